"""Values of coordinates that somebody gives by name: numbers in SI units, or text with a unit (``"45 deg"``)."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from tmodes.analysis.statics.loads import LARGEST as LARGEST_LOAD
from tmodes.errors import InputError
from tmodes.io.units import finite_number
from tmodes.io.words import meant
from tmodes.model.model import Model

__all__ = ["check_names", "coordinate_numbers"]

LARGEST = 1e6
"""Largest value of a coordinate or a rate that is given [rad, m, rad/s, m/s]."""


def coordinate_numbers(
    model: Model, values: Mapping[str, Any] | None, *, rate: bool = False, effort: bool = False
) -> dict[str, float]:
    """Values by coordinate [rad, m; ``rate``: rad/s, m/s; ``effort``: N*m, N], each a number or text with a unit.

    Raises :class:`tmodes.errors.InputError` for an unknown name, and for what is no finite number of that unit.
    """
    given = values or {}
    check_names(model, given)
    units = model.chain.units(given)
    if rate:
        units = {name: "1/s" if unit == "-" else f"{unit}/s" for name, unit in units.items()}
    if effort:
        units = {name: "N" if unit == "m" else "N*m" for name, unit in units.items()}
    most = LARGEST_LOAD if effort else LARGEST
    return {name: finite_number(name, value, units[name], most=most) for name, value in given.items()}


def check_names(model: Model, names: Iterable[str]) -> None:
    """Refuse names that are no coordinates of the model: :class:`tmodes.errors.InputError` with the nearest one."""
    for name in names:
        if name not in model.coordinates:
            hint = meant(str(name), model.coordinates, "check the spelling")
            raise InputError("coordinate", f"`{name}`", f"one of {', '.join(model.coordinates)}", hint)
