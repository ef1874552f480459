"""The rest of an arm as its data sheet states it: its loads and contact, its drives at their first command."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from tmodes.analysis.statics.equilibrium import Equilibrium, equilibrium
from tmodes.analysis.statics.loads import Load
from tmodes.analysis.statics.path import Progress
from tmodes.model.model import Model
from tmodes.sheet import Robot
from tmodes.sheet.parts import LoadFrame

__all__ = ["first_commands", "first_value", "robot_rest", "sheet_loads"]


def robot_rest(
    robot: Robot,
    loads: Sequence[Load] = (),
    *,
    model: Model | None = None,
    held: Mapping[str, float] | None = None,
    sheet: bool = True,
    contact: bool = True,
    progress: Progress = lambda stage, share: None,
) -> Equilibrium:
    """Static equilibrium of an arm under its weight, the loads of its data sheet at time 0 (``sheet``) and ``loads``.

    Driven coordinates are held at ``held``, else at their first command, else at the sheet's initial coordinates, else
    at 0; ``contact`` False leaves the sheet's contact out. One that was solved lately is taken again: a run, its modes
    and its page ask for the same. Errors as of :func:`equilibrium`.
    """
    model = model or Model(robot.chain())
    known = {name: value for name, value in robot.initial.coordinates.items() if name in model.coordinates}
    commands = first_commands(robot, model) | dict(held or {})
    acting = [*(sheet_loads(robot) if sheet else ()), *loads]
    touched = robot.contact if contact else None
    key = _key(model, acting, commands, known, touched)
    if key not in _solved:
        _solved[key] = equilibrium(model, acting, held=commands, start=known, contact=touched, progress=progress)
        while len(_solved) > _KEPT:
            _solved.popitem(last=False)
    return replace(_solved[key], model=model)  # whose points and rigid links may have other names


_solved: OrderedDict[Any, Equilibrium] = OrderedDict()
_KEPT = 8


def _key(
    model: Model, loads: Sequence[Load], held: Mapping[str, float], start: Mapping[str, float], contact: Any
) -> tuple[Any, ...]:
    """All that an equilibrium follows from: structure and numbers of the equations, and what acts."""
    structure = tuple(model.passes.schedule(name).key for name in ("inertia", "elastic"))
    numbers = model.parameters.tobytes(), model.at_rest().tobytes()
    acting = tuple((load.point, *load.wrench().tolist(), load.follows) for load in loads)
    touched = contact and (contact.fingerprint(), contact.model_dump_json())
    return structure, model.coordinates, numbers, acting, tuple(held.items()), tuple(start.items()), touched


def first_commands(robot: Robot, model: Model) -> dict[str, float]:
    """Coordinates whose position a drive commands, at time 0 [rad, m]; a motor's where its gear is elastic."""
    commands = {}
    for drive in robot.drives:
        if drive.command.is_motion:
            motor = f"{drive.joint}.motor"
            name = motor if motor in model.coordinates else drive.joint
            if name in model.coordinates:
                commands[name] = first_value(robot, drive.signal)
    return commands


def sheet_loads(robot: Robot) -> list[Load]:
    """The loads of a data sheet at time 0."""
    loads = []
    for load in robot.loads:
        factor = 1.0 if load.signal is None else first_value(robot, load.signal)
        force, moment = ([factor * x for x in part] for part in (load.force, load.moment))
        loads.append(Load(load.point, force, moment, follows=load.frame is LoadFrame.SECTION))
    return loads


def first_value(robot: Robot, signal: Any) -> float:
    """The value of a signal at time 0; beyond the arm's run it may have none."""
    return float(signal.schedule(min(1.0, robot.integration.duration)).coefficients[0, 0])
