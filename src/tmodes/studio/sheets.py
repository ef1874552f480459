"""Data sheets as the page holds them: plain data, checked here, written as YAML."""

from __future__ import annotations

import math
from functools import cache
from pathlib import Path
from typing import Any

from tmodes.io.sheet_check import sheet_data, sheet_from_data
from tmodes.sheet import Robot

__all__ = ["catalogue", "checked_sheet", "info_sheet", "loaded", "plain_sheet", "schema", "sheet_yaml", "units_of"]

MOST_BYTES = 300_000_000
"""Largest result that is simulated for the page [bytes]."""


@cache
def catalogue() -> list[dict[str, str]]:
    """Name and title of each published robot."""
    from tmodes.io.yaml_file import parse_yaml
    from tmodes.robots.load import sheet_names, sheet_text

    read = {name: parse_yaml(sheet_text(name), f"{name}.yaml")[0] for name in sheet_names()}
    return [{"name": name, "title": str(data.get("title", ""))} for name, data in read.items()]


@cache
def schema() -> dict[str, Any]:
    """The JSON Schema of which the forms are made."""
    from tmodes.io.forms import json_schema

    return json_schema()


def checked_sheet(data: Any) -> Robot:
    """The checked sheet of plain data; raises :class:`tmodes.errors.InputErrors` with every wrong value."""
    return sheet_from_data(data)


def loaded(name_or_path: str | Path, roots: tuple[Path, ...] = ()) -> Robot:
    """A published sheet, or that of a file; the errors are those of :func:`tmodes.robots.load.load`."""
    from tmodes.robots.load import load

    return load(name_or_path, roots=roots)


def plain_sheet(sheet: Robot) -> dict[str, Any]:
    """The plain data of a sheet as JSON can hold it, infinite numbers as ``.inf``: reading it gives the same sheet."""
    return _finite(sheet_data(sheet))


def _finite(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _finite(item) for key, item in value.items()}
    if isinstance(value, list):
        return [_finite(item) for item in value]
    return ".inf" if value == math.inf else value


def sheet_yaml(sheet: Robot) -> str:
    """The sheet as YAML, with units and meanings."""
    from tmodes.io.sheet_write import arm_to_yaml

    return arm_to_yaml(sheet)


def info_sheet(sheet: Robot) -> dict[str, Any]:
    """What the page gets of a right sheet: its data, units by path, sliders, and what looks implausible."""
    from tmodes.io.sheet_plausible import notices_about
    from tmodes.studio.sliders import info_sliders

    data = plain_sheet(sheet)
    info = {"units": units_of(data), "sliders": info_sliders(sheet, data), "warnings": notices_about(sheet)}
    return {"name": sheet.name, "sheet": data, **info}


def units_of(data: Any) -> dict[str, str]:
    """The unit of each number by its path, where the schema alone does not give it (a joint turns or slides)."""
    from tmodes.io.sheet_fields import quantities

    return {".".join(map(str, steps)): place.unit or "" for _, _, steps, place in quantities(data)}
