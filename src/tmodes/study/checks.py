"""What does not fit together in a study: names, correlations, expressions that go in circles."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

import numpy as np

from tmodes.io.words import meant
from tmodes.kinds.schema.quantity import Issue, plain_texts
from tmodes.kinds.signals.formula_grammar import CHOICES, CONSTANTS, FUNCTIONS, SEVERAL
from tmodes.study.order import circle
from tmodes.study.rows import OWN_COLUMNS
from tmodes.study.space import correlation_matrix, nearest_correlation

__all__ = ["study_issues"]

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
        for field, got, expected, hint in one.name_issues(names):
            wrong = True
            yield Issue(f"quantities.{name}.{field}", got, expected, hint)
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
