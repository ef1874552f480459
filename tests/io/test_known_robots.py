"""Robots that everybody knows (the data of the package example-robot-data), and Pinocchio's reading of them."""

from __future__ import annotations

import re
import sysconfig
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from io_frames import chain_frames, mass_matrix, sheet_frames
from tmodes.errors import TmodesError
from tmodes.io.sheet_check import sheet_from_data
from tmodes.io.sheet_files import read_sheet
from tmodes.io.urdf import read_urdf

SHARE = Path(sysconfig.get_path("purelib")) / "cmeel.prefix/share"
ROBOTS = SHARE / "example-robot-data/robots"
REASONS = {
    "inertia": r"link .*: inertia must be .*(triangle inequality|none is negative).*, got principal moments",
    "no mass": r"link .*: mass must be .*, got (no mass on the moving joint|0 on a moving link|0 with moments)",
    "no joint": r"the robot must be at least one joint, got no joint",
    "no link": r"the robot must be made of links and joints, got no link",
    "free flyer": r"joint .*: type must be .*, got a floating joint",
}

pytestmark = [
    pytest.mark.peer,
    pytest.mark.skipif(not ROBOTS.is_dir(), reason="needs the robots of `pip install example-robot-data` (414 MB)"),
]


def reason(path: Path) -> str:
    """Empty for a robot that is read and whose chain is made; else the kind of what is said against it."""
    try:
        sheet_from_data(*read_sheet(path, roots=[SHARE])).chain()
    except TmodesError as error:
        first = str(error).splitlines()[0]
        return next((kind for kind, words in REASONS.items() if re.search(words, first)), f"UNKNOWN: {first}")
    return ""


def test_all_robots_load_or_say_plainly_why_not(capsys: pytest.CaptureFixture[str]) -> None:
    table = {
        folder.name: {path.name: reason(path) for path in sorted(folder.rglob("*.urdf"))}
        for folder in sorted(ROBOTS.iterdir())
        if folder.is_dir()
    }
    with capsys.disabled():
        print(f"\n{'robot':32}{'file':40}reading")
        for robot, files in table.items():
            for name, why in files.items() or [("-", "no URDF among its files")]:
                print(f"{robot:32}{name:40}{why or 'loads'}")
    said = [why for files in table.values() for why in files.values()]
    assert len(table) == 39
    assert [why for why in said if why.startswith("UNKNOWN")] == []
    assert said.count("") == 58
    assert sum("" in files.values() for files in table.values()) == 32


def pinocchio_state(path: Path, rng: np.random.Generator, held: set[str]) -> tuple[Any, Any, dict[str, float], Any]:
    """Pinocchio's model and data at random angles; joints that are ``held`` stand at zero."""
    pin: Any = pytest.importorskip("pinocchio", reason="needs Pinocchio (`pip install pin`) to compare with")
    model = pin.buildModelFromUrdf(str(path))
    angles = {name: 0.0 if name in held else rng.uniform(-2, 2) for name in list(model.names)[1:]}
    q = pin.integrate(model, pin.neutral(model), np.array([*angles.values()]))
    data = model.createData()
    pin.framesForwardKinematics(model, data, q)
    mass = pin.crba(model, data, q)
    return model, data, angles, np.triu(mass) + np.triu(mass, 1).T


@pytest.mark.parametrize(
    "name",
    [
        "ur_description/urdf/ur5_robot.urdf",
        "panda_description/urdf/panda.urdf",
        "xarm_description/urdf/xarm7.urdf",
        "kinova_description/robots/kinova.urdf",
        "tiago_pro_description/robots/tiago_pro.urdf",
    ],
)
def test_frames_and_masses_are_pinocchios(name: str) -> None:
    """Frame of every link, of the sheet and of the chain, and the mass matrix of all joints."""
    robot = read_urdf(ROBOTS / name, roots=[SHARE])
    held = {joint["name"] for joint in robot.data["joints"] if joint.get("state") == "locked"}
    for seed in range(3):
        model, data, angles, mass = pinocchio_state(ROBOTS / name, np.random.default_rng(seed), held)
        frames, chain = sheet_frames(robot.data, angles), chain_frames(robot.data, angles)
        for joint in robot.data["joints"]:
            link = "base" if joint["child"] == "base_frame" else joint["child"]
            expected = data.oMf[model.getFrameId(link)].homogeneous
            np.testing.assert_allclose(frames[joint["child"]], expected, atol=3e-12)
            np.testing.assert_allclose(chain[joint["name"]], expected, atol=3e-12)
        ours = mass_matrix(robot.data, angles, list(angles)) + np.diag(model.armature)
        np.testing.assert_allclose(ours, mass, atol=1e-11 * np.abs(mass).max())


def test_meshes_of_the_panda_are_found_and_only_with_their_root() -> None:
    path = ROBOTS / "panda_description/urdf/panda.urdf"
    meshes = read_urdf(path, roots=[SHARE]).meshes
    assert sum(map(len, meshes.values())) == 20
    assert {file.suffix for files in meshes.values() for file in files} == {".dae", ".stl"}
    assert all(file.is_relative_to(ROBOTS) for files in meshes.values() for file in files)
