"""What sliders change and ``--set`` takes besides a number's own path.

``joints.*.gear.stiffness`` multiplies all that stand there by a factor, or sets them to a value with its unit or to
``inf``; ``real:PATH`` sets actual over nominal of what stands at a path, wherever the sheet has that factor.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from typing import Any

from tmodes.errors import InputError
from tmodes.io.forms import ROBOT, SHORTHANDS, form_of
from tmodes.io.sheet_fields import Step, keys, named
from tmodes.io.sheet_paths import expanded, steps_of
from tmodes.io.sheet_words import at, fields, is_group, members_of
from tmodes.io.words import shown

__all__ = ["group_path", "is_grouped", "later_changes", "path_of", "real_entry", "single_changes"]

EACH, REAL = "*", "real:"
LARGEST = 1000.0
"""Largest factor on numbers of a sheet, and one over the smallest: what is beyond is a value, not a factor."""


def is_grouped(path: object) -> bool:
    """Whether a path is one of these."""
    return isinstance(path, str) and (path.startswith(REAL) or EACH in path.split("."))


def single_changes(path: str, value: Any, data: Mapping[str, Any]) -> dict[str, Any]:
    """The changes by the paths of single numbers that one change means; ``data`` is a robot's complete plain data.

    Raises :class:`tmodes.errors.InputError` where nothing stands at the path, or the value is no factor.
    """
    if not is_grouped(path):
        return {path: value}
    given = not path.startswith(REAL) and (isinstance(value, str) or value == math.inf)
    if not given:
        _refuse_no_factor(path, value)
    numbers = _numbers(path.removeprefix(REAL), data)
    if not numbers:
        raise InputError(path, "no number there", "a path at which the sheet has one", "see: tmodes describe")
    if given:
        return {path_of(steps, data): value for steps, _ in numbers}
    if not path.startswith(REAL):
        return {path_of(steps, data): number * float(value) for steps, number in numbers}
    entries = {path_of(steps, data): real_entry(data, path_of(steps, data))[0] for steps, _ in numbers}
    for own, entry in entries.items():
        if entry is None:
            hint = "change the entries of `real` themselves"
            raise InputError(path, f"several factors on {own}, or one that acts on others too", "one of its own", hint)
    return {f"real.{entry}": value for entry in entries.values()}


def _refuse_no_factor(path: str, value: Any) -> None:
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not 1 / LARGEST <= value <= LARGEST:
        expected = f"a factor from {1 / LARGEST:g} to {LARGEST:g}"
        unit = "to set all to one value, write its unit too"
        hint = unit if isinstance(value, (int, float)) else "name each item to set it to something else"
        raise InputError(path, shown(value), expected, hint)


def later_changes(data: Mapping[str, Any], changes: Mapping[str, Any]) -> dict[str, Any]:
    """Those of the changes that need the complete robot, and all after them.

    They are of a group, or of one of several numbers in whose place the sheet has one; where the sheet is of another
    format, also those that name a place of the robot.
    """
    form = form_of(data)
    whole = (place for place, path in enumerate(changes) if is_grouped(path) or _in_shorthand(str(path), data))
    since = next(whole, len(changes))
    own, others = fields(form.root), keys(ROBOT.root)

    def is_later(path: str) -> bool:
        word, _, inner = path.removeprefix("real.").partition(".")
        plain_there = word in own and not any(map(is_group, members_of(own[word].annotation)))
        return word in others and (word not in own or (bool(inner) and plain_there))

    return {
        path: value
        for place, (path, value) in enumerate(changes.items())
        if place >= since or (form is not ROBOT and is_later(str(path)))
    }


def _in_shorthand(path: str, data: Mapping[str, Any]) -> bool:
    """Whether a path leads into a list or group in whose place the sheet has one number."""
    words = path.split(".")
    for count, word in enumerate(words[:-1], 1):
        if word in SHORTHANDS:
            with suppress(InputError):
                value = _value(steps_of(".".join(words[:count]), data), data)
                return value is not None and not isinstance(value, (dict, list))
    return False


def group_path(pattern: str, paths: Sequence[str], data: Mapping[str, Any]) -> str:
    """The path for all of these: the pattern that they share, with the steps in which all agree where it has others."""
    if set(single_changes(pattern, 1.0, data)) == set(paths):
        return pattern
    every = [steps_of(path, data) for path in paths]
    agreed = [str(ways[0]) if len(set(ways)) == 1 else EACH for ways in zip(*every, strict=True)]
    return ".".join(agreed)


def path_of(steps: Sequence[Step], data: Any) -> str:
    """The path of a place, by names where these lead there."""
    path, own = named(steps, data), ".".join(map(str, steps))
    try:
        return path if steps_of(path, data) == list(steps) else own
    except InputError:
        return own


def real_entry(data: Mapping[str, Any], path: str) -> tuple[str | None, float]:
    """Path in ``real`` at which the factor on a number stands, or would stand, and the factor.

    The path is None where several factors act on it, or one that acts on others as well.
    """
    real = data.get("real") or {}
    steps = steps_of(path, data)
    info = [(other, steps_of(other, data)) for other in real]
    acting = [(other, own) for other, own in info if steps[: len(own)] == own]
    if not acting:
        return path, 1.0
    (first, own), *others = acting
    shared = bool(others) or (len(own) < len(steps) and len(at(data, *own)) > 1)
    return None if shared else first, math.prod(real[other] for other, _ in acting)


def _numbers(path: str, data: Mapping[str, Any]) -> list[tuple[list[Step], float]]:
    """The numbers at a path that a factor changes, with what leads to each."""
    return [
        (steps, value)
        for place in _places(path.split("."), data)
        for steps, value in _scalars(place, _value(place, data))
        if isinstance(value, (int, float)) and not isinstance(value, bool) and value and math.isfinite(value)
    ]


def _places(words: list[str], data: Mapping[str, Any]) -> Iterator[list[Step]]:
    """The places of a path, one for each item where it says ``*``; of items that may have none, those that do."""
    if EACH not in words:
        yield steps_of(".".join(words), data)
        return
    before = words.index(EACH)
    items = _value(steps_of(".".join(words[:before]), data), data) if before else None
    for number in range(len(items) if isinstance(items, (list, tuple)) else 0):
        try:
            yield from _places([*words[:before], str(number), *words[before + 1 :]], data)
        except InputError:  # of another kind, which has no such number
            continue


def _value(steps: Sequence[Step], data: Any) -> Any:
    value = data
    for count, step in enumerate(steps, 1):
        value = expanded(at(value, step), steps[:count])
    return value


def _scalars(steps: list[Step], value: Any) -> Iterator[tuple[list[Step], Any]]:
    """What stands at a place, or what its list holds."""
    if not isinstance(value, (list, tuple)):
        yield steps, value
        return
    for number, item in enumerate(value):
        yield from _scalars([*steps, number], item)
