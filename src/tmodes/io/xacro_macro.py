"""A macro of a xacro file: which parameters and blocks it takes."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass

from tmodes.errors import InputError
from tmodes.io.words import nearest, shown
from tmodes.io.xacro_expression import Value
from tmodes.io.xml_file import Element

__all__ = ["Macro", "macro_of", "xacro_fault"]

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
                close = nearest(name, names)
                hint = f"did you mean {shown(close)}?" if close else "remove it, or add it to the macro's params"
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
