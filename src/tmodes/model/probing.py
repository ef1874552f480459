"""What is found about a vector of numbers by probing: which variables change each of them, and by which functions."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from tmodes.model.accuracy import rounding
from tmodes.model.curves import Curve, Samples
from tmodes.model.forms import Form, Powers, Product, Range, Unfit, share, variables_of

__all__ = ["ENTANGLED", "Entangled", "Evaluate", "Fit", "Numbers"]

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


class Entangled(Unfit):
    """Variables of which each by itself has a form."""


class Numbers:
    """The vector at points; ``count``: how often it was evaluated, once at each."""

    def __init__(self, evaluate: Evaluate) -> None:
        self._evaluate, self._known, self.count = evaluate, dict[tuple[tuple[int, float], ...], Array](), 0

    def at(self, values: Mapping[int, float], *, keep: bool = True) -> Array:
        """The vector where some variables have other values than at the start."""
        point = tuple(sorted(values.items()))
        if point in self._known:
            return self._known[point]
        self.count += 1
        found = self._evaluate(values)
        if keep:
            self._known[point] = found
        return found

    def known(self) -> Numbers:
        """The same at the points that were kept; raises :class:`tmodes.model.forms.Unfit` at others."""

        def unknown(values: Mapping[int, float]) -> Array:
            raise Unfit(dict.fromkeys(values, "it is not known there"))

        found = Numbers(unknown)
        found._known = self._known
        return found


class Fit:
    """What is known so far. After the numbers are the squares of some of them, ``squared``, as numbers of their own.

    ``roots``: the numbers that are to be described by their squares, by their index, with that of the square.
    """

    def __init__(
        self, numbers: Numbers, ranges: tuple[Range, ...], *, curves: bool, squared: Sequence[int] = ()
    ) -> None:
        self.numbers, self.ranges, self.curves, self.squared = numbers, ranges, curves, squared
        self.base = self.evaluate({})
        self.depends: dict[int, Powers] = {}
        self.unfit: dict[int, str] = {}
        self.lost: set[int] = set()
        self.roots: dict[int, int] = {}
        self._known: dict[frozenset[int], Array] = {frozenset(): self.base}

    def with_squares(self, entries: Sequence[int]) -> Fit:
        """The same with the squares of some numbers, probed again by the vectors that are known."""
        found = Fit(self.numbers.known(), self.ranges, curves=self.curves, squared=entries)
        for k in range(len(self.ranges)):
            found.probe(k)
        found.numbers = self.numbers
        return found

    def square_of(self, entry: int) -> int:
        """Where the square of a number is."""
        return len(self.base) - len(self.squared) + self.squared.index(entry)

    def evaluate(self, values: Mapping[int, float], *, keep: bool = True) -> Array:
        """All numbers where some variables have other values than at the start."""
        found = self.numbers.at(values, keep=keep)
        return np.concatenate([found, found[[*self.squared]] ** 2]) if self.squared else found

    def noise(self, values: Array) -> Array:
        """Size of what is rounding in all numbers; in a square what comes of that of its number."""
        if not self.squared:
            return rounding(values)
        found = rounding(values[: len(values) - len(self.squared)])
        own = found[[*self.squared]]
        return np.concatenate([found, own * (2 * np.sqrt(values[len(found) :]) + own)])

    def far(self, which: frozenset[int]) -> Array:
        """The vector with some variables at their far ends."""
        if which not in self._known:
            self._known[which] = self.evaluate({k: self.ranges[k].far for k in which})
        return self._known[which]

    def probe(self, k: int) -> None:
        """Which numbers a variable changes, and with which power."""
        one = self.ranges[k]
        try:
            far, between = self.far(frozenset([k])), self.evaluate({k: one.between})
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
        entries = entries[change > self.noise(size)[entries]]
        if len(entries) and self.curves:
            entries = self._curved(k, entries)
        if len(entries):
            self.lost.update(entries.tolist())
            self.unfit[k] = "its effect is no power of it"

    def _depend(self, entry: int, k: int, p: int | Curve) -> None:
        self.depends[entry] = (*self.depends.get(entry, ()), (k, p))

    def _curved(self, k: int, entries: NDArray[np.intp]) -> NDArray[np.intp]:
        """Find curves of the numbers ``entries`` that are no power of a variable; those that have none are left."""
        one = self.ranges[k]
        samples = Samples(lambda value: self.evaluate({k: value}), one.low, one.high)
        try:
            while len(entries) and samples.refined():
                entries = self._shared(k, entries, samples)
        except Unfit:
            return entries
        return entries

    def _shared(self, k: int, entries: NDArray[np.intp], samples: Samples) -> NDArray[np.intp]:
        """Curves through some samples, each for all numbers that change alike; what has none is left."""
        left: list[int] = []
        step, vectors = self.far(frozenset([k])) - self.base, samples.vectors
        while len(entries):
            found = vectors[:, entries]
            size = np.abs(found).max(axis=0)
            first = int(np.argmax(np.abs(step[entries]) / size))
            if step[entries[first]] == 0:
                return np.array([*left, *entries.tolist()], dtype=np.intp)
            shares = (found[:, first] - self.base[entries[first]]) / step[entries[first]]
            curve = samples.curve(shares)
            alike = np.abs(self.base[entries] + step[entries] * shares[:, None] - found).max(axis=0) <= _FITS * size
            alike[first] = True
            for entry in entries[alike].tolist():
                if curve is None:
                    left.append(entry)
                else:
                    self._depend(entry, k, curve)
            entries = entries[~alike]
        return np.array(left, dtype=np.intp)

    def form(self) -> Form:
        """The form of all numbers."""
        every = self.far(frozenset(k for info in self.depends.values() if len(info) > 1 for k in variables_of(info)))
        count = len(self.numbers.at({}))
        form = Form(self.base[:count].copy(), self.ranges)
        places = {square: entry for entry, square in self.roots.items()}
        for one, powers in self.depends.items():
            entry = places.get(one, one)
            if product := self._product(one, powers, every):
                form.products[entry] = product
            else:
                form.sums[entry] = self.terms(one, powers, every)
            if one in places:
                form.roots[entry] = float(np.sign(form.base[entry]))
                form.base[entry] = self.base[one]
        return form

    def _product(self, entry: int, powers: Powers, every: Array) -> Product:
        """The number as a product of powers; empty where it is none."""
        ratio, found = 1.0, list[tuple[int, int]]()
        for k, p in powers:
            one = self.ranges[k]
            if one.start == 0 or not isinstance(p, int):
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
            raise Entangled({max(variables_of(powers)): ENTANGLED})
        groups = [group for count in range(2, len(powers) + 1) for group in combinations(powers, count)]
        mixed = [(self._change(entry, group), group) for group in groups]
        return [*alone, *((change, group) for change, group in mixed if abs(change) > _SAME * size)]

    def _change(self, entry: int, group: Powers) -> float:
        parts = [part for count in range(len(group) + 1) for part in combinations(group, count)]
        signs = [(-1) ** (len(group) - len(part)) for part in parts]
        return float(sum(sign * self.far(variables_of(part))[entry] for sign, part in zip(signs, parts, strict=True)))
