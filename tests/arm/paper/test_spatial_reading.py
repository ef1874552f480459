"""The paper's robot built from the general elements: one segment for each mode, in space."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from tmodes.chain.chain import Body, Chain, Friction, Gear, Joint, Motor, Node, Segment
from tmodes.kinds.drives.registry import drive_kind
from tmodes.kinds.joints.registry import joint_kind
from tmodes.model.model import Model
from tmodes.paper.mechanism import Drive as SeedDrive
from tmodes.paper.model import PaperModel
from tmodes.robots import load_robot


def spatial_chain(robot: Any) -> Chain:
    """Motor, gear and two segments; the masses of Eq. (13) at the segments' tips."""
    motor = Motor(robot.motor.inertia, Friction(robot.motor.friction))
    gear = Gear((robot.gear.stiffness,), damping=robot.gear.damping)
    joint = Joint("root", joint_kind("revolute"), drive=drive_kind("elastic"), motor=motor, gear=gear)
    loads = ((0.0, 0.0), (robot.payload.mass, robot.payload.inertia))
    nodes = []
    for k, (mode, (mass, inertia)) in enumerate(zip(robot.link.modes, loads, strict=True)):
        across = mode.tip_inertia + inertia
        body = Body(mode.tip_mass + mass, np.zeros(3), np.diag([0.0, across, across]))
        stiffness, damping = mode.tip_stiffness, mode.tip_damping
        segment = Segment(mode.length, stiffness, stiffness, damping, damping, bodies=(body,))
        nodes.append(Node(f"mode{k + 1}", k - 1, joint if k == 0 else Joint("on", joint_kind("fixed")), segment))
    return Chain("spatial", tuple(nodes), np.array([0.0, 0.0, -robot.gravity]))


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
    robot = load_robot("filipovic2010", {"contact": False})
    mechanism, parameters = robot.split(SeedDrive.VOLTAGE)
    rng = np.random.default_rng(3)
    bending, rates = rng.normal(size=4), rng.normal(size=4)
    angles = np.array([0.3, 0.32, *(size * bending)])
    speeds = np.array([0.5, 0.4, *(size * rates)])
    phi, phid = np.linalg.solve(OF_PHI, angles), np.linalg.solve(OF_PHI, speeds)
    info = PaperModel(mechanism).evaluate(phi, phid, 0.0, parameters)
    model = Model(spatial_chain(robot))
    mass = OF_PHI.T @ model.mass_matrix(angles) @ OF_PHI
    forces = OF_PHI.T @ model.inverse_dynamics(angles, speeds, np.zeros(6))
    # The seed's right side holds the motor's friction and back-EMF; the chain has friction alone.
    friction = np.zeros(6)
    friction[5] = robot.motor.friction * phid[5]
    seed = (info["h"] + info["f_el"] + info["f_di"])[0] + friction
    return (
        float(np.abs(mass - info["H"][0]).max() / np.abs(info["H"]).max()),
        float(np.abs(forces - seed).max() / np.abs(seed).max()),
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
    robot = load_robot("filipovic2010")
    model = Model(spatial_chain(robot))
    first, second = (mode.length for mode in robot.link.modes)
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
