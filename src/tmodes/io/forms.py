"""The forms of data sheet that a person writes, and the JSON Schema of each, for editors that check it."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from tmodes.io.filipovic2010 import importer
from tmodes.io.filipovic2010.format import FORMAT, PLANT, Format2010
from tmodes.sheet import SHEET_FORMAT, Robot

__all__ = [
    "F2010",
    "ROBOT",
    "SHORTHANDS",
    "SheetForm",
    "editor_schema",
    "follows",
    "form_of",
    "json_schema",
    "own_path",
]
__all__ += ["register_form", "robot_path", "with_reach"]


@dataclass(frozen=True)
class SheetForm:
    """One form: the type that checks it, the version of its format, and the groups that ``real`` may name."""

    name: str
    root: type[Any]
    version: int
    factored: tuple[str, ...]


_FACTORED = (
    *("gravity", "base", "joints", "links", "tip", "points", "couplings", "loads", "drives"),
    *("contact", "contact_off", "parameters"),
)
ROBOT = SheetForm("arm", Robot, SHEET_FORMAT, _FACTORED)
F2010 = SheetForm(importer.NAME, Format2010, FORMAT, PLANT)

_ROBOT_KEYS = ("kind", "joints", "links", "urdf")
"""Keys by one of which a sheet is that of joints and links."""


_OTHERS: dict[str, SheetForm] = {}
"""Sheets that are of no robot, by what they say at ``kind``."""


def register_form(form: SheetForm) -> SheetForm:
    """Let sheets with ``kind: NAME`` be of this form; the packages that read them register them."""
    _OTHERS[form.name] = form
    return form


def form_of(data: Any) -> SheetForm:
    """The form of a sheet's plain data."""
    if isinstance(data, Mapping) and isinstance(kind := data.get("kind"), str) and kind in _OTHERS:
        return _OTHERS[kind]
    if not isinstance(data, Mapping) or any(key in data for key in _ROBOT_KEYS):
        return ROBOT
    return F2010


def robot_path(path: str, data: Any) -> str:
    """A path in a robot's plain data, where one of the format that it was imported from may stand."""
    return importer.placed_path(path, data) if _is_imported(data) else path


def own_path(path: str, data: Any) -> str:
    """The path of a number in the format that the robot was imported from."""
    return importer.own_path(path) if _is_imported(data) else path


def with_reach(before: Mapping[str, Any], after: dict[str, Any]) -> dict[str, Any]:
    """Changed plain data of a robot, with what follows from the changes in the format that it was imported from."""
    return importer.with_reach(before, after) if _is_imported(after) else after


def follows(robot: Robot, changed: Mapping[tuple[str | int, ...], Any]) -> dict[tuple[str | int, ...], Any]:
    """As :func:`with_reach` of numbers of a robot by their steps: what follows from those that are ``changed``."""
    return importer.reach_of(robot, changed) if robot.imported == importer.NAME else {}


def _is_imported(data: Any) -> bool:
    return isinstance(data, Mapping) and data.get("imported") == importer.NAME


WITH_UNIT = {"type": "string", "description": 'a number with its unit in quotes, such as "600 mm"'}
RULES = (
    *("type", "exclusiveMinimum", "minimum", "maximum", "anyOf", "items", "prefixItems", "additionalProperties"),
    *("minItems", "maxItems"),
)
OWN = ("smallest", "plausible", "span")
"""What a field keeps for messages, and no editor needs."""

SHORTHANDS = {
    **{name: {"type": "number"} for name in ("gravity", "stiffness", "bending_stiffness", "inertia")},
    "functions": {"type": "integer"},
}
"""Lists and groups in whose place one number may stand."""


def json_schema(form: SheetForm = ROBOT) -> dict[str, Any]:
    """JSON Schema (draft 2020-12) of a form of data sheets, with units, symbols and meanings."""
    return editor_schema(form.root.model_json_schema(by_alias=True))


def editor_schema(raw: Mapping[str, Any]) -> dict[str, Any]:
    """The schema for editors (draft 2020-12) of the ``raw`` one that a data sheet's type gives."""
    schema = _finite(_with_units(dict(raw)))
    return {"$schema": "https://json-schema.org/draft/2020-12/schema", **schema}


def _with_units(node: Any, name: str = "") -> Any:
    """Let every quantity also be text with a unit, and one number stand where it may, as the reader takes them."""
    if isinstance(node, list):
        return [_with_units(item) for item in node]
    if not isinstance(node, dict):
        return node
    if isinstance(node.get("unit"), str):
        return _quantity(node, name)
    inside = {
        key: {inner: _with_units(field, inner) for inner, field in value.items()}
        if key == "properties"
        else _with_units(value)
        for key, value in node.items()
    }
    if name in SHORTHANDS and "type" not in inside:
        text = [WITH_UNIT] if SHORTHANDS[name]["type"] == "number" else []
        inside["anyOf"] = [*inside.get("anyOf", []), SHORTHANDS[name], *text]
    return inside


def _quantity(node: dict[str, Any], name: str) -> dict[str, Any]:
    info = {key: value for key, value in node.items() if key not in (*RULES, *OWN)}
    rules = {key: _numbers(node[key]) if key != "type" else node[key] for key in RULES if key in node}
    choices = rules.pop("anyOf", None) or [rules]
    if all(choice.get("type") in {"number", "integer", "null"} for choice in choices):
        choices = [*choices, WITH_UNIT]
    elif name in SHORTHANDS:
        choices = [*choices, SHORTHANDS[name], WITH_UNIT]
    return {**info, "anyOf": choices}


def _numbers(node: Any) -> Any:
    """Numbers inside of a list or a group, each of which may be text too."""
    if isinstance(node, list):
        return [_numbers(item) for item in node]
    if not isinstance(node, dict):
        return node
    if node.get("type") == "number":
        return {"anyOf": [{key: value for key, value in node.items() if key in RULES}, WITH_UNIT]}
    return {key: _numbers(value) for key, value in node.items() if key not in OWN}


def _finite(node: Any) -> Any:
    """JSON has no infinite numbers; a sheet writes them as .inf."""
    if isinstance(node, dict):
        return {key: _finite(value) for key, value in node.items()}
    if isinstance(node, list):
        return [_finite(item) for item in node]
    return ".inf" if isinstance(node, float) and math.isinf(node) else node
