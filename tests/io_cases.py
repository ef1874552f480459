"""Every number of the published data sheet, replaced by everything a number can be wrong in: made, not written."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from copy import deepcopy
from functools import cache
from typing import Any, NamedTuple

from tmodes.io.sheet_check import sheet_data
from tmodes.io.sheet_fields import quantities
from tmodes.io.sheet_paths import steps_of
from tmodes.io.sheet_words import at
from tmodes.io.yaml_file import parse_yaml
from tmodes.robots import text
from tmodes.sheet import Robot

__all__ = ["KINDS", "SHEET", "Case", "bad_numbers", "data_with", "line_of", "number_paths", "numbers_of", "value_of"]

SHEET = text("filipovic2010")

KINDS = {
    "zero": "0.0",
    "negative zero": "-0.0",
    "negative": "-{value}",
    "nan": ".nan",
    "infinite": ".inf",
    "minus infinite": "-.inf",
    "text": "heavy",
    "comma": '"1,5"',
    "numeric text": '"{value}"',
    "empty": "",
    "bool": "true",
    "list": "[1.0, 2.0]",
    "group": "{{a: 1.0}}",
    "wrong unit": '"1.5 cd"',
    "huge": "1.0e308",
    "overflow": "1.0e400",
    "tiny": "1.0e-320",
    "underflow": "1.0e-400",
    "huge whole number": "1" + "0" * 400,
    "absent": None,
}
"""Kind of fault -> what is written in place of the number; None takes the line away."""


class Case(NamedTuple):
    """One data sheet with one number replaced."""

    id: str
    path: str
    kind: str
    text: str


def value_of(robot: Robot, path: str) -> Any:
    """What stands at a path of a robot, of its own or of the format that it was imported from."""
    data = sheet_data(robot)
    value = at(data, *steps_of(path, data))
    return value[0] if isinstance(value, list) and len(value) == 1 else value


def numbers_of(robot: Robot) -> list[float]:
    """Every number of a robot's sheet."""
    return [float(container[key]) for container, key, _, _ in quantities(sheet_data(robot))]


def bad_numbers() -> Iterator[Case]:
    """Each number of the sheet with each kind of fault; some of the results are right robots."""
    for path in number_paths():
        for kind, word in KINDS.items():
            yield Case(f"{path}-{kind}".replace(" ", "_"), path, kind, _replaced(path, word))


def data_with(path: str, word: str | None) -> dict[str, Any]:
    """The sheet's data with the number of a path replaced, without reading all of its text again."""
    data: Any = deepcopy(_parsed()[0])
    plain = not path.startswith("real.")  # whose keys are paths themselves
    *above, key = (int(step) if step.isdigit() else step for step in path.split(".", -1 if plain else 1))
    inner = data
    for step in above:
        inner = inner[step]
    if word is None:
        del inner[key]
    else:
        inner[key] = parse_yaml("value: " + word.format(value=repr(inner[key])), "sheet")[0]["value"]
    return data


def number_paths() -> list[str]:
    """Dotted paths of every number that the sheet holds."""
    return [*_numbers(_parsed()[0], "")]


def line_of(path: str) -> int:
    """Line of a path in the sheet."""
    return _parsed()[1][path]


@cache
def _parsed() -> tuple[Mapping[str, Any], Mapping[str, int]]:
    """The sheet's data and the line of each path, read once for all cases."""
    return parse_yaml(SHEET, "sheet")


def _numbers(value: Any, path: str) -> Iterator[str]:
    items = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, inner in items:
        yield from _numbers(inner, f"{path}.{key}" if path else f"{key}")
    if isinstance(value, (int, float)) and not isinstance(value, bool):
        yield path


def _replaced(path: str, word: str | None) -> str:
    """The sheet with the number of a path replaced on its own line, so that lines keep their numbers."""
    lines = SHEET.splitlines()
    index = line_of(path) - 1
    found = re.search(r"([\w.]+: )([-+.\w]+)", lines[index])
    assert found, lines[index]
    entry = "" if word is None else found[1] + word.format(value=found[2])
    lines[index] = lines[index].replace(found[0], entry, 1)
    return "\n".join(lines)
