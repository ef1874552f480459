"""How all numbers of a robot depend on what is varied, block by block: from some of its sheets, fitted and verified."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.errors import InputError, InputErrors
from tmodes.model.fitting import fitted
from tmodes.model.forms import Form, Range, Unfit
from tmodes.sheet import Robot, RobotPair

__all__ = ["block_forms", "pair_at"]

Array = NDArray[np.float64]
Point = Mapping[int, float]
"""Values of some varied paths, by their index; the others have their least."""

_SEED = 20100


def block_forms(
    numbers: Callable[[Point], tuple[Array, Any]], ranges: Sequence[Range], structure: Any, most: int
) -> dict[str, Form]:
    """The form of each block, by its name.

    ``numbers`` gives at a point all numbers (n,) and what must be the same everywhere, the ``structure``; its last part
    says where each block is. ``most``: vectors of numbers that surfaces of entangled paths may take; as many as there
    are cases pay, since a vector takes half to two thirds of the time of a case by itself. Raises
    :class:`tmodes.model.forms.Unfit` where there is no form.
    """

    def vector(point: Point) -> Array:
        found, own = numbers(point)
        if own != structure:
            raise Unfit({max(point, default=0): "it changes the structure"})
        return found

    places = structure[-1]
    form = fitted(vector, tuple(ranges), np.random.default_rng(_SEED), curves=True, most=most)
    ends = {name: place["start"] + int(np.prod(place["shape"])) for name, place in places.items()}
    return {name: form.part(place["start"], ends[name]) for name, place in places.items()}


def pair_at(sheet: Robot, paths: Iterable[str], ranges: Sequence[Range], point: Point) -> RobotPair:
    """The robots of a sheet at a point; raises :class:`tmodes.model.forms.Unfit` where the sheet refuses it."""
    at = [point.get(k, one.start) for k, one in enumerate(ranges)]
    try:
        return sheet.with_(dict(zip(paths, at, strict=True))).pair()
    except (InputError, InputErrors) as error:
        raise Unfit({max(point, default=0): f"the sheet refuses it: {error}"}) from error
