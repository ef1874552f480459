"""A rigid body: what a link carries. Its inertia must be one that some distribution of mass can have."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray
from pydantic import Field, field_validator

from tmodes.kinds.noted.functions import positive_definite
from tmodes.kinds.noted.number import is_noted
from tmodes.kinds.schema.axes import rpy_matrix
from tmodes.kinds.schema.frames import TURN, Vector, list_of_numbers
from tmodes.kinds.schema.quantity import DataSheet, Issue, any_sign, not_negative, quantity

__all__ = ["BodySheet", "InertiaSheet", "entries", "principal_moments", "raised_inertia"]

ROUNDING = 1e-4
"""Share of the largest principal moment by which printed digits may violate the triangle inequality [-]."""


def _moment(symbol: str, axis: str) -> float:
    return not_negative("kg*m^2", symbol, f"moment of inertia about {axis}", plausible=(0.0, 1e4))


def _product(symbol: str) -> float:
    return any_sign("kg*m^2", symbol, f"product of inertia: the entry {symbol[1:]} of the matrix", default=0.0)


def principal_moments(matrix: ArrayLike) -> tuple[NDArray[np.float64], Literal["sign", "triangle", ""]]:
    """Principal moments (3,) of an inertia (3, 3), ascending, and the rule of a real body that they break, or ``""``.

    The rules: no moment is negative, and the largest is at most the sum of the others.
    """
    if is_noted(matrix):
        return _noted_moments(np.asarray(matrix))
    low, middle, high = moments = np.linalg.eigvalsh(np.asarray(matrix, dtype=float))
    if low < -ROUNDING * high:
        return moments, "sign"
    return moments, "triangle" if low + middle < (1 - ROUNDING) * high else ""


def _noted_moments(matrix: NDArray[Any]) -> tuple[NDArray[Any], Literal["sign", ""]]:
    """Sufficient for both rules, noted: that J + small 1 and tr(J)/(2 - small) 1 - J are positive definite."""
    trace, one = np.trace(matrix), np.eye(3)
    fits = positive_definite(matrix + ROUNDING / 3 * trace * one)
    fits = fits and positive_definite(trace / (2 - ROUNDING) * one - matrix)
    return np.diag(matrix), "" if fits else "sign"


def raised_inertia(matrix: ArrayLike, uses: ArrayLike = ()) -> NDArray[np.float64]:
    """An inertia (3, 3) of a real body that is a given one with as little added as it takes.

    Negative moments become zero; what the largest is above the sum of the others is added about an axis square to its
    own, and as far as that goes square to the ``uses`` (k, 3), the longer the more, whose moments then stay.
    """
    moments, axes = np.linalg.eigh(np.asarray(matrix, dtype=float))
    low, middle, high = moments = np.maximum(moments, 0.0)
    raised, plane = axes @ np.diag(moments) @ axes.T, axes[:, :2]
    inside = np.reshape(np.asarray(uses, dtype=float), (-1, 3)) @ plane
    sizes, directions = np.linalg.eigh(inside.T @ inside)
    one_is_used = sizes[1] - sizes[0] > 1e-12 * np.sum(np.square(uses))
    share = np.outer(directions[:, 0], directions[:, 0]) if one_is_used else np.eye(2) / 2
    return raised + max(0.0, high - low - middle) * plane @ share @ plane.T


def entries(matrix: NDArray[np.float64]) -> dict[str, float]:
    """The six entries by which a sheet gives a symmetric matrix (3, 3): what :meth:`Inertia.matrix` turns back."""
    return {a + b: float(matrix["xyz".index(a), "xyz".index(b)]) for a, b in ("xx", "yy", "zz", "xy", "xz", "yz")}


class InertiaSheet(DataSheet):
    """Inertia about the center of mass: the six entries of a symmetric matrix (products with the matrix's sign)."""

    xx: float = _moment("Jxx", "x")
    yy: float = _moment("Jyy", "y")
    zz: float = _moment("Jzz", "z")
    xy: float = _product("Jxy")
    xz: float = _product("Jxz")
    yz: float = _product("Jyz")

    def _issues(self) -> Iterator[Issue]:
        moments, broken = principal_moments(self.matrix())
        if not broken:
            return
        info = "an inertia with the principal moments " + ", ".join(f"{moment:.6g}" for moment in moments)
        hint = "check signs, units, and that it is about the center of mass"
        if broken == "sign":
            yield Issue("", info, "one whose principal moments are not negative", hint)
        elif broken == "triangle":
            others = moments[0] + moments[1]
            rule = f"one whose largest moment is at most the sum of the others, {others:.6g} (triangle inequality)"
            yield Issue("", info, rule, hint)

    def matrix(self) -> NDArray[np.float64]:
        """The inertia as a matrix (3, 3) [kg*m^2]."""
        rows = [[self.xx, self.xy, self.xz], [self.xy, self.yy, self.yz], [self.xz, self.yz, self.zz]]
        return np.array(rows)


class BodySheet(DataSheet):
    """A rigid body of a link, in the link's frame; on a beam in the axes of the section at the station ``at``."""

    name: str = Field(default="", max_length=100, description="name of the body")
    mass: float = not_negative("kg", "m", "mass", plausible=(1e-6, 1e4))
    center: Vector = list_of_numbers("m", "c", "center of mass", default=(0.0, 0.0, 0.0))
    inertia: InertiaSheet | None = Field(
        default=None, description="inertia about the center of mass; one number: about every axis; none: a point mass"
    )
    rpy: Vector | None = list_of_numbers(
        "rad", "rpy", "axes of the inertia; none: those of the frame", default=None, plausible=[-TURN, TURN]
    )
    at: float | None = quantity(
        "-",
        "s",
        "station on a beam, from 0, its root, to 1, its tip (the default)",
        default=None,
        at_least=0,
        at_most=1,
    )

    @field_validator("inertia", mode="before")
    @classmethod
    def _one_number_is_about_every_axis(cls, value: Any) -> Any:
        alike = isinstance(value, (int, float)) and not isinstance(value, bool)
        return {"xx": value, "yy": value, "zz": value} if alike else value

    @property
    def station(self) -> float:
        """Where on a beam it is: 0 the root, 1 the tip."""
        return 1.0 if self.at is None else self.at

    def inertia_matrix(self) -> NDArray[np.float64]:
        """Inertia (3, 3) [kg*m^2] about the center of mass, in the axes of the frame that carries the body."""
        if self.inertia is None:
            return np.zeros((3, 3))
        axes = rpy_matrix(*self.rpy) if self.rpy else np.eye(3)
        return axes @ self.inertia.matrix() @ axes.T
