"""The robot over time, as a page shows it in space: ``Scene`` and ``LinePanel`` of ``web/src/contract.ts``."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.arm_result import ArmResult
from tmodes.report.scene_arm import arm_line_panel, arm_scene
from tmodes.report.scene_robot import robot_line_panel, robot_scene
from tmodes.result import Result

__all__ = ["line_of", "scene_frames", "scene_of"]

Frames = NDArray[np.intp]

_A_SECOND = 50
"""Display frames of a second of a long run: between them the page draws straight lines."""

_FEW, _MANY = 400, 3000
"""Frames that a short run has so that it can be slowed down, and that a long run has at most."""


def scene_frames(result: Result | ArmResult) -> Frames:
    """Indices of the samples that are shown, evenly spread, the first and the last among them."""
    times = result.data["time"].values
    wanted = max(_FEW, min(_MANY, int(_A_SECOND * (times[-1] - times[0])) + 1))
    return np.unique(np.linspace(0, len(times) - 1, min(wanted, len(times))).round().astype(np.intp))


def scene_of(result: Result | ArmResult, frames: Frames | None = None) -> dict[str, Any]:
    """The robot at the samples ``frames``; None chooses them by :func:`scene_frames`.

    Lengths in m, times in s; arrays are NumPy's or those of :mod:`tmodes.report.pack`.
    """
    chosen = scene_frames(result) if frames is None else frames
    return arm_scene(result, chosen) if isinstance(result, ArmResult) else robot_scene(result, chosen)


def line_of(result: Result | ArmResult, frames: Frames | None = None) -> dict[str, Any] | None:
    """Deflection, slope, moment and shear along each link that bends at ``frames``; None where none bends."""
    chosen = scene_frames(result) if frames is None else frames
    return arm_line_panel(result, chosen) if isinstance(result, ArmResult) else robot_line_panel(result, chosen)
