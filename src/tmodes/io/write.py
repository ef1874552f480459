"""Write a robot as a data sheet that reads back as the same robot, with symbols, units and meanings as comments."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from typing import Any

from pydantic import BaseModel

from tmodes.io.fields import place_at
from tmodes.io.scalars import scalar
from tmodes.robot import Robot

__all__ = ["robot_to_yaml"]

WORD = re.compile(r"[A-Za-z][A-Za-z0-9_]*")
COLUMN = 40


def robot_to_yaml(robot: Robot) -> str:
    """The data sheet of a robot as YAML. Every number is written with all its digits; reading it gives ``robot``."""
    return "\n".join([*_group(robot, "", ""), ""])


def _group(sheet: BaseModel, path: str, indent: str) -> Iterator[str]:
    for name in type(sheet).model_fields:
        value, here = getattr(sheet, name), f"{path}.{name}" if path else name
        yield from _entry(f"{indent}{name}:", value, here, indent)


def _entry(key: str, value: Any, path: str, indent: str) -> Iterator[str]:
    match value:
        case BaseModel():
            yield from ("", key)
            yield from _group(value, path, f"{indent}  ")
        case dict():
            if value:
                yield from ("", key)
            for inner, factor in value.items():
                yield f"{indent}  {inner}: {_scalar(factor)}"
        case tuple():
            yield key
            for index, item in enumerate(value):
                first, *rest = _group(item, f"{path}.{index}", f"{indent}    ")
                yield from (f"{indent}  - {first.lstrip()}", *rest)
        case _:
            yield _commented(f"{key} {_scalar(value)}", path)


def _commented(line: str, path: str) -> str:
    place = place_at(path)
    if place is None or place.unit is None:
        return line
    return f"{line:<{COLUMN}} # {place.extra['symbol']} [{place.unit}] {place.meaning}"


def _scalar(value: Any) -> str:
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, float):
        return _float(value)
    return str(value) if isinstance(value, int) else _text(str(value))


def _float(value: float) -> str:
    """All digits; with a point, so that readers of YAML 1.1 see a number too."""
    if math.isinf(value):
        return ".inf" if value > 0 else "-.inf"
    digits, exponent, power = repr(value).partition("e")
    return f"{digits if '.' in digits else digits + '.0'}{exponent}{power}"


def _text(value: str) -> str:
    if WORD.fullmatch(value) and scalar(value) == value:
        return value
    return '"' + "".join(_escaped(letter) for letter in value) + '"'


def _escaped(letter: str) -> str:
    if letter in '"\\':
        return f"\\{letter}"
    return letter if letter.isprintable() else f"\\U{ord(letter):08x}"
