"""The rest of an arm as its data sheet states it: its loads and contact, its drives at their first command."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from tmodes.analysis.statics.equilibrium import Equilibrium, equilibrium
from tmodes.analysis.statics.loads import Load
from tmodes.analysis.statics.path import Progress
from tmodes.model.model import Model
from tmodes.sheet import Robot
from tmodes.sheet.parts import LoadFrame

__all__ = ["arm_rest", "first_commands", "first_value", "sheet_loads"]


def arm_rest(
    arm: Robot,
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
    at 0; ``contact`` False leaves the sheet's contact out. Errors as of :func:`equilibrium`.
    """
    model = model or Model(arm.chain())
    known = {name: value for name, value in arm.initial.coordinates.items() if name in model.coordinates}
    commands = first_commands(arm, model) | dict(held or {})
    return equilibrium(
        model,
        [*(sheet_loads(arm) if sheet else ()), *loads],
        held=commands,
        start=known,
        contact=arm.contact if contact else None,
        progress=progress,
    )


def first_commands(arm: Robot, model: Model) -> dict[str, float]:
    """Coordinates whose position a drive commands, at time 0 [rad, m]; a motor's where its gear is elastic."""
    commands = {}
    for drive in arm.drives:
        if drive.command.is_motion:
            motor = f"{drive.joint}.motor"
            name = motor if motor in model.coordinates else drive.joint
            if name in model.coordinates:
                commands[name] = first_value(arm, drive.signal)
    return commands


def sheet_loads(arm: Robot) -> list[Load]:
    """The loads of a data sheet at time 0."""
    loads = []
    for load in arm.loads:
        factor = 1.0 if load.signal is None else first_value(arm, load.signal)
        force, moment = ([factor * x for x in part] for part in (load.force, load.moment))
        loads.append(Load(load.point, force, moment, follows=load.frame is LoadFrame.SECTION))
    return loads


def first_value(arm: Robot, signal: Any) -> float:
    """The value of a signal at time 0; beyond the arm's run it may have none."""
    return float(signal.schedule(min(1.0, arm.integration.duration)).coefficients[0, 0])
