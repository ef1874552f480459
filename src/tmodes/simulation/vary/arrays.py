"""Many cases of one sheet as arrays: their numbers by programs, their starts found all at once.

A program is noted at one case and holds for all of the same structure. Cases without one go one by one.
"""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable, Mapping
from threading import Lock
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmodes.errors import InputError, InputErrors
from tmodes.model.parameters import Structural
from tmodes.sheet import Robot
from tmodes.simulation.initial_state import RunSetup
from tmodes.simulation.vary.case_group import CaseGroup, Indices
from tmodes.simulation.vary.cases import Cases
from tmodes.simulation.vary.values import RobotVariant, Whole

__all__ = ["Family", "array_groups", "family_of"]

Array = NDArray[np.float64]
One = Callable[[int], RunSetup | str]

_FEW = 12
"""Cases that are prepared one by one sooner than a program is noted."""

_MOST, _MOST_SMALL, _LEAST = 24, 4, 4
"""Programs of a batch, those of few cases among them, and the cases that one is used for; others go one by one."""

_INSIDE = 1 / 3
"""Where in its span each number is at the case of a family's program: not in the middle, which is 0 of many spans."""

_SAME_START = 1e-9
"""Difference over the largest number of a start up to which it is the same as that of its sheet: rounding."""


class Family(NamedTuple):
    """What is found once for all batches of a study: cases at the ends of each number, their largest eigenvalues."""

    cases: Cases
    fastest: Array


_KEPT: OrderedDict[object, Family | None] = OrderedDict()
_MOST_KEPT = 16
_LOCK = Lock()


def family_of(
    sheet: Robot, variant: RobotVariant, whole: Whole, prepare: Callable[[Mapping[str, float]], RunSetup | str],
    shown: tuple[str, ...] = (),
) -> Family | None:  # fmt: skip
    """The family of all cases of a sheet, found once; None where there is none.

    ``prepare`` gives a case by itself. It depends on sheet, variant and ``whole`` alone, not on the batches before.
    """
    key = sheet.model_dump_json(), variant, whole.cases, tuple(whole.ends.items()), shown
    with _LOCK:
        if key not in _KEPT:
            try:
                _KEPT[key] = _found(sheet, variant, whole, prepare, shown)
            except (InputError, InputErrors, Structural):
                _KEPT[key] = None
            if len(_KEPT) > _MOST_KEPT:
                _KEPT.popitem(last=False)
        return _KEPT[key]


def _found(
    sheet: Robot, variant: RobotVariant, whole: Whole, prepare: Callable[[Mapping[str, float]], RunSetup | str],
    shown: tuple[str, ...],
) -> Family | None:  # fmt: skip
    inside = {path: low + _INSIDE * (high - low) for path, (low, high) in whole.ends.items()}
    corners = [inside, *({**inside, path: end} for path, ends in whole.ends.items() for end in dict.fromkeys(ends))]
    like = prepare(inside)
    if isinstance(like, str):
        return None
    values = {path: np.array([corner[path] for corner in corners]) for path in inside}
    cases, which = Cases(sheet, values, 0, like, variant, whole.cases, shown).holding()
    starts = cases.starts(lambda share: None)
    ends = np.arange(len(which))
    agrees = len(which) and agree(cases, starts, ends, lambda k: prepare(corners[which[k]]) if k else like)
    return Family(cases, cases.fastest(starts, ends)) if agrees else None


def agree(cases: Cases, starts: Array, some: Indices, one: One) -> bool:
    """Whether the starts of ``some`` of the cases, where they were searched, are those of their sheets."""
    if cases.like.rest is None:
        return True
    for k in some.tolist():
        setup = one(k)
        if isinstance(setup, str):
            if np.isfinite(starts[k]).all():
                return False
        elif np.abs(starts[k] - setup.start).max(initial=0.0) > _SAME_START * np.abs(setup.start).max(initial=1.0):
            return False
    return True


def array_groups(
    sheet: Robot,
    values: Mapping[str, Array],
    one: One,
    progress: Callable[[float], None],
    variant: RobotVariant = RobotVariant.ACTUAL,
    threads: int = 1,
    family: Family | None = None,
    shown: tuple[str, ...] = (),
) -> list[CaseGroup]:
    """Groups of the cases that can be prepared as arrays; ``one`` prepares a case by itself, as the others are to be.

    A program is noted at the first case that none before holds for, as long as enough are left. None are where
    lowering cannot be followed, or where starts that were searched differ from those of their sheets: then
    cases are prepared one by one. ``progress`` is given the share that is done. ``family``: what was noted and verified
    before. Raises what ``one`` raises for the first case that the sheet refuses.
    """
    size, groups, small = len(next(iter(values.values()))), list[CaseGroup](), 0
    left = np.flatnonzero(np.isfinite([*values.values()]).all(axis=0))

    def tell(share: float) -> None:
        progress((size - len(left) + share * len(places)) / size)

    if family:
        cases, places = family.cases.others({path: own[left] for path, own in values.items()}).holding()
        places = left[places]
        if len(places):
            groups += cases.groups(cases.starts(tell, threads), places, family.fastest)
        left = np.setdiff1d(left, places)
    for _ in range(_MOST):
        if len(left) < _FEW or small > _MOST_SMALL:
            break
        like = one(int(left[0]))
        if isinstance(like, str):
            left, small = left[1:], small + 1
            continue
        try:
            some = {path: own[left] for path, own in values.items()}
            cases, which = Cases(sheet, some, 0, like, variant, shown=shown).holding()
        except Structural:
            break
        places = left[which]
        left, small = left[~np.isin(left, places)][not len(places) :], small + (len(places) < _FEW)
        if len(places) < min(_FEW, _LEAST):
            continue
        starts, ends = cases.starts(tell, threads), _extremes(cases)
        if not agree(cases, starts, ends, lambda k, places=places: one(int(places[k]))):
            break
        groups += cases.groups(starts, places, cases.fastest(starts, ends))
    return groups


def _extremes(cases: Cases) -> Indices:
    """The first case, and those with the least and the largest of each number."""
    values = np.array([*cases.values.values()])
    return np.unique([0, *values.argmin(axis=1).tolist(), *values.argmax(axis=1).tolist()])
