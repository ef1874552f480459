"""Impossible masses and inertias of a URDF: warnings where nothing depends on them, else errors, or made possible."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from scipy.linalg import eigh

from tmodes.analysis.describe.describe import describe
from tmodes.chain.lowering import lowered
from tmodes.cli.sheets import check
from tmodes.errors import InputErrors
from tmodes.io.sheet_plausible import notices_about
from tmodes.kinds.links.body import principal_moments, raised_inertia
from tmodes.model.model import Model
from tmodes.robots.load import load

IMPOSSIBLE = {"triangle": (1e-3, 1e-3, 1e-2), "sign": (-1e-3, 2e-3, 2e-3), "a line": (0.0, 0.0, 3e-6)}
GOOD = (0.01, 0.01, 0.01)


def urdf(tmp_path: Path, ground: object, bracket: object, moving: object, *, mass: float = 1.0) -> Path:
    """A ground link, a bracket that is fixed to it, and a link that turns."""

    def link(name: str, moments: object, of: float = 1.0) -> str:
        xx, yy, zz = moments  # type: ignore[misc]
        inertia = f'<inertia ixx="{xx}" iyy="{yy}" izz="{zz}" ixy="0" ixz="0" iyz="0"/>'
        return f'<link name="{name}"><inertial><mass value="{of}"/>{inertia}</inertial></link>'

    ends = '<parent link="{}"/><child link="{}"/><axis xyz="0 0 1"/>'
    path = tmp_path / "r.urdf"
    path.write_text(
        f'<robot name="r">{link("ground", ground)}{link("bracket", bracket, mass)}{link("arm", moving)}'
        f'<joint name="screwed" type="fixed">{ends.format("ground", "bracket")}</joint>'
        f'<joint name="turns" type="continuous">{ends.format("bracket", "arm")}</joint></robot>'
    )
    return path


@pytest.mark.parametrize("moments", IMPOSSIBLE.values(), ids=IMPOSSIBLE)
@pytest.mark.parametrize("place", ["ground", "bracket"])
def test_what_stands_still_is_a_warning(place: str, moments: object, tmp_path: Path) -> None:
    given = {"ground": GOOD, "bracket": GOOD, place: moments}
    robot = load(urdf(tmp_path, given["ground"], given["bracket"], GOOD))
    (notice,) = notices_about(robot)
    assert notice.startswith(f"link {place}: inertia")
    assert "stands still with the base" in notice
    right = load(urdf(tmp_path, GOOD, GOOD, GOOD))
    found, expected = (Model(lowered(one)).forward_dynamics([0.1], [0.2], [0.3]) for one in (robot, right))
    assert np.array_equal(found, expected)


def test_a_mass_of_zero_that_stands_still_is_a_warning(tmp_path: Path) -> None:
    (notice,) = notices_about(load(urdf(tmp_path, GOOD, GOOD, GOOD, mass=0.0)))
    assert notice.startswith("link bracket: mass")


@pytest.mark.parametrize("moments", IMPOSSIBLE.values(), ids=IMPOSSIBLE)
def test_what_moves_is_an_error_unless_it_is_to_be_fixed(moments: object, tmp_path: Path) -> None:
    path = urdf(tmp_path, GOOD, GOOD, moments)
    with pytest.raises(InputErrors, match=r"link arm: inertia.*--fix-inertia"):
        load(path)
    robot = load(path, fix_inertia=True)
    (notice,) = notices_about(robot)
    assert notice.startswith("link arm: inertia is not possible")
    assert "stands still" not in notice
    found = robot.link("arm").bodies[0].inertia_matrix()
    assert not principal_moments(found)[1]


@pytest.mark.parametrize("seed", range(20))
def test_raised_moments_are_possible_and_those_about_a_joint_stay(seed: int) -> None:
    numbers = np.random.default_rng(seed)
    frame = np.linalg.qr(numbers.normal(size=(3, 3)))[0]
    low, middle = numbers.uniform(0, 1, 2) * (seed % 3 > 0, 1)
    given = frame @ np.diag([low, middle, low + middle + numbers.uniform(0.1, 1)]) @ frame.T
    axis = frame[:, seed % 3] if seed % 2 else numbers.normal(size=3)
    raised = raised_inertia(given, axis)
    assert not principal_moments(raised)[1]
    assert axis @ raised @ axis == pytest.approx(axis @ given @ axis, rel=1e-12)
    assert np.linalg.eigvalsh(raised - given)[0] > -1e-12
    assert np.trace(raised - given) == pytest.approx(np.max(np.linalg.eigvalsh(given)) - low - middle, rel=1e-9)
    assert np.allclose(raised_inertia(raised, axis), raised, atol=1e-12)
    second = np.trace(raised) / 2 * np.eye(3) - raised
    assert np.linalg.eigvalsh(second)[0] > -1e-12


@pytest.mark.parametrize("moments", [(0.0, 0.0, 0.1), (0.1, 0.0, 0.02)])
def test_a_planar_arm_with_one_moment_keeps_its_mass_matrix(moments: object, tmp_path: Path) -> None:
    robot = load(urdf(tmp_path, GOOD, GOOD, moments), fix_inertia=True)
    (notice,) = notices_about(robot)
    zz = moments[2]  # type: ignore[index]
    assert Model(lowered(robot)).mass_matrix([0.3]) == pytest.approx(np.array([[zz]]), rel=1e-12)
    assert "at most 0 %" in notice


def test_the_fall_of_a_frequency_is_bounded(tmp_path: Path) -> None:
    """Two joints turn a link about both of its small moments: one of them must be raised."""
    inertia = '<inertia ixx="{}" iyy="{}" izz="{}" ixy="0" ixz="0" iyz="0"/>'

    def text(*moments: float) -> str:
        body = f'<inertial><mass value="0.1"/>{inertia.format(*moments)}</inertial>'
        ring = f'<inertial><mass value="1"/>{inertia.format(0.02, 0.02, 0.02)}</inertial>'
        ends = '<parent link="{}"/><child link="{}"/><axis xyz="{}"/>'
        return (
            f'<robot name="r"><link name="g"/><link name="a">{ring}</link><link name="b">{body}</link>'
            f'<joint name="one" type="continuous">{ends.format("g", "a", "1 0 0")}</joint>'
            f'<joint name="two" type="continuous">{ends.format("a", "b", "0 1 0")}</joint></robot>'
        )

    path = tmp_path / "two.urdf"
    path.write_text(text(0.01, 0.01, 0.03))
    robot = load(path, fix_inertia=True)
    (notice,) = notices_about(robot)
    told = float(notice.partition("at most ")[2].partition(" %")[0]) / 100
    mass = Model(lowered(robot)).mass_matrix([0.0, 0.0])
    given = np.diag([0.02 + 0.01, 0.01])
    stiffness = np.diag([7.0, 3.0])
    before, after = (np.sqrt(eigh(stiffness, one, eigvals_only=True)) for one in (given, np.squeeze(mass)))
    falls = 1 - after / before
    assert falls.max() > 0.05
    assert falls.max() <= told
    assert told < 0.5


def test_held_joints_are_reported(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "m.urdf"
    inertial = '<inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>'
    ends = '<parent link="{}"/><child link="{}"/><axis xyz="0 0 1"/>'
    path.write_text(
        f'<robot name="r"><link name="g"/><link name="a">{inertial}</link><link name="b">{inertial}</link>'
        f'<joint name="one" type="continuous">{ends.format("g", "a")}</joint>'
        f'<joint name="two" type="continuous">{ends.format("a", "b")}<mimic joint="one"/></joint></robot>'
    )
    robot = load(path)
    (note,) = robot.held_notices
    assert "two at 0 (follows one)" in note
    assert notices_about(robot) == []
    assert describe(robot)["notes"] == [note]
    check(str(path))
    assert f"note: {note}" in capsys.readouterr().out


@pytest.mark.parametrize("mass", [-2.0, -1e-9, 0.0])
def test_an_impossible_mass_of_what_stands_still_is_a_warning(mass: float, tmp_path: Path) -> None:
    """It changes nothing; on a link that moves it stays an error, whatever is allowed."""
    path = urdf(tmp_path, GOOD, GOOD, GOOD, mass=mass)
    (notice,) = notices_about(load(path))
    assert "no mass is taken; it stands still with the base" in notice
    path.write_text(path.read_text().replace('name="screwed" type="fixed"', 'name="screwed" type="continuous"'))
    with pytest.raises(InputErrors, match="link bracket: mass must be a mass greater than 0"):
        load(path, fix_inertia=True)
