"""A run's data sheet as YAML with its sliders' numbers left open, so that a page can write the sheet of its own run."""

from __future__ import annotations

import re
from typing import Any

from tmodes.io.sheet_write import robot_to_yaml, scalar_text
from tmodes.live.map import LiveMap
from tmodes.sheet import Robot

__all__ = ["sheet_template"]

_NUMBER = re.compile(r"(?<![\w.+-])[-+]?(?:\d+\.\d*(?:e[-+]?\d+)?)(?![\w.])")


def sheet_template(sheet: Robot, live: LiveMap) -> list[Any]:
    """Text, and lines with open places: ``{"parts": [text, {"slider", "base"}, text, ...], "optional"}``.

    A place says which slider fills it, and of numbers that move in proportion by which ``base`` it is multiplied (None:
    by none). ``optional``: the slider whose line is left out where it says 1: a factor that the sheet does not have;
    ``-1``: no slider's. ``{"header": text}``: left out with all such lines.
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


def _marked(sheet: Robot, live: LiveMap) -> tuple[dict[str, float], dict[str, Any], dict[str, int]]:
    """Numbers that stand nowhere else in the sheet, by path; what each stands for; and whose lines may be left out."""
    marks: dict[str, float] = {}
    places: dict[str, Any] = {}
    optional: dict[str, int] = {}
    for index, slider in enumerate(live.sliders):
        knob = live.knobs[slider.knob]
        for path, base in slider.changes(knob, slider.value).items():
            mark = base * (1 + 1.37e-5 * (len(marks) + 1)) + (0.0 if base else 1.37e-5 * (len(marks) + 1))
            marks[path] = mark
            proportion = knob.together and not slider.real
            places[scalar_text(mark, quantity=False)] = {"slider": index, "base": base if proportion else None}
            if slider.real and path.removeprefix("real.") not in sheet.real:
                optional[scalar_text(mark, quantity=False)] = index
    return marks, places, optional
