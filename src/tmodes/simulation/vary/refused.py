"""Cases that the sheet refuses, such as a mass below zero: found by the ends of each varied number, not one by one."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np
from numpy.typing import NDArray

from tmodes.errors import InputError, InputErrors
from tmodes.sheet import Robot
from tmodes.simulation.vary.families import Spans, within
from tmodes.simulation.vary.simulate import changes_of

__all__ = ["accepted", "refused_cases"]

Array = NDArray[np.float64]


_ACCEPTED: dict[object, bool] = {}


def accepted(sheet: Robot, values: Mapping[str, Array], spans: Spans | None) -> bool:
    """Whether no case can be refused: all values lie within ``spans`` whose ends the sheet takes, one at a time."""
    if spans is None or not within(values, spans):
        return False
    key = sheet.model_dump_json(), tuple(spans.items())
    if key not in _ACCEPTED:
        middle = {path: (low + high) / 2 for path, (low, high) in spans.items()}
        corners = [{**middle, path: end} for path, ends in spans.items() for end in ends]
        _ACCEPTED[key] = not refused_cases(sheet, {path: np.array([one[path] for one in corners]) for path in spans})
    return _ACCEPTED[key]


def refused_cases(sheet: Robot, values: Mapping[str, Array]) -> dict[int, str]:
    """Messages of the cases that are refused, by index; ``values`` (k,) of each path.

    Of each path the numbers beyond a limit are refused. What is not finite, or zero, is looked at case by case.
    """
    messages: dict[int, str] = {}
    good: set[int] = set()

    def refuses(index: int) -> bool:
        if index not in messages and index not in good:
            try:
                sheet.with_(changes_of(values, index)).pair()
                good.add(index)
            except (InputError, InputErrors) as error:
                messages[index] = str(error)
        return index in messages

    whole = np.array([*values.values()])
    usual = np.isfinite(whole).all(axis=0) & (whole != 0).all(axis=0)
    for index in np.flatnonzero(~usual).tolist():
        refuses(index)
    left = np.flatnonzero(usual)
    while len(left):
        numbers = whole[:, left]
        ends = {*numbers.argmin(axis=1).tolist(), *numbers.argmax(axis=1).tolist()}
        wrong = [k for k in ends if refuses(int(left[k]))]
        if not wrong:
            break
        for k in wrong:
            _look_beyond(numbers, k, lambda place, left=left: refuses(int(left[place])))
        left = left[[index not in messages for index in left.tolist()]]
    return dict(sorted(messages.items()))


def _look_beyond(numbers: Array, wrong: int, refuses: Callable[[int], bool]) -> None:
    """Look at all cases beyond the limit of each path of which ``wrong`` has an end that is refused."""
    for row in numbers:
        if row[wrong] not in (row.min(), row.max()) or row.min() == row.max():
            continue
        order = np.argsort(row * (1 if row[wrong] == row.max() else -1), kind="stable")
        good, bad = -1, int(np.flatnonzero(order == wrong)[0])
        while bad - good > 1:
            middle = (good + bad) // 2
            good, bad = (good, middle) if refuses(int(order[middle])) else (middle, bad)
        for place in order[bad:].tolist():
            refuses(place)
