"""A vector of numbers as exact functions of a few others.

Each number is a product of powers of those that it depends on, or a polynomial that is linear in each of their powers:
a mass, a stiffness, the duration of a move enter the numbers of a robot in no other way.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

__all__ = ["Form", "Powers", "Product", "Range", "Unfit", "share", "variables_of"]

Array = NDArray[np.float64]


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

    def shares(self, values: Array) -> Array:
        """Where values are between the least and the largest, 0 to 1, by their ratio where none is negative."""
        low, high, here = (np.log(x) if self.low > 0 else x for x in (self.low, self.high, values))
        return np.asarray((here - low) / ((high - low) or 1.0))

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


Product = tuple[tuple[int, int], ...]
"""Variables, by their index, each with its exponent."""

Powers = tuple[tuple[int, int], ...]
"""Variables, by their index, each with its exponent."""


def variables_of(powers: Powers) -> frozenset[int]:
    """The variables, by their index."""
    return frozenset(k for k, _ in powers)


@dataclass(frozen=True, eq=False)
class Form:
    """base * product of (x/start)^p of some numbers; base + sum of terms of others.

    A term is its coefficient times the product of (x^p - start^p)/(far^p - start^p).
    """

    base: Array
    ranges: tuple[Range, ...]
    products: dict[int, Product] = field(default_factory=dict)
    sums: dict[int, list[tuple[float, Powers]]] = field(default_factory=dict)

    @classmethod
    def of(cls, base: Array, ranges: tuple[Range, ...], parts: dict[str, Any]) -> Form:
        """The form with these :meth:`parts`."""
        products = {entry: tuple(map(tuple, powers)) for entry, powers in parts["products"]}
        sums = {entry: [(one, tuple(map(tuple, powers))) for one, powers in terms] for entry, terms in parts["sums"]}
        return cls(base, ranges, products, sums)

    def parts(self) -> dict[str, Any]:
        """All but the base and the ranges as plain data, as JSON holds it."""
        return {"products": [*self.products.items()], "sums": [*self.sums.items()]}

    def at(self, values: Mapping[int, float | Array]) -> Array:
        """The vector (n,) at values of some variables; of k values each, the vectors (k, n)."""
        here = [values.get(k, one.start) for k, one in enumerate(self.ranges)]
        found = np.empty((*np.broadcast_shapes(*map(np.shape, here)), len(self.base)))
        found[...] = self.base
        for entry, powers in self.products.items():
            for k, p in powers:
                found[..., entry] *= (here[k] / self.ranges[k].start) ** p
        known: dict[Powers, Any] = {}
        for entry, terms in self.sums.items():
            for coefficient, powers in terms:
                if powers not in known:
                    known[powers] = math.prod(share(self.ranges[k], p, here[k]) for k, p in powers)
                found[..., entry] += coefficient * known[powers]
        return found

    def acting(self, start: int, stop: int) -> set[int]:
        """Variables, by their index, that change one of these numbers."""
        part = self.part(start, stop)
        each = [*part.products.values(), *(powers for terms in part.sums.values() for _, powers in terms)]
        return {k for powers in each for k in variables_of(powers)}

    def part(self, start: int, stop: int) -> Form:
        """The form of these numbers alone."""
        products = {entry - start: powers for entry, powers in self.products.items() if start <= entry < stop}
        sums = {entry - start: terms for entry, terms in self.sums.items() if start <= entry < stop}
        return Form(self.base[start:stop], self.ranges, products, sums)

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


def share(one: Range, p: int, value: Any) -> Any:
    """(value^p - start^p)/(far^p - start^p)."""
    return (value**p - one.start**p) / (one.far**p - one.start**p)
