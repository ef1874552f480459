"""What the validator found wrong in a data sheet, in our words: which, got, expected, hint."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from itertools import islice
from typing import Any, get_origin

from pydantic import ValidationError
from pydantic_core import ErrorDetails

from tmodes.errors import InputError
from tmodes.io.forms import SHORTHANDS, own_path
from tmodes.io.sheet_fields import ChainPlace, Step, chosen, inside, keys, named, place_of, quantities, root_of
from tmodes.io.sheet_words import at, fields, is_group, kind_of, members_of
from tmodes.io.words import nearest, shown
from tmodes.kinds.schema.quantity import LARGEST, LEAST
from tmodes.sheet.checks import command_issue

__all__ = ["AS_LIST", "Problem", "sheet_problems"]

SHEET = "the data sheet"

MOST_REPORTED = 500
"""Number of wrong places for which similar words are sought: no more."""

AS_LIST = "write it as a list: [0.1, 0.2, 0.3]"

_OUTERMOST = "put `"

_REMOVE = "remove it"
"""Hint for a key that is unknown wherever it stands."""

Problem = tuple[tuple[Step, ...], InputError]
"""The path of a wrong value by keys and numbers, and what is to be said of it."""


def sheet_problems(error: ValidationError, data: Any) -> list[Problem]:
    """One problem for each wrong place of the plain data that was refused, of very many the first."""
    info: dict[tuple[Step, ...], InputError] = {}
    for detail in islice(error.errors(include_url=False), MOST_REPORTED):
        for steps, problem in _problems(detail, data):
            info.setdefault(steps, problem)
    missing: dict[tuple[Step, ...], list[str]] = {}
    for steps, one in info.items():
        if steps and one.got == "nothing":
            missing.setdefault(steps[:-1], []).append(str(steps[-1]))
    if homeless := [
        (steps, one) for steps, one in info.items() if steps and one.hint.startswith((_REMOVE, _OUTERMOST))
    ]:
        words = _words(data)
        for steps, problem in homeless:
            lacking = missing.get(steps[:-1], [])
            if len(lacking) == 1 and str(steps[-1]) not in words:
                problem.hint = f"did you mean `{own_path(named((*steps[:-1], lacking[0]), data), data)}`?"
            elif problem.hint.startswith(_REMOVE) and (found := words.get(str(steps[-1])) or _further_in(steps, data)):
                problem.hint = f"did you mean `{found}`? Write it there"
    return list(info.items())


def _further_in(steps: tuple[Step, ...], data: Any) -> str:
    """The path of a key that belongs one group further in: by its name, or as a name of a group of numbers."""
    (*groups, last), value = steps, at(data, *steps)
    for key, info in fields(_group(tuple(groups), data)).items():
        members = members_of(info.annotation)
        numbers = bool(groups) and isinstance(value, (int, float))
        by_name = numbers and any(get_origin(member) is dict for member in members)
        if by_name or any(is_group(member) and str(last) in keys(member) for member in members):
            return own_path(named((*groups, key, last), data), data)
    return ""


def _words(data: Any) -> dict[str, str]:
    """The first path of a number with each key and each symbol, by which a key in the wrong group is known."""
    found: dict[str, str] = {}
    for _, _, steps, place in quantities(data):
        path = own_path(named(steps, data), data)
        found.setdefault(str(steps[-1]), path)
        found.setdefault(str(place.extra.get("symbol")), path)
    return found


def _problems(detail: ErrorDetails, data: Any) -> Iterator[Problem]:
    steps = _steps(detail["loc"], data)
    match detail["type"]:
        case "extra_forbidden" | "invalid_key":
            yield steps, _unknown(steps, data)
        case "missing" if steps and isinstance(steps[-1], int):
            place, got = place_of(steps[:-1], data), shown(at(data, *steps[:-1]))
            expected = place.expected if place else "a longer list"
            yield steps[:-1], InputError("", got, expected, "write each of its numbers")
        case "missing":
            yield steps, _missing(steps, data)
        case "too_short" if len(at(data, *steps)) >= detail.get("ctx", {})["min_length"]:
            return  # it counts the items that are right
        case "union_tag_not_found" | "union_tag_invalid":
            yield _kind(steps, data)
        case "issues":
            for field, got, expected, hint in detail.get("ctx", {})["issues"]:
                inner = tuple(int(step) if step.isdecimal() else step for step in field.split(".") if step)
                names = expected.removeprefix("one of ").split(", ") if expected.startswith("one of ") else []
                close = nearest(got.strip("'`"), names) if names else None
                yield (*steps, *inner), InputError("", got, expected, f"did you mean `{close}`?" if close else hint)
        case kind:
            yield steps, _wrong(steps, kind, detail, data)


def _steps(loc: tuple[Step, ...], data: Any) -> tuple[Step, ...]:
    """The validator's location without the kinds that it names on the way into a section, a signal, a material."""
    steps: list[Step] = []
    place: ChainPlace | None = root_of(data)
    value = data
    skipped = False
    for step in loc:
        if step == "[key]":
            continue
        if place is not None and place.tagged and not skipped:
            skipped = True
            continue
        skipped = False
        place = inside(place, step, value, [*steps, step], data) if place else None
        steps.append(step)
        value = at(value, step)
    return tuple(steps)


def _group(steps: tuple[Step, ...], data: Any) -> Any:
    """The type of the group at a path, of the kind that the data names."""
    place = place_of(steps, data)
    return chosen(place, at(data, *steps)) if place else None


def _unknown(steps: tuple[Step, ...], data: Any) -> InputError:
    known = keys(_group(steps[:-1], data))
    key = str(steps[-1])
    close = nearest(key, known)
    group = named(steps[:-1], data)
    hint = f"did you mean `{group}.{close}`?" if close and group else f"did you mean `{close}`?"
    hint = hint if close and "." not in key else _elsewhere(steps, data)
    if hint == _REMOVE and (kinds := _unnamed(steps[:-1], data)):
        hint = kinds
    return InputError("", "an unknown key", f"one of {', '.join(known) or 'the known keys'}", hint)


def _unnamed(steps: tuple[Step, ...], data: Any) -> str:
    """That a group may name its kind, where it does not, and so is taken for the one without a name."""
    kinds, value = _kinds(steps, data), at(data, *steps)
    words = [f"`{key}: {word}`" for key, word, default in kinds if word != default]
    named_kind = any(key in value for key, _, _ in kinds)
    return "" if named_kind or not words else f"{_REMOVE}, or name the kind: {', '.join(words)}"


def _elsewhere(steps: tuple[Step, ...], data: Any) -> str:
    """Where a key belongs that is no misspelt one of its group: it holds its own path, or is of a level further out."""
    key = str(steps[-1])
    group, _, name = key.rpartition(".")
    if group and place_of(path := key.split("."), data) is not None and is_group(_group(tuple(path[:-1]), data)):
        return f"put the key `{name}` inside the group `{group}`"
    for outer in (steps[:k] for k in range(len(steps) - 2, 0, -1)):
        if is_group(found := _group(outer, data)) and key in keys(found):
            return f"{_OUTERMOST}{key}` into the group `{own_path(named(outer, data), data)}`"
    return f"{_OUTERMOST}{key}` at the outermost level" if key in keys(root_of(data).annotation) else _REMOVE


def _missing(steps: tuple[Step, ...], data: Any) -> InputError:
    place = place_of(steps, data)
    expected = place.expected if place else "a value"
    if kinds := [str(word) for key, word, _ in _kinds(steps[:-1], data) if key == steps[-1]]:
        expected = f"one of {', '.join(kinds)}"
    elif place and place.info and place.info.description:
        expected += f": {place.meaning}"
    words = _possible(kinds or (place.choices if place else []), steps, data)
    lines = " or ".join(f"`{steps[-1]}: {choice}`" for choice in words or ["..."]) if steps else ""
    group = own_path(named(steps[:-1], data), data)
    inside = f" inside `{group}`" if group else ""
    return InputError("", "nothing", expected, f"add the line {lines}{inside}" if lines else "add it")


def _kinds(steps: tuple[Step, ...], data: Any) -> list[tuple[str, Any, Any]]:
    """Of a group of several kinds each one: the key that names it, its name, and the kind where the key is left out."""
    place = place_of(steps, data)
    kinds = [kind_of(member) for member in place.members] if place and len(place.members) > 1 else []
    return [(key, word, default) for key, words, default in kinds for word in words]


def _possible(choices: list[str], steps: tuple[Step, ...], data: Any) -> list[str]:
    """Of the choices those that fit the rest of the sheet: a drive's commands are those that its joint can take."""
    match steps:
        case ["drives", int(index), "command"]:
            joints, name = at(data, "joints"), at(data, "drives", index, "joint")
            joint = next((one for one in joints if at(one, "name") == name), {}) if isinstance(joints, list) else {}
            has = {
                "motor": at(joint, "motor") is not None,
                "electric": at(joint, "motor", "resistance") is not None,
                "elastic": at(joint, "gear", "stiffness") not in (None, math.inf, ".inf"),
            }
            return [choice for choice in choices if not joint or command_issue(choice, **has) is None]
        case _:
            return choices


def _kind(steps: tuple[Step, ...], data: Any) -> Problem:
    """A group that does not say, or says wrongly, of which of several kinds it is."""
    place, value = place_of(steps, data), at(data, *steps)
    members = place.members if place else []
    kinds = [(key, str(kind)) for key, words, _ in map(kind_of, members) for kind in words]
    key, names = kinds[0][0] if kinds else "type", [kind for _, kind in kinds]
    if not isinstance(value, Mapping):
        return steps, InputError("", shown(value), place.expected if place else "a group", f"write `{key}: ...` in it")
    got = at(value, key)
    close = nearest(got, names) if isinstance(got, str) else None
    hint = f"did you mean `{close}`?" if close else "choose one of these" if got is not None else f"add `{key}: ...`"
    expected = f"one of {', '.join(names)}"
    return (*steps, key), InputError("", shown(got), expected, hint)


def _wrong(steps: tuple[Step, ...], kind: str, detail: ErrorDetails, data: Any) -> InputError:
    value, place = detail["input"], place_of(steps, data)
    if place is None or not steps:
        expected = f"a group with the keys {', '.join(keys(root_of(data).annotation))}" if not steps else detail["msg"]
        return InputError("", shown(value), expected, "compare it with a published robot")
    bounds = {} if place.extra.get("span") else detail.get("ctx", {})
    if kind == "arithmetic" and bounds:
        zero = "zero, or " if bounds["smallest"] == LEAST else ""
        expected = f"{zero}a magnitude from {bounds['smallest']:g} to {bounds['largest']:g} [{place.unit}]"
        rigid = "; .inf makes it rigid" if place.may_be_infinite else ""
        return InputError("", shown(value), expected, f"correct the exponent or the unit{rigid}")
    if LARGEST in (abs(bound) for bound in bounds.values() if isinstance(bound, float)):
        expected = f"{place.expected} of a magnitude of at most {LARGEST:g}"
        return InputError("", shown(value), expected, "correct the exponent or the unit")
    shorthand = SHORTHANDS.get(str(steps[-1]), {}).get("type") if any(map(is_group, place.members)) else None
    expected = f"a {'whole ' * (shorthand == 'integer')}number, or {place.expected}" if shorthand else place.expected
    return InputError("", shown(value), expected, _hint(place, value, str(steps[-1])))


def _as_group(place: ChainPlace, key: str, value: Any) -> str:
    """How a group is written where something else stands: what was given may be the one key that it must have."""
    needed = [name for name, info in fields(place.members[0]).items() if info.is_required()]
    if len(needed) == 1 and isinstance(value, str):
        return f"write `{key}: {{{needed[0]}: {value[:40]}}}`"
    return "write its keys below it, each in a line"


def _hint(place: ChainPlace, value: Any, key: str) -> str:
    """How a value of the right kind or of the wrong one is put right."""
    known = place.choices
    close = nearest(value, known) if isinstance(value, str) else None
    hints = (
        (place.unit is not None, _of_numbers(place, value)),
        (close is not None, f"did you mean `{close}`?"),
        (any(map(is_group, place.members)), _as_group(place, key, value)),
        (isinstance(value, Mapping) and get_origin(place.members[0]) is tuple, _FIRST_ITEM),
        (bool(known), "choose one of these"),
    )
    return next((hint for fits, hint in hints if fits), f"write {place.expected}")


_FIRST_ITEM = "write a list: begin the first line of each item with `- `"


def _of_numbers(place: ChainPlace, value: Any) -> str:
    if place.expected.startswith("a list") and not isinstance(value, list):
        return AS_LIST
    plain = isinstance(value, (int, float)) and not isinstance(value, bool)
    return "check sign, size and unit" if plain else "write numbers, each alone or with its unit in quotes"
