"""What a page needs to find the modes of the 2010 robot anew: which directions are free, and where energy is stored."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from tmodes.analysis.spectrum import MotorState
from tmodes.compile.wasm.wasm_parts import sample_part
from tmodes.equations.lagrange.coordinates import basis, deformations, free_columns
from tmodes.live.module import Functions
from tmodes.paper.mechanism import Drive, Mechanism
from tmodes.paper.modes import ELEMENTS
from tmodes.paper.sheet import PaperRobot

__all__ = ["add_modes", "robot_modes"]

_CASES = (MotorState.CONTROLLED, MotorState.LOCKED, MotorState.FREE)


def free_mechanism(robot: PaperRobot) -> Mechanism:
    """The robot whose modes are told: out of contact, its motor driven by nothing that the equations know."""
    return robot.split(Drive.VOLTAGE, contact=False)[0]


def add_modes(made: Functions, robot: PaperRobot, parameters: int) -> None:
    """Samples of a module: ``modes.rest`` (inputs as ``rest`` has them) and ``modes.linear`` (M, D, K, row by row)."""
    mechanism = free_mechanism(robot)
    exports = {label: f"{label} {mechanism.arm_key}" for label in ("modes.rest", "modes.linear")}

    def make() -> Mapping[str, Any]:
        from tmodes.equations.lagrange.linear import linear_function
        from tmodes.equations.lagrange.statics import rest_function

        return dict(zip(exports.values(), (rest_function(mechanism), linear_function(mechanism)), strict=True))

    made.parts.append(sample_part(mechanism.arm_key, make, dict(zip(exports.values(), (2, 1), strict=True))))
    rest = {"angles": 5, "theta": 1}, {"residual": 5, "slope": 25}
    for label, (inputs, outputs) in zip(exports, (rest, ({"phi": 6}, {"linear": 108})), strict=True):
        made.program(label, exports[label], inputs, outputs, parameters)


def robot_modes(robot: PaperRobot) -> dict[str, Any]:
    """``RobotModes`` of ``web/src/live/bundle.ts``: cases of the motor, and the springs that are not rigid."""
    rigid = free_mechanism(robot).rigid
    cases = [
        {"name": str(state), "columns": np.ascontiguousarray(free_columns(rigid, state is MotorState.LOCKED))}
        for state in _CASES
    ]
    rows = deformations(np.eye(6))._asdict()
    springs = [
        {"element": ELEMENTS[name], "row": rows[name].tolist(), "stiffness": stiffness, "length": length}
        for name, (stiffness, length) in _numbers().items()
        if math.isfinite(dict(robot.numbers())[stiffness])
    ]
    return {"cases": cases, "turn": basis()[:, 0].tolist(), "springs": springs}


def _numbers() -> dict[str, tuple[str, str]]:
    """Paths of each element's stiffness, and of the length by which a mode's is divided."""
    modes = [(f"link.modes.{k}.bending_stiffness", f"link.modes.{k}.length") for k in (0, 1)]
    return {"th11q": modes[0], "th12d": modes[1], "th11m": modes[0], "th12e": modes[1], "xi": ("gear.stiffness", "")}
