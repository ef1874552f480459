"""From values of parameters to numbers of the robot's sheet: which paths each parameter sets or multiplies."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.errors import InputError, InputErrors
from tmodes.io.sheet_check import sheet_data
from tmodes.io.sheet_fields import place_of
from tmodes.io.sheet_groups import is_grouped, path_of, real_entry, single_changes
from tmodes.io.sheet_paths import steps_of
from tmodes.io.sheet_words import at
from tmodes.sheet import Robot

__all__ = ["Group", "Target", "groups_of", "target_of"]

Array = NDArray[np.float64]

_REAL = "real:"


@dataclass(frozen=True)
class Target:
    """What a parameter with a path acts on: single ``paths``, set to its values or multiplied by them.

    ``unit`` of its values and its ``nominal`` value, None where the sheet leaves the number out. ``alone``: what it
    sets cannot differ between the cases of one batch.
    """

    paths: tuple[str, ...]
    multiplies: bool
    unit: str
    nominal: float | None
    alone: bool = False


def target_of(path: str, data: Mapping[str, Any], *, relative: bool) -> Target:
    """What a path of a robot's complete plain data stands for.

    Raises :class:`tmodes.errors.InputError` for a path that does not exist or holds no number.
    """
    if is_grouped(path):
        if relative:
            hint = "leave `relative` out: the values at this path are factors already"
            raise InputError(path, "a relative factor", "a path of one number where `relative` is true", hint)
        if path.startswith(_REAL):
            changed = tuple(single_changes(path, 1.0, data))
            return Target(changed, False, "-", real_entry(data, changed[0].removeprefix("real."))[1])
        return Target(tuple(single_changes(path, 1.0, data)), True, "-", 1.0)
    steps = steps_of(path, data)
    place = place_of(steps, data)
    value = _number(at(data, *steps))
    if place is None or place.unit is None:
        expected, hint = "the path of a number", "take `choices` for words: each entry names what it sets"
        raise InputError(path, "a path that holds no number", expected, hint)
    several = isinstance(at(data, *steps), (list, dict)) and value is None
    if value is None and relative and not several:
        got, hint = "a number that the sheet leaves out", "write it in the sheet, or values without `relative`"
        raise InputError(path, got, "the path of a number of the sheet", hint)
    own = path_of(steps, data)
    alone = own.partition(".")[0] == "integration"
    if relative:
        each = tuple(single_changes(f"{own}.*", 1.0, data)) if several else (own,)
        return Target(each, True, "-", 1.0, alone)
    return Target((own,), False, place.unit, 1.0 if value is None and own.startswith("real.") else value, alone)


def _number(value: Any) -> float | None:
    """The one number of a value; of a list the number that all of it are."""
    if isinstance(value, (list, tuple)) and value and all(one == value[0] for one in value):
        return _number(value[0])
    if isinstance(value, (int, float)) and not isinstance(value, bool):
        return float(value)
    return None


@dataclass(frozen=True, eq=False)
class Group:
    """Cases that share a robot: their ``places`` (m,) among all, ``vary`` (m,) by path.

    ``kind``: the values of the parameters that cannot differ between them.
    """

    places: NDArray[np.intp]
    robot: Robot | None
    vary: Mapping[str, Array]
    kind: tuple[float, ...] = ()
    wrong: str = field(default="")
    """Why there is no such robot."""


def groups_of(
    robot: Robot, names: Sequence[str], targets: Mapping[str, Target],
    choices: Mapping[str, Sequence[Mapping[str, Any]]], values: Array,
) -> Iterator[Group]:  # fmt: skip
    """Cases (m, d) by what they set that cannot differ in a batch: words, whole structures, settings of integration.

    ``choices``: what each entry sets, by the name of the parameter. Numbers that all entries of a choice set vary in
    arrays too; factors act on what the choices have set.
    """
    columns = {name: values[:, k] for k, name in enumerate(names)}
    arrays = {name: _numeric(entries) for name, entries in choices.items()}
    apart = [name for name in choices if not arrays[name]]
    apart += [name for name, target in targets.items() if target.alone]
    keys = np.column_stack([columns[name] for name in apart]) if apart else np.zeros((len(values), 0))
    kinds, which = np.unique(keys, axis=0, return_inverse=True)
    for k, kind in enumerate(kinds):
        places = np.flatnonzero(which.ravel() == k)
        own = {name: column[places] for name, column in columns.items()}
        base, changes = robot, {}
        for name, value in zip(apart, kind.tolist(), strict=True):
            changes |= (
                choices[name][int(value)]
                if name in choices
                else {targets[name].paths[0]: _scaled(value, robot, targets[name])}
            )
        try:
            base = robot.with_(changes) if changes else robot
            varied = _varied(base, own, targets, {n: arrays[n] for n in choices if n not in apart})
            yield Group(places, base, varied, tuple(kind.tolist()))
        except (InputError, InputErrors) as error:
            yield Group(places, None, {}, tuple(kind.tolist()), str(error))


def _numeric(entries: Sequence[Mapping[str, Any]]) -> dict[str, Array]:
    """Numbers (n,) by path, where all entries set those of paths that may differ in a batch; else nothing."""
    paths = entries[0].keys()
    plain = all(
        entry.keys() == paths and all(isinstance(value, float) for value in entry.values()) for entry in entries
    )
    if not plain or any(path.partition(".")[0] == "integration" or is_grouped(path) for path in paths):
        return {}
    return {path: np.array([entry[path] for entry in entries]) for path in paths}


def _scaled(value: float, robot: Robot, target: Target) -> float:
    """The value that a case sets at a path that is set for all of a batch."""
    known = _number(at(sheet_data(robot), *steps_of(target.paths[0], sheet_data(robot)))) if target.multiplies else 1.0
    found = value * (known or 0.0)
    return int(found) if found.is_integer() and abs(found) < 2**53 else found


def _varied(
    robot: Robot, own: Mapping[str, Array], targets: Mapping[str, Target], arrays: Mapping[str, Mapping[str, Array]]
) -> dict[str, Array]:
    """Numbers by path: what choices and parameters set, then what factors make of these or of the sheet's own."""
    data, vary = sheet_data(robot), {}
    for name, numbers in arrays.items():
        vary |= {path: values[own[name].astype(int)] for path, values in numbers.items()}
    varying = [(own[name], target) for name, target in targets.items() if not target.alone]
    for values, target in varying:
        if not target.multiplies:
            vary |= dict.fromkeys(target.paths, values)
    for values, target in varying:
        for path in target.paths if target.multiplies else ():
            around = vary.get(path.rpartition(".")[0])  # one number for a whole list
            known = vary.get(path, around if around is not None else _number(at(data, *steps_of(path, data))))
            vary[path] = values * known
    return vary
