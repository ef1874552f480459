"""The paper's robot built from the general elements: one segment for each mode, in space."""

from __future__ import annotations

import numpy as np
import pytest

from lagrange.robot2010 import P
from oracle.oracle import oracle
from tmodes.chain.chain import Chain, Friction, Gear, Joint, Motor, Node
from tmodes.kinds.drives.registry import drive_kind
from tmodes.kinds.joints.registry import joint_kind
from tmodes.kinds.links.contract import Body
from tmodes.kinds.links.segment import Segment
from tmodes.model.model import Model


def spatial_chain() -> Chain:
    """Motor, gear and two segments; the masses of Eq. (13) at the segments' tips."""
    joint = Joint(
        "root", joint_kind("revolute"), drive=drive_kind("elastic"),
        motor=Motor(P["I"], Friction(P["Bm"])), gear=Gear((P["Cxi"],), damping=P["Bxi"]),
    )  # fmt: skip
    nodes = []
    for k, (mass, inertia) in enumerate(((0.0, 0.0), (P["m"], P["Jzz"])), 1):
        across = P[f"Jel{k}"] + inertia
        body = Body(P[f"mel{k}"] + mass, np.zeros(3), np.diag([0.0, across, across]))
        stiffness, damping = P[f"Cs{k}"], P[f"Bs{k}"]
        segment = Segment(P[f"l{k}"], stiffness, stiffness, damping, damping, bodies=(body,))
        nodes.append(Node(f"mode{k}", k - 2, joint if k == 1 else Joint("on", joint_kind("fixed")), segment))
    return Chain("spatial", tuple(nodes), np.array([0.0, 0.0, -P["g"]]))


# Angles of the chain [theta, gamma, th1y, th1z, th2y, th2z] from phi = [q, delta, gamma, vt, e, theta].
OF_PHI = np.array(
    [
        [0, 0, 0, 0, 0, 1],
        [0, 0, 1, 0, 0, 0],
        [0, 0, 0, -1, 0, 0],
        [1, 0, -1, 0, 0, 0],
        [0, 0, 0, 0.5, -1, 0],
        [-0.5, 1, 0.5, 0, 0, 0],
    ]
)


def difference(size: float) -> tuple[float, float]:
    """Largest difference of mass matrix and of all forces, over the largest of each, with bending of the size given."""
    rng = np.random.default_rng(3)
    bending, rates = rng.normal(size=4), rng.normal(size=4)
    angles = np.array([0.3, 0.32, *(size * bending)])
    speeds = np.array([0.5, 0.4, *(size * rates)])
    phi, phid = np.linalg.solve(OF_PHI, angles), np.linalg.solve(OF_PHI, speeds)
    info = oracle(phi, phid, 0.0, P, "consistent", contact=False)
    model = Model(spatial_chain())
    mass = OF_PHI.T @ model.mass_matrix(angles) @ OF_PHI
    forces = OF_PHI.T @ model.inverse_dynamics(angles, speeds, np.zeros(6))
    # The paper's right side holds the motor's friction and back-EMF; the chain has friction alone.
    friction = np.zeros(6)
    friction[5] = P["Bm"] * phid[5]
    expected = info["h"] + info["f_el"] + info["f_di"] + friction
    return (
        float(np.abs(mass - info["H"]).max() / np.abs(info["H"]).max()),
        float(np.abs(forces - expected).max() / np.abs(expected).max()),
    )


def test_agrees_with_consistent_to_second_order() -> None:
    sizes = np.array([0.04, 0.02, 0.01, 0.005])
    found = np.array([difference(size) for size in sizes])
    assert np.all(found < 0.05)
    for column in found.T:
        slope = np.polyfit(np.log(sizes), np.log(column), 1)[0]
        assert slope == pytest.approx(2.0, abs=0.35) or slope > 2.0


def test_segments() -> None:
    """The tip's tangent turns by 3/2 of the chord's angle, in both planes."""
    model = Model(spatial_chain())
    first, second = P["l1"], P["l2"]
    angle = 0.2
    position, rotation = model.pose([0.0, 0.0, 0.0, angle, 0.0, 0.0])
    assert position[0] == pytest.approx(
        [
            first * np.cos(angle) + second * np.cos(1.5 * angle),
            first * np.sin(angle) + second * np.sin(1.5 * angle),
            0.0,
        ]
    )
    assert rotation[0][:, 0] == pytest.approx([np.cos(1.5 * angle), np.sin(1.5 * angle), 0.0])
    position, _ = model.pose([0.0, 0.0, -angle, 0.0, 0.0, 0.0])
    assert position[0][2] == pytest.approx(first * np.sin(angle) + second * np.sin(1.5 * angle))
