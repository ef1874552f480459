"""Which coordinates of an arm stand still in statics, and the pose from which its rest is sought."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.quasistatic import gear_inputs, sprung
from tmodes.errors import InputError
from tmodes.model.model import Model

__all__ = ["driven", "free_coordinates", "starting_pose"]

Array = NDArray[np.float64]

LARGEST = 1e6
"""Largest value of a coordinate that is held [rad, m]."""


def driven(model: Model) -> list[int]:
    """Coordinates that a drive holds: motors before elastic gears, and joints driven directly or prescribed."""
    return sorted(axis.input for axis in model.parts.axes if axis.axis.drive.is_driven)


def free_coordinates(model: Model, held: Mapping[str, float], free: Sequence[str]) -> NDArray[np.intp]:
    """Indices of the coordinates to be found: all but the driven ones and ``held``, and those named ``free``."""
    _check_names(model, (*held, *free))
    both = sorted({*held} & {*free})
    if both:
        raise InputError(
            f"free: {both[0]}",
            "a coordinate that is also held",
            "held or free, not both",
            "take it out of one of the two",
        )
    still = {model.coordinates[k] for k in driven(model)} | {*held}
    names = enumerate(model.coordinates)
    return np.array([k for k, name in names if name in free or name not in still], dtype=np.intp)


def starting_pose(model: Model, held: Mapping[str, float], start: Mapping[str, float]) -> Array:
    """The unloaded pose (nq,): ``held`` and ``start`` as given, joints behind gears where their motors put them."""
    _check_names(model, start)
    given = {**start, **held}
    _check_numbers(given)
    q = np.zeros(model.nq)
    names = list(model.coordinates)
    q[model.motors] = [given.get(names[k], given.get(names[k].removesuffix(".motor"), 0.0)) for k in model.motors]
    q[sprung(model)] = gear_inputs(model, q[None], rest=True)[0]
    for name, value in given.items():
        q[names.index(name)] = value
    return q


def _check_names(model: Model, names: Iterable[str]) -> None:
    from difflib import get_close_matches

    for name in names:
        if name not in model.coordinates:
            close = get_close_matches(name, model.coordinates, 1)
            hint = f"did you mean `{close[0]}`?" if close else "check the spelling"
            raise InputError("coordinate", f"`{name}`", f"one of {', '.join(model.coordinates)}", hint)


def _check_numbers(values: Mapping[str, float]) -> None:
    for name, value in values.items():
        if not abs(value) <= LARGEST:
            raise InputError(name, repr(value), f"a finite value within {LARGEST:g}", "give it in radians or meters")
