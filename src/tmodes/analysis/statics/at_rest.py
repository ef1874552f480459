"""Static equilibrium of a robot as its sheet states it; what was found before is taken again."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from tmodes.analysis.statics.equilibrium import (
    Equilibrium,
    Load,
    base_spin,
    equilibrium,
    held_coordinates,
    steady_rates,
)
from tmodes.analysis.statics.loads import coordinate_numbers, first_value, sheet_loads
from tmodes.analysis.statics.path import Progress
from tmodes.equations.loop.plan import winding_of
from tmodes.errors import SimulationError
from tmodes.model.model import Model
from tmodes.sheet import Robot
from tmodes.sheet.parts import Command

__all__ = ["first_commands", "robot_rest"]


def robot_rest(
    robot: Robot,
    loads: Sequence[Load] = (),
    *,
    model: Model | None = None,
    held: Mapping[str, float | str] | None = None,
    sheet: bool = True,
    contact: bool = True,
    moving: bool = False,
    efforts: bool = False,
    progress: Progress = lambda stage, share: None,
) -> Equilibrium:
    """Static equilibrium of a robot under its weight, the loads of its data sheet at time 0 (``sheet``) and ``loads``.

    Driven coordinates are held at ``held`` (numbers [rad, m], or text with a unit), else at their first command, else
    at the sheet's initial coordinates, else at 0; ``contact`` False leaves the sheet's contact out; ``moving``: about
    motion of drives and base at constant speed; ``efforts``: joints whose drives command no position are free under
    their first effort, where ``held`` does not name them, instead of held. What was found before, a rest or that there
    is none, is taken again.
    Errors as of :func:`equilibrium`.
    """
    model = model or Model(robot.chain())
    known = {name: value for name, value in robot.initial.coordinates.items() if name in model.coordinates}
    given = held_coordinates(model, coordinate_numbers(model, held))
    commands = first_commands(robot, model) | given
    pushed = {name: value for name, value in first_efforts(robot, model).items() if efforts and name not in given}
    acting = [*(sheet_loads(robot) if sheet else ()), *loads]
    touched = robot.contact if contact else None
    rates, spin = (steady_rates(robot, model), base_spin(robot)) if moving else ({}, None)
    key = (
        _key(model, acting, commands, known, touched),
        *rates.items(),
        spin is not None and tuple(spin),
        tuple(pushed.items()),
    )
    if key not in _solved:
        how = {"start": known, "contact": touched, "rates": rates, "spin": spin, "efforts": pushed}
        try:
            _solved[key] = equilibrium(model, acting, held=commands, progress=progress, **how)
        except SimulationError as none:  # to find that out takes longest
            _solved[key] = str(none)
        while len(_solved) > _KEPT:
            _solved.popitem(last=False)
    found = _solved[key]
    if isinstance(found, str):
        raise SimulationError(found)
    return replace(found, model=model)  # whose points and rigid links may have other names


_solved: OrderedDict[Any, Equilibrium | str] = OrderedDict()
"""By what they follow from: rests, and for robots that have none, why."""
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


def first_efforts(robot: Robot, model: Model) -> dict[str, float]:
    """Efforts [N*m, N] of drives that command an effort, a torque or a voltage, at rest at time 0, by coordinate."""
    found, axes = {}, {part.axis.name: part for part in model.parts.axes}
    for drive in robot.drives:
        if not drive.command.is_motion and drive.joint in axes:
            resistance, _, torque, _ = winding_of(axes[drive.joint].axis.joint.motor)[1]
            share = torque / resistance if drive.command is Command.VOLTAGE else 1.0
            found[model.coordinates[axes[drive.joint].input]] = share * first_value(robot, drive.signal)
    return found
