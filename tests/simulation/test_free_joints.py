"""Joints that nothing drives: those with an initial rate move freely with it, others are held where they start."""

from __future__ import annotations

import numpy as np
import pytest

import tmodes
from simulation.sheets import ZERO, arm, pendulum
from tmodes.sheet import Robot

MOTOR = {"motor": {"inertia": 0.2, "side": "joint"}}
GEAR = {**MOTOR, "gear": {"stiffness": 100.0, "damping": 0.1}}
BODY = {"name": "bob", "mass": 1.0, "center": [0.3, 0.1, 0], "inertia": {"xx": 0.01, "yy": 0.01, "zz": 0.01}}
HELD = {"command": "prescribed", "signal": ZERO}


def two(free: int, kind: str, actuation: dict, how: dict | None = None, **more: object) -> Robot:
    """Two joints about z without gravity, of which one has no drive."""
    joints = [{"name": f"j{k}", "type": "revolute", "child": f"l{k}", "axis": [0, 0, 1]} for k in range(2)]
    joints[0]["parent"] = "base"
    joints[free] |= {"type": kind, **actuation}
    return arm(gravity=0.0, joints=joints, links=[{"name": f"l{k}", "bodies": [BODY]} for k in range(2)],
               drives=[{"joint": f"j{1 - free}", **(how or HELD)}],
               **{"initial": {"rates": {f"j{free}": 1.3}},
                  "integration": {"duration": 0.6, "output_step": 0.1}, **more})  # fmt: skip


@pytest.mark.parametrize("actuation", [{}, MOTOR, GEAR, {"state": "free"}], ids=["bare", "motor", "gear", "free"])
@pytest.mark.parametrize("kind", ["revolute", "prismatic"])
@pytest.mark.parametrize("free", [0, 1])
def test_it_keeps_its_rate_where_no_force_acts(free: int, kind: str, actuation: dict) -> None:
    """Alone, and, with a motor behind a rigid gear, side by side with others."""
    robot = two(free, kind, actuation)
    run = tmodes.run(robot)
    expected = np.outer(run.data["time"].values, [1.3 if name.startswith(f"j{free}") else 0.0
                                                  for name in run.data["coordinate"].values])  # fmt: skip
    np.testing.assert_allclose(run.data["q"].values, expected, rtol=0, atol=1e-9)
    assert (f"joint j{free} has no drive: it moves freely with its initial rate" in run.warnings) == (
        "state" not in actuation
    )
    if actuation is MOTOR:
        batch = tmodes.simulate_batch(robot, {"links.l1.bodies.bob.mass": [1.0, 2.0]})
        np.testing.assert_allclose(batch.states[:, :, : expected.shape[1]], [expected] * 2, rtol=0, atol=1e-9)


@pytest.mark.parametrize("free", [0, 1])
def test_it_keeps_the_momentum_while_the_other_is_moved(free: int) -> None:
    """No torque acts along it: its momentum stays what it was, and the energy is that of what moves the other."""
    move = {"command": "effort", "signal": {"type": "sine", "amplitude": 0.4, "frequency": 2.0}}
    robot = two(free, "revolute", {}, move)
    run, model = tmodes.run(robot), tmodes.Model(robot.chain())
    if free == 0:  # the outer joint's effort acts between both bodies
        momenta = [model.mass_matrix(q)[0] @ v for q, v in zip(run.data["q"].values, run.data["v"].values, strict=True)]
        np.testing.assert_allclose(momenta, momenta[0], rtol=1e-7)
    assert np.ptp(run.data["v"].values[:, free]) > 1e-3
    assert run.summary()["energy"]["worst_residual_over_moved"] < 1e-6


def test_without_a_rate_it_is_held() -> None:
    run = tmodes.run(two(1, "revolute", {}, initial={"coordinates": {"j1": 0.4}}))
    np.testing.assert_array_equal(run.data["q"].values[:, 1], 0.4)
    assert "joint j1 has no drive: it is held where it starts" in run.warnings


@pytest.mark.parametrize(("group", "value"), [("rates", 2.0), ("coordinates", 0.5)])
def test_what_a_prescribed_motion_leaves_out_is_reported(group: str, value: float) -> None:
    move = {"command": "prescribed", "signal": {"type": "quintic", "start": 0.0, "end": 0.2, "duration": 0.1}}
    robot = pendulum({"inertia": 0.3}, {"stiffness": 100.0}, move, initial={group: {"joint.motor": value}},
                     integration={"duration": 0.1, "output_step": 0.05})  # fmt: skip
    expected = f"initial.{group}.joint.motor: {value:g} is left out: its drive prescribes 0 at t = 0"
    assert expected in tmodes.run(robot).warnings


@pytest.mark.parametrize("seed", range(3))
def test_bodies_without_mass_and_rotors_without_inertia(seed: int) -> None:
    """J q'' = torque: the inertia of a body without mass counts, wherever its center is, and that of no rotor."""
    rng = np.random.default_rng(seed)
    inertia, effort = rng.uniform(0.1, 2, 2)
    body = {"name": "b", "mass": 0.0, "center": rng.normal(size=3).tolist(),
            "inertia": {"xx": inertia, "yy": inertia, "zz": inertia}}  # fmt: skip
    joint = {"name": "j", "type": "revolute", "parent": "base", "child": "l", "axis": rng.normal(size=3).tolist(),
             "motor": {"inertia": 0.0, "side": "joint"}}  # fmt: skip
    robot = arm(gravity=9.81, joints=[joint], links=[{"name": "l", "bodies": [body]}],
                drives=[{"joint": "j", "command": "effort", "signal": {"type": "constant", "value": effort}}],
                integration={"duration": 1.0, "output_step": 0.5})  # fmt: skip
    assert tmodes.run(robot).data["q"].values[-1, 0] == pytest.approx(effort / inertia / 2, rel=1e-8)
