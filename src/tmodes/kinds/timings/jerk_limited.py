"""From rest to rest along a path with bounded jerk, as fast as the limits of all joints allow.

On a line of the joints it is the least time in which all of them keep to their limits of speed, acceleration and jerk
and stay on the line (phase synchronization). Source: L. Berscheid, T. Kroeger, Jerk-limited real-time trajectory
generation with arbitrary target states, Robotics: Science and Systems (2021).
"""

from __future__ import annotations

from itertools import pairwise
from typing import Any, Literal

import numpy as np
from pydantic import Field

from tmodes.errors import InputError
from tmodes.kinds.schema.quantity import LARGEST, positive
from tmodes.kinds.signals.s_curve import SCurve
from tmodes.kinds.timings.contract import TIMINGS, Array, JointCourse, Timing, tightest

__all__ = ["JerkLimited"]

_INSTANTS, _SLOWEST = 400, 1e3
"""At which limits are looked at; the largest factor on the time that is tried."""


@TIMINGS.register
class JerkLimited(Timing):
    """An S-curve of the way, whose speed, acceleration and jerk are the largest that no joint's limit is passed by."""

    type: Literal["jerk_limited"] = Field(description="kind of timing")
    share: float = Field(default=1.0, gt=0.0, le=1.0, description="of all limits that is used")
    acceleration: float | None = positive("rad/s^2|m/s^2", "a", "of each joint; none: as `limits` say", default=None)
    jerk: float | None = positive("rad/s^3|m/s^3", "j", "of each joint; none: as `limits` say", default=None)

    def signal(self, course: JointCourse) -> dict[str, Any]:
        """Plain data of the S-curve; raises :class:`tmodes.errors.InputError` without a limit of jerk, or too weak."""
        from scipy.interpolate import CubicSpline
        from scipy.optimize import brentq

        path, length = CubicSpline(course.ways, course.joints), float(course.ways[-1])
        gain, jerk = tightest(course.acceleration, self.acceleration), tightest(course.jerk, self.jerk)
        limits = [self.share * one for one in (course.speed, gain, jerk, course.effort)]
        slope = np.abs(path(course.ways, 1)).max(axis=0)
        if not np.isfinite(jerk[slope > 0]).any():
            hint = "add `jerk: 100.0` to the timing, or to the `limits` of its joints"
            raise InputError("task.profile", "no limit of jerk", "one of a joint that moves", hint)
        free = [float(np.min(one / np.maximum(slope, 1 / LARGEST), initial=LARGEST)) for one in limits[:3]]

        def slower(factor: float) -> SCurve:
            bounds = {name: most / factor**k for k, (name, most) in enumerate(zip(_NAMES, free, strict=True), 1)}
            return SCurve(type="s_curve", start=0.0, end=length, **bounds)

        def beyond(factor: float) -> float:
            return _share(course, path, slower(factor), limits) - 1.0 - 1e-9

        factor = 1.0
        if beyond(1.0) > 0:
            if beyond(_SLOWEST) > 0:
                hint = "raise the limits, or keep away from poses in which a joint carries more than it can"
                raise InputError("task.profile", "no timing within the limits", "limits that let the robot stand", hint)
            found: Any = brentq(beyond, 1.0, _SLOWEST, xtol=1e-9)
            factor = float(found)
        return slower(factor * (1 + 1e-8 * (factor > 1.0))).model_dump(mode="json")


_NAMES = "speed", "acceleration", "jerk"


def _share(course: JointCourse, path: Any, way: SCurve, limits: list[Array]) -> float:
    """Largest share of a limit along the whole motion."""
    pieces = way.schedule(way.length())
    inner = [np.linspace(*ends, _INSTANTS // 7 + 2)[1:-1] for ends in pairwise(pieces.knots)]
    s, v, a, j = (pieces.at(np.concatenate(inner), order)[:, None] for order in range(4))
    q, d, dd, ddd = (path(np.clip(s[:, 0], 0.0, course.ways[-1]), order) for order in range(4))
    rates, gains = d * v, d * a + dd * v**2
    limited = np.isfinite(limits[3]).any()
    efforts = np.array([course.efforts(*row) for row in zip(q, rates, gains, strict=True)]) if limited else 0 * q
    moved = rates, gains, d * j + 3 * dd * v * a + ddd * v**3, efforts
    return max(float(np.abs(one / most).max()) for one, most in zip(moved, limits, strict=True))
