"""The speed of an arm of true beams, side by side in one go with other engines' rigid chains of as many coordinates.

    python -m benchmarks.arm [--rounds 9] [--joints 6] [--json FILE]

Six joints, each with motor and elastic gear, and six links `strain` with 3 + 3 bending functions and one of twist: 54
coordinates, geometrically exact. The error next to our times is the residual of the equations of motion, by the
independent pass of inverse dynamics, over the largest force. A rigid chain has no beams in it: the comparison is what
as many coordinates cost elsewhere. Contenders take turns; medians are printed.
"""

from __future__ import annotations

import argparse
import json
import platform
import statistics
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np
from benchmarks.engines.contender import PeerMissing, now
from benchmarks.engines.peers import ENGINES
from benchmarks.engines.rigid import RigidChain

from tmodes.chain.chain import Chain, Friction, Gear, Joint, Motor, Node
from tmodes.compile.ir import kernels
from tmodes.equations.recursion.forward import forward_dynamics
from tmodes.frame import Placement
from tmodes.kinds.drives.registry import drive_kind
from tmodes.kinds.joints.registry import joint_kind
from tmodes.kinds.links.strain import Beam, BeamPiece
from tmodes.model.model import Model

_SAMPLES = 2_000


def chain(joints: int, functions: int = 3) -> Chain:
    """An arm of tubes of 0.4 m; joint axes across, along and across again."""
    piece = BeamPiece(
        1.0, (2000.0, 2000.0), (2000.0, 2000.0), (1500.0, 1500.0), (1e7, 1e7), (2.0, 2.0),
        ((2e-3, 2e-3), (0.0, 0.0), (0.0, 0.0)),
    )  # fmt: skip
    turned = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]])
    nodes = []
    for k in range(joints):
        joint = Joint(
            f"j{k}", joint_kind("revolute"), Placement(turned if k % 2 else np.eye(3)), drive=drive_kind("elastic"),
            motor=Motor(0.2, Friction(0.1)), gear=Gear((8000.0,), damping=1.0),
        )  # fmt: skip
        link = Beam(0.4, (piece,), twist=1, bend_y=functions, bend_z=functions, damping_time=3e-5)
        nodes.append(Node(f"l{k}", k - 1, joint, link))
    return Chain("bench", tuple(nodes), np.array([0.0, 0.0, -9.81]))


class Robot:
    """Our side: forward dynamics of many states in one native call."""

    def __init__(self, joints: int) -> None:
        self.model = Model(chain(joints))
        self.schedule = forward_dynamics(self.model.parts)
        n, rng = self.model.nq, np.random.default_rng(0)
        self.q, self.v = 0.05 * rng.normal(size=(_SAMPLES, n)), rng.normal(size=(_SAMPLES, n))
        blocks = {"q": self.q, "v": self.v, "base": np.tile(self.model.at_rest(), (_SAMPLES, 1))}
        rows = [blocks.get(name, np.zeros((_SAMPLES, slot.size))) for name, slot in self.schedule.inputs.items()]
        self.rows = np.ascontiguousarray(np.concatenate(rows, axis=1))
        self.out = np.empty((_SAMPLES, n))

    def contender(self, arithmetic: str) -> Callable[[], float]:
        """Seconds per state."""
        library = kernels.schedule_function("arm", self.schedule, arithmetic)
        width = 4 if arithmetic == "lanes" else 1
        parameters, workspace = self.model.parameters, np.zeros(self.schedule.workspace * width)

        def run() -> float:
            arrays = (parameters, workspace, self.rows, self.out)
            began = now()
            library["run"](_SAMPLES // width, 0, *(array.ctypes.data for array in arrays))
            return (now() - began) / _SAMPLES

        return run

    def error(self) -> float:
        """Residual of the equations of motion over the largest force."""
        first = slice(0, 50)
        forces = self.model.inverse_dynamics(self.q[first], self.v[first], self.out[first])
        terms = self.model.elastic_forces(self.q[first], self.v[first])
        return float(np.abs(forces).max() / np.abs(terms).max())


_COLD = """
import time, casadi, llvmlite.binding, numpy, tmodes.model.model, tmodes.model.passes, tmodes.compile.ir.block
from benchmarks.arm import chain
from tmodes.model.model import Model
import numpy as np
model = Model(chain({joints}))
began = time.process_time()
zero = np.zeros(model.nq)
model.forward_dynamics(zero, zero)
print(time.process_time() - began)
"""


def start_time(joints: int) -> float:
    """Processor seconds until the first forward dynamics, with an empty cache."""
    import os
    import tempfile

    with tempfile.TemporaryDirectory() as folder:
        environment = os.environ | {"TMODES_CACHE": f"{folder}/cache"}
        command = [sys.executable, "-c", _COLD.format(joints=joints)]
        info = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
    return float(info.stdout)


def peers(coordinates: int) -> dict[str, Callable[[], float]]:
    """Rigid chains of as many coordinates, in the engines that are installed."""
    found: dict[str, Callable[[], float]] = {}
    for engine in ("pinocchio", "mujoco"):
        try:
            contender = ENGINES[engine](RigidChain(coordinates))
            found[f"{contender.name}, rigid chain of {coordinates}"] = contender.run
        except PeerMissing as missing:
            print(f"left out: {engine}: {missing}", file=sys.stderr)
    return found


def main() -> None:
    """Measure and print the table."""
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--rounds", type=int, default=9)
    options.add_argument("--joints", type=int, default=6)
    options.add_argument("--json", help="also write the figures to this file")
    chosen = options.parse_args()
    arm = Robot(chosen.joints)
    n = arm.model.nq
    ours = f"tmodes, {chosen.joints} strain links and gears, {n} coordinates"
    contenders = {ours: arm.contender("double"), f"{ours}, per lane of 4": arm.contender("lanes"), **peers(n)}
    times: dict[str, list[float]] = {name: [] for name in contenders}
    for _ in range(chosen.rounds):
        for name, contender in contenders.items():
            times[name].append(contender())
    arm.contender("double")()
    error, ready = arm.error(), start_time(chosen.joints)
    medians = {name: statistics.median(values) for name, values in times.items()}
    print(f"forward dynamics, medians of {chosen.rounds} rounds; {platform.processor() or platform.machine()}")
    for name, seconds in medians.items():
        print(f"{name:<62}{seconds * 1e6:9.2f} us   ratio {seconds / medians[ours]:6.3f}")
    print(f"residual of the equations of motion {error:.1e}; with an empty cache ready in {ready:.2f} s (processor)")
    if chosen.json:
        info = {"microseconds": {k: 1e6 * s for k, s in medians.items()}, "residual": error, "ready_s": ready}
        Path(chosen.json).write_text(json.dumps(info, indent=1))


if __name__ == "__main__":
    main()
