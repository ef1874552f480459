"""Write a robot as a data sheet that reads back as the same robot, with symbols, units and meanings as comments."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from pydantic import BaseModel

from tmodes.io.fields import place_at
from tmodes.io.yaml_text import scalar_text
from tmodes.paper.sheet import PaperRobot

__all__ = ["robot_to_yaml"]

COLUMN = 40


def robot_to_yaml(robot: PaperRobot) -> str:
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
                yield f"{indent}  {inner}: {scalar_text(factor, quantity=False)}"
        case tuple() if not any(isinstance(item, BaseModel) for item in value):
            if value:
                yield f"{key} [{', '.join(scalar_text(item, quantity=False) for item in value)}]"
        case tuple():
            yield key
            for index, item in enumerate(value):
                first, *rest = _group(item, f"{path}.{index}", f"{indent}    ")
                yield from (f"{indent}  - {first.lstrip()}", *rest)
        case _:
            yield _commented(f"{key} {scalar_text(value, quantity=False)}", path)


def _commented(line: str, path: str) -> str:
    place = place_at(path)
    if place is None or place.unit is None:
        return line
    return f"{line:<{COLUMN}} # {place.extra['symbol']} [{place.unit}] {place.meaning}"
