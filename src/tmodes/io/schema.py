"""The JSON Schema of a data sheet, for editors that complete and check while one types."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from tmodes.io.forms import ROBOT, Form

__all__ = ["editor_schema", "json_schema"]

WITH_UNIT = {"type": "string", "description": 'a number with its unit in quotes, such as "600 mm"'}
RULES = ("type", "exclusiveMinimum", "minimum", "maximum", "anyOf", "items", "prefixItems", "additionalProperties")
RULES = (*RULES, "minItems", "maxItems")
OWN = ("smallest", "plausible", "span")
"""What a field keeps for messages, and no editor needs."""

SHORTHANDS = {
    "gravity": {"type": "number"},
    "stiffness": {"type": "number"},
    "bending_stiffness": {"type": "number"},
    "functions": {"type": "integer"},
    "inertia": {"type": "number"},
}
"""Lists and groups in whose place one number may stand."""


def json_schema(form: Form = ROBOT) -> dict[str, Any]:
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
    return _or_number(inside, name) if name in SHORTHANDS and "type" not in inside else inside


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


def _or_number(node: dict[str, Any], name: str) -> dict[str, Any]:
    return {**node, "anyOf": [*node.get("anyOf", []), SHORTHANDS[name]]}


def _finite(node: Any) -> Any:
    """JSON has no infinite numbers; a sheet writes them as .inf."""
    if isinstance(node, dict):
        return {key: _finite(value) for key, value in node.items()}
    if isinstance(node, list):
        return [_finite(item) for item in node]
    return ".inf" if isinstance(node, float) and math.isinf(node) else node
