"""Text of a xacro file with its ``${formula}``, ``$(arg name)`` and ``$(find package)`` replaced; its macros."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass

from tmodes.errors import InputError
from tmodes.io.scalars import INTEGER, finite_float
from tmodes.io.words import meant, shown
from tmodes.io.xacro_expression import FormulaError, Value, evaluate
from tmodes.io.xml_file import LONGEST_ATTRIBUTE, Element

__all__ = ["Macro", "as_value", "filled", "is_true", "macro_of", "typed", "xacro_fault"]

PARAMETER = re.compile(r"""(\*{0,2})([A-Za-z_]\w*)(?::?=(\^\|?)?('[^']*'|"[^"]*"|\S*))?(?:\s+|$)""")
MOST_PARAMETERS = 100


def xacro_fault(element: Element, got: str, expected: str, hint: str) -> InputError:
    """The error of an element of a xacro, with its place."""
    return InputError(f"<{element.tag[:60]}>", got, expected, hint, element.place)


@dataclass(frozen=True)
class _Parameter:
    """One parameter: ``stars`` for a block; ``default`` text, None where it must be given; ``outer``: see around."""

    name: str
    stars: int
    default: str | None
    outer: bool


@dataclass(frozen=True, eq=False)
class Macro:
    """A macro's element and what it takes."""

    element: Element
    parameters: tuple[_Parameter, ...]

    def fill(self, call: Element, given: Mapping[str, Value], around: Mapping[str, Value]) -> dict[str, str]:
        """Default texts of the parameters that a call leaves out; InputError for unknown and missing ones."""
        names = {parameter.name: parameter for parameter in self.parameters if not parameter.stars}
        for name in given:
            if name not in names:
                hint = meant(name, names, "remove it, or add it to the macro's params")
                got, expected = (
                    f"the unknown parameter {shown(name)}",
                    f"called with parameters of {', '.join(names) or 'none'}",
                )
                raise xacro_fault(call, got, expected, hint)
        left_out = [parameter for name, parameter in names.items() if name not in given]
        left_out = [parameter for parameter in left_out if not (parameter.outer and parameter.name in around)]
        if missing := [parameter.name for parameter in left_out if parameter.default is None]:
            hint = f'write {missing[0]}="..."'
            raise xacro_fault(
                call, f"no value for {', '.join(missing)}", "called with every parameter without a default", hint
            )
        return {parameter.name: parameter.default for parameter in left_out if parameter.default is not None}

    def blocks(self, call: Element, children: list[Element]) -> dict[str, list[Element]]:
        """The elements of each block: for ``*name`` the call's next child, for ``**name`` what is inside it."""
        wanted = [parameter for parameter in self.parameters if parameter.stars]
        if len(wanted) != len(children):
            names = ", ".join(parameter.name for parameter in wanted) or "none"
            got, expected = (
                f"{len(children)} elements inside",
                f"called with {len(wanted)} elements, one for each block ({names})",
            )
            raise xacro_fault(call, got, expected, "add or remove elements inside the call")
        pairs = zip(wanted, children, strict=True)
        return {parameter.name: [child] if parameter.stars == 1 else child.children for parameter, child in pairs}


def macro_of(element: Element) -> Macro:
    """The macro that an element defines; InputError for a list of parameters that is none."""
    text = element.attributes.get("params", "").strip()
    parameters: list[_Parameter] = []
    position = 0
    while position < len(text):
        match = PARAMETER.match(text, position)
        if match is None or len(parameters) >= MOST_PARAMETERS or match.end() == position:
            hint = "write them as: name other:=1.0 *block"
            raise xacro_fault(
                element,
                f"the parameters {shown(text[position:])}",
                "a macro with names and spaces between as parameters",
                hint,
            )
        parameters.append(_parameter(match))
        position = match.end()
    return Macro(element, tuple(parameters))


def _parameter(match: re.Match[str]) -> _Parameter:
    stars, name, outer, default = match.groups()
    if outer == "^":
        default = None
    elif default is not None and default[:1] in {"'", '"'}:
        default = default[1:-1]
    return _Parameter(name, len(stars), default, outer is not None)


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
        hint = meant(name, arguments, "give the xacro:arg a default")
        raise _fault(element, f"the argument {shown(name)}, which has no value", hint)
    return arguments[name]


def _written(value: Value) -> str:
    return ("true" if value else "false") if isinstance(value, bool) else str(value)


def _fault(element: Element, got: str, hint: str) -> InputError:
    expected = "text with ${formula} or $(arg name)"
    return InputError(f"<{element.tag[:60]}>", got, expected, hint, element.place)
