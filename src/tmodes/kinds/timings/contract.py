"""What a timing is: from the joints along a path and their limits to the speed on each part of it.

A timing of a user's own is a class with the field ``type`` and one method::

    @TIMINGS.register
    class Steady(Timing):
        type: Literal["steady"] = Field(description="kind of timing")

        def speeds(self, course: JointCourse) -> Array:
            return np.append(np.append(0.0, np.full(len(course.ways) - 2, 0.1)), 0.0)
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from tmodes.kinds.schema.kind import Kind

__all__ = ["TIMINGS", "JointCourse", "Timing"]

Array = NDArray[np.float64]


class JointCourse(NamedTuple):
    """A path of the rigid robot: ``joints`` (n, k) [rad, m] at rising ``ways`` (n,) along it [m, rad], from 0 on.

    Limits of each joint (k,), infinite for none: ``speed`` [rad/s, m/s], ``effort`` [N*m, N]. ``efforts``: those that
    joints, rates and accelerations (k,) need.
    """

    ways: Array
    joints: Array
    speed: Array
    effort: Array
    efforts: Callable[[Array, Array, Array], Array]


class Timing(Kind, family="timing", key="type"):
    """How fast to go where on a path."""

    type: Any = Field(description="kind of timing")

    def speeds(self, course: JointCourse) -> Array:
        """Speed (n,) [m/s, rad/s] at the ways, 0 at both ends; its square is linear in between.

        Raises :class:`tmodes.errors.InputError` where there is none.
        """
        raise NotImplementedError


TIMINGS = Timing.registry
"""Those of tmodes, and what a user registers: ``@TIMINGS.register``."""
