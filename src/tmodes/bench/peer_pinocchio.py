"""Pinocchio's articulated-body algorithm on the same chain, called from Python as its users do."""

from __future__ import annotations

from typing import Any

import numpy as np

from tmodes.bench.contender import CHECKED, Contender, PeerMissing, needed, now
from tmodes.bench.rigid import CENTER, INERTIA, MASS, TURNED, RigidChain

__all__ = ["LARGEST", "contender", "model"]

LARGEST = 300
"""Joints above which it is left out: its data keep tables of the cube of them, 32 GB at a thousand."""

_CALLS = 300


def model(robot: RigidChain) -> tuple[Any, Any]:
    """The module and the model; raises :class:`PeerMissing` where Pinocchio is absent or too large."""
    if robot.joints > LARGEST:
        raise PeerMissing(f"above {LARGEST} joints: its data grow with the cube of them")
    pin = needed("pinocchio", "pin")
    made, parent = pin.Model(), 0
    kinds = (pin.JointModelRX, pin.JointModelRY, pin.JointModelRZ)
    for k, (axis, place) in enumerate(zip(robot.axes, robot.places, strict=True)):
        parent = made.addJoint(parent, kinds[axis](), pin.SE3(TURNED, place), f"j{k}")
        made.appendBodyToJoint(parent, pin.Inertia(MASS, CENTER, np.diag(INERTIA)), pin.SE3.Identity())
    return pin, made


def contender(robot: RigidChain) -> Contender:
    """``aba`` at one state after the other."""
    pin, made = model(robot)
    data, none = made.createData(), np.zeros(robot.joints)
    states = list(zip(*robot.states(_CALLS), strict=True))

    def run() -> float:
        began = now()
        for q, v in states:
            pin.aba(made, data, q, v, none)
        return (now() - began) / _CALLS

    def found() -> Any:
        q, v = robot.states(1024)
        return np.array([pin.aba(made, data, q[k], v[k], none) for k in range(CHECKED)])

    return Contender(f"Pinocchio {pin.__version__} aba, from Python", run, found)
