"""What a timing is: from the joints along a path and their limits to the way along it over time.

A timing of a user's own is a class with the field ``type`` and one method, ``speeds``, or ``signal`` itself::

    @TIMINGS.register
    class Steady(Timing):
        type: Literal["steady"] = Field(description="kind of timing")

        def speeds(self, course: JointCourse) -> Array:
            return np.append(np.append(0.0, np.full(len(course.ways) - 2, 0.1)), 0.0)
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from tmodes.kinds.schema.kind import Kind

__all__ = ["TIMINGS", "JointCourse", "Timing", "tightest"]

Array = NDArray[np.float64]


class JointCourse(NamedTuple):
    """A path of the rigid robot: ``joints`` (n, k) [rad, m] at rising ``ways`` (n,) along it [m, rad], from 0 on.

    Limits of each joint (k,), infinite for none: ``speed`` [rad/s, m/s], ``acceleration``, ``jerk``, ``effort`` [N*m,
    N]. ``efforts``: those that joints, rates and accelerations (k,) need.
    """

    ways: Array
    joints: Array
    speed: Array
    acceleration: Array
    jerk: Array
    effort: Array
    efforts: Callable[[Array, Array, Array], Array]


def tightest(own: Array, limit: float | None) -> Array:
    """Limits of the joints (k,), and one of all that a timing may have."""
    return np.minimum(own, np.inf if limit is None else limit)


class Timing(Kind, family="timing", key="type"):
    """How fast to go where on a path."""

    type: Any = Field(description="kind of timing")

    def speeds(self, course: JointCourse) -> Array:
        """Speed (n,) [m/s, rad/s] at the ways, 0 at both ends; its square is linear in between.

        Raises :class:`tmodes.errors.InputError` where there is none.
        """
        raise NotImplementedError

    def signal(self, course: JointCourse) -> dict[str, Any]:
        """Plain data of the signal of the way over time: at a steady acceleration from place to place."""
        rows, time, places, speeds = [], 0.0, course.ways.tolist(), self.speeds(course).tolist()
        for (low, high), (before, after) in zip(pairwise(places), pairwise(speeds), strict=True):
            length, gain = 2 * (high - low) / (before + after), (after**2 - before**2) / (2 * (high - low))
            rows += [(time, low, before, gain), (time + length, high, after, gain)]
            time += length
        names = "times", "positions", "velocities", "accelerations"
        return {"type": "trajectory", **dict(zip(names, map(list, zip(*rows, strict=True)), strict=True))}


TIMINGS = Timing.registry
"""Those of tmodes, and what a user registers: ``@TIMINGS.register``."""
