"""Text of a xacro file with its ``${formula}``, ``$(arg name)`` and ``$(find package)`` replaced."""

from __future__ import annotations

import re
from collections.abc import Mapping

from tmodes.errors import InputError
from tmodes.io.scalars import INTEGER, finite_float
from tmodes.io.words import nearest, shown
from tmodes.io.xacro_expression import FormulaError, Value, evaluate
from tmodes.io.xml_file import LONGEST_ATTRIBUTE, Element

__all__ = ["as_value", "filled", "is_true", "typed"]

PART = re.compile(r"\$\$(?=[{(])|\$\{[^{}]*\}|\$\([^()]*\)")


def filled(text: str, element: Element, known: Mapping[str, Value], arguments: Mapping[str, Value]) -> str:
    """The text with each part replaced by its value; InputError at the element's place for what has none."""
    pieces = PART.split(text)
    values = [_part(part, element, known, arguments) for part in PART.findall(text)]
    if stray := next((piece for piece in pieces if "${" in piece or "$(" in piece), None):
        raise _fault(element, f"the unfinished formula {shown(stray)}", "close its bracket")
    whole = "".join(f"{piece}{_written(value)}" for piece, value in zip(pieces, [*values, ""], strict=True))
    if len(whole) > LONGEST_ATTRIBUTE:
        raise _fault(element, f"a text of {len(whole)} characters", "shorten it")
    return whole


def typed(text: str, element: Element, known: Mapping[str, Value], arguments: Mapping[str, Value]) -> Value:
    """As :func:`filled`, but a number or truth value stays one."""
    if len(PART.findall(text)) == 1 and PART.fullmatch(text.strip()):
        return as_value(_part(text.strip(), element, known, arguments))
    return as_value(filled(text, element, known, arguments))


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


def is_true(text: str, element: Element, known: Mapping[str, Value], arguments: Mapping[str, Value]) -> bool:
    """Whether the condition of ``xacro:if`` holds: a truth value or a number."""
    value = typed(text, element, known, arguments)
    if isinstance(value, str):
        raise _fault(element, f"the condition {shown(value)}", "write true, false, or a formula such as ${a == 1}")
    return bool(value)


def _part(part: str, element: Element, known: Mapping[str, Value], arguments: Mapping[str, Value]) -> Value:
    if part == "$$":
        return "$"
    if part.startswith("${"):
        try:
            return evaluate(part[2:-1], known)
        except FormulaError as error:
            hint = "write numbers, properties, + - * / ** and functions such as sin, sqrt, radians"
            raise _fault(element, str(error), hint) from None
    command, _, name = part[2:-1].strip().partition(" ")
    name = name.strip()
    if command == "find" and name:
        return f"package://{name}"
    if command != "arg":
        raise _fault(element, f"the command {shown(part)}", "write the value, or use $(arg name) or $(find package)")
    if name not in arguments:
        close = nearest(name, arguments)
        hint = f"did you mean {shown(close)}?" if close else "give the xacro:arg a default"
        raise _fault(element, f"the argument {shown(name)}, which has no value", hint)
    return arguments[name]


def _written(value: Value) -> str:
    return ("true" if value else "false") if isinstance(value, bool) else str(value)


def _fault(element: Element, got: str, hint: str) -> InputError:
    expected = "text with ${formula} or $(arg name)"
    return InputError(f"<{element.tag[:60]}>", got, expected, hint, element.place)
