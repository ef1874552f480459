"""What can be varied of a robot: every number of its sheet with unit and bounds, and what of a run it enters."""

from __future__ import annotations

import math
from typing import NamedTuple

from tmodes.io.printed import Table, shortened, table_html
from tmodes.io.sheet_check import sheet_data
from tmodes.io.sheet_fields import quantities
from tmodes.io.sheet_groups import path_of
from tmodes.model.parameters import bounds_of
from tmodes.sheet import Robot
from tmodes.sheet.robot import refuse_other
from tmodes.simulation.plan import Follow
from tmodes.simulation.vary.cases import run_blocks
from tmodes.simulation.vary.programs import case_program

__all__ = ["Parameters", "RobotParameter", "parameters_of"]


class RobotParameter(NamedTuple):
    """A number of a sheet: its ``path``, ``value``, ``unit``, and bounds (infinite where there are none).

    ``enters``: the blocks of numbers of a run that depend on it: ``parameters`` (of the closed loop), ``rest`` (of its
    rest with held motors), ``chain`` (of the robot without drives), ``base``, ``held``, ``start``, and ``signal k``.
    ``is_structure``: another value needs other code (a count, a rigid stiffness, a sample time, settings); where
    gains are designed, as of ``lqr``, every number is: they are designed again for each value.
    """

    path: str
    value: float
    unit: str
    low: float
    high: float
    enters: tuple[str, ...]
    is_structure: bool


class Parameters(tuple[RobotParameter, ...]):
    """Numbers of a sheet, in its order; ``table()`` has them as texts, as ``tmodes parameters`` prints them."""

    __slots__ = ()

    def table(self) -> Table:
        """Path, value, unit, bounds, and what each enters."""
        rows = [
            [one.path, f"{one.value:g}", one.unit, _bound(one.low), _bound(one.high),
             "structure" if one.is_structure else ", ".join(one.enters) or "nothing at this value"]
            for one in self
        ]  # fmt: skip
        return Table(f"{len(self)} parameters", ["path", "value", "unit", "low", "high", "enters"], rows)

    def __repr__(self) -> str:
        return shortened([self.table()], "print them with .table()")

    def _repr_html_(self) -> str:
        return table_html(self.table())


def _bound(value: float) -> str:
    return f"{value:g}" if math.isfinite(value) else "-"


def parameters_of(robot: Robot) -> Parameters:
    """Every number of a robot's sheet, in its order, as ``tmodes parameters``.

    Raises :class:`tmodes.errors.InputError` for what is no robot, and :class:`tmodes.model.parameters.Structural` where
    a user's kind lowers its numbers so that it cannot be followed.

    >>> found = tmodes.parameters(tmodes.load("spong1987"))
    >>> next((one.unit, one.low) for one in found if one.path == "joints.joint.gear.stiffness.0")
    ('N*m/rad', 0.0)
    """
    refuse_other(robot)
    data = sheet_data(robot)
    known = {
        path_of(steps, data): (float(item), steps, place.unit or "")
        for inner, key, steps, place in quantities(data)
        if isinstance(item := inner[key], (int, float, str)) and not isinstance(item, bool) and _is_number(item)
    }
    free = {path: value for path, (value, _, _) in known.items() if math.isfinite(value)}
    enters: dict[str, list[str]] = {}
    designed = any(one.block.is_designed for one in robot.control)
    made = (
        []
        if designed
        else [case_program(robot, free, lambda pair: pair.real, lambda one: run_blocks(one, Follow.SHEET))]
    )
    for program, name in ((one, name) for one in made for name in one.places):
        block = f"signal {name.split()[1]}" if " " in name else "rest" if name == "rest_row" else name
        for path in program.acting(name):
            if block not in enters.setdefault(path, []):
                enters[path].append(block)
    return Parameters(
        RobotParameter(
            path,
            value,
            unit,
            *bounds_of(robot, steps),
            tuple(enters.get(path, ())),
            not any(path in one.paths for one in made),
        )
        for path, (value, steps, unit) in known.items()
    )


def _is_number(item: float | str) -> bool:
    try:
        float(item)
    except ValueError:
        return False
    return True
