"""How fast a rigid robot may go along its paths, as a timing says from what its joints can do."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.follow import Arm, Followed, Leg
from tmodes.kinds.signals.registry import Signal
from tmodes.kinds.timings.registry import JointCourse, Timing
from tmodes.sheet import Robot

__all__ = ["timed_ways"]

Array = NDArray[np.float64]

_PLACES = 101
"""Places along a path at which its timing is found."""


def timed_ways(robot: Robot, found: Followed, timing: Timing) -> list[dict[str, Any]]:
    """Plain data of the signals of the ways over time, by leg, of paths that were followed at some other speed.

    Raises :class:`tmodes.errors.InputError` where the timing finds none.
    """
    arm, bounds = Arm(robot), {joint.name: joint.limits for joint in robot.joints}
    limits = [bounds[joint] for joint in found.joints]
    speed, effort = (np.array([getattr(one, name, None) or np.inf for one in limits]) for name in ("speed", "effort"))
    signals = [Signal.of(one).schedule(float(found.times[-1])) for one in found.signals()]
    ways = []
    for leg in found.legs:
        places, times = _places(leg)
        joints = np.stack([one.at(leg.begin + times) for one in signals], axis=1)
        course = JointCourse(places, joints, speed, effort, arm.efforts)
        ways.append(_signal(places, timing.speeds(course)))
    return ways


def _places(leg: Leg) -> tuple[Array, Array]:
    """About even places along a leg from 0 to its length, and when it is there."""
    dense = np.linspace(0.0, leg.end, 40 * _PLACES)
    times = np.interp(np.linspace(0.0, leg.course.length, _PLACES), leg.pieces.at(dense), dense)
    places = leg.pieces.at(times)
    places[[0, -1]] = 0.0, leg.course.length
    kept = np.append(True, np.diff(places) > 0)
    return places[kept], times[kept]


def _signal(places: Array, speeds: Array) -> dict[str, Any]:
    """A way at a steady acceleration from place to place, whose square of the speed is linear over it."""
    rows, time = [], 0.0
    for (low, high), (before, after) in zip(pairwise(places.tolist()), pairwise(speeds.tolist()), strict=True):
        length, gain = 2 * (high - low) / (before + after), (after**2 - before**2) / (2 * (high - low))
        rows += [(time, low, before, gain), (time + length, high, after, gain)]
        time += length
    names = "times", "positions", "velocities", "accelerations"
    return {"type": "trajectory", **dict(zip(names, map(list, zip(*rows, strict=True)), strict=True))}
