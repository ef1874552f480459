"""What is found once for many batches of one sheet: the program of their numbers."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from threading import Lock

import numpy as np
from numpy.typing import NDArray

from tmodes.errors import InputError, InputErrors
from tmodes.model.parameters import Structural
from tmodes.sheet import Robot
from tmodes.simulation.start import RunSetup
from tmodes.simulation.vary.cases import Cases
from tmodes.simulation.vary.lanes import Side

__all__ = ["Family", "Spans", "agree", "family_of", "within"]

Array = NDArray[np.float64]

Spans = Mapping[str, tuple[float, float]]
"""The least and the largest value of each path, over all batches."""

_MOST = 16
"""Families that are kept."""

_SAME_START = 1e-9
"""Difference over the largest number of a start up to which it is the same as that of its sheet: rounding."""


@dataclass(frozen=True, eq=False)
class Family:
    """Cases at the ends of the spans, and their ``setups``, prepared as sheets; the program agrees with all of them."""

    corners: Cases
    setups: list[RunSetup]

    def cases(self, values: Mapping[str, Array]) -> Cases:
        """Other cases, by the same program."""
        return self.corners.others(values)


_KEPT: OrderedDict[object, Family | None] = OrderedDict()
_LOCK = Lock()


def within(values: Mapping[str, Array], spans: Spans | None) -> bool:
    """Whether all values are in their spans, and none is zero, where structure may hang on it."""
    return (
        spans is not None
        and bool(values)
        and all(
            path in spans and spans[path][0] <= own.min() and own.max() <= spans[path][1] and bool((own != 0).all())
            for path, own in values.items()
        )
    )


def family_of(
    sheet: Robot, side: Side, spans: Spans, prepare: Callable[[Mapping[str, float]], RunSetup | str]
) -> Family | None:
    """The family of a sheet's cases within ``spans``, found once; None where there is none.

    ``prepare`` gives a case by itself. It depends on sheet, side and spans alone, not on the batches before.
    """
    key = sheet.model_dump_json(), side, tuple(spans.items())
    with _LOCK:
        if key not in _KEPT:
            _KEPT[key] = _found(sheet, side, spans, prepare)
            if len(_KEPT) > _MOST:
                _KEPT.popitem(last=False)
        return _KEPT[key]


def _found(
    sheet: Robot, side: Side, spans: Spans, prepare: Callable[[Mapping[str, float]], RunSetup | str]
) -> Family | None:
    middle = {path: (low + high) / 2 for path, (low, high) in spans.items()}
    corners = [middle, *({**middle, path: end} for path, ends in spans.items() for end in dict.fromkeys(ends))]
    try:
        setups = [prepare(corner) for corner in corners]
    except (InputError, InputErrors):
        return None
    if any(isinstance(setup, str) for setup in setups):
        return None
    known = [setup for setup in setups if not isinstance(setup, str)]
    values = {path: np.array([corner[path] for corner in corners]) for path in spans}
    cases = Cases(sheet, values, 0, known[0], side)
    try:
        if not cases.program.holds(values).all():
            return None
        starts = cases.starts(lambda share: None, 1)
    except Structural:
        return None
    return Family(cases, known) if agree(cases, starts, dict(enumerate(known))) else None


def agree(cases: Cases, starts: Array, setups: Mapping[int, RunSetup]) -> bool:
    """Whether starts and numbers of some cases, by index, are those of their sheets but for rounding."""
    return all(_same(starts[k], setup.start) and cases.has_numbers(k, setup) for k, setup in setups.items())


def _same(found: Array, true: Array) -> bool:
    """Whether a start, where one was found, is that of its sheet but for rounding."""
    return not np.abs(found - true).max(initial=0.0) > _SAME_START * np.abs(true).max(initial=1.0)
