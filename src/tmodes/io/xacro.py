"""Read a xacro file: a safe part of the language that writes URDFs.

Properties, arguments, macros with blocks, if/unless, include inside the robot's folders, and ``${formula}`` by a closed
grammar. All else (Python in formulas, YAML, environment, scopes, namespaces) is refused with its line. Steps, depth
and sizes are bounded. Language: http://wiki.ros.org/xacro.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from tmodes.errors import InputError
from tmodes.io.files import FilePath, Folders, Roots, folders_of
from tmodes.io.urdf import UrdfRobot, urdf_robot
from tmodes.io.words import meant, nearest, shown
from tmodes.io.xacro_expression import Scope, Value, as_value, filled, is_true, typed
from tmodes.io.xml_file import MOST_ELEMENTS, Element, read_xml

__all__ = ["expand_xacro", "read_xacro"]

PREFIX = "xacro:"
MOST_DEPTH = 60
MOST_FILES = 100
PARAMETER = re.compile(r"""(\*{0,2})([A-Za-z_]\w*)(?::?=(\^\|?)?('[^']*'|"[^"]*"|\S*))?(?:\s+|$)""")
MOST_PARAMETERS = 100


def read_xacro(
    path: FilePath,
    roots: Roots = (),
    trust_paths: bool = False,
    weighed: Collection[str] = (),
    fix_inertia: bool = False,
    arguments: Mapping[str, Value] | None = None,
) -> UrdfRobot:
    """The robot of a xacro file; ``arguments`` are values of its ``xacro:arg``. Else as ``read_urdf``."""
    folders = folders_of(path, roots, trust_paths)
    root = expand_xacro(read_xml(path), folders, arguments or {})
    return urdf_robot(root, folders, weighed, fix_inertia=fix_inertia)


def expand_xacro(robot: Element, folders: Folders, arguments: Mapping[str, Value]) -> Element:
    """The plain elements that a xacro's root stands for, with their lines; InputError for what is not read here."""
    given = {name: as_value(value) for name, value in arguments.items()}
    inside = _Expansion(folders).inside(robot, Scope(given), 0)
    return Element(robot.tag, dict(robot.attributes), robot.source, robot.line, inside)


class _Expansion:
    """What is known in the whole file: its macros, and how much has been done."""

    def __init__(self, folders: Folders) -> None:
        self.folders = folders
        self.macros: dict[str, Macro] = {}
        self.steps = 0
        self.files = 0
        self.commands = {
            "property": self._property,
            "arg": self._argument,
            "macro": self._macro,
            "include": self._include,
            "insert_block": self._insert,
            "if": self._condition,
            "unless": self._condition,
        }

    def inside(self, element: Element, scope: Scope, depth: int) -> list[Element]:
        """What the children of an element stand for."""
        return [made for child in element.children for made in self.expand(child, scope, depth)]

    def expand(self, element: Element, scope: Scope, depth: int) -> list[Element]:
        """What one element stands for: itself with its formulas replaced, or what its command makes."""
        self.steps += 1
        if self.steps > MOST_ELEMENTS or depth > MOST_DEPTH:
            got = f"more than {MOST_ELEMENTS} elements" if depth <= MOST_DEPTH else f"more than {MOST_DEPTH} levels"
            raise element.wrong(got, "a robot of bounded size", "look for a macro that calls itself")
        if element.tag in self.commands:
            tag = f"<{PREFIX}{element.tag}>"
            raise element.wrong(f"<{element.tag}> without its prefix", tag, f"write {tag}")
        if not element.tag.startswith(PREFIX):
            return [self._plain(element, scope, depth)]
        command = self.commands.get(element.tag.removeprefix(PREFIX), self._call)
        return command(element, scope, depth + 1)

    def _plain(self, element: Element, scope: Scope, depth: int) -> Element:
        attributes = {name: self._text(element, text, scope) for name, text in element.attributes.items()}
        made = Element(element.tag, attributes, element.source, element.line, self.inside(element, scope, depth + 1))
        with suppress(InputError):  # formulas in the texts of other programs may be of no kind that is read here
            made.texts.append(self._text(element, element.content, scope))
        return made

    def _text(self, element: Element, text: str, scope: Scope) -> str:
        return filled(text, element, scope) if "$" in text else text

    def _property(self, element: Element, scope: Scope, _: int) -> list[Element]:
        name = _needed(element, "name")
        _refuse_others(element, {"name", "value", "default"})
        if "value" in element.attributes:
            scope.values[name] = typed(element.attributes["value"], element, scope)
        elif "default" in element.attributes:
            default = element.attributes["default"]
            scope.values.setdefault(name, typed(default, element, scope))
        else:
            scope.blocks[name] = element.children
        return []

    def _argument(self, element: Element, scope: Scope, _: int) -> list[Element]:
        _refuse_others(element, {"name", "default"})
        if "default" in element.attributes:
            default = typed(element.attributes["default"], element, scope)
            scope.arguments.setdefault(_needed(element, "name"), default)
        return []

    def _macro(self, element: Element, *_: Any) -> list[Element]:
        _refuse_others(element, {"name", "params"})
        name = _needed(element, "name").removeprefix(PREFIX)
        if name in self.commands:
            raise element.wrong(f"a macro called {shown(name)}", "another name", "rename the macro")
        self.macros[name] = macro_of(element)
        return []

    def _include(self, element: Element, scope: Scope, depth: int) -> list[Element]:
        _refuse_others(element, {"filename"})
        name = self._text(element, _needed(element, "filename"), scope)
        path = self.folders.find(name, "xacro:include", element.place, Path(element.source).absolute().parent)
        self.files += 1
        if path is None or self.files > MOST_FILES:
            got = f"{shown(name)}, which is not there" if path is None else f"more than {MOST_FILES} includes"
            raise element.wrong(got, "a file", "check the path, or list its package's folder among the roots")
        return self.inside(read_xml(path), scope, depth)

    def _insert(self, element: Element, scope: Scope, depth: int) -> list[Element]:
        name = self._text(element, _needed(element, "name"), scope)
        if name not in scope.blocks:
            hint = meant(name, scope.blocks, "declare it in the macro's params as *name")
            raise element.wrong(f"the unknown block {shown(name)}", "a block", hint)
        return [made for child in scope.blocks[name] for made in self.expand(child, scope, depth)]

    def _condition(self, element: Element, scope: Scope, depth: int) -> list[Element]:
        _refuse_others(element, {"value"})
        holds = is_true(_needed(element, "value"), element, scope)
        return self.inside(element, scope, depth) if holds is (element.tag == f"{PREFIX}if") else []

    def _call(self, element: Element, scope: Scope, depth: int) -> list[Element]:
        """A macro's body in a scope of its own: its parameters and blocks, over what is known around the call."""
        name = element.tag.removeprefix(PREFIX)
        if name not in self.macros:
            close = nearest(name, [*self.macros, *self.commands])
            hint = f"did you mean <{PREFIX}{close}>?" if close else "define the macro above, or write it out"
            expected = "a macro, or property, arg, macro, include, if, unless, insert_block"
            raise element.wrong(element.label, expected, hint)
        macro, inner = self.macros[name], scope.inner()
        given = {key: typed(text, element, scope) for key, text in element.attributes.items()}
        defaults = macro.fill(element, given, scope.values)
        for key, text in defaults.items():
            inner.values[key] = typed(text, element, inner)
        inner.values.update(given)
        inner.blocks.update(macro.blocks(element, self.inside(element, scope, depth)))
        return self.inside(macro.element, inner, depth)


def _needed(element: Element, name: str) -> str:
    text = element.attributes.get(name, "").strip()
    if not text:
        raise element.wrong(f"no attribute `{name}`", f'an element with {name}="..."', f'write {name}="..."')
    return text


def _refuse_others(element: Element, known: set[str]) -> None:
    if others := sorted(element.attributes.keys() - known):
        expected = f"an element with no attribute but {', '.join(sorted(known))}"
        raise element.wrong(f"the attribute {shown(others[0])}", expected, "write it without, or expand it with ROS")


@dataclass(frozen=True)
class _MacroParameter:
    """One parameter: ``stars`` for a block; ``default`` text, None where it must be given; ``outer``: see around."""

    name: str
    stars: int
    default: str | None
    outer: bool


@dataclass(frozen=True, eq=False)
class Macro:
    """A macro's element and what it takes."""

    element: Element
    parameters: tuple[_MacroParameter, ...]

    def fill(self, call: Element, given: Mapping[str, Value], around: Mapping[str, Value]) -> dict[str, str]:
        """Default texts of the parameters that a call leaves out; InputError for unknown and missing ones."""
        names = {parameter.name: parameter for parameter in self.parameters if not parameter.stars}
        for name in given:
            if name not in names:
                hint = meant(name, names, "remove it, or add it to the macro's params")
                expected = f"called with parameters of {', '.join(names) or 'none'}"
                raise call.wrong(f"the unknown parameter {shown(name)}", expected, hint)
        left_out = [parameter for name, parameter in names.items() if name not in given]
        left_out = [parameter for parameter in left_out if not (parameter.outer and parameter.name in around)]
        if missing := [parameter.name for parameter in left_out if parameter.default is None]:
            got, expected = f"no value for {', '.join(missing)}", "called with every parameter without a default"
            raise call.wrong(got, expected, f'write {missing[0]}="..."')
        return {parameter.name: parameter.default for parameter in left_out if parameter.default is not None}

    def blocks(self, call: Element, children: list[Element]) -> dict[str, list[Element]]:
        """The elements of each block: for ``*name`` the call's next child, for ``**name`` what is inside it."""
        wanted = [parameter for parameter in self.parameters if parameter.stars]
        if len(wanted) != len(children):
            names = ", ".join(parameter.name for parameter in wanted) or "none"
            expected = f"called with {len(wanted)} elements, one for each block ({names})"
            raise call.wrong(f"{len(children)} elements inside", expected, "add or remove elements inside the call")
        pairs = zip(wanted, children, strict=True)
        return {parameter.name: [child] if parameter.stars == 1 else child.children for parameter, child in pairs}


def macro_of(element: Element) -> Macro:
    """The macro that an element defines; InputError for a list of parameters that is none."""
    text = element.attributes.get("params", "").strip()
    parameters: list[_MacroParameter] = []
    position = 0
    while position < len(text):
        match = PARAMETER.match(text, position)
        if match is None or len(parameters) >= MOST_PARAMETERS or match.end() == position:
            got, expected = (
                f"the parameters {shown(text[position:])}",
                "a macro with names and spaces between as parameters",
            )
            raise element.wrong(got, expected, "write them as: name other:=1.0 *block")
        parameters.append(_parameter(match))
        position = match.end()
    return Macro(element, tuple(parameters))


def _parameter(match: re.Match[str]) -> _MacroParameter:
    stars, name, outer, default = match.groups()
    if outer == "^":
        default = None
    elif default is not None and default[:1] in {"'", '"'}:
        default = default[1:-1]
    return _MacroParameter(name, len(stars), default, outer is not None)
