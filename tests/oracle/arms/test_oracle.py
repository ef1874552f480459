"""The oracle is checked first: by another engine where nothing bends, by closed forms where something does."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from oracle.arms.lagrange import Lagrangian
from oracle.arms.pinocchio_bridge import model_of
from oracle.arms.robots import arms, piece, ur5, ur5_table
from random_chains import random_chain, random_state
from tmodes.chain.chain import Chain, Gear, Joint, Motor, Node
from tmodes.kinds.drives.registry import drive_kind
from tmodes.kinds.joints.registry import joint_kind
from tmodes.kinds.links.contract import Body
from tmodes.kinds.links.segment import Segment
from tmodes.kinds.links.strain import Beam

pytest.importorskip("casadi")


def clamped(beam: Beam) -> Lagrangian:
    """A beam on a fixed base, no gravity."""
    return Lagrangian(Chain("clamped", (Node("beam", -1, Joint("clamp", joint_kind("fixed")), beam),), np.zeros(3)))


@pytest.mark.peer
@pytest.mark.parametrize("seed", range(12))
def test_rigid_trees_equal_pinocchio(seed: int) -> None:
    pinocchio = pytest.importorskip("pinocchio")
    chain = random_chain(seed, 6, rigid=True)
    oracle, model = Lagrangian(chain), model_of(chain)
    data = model.createData()
    order = [oracle.coordinates.index(name) for name in list(model.names)[1:]]
    q, v, a = random_state(seed, oracle.coordinates)
    still = pinocchio.rnea(model, data, q[order], 0 * v, 0 * v)
    mass = [pinocchio.rnea(model, data, q[order], 0 * v, unit) - still for unit in np.eye(len(order))]
    np.testing.assert_allclose(oracle.mass_matrix(q)[np.ix_(order, order)], mass, atol=1e-12)
    torque = pinocchio.rnea(model, data, q[order], v[order], a[order])
    np.testing.assert_allclose(oracle.inverse_dynamics(q, v, a)[order], torque, atol=1e-11)
    pinocchio.framesForwardKinematics(model, data, q[order])
    placed = data.oMf[model.nframes - 2]
    places, axes, jacobians = oracle.points(q)
    np.testing.assert_allclose(places[0], placed.translation, atol=1e-13)
    np.testing.assert_allclose(axes[0], placed.rotation, atol=1e-13)
    frame = pinocchio.ReferenceFrame.LOCAL_WORLD_ALIGNED
    jacobian = pinocchio.computeFrameJacobian(model, data, q[order], model.nframes - 2, frame)
    np.testing.assert_allclose(jacobians[0][:, order], jacobian, atol=1e-13)


def test_ur5_equals_reference_values() -> None:
    oracle = Lagrangian(ur5())
    for state in ur5_table()["states"]:
        q, v, a = (np.array(state[name]) for name in ("q", "v", "a"))
        np.testing.assert_allclose(oracle.mass_matrix(q), state["mass_matrix"], atol=1e-12)
        np.testing.assert_allclose(oracle.inverse_dynamics(q, v, a), state["inverse_dynamics"], atol=1e-11)
        accelerations = oracle.forward_dynamics(q, v, np.array(state["tau"]))
        np.testing.assert_allclose(accelerations, state["forward_dynamics"], rtol=1e-9, atol=1e-9)
        energies = oracle.energies(q, v)
        assert energies["kinetic"] == pytest.approx(state["kinetic_energy"], rel=1e-12)


def test_constant_curvature_is_a_circle() -> None:
    oracle = clamped(Beam(2.0, (piece(1.0, 1.0),), bend_y=2, bend_z=2, points=12))
    assert oracle.coordinates == ("beam.bend_y1", "beam.bend_y2", "beam.bend_z1", "beam.bend_z2")
    for angle, index, side in ((1.1, 2, [0, 1, 0]), (1.1, 0, [0, 0, -1])):
        q = np.zeros(4)
        q[index] = angle
        place = 2.0 / angle * (np.array([np.sin(angle), 0, 0]) + (1 - np.cos(angle)) * np.array(side, float))
        np.testing.assert_allclose(oracle.points(q)[0][0], place, atol=1e-13)


def test_stiffness_of_a_uniform_link_is_diagonal() -> None:
    """EI/(L (2j + 1)) for Legendre functions, EA L/(2j + 1) for stretch; EI/(3 L) for the one function 1 - s."""
    beam = Beam(0.5, (piece(6.0, 1.0, torsion=4.0, axial=9.0),), twist=1, bend_y=3, bend_z=0, stretch=2)
    stiffness, _ = clamped(beam).linear_parts(np.zeros(6), np.zeros(6))
    np.testing.assert_allclose(stiffness, np.diag([8.0, 12.0, 4.0, 2.4, 4.5, 1.5]), atol=1e-13)
    beam = Beam(0.5, (piece(6.0, 1.0),), bend_y=1, basis="tip_weighted")
    stiffness, _ = clamped(beam).linear_parts(np.zeros(1), np.zeros(1))
    np.testing.assert_allclose(stiffness, [[4.0]], atol=1e-13)


def test_motor_behind_a_gear_is_a_two_mass_oscillator() -> None:
    """Two rotors on one axis: w^2 = k (1/I + 1/J)."""
    joint = Joint(
        "hub", joint_kind("revolute"), drive=drive_kind("elastic"), motor=Motor(0.2), gear=Gear((50.0,), damping=0.3)
    )
    segment = Segment(0.4, 1.0, 1.0, bend_y=False, bend_z=False, bodies=(Body(2.0, inertia=0.1 * np.eye(3)),))
    oracle = Lagrangian(Chain("c", (Node("rotor", -1, joint, segment),), np.zeros(3)))
    mass, damping, stiffness = oracle.linearize(np.zeros(2), np.zeros(2))
    np.testing.assert_allclose(mass, np.diag([0.2, 2.0 * 0.16 + 0.1]), atol=1e-14)
    np.testing.assert_allclose(stiffness, 50 * np.array([[1, -1], [-1, 1]]), atol=1e-12)
    np.testing.assert_allclose(damping, 0.3 * np.array([[1, -1], [-1, 1]]), atol=1e-12)


@pytest.mark.parametrize("name", list(arms()))
def test_power_is_balanced(name: str) -> None:
    oracle = Lagrangian(arms()[name])
    q, v, _ = random_state(3, oracle.coordinates)
    a = oracle.forward_dynamics(q, v, np.zeros(len(oracle.driven)))
    small = 1e-6 / max(1.0, np.abs(a).max() ** 0.5)

    def energy(h: float) -> float:
        return sum(oracle.energies(q + h * v, v + h * a).values())

    gain = (energy(small) - energy(-small)) / (2 * small)
    assert gain == pytest.approx(-v @ oracle.forces(q, v)[3], rel=1e-4, abs=1e-4)


def test_torque_of_a_free_axis_is_the_rate_of_angular_momentum() -> None:
    """No gravity, first joint about the world's z, no motor on it: its row of the inverse dynamics is dL_z/dt."""
    chain = arms()["twist_and_bend"]
    free = Joint("shoulder", joint_kind("revolute"))
    nodes = (replace(chain.nodes[0], joint=free), *chain.nodes[1:])
    oracle = Lagrangian(replace(chain, nodes=nodes, gravity=np.zeros(3)))
    q, v, a = random_state(5, oracle.coordinates)
    small = 1e-5
    after, before = (oracle.momentum(q + h * v + h * h / 2 * a, v + h * a)[1] for h in (small, -small))
    row = oracle.coordinates.index("shoulder")
    torque = oracle.inverse_dynamics(q, v, a)[row]
    assert (after - before)[2] / (2 * small) == pytest.approx(torque, rel=1e-7)
