"""A planar arm in one word: beams bend in the plane of the joints alone."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from tmodes.errors import InputErrors
from tmodes.model.model import Model
from tmodes.sheet import Robot

BEAM = {
    "model": "strain", "functions": 3, "length": 0.5, "damping_time": 1e-4, "material": "steel",
    "section": {"shape": "round", "diameter": 0.01},
}  # fmt: skip


def arm(axis: list[float], roll: float = 0.0, **changes: Any) -> Robot:
    joints = [
        {"name": "a", "type": "revolute", "child": "upper", "axis": axis},
        {"name": "b", "type": "revolute", "child": "fore", "axis": axis},
        {"name": "c", "type": "fixed", "child": "hand", "origin": {"rpy": [0, 0, 0.3] if axis[2] else [0, 0.3, 0]}},
    ]
    mounts = {"root_mount": {"rpy": [roll, 0, 0]}, "tip_mount": {"rpy": [-roll, 0, 0]}}
    beam = BEAM | (mounts if roll else {})
    links = [
        {"name": "upper", "beam": beam},
        {"name": "fore", "beam": {**BEAM, "model": "segments", "segments": 2, "functions": None}},
        {"name": "hand", "bodies": [{"mass": 1.0, "inertia": 0.01}]},
    ]
    data = {"format": 1, "kind": "arm", "name": "p", "planar": True, "joints": joints, "links": links}
    return Robot.from_data(data | changes)


def functions_of(robot: Robot) -> dict[str, int]:
    beam: Any = robot.links[0].beam
    return beam.functions.model_dump()


@pytest.mark.parametrize(
    ("axis", "roll", "bends"),
    [
        ([0, 0, 1], 0.0, "bend_z"),
        ([0, 1, 0], 0.0, "bend_y"),
        ([0, -2, 0], 0.0, "bend_y"),
        ([0, 0, 1], np.pi / 2, "bend_y"),
    ],
)
def test_beams_bend_in_the_plane_of_the_joints(axis: list[float], roll: float, bends: str) -> None:
    robot = arm(axis, roll)
    assert functions_of(robot) == dict.fromkeys(("twist", "bend_y", "bend_z", "stretch", "shear_y", "shear_z"), 0) | {
        bends: 3
    }
    model = Model(robot.chain())
    assert model.nq == 2 + 3 + 2
    again = Robot.from_data(robot.model_dump(mode="json", by_alias=True, exclude_none=True))
    assert again == robot
    assert functions_of(robot.with_({"links.upper.beam.functions": 2}))[bends] == 2


@pytest.mark.parametrize(
    ("changes", "which"),
    [
        ({"joints.b.axis": [0, 0.1, 1]}, "joints.b.axis"),
        ({"joints.b.type": "prismatic"}, "joints.b.axis"),
        (
            {f"links.upper.beam.{end}_mount": {"rpy": [t, 0, 0]} for end, t in (("root", 0.5), ("tip", -0.5))},
            "links.upper.beam.root_mount",
        ),
        ({"joints.a.type": "fixed", "joints.a.axis": None, "joints.b.type": "fixed", "joints.b.axis": None}, "planar"),
    ],
)
def test_what_leaves_the_plane_is_refused(changes: dict[str, Any], which: str) -> None:
    with pytest.raises(InputErrors) as caught:
        arm([0, 0, 1]).with_(changes)
    assert caught.value.errors[0].which == which
