"""What holds a robot at rest: the reaction of its base, and the force and moment that each joint carries."""

from __future__ import annotations

from typing import Any

import numpy as np

from tmodes.analysis.statics.equilibrium import Equilibrium
from tmodes.model.passes import evaluate
from tmodes.model.rows import StateRows
from tmodes.sheet import Robot

__all__ = ["reactions"]


def reactions(robot: Robot, rest: Equilibrium) -> list[dict[str, Any]] | None:
    """Of the base and of each joint of a data sheet, in world axes; None for equations that do not know them.

    ``position_m``: of the base, and of where the joint's link begins; ``force_N`` and ``moment_Nm`` about it: by what
    stands before it on what it carries, weight and loads of all beyond.
    """
    model, joints = rest.model, {joint.name for joint in robot.joints}
    if not model.passes.mechanics.base_moves:  # equations that know no base
        return None
    rows = StateRows(rest.q, np.zeros(model.nq) if rest.rates is None else rest.rates, model.nq)
    schedule = model.passes.schedule("reactions", loaded=rest.wrenches is not None)
    blocks = model.passes.inertial(rows, 0.0, rest.base[None], rest.wrenches)
    found = evaluate(model.parameters, schedule, blocks, 1)
    base = model.chain.base
    info = [_one("base", base.rotation, base.position, found["base_force"][0])]
    forces, poses = found["reactions"].reshape(-1, 6), found["poses"].reshape(len(model.chain.nodes), -1)
    for node, force, pose in zip(model.chain.nodes, forces, poses, strict=True):
        if node.joint.name in joints:
            info.append(_one(node.joint.name, pose[:9].reshape(3, 3), pose[9:12], force))
    return info


def _one(name: str, rotation: Any, position: Any, force: Any) -> dict[str, Any]:
    return {
        "at": name,
        "position_m": position.tolist(),
        "force_N": (rotation @ force[3:]).tolist(),
        "moment_Nm": (rotation @ force[:3]).tolist(),
    }
