"""Small runs of arms to look at, each made once."""

from __future__ import annotations

from functools import cache
from typing import Any

from tmodes.result import Result, assemble_result
from tmodes.result.run import ready_to_run
from tmodes.sheet import Robot
from tmodes.simulation.motion_run import RunData
from tmodes.simulation.simulate import simulate_motion

LENGTH, FORCE = 0.8, 2.0
OUTER, THICK, YOUNG = 0.02, 0.002, 70e9
NASTY = "$x$ <b>&_{"
"""A name that breaks formulas and pages."""

HOLD = {"type": "constant", "value": 0.0}
QUINTIC = {"type": "quintic", "start": 0.0, "end": 0.5, "duration": 0.2}


def sheet(**more: Any) -> dict[str, Any]:
    """What every sheet has."""
    return {"format": 1, "kind": "arm", "name": "test", "gravity": [0, 0, 0],
            "integration": {"duration": 0.4, "output_step": 0.004, "relative_tolerance": 1e-8}, **more}  # fmt: skip


def tube(**more: Any) -> dict[str, Any]:
    """A tube of aluminium."""
    return {"model": "strain", "functions": {"bend_y": 3, "bend_z": 3}, "length": LENGTH, "damping_time": 1e-3,
            "section": {"shape": "tube", "outer_diameter": OUTER, "thickness": THICK},
            "material": {"young": YOUNG, "shear": 26e9, "density": 2700.0}, **more}  # fmt: skip


def cantilever() -> dict[str, Any]:
    """A tube that is held at its root and pulled at its tip along z, at rest."""
    return sheet(
        joints=[{"name": "hub", "type": "revolute", "parent": "base", "child": "rod", "axis": [0, 0, 1]}],
        links=[{"name": "rod", "beam": tube()}],
        loads=[{"point": "tip", "force": [0, 0, FORCE], "frame": "world"}],
        drives=[{"joint": "hub", "command": "prescribed", "signal": HOLD}],
    )


def swinging() -> dict[str, Any]:
    """Two links, one bends; elastic gear, following and dead loads over time, contact, a real arm that is softer."""
    ramp = {"type": "sine", "amplitude": 1.0, "frequency": 3.0}
    motor = {"inertia": 0.2, "side": "joint", "resistance": 0.5, "back_emf_constant": 1.0, "torque_constant": 1.0,
             "inductance": 0.0}  # fmt: skip
    control = {"type": "pd", "position_gain": 400.0, "velocity_gain": 40.0}
    return sheet(
        gravity=9.81,
        joints=[
            {"name": "shoulder", "type": "revolute", "parent": "base", "child": "rod", "axis": [0, 0, 1],
             "motor": motor, "gear": {"stiffness": 900.0, "damping": 1.0}},
            {"name": NASTY, "type": "revolute", "parent": "rod", "child": "hand", "axis": [0, 1, 0],
             "motor": {"inertia": 0.02, "side": "joint"}},
        ],
        links=[{"name": "rod", "beam": tube(functions={"twist": 1, "bend_y": 2, "bend_z": 2})},
               {"name": "hand", "bodies": [{"name": "body", "mass": 0.3, "center": [0.1, 0, 0]}]}],
        tip={"link": "hand", "position": [0.2, 0, 0]},
        points=[{"name": "middle", "link": "rod", "at": 0.5}],
        loads=[{"point": "middle", "force": [0, 1.0, 0], "moment": [0.1, 0, 0.2], "frame": "section", "signal": ramp},
               {"point": "tip", "force": [0, 0, -1.0], "frame": "world"}],
        contact={"point": "tip", "shape": {"type": "plane", "position": [0, 0, -0.05], "normal": [0, 0, 1]},
                 "law": "unilateral", "stiffness": 2000.0, "damping": 5.0},
        drives=[{"joint": "shoulder", "command": "position", "signal": QUINTIC, "controller": control},
                {"joint": NASTY, "command": "position", "signal": QUINTIC,
                 "controller": {"type": "pd", "position_gain": 200.0, "velocity_gain": 6.0}}],
        real={"links.rod.beam.damping_time": 2.0, "joints.shoulder.gear.stiffness": 0.8},
    )  # fmt: skip


def pendulum() -> dict[str, Any]:
    """A bob of 1 kg at 1 m that hangs at angle 0, let go; nothing drives it."""
    return sheet(
        gravity=9.81,
        joints=[{"name": "joint", "type": "revolute", "parent": "base", "child": "link", "axis": [0, 1, 0]}],
        links=[{"name": "link", "bodies": [{"name": "bob", "mass": 1.0, "center": [0, 0, -1]}]}],
        tip={"link": "link", "position": [0, 0, -1]},
        initial={"state": "zero", "coordinates": {"joint": 0.4}},
        integration={"duration": 16.0, "output_step": 0.01},
    )


SHEETS = {"cantilever": cantilever, "swinging": swinging, "pendulum": pendulum}


@cache
def run_of(name: str) -> tuple[Robot, RunData]:
    """The arm as it is known and its run."""
    arm = ready_to_run(Robot.from_data(SHEETS[name]()))
    return arm, simulate_motion(arm)


@cache
def result_of(name: str) -> Result:
    """The result of that run."""
    arm, run = run_of(name)
    return assemble_result(run, arm)
