"""Read a xacro file: a safe part of the language that writes URDFs.

Properties, arguments, macros with blocks, if/unless, include inside the robot's folders, and ``${formula}`` by a closed
grammar. All else (Python in formulas, YAML, environment, scopes, namespaces) is refused with its line. Steps, depth
and sizes are bounded. Language: http://wiki.ros.org/xacro.
"""

from __future__ import annotations

import os
from collections import ChainMap
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from tmodes.io.mesh_paths import Folders, folders_of
from tmodes.io.urdf import UrdfRobot, urdf_robot
from tmodes.io.words import meant, nearest, shown
from tmodes.io.xacro_expression import Value
from tmodes.io.xacro_text import Macro, as_value, filled, is_true, macro_of, typed, xacro_fault
from tmodes.io.xml_file import MOST_ELEMENTS, Element, read_xml

__all__ = ["expand_xacro", "read_xacro"]

PREFIX = "xacro:"
MOST_DEPTH = 60
MOST_FILES = 100


def read_xacro(
    path: str | os.PathLike[str],
    roots: Sequence[str | os.PathLike[str]] = (),
    trust_paths: bool = False,
    weighed: Collection[str] = (),
    arguments: Mapping[str, Value] | None = None,
) -> UrdfRobot:
    """The robot of a xacro file; ``arguments`` are values of its ``xacro:arg``. Else as ``read_urdf``."""
    folders = folders_of(path, roots, trust_paths)
    return urdf_robot(expand_xacro(read_xml(path), folders, arguments or {}), folders, weighed)


def expand_xacro(robot: Element, folders: Folders, arguments: Mapping[str, Value]) -> Element:
    """The plain elements that a xacro's root element stands for, each with the line it comes from.

    Raises :class:`tmodes.errors.InputError` for what is wrong or no part of the language that is read here.
    """
    given = {name: as_value(value) for name, value in arguments.items()}
    expansion = _Expansion(folders, given)
    return Element(robot.tag, dict(robot.attributes), robot.source, robot.line, expansion.inside(robot, _Scope(), 0))


@dataclass
class _Scope:
    """Properties and blocks that are known at a place; those of the places around it are seen through."""

    values: ChainMap[str, Value] = field(default_factory=lambda: ChainMap({}))
    blocks: ChainMap[str, list[Element]] = field(default_factory=lambda: ChainMap({}))

    def inner(self) -> _Scope:
        return _Scope(self.values.new_child(), self.blocks.new_child())


class _Expansion:
    """What is known in the whole file: macros, arguments, and how much has been done."""

    def __init__(self, folders: Folders, arguments: dict[str, Value]) -> None:
        self.folders = folders
        self.arguments = arguments
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

    def inside(self, element: Element, scope: _Scope, depth: int) -> list[Element]:
        """What the children of an element stand for."""
        return [made for child in element.children for made in self.expand(child, scope, depth)]

    def expand(self, element: Element, scope: _Scope, depth: int) -> list[Element]:
        """What one element stands for: itself with its formulas replaced, or what its command makes."""
        self.steps += 1
        if self.steps > MOST_ELEMENTS or depth > MOST_DEPTH:
            got = f"more than {MOST_ELEMENTS} elements" if depth <= MOST_DEPTH else f"more than {MOST_DEPTH} levels"
            raise xacro_fault(element, got, "a robot of bounded size", "look for a macro that calls itself")
        if element.tag in self.commands:
            tag = f"<{PREFIX}{element.tag}>"
            raise xacro_fault(element, f"<{element.tag}> without its prefix", tag, f"write {tag}")
        if not element.tag.startswith(PREFIX):
            return [self._plain(element, scope, depth)]
        name = element.tag.removeprefix(PREFIX)
        command = self.commands.get(name, self._call)
        return command(element, scope, depth + 1)

    def _plain(self, element: Element, scope: _Scope, depth: int) -> Element:
        attributes = {name: self._text(element, text, scope) for name, text in element.attributes.items()}
        return Element(element.tag, attributes, element.source, element.line, self.inside(element, scope, depth + 1))

    def _text(self, element: Element, text: str, scope: _Scope) -> str:
        return filled(text, element, scope.values, self.arguments) if "$" in text else text

    def _property(self, element: Element, scope: _Scope, _: int) -> list[Element]:
        name = _needed(element, "name")
        _refuse_others(element, {"name", "value", "default"})
        if "value" in element.attributes:
            scope.values[name] = typed(element.attributes["value"], element, scope.values, self.arguments)
        elif "default" in element.attributes:
            default = element.attributes["default"]
            scope.values.setdefault(name, typed(default, element, scope.values, self.arguments))
        else:
            scope.blocks[name] = element.children
        return []

    def _argument(self, element: Element, scope: _Scope, _: int) -> list[Element]:
        _refuse_others(element, {"name", "default"})
        if "default" in element.attributes:
            default = typed(element.attributes["default"], element, scope.values, self.arguments)
            self.arguments.setdefault(_needed(element, "name"), default)
        return []

    def _macro(self, element: Element, *_: Any) -> list[Element]:
        _refuse_others(element, {"name", "params"})
        name = _needed(element, "name").removeprefix(PREFIX)
        if name in self.commands:
            raise xacro_fault(element, f"a macro called {shown(name)}", "another name", "rename the macro")
        self.macros[name] = macro_of(element)
        return []

    def _include(self, element: Element, scope: _Scope, depth: int) -> list[Element]:
        _refuse_others(element, {"filename"})
        name = self._text(element, _needed(element, "filename"), scope)
        path = self.folders.find(name, "xacro:include", element.place, Path(element.source).absolute().parent)
        self.files += 1
        if path is None or self.files > MOST_FILES:
            got = f"{shown(name)}, which is not there" if path is None else f"more than {MOST_FILES} includes"
            raise xacro_fault(element, got, "a file", "check the path, or list its package's folder among the roots")
        return self.inside(read_xml(path), scope, depth)

    def _insert(self, element: Element, scope: _Scope, depth: int) -> list[Element]:
        name = self._text(element, _needed(element, "name"), scope)
        if name not in scope.blocks:
            hint = meant(name, scope.blocks, "declare it in the macro's params as *name")
            raise xacro_fault(element, f"the unknown block {shown(name)}", "a block", hint)
        return [made for child in scope.blocks[name] for made in self.expand(child, scope, depth)]

    def _condition(self, element: Element, scope: _Scope, depth: int) -> list[Element]:
        _refuse_others(element, {"value"})
        holds = is_true(_needed(element, "value"), element, scope.values, self.arguments)
        return self.inside(element, scope, depth) if holds is (element.tag == f"{PREFIX}if") else []

    def _call(self, element: Element, scope: _Scope, depth: int) -> list[Element]:
        """A macro's body in a scope of its own: its parameters and blocks, over what is known around the call."""
        name = element.tag.removeprefix(PREFIX)
        if name not in self.macros:
            close = nearest(name, [*self.macros, *self.commands])
            hint = f"did you mean <{PREFIX}{close}>?" if close else "define the macro above, or write it out"
            expected = "a macro, or property, arg, macro, include, if, unless, insert_block"
            raise xacro_fault(element, f"<{element.tag[:60]}>", expected, hint)
        macro, inner = self.macros[name], scope.inner()
        given = {key: typed(text, element, scope.values, self.arguments) for key, text in element.attributes.items()}
        defaults = macro.fill(element, given, scope.values)
        for key, text in defaults.items():
            inner.values[key] = typed(text, element, inner.values, self.arguments)
        inner.values.update(given)
        inner.blocks.update(macro.blocks(element, self.inside(element, scope, depth)))
        return self.inside(macro.element, inner, depth)


def _needed(element: Element, name: str) -> str:
    text = element.attributes.get(name, "").strip()
    if not text:
        raise xacro_fault(element, f"no attribute `{name}`", f'an element with {name}="..."', f'write {name}="..."')
    return text


def _refuse_others(element: Element, known: set[str]) -> None:
    if others := sorted(element.attributes.keys() - known):
        got = f"the attribute {shown(others[0])}"
        raise xacro_fault(
            element,
            got,
            f"an element with no attribute but {', '.join(sorted(known))}",
            "write it without, or expand it with ROS",
        )
