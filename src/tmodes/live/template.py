"""A run's data sheet as YAML with its sliders' numbers left open, so that a page can write the sheet of its own run."""

from __future__ import annotations

import math
import re
from typing import Any

from tmodes.io.sheet_write import robot_to_yaml, scalar_text
from tmodes.live.map import LiveMap
from tmodes.sheet import Robot

__all__ = ["sheet_template"]

_NUMBER = re.compile(r"(?<![\w.+-])[-+]?(?:\d+\.\d*(?:e[-+]?\d+)?)(?![\w.])")


def sheet_template(sheet: Robot, live: LiveMap) -> list[Any]:
    """Text, and lines with open places: ``{"parts": [text, {"sliders", "base"}, text, ...], "optional"}``.

    A place is a number, ``base``, times the values of some sliders. ``optional``: the slider whose line is left out
    where it says 1: a factor that the sheet does not have; ``-1``: no slider's. ``{"header": text}``: left out with all
    such lines.
    """
    marks, places, optional = _marked(sheet, live)
    text = robot_to_yaml(sheet.with_(marks))
    found: list[Any] = []
    bare = not sheet.real
    for line in text.splitlines(keepends=True):
        numbers = [match for match in _NUMBER.finditer(line.partition(" # ")[0]) if match.group() in places]
        if numbers:
            own = [optional.get(match.group(), -1) for match in numbers]
            found.append({"parts": _parts(line, numbers, places), "optional": own[0]})
        elif bare and line.rstrip() == "real:":
            found.append({"header": line})
        elif found and isinstance(found[-1], str):
            found[-1] += line
        else:
            found.append(line)
    return found


def _parts(line: str, numbers: list[re.Match[str]], places: dict[str, Any]) -> list[Any]:
    parts: list[Any] = []
    end = 0
    for match in numbers:
        parts += [line[end : match.start()], places[match.group()]]
        end = match.end()
    return [*parts, line[end:]]


_MARK = 1e-9


def _marked(sheet: Robot, live: LiveMap) -> tuple[dict[str, float], dict[str, Any], dict[str, int]]:
    """Numbers that stand nowhere else in the sheet, by path; what each stands for; and whose lines may be left out."""
    marks: dict[str, float] = {}
    places: dict[str, Any] = {}
    optional: dict[str, int] = {}
    for path, (base, own) in live.targets.items():
        value = base * math.prod(live.sliders[k].value for k in own)
        away = _MARK * (len(marks) + 1) * (abs(value) or 1.0)
        up = all(slider.high > slider.value for slider in (live.sliders[k] for k in own))
        marks[path] = value + away if up else value - away
        text = scalar_text(marks[path], quantity=False)
        places[text] = {"sliders": [*own], "base": base}
        if path.startswith("real.") and path.removeprefix("real.") not in sheet.real:
            optional[text] = own[0]
    return marks, places, optional
