"""A vector of numbers as exact functions of a few others: found by probing, and verified at random points.

Each number is a product of powers of those that it depends on, or a polynomial that is linear in each of their powers:
a mass, a stiffness, the duration of a move enter the numbers of a robot in no other way.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import combinations
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

__all__ = ["Form", "Range", "Unfit", "fitted"]

Array = NDArray[np.float64]

Evaluate = Callable[[Mapping[int, float]], Array]
"""The vector where some of the variables, by their index, have other values than at the start."""

_EXPONENTS = (1, -1, 2, -2, 3, -3, -4, -5, 4, -6, -7)
_SAME = 2e-14
"""Relative change below which a number is called unchanged: rounding."""

_FITS = 2e-13
_VERIFIED = 1e-12
_ROUNDING = 4e-15
"""Size of a number over that of its neighbours in the vector (of the same matrix, the same signal) that is rounding."""

_NEAR = 20
_MOST_TOGETHER = 4
"""Variables whose joint polynomial is looked for."""


class Range(NamedTuple):
    """A variable: where it starts, its least and its largest value."""

    start: float
    low: float
    high: float

    @property
    def far(self) -> float:
        """The end that is the farther from the start."""
        return max((self.low, self.high), key=lambda end: abs(end - self.start))

    @property
    def between(self) -> float:
        """A value at neither end."""
        return self.start + 0.618 * (self.far - self.start)

    def drawn(self, generator: np.random.Generator) -> float:
        """A random value, as likely above as below the start in ratio."""
        if self.low > 0:
            return float(np.exp(generator.uniform(np.log(self.low), np.log(self.high))))
        return float(generator.uniform(self.low, self.high))


class Unfit(Exception):
    """Variables, by their index, whose effect has no such form, each with the reason in words."""

    def __init__(self, reasons: dict[int, str]) -> None:
        super().__init__(reasons)
        self.reasons = reasons


Powers = tuple[tuple[int, int], ...]
"""Variables, by their index, each with its exponent."""


@dataclass(frozen=True, eq=False)
class Form:
    """base * product of (x/start)^p of some numbers; base + sum of terms of others.

    A term is its coefficient times the product of (x^p - start^p)/(far^p - start^p).
    """

    base: Array
    ranges: tuple[Range, ...]
    products: dict[int, Powers] = field(default_factory=dict)
    sums: dict[int, list[tuple[float, Powers]]] = field(default_factory=dict)

    def at(self, values: Mapping[int, float]) -> Array:
        """The vector at values of some variables."""
        found = self.base.copy()
        here = [values.get(k, one.start) for k, one in enumerate(self.ranges)]
        for entry, powers in self.products.items():
            for k, p in powers:
                found[entry] *= (here[k] / self.ranges[k].start) ** p
        for entry, terms in self.sums.items():
            for coefficient, powers in terms:
                found[entry] += coefficient * float(np.prod([_share(self.ranges[k], p, here[k]) for k, p in powers]))
        return found

    def acting(self, start: int, stop: int) -> set[int]:
        """Variables, by their index, that change one of these numbers."""
        each = [powers for entry, powers in self.products.items() if start <= entry < stop]
        each += [powers for entry, terms in self.sums.items() if start <= entry < stop for _, powers in terms]
        return {k for powers in each for k, _ in powers}

    def first(self, count: int) -> Form:
        """The form of so many numbers alone."""
        products = {entry: powers for entry, powers in self.products.items() if entry < count}
        sums = {entry: terms for entry, terms in self.sums.items() if entry < count}
        return Form(self.base[:count], self.ranges, products, sums)

    def info(self) -> dict[str, Any]:
        """As plain data with arrays: what ``web/src/live/map.ts`` evaluates."""
        kinds: dict[Powers, int] = {}
        ratios = [(entry, kinds.setdefault(powers, len(kinds))) for entry, powers in self.products.items()]
        terms = [
            (entry, coefficient, kinds.setdefault(powers, len(kinds)))
            for entry, info in self.sums.items()
            for coefficient, powers in info
        ]
        return {
            "base": self.base,
            "variables": [{"start": one.start, "far": one.far} for one in self.ranges],
            "powers": [[list(pair) for pair in powers] for powers in kinds],
            "products": np.array(ratios, dtype=np.int32).reshape(-1, 2),
            "terms": np.array([(entry, kind) for entry, _, kind in terms], dtype=np.int32).reshape(-1, 2),
            "coefficients": np.array([coefficient for _, coefficient, _ in terms], dtype=float),
        }


def _share(one: Range, p: int, value: float) -> float:
    return (value**p - one.start**p) / (one.far**p - one.start**p)


def fitted(evaluate: Evaluate, ranges: Sequence[Range], generator: np.random.Generator, trials: int = 3) -> Form:
    """The form of a vector over all variables.

    Raises :class:`Unfit` that names the variables without one.
    """
    fit = _Fit(evaluate, tuple(ranges))
    for k in range(len(ranges)):
        fit.probe(k)
    if fit.unfit:
        raise Unfit(fit.unfit)
    form = fit.form()
    for _ in range(trials):
        values = {k: one.drawn(generator) for k, one in enumerate(ranges)}
        found, true = form.at(values), evaluate(values)
        allowed = np.maximum(_VERIFIED * np.maximum(np.abs(true), _reach(form, true)), _ROUNDING * _around(true))
        wrong = ~(np.abs(found - true) <= allowed)
        if wrong.any():
            blamed = max((k for e in np.flatnonzero(wrong) for k, _ in fit.depends.get(int(e), ())), default=None)
            raise Unfit({len(ranges) - 1 if blamed is None else blamed: _ENTANGLED})
    return form


def _reach(form: Form, true: Array) -> Array:
    """Size of what is added up in a number: rounding is of that size."""
    size = np.zeros_like(true)
    for entry, terms in form.sums.items():
        size[entry] = max(abs(form.base[entry]), *(abs(coefficient) for coefficient, _ in terms))
    return size


def _around(values: Array) -> Array:
    """The largest size of a number and its neighbours."""
    padded = np.pad(np.abs(values), _NEAR)
    return np.lib.stride_tricks.sliding_window_view(padded, 2 * _NEAR + 1).max(axis=1, initial=0.0)


_ENTANGLED = "its effect together with others has no simple form"


class _Fit:
    """What is known so far; each point is evaluated once."""

    def __init__(self, evaluate: Evaluate, ranges: tuple[Range, ...]) -> None:
        self.evaluate, self.ranges = evaluate, ranges
        self.base = evaluate({})
        self.depends: dict[int, list[tuple[int, int]]] = {}
        self.unfit: dict[int, str] = {}
        self._known: dict[frozenset[int], Array] = {frozenset(): self.base}

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
            info = self.base[entries] + (far - self.base)[entries] * _share(one, exponent, one.between)
            fits = np.abs(info - between[entries]) <= _FITS * size[entries]
            for entry in entries[fits].tolist():
                self.depends.setdefault(entry, []).append((k, exponent))
            entries = entries[~fits]
        change = np.maximum(np.abs(far - self.base), np.abs(between - self.base))[entries]
        entries = entries[change > _ROUNDING * _around(size)[entries]]
        if len(entries):
            self.unfit[k] = "its effect is no power of it"

    def form(self) -> Form:
        """The form of all numbers."""
        every = self.far(frozenset(k for info in self.depends.values() if len(info) > 1 for k, _ in info))
        form = Form(self.base, self.ranges)
        for entry, powers in self.depends.items():
            if self._is_product(entry, powers, every):
                form.products[entry] = tuple(powers)
            else:
                form.sums[entry] = self._terms(entry, powers, every)
        return form

    def _is_product(self, entry: int, powers: list[tuple[int, int]], every: Array) -> bool:
        ratio = 1.0
        for k, p in powers:
            one = self.ranges[k]
            if one.start == 0:
                return False
            own = (one.far / one.start) ** p
            if abs(self.far(frozenset([k]))[entry] - self.base[entry] * own) > _FITS * abs(self.base[entry] * own):
                return False
            ratio *= own
        return len(powers) == 1 or abs(every[entry] - self.base[entry] * ratio) <= _FITS * abs(every[entry])

    def _terms(self, entry: int, powers: list[tuple[int, int]], every: Array) -> list[tuple[float, Powers]]:
        """Coefficients by inclusion and exclusion of the corners; without mixed terms where none are needed."""
        alone = [(self._change(entry, (one,)), (one,)) for one in powers]
        total = self.base[entry] + sum(change for change, _ in alone)
        size = abs(self.base[entry]) + sum(abs(change) for change, _ in alone)
        if len(powers) == 1 or abs(total - every[entry]) <= _FITS * size:
            return alone
        if len(powers) > _MOST_TOGETHER:
            raise Unfit({max(k for k, _ in powers): _ENTANGLED})
        groups = [group for count in range(2, len(powers) + 1) for group in combinations(powers, count)]
        mixed = [(self._change(entry, group), group) for group in groups]
        return [*alone, *((change, group) for change, group in mixed if abs(change) > _SAME * size)]

    def _change(self, entry: int, group: Powers) -> float:
        names = [k for k, _ in group]
        parts = [part for count in range(len(names) + 1) for part in combinations(names, count)]
        return float(sum((-1) ** (len(names) - len(part)) * self.far(frozenset(part))[entry] for part in parts))
