"""The numbers of a data sheet as parameters: a robot whose numbers at some paths are noted, with its checks as guards.

The robot is lowered by the code of any other robot; what comes out are noted numbers, and from them a program.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from inspect import signature
from types import SimpleNamespace, UnionType
from typing import Annotated, Any, Union, get_args, get_origin

import annotated_types as bounds
from pydantic import BaseModel
from pydantic.fields import FieldInfo
from pydantic_core import PydanticCustomError

from tmodes.io.forms import follows
from tmodes.io.sheet_check import sheet_data
from tmodes.io.sheet_paths import steps_of
from tmodes.kinds.noted.functions import isfinite
from tmodes.kinds.noted.number import Noted, NotedTape, is_noted
from tmodes.sheet import Robot, RobotPair

__all__ = ["Structural", "bounds_of", "limits_of", "noted_pair"]

Steps = tuple[str | int, ...]

STRUCTURE = ("integration", "format")
"""Groups of a sheet that are no numbers of the robot."""


class Structural(Exception):
    """A path that is structure, or a robot that cannot be noted, with the reason in words."""


def limits_of(kind: Any, steps: Steps, own: Sequence[Any] = ()) -> list[Any]:
    """Bounds (of :mod:`annotated_types`) of what stands at ``steps`` in a value of a type."""
    if get_origin(kind) is Annotated:
        kind, *extra = get_args(kind)
        found = [one for each in extra for one in (each.metadata if isinstance(each, FieldInfo) else [each])]
        return limits_of(kind, steps, [*own, *found])
    arms = get_args(kind)
    if get_origin(kind) in (Union, UnionType):
        found = [limits_of(arm, steps, own) for arm in arms if arm is not type(None)]
        return max(found, key=len, default=[])
    if not steps:
        return [one for one in own if isinstance(one, (bounds.Gt, bounds.Ge, bounds.Lt, bounds.Le, bounds.Interval))]
    if get_origin(kind) is tuple and isinstance(steps[0], int):
        return limits_of(arms[0] if arms[-1] is Ellipsis else arms[steps[0]], steps[1:])
    return limits_of(arms[1], steps[1:]) if get_origin(kind) is dict else []


def bounds_of(robot: Robot, steps: Steps) -> tuple[float, float]:
    """The least and the largest value of the number at steps of a robot, as its type bounds it; infinite: no bound."""
    group: Any = robot
    limits: list[Any] = []
    for k, step in enumerate(steps):
        if isinstance(group, BaseModel) and str(step) in type(group).model_fields:
            info = type(group).model_fields[str(step)]
            limits = limits_of(info.annotation, steps[k + 1 :], info.metadata)
        group = _at(group, [step])
    low = [getattr(one, name) for one in limits for name in ("gt", "ge") if getattr(one, name, None) is not None]
    high = [getattr(one, name) for one in limits for name in ("lt", "le") if getattr(one, name, None) is not None]
    return float(max(low, default=-math.inf)), float(min(high, default=math.inf))


def _refuse_beyond(limits: Sequence[Any], value: Any) -> None:
    """Compare a number with its bounds, which notes them as guards."""
    asked = {"gt": lambda x, y: x > y, "ge": lambda x, y: x >= y, "lt": lambda x, y: x < y, "le": lambda x, y: x <= y}
    for one in limits:
        for name, holds in asked.items():
            limit = getattr(one, name, None)
            if limit is not None and not holds(value, limit):
                raise Structural("a number beyond its bounds")


Tree = dict[Any, Any]
"""What takes the place of numbers, by steps; an end is the number itself."""


def _tree(leaves: Mapping[Steps, Any]) -> Tree:
    tree: Tree = {}
    for steps, value in leaves.items():
        inner = tree
        for step in steps[:-1]:
            inner = inner.setdefault(step, {})
        inner[steps[-1]] = value
    return tree


def _replaced(value: Any, tree: Any) -> Any:
    if not isinstance(tree, dict):
        return tree
    if isinstance(value, tuple):
        return tuple(_replaced(item, tree[k]) if k in tree else item for k, item in enumerate(value))
    if isinstance(value, dict):
        return {key: _replaced(item, tree[key]) if key in tree else item for key, item in value.items()}
    if not isinstance(value, BaseModel):
        raise Structural("a path that leads to no number")
    return _changed_group(value, tree)


def _changed_group(group: BaseModel, tree: Tree) -> Any:
    """A group with other numbers: not read again, but checked by the same checks, which note what they ask."""
    made, kind = BaseModel.model_copy(group), type(group)
    fields = {name: getattr(group, name) for name in kind.model_fields}
    for name, inner in tree.items():
        fields[name] = _replaced(fields[name], inner)
        info = kind.model_fields[name]
        for steps, number in _ends(inner):
            _refuse_beyond(limits_of(info.annotation, steps, info.metadata), number)
    vars(made).clear()
    vars(made).update(fields)
    decorators = kind.__pydantic_decorators__
    for name, each in decorators.field_validators.items():
        if each.info.mode == "after":
            for field in tree:
                if "*" in each.info.fields or field in each.info.fields:
                    check = getattr(kind, name)
                    more = [SimpleNamespace(field_name=field, data=fields)] * (len(signature(check).parameters) - 1)
                    check(fields[field], *more)
    for name, each in decorators.model_validators.items():
        if each.info.mode == "after":
            getattr(made, name)()
    return made


def _ends(tree: Any, before: Steps = ()) -> Iterator[tuple[Steps, Any]]:
    if isinstance(tree, dict):
        for step, inner in tree.items():
            yield from _ends(inner, (*before, step))
    else:
        yield before, tree


def _at(value: Any, steps: Sequence[str | int]) -> Any:
    """What stands at steps of a robot; None where nothing does."""
    for step in steps:
        if isinstance(value, tuple):
            value = value[int(step)]
        else:
            value = value.get(step) if isinstance(value, dict) else getattr(value, str(step), None)
    return value


def _leaves(value: Any, number: float, here: Any, steps: Steps) -> Iterator[tuple[Steps, Any]]:
    """The places of a value that are a ``number``, or its negative, each with what stands there: ``here`` or -here.

    A sheet takes one number in place of equal ones of a list, or of gravity downwards.
    """
    for place, own in _ends_of_value(value, steps):
        if own == number:
            yield place, here
        elif own == -number:
            yield place, -here


def noted_pair(robot: Robot, values: Mapping[str, float], tape: NotedTape) -> tuple[RobotPair, dict[str, Noted]]:
    """The robot, which has these values at their paths, as known and as it really is, with noted numbers there.

    Paths that are structure are not among the numbers, by path, that are returned. Raises :class:`Structural` where a
    check of the sheet cannot be followed.
    """
    data, leaves, inputs = sheet_data(robot), dict[Steps, Any](), dict[str, Noted]()
    for path, value in values.items():
        steps, number = tuple(steps_of(path, data)), tape.input(value, path)
        found = {} if steps[0] in STRUCTURE else dict(_leaves(_at(robot, steps), value, number, steps))
        if found and not (value == 0.0 and len(found) > 1):
            leaves |= found
            inputs[path] = number
    try:
        known = _changed(robot, leaves)
        real = _real(robot, known, leaves, data) if robot.real else known
    except PydanticCustomError as error:
        raise Structural(str(error)) from error
    if real is not known:
        vars(real)["nominal"] = known
    return RobotPair(known, real), inputs


def _changed(robot: Robot, leaves: Mapping[Steps, Any]) -> Robot:
    """The robot with other numbers, in another format's robot with those that follow from them."""
    return _replaced(robot, _tree({**leaves, **follows(robot, leaves)}))


def _real(robot: Robot, known: Robot, leaves: Mapping[Steps, Any], data: Any) -> Robot:
    """The robot as it really is: numbers at the paths of ``real`` times their factors."""
    real, found = robot.pair().real, {steps: value for steps, value in leaves.items() if steps[0] != "real"}
    for path, factor in known.real.items():
        steps = tuple(steps_of(path, data))
        ends = dict(_ends_of_value(_at(robot, steps), steps))
        if is_noted(factor) and not (ends and factor):
            raise Structural(f"`real.{path}` is a factor on numbers that are not in the sheet")
        for place, plain in ends.items():
            number = found.get(place, plain) * factor
            if is_noted(number) or place in found:
                found[place] = number
    return _changed(real, found)


def _ends_of_value(value: Any, steps: Steps) -> Iterator[tuple[Steps, float]]:
    if isinstance(value, float) and isfinite(value):
        yield steps, value
    elif isinstance(value, tuple):
        for k, item in enumerate(value):
            yield from _ends_of_value(item, (*steps, k))
    elif isinstance(value, BaseModel):
        for name in type(value).model_fields:
            yield from _ends_of_value(getattr(value, name), (*steps, name))
