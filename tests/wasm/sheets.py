"""Small arms whose modules are tried: two flexible links with motors and elastic gears, loads, a wall."""

from __future__ import annotations

from typing import Any

from tmodes.sheet import Robot

__all__ = ["two_links"]

_WALL = {
    "point": "tip", "shape": {"type": "plane", "normal": [0, -1, 0], "position": [0, 0.15, 0]}, "law": "unilateral",
    "stiffness": 2e3, "damping": 20.0, "friction": 0.2, "static_friction": 0.3,
}  # fmt: skip


def _link(k: int, **more: Any) -> dict[str, Any]:
    section = {"shape": "tube", "outer_diameter": 0.03 - 0.008 * k, "thickness": 0.001}
    beam = {"model": "strain", "functions": {"twist": 1, "bend_y": 2, "bend_z": 1}, "length": 0.5 - 0.1 * k,
            "section": section, "material": "aluminium_6061", "damping_time": 1e-4,
            "rotary_inertia": "full"}  # fmt: skip
    return {"name": f"l{k}", "beam": beam, **more}


def two_links(*, wall: bool = False, **integration: Any) -> Robot:
    """Twelve coordinates and a payload; the real gears are softer and the real payload is heavier than known."""
    joints = [
        {"name": f"j{k}", "type": "revolute", "child": f"l{k}", "axis": axis,
         "gear": {"stiffness": 300.0, "damping": 0.2},
         "motor": {"inertia": 0.1, "side": "joint",
                   "friction": {"viscous": 0.2, "coulomb": 0.05, "static_extra": 0.02}}}
        for k, axis in enumerate(([0, 0, 1], [0, 1, 0]))
    ]  # fmt: skip
    drives = [
        {"joint": f"j{k}", "command": "position",
         "controller": {"type": "pd", "position_gain": 300.0, "velocity_gain": 12.0},
         "signal": {"type": "quintic", "start": 0.1, "end": 0.5, "duration": 0.15}}
        for k in range(2)
    ]  # fmt: skip
    return Robot.from_data({
        "format": 1, "kind": "arm", "name": "two", "gravity": 9.81, "joints": joints,
        "links": [_link(0), _link(1, bodies=[{"name": "payload", "mass": 0.4, "at": 1.0}])], "drives": drives,
        "tip": {"link": "l1", "at": 1.0}, "real": {"joints.0.gear.stiffness": 0.8},
        "loads": [{"point": "tip", "frame": "section", "force": [0, 1.0, -0.5],
                   "signal": {"type": "constant", "value": 1.5}}],
        **({"contact": _WALL} if wall else {}),
        "integration": {"duration": 0.2, "output_step": 0.005, **integration},
    })  # fmt: skip
