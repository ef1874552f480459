"""What a picture of the scene shows: where it differs from its background, which has one colour in each row."""

from __future__ import annotations

import io
from typing import Any

import matplotlib.image
import numpy as np

from patience import steady

__all__ = ["drawn_under", "notes_of", "robot_pixels"]

NOTES = ".scene-legend, .scene-scale, .scene-grid, .scene-flat, .scene-factor, .scene-axes"
HIDDEN = ("floor", "surface", "traces")


def notes_of(frame: Any) -> dict[str, tuple[float, float, float, float]]:
    """The boxes of the notes that are shown, in pixels of the view: left, top, right, bottom."""
    view = frame.locator(".scene-view").evaluate("one => one.getBoundingClientRect().toJSON()")
    boxes = frame.evaluate(
        f"""[...document.querySelectorAll('{NOTES}')].map((one) => [one.className,
        one.getBoundingClientRect().toJSON()])"""
    )
    return {
        name.split()[-1]: (
            box["left"] - view["left"], box["top"] - view["top"],
            box["right"] - view["left"], box["bottom"] - view["top"],
        )
        for name, box in boxes if box["height"]
    }  # fmt: skip


KEEP = """document.querySelectorAll('.scene-note').forEach((one) => {
  const { width, height } = one.getBoundingClientRect();
  if (height) one.style.cssText = `width: ${width}px; height: ${height}px; display: block !important` })"""
"""Notes take the room that they take with all things shown, from which the camera stands where it stands."""


def robot_pixels(frame: Any) -> np.ndarray:
    """The view [h, w, 3] in parts of one, with the robot in it: without notes, floor and paths."""
    frame.evaluate(KEEP)
    frame.evaluate(
        f"""for (const name of {list(HIDDEN)}) {{ const box = document.querySelector(`[data-scene=${{name}}]`);
        if (box && box.checked) box.click() }}
        for (const one of document.querySelectorAll('.scene-note, .scene-overlay')) one.style.visibility = 'hidden';"""
    )
    picture = matplotlib.image.imread(io.BytesIO(steady(frame.locator(".scene-view").screenshot)))
    return np.asarray(picture)[..., :3]


def drawn_under(picture: np.ndarray, box: tuple[float, float, float, float]) -> int:
    """How many pixels of a box [left, top, right, bottom] differ from the background of their row."""
    away = np.abs(picture - np.median(picture, axis=1, keepdims=True)).max(axis=2) > 0.12
    left, top, right, bottom = (round(max(side, 0.0)) for side in box)
    edge = 4  # of the view, whose corners are round
    return int(away[max(top, edge) : min(bottom, len(away) - edge), max(left, edge) : right].sum())
