"""All derivatives of the forward dynamics of the rigid chain: ours, and Pinocchio's as called from Python.

``python -m benchmarks.peers.derivatives [joints]`` prints medians in microseconds and the median of their ratios.
"""

from __future__ import annotations

import statistics
import sys
import time
from typing import Any

import numpy as np
from benchmarks.peers import rigid_chain
from scipy.spatial.transform import Rotation

from tmodes.arm_model import ArmModel
from tmodes.chain import Body, Chain, Joint, JointKind, Node, Placement, RigidLink

__all__ = ["main", "pinocchio_chain", "same_chain"]

_CALLS, _ROUNDS = 40, 25


def same_chain(joints: int) -> Chain:
    """The chain of :mod:`benchmarks.peers.rigid_chain` in our terms."""
    turned = (Rotation.from_euler("z", 0.3) * Rotation.from_euler("x", 0.2)).as_matrix()
    body = Body(1.0, np.array([0.05, 0.01, 0.02]), np.diag([0.01, 0.02, 0.02]))
    nodes = []
    for k, (axis, place) in enumerate(rigid_chain._links(joints)):
        joint = Joint(f"j{k}", JointKind.REVOLUTE, Placement(turned, place), axis)
        nodes.append(Node(f"l{k}", k - 1, joint, RigidLink((body,))))
    return Chain("rigid", tuple(nodes), np.array([0.0, 0.0, -9.81]))


def pinocchio_chain(joints: int) -> tuple[Any, Any]:
    """Pinocchio's model of it, and its data; raises ImportError where Pinocchio is absent."""
    import pinocchio as pin

    model, parent = pin.Model(), 0
    for k, (axis, place) in enumerate(rigid_chain._links(joints)):
        kind = (pin.JointModelRX(), pin.JointModelRY(), pin.JointModelRZ())[int(np.argmax(axis))]
        turned = pin.SE3(pin.utils.rotate("z", 0.3) @ pin.utils.rotate("x", 0.2), place)
        parent = model.addJoint(parent, kind, turned, f"j{k}")
        body = pin.Inertia(1.0, np.array([0.05, 0.01, 0.02]), np.diag([0.01, 0.02, 0.02]))
        model.appendBodyToJoint(parent, body, pin.SE3.Identity())
    return model, model.createData()


def main(joints: int) -> None:
    """Measure side by side."""
    import pinocchio as pin

    ours, (peer, data) = ArmModel(same_chain(joints)), pinocchio_chain(joints)
    q, v, effort = np.random.default_rng(0).normal(size=(3, joints))
    calls = {
        "ours": lambda: ours.forward_dynamics_derivatives(q, v, effort),
        "pinocchio": lambda: pin.computeABADerivatives(peer, data, q, v, effort),
    }
    times: dict[str, list[float]] = {name: [] for name in calls}
    for call in calls.values():
        call()
    for _ in range(_ROUNDS):
        for name, call in calls.items():
            began = time.perf_counter()
            for _ in range(_CALLS):
                call()
            times[name].append((time.perf_counter() - began) / _CALLS * 1e6)
    told = "  ".join(f"{name} {statistics.median(values):.1f} us" for name, values in times.items())
    ratios = [one / other for one, other in zip(times["ours"], times["pinocchio"], strict=True)]
    print(f"{joints} joints: {told}  ratio {statistics.median(ratios):.2f}")


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 36)
