"""All derivatives of the forward dynamics of the rigid chain: ours, and Pinocchio's as called from Python.

``python -m benchmarks.peers.derivatives [joints]`` prints medians in microseconds and the median of their ratios.
"""

from __future__ import annotations

import statistics
import sys
import time

import numpy as np

from tmodes.arm_model import ArmModel
from tmodes.bench.peer_pinocchio import model
from tmodes.bench.rigid import RigidChain

__all__ = ["main"]

_CALLS, _ROUNDS = 40, 25


def main(joints: int) -> None:
    """Measure side by side."""
    robot = RigidChain(joints)
    ours, (pin, peer) = ArmModel(robot.chain()), model(robot)
    data = peer.createData()
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
