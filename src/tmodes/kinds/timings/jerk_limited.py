"""From rest to rest along a path with bounded jerk, as fast as the limits of all joints allow.

On a line of the joints without limits of effort it is the least time in which all of them keep to their limits of
speed, acceleration and jerk and stay on the line (phase synchronization). Source: L. Berscheid, T. Kroeger,
Jerk-limited real-time trajectory generation with arbitrary target states, Robotics: Science and Systems (2021).
"""

from __future__ import annotations

from typing import Any, Literal

import numpy as np
from pydantic import Field

from tmodes.errors import InputError
from tmodes.kinds.schema.quantity import LARGEST, positive
from tmodes.kinds.signals.s_curve import SCurve
from tmodes.kinds.timings.contract import TIMINGS, Array, JointCourse, Timing, tightest
from tmodes.kinds.timings.jerk_steps import Shares, Steps, quicker

__all__ = ["JerkLimited"]

_PARTS, _INSTANTS, _SLOWEST = 6, 8, 1e3
"""Of each phase of an S-curve; instants of each part at which limits are checked; largest factor on the time."""


@TIMINGS.register
class JerkLimited(Timing):
    """From rest to rest within the joints' limits of speed, acceleration, jerk and effort.

    Where no limit depends on the place it is the S-curve of the least time. Elsewhere (efforts, a path that is no line
    of the joints) it is a motion of up to 42 pieces of steady jerk: a local optimum, never longer than that S-curve
    slowed as a whole, and with no limit passed at 336 instants, those of all ends of pieces among them.
    """

    type: Literal["jerk_limited"] = Field(description="kind of timing")
    share: float = Field(default=1.0, gt=0.0, le=1.0, description="of all limits that is used")
    acceleration: float | None = positive("rad/s^2|m/s^2", "a", "of each joint; none: as `limits` say", default=None)
    jerk: float | None = positive("rad/s^3|m/s^3", "j", "of each joint; none: as `limits` say", default=None)

    def signal(self, course: JointCourse) -> dict[str, Any]:
        """Plain data of the S-curve; raises :class:`tmodes.errors.InputError` without a limit of jerk, or too weak."""
        from scipy.interpolate import CubicSpline

        path, length = CubicSpline(course.ways, course.joints), float(course.ways[-1])
        gain, jerk = tightest(course.acceleration, self.acceleration), tightest(course.jerk, self.jerk)
        limits = [self.share * one for one in (course.speed, gain, jerk, course.effort)]
        slope = np.abs(path(course.ways, 1)).max(axis=0)
        if not np.isfinite(jerk[slope > 0]).any():
            hint = "add `jerk: 100.0` to the timing, or to the `limits` of its joints"
            raise InputError("task.profile", "no limit of jerk", "one of a joint that moves", hint)
        free = [float(np.min(one / np.maximum(slope, 1 / LARGEST), initial=LARGEST)) for one in limits[:3]]

        bounds = dict(zip(("speed", "acceleration", "jerk"), free, strict=True))
        curve = SCurve(type="s_curve", start=0.0, end=length, **bounds)

        def shares(way: Array, speed: Array, gain: Array, jerk: Array) -> Array:
            return _shares(course, path, (way, speed, gain, jerk), limits)

        first = _steps(curve)
        if _beyond(first, shares) <= 0:
            return curve.model_dump(mode="json")
        slowed = _slowed(first, shares)
        return _rows(min(slowed, _slowed(quicker(slowed, shares), shares), key=lambda one: one.duration))


def _steps(curve: SCurve) -> Steps:
    """The pieces of an S-curve, each in parts."""
    pieces = curve.schedule(curve.length())
    whole, middles = float(pieces.knots[-1]), (pieces.knots[1:] + pieces.knots[:-1]) / 2
    shares = np.repeat(np.diff(pieces.knots) / whole / _PARTS, _PARTS)
    return Steps(whole, shares, np.repeat(pieces.at(middles, 3), _PARTS))


def _beyond(steps: Steps, shares: Shares) -> float:
    """By how much of a limit the worst is passed."""
    return float(np.abs(shares(*steps.motion(_INSTANTS))).max()) - 1.0 - 1e-9


def _slowed(steps: Steps, shares: Shares) -> Steps:
    """As a whole, to where no limit is passed; raises :class:`tmodes.errors.InputError` where that is nowhere."""
    from scipy.optimize import brentq

    if _beyond(steps, shares) <= 0:
        return steps
    if _beyond(steps.slower(_SLOWEST), shares) > 0:
        hint = "raise the limits, or keep away from poses in which a joint carries more than it can"
        raise InputError("task.profile", "no timing within the limits", "limits that let the robot stand", hint)
    found: Any = brentq(lambda factor: _beyond(steps.slower(factor), shares), 1.0, _SLOWEST, xtol=1e-9)
    return steps.slower(float(found) * (1 + 1e-8))


def _rows(steps: Steps) -> dict[str, Any]:
    """Plain data of a signal."""
    way, speed, gain, _ = steps.motion(2)  # at both ends of each piece
    times = steps.duration * np.append(0.0, np.cumsum(steps.shares))
    columns = {"positions": (way, way[-1]), "velocities": (speed, 0.0), "accelerations": (gain, 0.0)}
    return {"type": "trajectory", "times": times.tolist()} | {
        name: [*one[::2].tolist(), float(end)] for name, (one, end) in columns.items()
    }


def _shares(course: JointCourse, path: Any, motion: tuple[Array, ...], limits: list[Array]) -> Array:
    """Of the limits that there are, (m, limits), with signs, in a ``motion``: way and three derivatives (m,)."""
    s, (v, a, j) = motion[0], (one[:, None] for one in motion[1:])
    q, d, dd, ddd = (path(np.clip(s, 0.0, course.ways[-1]), order) for order in range(4))
    rates, gains = d * v, d * a + dd * v**2
    limited = np.isfinite(limits[3]).any()
    efforts = np.array([course.efforts(*row) for row in zip(q, rates, gains, strict=True)]) if limited else 0 * q
    moved = rates, gains, d * j + 3 * dd * v * a + ddd * v**3, efforts
    return np.hstack([(one / most)[:, np.isfinite(most)] for one, most in zip(moved, limits, strict=True)])
