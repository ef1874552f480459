"""The space of a study's parameters: each with its distribution or its choices, its nominal value, and correlations."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.io.words import meant
from tmodes.kinds.schema.quantity import Issue, plain_texts
from tmodes.kinds.signals.formula_grammar import CHOICES, CONSTANTS, FUNCTIONS, SEVERAL
from tmodes.study.distributions import Distribution
from tmodes.study.rows import OWN_COLUMNS

__all__ = [
    "Dimension",
    "ParameterSpace",
    "circle",
    "correlation_matrix",
    "nearest_correlation",
    "ordered",
    "study_issues",
]

Array = NDArray[np.float64]

_INSIDE = float(np.nextafter(0.0, 1.0)), float(np.nextafter(1.0, 0.0))
"""Shares that are neither 0 nor 1, where a quantile may be infinite."""


@dataclass(frozen=True, eq=False)
class Dimension:
    """One parameter: its ``distribution``, or so many ``choices``, each as likely as any other."""

    name: str
    nominal: float
    distribution: Distribution | None = None
    choices: int = 0

    def at(self, shares: Array) -> Array:
        """Values (k,) at shares (k,) of all."""
        if self.distribution is None:
            return self._chosen(shares)
        return np.asarray(self.distribution.at(np.clip(shares, *_INSIDE)), dtype=float)

    def between(self, shares: Array) -> Array:
        """Values (k,) at shares (k,) of the way from the least to the largest."""
        if self.distribution is None:
            return self._chosen(shares)
        if listed := self.distribution.listed:
            return np.array(listed)[np.minimum((shares * len(listed)).astype(int), len(listed) - 1)]
        low, high = self.distribution.ends
        return np.clip(low + (high - low) * shares, low, high)

    def levels(self, points: int) -> Array:
        """Evenly spaced values, the ends included; of a list of values all of them."""
        if self.distribution is None:
            return np.arange(float(self.choices))
        if listed := self.distribution.listed:
            return np.array(listed)
        return np.linspace(*self.distribution.ends, points) if points > 1 else np.array([self.nominal])

    def _chosen(self, shares: Array) -> Array:
        return np.minimum(np.floor(shares * self.choices), self.choices - 1)


@dataclass(frozen=True, eq=False)
class ParameterSpace:
    """All parameters, as plans see them. ``correlation`` (d, d): of the underlying normals (Gaussian copula)."""

    dimensions: Sequence[Dimension]
    correlation: Array | None = field(default=None)

    @property
    def names(self) -> tuple[str, ...]:
        """Their names, in order."""
        return tuple(one.name for one in self.dimensions)

    @property
    def chosen(self) -> frozenset[str]:
        """Names of those that are chosen from a list."""
        return frozenset(one.name for one in self.dimensions if one.distribution is None)

    @property
    def nominal(self) -> Array:
        """Their nominal values, (d,)."""
        return np.array([one.nominal for one in self.dimensions])

    def drawn(self, shares: Array) -> Array:
        """Values (k, d) of independent uniform ``shares`` (k, d): by each distribution, and correlated as asked.

        Correlations are those of normals of which each value is at the same share (Gaussian copula; Nelsen, An
        Introduction to Copulas, 2006): ranks stay those of the normals.
        """
        if self.correlation is not None:
            from scipy.special import ndtr, ndtri

            lower = np.linalg.cholesky(self.correlation)
            mixed = [k for k, row in enumerate(lower) if row[:k].any()]  # all others stay to the last digit
            normals = ndtri(np.clip(shares, *_INSIDE))
            shares = shares.copy()
            shares[:, mixed] = ndtr(normals @ lower[mixed].T)
        return np.column_stack([one.at(shares[:, k]) for k, one in enumerate(self.dimensions)])

    def between(self, shares: Array) -> Array:
        """Values (k, d) at shares (k, d) of the way from the least to the largest value of each; no correlation."""
        return np.column_stack([one.between(shares[:, k]) for k, one in enumerate(self.dimensions)])

    def levels(self, name: str, points: int) -> Array:
        """Evenly spaced values of a parameter, its ends included; of one with a list of values, all of them."""
        return next(one for one in self.dimensions if one.name == name).levels(points)


def correlation_matrix(names: Sequence[str], pairs: Sequence[tuple[str, str, float]]) -> Array:
    """The matrix (d, d) of pairs of names with their correlation."""
    matrix = np.eye(len(names))
    for one, other, value in pairs:
        i, j = names.index(one), names.index(other)
        matrix[i, j] = matrix[j, i] = value
    return matrix


def nearest_correlation(matrix: Array, least: float = 1e-6) -> Array:
    """A positive definite correlation matrix (d, d) near a symmetric one.

    By alternating projections on matrices with eigenvalues of at least ``least`` and on those with ones on the diagonal
    (Higham, IMA Journal of Numerical Analysis 22, 2002), then a step towards the unit matrix.
    """
    found, correction = matrix.copy(), np.zeros_like(matrix)
    for _ in range(200):
        shifted = found - correction
        values, vectors = np.linalg.eigh(shifted)
        positive = vectors * np.maximum(values, least) @ vectors.T
        correction = positive - shifted
        found = positive.copy()
        np.fill_diagonal(found, 1.0)
    lowest = float(np.linalg.eigvalsh(found)[0])
    share = max(0.0, (least - lowest) / (1 - lowest))
    return (1 - share) * found + share * np.eye(len(found))


_NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]{0,59}")
_TAKEN = {*FUNCTIONS, *SEVERAL, *CHOICES, *CONSTANTS, "and", "or", "not"}
"""Words of formulas."""


_EMPTY = {
    "parameters": ("at least one parameter", "write one: `payload: {path: payload.mass, distribution: {...}}`"),
    "quantities": ("at least one quantity", "write one: `peak: {series: deviation, reduce: max}`"),
}
"""What is expected of a group without a name, and how to write it."""


def study_issues(sheet: Any) -> Iterator[Issue]:
    """All that is wrong with a study without its robot."""
    yield from plain_texts({key: getattr(sheet, key) for key in ("name", "title")})
    for group in ("parameters", "quantities"):
        if not getattr(sheet, group):
            yield Issue(group, "none", *_EMPTY[group])
    yield from _names(sheet)
    yield from _expressions(sheet)
    yield from _correlations(sheet)
    yield from _optimized(sheet)


def _names(sheet: Any) -> Iterator[Issue]:
    for group in ("parameters", "quantities"):
        for name, one in getattr(sheet, group).items():
            yield from plain_texts({f"{group}.{name}.title": one.title})
            if not _NAME.fullmatch(name):
                hint = "write a name such as gear_stiffness"
                yield Issue(f"{group}.{name}", f"the name {name[:70]!a}", "letters, digits and _, a letter first", hint)
            elif name in _TAKEN or name in OWN_COLUMNS:
                what = "word of formulas" if name in _TAKEN else "column of the table"
                yield Issue(f"{group}.{name}", f"the name {name!r}, a {what}", "another name", f"write {name}_1")
    for name in sheet.quantities.keys() & sheet.parameters.keys():
        got = f"the name {name!r}, which a parameter has"
        yield Issue(f"quantities.{name}", got, "a name of its own", "rename one of the two")


def _expressions(sheet: Any) -> Iterator[Issue]:
    names = (*sheet.parameters, *sheet.quantities)
    needs = {name: one.needs().names for name, one in sheet.quantities.items()}
    wrong = False
    for name, one in sheet.quantities.items():
        for key, got, expected, hint in one.name_issues(names):
            wrong = True
            yield Issue(f"quantities.{name}.{key}", got, expected, hint)
    if not wrong and (names_around := circle(needs)):
        got = f"a circle: {' needs '.join(names_around)}"
        yield Issue(f"quantities.{names_around[0]}", got, "quantities that follow from others", "break the circle")


def _correlations(sheet: Any) -> Iterator[Issue]:
    known, pairs, wrong = list(sheet.parameters), [], False
    for k, one in enumerate(sheet.correlations):
        for place, name in enumerate(one.between):
            if name not in known:
                wrong = True
                hint = meant(name, known, "write the name of a parameter")
                yield Issue(f"correlations.{k}.between.{place}", f"the unknown name {name!r}", "a parameter", hint)
            elif sheet.parameters[name].distribution is None:
                wrong = True
                hint = "remove this pair; choices are independent of all else"
                yield Issue(f"correlations.{k}.between.{place}", f"{name!r}, a choice", "a parameter with values", hint)
        pair = frozenset(one.between)
        if len(pair) < 2 or pair in pairs:
            wrong = True
            got = f"{' and '.join(one.between)}, {'given twice' if len(pair) > 1 else 'the same parameter'}"
            yield Issue(f"correlations.{k}.between", got, "two different parameters, each pair once", "remove it")
        pairs.append(pair)
    if not wrong and sheet.correlations:
        yield from _not_positive(sheet)


_LEAST = 1e-9
"""Smallest eigenvalue of a correlation matrix that is taken for positive."""


def _not_positive(sheet: Any) -> Iterator[Issue]:
    names = list(sheet.parameters)
    matrix = correlation_matrix(names, [(*one.between, one.value) for one in sheet.correlations])
    lowest = float(np.linalg.eigvalsh(matrix)[0])
    if lowest < _LEAST:
        near = nearest_correlation(matrix, 1e-3)
        pairs = [one.between for one in sheet.correlations[:6]]
        values = [f"{one} and {other} {near[names.index(one), names.index(other)]:.3f}" for one, other in pairs]
        got = f"correlations that exclude each other: their matrix has the eigenvalue {lowest:.3g}"
        expected = "a matrix with positive eigenvalues alone"
        yield Issue("correlations", got, expected, f"the nearest one has {', '.join(values)}")


def _optimized(sheet: Any) -> Iterator[Issue]:
    design = sheet.optimize.design if sheet.optimize else ()
    for k, name in enumerate(design):
        if name not in sheet.parameters:
            hint = meant(name, sheet.parameters, "write the name of a parameter")
            yield Issue(f"optimize.design.{k}", f"the unknown name {name!r}", "a parameter", hint)
        elif name in design[:k]:
            yield Issue(f"optimize.design.{k}", f"{name!r}, given twice", "each parameter once", "remove it")


def ordered(needs: Mapping[str, Sequence[str]]) -> list[str]:
    """The names, each after those that it needs; those that need nothing of the others stay in their order."""
    done: dict[str, None] = {}

    def visit(name: str) -> None:
        if name in needs and name not in done:
            for inner in needs[name]:
                visit(inner)
            done[name] = None

    for name in needs:
        visit(name)
    return list(done)


def circle(needs: Mapping[str, Sequence[str]]) -> list[str]:
    """Names of which each needs the next, the first and last the same; empty where there is no circle."""
    state: dict[str, bool] = {}

    def visit(name: str, path: list[str]) -> list[str]:
        if name in path:
            return [*path[path.index(name) :], name]
        if name not in needs or state.get(name):
            return []
        for inner in needs[name]:
            if found := visit(inner, [*path, name]):
                return found
        state[name] = True
        return []

    return next((found for name in needs if (found := visit(name, []))), [])
