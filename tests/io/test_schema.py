"""The schema for editors has the keys, the units and the meanings of the data sheet."""

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import Any

from io_cases import SHEET
from tmodes.io.forms import F2010
from tmodes.io.schema import json_schema
from tmodes.io.yaml_file import parse_yaml

SCHEMA = json_schema(F2010)


def resolved(node: dict[str, Any]) -> dict[str, Any]:
    return SCHEMA["$defs"][node["$ref"].rpartition("/")[2]] if "$ref" in node else node


def keys_of(node: dict[str, Any], path: str = "") -> Iterator[tuple[str, dict[str, Any]]]:
    """Every path that the schema knows."""
    node = resolved(node)
    inner = node.get("properties") or {str(index): item for index, item in enumerate(node.get("prefixItems", []))}
    for key, child in inner.items():
        here = f"{path}.{key}" if path else key
        yield here, child
        yield from keys_of(child, here)


def test_it_knows_every_key_of_the_published_sheet_and_no_other() -> None:
    known = dict(keys_of(SCHEMA))
    _, lines = parse_yaml(SHEET, "sheet")
    assert {path for path in lines if path and not path.startswith("real.")} <= set(known)
    for _, node in keys_of(SCHEMA):
        if "properties" in resolved(node):
            assert resolved(node)["additionalProperties"] is False


def test_required_keys_are_those_without_a_default() -> None:
    assert set(SCHEMA["required"]) == {
        *("format", "name", "contact", "motor", "gear", "link", "payload", "environment", "controller", "reference")
    }


def test_every_quantity_has_unit_symbol_and_meaning_and_may_be_text_with_a_unit() -> None:
    quantities = {path: node for path, node in keys_of(SCHEMA) if "unit" in node}
    factors = quantities.pop("real")
    assert [choice["type"] for choice in factors["anyOf"]] == ["object"]
    assert factors["description"].endswith("[-]")
    assert len(quantities) > 40
    for path, node in quantities.items():
        assert node["description"].endswith(f"[{node['unit']}]"), path
        assert node["symbol"], path
        assert [choice["type"] for choice in node["anyOf"]] in (["number", "string"], ["integer", "string"]), path
    assert quantities["gear.stiffness"]["anyOf"][0] == {"type": "number", "exclusiveMinimum": 0.0}


def test_it_is_json() -> None:
    text = json.dumps(SCHEMA, allow_nan=False)
    assert json.loads(text)["$schema"].endswith("2020-12/schema")
