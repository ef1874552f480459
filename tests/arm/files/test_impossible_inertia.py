"""Impossible masses and inertias of a URDF: warnings where nothing depends on them, else errors, or made possible."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from tmodes.analysis.describe.describe import describe
from tmodes.chain.lowering import lowered
from tmodes.cli.sheets import check
from tmodes.errors import InputErrors
from tmodes.io.sheet_plausible import notices_about
from tmodes.kinds.links.body import nearest_inertia, principal_moments
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
def test_no_possible_inertia_is_nearer(seed: int) -> None:
    numbers = np.random.default_rng(seed)
    given = numbers.normal(size=(3, 3))
    given = given + given.T
    nearest = nearest_inertia(given)
    assert not principal_moments(nearest)[1]
    distance = np.linalg.norm(nearest - given)
    for _ in range(200):
        points = numbers.normal(size=(4, 3)) * np.exp(numbers.normal())
        second = points.T @ points
        other = np.trace(second) * np.eye(3) - second
        for share in (1.0, 0.1, 0.01):
            mixed = (1 - share) * nearest + share * other  # the real inertias are a convex cone
            assert np.linalg.norm(mixed - given) >= distance * (1 - 1e-9)
    assert np.allclose(nearest_inertia(nearest), nearest, atol=1e-12)


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
