"""A formula, of time or of other named numbers: read by a closed grammar into steps of arithmetic.

What may stand in one: :mod:`tmodes.kinds.signals.formula_grammar`. Where a formula switches there is a knot: from it
on, value and derivatives are those of the piece that begins there.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations, pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.kinds.signals.formula_grammar import (
    CHOICES,
    COMPARED,
    CONSTANTS,
    FUNCTIONS,
    PAIRS,
    SEVERAL,
    TIME,
    FormulaError,
    checked_tree,
)

__all__ = ["FUNCTIONS", "Formula", "FormulaError", "parse_formula"]

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Formula:
    """A formula that was read; not finite where it has no value. One of time is called with times [s], any shape."""

    tree: ast.expr

    def __call__(self, time: Any) -> Array:
        """Its value at each time."""
        return self.at({TIME[0]: np.asarray(time, dtype=float)})

    def at(self, values: Mapping[str, Array]) -> Array:
        """Its value at each of the ``values`` of its names, all of one shape."""
        shape = np.shape(next(iter(values.values())))
        with np.errstate(all="ignore"):
            return np.broadcast_to(np.asarray(_value(self.tree, values, shape), dtype=float), shape).copy()

    def switches(self) -> list[Formula]:
        """Formulas in whose zeros it may jump or have a kink."""
        return [Formula(node) for found in ast.walk(self.tree) for node in _switching(found)]


def _switching(node: ast.AST) -> Iterator[ast.expr]:
    """What changes its sign where a node switches."""
    match node:
        case ast.Compare(left=left, comparators=others):
            yield from (ast.BinOp(one, ast.Sub(), other) for one, other in pairwise([left, *others]))
        case ast.Call(func=ast.Name(id="sign" | "abs"), args=[inner]):
            yield inner
        case ast.Call(func=ast.Name(id="min" | "max"), args=several):
            yield from (ast.BinOp(one, ast.Sub(), other) for one, other in combinations(several, 2))


def parse_formula(text: str, names: Sequence[str] = TIME) -> Formula:
    """The formula of a text in these names; raises :class:`FormulaError` for anything outside of the grammar."""
    return Formula(checked_tree(text, names))


def _value(node: ast.expr, at: Mapping[str, Array], shape: tuple[int, ...]) -> Any:
    match node:
        case ast.Constant(value=value):
            return float(value)  # pyright: ignore[reportArgumentType]  # checked when it was read
        case ast.Name(id=name):
            return at[name] if name in at else CONSTANTS[name]
        case ast.UnaryOp(op=op, operand=inner):
            return -_value(inner, at, shape) if isinstance(op, ast.USub) else _value(inner, at, shape)
        case ast.BinOp(left=left, op=op, right=right):
            return PAIRS[type(op)](_value(left, at, shape), _value(right, at, shape))
        case ast.Call(func=ast.Name(id=name), args=args) if name in CHOICES:
            conditions, values = args[:-1:2], args[1::2]
            total = _value(args[-1], at, shape)
            for condition, value in reversed([*zip(conditions, values, strict=True)]):
                total = np.where(_holds(condition, at, shape), _value(value, at, shape), total)
            return total
        case ast.Call(func=ast.Name(id=name), args=args):
            numbers = [np.broadcast_to(np.asarray(_value(inner, at, shape), dtype=float), shape) for inner in args]
            return SEVERAL[name](np.stack(numbers)) if name in SEVERAL else FUNCTIONS[name](numbers[0])
    raise AssertionError(node)


def _holds(node: ast.expr, at: Mapping[str, Array], shape: tuple[int, ...]) -> Any:
    match node:
        case ast.Compare(left=left, ops=ops, comparators=others):
            values = [_value(inner, at, shape) for inner in (left, *others)]
            compared = zip(ops, pairwise(values), strict=True)
            return np.logical_and.reduce([COMPARED[type(op)](*pair) for op, pair in compared])
        case ast.BoolOp(op=op, values=several):
            both = [_holds(inner, at, shape) for inner in several]
            return np.logical_and.reduce(both) if isinstance(op, ast.And) else np.logical_or.reduce(both)
        case ast.UnaryOp(operand=inner):
            return np.logical_not(_holds(inner, at, shape))
    raise AssertionError(node)
