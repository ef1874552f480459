"""What is found about a vector of numbers by probing: which variables change each of them, and by which functions."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from tmodes.model.accuracy import rounding
from tmodes.model.forms import Form, Powers, Product, Range, Unfit, share, variables_of

__all__ = ["ENTANGLED", "Evaluate", "Fit", "Numbers"]

Array = NDArray[np.float64]

Evaluate = Callable[[Mapping[int, float]], Array]
"""The vector where some of the variables, by their index, have other values than at the start."""

ENTANGLED = "its effect together with others has no simple form"

_EXPONENTS = (1, -1, 2, -2, 3, -3, -4, -5, 4, -6, -7)
_SAME = 2e-14
"""Relative change below which a number is called unchanged: rounding."""

_FITS = 2e-13
_MOST_TOGETHER = 4
"""Variables whose joint polynomial is looked for."""


class Numbers:
    """The vector at points; ``count``: how often it was evaluated, once at each."""

    def __init__(self, evaluate: Evaluate) -> None:
        self._evaluate, self._known, self.count = evaluate, dict[tuple[tuple[int, float], ...], Array](), 0

    def at(self, values: Mapping[int, float]) -> Array:
        """The vector where some variables have other values than at the start."""
        point = tuple(sorted(values.items()))
        if point in self._known:
            return self._known[point]
        self.count += 1
        found = self._evaluate(values)
        self._known[point] = found
        return found


class Fit:
    """What is known so far of the numbers."""

    def __init__(self, numbers: Numbers, ranges: tuple[Range, ...]) -> None:
        self.numbers, self.ranges = numbers, ranges
        self.base = numbers.at({})
        self.depends: dict[int, Powers] = {}
        self.unfit: dict[int, str] = {}
        self._known: dict[frozenset[int], Array] = {frozenset(): self.base}

    def far(self, which: frozenset[int]) -> Array:
        """The vector with some variables at their far ends."""
        if which not in self._known:
            self._known[which] = self.numbers.at({k: self.ranges[k].far for k in which})
        return self._known[which]

    def probe(self, k: int) -> None:
        """Which numbers a variable changes, and with which power."""
        one = self.ranges[k]
        try:
            far, between = self.far(frozenset([k])), self.numbers.at({k: one.between})
        except Unfit as error:
            self.unfit[k] = next(iter(error.reasons.values()))
            return
        size = np.maximum(np.maximum(np.abs(far), np.abs(self.base)), np.abs(between))
        entries = np.flatnonzero(np.maximum(np.abs(far - self.base), np.abs(between - self.base)) > _SAME * size)
        for exponent in _EXPONENTS:
            if not len(entries) or (exponent < 0 and one.start * one.far <= 0):
                continue
            info = self.base[entries] + (far - self.base)[entries] * share(one, exponent, one.between)
            fits = np.abs(info - between[entries]) <= _FITS * size[entries]
            for entry in entries[fits].tolist():
                self._depend(entry, k, exponent)
            entries = entries[~fits]
        change = np.maximum(np.abs(far - self.base), np.abs(between - self.base))[entries]
        if (change > rounding(size)[entries]).any():
            self.unfit[k] = "its effect is no power of it"

    def _depend(self, entry: int, k: int, p: int) -> None:
        self.depends[entry] = (*self.depends.get(entry, ()), (k, p))

    def form(self) -> Form:
        """The form of all numbers."""
        every = self.far(frozenset(k for info in self.depends.values() if len(info) > 1 for k in variables_of(info)))
        form = Form(self.base.copy(), self.ranges)
        for entry, powers in self.depends.items():
            if product := self._product(entry, powers, every):
                form.products[entry] = product
            else:
                form.sums[entry] = self.terms(entry, powers, every)
        return form

    def _product(self, entry: int, powers: Powers, every: Array) -> Product:
        """The number as a product of powers; empty where it is none."""
        ratio, found = 1.0, list[tuple[int, int]]()
        for k, p in powers:
            one = self.ranges[k]
            if one.start == 0:
                return ()
            own = (one.far / one.start) ** p
            if abs(self.far(frozenset([k]))[entry] - self.base[entry] * own) > _FITS * abs(self.base[entry] * own):
                return ()
            ratio *= own
            found.append((k, p))
        whole = len(powers) == 1 or abs(every[entry] - self.base[entry] * ratio) <= _FITS * abs(every[entry])
        return tuple(found) if whole else ()

    def terms(self, entry: int, powers: Powers, every: Array) -> list[tuple[float, Powers]]:
        """Coefficients by inclusion and exclusion of the corners; without mixed terms where none are needed."""
        alone = [(self._change(entry, (one,)), (one,)) for one in powers]
        total = self.base[entry] + sum(change for change, _ in alone)
        size = abs(self.base[entry]) + sum(abs(change) for change, _ in alone)
        if len(powers) == 1 or abs(total - every[entry]) <= _FITS * size:
            return alone
        if len(powers) > _MOST_TOGETHER:
            raise Unfit({max(variables_of(powers)): ENTANGLED})
        groups = [group for count in range(2, len(powers) + 1) for group in combinations(powers, count)]
        mixed = [(self._change(entry, group), group) for group in groups]
        return [*alone, *((change, group) for change, group in mixed if abs(change) > _SAME * size)]

    def _change(self, entry: int, group: Powers) -> float:
        parts = [part for count in range(len(group) + 1) for part in combinations(group, count)]
        signs = [(-1) ** (len(group) - len(part)) for part in parts]
        return float(sum(sign * self.far(variables_of(part))[entry] for sign, part in zip(signs, parts, strict=True)))
