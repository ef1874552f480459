"""The 2010 robot as a chain of given numbers, its terms in the paper's coordinates, and the sample states."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from oracle.parameters import with_equivalents
from tmodes.analysis.line.line import elastic_line
from tmodes.chain.chain import Chain, Friction, Gear, Joint, Motor, Node, Point
from tmodes.equations.lagrange.filipovic2010 import basis
from tmodes.equations.loop.contact_kernels import Touch
from tmodes.equations.loop.control_kernels import Servo, Winding
from tmodes.equations.loop.plan import DrivePlan, LoopPlan, TouchPlan
from tmodes.kinds.contacts.dynamic_environment import DynamicEnvironment
from tmodes.kinds.drives.registry import drive_kind
from tmodes.kinds.joints.registry import joint_kind
from tmodes.kinds.links.contract import Body
from tmodes.kinds.links.modes import ModesLink
from tmodes.kinds.links.modes_sheet import Mode
from tmodes.model.model import Model
from tmodes.sheet.robot import Robot
from tmodes.simulation.loop import LoopModel

STATES = json.loads((Path(__file__).parents[1] / "oracle" / "reference_states.json").read_text(encoding="utf-8"))
P: dict[str, float] = STATES["parameters"]

TO_PAPER = np.zeros((6, 6))
"""phi = TO_PAPER [motor, joint, azimuth1, azimuth2, elevation1, elevation2]."""
TO_PAPER[:5, 1:] = basis()
TO_PAPER[5, 0] = 1.0
TO_ROBOT = np.linalg.inv(TO_PAPER)

Numbers = Mapping[str, float]


def symbols(robot: Robot) -> dict[str, float]:
    """The paper's symbols of a robot that was read of its sheet: its numbers as known; of its pair's other one, too."""
    joint, link, touch = robot.joints[0], robot.links[0], robot.contact or robot.contact_off
    motor, body, gear, beam = joint.motor, link.bodies[0], joint.gear, link.beam
    assert motor
    assert motor.friction
    assert gear
    assert body.inertia
    assert isinstance(touch, DynamicEnvironment)
    found: dict[str, Any] = {
        "g": float(np.linalg.norm(robot.gravity)), "R": motor.resistance, "CE": motor.back_emf_constant,
        "CM": motor.torque_constant, "I": motor.inertia, "Bm": motor.friction.viscous, "Cxi": gear.stiffness[0],
        "Bxi": gear.damping, "m": body.mass, "Jzz": body.inertia.xx, "me": touch.mass, "be": touch.damping,
        "Fc0": touch.preload, "ka1": touch.stiffness, "mu": touch.friction, "veps": touch.friction_velocity,
    }  # fmt: skip
    for k, mode in enumerate(getattr(beam, "modes"), 1):  # noqa: B009
        found |= {f"l{k}": mode.length, f"EI{k}": mode.bending_stiffness, f"w{k}": mode.mass_per_length,
                  f"eta{k}": mode.damping_time}  # fmt: skip
    return with_equivalents(found)


def chain(equations: str, p: Numbers = P) -> Chain:
    """One joint with motor and elastic gear, one link of two modes with the payload."""
    modes = tuple(
        Mode(
            length=p[f"l{k}"],
            bending_stiffness=p[f"Cs{k}"] * p[f"l{k}"] ** 3 / 3,
            mass_per_length=p[f"w{k}"],
            damping_time=p[f"Bs{k}"] / p[f"Cs{k}"],
        )
        for k in (1, 2)
    )
    link = ModesLink(modes, ((1.0, Body(p["m"], np.zeros(3), p["Jzz"] * np.eye(3))),))
    motor = Motor(p["I"], Friction(p["Bm"]), p["R"], p["CE"], p["CM"])
    gear = Gear((p["Cxi"],), (), p["Bxi"])
    joint = Joint("joint", joint_kind("revolute"), drive=drive_kind("elastic"), motor=motor, gear=gear)
    gravity = np.array([0.0, 0.0, -p["g"]])
    return Chain("2010", (Node("link", -1, joint, link),), gravity, points=(Point("tip", 0),), equations=equations)


def plan(equations: str, p: Numbers = P, *, contact: bool, law: str = "signed") -> LoopPlan:
    """The robot at a voltage, a constant signal, in contact with its environment or free."""
    ball = {"type": "ball", "center": [0.0, 0.0, 0.0], "radius": p["l1"] + p["l2"], "inside": True}
    data: dict[str, Any] = {
        "law": "dynamic_environment", "point": "tip", "shape": ball, "mass": p["me"], "damping": p["be"],
        "preload": p["Fc0"], "stiffness": p["ka1"], "friction": p["mu"], "friction_velocity": p["veps"],
        "friction_law": law,
    }  # fmt: skip
    robot = chain(equations, p)
    touch = Touch(DynamicEnvironment.model_validate(data))
    servo = Servo(None, driven=True, winding=Winding.RESISTANCE)
    drive = DrivePlan("joint", 0, servo, Winding.RESISTANCE, (p["R"], p["CE"], p["CM"], 0.0))
    touched = TouchPlan(0, touch, touch.numbers(robot.gravity)) if contact else None
    return replace(LoopPlan(robot, (drive,), signals=1, degree=0), touch=touched)


def terms(
    equations: str, phi: Any, phid: Any, u: float = 0.0, p: Numbers = P, *, contact: bool = False, law: str = "signed"
) -> dict[str, Any]:
    """What the package says of one state, by the names, units and conventions of the sample states and the oracle."""
    model, loop = Model(chain(equations, p)), LoopModel(plan(equations, p, contact=contact, law=law))
    z, v, still = TO_ROBOT @ np.asarray(phi), TO_ROBOT @ np.asarray(phid), np.zeros(6)
    friction = np.eye(6)[5] * p["Bm"] * phid[5]  # a force of the drive here, a part of the input Q there
    springs = TO_ROBOT.T @ model.elastic_forces(z, still)
    energy = model.energies(z, v)
    seen = loop.observe(0.0, np.concatenate([z, v, np.zeros(7)]), np.array([0.0, u]))
    found = {
        "H": TO_ROBOT.T @ model.mass_matrix(z) @ TO_ROBOT,
        "h": TO_ROBOT.T @ model.bias(z, v),
        "f_el": springs,
        "f_di": TO_ROBOT.T @ model.elastic_forces(z, v) - springs - friction,
        "Q": np.eye(6)[5] * seen["drives"][0, 0, 0] - friction,
        "tip": model.pose(z)[0][0],
        "J": model.jacobian(z)[0][:3] @ TO_ROBOT,
        "kinetic": energy["kinetic"],
        "potential_gravity": energy["gravity"],
        "potential_elastic": energy["elastic_gear"] + energy["elastic_link"],
        "rayleigh": (model.power_lost(z, v) - friction[5] * phid[5]) / 2,
        "energy": sum(energy.values()),
        "phidd": TO_PAPER @ seen["a"][0],
    }
    return found | ({"F_tip_on_environment": seen["contact"][0, :3]} if contact else {})


def lines(equations: str, phi: Any, phid: Any, phidd: Any, force: Any, p: Numbers, places: Any) -> dict[str, Any]:
    """The package's elastic line of both modes, by the names and axes of the oracle's."""
    motion = (TO_ROBOT @ np.asarray(x) for x in (phi, phid, phidd))
    wrench = np.concatenate([-np.asarray(force), np.zeros(3)])[None, None]
    model = Model(chain(equations, p))
    found: dict[str, list[Any]] = {}
    for one in elastic_line(model, *motion, stations=list(places), wrenches=wrench).bending():
        assert one.shape is not None
        own = {"line": one.position, "deflection": one.shape.deflection, "slope": one.shape.slope,
               "bending_moment": one.moment[..., [2, 1]] * [1, -1], "shear_force": one.shear,
               "flexibility_moment": one.shape.elastic_moment[..., [2, 1]] * [1, -1]}  # fmt: skip
        for name, values in own.items():
            found.setdefault(name, []).append(values[0])
    return {name: np.array(values) for name, values in found.items()}


def close(found: Any, expected: Any, digits: float = 1e-9) -> None:
    """Equal to ``digits`` of the largest entry."""
    found, expected = np.asarray(found), np.asarray(expected)
    assert found.shape == expected.shape
    assert np.abs(found - expected).max() <= digits * max(np.abs(expected).max(), 1e-12)
