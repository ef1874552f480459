"""The JSON Schema of a data sheet, for editors that complete and check while one types."""

from __future__ import annotations

from typing import Any

from tmodes.robot import Robot

__all__ = ["json_schema"]

WITH_UNIT = {"type": "string", "description": 'a number with its unit in quotes, such as "600 mm"'}


def json_schema() -> dict[str, Any]:
    """JSON Schema (draft 2020-12) of a robot's data sheet, with units, symbols and meanings."""
    schema = _with_units(Robot.model_json_schema())
    return {"$schema": "https://json-schema.org/draft/2020-12/schema", **schema}


def _with_units(node: Any) -> Any:
    """Let every quantity also be text with a unit, as the reader takes it."""
    if isinstance(node, list):
        return [_with_units(item) for item in node]
    if not isinstance(node, dict):
        return node
    if "unit" in node:
        return _quantity(node)
    return {key: _with_units(value) for key, value in node.items()}


def _quantity(node: dict[str, Any]) -> dict[str, Any]:
    rules = ("type", "exclusiveMinimum", "minimum", "maximum")
    told = {key: value for key, value in node.items() if key not in (*rules, "smallest", "plausible")}
    number = {key: node[key] for key in rules if key in node}
    return {**told, "anyOf": [number, WITH_UNIT]}
