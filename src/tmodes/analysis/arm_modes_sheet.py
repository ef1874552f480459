"""The modes of an arm as its data sheet tells it: about its rest, for each thing that its motors may do."""

from __future__ import annotations

from dataclasses import asdict
from typing import Any

from tmodes.analysis.arm_modes import ArmMode, MotorState, Servo, arm_modes
from tmodes.analysis.equilibrium import Equilibrium
from tmodes.analysis.equilibrium_arm import arm_rest
from tmodes.analysis.equilibrium_path import Progress
from tmodes.arm import Arm
from tmodes.arm_model import ArmModel
from tmodes.chain import Motor

__all__ = ["servos_of", "sheet_modes"]


def sheet_modes(
    arm: Arm, *, contact: bool = False, progress: Progress = lambda stage, share: None
) -> dict[str, list[dict[str, Any]]]:
    """Modes for each state of the motors about the arm's rest under its loads, as plain data.

    ``controlled`` is there only where a drive has a controller. Errors as of
    :func:`tmodes.analysis.equilibrium_arm.arm_rest`.
    """
    rest = arm_rest(arm, contact=contact, progress=progress)
    servos = servos_of(arm, rest.model)
    states = [MotorState.LOCKED, MotorState.FREE, *([MotorState.CONTROLLED] if servos else [])]
    return {str(state): [_plain(mode, rest) for mode in arm_modes(rest, state, servos)] for state in states}


def servos_of(arm: Arm, model: ArmModel) -> dict[str, Servo]:
    """The controllers of a data sheet as springs and dampers of the coordinates that they keep.

    Volts become torque by CM/R, and the back electromotive force damps: Eq. (41) of Filipovic & Djuric 2010.
    """
    motors = {node.joint.name: node.joint.motor for node in model.chain.nodes}
    found = {}
    for drive in arm.drives:
        names = [name for name in (f"{drive.joint}.motor", drive.joint) if name in model.coordinates]
        if drive.controller and names:
            gains = drive.controller.position_gain, drive.controller.velocity_gain
            found[names[0]] = _servo(motors.get(drive.joint), *gains)
    return found


def _servo(motor: Motor | None, position_gain: float, velocity_gain: float) -> Servo:
    if motor is None or motor.resistance is None:
        return Servo(position_gain, velocity_gain)
    per_volt = motor.torque_constant / motor.resistance
    return Servo(per_volt * position_gain, per_volt * (velocity_gain + motor.back_emf))


def _plain(mode: ArmMode, rest: Equilibrium) -> dict[str, Any]:
    told = asdict(mode)
    told["shape"] = dict(zip(rest.model.coordinates, mode.shape.tolist(), strict=True))
    return told
