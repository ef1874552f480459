"""The robot without its controllers, linear about a rest: what laws are designed from."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.statics.at_rest import robot_rest
from tmodes.kinds.controllers.registry import LinearPlant
from tmodes.kinds.noted.functions import number
from tmodes.kinds.noted.number import Lost, is_noted
from tmodes.kinds.signals.registry import constant_signal
from tmodes.model.passes import derivatives
from tmodes.sheet.parts import Command
from tmodes.simulation.loop import LoopModel
from tmodes.simulation.plan import planned

if TYPE_CHECKING:
    from tmodes.sheet import Robot
    from tmodes.sheet.parts import DriveSheet

__all__ = ["linear_plant"]

Array = NDArray[np.float64]


def linear_plant(robot: Robot, reads: tuple[str, ...], drives: tuple[str, ...], *, start: bool = False) -> LinearPlant:
    """The robot about its rest at the last setpoints, or the first (``start``), under the commands of ``drives``.

    ``reads``: outputs and sensors by name; sensors without samples and noise. All derivatives are exact.
    """
    held = {drive.joint: _setpoint(robot, drive, start=start) for drive in robot.drives if drive.command.is_motion}
    _refuse_noted(*held.values())
    rest = robot_rest(robot, held=_motors(robot, held), contact=robot.contact is not None)
    plan = planned(_open(robot))
    model = LoopModel(plan.plan)
    _refuse_noted(*model.numbers)
    layout, n, count = model.layout, len(model.coordinates), plan.plan.degree + 1
    state, row = np.zeros(layout.size), plan.first_row.copy()
    state[:n] = [rest.named[name] for name in model.coordinates]
    places = [next(1 + one.signal * count for one in plan.plan.drives if one.joint == joint) for joint in drives]
    for drive in plan.plan.drives:
        if drive.joint in held and drive.joint not in drives:
            row[1 + drive.signal * count] = held[drive.joint]
    moving = np.arange(layout.currents.stop)
    push = np.zeros((len(places), len(row)))
    push[np.arange(len(places)), places] = 1.0

    def along(schedule: object, numbers: Array, name: str, directions: Array, output: str) -> Array:
        blocks = model._blocks(np.zeros(len(directions)), np.tile(state, (len(directions), 1)),
                               np.tile(row, (len(directions), 1)))  # fmt: skip
        return derivatives(numbers, schedule, blocks, {name: directions}, len(directions))[output].T

    # What holds it: rates are affine in the commands and in the currents.
    by_state, by_push = np.eye(layout.size)[moving], along(model.loop.rate, model.numbers, "row", push, "rate")
    slopes = along(model.loop.rate, model.numbers, "state", by_state, "rate")
    currents = np.arange(layout.currents.start, layout.currents.stop)
    rows = np.append(np.arange(n, 2 * n), currents)
    rate = model.rate([0.0], state, row)[0]
    found = np.linalg.lstsq(np.hstack([slopes[np.ix_(rows, currents)], by_push[rows]]), -rate[rows], rcond=None)[0]
    state[currents] += found[: len(currents)]
    row[places] += found[len(currents) :]
    A, B = along(model.loop.rate, model.numbers, "state", by_state, "rate")[moving], by_push[moving]
    shown = tuple(model.outputs.find(_plain(name, model.outputs), "control") for name in reads)
    series = model.series(shown, 0, after=False, lean=False)
    numbers = np.concatenate([model.numbers, series.further])
    C = along(series.schedule, numbers, "state", by_state, "series") if reads else np.zeros((0, len(moving)))
    D = along(series.schedule, numbers, "row", push, "series") if reads else np.zeros((0, len(places)))
    seen = model.seen(shown, [0.0], state, row)[0] if reads else np.zeros(0)
    names = (
        *model.coordinates,
        *(f"{name}'" for name in model.coordinates),
        *(f"{j}.current" for j in plan.plan.currents),
    )
    return LinearPlant(names, drives, reads, A, B, C, D, state[moving], row[places], seen)


def _refuse_noted(*values: object) -> None:
    """Gains follow from an eigenvalue problem, which a program of noted numbers does not hold."""
    if noted := [one for one in values if is_noted(one)]:
        raise Lost("gains that are designed from the robot", noted[0])


def _plain(name: str, outputs: object) -> str:
    """Behind a rigid gear the motor is where the joint is."""
    return name.replace(".motor.", ".") if name not in outputs else name  # pyright: ignore[reportOperatorIssue]


def _setpoint(robot: Robot, drive: DriveSheet, *, start: bool) -> float:
    duration = robot.integration.duration
    pieces = drive.signal.schedule(duration)
    return number(pieces.at(0.0 if start else duration))


def _motors(robot: Robot, held: dict[str, float]) -> dict[str, float | str]:
    """Setpoints by coordinate: of the motor behind an elastic gear, else of the joint."""
    names = robot.undriven.chain().coordinates
    return {f"{joint}.motor" if f"{joint}.motor" in names else joint: value for joint, value in held.items()}


def _open(robot: Robot) -> Robot:
    """The robot whose controlled drives take commands, with sensors that measure at every instant."""
    axes = {axis.name: axis for axis in robot.undriven.chain().axes}
    drives = []
    for drive in robot.drives:
        if not drive.command.is_controlled:
            drives.append(drive)
            continue
        motor = axes[drive.joint].joint.motor
        command = Command.EFFORT if motor is None else Command.TORQUE if motor.resistance is None else Command.VOLTAGE
        free = {"command": command, "signal": constant_signal(0.0), "controller": None, "noise": None, "limits": None,
                "sample_time": None, "delay": 0.0}  # fmt: skip
        drives.append(drive.model_copy(update=free))
    ideal = {"sample_time": None, "delay": 0.0, "noise": 0.0}
    sensors = tuple(sensor.model_copy(update=ideal) for sensor in robot.sensors)
    return robot.model_copy(update={"drives": tuple(drives), "sensors": sensors, "control": ()})
