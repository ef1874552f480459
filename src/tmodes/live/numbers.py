"""All numbers that a run of a sheet is given, in one vector with named blocks: parameters, signals, start."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.arm import Arm
from tmodes.mechanism import Drive
from tmodes.motion.loop import LoopModel
from tmodes.motion.plan import Follow, planned
from tmodes.reference.signals import Quintic, Trapezoid
from tmodes.robot import Robot

__all__ = ["Blocks", "arm_numbers", "robot_numbers", "whole", "whole_moves"]

Array = NDArray[np.float64]

Blocks = dict[str, Array]


def robot_numbers(robot: Robot, drive: Drive) -> Blocks:
    """``parameters``; ``knots`` (k + 1,) and ``coefficients`` (k, degree + 1) of the wanted angle; ``start`` [rad]."""
    wanted = robot.wanted(drive)
    return {
        "parameters": np.array([value for _, value in robot.numbers()]),
        "knots": wanted.knots,
        "coefficients": wanted.coefficients,
        "start": np.array([robot.reference.start]),
        "end": np.array([robot.reference.duration]),
    }


def arm_numbers(arm: Arm, follow: Follow, until: float) -> Blocks:
    """``parameters``; ``knots.k`` and ``coefficients.k`` of each signal of the plan.

    ``until`` [s]: moves with a duration of their own are told so far, beyond the end of the run, to be whole.
    """
    plan = planned(arm, follow)
    found = {"parameters": LoopModel(plan.plan).numbers.vector}
    for k, signal in enumerate(plan.each):
        schedule = signal.schedule(until if isinstance(signal, (Quintic, Trapezoid)) else arm.integration.duration)
        found |= {f"knots.{k}": schedule.knots, f"coefficients.{k}": schedule.coefficients}
    return found


def whole_moves(arm: Arm, reach: float) -> float:
    """Time [s] at which every move is at its end, though its duration be ``reach`` times as long."""
    moves = [drive.signal for drive in arm.drives] + [load.signal for load in arm.loads if load.signal]
    ends = [move.delay + reach * move.duration for move in moves if isinstance(move, (Quintic, Trapezoid))]
    return 1.0 + max([arm.integration.duration, *ends])


def whole(blocks: Blocks) -> tuple[Array, dict[str, Any]]:
    """All blocks in one vector; and where each is: its start and shape."""
    places: dict[str, Any] = {}
    start = 0
    for name, values in blocks.items():
        places[name] = {"start": start, "shape": list(values.shape)}
        start += values.size
    return np.concatenate([values.ravel() for values in blocks.values()]), places
