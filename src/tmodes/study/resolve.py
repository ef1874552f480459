"""What a study's names stand for in its robot: units of its parameters, what choices set, cases by names of choices."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import Any

from tmodes.errors import InputError
from tmodes.io.sheet_check import sheet_data
from tmodes.io.sheet_fields import place_of
from tmodes.io.sheet_groups import is_grouped, path_of
from tmodes.io.sheet_paths import steps_of
from tmodes.io.sheet_problems import Problem
from tmodes.io.units import NotANumber, number
from tmodes.io.words import meant, shown
from tmodes.sheet import Robot
from tmodes.study.mapping import target_of
from tmodes.study.plain_data import CsvTable, Shorthands

__all__ = ["resolved_parameters", "resolved_plan", "words_of_path"]

_STANDS_IN = {"type": "uniform", "low": 0.0, "high": 1.0}
"""In place of a distribution whose unit is not known, because its path is wrong."""


def _no_robot(path: str = "") -> InputError:
    return InputError(path, "a path without a robot", "left out without a robot", "name the robot: `robot: NAME`")


def resolved_parameters(plain: dict[str, Any], robot: Robot | None, found: Shorthands) -> list[Problem]:
    """Give each parameter in plain data its unit and its choices their numbers; what is wrong with their paths."""
    groups = plain.get("parameters")
    if not isinstance(groups, Mapping):
        return []
    data = None if robot is None else sheet_data(robot)
    problems: list[Problem] = []
    taken: dict[str, str] = {}
    for name, group in groups.items():
        if isinstance(group, dict):
            problems += _parameter(name, group, robot, data, taken)
            problems += _choices(name, group, data, found)
            _sampled(name, group.get("distribution"), str(group.get("unit", "-")), found)
    return problems


def _parameter(
    name: str, group: dict[str, Any], robot: Robot | None, data: Any, taken: dict[str, str]
) -> Iterator[Problem]:
    path, here = group.get("path"), ("parameters", name)
    if not isinstance(path, str):
        return
    if robot is None:
        group["distribution"] = _STANDS_IN
        yield (*here, "path"), _no_robot()
        return
    try:
        robot.commanded(vary=[path])
        target = target_of(path, data, relative=group.get("relative") is True)
    except InputError as error:
        group["distribution"] = _STANDS_IN
        yield (*here, "path"), InputError("", *words_of_path(error))
        return
    for own in target.paths if not target.multiplies else ():
        if own in taken:
            got = f"{own}, which `{taken[own]}` sets already"
            yield (*here, "path"), InputError("", got, "a path of its own", "remove one, or make it `relative: true`")
        taken[own] = name
    unit = group.setdefault("unit", target.unit)
    if unit != target.unit:
        group["distribution"] = _STANDS_IN
        hint = f"remove it; write numbers in {target.unit}, or text such as '1.5 {unit}'"
        yield (*here, "unit"), InputError("", shown(unit), f"{target.unit}, that of the path", hint)


def words_of_path(error: InputError) -> tuple[str, str, str]:
    """What is wrong at a path, as the value of a key: got, expected, hint."""
    got = f"the unknown path {error.which!r}" if error.got.startswith("an unknown") else error.got
    return got, error.expected, error.hint


def _choices(name: str, group: dict[str, Any], data: Any, found: Shorthands) -> Iterator[Problem]:
    """Numbers and paths of what the choices set, as the robot's sheet has them."""
    choices, place = group.get("choices"), f"parameters.{name}.choices"
    if not isinstance(choices, list):
        return
    table, known = found.filled.get(place), {}
    group["choices"] = copied = [{**one} if isinstance(one, Mapping) else one for one in choices]
    for k, one in enumerate(copied):
        if not isinstance(one, dict) or not isinstance(one.get("set"), Mapping):
            continue
        own: dict[str, Any] = {}
        for path, value in one["set"].items():
            try:
                own |= _set(str(path), value, data, known)
            except InputError as error:
                yield from _kept(error, (*("parameters", name, "choices"), k, "set", path), table, k, found)
        one["set"] = own


def _kept(
    error: InputError, steps: tuple[Any, ...], table: CsvTable | None, row: int, found: Shorthands
) -> Iterator[Problem]:
    """An error of a table with its line there; any other as a problem of the study's file."""
    if table is None:
        yield steps, InputError("", error.got, error.expected, error.hint)
        return
    wrong_path = error.got.startswith("an unknown")
    line = 1 if wrong_path else table.lines[row]
    kept = InputError(error.which, error.got, error.expected, error.hint, f"{table.source}:{line}")
    if str(kept) not in map(str, found.errors):
        found.errors.append(kept)


def _set(path: str, value: Any, data: Any, known: dict[str, Any]) -> dict[str, Any]:
    """What one path of a choice sets, by its own path; raises InputError."""
    if data is None:
        raise _no_robot(path)
    if is_grouped(path):
        target_of(path, data, relative=False)
        return {path: _number(path, value, "-")}
    if path not in known:
        steps = steps_of(path, data)
        known[path] = path_of(steps, data), place_of(steps, data)
    own, place = known[path]
    if place is None or place.unit is None:
        if place is not None and place.choices and value not in place.choices:
            hint = meant(str(value), place.choices, "choose one of these")
            raise InputError(path, shown(value), place.expected, hint)
        return {own: value}
    found = _number(path, value, place.unit)
    return {own: int(found) if place.whole and found.is_integer() else found}


def _number(which: str, value: Any, unit: str) -> float:
    """The number in SI units; raises :class:`tmodes.errors.InputError`."""
    expected = "a number" if unit == "-" else f"a number in {unit}"
    try:
        found = number(value, unit)
    except NotANumber as error:
        raise InputError(which, error.got, expected, error.hint) from None
    if not math.isfinite(found):
        raise InputError(which, shown(found), "a finite number", "write a finite number")
    return found


def _sampled(name: str, group: Any, unit: str, found: Shorthands, place: str = "") -> None:
    """Numbers of a table in place of its cells, in the unit of the parameter."""
    place = place or f"parameters.{name}.distribution"
    if not isinstance(group, dict):
        return
    _sampled(name, group.get("distribution"), unit, found, f"{place}.distribution")
    if (table := found.filled.get(f"{place}.values")) is not None:
        group["values"] = [_cell(name, cell, unit, table, k, found) for k, cell in enumerate(group["values"])]


def _cell(which: str, cell: Any, unit: str, table: CsvTable, row: int, found: Shorthands) -> float:
    try:
        return _number(which, cell, unit)
    except InputError as error:
        found.errors.append(
            InputError(which, error.got, error.expected, error.hint, f"{table.source}:{table.lines[row]}")
        )
        return float(row)


def resolved_plan(plain: dict[str, Any], found: Shorthands) -> list[Problem]:
    """Numbers of choices in place of their names in written cases, and numbers in place of a table's cells."""
    plan, groups = plain.get("plan"), plain.get("parameters")
    if not isinstance(plan, dict) or not isinstance(groups, Mapping):
        return []
    problems = [*_named(plan, [*groups])]
    if not isinstance(plan.get("rows"), list):
        return problems
    table = found.filled.get("plan.rows")
    names = {
        name: [one.get("name") if isinstance(one, Mapping) else None for one in group["choices"]]
        for name, group in groups.items()
        if isinstance(group, Mapping) and isinstance(group.get("choices"), list)
    }
    units = {name: str(group.get("unit", "-")) for name, group in groups.items() if isinstance(group, Mapping)}
    plan["rows"] = rows = [{**row} if isinstance(row, Mapping) else row for row in plan["rows"]]
    for k, row in enumerate(rows):
        for name, value in row.items() if isinstance(row, dict) else ():
            try:
                if name in names and isinstance(value, str):
                    row[name] = _index(name, value, names[name])
                elif table is not None and name in units:
                    row[name] = _number(name, value, units[name])
            except InputError as error:
                row[name] = 0.0
                problems += _kept(error, ("plan", "rows", k, name), table, k, found)
    return problems


def _named(plan: Mapping[str, Any], names: list[str]) -> Iterator[Problem]:
    """Names of parameters in a grid that there are not, next to all else that is wrong with the study."""
    for field in ("levels_of", "points"):
        for name in plan[field] if isinstance(plan.get(field), Mapping) else ():
            if name not in names:
                hint = meant(str(name), names, "write the name of a parameter")
                yield ("plan", field, name), InputError("", "an unknown key", f"one of {', '.join(names)}", hint)


def _index(name: str, value: str, names: list[Any]) -> float:
    if value not in names:
        known = [str(each) for each in names]
        hint = meant(value, known, "write the name of an entry, or its number from 0")
        raise InputError(name, f"the unknown name {shown(value)}", f"one of {', '.join(known[:12])}", hint)
    return float(names.index(value))
