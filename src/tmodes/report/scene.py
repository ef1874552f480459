"""The robot over time, as a page shows it in space: ``Scene`` and ``LinePanel`` of ``web/src/contract.ts``."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.report.scene_chain import arm_line_panel, arm_scene
from tmodes.report.scene_paper import robot_line_panel, robot_scene
from tmodes.report.thin import scene_frames
from tmodes.result import Result
from tmodes.result.record import PaperResult

__all__ = ["line_of", "scene_of"]

Frames = NDArray[np.intp]


def scene_of(result: PaperResult | Result, frames: Frames | None = None) -> dict[str, Any]:
    """The robot at the samples ``frames``; None chooses them by :func:`tmodes.report.thin.scene_frames`.

    Lengths in m, times in s; arrays are NumPy's or those of :mod:`tmodes.report.pack`.
    """
    chosen = _frames(result) if frames is None else frames
    return arm_scene(result, chosen) if isinstance(result, Result) else robot_scene(result, chosen)


def line_of(result: PaperResult | Result, frames: Frames | None = None) -> dict[str, Any] | None:
    """Deflection, slope, moment and shear along each link that bends at ``frames``; None where none bends."""
    chosen = _frames(result) if frames is None else frames
    return arm_line_panel(result, chosen) if isinstance(result, Result) else robot_line_panel(result, chosen)


def _frames(result: PaperResult | Result) -> Frames:
    data = result.data
    return scene_frames(data["time"].values, int(np.prod(data["line"].shape[1:])) if "line" in data else 0)
