"""Change plain data by dotted path: ``gear.stiffness``, ``link.modes.0.length``, ``real.gear.stiffness``."""

from __future__ import annotations

import copy
import re
from collections.abc import Mapping
from typing import Any

from tmodes.errors import InputError
from tmodes.io.fields import number_paths, places
from tmodes.io.scalars import scalar
from tmodes.io.words import nearest, shown

__all__ = ["parse_assignment", "set_paths"]

LONGEST_VALUE = 2_000

NUMBERS = re.compile(r"\[ *[-+.0-9][^][{},'\"&*!]*(,[ ]*[-+.0-9][^][{},'\"&*!]*)*\]")
"""A flow list of numbers, each perhaps with its unit."""


def set_paths(data: Mapping[str, Any], changes: Mapping[str, Any]) -> dict[str, Any]:
    """A copy of a robot's plain data with the value at each path replaced; the values are checked elsewhere.

    Every key that a data sheet may hold can be set, also one that this one leaves out, and each entry of ``real``.
    Raises :class:`tmodes.errors.InputError` with the nearest path for one that does not exist.
    """
    changed = copy.deepcopy(dict(data))
    for path, value in changes.items():
        *groups, key = _steps(path)
        inner: Any = changed
        for step in groups:
            inner = _entered(inner, step, path)
        _put(inner, key, copy.deepcopy(value), path)
    return changed


def parse_assignment(text: str) -> tuple[str, Any]:
    """Path and value of ``path=value``; the value is read as a bare word, quoted text or list of numbers of YAML.

    Raises :class:`tmodes.errors.InputError` for anything else.
    """
    path, equals, value = (part.strip() for part in text.partition("="))
    if not (path and equals and value) or len(value) > LONGEST_VALUE:
        hint = "write it without spaces around =, as in gear.stiffness=900"
        raise InputError("an assignment", shown(text), "path=value", hint)
    if len(value) > 1 and value[0] == value[-1] and value[0] in "'\"":
        return path, value[1:-1]
    if NUMBERS.fullmatch(value):
        return path, [scalar(word.strip()) for word in value[1:-1].split(",")]
    return path, scalar(value)


def _steps(path: str) -> list[str]:
    """The keys that lead to a path; the keys inside ``real`` hold dots themselves."""
    if path in places():
        return path.split(".")
    group, _, inner = path.partition(".")
    if group == "real" and inner in number_paths():
        return [group, inner]
    known = [*places(), *(f"real.{number}" for number in number_paths())]
    raise InputError(path or "''", "an unknown path", "the path of a value of the data sheet", _meant(path, known))


def _meant(path: str, known: list[str]) -> str:
    last = path.rpartition(".")[2]
    same = [other for other in known if other.rpartition(".")[2] == last and not other.startswith("real.")]
    close = [*dict.fromkeys(filter(None, [nearest(path, known), *same[:3]]))]
    if not close:
        return "look the path up in the data sheet"
    return f"did you mean {' or '.join(f'`{other}`' for other in close)}?"


def _entered(inner: Any, step: str, path: str) -> Any:
    if isinstance(inner, list):
        return inner[_index(inner, step, path)]
    if not isinstance(inner, dict):
        raise _not_a_group(inner, path)
    return inner.setdefault(step, {})


def _put(inner: Any, key: str, value: Any, path: str) -> None:
    if isinstance(inner, list):
        inner[_index(inner, key, path)] = value
    elif isinstance(inner, dict):
        inner[key] = value
    else:
        raise _not_a_group(inner, path)


def _index(items: list[Any], step: str, path: str) -> int:
    if int(step) >= len(items):
        raise InputError(
            path, f"a list of {len(items)}", f"an entry number {step}", "correct the list in the file first"
        )
    return int(step)


def _not_a_group(inner: Any, path: str) -> InputError:
    return InputError(path, f"{shown(inner)} around it", "a group", "correct the group in the file first")
