"""The link kind ``modes`` in the recursion equals the 2010 robot in its ``consistent`` reading."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from tmodes.analysis.line.line import elastic_line
from tmodes.chain.chain import Body, Chain, Friction, Gear, Joint, Motor, Node
from tmodes.kinds.drives.registry import drive_kind
from tmodes.kinds.joints.registry import joint_kind
from tmodes.kinds.links.modes import ModesLink
from tmodes.model.model import Model
from tmodes.paper.mechanism import Drive as PaperDrive
from tmodes.paper.model import PaperModel
from tmodes.robots import load_robot

OF_OWN = np.array(
    [
        [0, 1, 1, 0, 0, 0],
        [0, 0, 0.5, 1, 0, 0],
        [0, 1, 0, 0, 0, 0],
        [0, 0, 0, 0, 1, 0],
        [0, 0, 0, 0, 0.5, 1],
        [1, 0, 0, 0, 0, 0],
    ]
)
"""phi = [q, delta, gamma, vt, e, theta] from [motor, joint, azimuth1, azimuth2, elevation1, elevation2]."""


def random_robot(seed: int) -> Any:
    """The 2010 robot with every number of link, payload, gear and motor changed by a factor."""
    rng = np.random.default_rng(seed)

    def near(value: float) -> float:
        return float(value * np.exp(rng.uniform(-0.7, 0.7)))

    robot = load_robot("filipovic2010", {"contact": False})
    changes = {}
    for path, group in (("payload", robot.payload), ("gear", robot.gear), ("motor", robot.motor)):
        changes |= {f"{path}.{name}": near(x) for name, x in group.model_dump().items() if isinstance(x, float) and x}
    for k, mode in enumerate(robot.link.modes):
        changes |= {f"link.modes.{k}.{name}": near(x) for name, x in mode.model_dump().items()}
    return load_robot("filipovic2010", {"contact": False, **changes})


def chain_of(robot: Any) -> Chain:
    """Motor, elastic gear, and one link."""
    motor = Motor(robot.motor.inertia, Friction(robot.motor.friction))
    gear = Gear((robot.gear.stiffness,), damping=robot.gear.damping)
    joint = Joint("joint", joint_kind("revolute"), drive=drive_kind("elastic"), motor=motor, gear=gear)
    payload = Body(robot.payload.mass, np.zeros(3), robot.payload.inertia * np.eye(3))
    link = ModesLink(tuple(robot.link.modes), ((1.0, payload),))
    return Chain("paper", (Node("link", -1, joint, link),), np.array([0.0, 0.0, -robot.gravity]))


def near(found: Any, expected: Any, bound: float = 1e-12) -> None:
    found, expected = np.asarray(found), np.asarray(expected)
    assert np.abs(found - expected).max() <= bound * np.abs(expected).max()


@pytest.mark.parametrize("seed", range(6))
def test_equals_the_consistent_lagrangian(seed: int) -> None:
    """H, h, elastic and damping forces, energies, losses; accelerations to rounding times the condition of H."""
    robot = random_robot(seed)
    mechanism, parameters = robot.split(PaperDrive.VOLTAGE)
    model, paper, rng = Model(chain_of(robot)), PaperModel(mechanism), np.random.default_rng(100 + seed)
    assert model.coordinates[2:] == ("link.azimuth1", "link.azimuth2", "link.elevation1", "link.elevation2")
    back = np.linalg.inv(OF_OWN)
    for size in (0.01, 0.1, 0.5):
        x, rate = size * rng.normal(size=6), rng.normal(size=6)
        x[1] = x[0] + 0.02 * rng.normal()
        phi, phid, voltage = OF_OWN @ x, OF_OWN @ rate, float(rng.normal() * 20)
        info = {name: np.asarray(value)[0] for name, value in paper.evaluate(phi, phid, voltage, parameters).items()}
        near(back.T @ model.mass_matrix(x) @ back, info["H"])
        near(back.T @ model.bias(x, rate), info["h"])
        friction = np.zeros(6)
        friction[0] = robot.motor.friction * rate[0]
        near(back.T @ (model.elastic_forces(x, rate) - friction), info["f_el"] + info["f_di"])
        energies = model.energies(x, rate)
        near(energies["kinetic"], info["kinetic"])
        near(energies["gravity"], info["potential_gravity"])
        near(energies["elastic_gear"] + energies["elastic_link"], info["potential_elastic"])
        losses = model.losses(x, rate)
        near(losses["gear_damping"] + losses["link_damping"], 2 * info["rayleigh"])
        torque = robot.motor.torque(voltage, phid[5])
        found = OF_OWN @ model.forward_dynamics(x, rate, [torque])
        near(found, info["phidd"], max(1e-12, 1e-14 * np.linalg.cond(info["H"])))


@pytest.mark.parametrize("seed", range(3))
def test_lines_of_modes_are_those_of_the_paper(seed: int) -> None:
    """Line, deflection, slope, moments and shear of both modes, under a force on the tip."""
    robot = random_robot(seed)
    mechanism, parameters = robot.split(PaperDrive.VOLTAGE)
    model, paper, rng = Model(chain_of(robot)), PaperModel(mechanism), np.random.default_rng(200 + seed)
    x, rate, gain = 0.3 * rng.normal(size=(4, 6)), rng.normal(size=(4, 6)), 5 * rng.normal(size=(4, 6))
    force = 20 * rng.normal(size=(4, 3))
    s = np.linspace(0.0, 1.0, 5)
    motion = np.concatenate([*(part @ OF_OWN.T for part in (x, rate, gain)), force], axis=1)
    paper_line = paper.line(motion, s, parameters)
    wrenches = np.concatenate([-force, np.zeros((4, 3))], axis=1)[:, None]
    lines = elastic_line(model, x, rate, gain, stations=s.tolist(), wrenches=wrenches)
    assert [*lines.links] == ["link.1", "link.2"]
    for k, line in enumerate(lines.bending()):
        assert line.shape is not None
        found = {"line": line.position, "deflection": line.shape.deflection, "slope": line.shape.slope,
                 "bending_moment": line.moment[..., [2, 1]] * [1, -1], "shear_force": line.shear,
                 "flexibility_moment": line.shape.elastic_moment[..., [2, 1]] * [1, -1]}  # fmt: skip
        for name, values in found.items():
            near(values, np.asarray(paper_line[name])[:, k])
