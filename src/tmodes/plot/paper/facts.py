"""What figures need to know of the robot, from the data sheet that every result carries."""

from __future__ import annotations

import json
from typing import Any

__all__ = ["mode_lengths", "move_duration", "steady_part"]


def mode_lengths(data: Any) -> list[float]:
    """Length of each mode [m], root to tip."""
    return [float(mode["length"]) for mode in json.loads(data.attrs["robot"])["link"]["modes"]]


def move_duration(data: Any) -> float:
    """How long the wanted motion takes [s]; the run may be shorter or longer."""
    return float(json.loads(data.attrs["robot"])["reference"]["duration"])


def steady_part(data: Any) -> tuple[float, float]:
    """Where the wanted motion keeps its speed, as shares of the move; all of it where the ramps (nearly) meet."""
    ramp = float(json.loads(data.attrs["robot"])["reference"]["ramp_fraction"])
    return (ramp, 1 - ramp) if ramp < 0.45 else (0.0, 1.0)
