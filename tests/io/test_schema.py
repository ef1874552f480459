"""The schema for editors has the keys, the units and the meanings of the data sheet."""

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import Any, get_args

import pytest

from io_cases import SHEET
from tmodes.io.forms import F2010, ROBOT, SheetForm, json_schema
from tmodes.io.sheet_words import fields, is_group, members_of, own_unit
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


def groups(member: Any, found: dict[str, Any]) -> dict[str, Any]:
    """Every group of keys that a type leads to, by its name."""
    for inner in members_of(member):
        if is_group(inner) and inner.__name__ not in found:
            found[inner.__name__] = inner
            for info in fields(inner).values():
                groups(info.annotation, found)
        for argument in () if is_group(inner) else get_args(inner):
            groups(argument, found)
    return found


@pytest.mark.parametrize("form", [F2010, ROBOT], ids=lambda form: form.name)
def test_it_has_the_places_and_the_units_of_the_data_sheet(form: SheetForm) -> None:
    """In the same order, of both forms of data sheets and of every kind that is registered."""
    schema = json_schema(form)
    nodes = {name.rpartition("__")[2]: node for name, node in schema["$defs"].items()}
    nodes[form.root.__name__] = schema
    found = groups(form.root, {})
    assert len(found) > (10 if form is F2010 else 40)
    for name, group in found.items():
        properties = nodes[name]["properties"]
        assert list(properties) == list(fields(group)), name
        assert {key: node.get("unit") for key, node in properties.items()} == {
            key: own_unit(info) for key, info in fields(group).items()
        }, name


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
