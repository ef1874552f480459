"""Impedance and force control where the tip touches: static forces by stiffness in series, wanted forces reached."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import tmodes
from contracts.test_blocks import Sheet
from contracts.test_drive_limits import public
from simulation.sheets import arm, beam

SPAN, WALL, GEAR, BENDING = 0.8, 4e4, 2500.0, 350.0
IMPEDANCE = {"type": "impedance", "stiffness": [900.0, 1500.0, 900.0], "damping": [60.0, 80.0, 60.0]}
FORCE = IMPEDANCE | {"type": "force", "direction": [0, 1, 0], "force": 12.0, "integral_gain": 8.0,
                     "input": "contact.force.y", "sample_time": 1e-3}  # fmt: skip


def pressing(block: Sheet, goal: float, *, bends: bool = True, **more: Any) -> Any:
    """A beam on an elastic gear that turns in the plane against a wall across its tip, without weight."""
    wall = {"type": "plane", "position": [0, 0, 0], "normal": [0, -1, 0]}
    joint = {"name": "joint", "type": "revolute", "child": "link", "axis": [0, 0, 1],
             "motor": {"inertia": 0.3, "side": "joint"}, "gear": {"stiffness": GEAR, "damping": 8.0}}  # fmt: skip
    link = ({"name": "link", "beam": beam({"bend_z": 3}, SPAN, BENDING, 0.7, damping_time=5e-3)} if bends else
            {"name": "link", "bodies": [{"name": "own", "mass": 0.6, "center": [SPAN, 0, 0]}]})  # fmt: skip
    drive = {"joint": "joint", "command": "position", "signal": {"type": "constant", "value": goal}}
    return public(arm(gravity=0.0, joints=[joint], links=[link], drives=[drive],
                      **({} if bends else {"tip": {"link": "link", "position": [SPAN, 0, 0]}}),
                      contact={"law": "unilateral", "shape": wall, "stiffness": WALL, "damping": 400.0},
                      control=[{"name": "law", "drives": ["joint"], "block": block}],
                      initial={"state": "zero", "coordinates": {"joint": -0.02, "joint.motor": -0.02}},
                      integration={"duration": 3.0, "output_step": 0.01}, **more))  # fmt: skip


@pytest.mark.parametrize("bends", [True, False])
def test_the_force_of_an_impedance_is_that_of_springs_in_series(bends: bool) -> None:
    """Of the law, the gear, the link and the wall, over how far the setpoint is behind it."""
    goal = 1e-3
    result = pressing(IMPEDANCE, goal, bends=bends).run()
    soft = 1 / IMPEDANCE["stiffness"][1] + SPAN**2 / GEAR + 1 / WALL + (SPAN**3 / (3 * BENDING) if bends else 0.0)
    force = np.asarray(result.output("contact.force.y"))
    assert force[0] == 0.0
    assert force[-1] == pytest.approx(SPAN * goal / soft, rel=1e-4)


def test_a_wanted_force_is_reached_however_soft_the_robot_is() -> None:
    """With the integral; without it the law pushes as hard, for it knows no friction. The way is no matter."""
    result = pressing(FORCE, 0.0).run()
    force = np.asarray(result.output("contact.force.y"))
    assert force[-1] == pytest.approx(FORCE["force"], rel=1e-6)
    assert force[0] == 0.0
    assert force.max() < 1.3 * FORCE["force"]


def test_a_load_that_is_not_known_is_taken_by_the_integral_alone() -> None:
    """3 N against the push are missing at the wall, where nothing integrates."""
    for gain, left in ((0.0, 9.0), (8.0, 12.0)):
        against = [{"force": [0, -3, 0], "frame": "world"}]
        result = pressing(FORCE | {"integral_gain": gain}, 0.0, loads=against).run()
        assert float(np.asarray(result.output("contact.force.y"))[-1]) == pytest.approx(left, rel=1e-3)


def elbow(behind: float) -> Any:
    """Two rigid links at right angles whose motors are given; the tip would be ``behind`` a wall across x."""
    angles = np.array([-0.4, 1.6])
    reach = SPAN * np.cos(angles[0]) + SPAN * np.cos(angles.sum())
    wall = {"type": "plane", "position": [reach - behind, 0, 0], "normal": [-1, 0, 0]}
    motor, gear = {"inertia": 0.3, "side": "joint"}, {"stiffness": GEAR, "damping": 30.0}
    joints = [{"name": f"j{k}", "type": "revolute", "child": f"l{k}", "axis": [0, 0, 1], "motor": motor, "gear": gear,
               **({"parent": "l0", "origin": {"position": [SPAN, 0, 0]}} if k else {})} for k in range(2)]  # fmt: skip
    body = {"name": "own", "mass": 1.0, "center": [SPAN / 2, 0, 0]}
    drives = [{"joint": f"j{k}", "command": "prescribed", "signal": {"type": "constant", "value": float(angle)}}
              for k, angle in enumerate(angles)]  # fmt: skip
    return public(arm(gravity=0.0, joints=joints, drives=drives, tip={"link": "l1", "position": [SPAN, 0, 0]},
                      links=[{"name": f"l{k}", "bodies": [body]} for k in range(2)],
                      contact={"law": "unilateral", "shape": wall, "stiffness": WALL, "damping": 0.0},
                      integration={"duration": 0.1, "output_step": 0.01}))  # fmt: skip


def test_force_follows_position_at_a_bent_elbow() -> None:
    """F = x/(1/k + n' J K^-1 J' n): of small ways behind the wall, in proportion, by the pose's own compliance."""
    a, b = -0.4, 1.2
    row = -SPAN * np.array([np.sin(a) + np.sin(b), np.sin(b)])
    soft = row @ row / GEAR + 1 / WALL
    forces = []
    for behind in (2e-5, 4e-5):
        forces.append(float(np.asarray(elbow(behind).run().output("contact.force"))[-1]))
        assert forces[-1] == pytest.approx(behind / soft, rel=2e-3)
    assert forces[1] == pytest.approx(2 * forces[0], rel=2e-3)


def of_2010(**more: Any) -> Any:
    """The arm of the 2010 paper as known, from 40 degrees, its motor commanded by a block."""
    data = tmodes.load("filipovic2010").model_dump(mode="json", by_alias=True, exclude_none=True)
    data["drives"] = [{"joint": "joint", "command": "position", "signal": {"type": "constant", "value": 0.7}}]
    start = {"state": "zero", "coordinates": {"joint": 0.7, "joint.motor": 0.7}}
    return tmodes.Robot.from_data(data | {"initial": start, "real": {}} | more)


PRESS = {"type": "force", "stiffness": [400.0, 400.0, 400.0], "damping": [60.0, 60.0, 60.0], "direction": [1, 1, 0],
         "force": 20.0, "integral_gain": 5.0, "input": "contact.force", "sample_time": 1e-3}  # fmt: skip
ALONG = [-float(np.sin(0.7)), float(np.cos(0.7)), 0.0]


def across(**more: Any) -> Sheet:
    """The environment of 2010, with its mass and preload, across the path in place of along the radius."""
    contact = tmodes.load("filipovic2010").contact
    assert contact is not None
    place = [0.9 * float(np.cos(0.7)), 0.9 * float(np.sin(0.7)), 0.0]
    return (
        contact.model_dump(mode="json")
        | {"shape": {"type": "plane", "position": place, "normal": [-x for x in ALONG]}}
        | more
    )


def test_the_force_of_2010_is_beyond_the_reach_of_its_motor() -> None:
    """It points along the radius, where one joint has no lever: J' n = 0. Whatever is wanted, the preload stays."""
    radius = [float(np.cos(0.7)), float(np.sin(0.7)), 0.0]
    control = [{"name": "law", "drives": ["joint"], "block": PRESS | {"direction": radius}}]
    force = np.asarray(of_2010(control=control).run().output("contact.force"))
    assert np.abs(force[1000:] - 5.0).max() < 0.02
    assert PRESS["force"] == 20.0


def test_the_environment_of_2010_across_the_path_is_pressed_as_wanted() -> None:
    """Without friction to the wanted force; with that of the paper it creeps about it."""
    control = [{"name": "law", "drives": ["joint"], "block": PRESS | {"direction": ALONG}}]
    settings = {"duration": 8.0, "output_step": 0.01}
    robots = [of_2010(control=control, integration=settings, contact=across(friction=mu)) for mu in (0.0, 0.1)]
    smooth, rough = (np.asarray(robot.run().output("contact.force")) for robot in robots)
    assert smooth[-300:] == pytest.approx(20.0, rel=1e-4)
    assert rough[-500:] == pytest.approx(20.0, rel=0.04)


def test_an_impedance_on_the_environment_of_2010() -> None:
    """Its preload, 5 N, moves the tip back by all compliances in series: F = 5/ka/(1/ka + 1/K + L^2/C + links).

    A mode yields l/(3 EI) per moment at the lever it has on the tip: 0.6 m + 3/2 0.3 m, and 0.3 m.
    """
    block = {"type": "impedance"} | {name: PRESS[name] for name in ("stiffness", "damping")}
    control = [{"name": "law", "drives": ["joint"], "block": block}]
    soft = 0.9**2 / 4700 + 1.05**2 * 0.6 / (3 * 1082.129) + 0.3**3 / (3 * 13.35962)
    force = float(np.asarray(of_2010(control=control, contact=across(friction=0.0)).run().output("contact.force"))[-1])
    assert force == pytest.approx(5e-3 / (1e-3 + 1 / 400 + soft), rel=2e-3)
