"""Many cases of one sheet as arrays: their numbers by programs, their starts found all at once.

A program is noted at one case and holds for all of the same structure. Cases without one go one by one.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np
from numpy.typing import NDArray

from tmodes.model.parameters import Structural
from tmodes.sheet import Robot
from tmodes.simulation.start import RunSetup
from tmodes.simulation.vary.cases import Cases
from tmodes.simulation.vary.families import Family, agree
from tmodes.simulation.vary.lanes import Side
from tmodes.simulation.vary.lots import Lot

__all__ = ["array_lots"]

Array = NDArray[np.float64]
One = Callable[[int], RunSetup | str]

_FEW = 12
"""Cases that are prepared one by one sooner than a program is noted."""

_MOST, _MOST_SMALL, _LEAST = 24, 4, 4
"""Programs of a batch, those of few cases among them, and the cases that one is used for; others go one by one."""


def array_lots(
    sheet: Robot,
    values: Mapping[str, Array],
    one: One,
    progress: Callable[[float], None],
    side: Side = Side.ACTUAL,
    threads: int = 1,
    family: Family | None = None,
) -> list[Lot]:
    """Lots of the cases that can be prepared as arrays; ``one`` prepares a case by itself, as the others are to be.

    A program is noted at the first case that none before holds for, as long as enough are left. None are where
    lowering cannot be followed, or where starts or numbers that were found differ from those of their sheets: then
    cases are prepared one by one. ``progress`` is given the share that is done. ``family``: what was noted and verified
    before. Raises what ``one`` raises for the first case that the sheet refuses.
    """
    size, lots, small = len(next(iter(values.values()))), list[Lot](), 0
    left = np.flatnonzero(np.isfinite([*values.values()]).all(axis=0))

    def tell(share: float) -> None:
        progress((size - len(left) + share * len(places)) / size)

    if family:
        cases, places = family.cases({path: own[left] for path, own in values.items()}).holding()
        places = left[places]
        if len(places):
            lots += cases.lots(cases.starts(tell, threads), places, family.setups)
        left = np.setdiff1d(left, places)
    for _ in range(_MOST):
        if len(left) < _FEW or small > _MOST_SMALL:
            break
        like = one(int(left[0]))
        if isinstance(like, str):
            left, small = left[1:], small + 1
            continue
        try:
            cases, which = Cases(sheet, {path: own[left] for path, own in values.items()}, 0, like, side).holding()
        except Structural:
            break
        places = left[which]
        left, small = left[~np.isin(left, places)][not len(places) :], small + (len(places) < _FEW)
        if len(places) < min(_FEW, _LEAST):
            continue
        tried = {k: one(int(places[k])) for k in _extremes(cases)}
        setups = {k: lane for k, lane in tried.items() if not isinstance(lane, str)}
        starts = cases.starts(tell, threads)
        if any(np.isfinite(starts[k]).all() for k in tried if k not in setups) or not agree(cases, starts, setups):
            break
        lots += cases.lots(starts, places, [*setups.values()])
    return lots


def _extremes(cases: Cases) -> list[int]:
    """The first case, and those with the least and the largest of each number."""
    values = np.array([*cases.values.values()])
    return sorted({0, *values.argmin(axis=1).tolist(), *values.argmax(axis=1).tolist()})
