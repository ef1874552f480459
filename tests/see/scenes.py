"""Short true runs whose scenes are looked at, each made once."""

from __future__ import annotations

from functools import cache

from see.runs import QUINTIC, sheet, tube
from tmodes import load, run
from tmodes.report.data import live_page
from tmodes.report.parts import viewer_document
from tmodes.result import Result
from tmodes.sheet import Robot

MOVE = {"reference.duration": 0.2, "integration.duration": 0.2, "integration.line_points": 7}


@cache
def robot_result(mass: float = 0.5) -> Result:
    """The robot of the 2010 paper in contact, a move of 0.2 s."""
    return run(load("filipovic2010").with_(MOVE | {"payload.mass": mass}))


@cache
def short_robot() -> Robot:
    """The robot of the 2010 paper, for 0.3 s."""
    return load("filipovic2010").with_({"integration.duration": 0.3})


@cache
def short_report() -> str:
    """The page of its run, with the robot's equations."""
    return viewer_document(live_page(run(short_robot())))


@cache
def arm_result() -> Result:
    """A bending rod and a rigid hand behind elastic gears, on a base that turns and rises."""
    motor = {"inertia": 0.2, "side": "joint"}
    gear = {"stiffness": 900.0, "damping": 1.0}
    pd = {"type": "pd", "position_gain": 900.0, "velocity_gain": 40.0}
    info = sheet(
        gravity=9.81,
        base={"position": [0.1, 0.2, 0.3], "rpy": [0.0, 0.0, 0.4]},
        base_motion={"z": {"type": "sine", "amplitude": 0.05, "frequency": 2.0}},
        joints=[
            {"name": "shoulder", "type": "revolute", "parent": "base", "child": "rod", "axis": [0, 0, 1],
             "motor": motor, "gear": gear},
            {"name": "wrist", "type": "revolute", "parent": "rod", "child": "hand", "axis": [0, 1, 0], "motor": motor},
        ],
        links=[
            {"name": "rod", "beam": tube(functions={"twist": 1, "bend_y": 2, "bend_z": 2})},
            {"name": "hand", "bodies": [{"name": "hand", "mass": 0.5, "center": [0.2, 0, 0]}]},
        ],
        tip={"link": "hand", "position": [0.25, 0.0, 0.0]},
        drives=[
            {"joint": "shoulder", "command": "position", "signal": QUINTIC, "controller": pd},
            {"joint": "wrist", "command": "position", "signal": QUINTIC, "controller": pd},
        ],
        real={"joints.shoulder.gear.stiffness": 0.5},
    )  # fmt: skip
    arm = Robot.from_data(info)
    return run(arm)
