"""Write a robot as a data sheet that reads back as the same robot, with symbols, units and meanings as comments."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping
from typing import Any

from tmodes.io.sheet_check import sheet_data
from tmodes.io.sheet_fields import Step, place_of
from tmodes.io.units import scalar
from tmodes.sheet import Robot

__all__ = ["robot_to_yaml", "scalar_text", "text"]

WORD = re.compile(r"[A-Za-z][A-Za-z0-9_]*")
YAML_1_1 = {"y", "n", "yes", "no", "on", "off"}
"""Words that older readers take for true and false."""


def scalar_text(value: Any, quantity: bool) -> str:
    """A value of plain data as YAML; ``quantity``: text stands for an infinite number."""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, int):
        return str(value)
    if quantity and isinstance(value, str):
        value = float(value)
    return _float(value) if isinstance(value, float) else text(str(value))


def _float(value: float) -> str:
    """All digits; with a point, so that readers of YAML 1.1 see a number too."""
    if math.isinf(value):
        return ".inf" if value > 0 else "-.inf"
    digits, exponent, power = repr(value).partition("e")
    return f"{digits if '.' in digits else digits + '.0'}{exponent}{power}"


def text(value: str) -> str:
    """A text as a bare word where that is safe, else in quotes."""
    if WORD.fullmatch(value) and scalar(value) == value and value.lower() not in YAML_1_1:
        return value
    return '"' + "".join(_escaped(letter) for letter in value) + '"'


def _escaped(letter: str) -> str:
    if letter in '"\\':
        return f"\\{letter}"
    return letter if letter.isprintable() else f"\\U{ord(letter):08x}"


COLUMN = 48


def robot_to_yaml(robot: Robot) -> str:
    """The data sheet of a robot as YAML. Every number is written with all its digits; reading it gives ``robot``."""
    data = sheet_data(robot)
    return "\n".join([*_group(data, (), "", data), ""])


def _group(group: Mapping[str, Any], steps: tuple[Step, ...], indent: str, data: Any) -> Iterator[str]:
    for key, value in group.items():
        if value not in ({}, []):
            yield from _entry(f"{indent}{text(key)}:", value, (*steps, key), indent, data)


def _entry(key: str, value: Any, steps: tuple[Step, ...], indent: str, data: Any) -> Iterator[str]:
    if isinstance(value, dict):
        yield key
        yield from _group(value, steps, f"{indent}  ", data)
    elif isinstance(value, list) and any(isinstance(item, dict) for item in value):
        yield key
        for index, item in enumerate(value):
            first, *rest = _group(item, (*steps, index), f"{indent}    ", data)
            yield from (f"{indent}  - {first.lstrip()}", *rest)
    else:
        yield from _values(key, value, steps, indent, data)


def _flow(value: Any, quantity: bool) -> str:
    """A scalar, or a list of them or of lists, in one line."""
    if isinstance(value, list):
        return f"[{', '.join(_flow(item, quantity) for item in value)}]"
    return scalar_text(value, quantity)


def _values(key: str, value: Any, steps: tuple[Step, ...], indent: str, data: Any) -> Iterator[str]:
    """A scalar or a list of numbers, with what it is; a long list one number in a line."""
    place = place_of(steps, data)
    quantity = place is not None and place.unit is not None
    comment = f" # {place.extra.get('symbol', steps[-1])} [{place.unit}] {place.meaning}" if quantity and place else ""
    if isinstance(value, list) and len(value) > 12:
        yield f"{key:<{COLUMN}}{comment}" if comment else key
        yield from (f"{indent}  - {_flow(item, quantity)}" for item in value)
        return
    line = f"{key} {_flow(value, quantity)}"
    yield f"{line:<{COLUMN}}{comment}" if comment else line
