"""How fast a rigid robot may go along its paths, as a timing says from what its joints can do."""

from __future__ import annotations

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
    arm, own = Arm(robot), {joint.name: joint.limits for joint in robot.joints}
    names = "speed", "acceleration", "jerk", "effort"
    speed, gain, jerk, effort = (
        np.array([getattr(own[joint], name, None) or np.inf for joint in found.joints]) for name in names
    )
    signals = [Signal.of(one).schedule(float(found.times[-1])) for one in found.signals()]
    ways = []
    for leg in found.legs:
        places, times = _places(leg)
        joints = np.stack([one.at(leg.begin + times) for one in signals], axis=1)
        ways.append(timing.signal(JointCourse(places, joints, speed, gain, jerk, effort, arm.efforts)))
    return ways


def _places(leg: Leg) -> tuple[Array, Array]:
    """About even places along a leg from 0 to its length, and when it is there."""
    dense = np.linspace(0.0, leg.end, 40 * _PLACES)
    times = np.interp(np.linspace(0.0, leg.course.length, _PLACES), leg.pieces.at(dense), dense)
    places = leg.pieces.at(times)
    places[[0, -1]] = 0.0, leg.course.length
    kept = np.append(True, np.diff(places) > 0)
    return places[kept], times[kept]
