"""What a path is: places over the way along them, of the tip in the world, or of the joints.

A path of a user's own is a class with the field ``type`` and one method::

    @PATHS.register
    class Up(Path):
        type: Literal["up"] = Field(description="kind of path")
        height: float = positive("m", "h", "how far up")

        def course(self, start: Place) -> Course:
            return lines([start.point, start.point + [0.0, 0.0, self.height]], 0.0)
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Annotated, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from tmodes.kinds.schema.kind import Kind
from tmodes.kinds.schema.quantity import LARGEST

__all__ = ["PATHS", "Course", "Number", "Path", "Place", "Way", "numbers", "points"]

Array = NDArray[np.float64]

MOST_POINTS = 1000
Number = Annotated[float, Field(ge=-LARGEST, le=LARGEST)]
Point = Annotated[tuple[Number, Number, Number], Field(strict=False)]
Values = Annotated[tuple[Number, ...], Field(strict=False)]


class Place(NamedTuple):
    """Where a path starts: ``point`` (3,) [m] and ``rotation`` (3, 3) of the tip, ``joints`` (n,) [rad, m]."""

    point: Array
    rotation: Array
    joints: Array


class Way(NamedTuple):
    """A place on a way and how it goes on: ``value`` (d,), its first and second derivative by the way."""

    value: Array
    slope: Array
    bend: Array


@dataclass(frozen=True, eq=False)
class Course:
    """A path from its start: how long it is [m; rad where it only turns, or is of joints], and its places.

    ``at`` gives for a way from 0 to ``length`` the place of the tip (3,) [m], or with ``of_joints`` of the joints (n,).
    ``turn``: rotation vector (3,) [rad] by which the tip turns at a steady rate up to the end, in world axes; None: it
    may turn as it likes. ``knots``: ways at which a derivative jumps.
    """

    length: float
    at: Callable[[float], Way]
    turn: Array | None = None
    knots: tuple[float, ...] = ()
    of_joints: bool = field(default=False)


class Path(Kind, family="path", key="type"):
    """A way of the tip, or of the joints, from where they are."""

    type: Any = Field(description="kind of path")

    def course(self, start: Place) -> Course:
        """The path that begins at a place; raises :class:`tmodes.errors.InputError` where there is none from there."""
        raise NotImplementedError


def numbers(unit: str, symbol: str, meaning: str, count: int = 0, **more: Any) -> Any:
    """A field with ``count`` numbers, of 0 with any number of them."""
    extra: Any = {"unit": unit, "symbol": symbol, "smallest": 0.0, "plausible": None}
    least, most = (count, count) if count else (1, MOST_POINTS)
    return Field(strict=False, min_length=least, max_length=most, description=f"{meaning} [{unit}]",
                 json_schema_extra=extra, **more)  # fmt: skip


def points(unit: str, symbol: str, meaning: str) -> Any:
    """A field with a list of points."""
    extra: Any = {"unit": unit, "symbol": symbol, "smallest": 0.0, "plausible": None}
    return Field(strict=False, min_length=1, max_length=MOST_POINTS, description=f"{meaning} [{unit}]",
                 json_schema_extra=extra)  # fmt: skip


PATHS = Path.registry
"""Those of tmodes, and what a user registers: ``@PATHS.register``."""
