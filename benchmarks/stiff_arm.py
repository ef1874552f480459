"""The stiff arm of the benchmarks: six joints with motors and elastic gears, six tubes of true beams, 54 coordinates.

Tubes of 25 to 50 mm radius and 0.2 to 0.5 m (2.2 m in all), gears of 3e3 to 2e4 N m/rad, 2 kg at the tip, motors under
PD control, gravity. The joints move by 0.4 to 0.6 rad in half a second; each motor's reference starts ``JUMP`` ahead of
the motor, so the move begins with a step of torque. First mode about 16 Hz, fastest eigenvalue near 1e6 1/s.
"""

from __future__ import annotations

from typing import Any

from tmodes.analysis.statics.at_rest import robot_rest
from tmodes.model.model import Model
from tmodes.sheet import Robot

__all__ = ["DAMPING_TIME", "falling_arm", "stiff_arm", "two_beams"]

DAMPING_TIME = 3e-5
"""Kelvin-Voigt damping of the links [s]."""

JUMP = 0.01
"""How far the references start ahead of the motors [rad]."""

_LENGTHS = (0.2, 0.5, 0.45, 0.4, 0.35, 0.3)
_RADII = (0.05, 0.05, 0.045, 0.035, 0.03, 0.025)
_GEARS = (2e4, 2e4, 1.5e4, 8e3, 5e3, 3e3)
_INERTIAS = (2.0, 2.0, 1.0, 0.4, 0.2, 0.1)
_GAINS = (12000.0, 12000.0, 6000.0, 2500.0, 1000.0, 500.0)
_AXES = ([0, 0, 1], [0, 1, 0], [0, 1, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1])
_STARTS = (0.0, -0.4, 0.8, 0.0, 0.5, 0.0)
_MOVES = (0.6, 0.5, -0.5, 0.4, -0.5, 0.5)


def _joint(k: int) -> dict[str, Any]:
    motor = {"inertia": _INERTIAS[k], "side": "joint", "friction": {"viscous": 0.5}}
    return {"name": f"j{k}", "type": "revolute", "child": f"l{k}", "axis": _AXES[k], "motor": motor,
            "gear": {"stiffness": _GEARS[k], "damping": 1e-3 * _GEARS[k] ** 0.5}}  # fmt: skip


def _link(k: int, damping_time: float) -> dict[str, Any]:
    section = {"shape": "tube", "outer_diameter": 2 * _RADII[k], "thickness": 0.003}
    beam = {"model": "strain", "functions": {"twist": 1, "bend_y": 3, "bend_z": 3},
            "length": _LENGTHS[k], "section": section, "material": "aluminium_6061",
            "damping_time": damping_time, "rotary_inertia": "full"}  # fmt: skip
    body = {"name": "load", "mass": 2.0, "inertia": {"xx": 4e-3, "yy": 4e-3, "zz": 4e-3}, "at": 1.0}
    return {"name": f"l{k}", "beam": beam, **({"bodies": [body]} if k == len(_LENGTHS) - 1 else {})}


def _drive(k: int) -> dict[str, Any]:
    return {"joint": f"j{k}", "command": "position",
            "signal": {"type": "quintic", "start": _STARTS[k] + JUMP, "end": _STARTS[k] + _MOVES[k], "duration": 0.5},
            "controller": {"type": "pd", "position_gain": _GAINS[k], "velocity_gain": 0.06 * _GAINS[k]}}  # fmt: skip


def stiff_arm(*, start: str = "rest", damping_time: float = DAMPING_TIME, **integration: Any) -> Robot:
    """The arm's sheet; ``start``: ``rest`` (sagged, before the references are ahead) or ``drop`` (undeformed)."""
    motors = {f"j{k}.motor": value for k, value in enumerate(_STARTS)}
    angles = {**motors, **{name.removesuffix(".motor"): value for name, value in motors.items()}}
    if start == "rest":
        arm = _sheet(angles, damping_time, {})
        model = Model(arm.chain())
        angles = dict(zip(model.coordinates, robot_rest(arm, model=model, held=motors).q.tolist(), strict=True))
    return _sheet(angles, damping_time, integration)


def _sheet(angles: dict[str, float], damping_time: float, integration: dict[str, Any]) -> Robot:
    return Robot.from_data({
        "format": 1, "kind": "arm", "name": "stiff", "gravity": 9.81,
        "joints": [_joint(k) for k in range(6)],
        "links": [_link(k, damping_time) for k in range(6)],
        "drives": [_drive(k) for k in range(6)],
        "initial": {"state": "zero", "coordinates": angles},
        "integration": {"duration": 1.0, "output_step": 0.01, **integration},
    })  # fmt: skip


def falling_arm(**integration: Any) -> Robot:
    """The same tubes, gears and load with motors that stand, straight and level at first: it falls into its gears."""
    joints = [{**_joint(k), "state": "locked"} for k in range(6)]
    for joint in joints:
        del joint["motor"]
    return Robot.from_data({
        "format": 1, "kind": "arm", "name": "falling", "gravity": 9.81, "joints": joints,
        "links": [_link(k, DAMPING_TIME) for k in range(6)], "initial": {"state": "zero"},
        "integration": {"duration": 1.0, "output_step": 0.01, **integration},
    })  # fmt: skip


def two_beams(**integration: Any) -> Robot:
    """The first two joints and links alone, with four functions for each way of bending: 22 coordinates."""
    links = [_link(k, DAMPING_TIME) for k in range(2)]
    for link in links:
        link["beam"]["functions"] = {"twist": 1, "bend_y": 4, "bend_z": 4}
    links[1]["bodies"] = [{"name": "load", "mass": 2.0, "inertia": {"xx": 4e-3, "yy": 4e-3, "zz": 4e-3}, "at": 1.0}]
    return Robot.from_data({
        "format": 1, "kind": "arm", "name": "two_beams", "gravity": 9.81,
        "joints": [_joint(k) for k in range(2)], "links": links, "drives": [_drive(k) for k in range(2)],
        "integration": {"duration": 0.5, "output_step": 5e-3, "relative_tolerance": 1e-6, **integration},
    })  # fmt: skip
