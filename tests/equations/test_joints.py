"""Every kind of joint, drive and gear on a small arm of rigid links, against the independent Lagrangian."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np
import pytest

from oracle.arms.lagrange import Lagrangian
from oracle.arms.pair import SPRUNG, Pair, assert_equations_agree, assert_near, assert_parts_agree
from oracle.arms.robots import GRAVITY, arms, turned
from random_chains import random_body, random_state
from tmodes.chain.chain import Chain, Friction, Gear, Joint, Motor, Node
from tmodes.kinds.drives.registry import drive_kind
from tmodes.kinds.joints.registry import joint_kind
from tmodes.kinds.links.rigid import RigidLink
from tmodes.model.model import Model

RUBBED = Friction(0.3, 0.5, 0.2, 0.4, 1e-2)
LINEAR, RISING = Gear((100.0,), damping=0.5), Gear((100.0, 200.0, 300.0), (5.0, 20.0), damping=0.5)


def joint(name: str, **changed: Any) -> Joint:
    """An oblique revolute joint driven directly, changed."""
    oblique = Joint(name, joint_kind("revolute"), turned([1, 1, 0], 0.4, [0.3, 0.0, 0.1]), np.array([0.0, 0.6, 0.8]))
    return replace(oblique, **changed)


def elastic(name: str, gear: Gear = LINEAR, **changed: Any) -> Joint:
    return joint(name, drive=drive_kind("elastic"), motor=Motor(0.2, Friction(0.1)), gear=gear, **changed)


def arm(first: Joint, second: Joint, **changed: Any) -> Chain:
    rng = np.random.default_rng(0)
    links = [RigidLink((random_body(rng),)), RigidLink((random_body(rng), random_body(rng)))]
    nodes = (Node("one", -1, first, links[0]), Node("two", 0, second, links[1]))
    return Chain("arm", nodes, GRAVITY, **changed)


CASES = {
    "direct": arm(joint("a"), joint("b")),
    "rotor": arm(joint("a", motor=Motor(0.4)), joint("b")),
    "friction": arm(joint("a", friction=RUBBED), joint("b", motor=Motor(0.1, RUBBED), friction=RUBBED)),
    "elastic": arm(elastic("a", friction=RUBBED), elastic("b")),
    "rising_gear": arm(elastic("a", RISING), elastic("b", RISING)),
    "slide": arm(joint("a", kind=joint_kind("prismatic")), elastic("b", kind=joint_kind("prismatic"))),
    "spring": arm(joint("a", drive=drive_kind("spring"), gear=LINEAR, rest=0.4), joint("b")),
    "locked_motor": arm(
        joint("a", drive=drive_kind("spring"), gear=RISING, rest=0.4, motor=Motor(0.3, RUBBED)), joint("b")
    ),
    "coupled": arm(elastic("a"), elastic("b"), couplings=np.array([[1.0, 0.2], [-0.3, 0.9]])),
    "fixed": arm(joint("a", kind=joint_kind("fixed")), joint("b")),
}


@cache
def pair(name: str) -> Pair:
    return Pair(CASES[name])


@pytest.mark.parametrize("name", CASES)
def test_equations(name: str) -> None:
    for seed in range(6):
        assert_equations_agree(pair(name), seed, SPRUNG)
        assert_parts_agree(pair(name), seed)


@pytest.mark.parametrize("wound", [0.02, 0.08, 0.3, -0.08, -0.3])
def test_rising_gear_follows_its_table(wound: float) -> None:
    """5 N*m after 0.05 rad, 20 N*m after 0.125 rad, then 300 N*m/rad."""
    chain = replace(CASES["rising_gear"], gravity=np.zeros(3))
    model = Model(chain)
    q = np.array([wound, 0.0, 0.0, 0.0])
    torque = np.sign(wound) * np.interp(abs(wound), [0, 0.05, 0.125, 1.125], [0, 5, 20, 320])
    found = np.asarray(model.inverse_dynamics(q, np.zeros(4), np.zeros(4)))
    np.testing.assert_allclose(found, [torque, 0.0, -torque, 0.0], atol=1e-12)


@pytest.mark.parametrize("gear", [LINEAR, RISING])
def test_nothing_crosses_a_play_and_beyond_it_teeth_only_push(gear: Gear) -> None:
    """Spring and damper from where the teeth meet on, as far as these push; the torque is the slope of the energy."""
    width = 0.01
    model = Model(replace(arm(elastic("a", replace(gear, backlash=width)), joint("b")), gravity=np.zeros(3)))
    without = Model(replace(arm(elastic("a", gear), joint("b")), gravity=np.zeros(3)))

    def torque(of: Model, wound: float, rate: float = 0.0) -> float:
        """On the motor, without its friction."""
        q, v = np.array([wound, 0.0, 0.0]), np.array([rate, 0.0, 0.0])
        return float(np.asarray(of.inverse_dynamics(q, v, np.zeros(3)))[0]) - 0.1 * rate

    def energy(wound: float) -> float:
        return float(model.energies(np.array([wound, 0.0, 0.0]), np.zeros(3))["elastic_gear"])

    for wound, rate in ((0.0, 3.0), (0.003, -2.0), (-0.0099, 50.0), (0.01, 1.0)):
        assert torque(model, wound, rate) == 0.0
        assert energy(wound) == 0.0
    for wound in (0.0101, 0.02, 0.1, -0.02, -0.2):
        beyond = wound - np.sign(wound) * width
        for rate in (0.0, 2.0 * np.sign(wound), -1e-3 * np.sign(wound)):
            assert torque(model, wound, rate) == pytest.approx(torque(without, beyond, rate), rel=1e-12)
        assert torque(model, wound, -1e4 * np.sign(wound)) == 0.0
        slope = (energy(wound + 1e-6) - energy(wound - 1e-6)) / 2e-6
        assert torque(model, wound) == pytest.approx(slope, rel=1e-5)


@pytest.mark.parametrize("name", ["twist_and_bend", "branched", "curved_and_stretched"])
@pytest.mark.parametrize("which", [0, -1])
def test_given_motion_of_a_joint(name: str, which: int) -> None:
    """A prescribed joint: its acceleration is what is given, all others those of the Lagrangian with that one known."""
    chain = arms()[name]
    moving = [i for i, node in enumerate(chain.nodes) if node.joint.kind is not joint_kind("fixed")]
    nodes = list(chain.nodes)
    info = nodes[moving[which]]
    nodes[moving[which]] = replace(
        info, joint=replace(info.joint, drive=drive_kind("prescribed"), motor=None, gear=None)
    )
    chain = replace(chain, nodes=tuple(nodes))
    model, oracle = Model(chain), Lagrangian(chain)
    assert tuple(model.coordinates) == oracle.coordinates
    row = oracle.coordinates.index(info.joint.name)
    free = [i for i in range(oracle.size) if i != row]
    for seed in range(4):
        q, v, _ = random_state(seed, oracle.coordinates)
        effort, given = np.random.default_rng(seed).normal(size=len(oracle.driven)), 1.7
        right = np.zeros(oracle.size)
        right[oracle.driven] = effort
        known = np.zeros(oracle.size)
        known[row] = given
        right -= oracle.inverse_dynamics(q, v, known)
        expected = known.copy()
        expected[free] = np.linalg.solve(oracle.mass_matrix(q)[np.ix_(free, free)], right[free])
        assert_near(model.forward_dynamics(q, v, effort, given=given), expected, SPRUNG)
