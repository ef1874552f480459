"""The grammar of a formula: what may stand in one. Nothing is ever executed as code.

Numbers, the given names, ``pi``, + - * / and **, parentheses, the functions of one number in :data:`FUNCTIONS`, ``min``
and ``max`` of several, ``where(condition, value, otherwise)`` and ``piecewise(condition, value, condition, value, ...,
otherwise)``, which takes the value of the first condition that holds. A condition compares numbers by < <= > >=, with
``and``, ``or``, ``not``. The exponent of a power is a number written out, so that no tower of powers can be built.
"""

from __future__ import annotations

import ast
import math
import re
import warnings
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from difflib import get_close_matches
from typing import Any

import numpy as np
from numpy.typing import NDArray

__all__ = [
    "CHOICES",
    "COMPARED",
    "CONSTANTS",
    "FUNCTIONS",
    "PAIRS",
    "SEVERAL",
    "TIME",
    "FormulaError",
    "checked_tree",
    "names_in",
]

Array = NDArray[np.float64]

TIME = ("t",)
"""The name in a formula of time [s]."""

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

COMPARED: dict[type[ast.cmpop], Callable[[Any, Any], Any]] = {
    ast.Lt: np.less,
    ast.LtE: np.less_equal,
    ast.Gt: np.greater,
    ast.GtE: np.greater_equal,
}

CONSTANTS = {"pi": math.pi}

PAIRS: dict[type[ast.operator], Callable[[Any, Any], Any]] = {
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


def checked_tree(text: str, names: Sequence[str]) -> ast.expr:
    """The syntax tree of a formula of these names; raises :class:`FormulaError` for what is outside of the grammar."""
    if len(text) > LONGEST:
        raise FormulaError(f"a formula of {len(text)} characters", f"at most {LONGEST}", "write a table instead")
    if not LETTERS.fullmatch(text):
        letter = next(letter for letter in text if not LETTERS.fullmatch(letter))
        hint = "write ** for a power" if letter == "^" else "remove it"
        raise FormulaError(f"the character {letter!a}", _arithmetic(names), hint)
    tree = _tree(text, names)
    nodes = sum(1 for _ in ast.walk(tree))
    if nodes > MOST_NODES:
        raise FormulaError(f"a formula of {nodes} parts", f"at most {MOST_NODES}", "write a table instead")
    _check(tree, 0, names)
    return tree


def _tree(text: str, names: Sequence[str]) -> ast.expr:
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # the parser's advice on Python code is none on formulas
            return ast.parse(text.strip(), mode="eval").body
    except (SyntaxError, ValueError, MemoryError, RecursionError):
        hint = "look for a missing parenthesis or operator: 2*t, not 2t"
        raise FormulaError(
            f"the text {text[:60]!r}",
            f"a formula of {_listed(names)}, such as 0.5*sin(2*pi*{names[0] if names else 'x'})",
            hint,
        ) from None


def _check(node: ast.AST, depth: int, names: Sequence[str]) -> None:
    """Refuse every node that is not of the grammar."""
    if depth > MOST_DEPTH:
        raise FormulaError(f"more than {MOST_DEPTH} levels", "a shallow formula", "remove parentheses")
    match node:
        case ast.Constant(value=value):
            _check_number(value)
        case ast.Name(id=name):
            if name not in names and name not in CONSTANTS:
                raise FormulaError(
                    f"the name {name[:40]!r}", f"{_listed(names)} or {', '.join(CONSTANTS)}", _meant(name, names)
                )
        case ast.UnaryOp(op=ast.UAdd() | ast.USub(), operand=inner):
            _check(inner, depth + 1, names)
        case ast.BinOp(left=left, op=op, right=right) if type(op) in PAIRS:
            if isinstance(op, ast.Pow):
                _check_exponent(right)
            _check(left, depth + 1, names)
            _check(right, depth + 1, names)
        case ast.Call():
            _check_call(node, depth, names)
        case ast.Compare() | ast.BoolOp():
            got = f"the condition {ast.unparse(node)[:40]!r} as a number"
            raise FormulaError(got, "a condition in where or piecewise", f"write {_choice(names)}")
        case _:
            got = f"{ast.unparse(node)[:40]!r}, which is no arithmetic"
            raise FormulaError(got, _arithmetic(names), "write it with these")


def _choice(names: Sequence[str]) -> str:
    return f"where({names[0] if names else 1} < 1, value, otherwise)"


def _check_call(node: ast.Call, depth: int, names: Sequence[str]) -> None:
    """A known function, with as many arguments as it takes."""
    name = node.func.id if isinstance(node.func, ast.Name) else ""
    if node.keywords or not _fits(name, len(node.args)):
        allowed = f"one of {', '.join(FUNCTIONS)} of one number, min or max of several, {_choice(names)}"
        raise FormulaError(f"the call {ast.unparse(node)[:40]!r}", allowed, "write it with these")
    conditions = node.args[:-1:2] if name in CHOICES else []
    for inner in node.args:
        (_check_condition if inner in conditions else _check)(inner, depth + 1, names)


def _fits(name: str, count: int) -> bool:
    """Whether a function may be called with so many arguments."""
    if name in CHOICES:
        return count == 3 or (name == "piecewise" and count >= 3 and count % 2 == 1)
    return count == 1 if name in FUNCTIONS else name in SEVERAL and count > 1


def _check_condition(node: ast.AST, depth: int, names: Sequence[str]) -> None:
    """Comparisons of numbers, and what is made of them."""
    if depth > MOST_DEPTH:
        raise FormulaError(f"more than {MOST_DEPTH} levels", "a shallow formula", "remove parentheses")
    match node:
        case ast.Compare(left=left, ops=ops, comparators=others) if all(type(op) in COMPARED for op in ops):
            for inner in (left, *others):
                _check(inner, depth + 1, names)
        case ast.BoolOp(values=values):
            for inner in values:
                _check_condition(inner, depth + 1, names)
        case ast.UnaryOp(op=ast.Not(), operand=inner):
            _check_condition(inner, depth + 1, names)
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


_LISTED = 12
"""Names that a message lists."""


def _listed(names: Sequence[str]) -> str:
    return ", ".join(names[:_LISTED]) + (", ..." if len(names) > _LISTED else "") or "numbers"


def _arithmetic(names: Sequence[str]) -> str:
    return f"numbers, {_listed(names)}, pi, + - * / **, functions"


def _meant(name: str, names: Sequence[str]) -> str:
    """How to correct a name that a formula may not use."""
    if name in FUNCTIONS:
        return f"write {name}(...)"
    if tuple(names) == TIME:
        return "the time is called t"
    close = get_close_matches(name, names, n=1)
    return f"did you mean `{close[0]}`?" if close else "write one of these names"


def names_in(text: str) -> tuple[str, ...]:
    """All names of a formula that stand for numbers, each once; none of a text that is no formula."""
    if len(text) > LONGEST or not LETTERS.fullmatch(text):
        return ()
    try:
        nodes = [*ast.walk(_tree(text, ()))]
    except FormulaError:
        return ()
    called = {id(node.func) for node in nodes if isinstance(node, ast.Call)}
    used = [node.id for node in nodes if isinstance(node, ast.Name) and id(node) not in called]
    return tuple(dict.fromkeys(name for name in used if name not in CONSTANTS))
