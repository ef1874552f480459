"""Data sheets as the page holds them: plain data, checked here, written as YAML."""

from __future__ import annotations

import math
from functools import cache
from typing import Any

from tmodes.io.files import ALLOW
from tmodes.io.forms import json_schema
from tmodes.io.sheet_check import sheet_data
from tmodes.io.sheet_fields import quantities
from tmodes.io.sheet_paths import steps_of
from tmodes.io.sheet_plausible import notices_about
from tmodes.io.yaml_file import parse_yaml
from tmodes.live.knobs import Knob, knobs_of
from tmodes.live.sliders import Slider, sliders_of
from tmodes.robots.load import sheet_names, sheet_text
from tmodes.sheet import Robot
from tmodes.studio.messages import FOLDER

__all__ = ["catalogue", "plain_sheet", "schema", "sheet_record", "slider_records"]

MOST_BYTES = 300_000_000
"""Largest result that is simulated for the page [bytes]."""


@cache
def catalogue() -> list[dict[str, str]]:
    """Name and title of each published robot."""
    read = {name: parse_yaml(sheet_text(name), f"{name}.yaml")[0] for name in sheet_names()}
    return [{"name": name, "title": str(data.get("title", ""))} for name, data in read.items()]


@cache
def schema() -> dict[str, Any]:
    """The JSON Schema of which the forms are made."""
    return json_schema()


def plain_sheet(sheet: Robot) -> dict[str, Any]:
    """The plain data of a sheet as JSON can hold it, infinite numbers as ``.inf``: reading it gives the same sheet."""
    return _finite(sheet_data(sheet))


def _finite(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _finite(item) for key, item in value.items()}
    if isinstance(value, list):
        return [_finite(item) for item in value]
    return ".inf" if value == math.inf else value


def sheet_record(sheet: Robot) -> dict[str, Any]:
    """What the page gets of a right sheet: its data, units by path, sliders, and what looks implausible."""
    data = plain_sheet(sheet)
    data["notices"] = [text.replace(ALLOW, FOLDER) for text in data["notices"]]
    units = {".".join(map(str, steps)): place.unit or "" for _, _, steps, place in quantities(data)}
    info = {"units": units, "sliders": slider_records(sheet, data), "warnings": notices_about(sheet)}
    return {"name": sheet.name, "sheet": data, **info}


def slider_records(sheet: Robot, data: dict[str, Any]) -> list[dict[str, Any]]:
    """The numbers of a sheet that are dragged most, the most useful first; ``data`` is its plain data.

    A slider stands at its number, or, where it moves several ``together``, at the factor on their bases.
    """
    knobs = knobs_of(sheet)
    return [_slider_record(slider, knobs[slider.knob], data) for slider in sliders_of(sheet, knobs)]


def _slider_record(slider: Slider, knob: Knob, data: dict[str, Any]) -> dict[str, Any]:
    if slider.real:
        targets = [{"steps": ["real", path], "base": 1.0} for path in knob.reals]
    else:
        targets = [{"steps": list(steps_of(path, data)), "base": base} for path, base in knob.targets]
    names = ("path", "label", "symbol", "unit", "group", "log", "design")
    info: dict[str, Any] = {name: getattr(slider, name) for name in names}
    together = knob.together and not slider.real
    return info | {"min": slider.low, "max": slider.high, "together": together, "targets": targets}
