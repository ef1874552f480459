"""Many cases of one sheet as arrays: their numbers by a form of the varied ones, their starts found all at once.

A form is found from some sheets and verified with others. Cases without one go the ordinary way, case by case.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np
from numpy.typing import NDArray

from tmodes.errors import InputError, InputErrors
from tmodes.model.forms import Unfit
from tmodes.sheet import Robot
from tmodes.simulation.start import RunSetup
from tmodes.simulation.vary.cases import Cases
from tmodes.simulation.vary.families import Family, agree
from tmodes.simulation.vary.lanes import Side
from tmodes.simulation.vary.lots import Lot

__all__ = ["array_lots"]

Array = NDArray[np.float64]

_FEW = 12
"""Cases for each varied path, and one more, that are prepared one by one sooner than a form is found."""


def array_lots(
    sheet: Robot,
    values: Mapping[str, Array],
    one: Callable[[int], RunSetup | str],
    progress: Callable[[float], None],
    side: Side = Side.ACTUAL,
    threads: int = 1,
    family: Family | None = None,
) -> list[Lot]:
    """Lots of the cases that can be prepared as arrays; ``one`` prepares a case by itself, as most others are to be.

    None are where there are too few cases, or the numbers of the varied paths act in no simple way, or where starts
    or numbers that were found differ from those of their sheets. ``progress`` is given the share that is done.
    ``family``: what was found and verified before for values among which these are.
    """
    if family is not None:
        cases = family.cases(values)
        return list(
            cases.lots(cases.starts(progress, threads), np.arange(len(next(iter(values.values())))), family.setups)
        )
    whole_of = np.array([*values.values()])
    plain = np.flatnonzero(np.isfinite(whole_of).all(axis=0) & (whole_of != 0).all(axis=0))
    if len(plain) < _FEW * (len(values) + 1):
        return []
    tried = _extremes(whole_of[:, plain], lambda k: one(int(plain[k])))
    setups = {k: lane for k, lane in tried.items() if not isinstance(lane, str)}
    if not setups:
        return []
    try:
        cases = Cases(sheet, dict(zip(values, whole_of[:, plain], strict=True)), next(iter(setups.values())), side)
        starts = cases.starts(progress, threads)
    except Unfit:
        return []
    if any(np.isfinite(starts[k]).all() for k in tried if k not in setups):
        return []
    return list(cases.lots(starts, plain, [*setups.values()])) if agree(cases, starts, setups) else []


def _extremes(values: Array, one: Callable[[int], RunSetup | str]) -> dict[int, RunSetup | str]:
    """The first case, and those with the least and the largest of each number.

    Where such a case is refused, the error is that of the first case that is, by limits of single numbers.
    """
    chosen = sorted({0, *values.argmin(axis=1).tolist(), *values.argmax(axis=1).tolist()})
    tried: dict[int, RunSetup | str] = {}
    for k in chosen:
        try:
            tried[k] = one(k)
        except (InputError, InputErrors):
            _first_refused(values, k, one)
            raise
    return tried


def _first_refused(values: Array, wrong: int, one: Callable[[int], RunSetup | str]) -> None:
    """Raise the error of the first case beyond a limit that refuses ``wrong``, which has an extreme number."""

    def refused(k: int) -> bool:
        try:
            one(k)
        except (InputError, InputErrors):
            return True
        return False

    first = wrong
    for numbers in values:
        ends = numbers.min(), numbers.max()
        if numbers[wrong] not in ends or ends[0] == ends[1]:
            continue
        order = np.argsort(numbers * (1 if numbers[wrong] == numbers.max() else -1), kind="stable")
        good, bad = 0, len(order) - 1
        if refused(int(order[good])):
            continue
        while bad - good > 1:
            middle = (good + bad) // 2
            good, bad = (good, middle) if refused(int(order[middle])) else (middle, bad)
        found = int(order[bad:].min())
        first = min(first, found) if refused(found) else first
    one(first)
