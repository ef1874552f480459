"""The least time on a path within the limits of all joints (package toppra).

H. Pham, Q.-C. Pham, A new approach to time-optimal path parameterization based on reachability analysis, IEEE
Transactions on Robotics 34 (2018) 645-659.
"""

from __future__ import annotations

import logging
from typing import Any, Literal

import numpy as np
from pydantic import Field

from tmodes.errors import InputError
from tmodes.kinds.schema.quantity import positive
from tmodes.kinds.timings.contract import TIMINGS, Array, JointCourse, Timing, tightest

__all__ = ["Toppra"]

_ROUNDS, _CLOSE = 10, 1e-4
"""Of finding the speeds with the friction of those before, at most; share of a change that ends it."""


@TIMINGS.register
class Toppra(Timing):
    """As fast as speed, effort and ``acceleration`` of the joints allow, each up to a ``share`` of its limit."""

    type: Literal["toppra"] = Field(description="kind of timing")
    share: float = Field(default=1.0, gt=0.0, le=1.0, description="of the limits of speed and effort that is used")
    acceleration: float | None = positive(
        "rad/s^2|m/s^2", "a", "largest of each joint; none: as `limits` say", default=None
    )

    def speeds(self, course: JointCourse) -> Array:
        """By reachability analysis; raises :class:`tmodes.errors.InputError` where a joint cannot even stand."""
        constraint, algorithm, toppra = _package()
        count, still = course.joints.shape[1], np.zeros(len(course.ways))
        path, limits, effort = toppra.SplineInterpolator(course.ways, course.joints), list[Any](), list[Any]()
        if np.isfinite(course.speed).any():
            limits.append(constraint.JointVelocityConstraint(_both(self.share * course.speed)))
        gain = tightest(course.acceleration, self.acceleration)
        if np.isfinite(gain).any():
            limits.append(constraint.JointAccelerationConstraint(_both(gain)))
        if np.isfinite(course.effort).any():
            bounds, rows = _both(self.share * course.effort), np.vstack([np.eye(count), -np.eye(count)])
            sides = np.append(bounds[:, 1], -bounds[:, 0])
            effort = [_even(course), lambda q: rows, lambda q: sides, count]
        if not limits and not effort:
            hint = "add `limits: {speed: 3.0, effort: 100.0}` to its joints, or `acceleration` to the timing"
            raise InputError("task.profile", "no limit of a joint", "a limit of speed, effort or acceleration", hint)
        speeds = still
        for _ in range(_ROUNDS if effort else 1):

            def drag(path: Any, way: float, before: Array = speeds) -> Array:
                return _odd(course, path(way), path(way, 1)) * np.interp(way, course.ways, before)

            own = [constraint.SecondOrderConstraint(*effort, custom_term=drag)] if effort else []
            for one in (*limits, *own):
                one.set_discretization_type(1)  # limits hold up to the next place
            found = algorithm.TOPPRA([*limits, *own], path, gridpoints=course.ways).compute_parameterization(0.0, 0.0)[
                1
            ]
            if found is None or not np.isfinite(found).all():
                hint = "raise the limits, or keep away from poses in which a joint carries more than it can"
                raise InputError("task.profile", "no timing within the limits", "limits that let the robot stand", hint)
            speeds, before = np.asarray(found, dtype=np.float64), speeds
            if np.abs(speeds - before).max() < _CLOSE * speeds.max():
                break
        return speeds


def _even(course: JointCourse) -> Any:
    """Efforts without those of friction, which changes its sign with the rates: TOPP-RA takes squares of them."""
    return lambda q, v, a: (course.efforts(q, v, a) + course.efforts(q, -v, a)) / 2


def _odd(course: JointCourse, q: Array, v: Array) -> Array:
    return (course.efforts(q, v, 0 * v) - course.efforts(q, -v, 0 * v)) / 2


def _both(limit: Array) -> Array:
    """Bounds below and above (k, 2); of what has none far more than any robot does."""
    most = np.where(np.isfinite(limit), limit, 1e6)
    return np.stack([-most, most], axis=1)


def _package() -> tuple[Any, Any, Any]:
    try:
        import toppra  # pyright: ignore[reportMissingImports]
        from toppra import algorithm, constraint  # pyright: ignore[reportMissingImports]
    except ImportError as error:
        raise InputError("task.profile", "toppra, which is not installed", "the package toppra",
                         'pip install "tmodes[planning]"') from error  # fmt: skip
    logging.getLogger("toppra").setLevel(logging.ERROR)
    return constraint, algorithm, toppra
