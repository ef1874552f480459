"""The 2010 robot as a chain, and its sample states in the paper's coordinates."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from tmodes.chain.chain import Body, Chain, Friction, Gear, Joint, Motor, Node, Point
from tmodes.equations.lagrange.filipovic2010 import basis
from tmodes.equations.loop.contact_kernels import Touch
from tmodes.equations.loop.control_kernels import Servo, Winding
from tmodes.equations.loop.plan import DrivePlan, LoopPlan, TouchPlan
from tmodes.kinds.contacts.dynamic_environment import DynamicEnvironment
from tmodes.kinds.drives.registry import drive_kind
from tmodes.kinds.joints.registry import joint_kind
from tmodes.kinds.links.modes import ModesLink
from tmodes.kinds.links.modes_sheet import Mode

STATES = json.loads((Path(__file__).parents[1] / "oracle" / "reference_states.json").read_text())
P = STATES["parameters"]

TO_PAPER = np.zeros((6, 6))
"""phi = TO_PAPER [motor, joint, azimuth1, azimuth2, elevation1, elevation2]."""
TO_PAPER[:5, 1:] = basis()
TO_PAPER[5, 0] = 1.0
TO_ROBOT = np.linalg.inv(TO_PAPER)


def chain(equations: str) -> Chain:
    """The real robot: one joint with motor and elastic gear, one link of two modes with the payload."""
    modes = tuple(
        Mode(
            length=P[f"l{k}"],
            bending_stiffness=P[f"Cs{k}"] * P[f"l{k}"] ** 3 / 3,
            mass_per_length=P[f"w{k}"],
            damping_time=P[f"Bs{k}"] / P[f"Cs{k}"],
        )
        for k in (1, 2)
    )
    link = ModesLink(modes, ((1.0, Body(P["m"], np.zeros(3), P["Jzz"] * np.eye(3))),))
    motor = Motor(P["I"], Friction(P["Bm"]), P["R"], P["CE"], P["CM"])
    gear = Gear((P["Cxi"],), (), P["Bxi"])
    joint = Joint("joint", joint_kind("revolute"), drive=drive_kind("elastic"), motor=motor, gear=gear)
    gravity = np.array([0.0, 0.0, -P["g"]])
    return Chain("2010", (Node("link", -1, joint, link),), gravity, points=(Point("tip", 0),), equations=equations)


def plan(equations: str, *, contact: bool, law: str = "signed") -> LoopPlan:
    """The robot at a voltage, a constant signal, in contact with its environment or free."""
    ball = {"type": "ball", "center": [0.0, 0.0, 0.0], "radius": P["l1"] + P["l2"], "inside": True}
    data: dict[str, Any] = {
        "law": "dynamic_environment", "point": "tip", "shape": ball, "mass": P["me"], "damping": P["be"],
        "preload": P["Fc0"], "stiffness": P["ka1"], "friction": P["mu"], "friction_velocity": P["veps"],
        "friction_law": law,
    }  # fmt: skip
    robot = chain(equations)
    touch = Touch(DynamicEnvironment.model_validate(data))
    servo = Servo(None, driven=True, winding=Winding.RESISTANCE)
    drive = DrivePlan("joint", 0, servo, Winding.RESISTANCE, (P["R"], P["CE"], P["CM"], 0.0))
    touched = TouchPlan(0, touch, touch.numbers(robot.gravity)) if contact else None
    return replace(LoopPlan(robot, (drive,), signals=1, degree=0), touch=touched)
