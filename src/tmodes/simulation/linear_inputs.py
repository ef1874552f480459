"""Inputs of linear models: commands of drives, setpoints of controllers, forces and moments at points."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from tmodes.errors import InputError
from tmodes.kinds.signals.registry import constant_signal
from tmodes.sheet import Robot
from tmodes.sheet.parts import Command, DriveSheet, LoadFrame, LoadSheet
from tmodes.simulation.plan import Planned, initial_value, loose_drive

__all__ = ["all_inputs", "columns", "driven", "input_unit", "opened", "with_loads"]

_LOADS = {"force": ("x", "y", "z"), "moment": ("x", "y", "z")}


def opened(robot: Robot) -> Robot:
    """The robot whose drives take commands, all constant; its sensors measure at every instant, without noise."""
    axes = {axis.name: axis for axis in robot.undriven.chain().axes}
    drives = []
    for drive in robot.drives:
        motor = axes[drive.joint].joint.motor
        command = Command.EFFORT if motor is None else Command.TORQUE if motor.resistance is None else Command.VOLTAGE
        own = command if drive.command.is_motion else drive.command
        free = {"command": own, "signal": constant_signal(0.0), "controller": None, "noise": None, "saturation": None,
                "sample_time": None, "delay": 0.0}  # fmt: skip
        drives.append(drive.model_copy(update=free))
    ideal = {"sample_time": None, "delay": 0.0, "noise": 0.0}
    sensors = tuple(sensor.model_copy(update=ideal) for sensor in robot.sensors)
    still = {"base_motion": None, "control": (), "sensors": sensors, "drives": tuple(drives)}
    return robot.model_copy(update=still)


def driven(robot: Robot, inputs: Sequence[str]) -> Robot:
    """With a drive for each joint without one whose command is among the inputs; without any drive, for all joints.

    They hold their joints as a run does.
    """
    free = [axis for axis in robot.undriven.chain().axes if axis.name not in {drive.joint for drive in robot.drives}]
    named = {name.rpartition(".")[0] for name in inputs}
    added = [
        loose_drive(robot, axis) or DriveSheet(
            joint=axis.name, command=Command.PRESCRIBED, signal=constant_signal(initial_value(robot, axis.name))
        )
        for axis in free
        if axis.name in named or not (inputs or robot.drives)
    ]  # fmt: skip
    return robot.model_copy(update={"drives": (*robot.drives, *added)}) if added else robot


def all_inputs(robot: Robot, *, closed: bool) -> tuple[str, ...]:
    """Names of the commands of all drives; under control of their setpoints; without any joint of forces at the tip."""
    if closed:
        return tuple(f"{drive.joint}.setpoint" for drive in robot.drives if drive.command.is_controlled)
    found = tuple(f"{drive.joint}.{drive.command}" for drive in opened(robot).drives if not drive.command.is_motion)
    return found or tuple(f"tip.force.{axis}" for axis in "xyz")


def with_loads(robot: Robot, inputs: Sequence[str]) -> tuple[Robot, dict[str, int]]:
    """The robot with a load of size zero for each input on a point, and the places of these among its loads."""
    points, loads, places = ("tip", *(point.name for point in robot.points)), list(robot.loads), {}
    for name in inputs:
        point, _, rest = name.rpartition(".")
        point, _, kind = point.rpartition(".")
        if point in points and kind in _LOADS and rest in _LOADS[kind]:
            vector: Any = tuple(float(rest == axis) for axis in "xyz")
            places[name] = len(loads)
            loads.append(LoadSheet(point=point, frame=LoadFrame.WORLD, signal=constant_signal(0.0), **{kind: vector}))
    return (robot.model_copy(update={"loads": tuple(loads)}) if places else robot), places


def columns(
    robot: Robot, plan: Planned, inputs: Sequence[str], loads: Mapping[str, int], *, closed: bool
) -> list[tuple[str, int]]:
    """Each input with its place in the row; raises :class:`tmodes.errors.InputError` for an unknown one."""
    width, known = plan.plan.degree + 1, dict(_known(robot, plan, closed=closed))
    known |= {name: 1 + plan.plan.loads[place].signal * width for name, place in loads.items()}
    found = []
    for name in inputs:
        own = name if name in known else name.replace(".effort", ".torque")
        if own not in known:
            points = [f"{point}.force.x" for point in ("tip", *(one.name for one in robot.points[:2]))]
            hint = "add --closed for setpoints" if name.endswith(".setpoint") and not closed else "take one of these"
            every = (
                f"one of {', '.join(dict.fromkeys([*known, *all_inputs(driven(robot, ()), closed=closed), *points]))}"
            )
            raise InputError("inputs", f"the unknown input `{name}`", every, hint)
        found.append((name, known[own]))
    return found


def input_unit(name: str, outputs: Any) -> str:
    """The unit of an input, by the ``outputs`` of its model: a drive's that of its setpoint, which is its command."""
    joint, _, kind = name.rpartition(".")
    if f"{joint}.setpoint" in outputs:
        return outputs.find(f"{joint}.setpoint", "inputs").unit + "/s" * (kind == "setpoint_rate")
    return "N*m" if ".moment." in name else "N"


def _known(robot: Robot, plan: Planned, *, closed: bool) -> Iterator[tuple[str, int]]:
    commands = {drive.joint: drive.command for drive in robot.drives}
    for drive in plan.plan.drives:
        if drive.servo and closed == drive.servo.is_controlled and drive.joint in commands:
            place = 1 + drive.signal * (plan.plan.degree + 1)
            names = ("setpoint", "setpoint_rate") if closed else (commands[drive.joint],)  # second in a piece: its rate
            yield from ((f"{drive.joint}.{name}", place + k) for k, name in enumerate(names))
