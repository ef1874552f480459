"""Frames as a person writes them: a position with angles or a quaternion, or a row of a Denavit-Hartenberg table."""

from __future__ import annotations

from collections.abc import Iterator
from enum import StrEnum
from typing import Annotated, Any

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from tmodes.kinds.noted.functions import hypot
from tmodes.kinds.schema.axes import quaternion_matrix, rotation_about, rpy_matrix
from tmodes.kinds.schema.quantity import LARGEST, DataSheet, Issue, any_sign

__all__ = ["TURN", "Convention", "DenavitHartenberg", "Origin", "Quaternion", "Vector", "list_of_numbers"]

Array = NDArray[np.float64]

Component = Annotated[float, Field(ge=-LARGEST, le=LARGEST)]
Vector = tuple[Component, Component, Component]
Quaternion = tuple[Component, Component, Component, Component]

NEAR = 1e-3
"""How far the length of a quaternion may be from 1 [-] to be taken for the rounding of its digits."""

PRINTED = 1e-6
"""How far the length of a quaternion is from 1 [-] when it is printed with the usual digits: not worth a word."""

TURN = 6.3
"""An angle [rad] beyond a whole turn: more is likely in degrees."""


def list_of_numbers(unit: str, symbol: str, meaning: str, *, default: Any = ..., **more: Any) -> Any:
    """A field that is a list of numbers of one unit (a vector, a table)."""
    extra = {"unit": unit, "symbol": symbol, "rigid_when_infinite": False, "plausible": None, "smallest": 0.0, **more}
    return Field(default, strict=False, description=f"{meaning} [{unit}]", json_schema_extra=extra)


class Origin(DataSheet):
    """Where a frame is in another, and which way it looks: angles or a quaternion, neither for the same axes."""

    position: Vector = list_of_numbers("m", "p", "position", default=(0.0, 0.0, 0.0))
    rpy: Vector | None = list_of_numbers(
        "rad", "rpy", "roll, pitch, yaw about axes that stay, as in URDF", default=None, plausible=[-TURN, TURN]
    )
    quaternion: Quaternion | None = list_of_numbers("-", "x y z w", "rotation as a unit quaternion", default=None)

    def _issues(self) -> Iterator[Issue]:
        if self.quaternion is None:
            return
        length = self._quaternion_length
        if self.rpy is not None:
            yield Issue("quaternion", "a quaternion next to `rpy`", "one of the two", "remove `quaternion` or `rpy`")
        if length == 0.0:
            hint = "write [0, 0, 0, 1] for no rotation"
            yield Issue("quaternion", "a quaternion of zeros, which is no rotation", "x, y, z, w of length 1", hint)
        elif abs(length - 1) > NEAR:
            hint = "divide its numbers by that length, and check that w stands last"
            yield Issue("quaternion", f"a quaternion of length {length:.6g}", f"length 1 within {NEAR:g}", hint)

    @property
    def _quaternion_length(self) -> float:
        return hypot(*self.quaternion) if self.quaternion else 1.0

    def rotation(self) -> Array:
        """Rotation matrix (3, 3), columns = the axes of this frame."""
        if self.quaternion is not None:
            return quaternion_matrix(self.quaternion)
        return rpy_matrix(*self.rpy) if self.rpy else np.eye(3)

    def notice(self) -> str:
        """What was put right in reading it; empty when nothing was."""
        length = self._quaternion_length
        return "" if abs(length - 1) <= PRINTED else f"quaternion of length {length:.9g} taken as one of length 1"


class Convention(StrEnum):
    """Which Denavit-Hartenberg table a row is of.

    ``standard``: T = Rz(theta) Tz(d) Tx(a) Rx(alpha) from joint to joint, the link's frame at its far end.
    ``modified`` (Craig): T = Rx(alpha) Tx(a) Rz(theta) Tz(d), the link's frame at its joint.
    ``paper``: a is the chord of the link's mode, alpha = d = 0; the link's frame is at its joint and its elastic angles
    are further turns, between this row and the next.
    """

    STANDARD = "standard"
    MODIFIED = "modified"
    PAPER = "paper"


class DenavitHartenberg(DataSheet):
    """One row of a Denavit-Hartenberg table, in place of a joint's origin and axis, which is its z axis."""

    convention: Convention = Field(strict=False, description="standard, modified (Craig), or paper")
    a: float = any_sign("m", "a", "distance of the joint axes along x", plausible=(-50.0, 50.0))
    alpha: float = any_sign("rad", "alpha", "angle of the joint axes about x", plausible=(-TURN, TURN))
    d: float = any_sign("m", "d", "distance along z", plausible=(-50.0, 50.0))
    theta: float = any_sign("rad", "theta", "angle about z, to which the joint's own is added", plausible=(-TURN, TURN))

    def _issues(self) -> Iterator[Issue]:
        for key in ("alpha", "d") if self.convention is Convention.PAPER else ():
            if value := getattr(self, key):
                hint = "write 0, or take the convention `standard` or `modified`"
                yield Issue(key, repr(value), "0 in the convention `paper`", hint)

    def before(self) -> tuple[Array, Array]:
        """Rotation (3, 3) and position (3,) [m] of the joint's frame in its parent's tip frame."""
        along, about = np.array([0.0, 0.0, self.d]), rotation_about((0, 0, 1), self.theta)
        if self.convention is not Convention.MODIFIED:
            return about, along
        tilted = rotation_about((1, 0, 0), self.alpha)
        return tilted @ about, np.array([self.a, 0.0, 0.0]) + tilted @ along

    def after(self) -> tuple[Array, Array]:
        """Rotation (3, 3) and position (3,) [m] of the link's frame in the frame that the joint has moved."""
        if self.convention is not Convention.STANDARD:
            return np.eye(3), np.zeros(3)
        return rotation_about((1, 0, 0), self.alpha), np.array([self.a, 0.0, 0.0])

    def chord(self) -> float:
        """Distance [m] along x from the link's frame to its tip: a, where the frame is at the joint (``paper``)."""
        return self.a if self.convention is Convention.PAPER else 0.0
