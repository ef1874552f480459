"""From plain data to a checked Robot; all that is wrong is told in one go, each with its line."""

from __future__ import annotations

import copy
import math
from collections.abc import Iterator, Mapping
from typing import Any

from pydantic import ValidationError

from tmodes.errors import InputError, InputErrors
from tmodes.io.fields import Place, number_paths, place_at
from tmodes.io.paths import set_paths
from tmodes.io.problems import problems
from tmodes.io.units import NotANumber, number
from tmodes.io.words import nearest, shown
from tmodes.io.yaml_file import nearest_line
from tmodes.paper.sheet import FORMAT, PaperRobot

__all__ = ["changed_robot", "robot_from_data"]

MOST_ERRORS = 100


def robot_from_data(data: Any, positions: Mapping[str, int] | None = None, source: str = "") -> PaperRobot:
    """The checked robot of plain data (maps, lists and scalars, as a YAML file holds them).

    ``positions`` gives the line of each dotted path and ``source`` the name of the file, for messages. Numbers may be
    text with a unit. Raises :class:`tmodes.errors.InputErrors` that holds every wrong value.
    """
    positions = positions or {}
    if wrong_format := list(_other_format(data)):
        raise _located(wrong_format, positions, source)
    plain = copy.deepcopy(data)
    wrong = {error.which: error for error in [*_read_numbers(plain), *_wrong_factors(plain)]}
    try:
        robot = PaperRobot.model_validate(plain)
    except ValidationError as error:
        info = problems(error)
        raise _located([*wrong.values(), *(one for one in info if one.which not in wrong)], positions, source) from None
    if info := list(wrong.values()) or list(_wrong_real(robot)):
        raise _located(info, positions, source)
    return robot


def changed_robot(data: Mapping[str, Any], changes: Mapping[str, Any]) -> PaperRobot:
    """The checked robot of plain data with changes by dotted path; see :func:`tmodes.io.paths.set_paths`."""
    return robot_from_data(set_paths(data, changes))


def _other_format(data: Any) -> Iterator[InputError]:
    """A sheet of another version is not read any further: its keys may mean something else."""
    if not isinstance(data, Mapping) or "format" not in data:
        return
    version, hint = data["format"], f"write `format: {FORMAT}`"
    if type(version) is not int:
        yield InputError("format", shown(version), f"the number {FORMAT}", hint)
    elif version > FORMAT:
        yield InputError("format", f"{shown(version)}, newer than this program", f"at most {FORMAT}", "update tmodes")
    elif version < FORMAT:
        yield InputError("format", shown(version), f"the number {FORMAT}, the first format there is", hint)


def _read_numbers(data: Any, path: str = "") -> Iterator[InputError]:
    """Put plain numbers in place of text with units, where numbers belong; tell those that are none."""
    items = data.items() if isinstance(data, dict) else enumerate(data) if isinstance(data, list) else ()
    for key, value in list(items):
        here = f"{path}.{key}" if path else f"{key}"
        place = place_at(here)
        if place is None or place.unit is None:
            yield from _read_numbers(value, here)
            continue
        try:
            data[key] = _read_number(value, place)
        except NotANumber as error:
            yield InputError(here, error.got, place.expected, error.hint)


def _read_number(value: Any, place: Place) -> float:
    result = number(value, place.unit or "-")
    if math.isinf(result) and not (place.may_be_infinite and result > 0):
        hint = "write a finite number" + ("; .inf makes it rigid" if place.may_be_infinite else "")
        raise NotANumber(f"the infinite number {shown(result)}", hint)
    if place.annotation is int and result.is_integer():
        return int(result)
    return result


def _wrong_factors(data: Any) -> Iterator[InputError]:
    """Entries of ``real`` that name no number of the plant."""
    real = data.get("real") if isinstance(data, dict) else None
    for path in real if isinstance(real, dict) else ():
        if path not in number_paths():
            close = nearest(str(path), number_paths())
            hint = f"did you mean `{close}`?" if close else f"name a number, such as `{number_paths()[-1]}`"
            expected = "the path of a number of the motor, gear, link, payload, environment, controller, or gravity"
            yield InputError(f"real.{path}", "a path that names no number", expected, hint)


def _wrong_real(robot: PaperRobot) -> Iterator[InputError]:
    """Products of known values and factors that no robot may have."""
    known = dict(robot.numbers())
    try:
        robot.pair()
    except InputErrors as errors:
        for error in errors.errors:
            factor = robot.real[error.which]
            got = f"{shown(factor)} times {shown(known[error.which])}"
            yield InputError(f"real.{error.which}", got, error.expected, f"change the factor: {error.hint}")


def _located(errors: list[InputError], positions: Mapping[str, int], source: str) -> InputErrors:
    """The errors in the order of the file, each with its place."""
    lines = {id(error): nearest_line(error.which, positions) for error in errors}
    errors = sorted(errors, key=lambda error: lines[id(error)])
    if len(errors) > MOST_ERRORS:
        got, hint = f"{len(errors)} wrong values", f"correct the first {MOST_ERRORS}, which are listed"
        errors = [*errors[:MOST_ERRORS], InputError("the file", got, "a data sheet of this format", hint)]
    for error in errors:
        line = lines.get(id(error), 0)
        error.where = f"{source}:{line}" if source and line else source
    return InputErrors(errors)
