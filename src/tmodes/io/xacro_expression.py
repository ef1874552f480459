"""The formulas of a xacro file by a closed grammar: numbers, texts, names, arithmetic, comparisons, a few functions.

Text of the file has its ``${formula}``, ``$(arg name)`` and ``$(find package)`` replaced.
Nothing is handed to Python's own evaluation. The formula is parsed into a tree, every kind of node that is not listed
here is refused, and length, number of nodes and size of every number and text are bounded.
"""

from __future__ import annotations

import ast
import math
import operator
import re
import warnings
from collections import ChainMap
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

from tmodes.errors import InputError
from tmodes.io.units import INTEGER, finite_float
from tmodes.io.words import meant, nearest, shown
from tmodes.io.xml_file import LONGEST_ATTRIBUTE, Element

__all__ = ["Scope", "Value", "XacroFormulaError", "as_value", "evaluate", "filled", "is_true", "typed"]

Value = bool | int | float | str

LONGEST = 500
MOST_NODES = 150
LARGEST = 2**53
"""Largest magnitude of a whole number, the last that a double holds exactly; other numbers are doubles."""

NAMES: dict[str, Value] = {"pi": math.pi, "True": True, "False": False, "true": True, "false": False}
FUNCTIONS: dict[str, Callable[..., Any]] = {
    name: getattr(math, name)
    for name in ("sin", "cos", "tan", "asin", "acos", "atan", "atan2", "sqrt", "exp", "log", "hypot", "floor", "ceil")
} | {"radians": math.radians, "degrees": math.degrees, "abs": abs, "min": min, "max": max, "round": round}
UNARY: dict[type, Callable[[Any], Any]] = {ast.USub: operator.neg, ast.UAdd: operator.pos, ast.Not: operator.not_}
BINARY: dict[type, Callable[[Any, Any], Any]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.FloorDiv: operator.floordiv,
    ast.Mod: operator.mod,
}
COMPARE: dict[type, Callable[[Any, Any], Any]] = {
    ast.Eq: operator.eq,
    ast.NotEq: operator.ne,
    ast.Lt: operator.lt,
    ast.LtE: operator.le,
    ast.Gt: operator.gt,
    ast.GtE: operator.ge,
}


class XacroFormulaError(ValueError):
    """Why a formula has no value; its text is a phrase for a message."""


def evaluate(text: str, known: Mapping[str, Value]) -> Value:
    """The value of a formula with the names that are ``known``; raises :class:`XacroFormulaError`."""
    tree = _parsed(text)
    if sum(1 for _ in ast.walk(tree)) > MOST_NODES:
        raise XacroFormulaError(f"a formula of more than {MOST_NODES} parts")
    try:
        return _value(tree.body, known)
    except XacroFormulaError:
        raise
    except (ArithmeticError, TypeError, ValueError) as error:
        raise XacroFormulaError(f"{shown(text)}, which has no value ({error})") from None


def _parsed(text: str) -> ast.Expression:
    if len(text) > LONGEST:
        raise XacroFormulaError(f"a formula of {len(text)} characters")
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            return ast.parse(text.strip(), mode="eval")
    except (SyntaxError, ValueError, MemoryError, RecursionError):
        raise XacroFormulaError(f"{shown(text)}, which is no formula") from None


def _value(node: ast.expr, known: Mapping[str, Value]) -> Value:
    match node:
        case ast.Constant(value=bool() | int() | float() | str() as value):
            result = value
        case ast.Name(id=name):
            result = _named(name, known)
        case ast.UnaryOp(op=op, operand=operand) if type(op) in UNARY:
            result = UNARY[type(op)](_value(operand, known))
        case ast.BinOp(left=left, op=op, right=right):
            result = _combined(op, _value(left, known), _value(right, known))
        case ast.BoolOp(op=op, values=values):
            result = _any_or_all(op, values, known)
        case ast.Compare(left=left, ops=[op], comparators=[right]) if type(op) in COMPARE:
            result = COMPARE[type(op)](_value(left, known), _value(right, known))
        case ast.IfExp(test=test, body=body, orelse=orelse):
            result = _value(body if _value(test, known) else orelse, known)
        case ast.Call(func=ast.Name(id=name), args=arguments, keywords=[]) if name in FUNCTIONS:
            result = FUNCTIONS[name](*(_number(_value(argument, known)) for argument in arguments))
        case _:
            raise XacroFormulaError(f"{shown(ast.unparse(node))}, which is not arithmetic")
    return _bounded(result)


def _named(name: str, known: Mapping[str, Value]) -> Value:
    if name in known:
        return known[name]
    if name in NAMES:
        return NAMES[name]
    close = nearest(name, [*known, *NAMES])
    raise XacroFormulaError(f"the unknown name {shown(name)}" + (f" (did you mean {shown(close)}?)" if close else ""))


def _combined(op: ast.operator, left: Value, right: Value) -> Value:
    """Two numbers combined; of texts only the sum. A power is taken of doubles, so that it overflows at once."""
    if isinstance(left, str) and isinstance(right, str) and isinstance(op, ast.Add):
        return left + right
    left, right = _number(left), _number(right)
    if isinstance(op, ast.Pow):
        power = math.pow(left, right)
        both_whole = isinstance(left, int) and isinstance(right, int) and power.is_integer()
        return int(power) if both_whole and abs(power) <= LARGEST else power
    if type(op) not in BINARY:
        raise XacroFormulaError("an operator on bits or matrices, which is not arithmetic")
    return BINARY[type(op)](left, right)


def _any_or_all(op: ast.boolop, values: list[ast.expr], known: Mapping[str, Value]) -> Value:
    result: Value = isinstance(op, ast.And)
    for value in values:
        result = _value(value, known)
        if bool(result) is isinstance(op, ast.Or):
            break
    return result


def _number(value: Value) -> int | float:
    if isinstance(value, str):
        raise XacroFormulaError(f"the text {shown(value)} where a number belongs")
    return value


def _bounded(value: Value) -> Value:
    if isinstance(value, str) and len(value) > LONGEST:
        raise XacroFormulaError(f"a text of {len(value)} characters")
    if isinstance(value, int) and abs(value) > LARGEST:
        raise XacroFormulaError("a whole number of more than 15 digits")
    if isinstance(value, float) and not math.isfinite(value):
        raise XacroFormulaError("a result that no double can hold")
    return value


PART = re.compile(r"\$\$(?=[{(])|\$\{[^{}]*\}|\$\([^()]*\)")


@dataclass
class Scope:
    """Properties and blocks that are known at a place, those of the places around it too; the file's arguments."""

    arguments: dict[str, Value]
    values: ChainMap[str, Value] = field(default_factory=lambda: ChainMap({}))
    blocks: ChainMap[str, list[Element]] = field(default_factory=lambda: ChainMap({}))

    def inner(self) -> Scope:
        """A scope inside this one."""
        return Scope(self.arguments, self.values.new_child(), self.blocks.new_child())


def filled(text: str, element: Element, scope: Scope) -> str:
    """The text with each part replaced by its value; InputError at the element's place for what has none."""
    pieces = PART.split(text)
    values = [_part(part, element, scope) for part in PART.findall(text)]
    if stray := next((piece for piece in pieces if "${" in piece or "$(" in piece), None):
        raise _fault(element, f"the unfinished formula {shown(stray)}", "close its bracket")
    whole = "".join(
        f"{piece}{str(value).lower() if isinstance(value, bool) else value}"
        for piece, value in zip(pieces, [*values, ""], strict=True)
    )
    if len(whole) > LONGEST_ATTRIBUTE:
        raise _fault(element, f"a text of {len(whole)} characters", "shorten it")
    return whole


def typed(text: str, element: Element, scope: Scope) -> Value:
    """As :func:`filled`, but a number or truth value stays one."""
    if len(PART.findall(text)) == 1 and PART.fullmatch(text.strip()):
        return as_value(_part(text.strip(), element, scope))
    return as_value(filled(text, element, scope))


def as_value(value: Value) -> Value:
    """A text that is a number or a truth value, as such."""
    if not isinstance(value, str):
        return value
    text = value.strip()
    if text in {"true", "True", "false", "False"}:
        return text in {"true", "True"}
    if INTEGER.fullmatch(text) and len(text) <= 15:
        return int(text)
    number = finite_float(text)
    return value if number is None else number


def is_true(text: str, element: Element, scope: Scope) -> bool:
    """Whether the condition of ``xacro:if`` holds: a truth value or a number."""
    value = typed(text, element, scope)
    if isinstance(value, str):
        raise _fault(element, f"the condition {shown(value)}", "write true, false, or a formula such as ${a == 1}")
    return bool(value)


def _part(part: str, element: Element, scope: Scope) -> Value:
    if part == "$$":
        return "$"
    if part.startswith("${"):
        try:
            return evaluate(part[2:-1], scope.values)
        except XacroFormulaError as error:
            hint = "write numbers, properties, + - * / ** and functions such as sin, sqrt, radians"
            raise _fault(element, str(error), hint) from None
    command, _, name = part[2:-1].strip().partition(" ")
    name = name.strip()
    if command == "find" and name:
        return f"package://{name}"
    if command != "arg":
        raise _fault(element, f"the command {shown(part)}", "write the value, or use $(arg name) or $(find package)")
    if name not in scope.arguments:
        hint = meant(name, scope.arguments, "give the xacro:arg a default")
        raise _fault(element, f"the argument {shown(name)}, which has no value", hint)
    return scope.arguments[name]


def _fault(element: Element, got: str, hint: str) -> InputError:
    return element.wrong(got, "text with ${formula} or $(arg name)", hint)
