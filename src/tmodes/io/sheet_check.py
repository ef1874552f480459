"""From plain data to a checked Robot; everything that is wrong is reported together, each with its line."""

from __future__ import annotations

import copy
import math
from collections import ChainMap
from collections.abc import Collection, Iterator, Mapping
from itertools import groupby, islice
from typing import Any

from tmodes.errors import InputError, InputErrors
from tmodes.io.checked_sheet import checked_sheet, located
from tmodes.io.filipovic2010.importer import robot_data
from tmodes.io.forms import F2010, ROBOT, form_of, own_path, with_reach
from tmodes.io.sheet_fields import ChainPlace, place_of
from tmodes.io.sheet_groups import is_grouped, single_changes
from tmodes.io.sheet_paths import changed_places, entered, steps_of
from tmodes.io.sheet_problems import MOST_REPORTED, Problem
from tmodes.io.sheet_words import at
from tmodes.io.words import shown
from tmodes.sheet import Robot

__all__ = ["changed_robot", "real_robot", "sheet_data", "sheet_from_data"]

_LEFT_OUT = "a number that the sheet leaves out"


def sheet_from_data(
    data: Any, positions: Mapping[str, int] | None = None, source: str = "", changed: Collection[str] = ("",)
) -> Robot:
    """The checked robot of plain data (maps, lists and scalars, as a YAML file holds them).

    ``positions``: the line of each dotted path; ``source``: the name of the file, for messages. Numbers may be text
    with a unit; in data of a robot only those at the ``changed`` places (:func:`tmodes.io.sheet_paths.changed_places`)
    are not read yet. Raises :class:`tmodes.errors.InputErrors` that holds every wrong value.
    """
    form = form_of(data)
    if form not in (ROBOT, F2010):
        hint = f"give a robot; this is a {form.name}"
        raise InputErrors([InputError("kind", shown(form.name), "the data sheet of a robot", hint, source)])
    further = _unknown_factors if form is F2010 else lambda plain: ()
    sheet = checked_sheet(data, positions, source, changed, further=further)
    robot = sheet if form is ROBOT else Robot.model_validate(robot_data(sheet.model_dump(mode="json")))
    if info := list(_wrong_real(robot)):
        raise located(info, data, positions or {}, source)
    return robot


def sheet_data(robot: Robot) -> dict[str, Any]:
    """The plain data of a robot: reading it gives the same robot."""
    return robot.model_dump(mode="json", by_alias=True, exclude_none=True)


def changed_robot(robot: Robot, changes: Mapping[str, Any]) -> Robot:
    """The checked robot with changes by path; see :mod:`tmodes.io.sheet_paths`, for groups :mod:`.sheet_groups`."""
    if not isinstance(changes, Mapping) or not any(map(is_grouped, changes)):
        return _changed(sheet_data(robot), changes)
    for grouped, part in groupby(changes.items(), lambda change: is_grouped(change[0])):
        for one in [[each] for each in part] if grouped else [[*part]]:
            data = sheet_data(robot)
            single = [single_changes(path, value, data) for path, value in one]
            robot = _changed(data, dict(ChainMap(*reversed(single))))
    return robot


def _changed(data: dict[str, Any], changes: Mapping[str, Any]) -> Robot:
    """The robot of a robot's data with changes."""
    changed, places = changed_places(data, changes)
    return sheet_from_data(changed, changed=places)


def real_robot(robot: Robot) -> Robot:
    """The robot as it really is: each number that ``real`` names times its factor.

    Raises :class:`tmodes.errors.InputErrors` for paths that name no number, and for numbers that no robot can have.
    """
    if not robot.real:
        return robot
    data, wrong = {**sheet_data(robot), "real": {}}, []
    for path, factor in robot.real.items():
        try:
            inner, key = _factored(data, path)
            inner[key] = _scaled(inner[key], factor)
        except InputError as error:
            wrong.append(InputError(f"real.{path}", error.got, error.expected, _of_real(error.hint)))
    if wrong:
        raise InputErrors(wrong)
    return sheet_from_data(with_reach(sheet_data(robot), data))


def _unknown_factors(data: Any) -> Iterator[Problem]:
    """Entries of ``real`` that name no number, before the sheet becomes a robot."""
    real = data.get("real") if isinstance(data, dict) else None
    others = {key: value for key, value in copy.deepcopy(data).items() if key != "real"} if real else {}
    for path in islice(real, MOST_REPORTED) if isinstance(real, dict) else ():
        try:
            _factored(others, str(path))
        except InputError as error:
            if error.got != _LEFT_OUT:  # that number is reported itself
                yield ("real", path), InputError("", error.got, error.expected, _of_real(error.hint))


def _of_real(hint: str) -> str:
    """The hint of a path, as that of a factor on what stands there."""
    return hint.replace("did you mean `", "did you mean `real.")


def _factored(data: dict[str, Any], path: str) -> tuple[Any, Any]:
    """Where a number stands that ``real`` may name: its group or list, and its key."""
    steps = steps_of(path, data)
    key: Any = steps[-1]
    inner = entered(data, steps[:-1], path)
    place = place_of(steps, data)
    factored = form_of(data).factored
    if steps[0] not in factored or place is None or not _is_number(place, at(inner, key)):
        expected = f"the path of a number of {', '.join(factored)}"
        raise InputError(path, "a path that names no number", expected, "name a number of the sheet")
    if at(inner, key) is None:
        raise InputError(path, _LEFT_OUT, "the path of a number that the sheet has", "write the number")
    return inner, key


def _is_number(place: ChainPlace, value: Any) -> bool:
    """Whether a factor may stand here: at a number, or at the entries of an inertia."""
    if place.unit is not None:
        return not place.whole
    return isinstance(value, dict) and {"xx", "yy", "zz"} <= value.keys()


def _scaled(value: Any, factor: float) -> Any:
    if isinstance(value, list):
        return [_scaled(item, factor) for item in value]
    if isinstance(value, dict):
        return {key: _scaled(item, factor) for key, item in value.items()}
    known = float(value)  # infinite ones are text in plain data
    return known if math.isinf(known) and factor else known * factor if factor else 0.0


def _wrong_real(robot: Robot) -> Iterator[Problem]:
    try:
        real_robot(robot)
    except InputErrors as errors:
        for error in errors.errors:
            path = own_path(error.which.removeprefix("real."), sheet_data(robot))
            named = next((name for name in robot.real if path == name or path.startswith(f"{name}.")), None)
            if named is not None:
                got = error.got if error.which.startswith("real.") else _product(robot, named, error.got)
                yield ("real", named), InputError("", got, error.expected, error.hint)
            else:
                got = f"factors that make {path} {error.got}"
                yield ("real",), InputError("", got, error.expected, f"change the factor: {error.hint}")


def _product(robot: Robot, path: str, got: str) -> str:
    """A factor and the number that it is on."""
    inner, key = _factored(sheet_data(robot), path)
    known = inner[key][0] if isinstance(inner[key], list) and len(inner[key]) == 1 else inner[key]
    info = f"{shown(robot.real[path])} times "
    return info + (f"the known value, {got}" if isinstance(known, (dict, list)) else shown(float(known)))
