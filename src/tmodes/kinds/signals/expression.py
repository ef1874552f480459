"""A formula of time: a closed grammar, read into steps of arithmetic. Nothing is ever executed as code.

Numbers, ``t`` [s], ``pi``, + - * / and **, parentheses, and the functions of one number in :data:`FUNCTIONS`. The
exponent of a power is a number written out, so that no tower of powers can be built.
"""

from __future__ import annotations

import ast
import math
import re
import warnings
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray
from pydantic import Field

from tmodes.kinds.schema.quantity import Issue
from tmodes.kinds.signals.contract import SIGNALS, Signal
from tmodes.kinds.signals.fit import fitted
from tmodes.kinds.signals.schedule import Schedule

__all__ = ["FUNCTIONS", "Expression", "Formula", "FormulaError", "parse_formula"]

Array = NDArray[np.float64]

LONGEST = 500
MOST_NODES = 200
MOST_DEPTH = 30
LARGEST_EXPONENT = 20
LARGEST_NUMBER = 1e12

LETTERS = re.compile(r"[0-9A-Za-z_.+\-*/() ]*")

FUNCTIONS: dict[str, Callable[[Array], Array]] = {
    name: getattr(np, name) for name in ("sin", "cos", "tan", "exp", "log", "sqrt", "tanh", "sinh", "cosh", "abs")
} | {"atan": np.arctan, "asin": np.arcsin, "acos": np.arccos}
"""What a formula may call."""

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


def parse_formula(text: str) -> Formula:
    """The formula of a text; raises :class:`FormulaError` for anything outside of the grammar."""
    if len(text) > LONGEST:
        raise FormulaError(f"a formula of {len(text)} characters", f"at most {LONGEST}", "write a table instead")
    if not LETTERS.fullmatch(text):
        letter = next(letter for letter in text if not LETTERS.fullmatch(letter))
        hint = "write ** for a power" if letter == "^" else "write a decimal point" if letter == "," else "remove it"
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
        case ast.Call(func=ast.Name(id=name), args=[inner], keywords=[]) if name in FUNCTIONS:
            _check(inner, depth + 1)
        case ast.Call():
            allowed = f"one of {', '.join(FUNCTIONS)} of one number"
            raise FormulaError(f"the call {ast.unparse(node)[:40]!r}", allowed, "write it with these")
        case _:
            got = f"{ast.unparse(node)[:40]!r}, which is no arithmetic"
            raise FormulaError(got, "numbers, t, pi, + - * / **, functions", "write it with these")


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
        case ast.Call(func=ast.Name(id=name), args=[inner]):
            return FUNCTIONS[name](np.asarray(_value(inner, time), dtype=float))
    raise AssertionError(node)


@SIGNALS.register
class Expression(Signal):
    """A formula of the time t [s], such as ``0.2*sin(2*pi*t)*exp(-t)``."""

    type: Literal["expression"] = Field(description="kind of signal")
    formula: str = Field(min_length=1, max_length=500, description="formula of t")

    def _issues(self) -> Iterator[Issue]:
        try:
            parse_formula(self.formula)
        except FormulaError as error:
            yield Issue("formula", error.got, error.expected, error.hint)

    def schedule(self, until: float) -> Schedule:
        """Pieces of degree 7, exact to 1e-12 of the largest value, up to ``until`` [s].

        Raises :class:`tmodes.errors.InputError` where the formula has no value or jumps.
        """
        return fitted(parse_formula(self.formula), until, "formula")
