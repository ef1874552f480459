"""A small arm of rigid links on elastic gears that turns far."""

from __future__ import annotations

from tmodes.sheet import Robot

__all__ = ["chain"]


def chain(count: int, turn: float = 0.3) -> Robot:
    """Links in the plane, each turned by ``turn`` [rad]; the last link is a point with a body."""
    ends = range(count)
    inertia = {"xx": 0.01, "yy": 0.01, "zz": 0.01}
    joints = [
        {"name": f"j{k}", "type": "revolute", "child": f"l{k}", "axis": [0, 0, 1],
         "origin": {"position": [0.5 if k else 0.0, 0, 0]},
         "gear": {"stiffness": 400.0, "damping": 0.2}, "motor": {"inertia": 0.1, "side": "joint"}}
        for k in ends
    ]  # fmt: skip
    bodies = [[{"name": "bar", "mass": 1.0, "inertia": inertia, "center": [0.25, 0, 0]}] for _ in ends]
    drives = [
        {"joint": f"j{k}", "command": "position",
         "signal": {"type": "quintic", "start": 0.0, "end": turn, "duration": 0.2},
         "controller": {"type": "pd", "position_gain": 300.0, "velocity_gain": 12.0}}
        for k in ends
    ]  # fmt: skip
    return Robot.from_data({
        "format": 1, "kind": "arm", "name": "chain", "gravity": 9.81, "joints": joints, "drives": drives,
        "links": [{"name": f"l{k}", "bodies": bodies[k]} for k in ends],
        "integration": {"method": "dormand_prince", "duration": 0.2, "output_step": 0.005, "line_points": 5,
                        "relative_tolerance": 1e-11, "absolute_tolerance": 1e-13},
    })  # fmt: skip
