"""From plain data of any form of sheet to its checked group; all that is wrong together, each with its line."""

from __future__ import annotations

import copy
import math
import re
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from itertools import islice
from typing import Any

from pydantic import ValidationError

from tmodes.errors import InputError, InputErrors
from tmodes.io.filipovic2010.format import PLANT
from tmodes.io.forms import F2010, SheetForm, form_of, own_path
from tmodes.io.sheet_fields import ChainPlace, Step, named, place_of, quantities
from tmodes.io.sheet_problems import AS_LIST, MOST_REPORTED, SHEET, Problem, sheet_problems
from tmodes.io.sheet_words import at
from tmodes.io.units import NotANumber, number
from tmodes.io.words import shown
from tmodes.io.yaml_file import nearest_line

__all__ = ["checked_sheet", "located"]

MOST_ERRORS, MOST_DEPTH = 100, 40
MOST_VALUES = 200_000
"""Largest number of values in the plain data of a robot."""


FEW = 1
"""Groups of the 2010 robot up to which a sheet without `kind` is none of it."""

OTHER_KEYS = {
    "rows": "write `kind: dh` for a Denavit-Hartenberg table",
    "mjcf": "read the MJCF by itself; an elasticity file lays over a URDF or xacro (`urdf: FILE`) alone",
    "sdf": "give the URDF or xacro that it was made from (`urdf: FILE`)",
    "xacro": "write `urdf: FILE` for a xacro, too",
}
"""Keys of no sheet that tell what was meant, and what to do."""


def checked_sheet(
    data: Any,
    positions: Mapping[str, int] | None = None,
    source: str = "",
    changed: Collection[str] = ("",),
    *,
    most: int = MOST_VALUES,
    further: Callable[[Any], Iterable[Problem]] = lambda plain: (),
) -> Any:
    """The group that plain data (maps, lists and scalars) stand for, by the form that they have.

    ``positions``: the line of each dotted path; ``source``: the name of the file, for messages; only at the ``changed``
    places numbers may be text. ``most``: values that the data may hold; ``further``: what else is wrong with it.
    Raises :class:`tmodes.errors.InputErrors` that holds every wrong value.
    """
    positions = positions or {}
    _refuse_huge(data, source, most)
    form = form_of(data)
    if wrong := list(_other_format(data, form)):
        raise located(wrong, data, positions, source)
    plain = copy.deepcopy(data)
    found = dict(islice(_read_numbers(plain, changed), MOST_REPORTED))
    refused: Any = (None, ())
    sheet, wrong = _checked(form, plain, data, list(further(plain))) if len(found) < MOST_REPORTED else refused
    if found := {**dict(wrong), **found}:
        raise located(list(found.items()), data, positions, source)
    return sheet


def _checked(form: SheetForm, plain: Any, data: Any, wrong: list[Problem]) -> tuple[Any, list[Problem]]:
    """The sheet; and what the form's type refuses, after what is ``wrong`` already."""
    try:
        return form.root.model_validate(plain), wrong
    except ValidationError as error:
        return None, wrong + [(steps, _as_typed(one, steps, data)) for steps, one in sheet_problems(error, plain)]


def _refuse_huge(data: Any, source: str, most_values: int) -> None:
    """Bounded before anything is copied."""
    count, waiting = 0, [(data, 0)]
    while waiting:
        value, depth = waiting.pop()
        count += 1
        for size, most, what in ((count, most_values, "values"), (depth, MOST_DEPTH, "levels")):
            if size > most:
                got, hint = f"more than {most} {what}", "check that this is a data sheet"
                raise InputErrors([InputError(SHEET, got, f"at most {most}", hint, source)])
        inner = value.values() if isinstance(value, dict) else value if isinstance(value, (list, tuple)) else ()
        waiting.extend((item, depth + 1) for item in inner)


def _other_format(data: Any, form: SheetForm) -> Iterator[Problem]:
    """A sheet of another version is not read any further: its keys may mean something else."""
    if not isinstance(data, Mapping):
        yield (), InputError("", shown(data), "keys and values, such as `kind: arm`", "see a published arm")
        return
    if other := next((key for key in OTHER_KEYS if key in data), None):
        yield (
            (other,),
            InputError("", f"the key `{other}` of no sheet", "a sheet of joints and links", OTHER_KEYS[other]),
        )
    elif form is F2010 and len(data.keys() & {*PLANT}) <= FEW:
        named = ", ".join(f"`{shown(key)[1:-1]}`" for key in islice(data, 6)) or "nothing"
        got = f"a sheet without `kind`, with the keys {named}"
        hint = "write `kind: arm` with its joints and links, or `urdf: FILE` for what bends in a URDF"
        yield ("kind",), InputError("", got, "arm, dh, elasticity or study", hint)
    elif "format" in data:
        version, hint = data["format"], f"write `format: {form.version}`"
        if type(version) is not int or version < form.version:
            yield ("format",), InputError("", shown(version), f"the number {form.version}", hint)
        elif version > form.version:
            got = f"{shown(version)}, newer than this program"
            yield ("format",), InputError("", got, f"at most {form.version}", "update tmodes")


def _read_numbers(data: Any, places: Collection[str]) -> Iterator[Problem]:
    """Put plain numbers in place of text with units, where numbers belong; an issue for each that is none."""
    for container, key, steps, place in quantities(data, places):
        try:
            container[key] = _read_number(container[key], place)
        except NotANumber as error:
            yield steps, InputError("", error.got, place.expected, _hint(container[key], place) or error.hint)


_AXIS = re.compile(r"([-+]?)([xyzXYZ])")


def _hint(value: Any, place: ChainPlace) -> str:
    """How to write what was given in words where numbers belong; empty where its own error says it."""
    listed = place.expected.startswith("a list")
    if listed and isinstance(value, str) and (axis := _AXIS.fullmatch(value.strip())):
        numbers = [0, 0, 0]
        numbers["xyz".index(axis[2].lower())] = -1 if axis[1] == "-" else 1
        return f"write {numbers}"
    if listed and isinstance(value, str | list) and str(value).count(",") > 1:
        return AS_LIST
    return "write .inf" if place.may_be_infinite and str(value).strip().lower() in _RIGID else ""


_RIGID = ("rigid", "infinite", "stiff", "none", "∞")


def _read_number(value: Any, place: ChainPlace) -> float:
    result = number(value, place.unit or "-")
    if math.isinf(result) and not (place.may_be_infinite and result > 0):
        hint = "write a finite number" + ("; .inf makes it rigid" if place.may_be_infinite else "")
        raise NotANumber(f"the infinite number {shown(result)}", hint)
    return int(result) if result.is_integer() and int in place.members else result


def _as_typed(error: InputError, steps: tuple[Step, ...], data: Any) -> InputError:
    """A number that was refused, shown as it stands in the file: with its own unit."""
    place, value = place_of(steps, data), at(data, *steps)
    if isinstance(value, str) and place and place.unit is not None and error.got != shown(value):
        error.got = f"{shown(value)}, which is {error.got} {place.unit}"
    return error


def located(info: list[Problem], data: Any, positions: Mapping[str, int], source: str) -> InputErrors:
    """The errors in the order of the file, each with its place, and with names in its path."""
    lines = {id(error): nearest_line(".".join(map(str, steps)), positions) for steps, error in info}
    for steps, error in info:
        error.which = own_path(named(steps, data), data) or SHEET
        line = lines[id(error)]
        error.where = f"{source}:{line}" if source and line else source
    errors = [error for _, error in sorted(info, key=lambda one: lines[id(one[1])])]
    if len(errors) > MOST_ERRORS:
        got, hint = f"more than {MOST_ERRORS} wrong values", f"correct the first {MOST_ERRORS}, which are listed"
        errors = [*errors[:MOST_ERRORS], InputError("the file", got, "a data sheet of this format", hint, source)]
    return InputErrors(errors)
