"""A formula of time: a closed grammar, read into steps of arithmetic. Nothing is ever executed as code.

Numbers, ``t`` [s], ``pi``, + - * / and **, parentheses, the functions of one number in :data:`FUNCTIONS`, ``min`` and
``max`` of several, ``where(condition, value, otherwise)`` and ``piecewise(condition, value, condition, value, ...,
otherwise)``, which takes the value of the first condition that holds. A condition compares numbers by < <= > >=, with
``and``, ``or``, ``not``. The exponent of a power is a number written out, so that no tower of powers can be built.

Where a formula switches there is a knot: from it on, value and derivatives are those of the piece that begins there.
"""

from __future__ import annotations

import ast
import math
import re
import warnings
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from itertools import combinations, pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

__all__ = ["FUNCTIONS", "Formula", "FormulaError", "parse_formula"]

Array = NDArray[np.float64]

LONGEST = 500
MOST_NODES = 200
MOST_DEPTH = 30
LARGEST_EXPONENT = 20
LARGEST_NUMBER = 1e12

LETTERS = re.compile(r"[0-9A-Za-z_.,<>=+\-*/() ]*")

FUNCTIONS: dict[str, Callable[[Array], Array]] = {
    name: getattr(np, name)
    for name in ("sin", "cos", "tan", "exp", "log", "sqrt", "tanh", "sinh", "cosh", "abs", "sign")
} | {"atan": np.arctan, "asin": np.arcsin, "acos": np.arccos}
"""What a formula may call with one number."""

SEVERAL: dict[str, Callable[[Array], Array]] = {"min": np.minimum.reduce, "max": np.maximum.reduce}
"""With two numbers or more."""

CHOICES = ("where", "piecewise")
"""With conditions, each before its value, and a value at the end."""

_COMPARED: dict[type[ast.cmpop], Callable[[Any, Any], Any]] = {
    ast.Lt: np.less,
    ast.LtE: np.less_equal,
    ast.Gt: np.greater,
    ast.GtE: np.greater_equal,
}

CONSTANTS = {"pi": math.pi}

_PAIRS: dict[type[ast.operator], Callable[[Any, Any], Any]] = {
    ast.Add: np.add,
    ast.Sub: np.subtract,
    ast.Mult: np.multiply,
    ast.Div: np.divide,
    ast.Pow: np.power,
}


@dataclass
class FormulaError(ValueError):
    """What is wrong with a formula: got, expected, fix."""

    got: str
    expected: str
    hint: str


@dataclass(frozen=True)
class Formula:
    """A formula of time that was read: call it with times [s], any shape; not finite where it has no value."""

    tree: ast.expr

    def __call__(self, time: Any) -> Array:
        """Its value at each time."""
        times = np.asarray(time, dtype=float)
        with np.errstate(all="ignore"):
            return np.broadcast_to(np.asarray(_value(self.tree, times), dtype=float), times.shape).copy()

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


def parse_formula(text: str) -> Formula:
    """The formula of a text; raises :class:`FormulaError` for anything outside of the grammar."""
    if len(text) > LONGEST:
        raise FormulaError(f"a formula of {len(text)} characters", f"at most {LONGEST}", "write a table instead")
    if not LETTERS.fullmatch(text):
        letter = next(letter for letter in text if not LETTERS.fullmatch(letter))
        hint = "write ** for a power" if letter == "^" else "remove it"
        raise FormulaError(f"the character {letter!a}", "numbers, t, pi, + - * / **, functions", hint)
    tree = _tree(text)
    nodes = sum(1 for _ in ast.walk(tree))
    if nodes > MOST_NODES:
        raise FormulaError(f"a formula of {nodes} parts", f"at most {MOST_NODES}", "write a table instead")
    _check(tree, 0)
    return Formula(tree)


def _tree(text: str) -> ast.expr:
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # the parser's advice on Python code is none on formulas
            return ast.parse(text.strip(), mode="eval").body
    except (SyntaxError, ValueError, MemoryError, RecursionError):
        hint = "look for a missing parenthesis or operator: 2*t, not 2t"
        raise FormulaError(f"the text {text[:60]!r}", "a formula of t, such as 0.5*sin(2*pi*t)", hint) from None


def _check(node: ast.AST, depth: int) -> None:
    """Refuse every node that is not of the grammar."""
    if depth > MOST_DEPTH:
        raise FormulaError(f"more than {MOST_DEPTH} levels", "a shallow formula", "remove parentheses")
    match node:
        case ast.Constant(value=value):
            _check_number(value)
        case ast.Name(id=name):
            if name != "t" and name not in CONSTANTS:
                hint = f"write {name}(...)" if name in FUNCTIONS else "the time is called t"
                raise FormulaError(f"the name {name[:40]!r}", f"t or {', '.join(CONSTANTS)}", hint)
        case ast.UnaryOp(op=ast.UAdd() | ast.USub(), operand=inner):
            _check(inner, depth + 1)
        case ast.BinOp(left=left, op=op, right=right) if type(op) in _PAIRS:
            if isinstance(op, ast.Pow):
                _check_exponent(right)
            _check(left, depth + 1)
            _check(right, depth + 1)
        case ast.Call():
            _check_call(node, depth)
        case ast.Compare() | ast.BoolOp():
            got = f"the condition {ast.unparse(node)[:40]!r} as a number"
            raise FormulaError(got, "a condition in where or piecewise", f"write {_CHOICE}")
        case _:
            got = f"{ast.unparse(node)[:40]!r}, which is no arithmetic"
            raise FormulaError(got, "numbers, t, pi, + - * / **, functions", "write it with these")


_CHOICE = "where(t < 1, value, otherwise)"


def _check_call(node: ast.Call, depth: int) -> None:
    """A known function, with as many arguments as it takes."""
    name = node.func.id if isinstance(node.func, ast.Name) else ""
    if node.keywords or not _fits(name, len(node.args)):
        allowed = f"one of {', '.join(FUNCTIONS)} of one number, min or max of several, {_CHOICE}"
        raise FormulaError(f"the call {ast.unparse(node)[:40]!r}", allowed, "write it with these")
    conditions = node.args[:-1:2] if name in CHOICES else []
    for inner in node.args:
        (_check_condition if inner in conditions else _check)(inner, depth + 1)


def _fits(name: str, count: int) -> bool:
    """Whether a function may be called with so many arguments."""
    if name in CHOICES:
        return count == 3 or (name == "piecewise" and count >= 3 and count % 2 == 1)
    return count == 1 if name in FUNCTIONS else name in SEVERAL and count > 1


def _check_condition(node: ast.AST, depth: int) -> None:
    """Comparisons of numbers, and what is made of them."""
    if depth > MOST_DEPTH:
        raise FormulaError(f"more than {MOST_DEPTH} levels", "a shallow formula", "remove parentheses")
    match node:
        case ast.Compare(left=left, ops=ops, comparators=others) if all(type(op) in _COMPARED for op in ops):
            for inner in (left, *others):
                _check(inner, depth + 1)
        case ast.BoolOp(values=values):
            for inner in values:
                _check_condition(inner, depth + 1)
        case ast.UnaryOp(op=ast.Not(), operand=inner):
            _check_condition(inner, depth + 1)
        case _:
            expected = "a comparison by <, <=, > or >=, such as t < 1"
            raise FormulaError(f"the condition {ast.unparse(node)[:40]!r}", expected, "compare two numbers")


def _check_number(value: object) -> None:
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        raise FormulaError(repr(value)[:40], "a number", "write a number")
    if not abs(value) <= LARGEST_NUMBER:
        raise FormulaError("a number too large", f"a number up to {LARGEST_NUMBER:g}", "write a smaller one")


def _check_exponent(node: ast.expr) -> None:
    inner = node.operand if isinstance(node, ast.UnaryOp) else node
    if not isinstance(inner, ast.Constant) or not isinstance(inner.value, (int, float)):
        hint = "write exp(...) for a power that varies"
        raise FormulaError(f"the exponent {ast.unparse(node)[:40]!r}", "a number written out", hint)
    if not abs(inner.value) <= LARGEST_EXPONENT:
        raise FormulaError("an exponent too large", f"an exponent up to {LARGEST_EXPONENT}", "write a smaller one")


def _value(node: ast.expr, time: Array) -> Any:
    match node:
        case ast.Constant(value=value):
            return float(value)  # pyright: ignore[reportArgumentType]  # checked when it was read
        case ast.Name(id=name):
            return time if name == "t" else CONSTANTS[name]
        case ast.UnaryOp(op=op, operand=inner):
            return -_value(inner, time) if isinstance(op, ast.USub) else _value(inner, time)
        case ast.BinOp(left=left, op=op, right=right):
            return _PAIRS[type(op)](_value(left, time), _value(right, time))
        case ast.Call(func=ast.Name(id=name), args=args) if name in CHOICES:
            conditions, values = args[:-1:2], args[1::2]
            total = _value(args[-1], time)
            for condition, value in reversed([*zip(conditions, values, strict=True)]):
                total = np.where(_holds(condition, time), _value(value, time), total)
            return total
        case ast.Call(func=ast.Name(id=name), args=args):
            numbers = [np.broadcast_to(np.asarray(_value(inner, time), dtype=float), time.shape) for inner in args]
            return SEVERAL[name](np.stack(numbers)) if name in SEVERAL else FUNCTIONS[name](numbers[0])
    raise AssertionError(node)


def _holds(node: ast.expr, time: Array) -> Any:
    match node:
        case ast.Compare(left=left, ops=ops, comparators=others):
            values = [_value(inner, time) for inner in (left, *others)]
            compared = zip(ops, pairwise(values), strict=True)
            return np.logical_and.reduce([_COMPARED[type(op)](*pair) for op, pair in compared])
        case ast.BoolOp(op=op, values=several):
            both = [_holds(inner, time) for inner in several]
            return np.logical_and.reduce(both) if isinstance(op, ast.And) else np.logical_or.reduce(both)
        case ast.UnaryOp(operand=inner):
            return np.logical_not(_holds(inner, time))
    raise AssertionError(node)
