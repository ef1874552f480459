"""Reactions of a robot at rest: the base holds all weight and loads, each joint those of what is beyond."""

from __future__ import annotations

import json

import numpy as np
import pytest

from command import tmodes
from tmodes import load
from tmodes.analysis.statics.at_rest import robot_rest
from tmodes.analysis.statics.equilibrium import Load
from tmodes.analysis.statics.reactions import reactions
from tmodes.sheet import Robot


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("name", ["manutec_r3", "flexarm1990", "spong1987"])
def test_each_joint_carries_what_is_beyond(name: str, seed: int) -> None:
    """The base: all weight, and the loads about it; joints: what their own coordinate feels along its axis."""
    rng = np.random.default_rng(seed)
    robot = load(name).with_({"gravity": rng.uniform(-9, 9, 3).tolist()})
    force, moment = rng.uniform(-3, 3, (2, 3))
    rest = robot_rest(robot, [Load("tip", force, moment)])
    model, found = rest.model, {one["at"]: one for one in reactions(robot, rest) or ()}
    mass = sum(body.mass for node in model.chain.nodes for body in node.link.unbent_bodies())
    total = np.array(found["base"]["force_N"])
    np.testing.assert_allclose(total, -(mass * np.array(robot.gravity) + force), rtol=1e-9, atol=1e-9)
    step, tip = 1e-6, model.pose(rest.q)[0][0]
    first = found[robot.joints[0].name]
    about = np.array(first["moment_Nm"]) + np.cross(np.array(first["position_m"]) - found["base"]["position_m"], total)
    np.testing.assert_allclose(found["base"]["moment_Nm"], about, rtol=0, atol=1e-8 * (1 + np.abs(about).max()))
    for axis in model.parts.axes:  # virtual work of weight and loads along each joint's own coordinate
        one = found[axis.axis.name]
        moved = rest.q + step * np.eye(model.nq)[axis.angle]
        back = rest.q - step * np.eye(model.nq)[axis.angle]
        turn = (model.pose(moved)[1][0] - model.pose(back)[1][0]) / (2 * step) @ model.pose(rest.q)[1][0].T
        rate = np.array([turn[2, 1], turn[0, 2], turn[1, 0]])
        work = model.gravity(rest.q)[axis.angle] - moment @ rate
        work -= force @ (model.pose(moved)[0][0] - model.pose(back)[0][0]) / (2 * step)
        assert np.array(one["moment_Nm"]) @ rate == pytest.approx(work, rel=1e-6, abs=1e-6)
    assert np.isfinite(tip).all()


def test_a_cantilever_by_hand() -> None:
    """Rod of 2 kg/m, 1 m long, 3 kg at its tip: 5 g at the root, g (2/2 + 3) about it."""
    beam = {"model": "strain", "functions": {"bend_y": 4}, "length": 1.0, "damping_time": 0.0,
            "section": {"bending_stiffness": 1e7, "mass_per_length": 2.0}}  # fmt: skip
    robot = Robot.from_data({
        "format": 1, "kind": "arm", "name": "rod", "gravity": 10.0,
        "joints": [{"name": "root", "type": "fixed", "child": "rod", "origin": {"position": [0, 0, 2]}}],
        "links": [{"name": "rod", "beam": beam, "bodies": [{"name": "tip", "mass": 3.0, "at": 1.0}]}],
    })  # fmt: skip
    base, root = reactions(robot, robot_rest(robot)) or []
    assert root["position_m"] == pytest.approx([0, 0, 2])
    for one in (base, root):
        assert one["force_N"] == pytest.approx([0, 0, 50], abs=1e-9)
        assert one["moment_Nm"] == pytest.approx([0, -40, 0], rel=1e-6, abs=1e-9)


def test_they_are_printed() -> None:
    printed = " ".join(tmodes("static", "spong1987").stdout.split())
    assert "Reactions of the base and of each joint on what it carries, world axes" in printed
    info = json.loads(tmodes("static", "spong1987", "--json").stdout)["reactions"]
    assert [one["at"] for one in info] == ["base", "joint"]
