"""Central differences of what a data sheet says, and the numbers of a sheet by which one can differentiate."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from pydantic import BaseModel

from tmodes.errors import InputError

__all__ = ["Change", "far_difference", "near_difference", "number_at", "replaced"]

Array = NDArray[np.float64]

_NEAR, _FAR = 3e-5, 1e-3
"""Relative steps of the differences: of smooth arithmetic, whose error is of second order in the step and below 1e-8;
and of equilibria, found to a tolerance, by differences of fourth order."""


class Change(NamedTuple):
    """Derivatives by one quantity: of the parameters, of the state at the start, and of the rows of the signals."""

    parameters: Array
    start: Array
    rows: Array


def near_difference(value_at: Callable[[float], Array], value: float) -> Array:
    """Derivative of smooth arithmetic at a value, from changes of it; at 0 the change counts in its own unit."""
    step = _NEAR * (abs(value) or 1.0)
    return (value_at(step) - value_at(-step)) / (2 * step)


def far_difference(value_at: Callable[[float], Array], value: float) -> Array:
    """The same of an equilibrium."""
    step = _FAR * (abs(value) or 1.0)
    near = np.stack([value_at(k * step) for k in (-2, -1, 1, 2)])
    return np.array([1.0, -8.0, 8.0, -1.0]) @ near / (12 * step)


def number_at(path: str, known: Any, *, zero: bool = False) -> float:
    """The number at a path; a list of equal numbers and an inertia that is alike about every axis count as one.

    Raises :class:`tmodes.errors.InputError` for anything else, and for a zero where none may be.
    """
    several = _moments(known) if isinstance(known, dict) else known
    same = isinstance(several, list) and len(set(map(str, several))) == 1
    value: Any = several[0] if same and several else known
    wrong = isinstance(value, bool) or not isinstance(value, (int, float)) or not np.isfinite(value)
    if wrong or (value == 0 and not zero):
        expected = "the path of a finite number other than 0: its change is given relative to it"
        raise InputError(path, repr(known), expected, "name another quantity, or give this one a value")
    return float(value)


def _moments(known: dict[str, Any]) -> list[Any] | None:
    """The moments of an inertia without products."""
    products = [known.get(name, 0.0) for name in ("xy", "xz", "yz")]
    return [known[name] for name in ("xx", "yy", "zz")] if "xx" in known and not any(products) else None


def replaced(sheet: Any, steps: Sequence[str | int], value: float) -> Any:
    """A sheet with another number where one stands, made again without checks; None where none stands by itself.

    A check of the whole takes longer than what differences need otherwise.
    """
    if not steps:
        alone = isinstance(sheet, tuple) and len(sheet) == 1 and isinstance(sheet[0], float)
        return (value,) if alone else value if isinstance(sheet, float) else None
    step, *rest = steps
    if isinstance(sheet, BaseModel):
        fields = {name: getattr(sheet, name) for name in type(sheet).model_fields}
        inner = replaced(fields.get(str(step)), rest, value)
        made = type(sheet).model_construct(sheet.model_fields_set, **(fields | {str(step): inner}))
        return None if inner is None else made
    if isinstance(sheet, tuple) and isinstance(step, int):
        inner = replaced(sheet[step], rest, value)
        return None if inner is None else (*sheet[:step], inner, *sheet[step + 1 :])
    return None
