"""Draws the picture of docs/uncertain-axis.md: ``python tools/axis_picture.py``."""

from __future__ import annotations

from pathlib import Path

import numpy as np

import tmodes
from tmodes import plot
from tmodes.plot.style import new_figure

__all__ = ["draw"]

ROOT = Path(__file__).resolve().parents[1]
TARGET = ROOT / "docs/images/uncertain-axis.png"
PLANTS = 500


def draw(target: Path = TARGET) -> None:
    """The tool of the first plants of the study under the gains of the sheet and under those that were found."""
    study = tmodes.read_study(ROOT / "examples/studies/axis_plants.yaml")
    assert study.robot is not None  # noqa: S101
    found, sheet = study.robot, tmodes.load("moberg2009").with_({"integration.method": "rk4", "integration.step": 5e-4})
    factors = np.vstack([study.space.nominal, study.design().values[:PLANTS]]).T
    paths = [study.sheet.parameters[name].path or name for name in study.names]
    plants = {path: factor * sheet.parameters[path.split(".")[1]] for path, factor in zip(paths, factors, strict=True)}
    with plot.house_style():
        figure = new_figure(3.2)
        axes = figure.subplots()
        for robot, name, color in ((sheet, "by hand", "#d55e00"), (found, "by gradients", "#0072b2")):
            batch = tmodes.simulate_batch(robot, plants, tips=True)
            assert batch.tips is not None  # noqa: S101
            height = 1e3 * batch.tips[:, :, 2]
            axes.fill_between(batch.times, height.min(axis=0), height.max(axis=0), color=color, alpha=0.35, linewidth=0)
            axes.plot(batch.times, height[0], color=color, label=f"gains {name}")
        axes.set_ylabel("tool off its place [mm]")
        axes.set_xlabel("time [s]")
        axes.legend(loc="upper right")
        figure.savefig(target, dpi=170, metadata={"Software": None})


if __name__ == "__main__":
    draw()
