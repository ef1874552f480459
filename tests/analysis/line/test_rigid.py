"""Inner forces of beams that do not bend: closed forms, and those of the same beams with functions that stand still."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import tmodes
from tmodes.analysis.line.line import elastic_line, line_places
from tmodes.model.model import Model
from tmodes.sheet import Robot
from tmodes.study.quantities.summary import names_in_summary


def sheet(model: str, rng: np.random.Generator | None = None, **more: Any) -> Robot:
    """Two beams in a row, the first with a body inside and one at its tip, both with rotary inertia; or one plain."""
    section = {"bending_stiffness": 100.0, "mass_per_length": 0.8}
    one = {"name": "a", "beam": {"model": model, "length": 1.2, "section": section}}
    joints = [{"name": "j", "type": "revolute", "child": "a", "axis": [0, 0, 1]}]
    links = [one]
    if rng is not None:
        tube = {"shape": "tube", "outer_diameter": 0.03, "thickness": 0.003}
        beam = {"model": model, "length": 0.7, "section": tube, "material": "steel", "damping_time": 0.0}
        beam |= {"functions": 2} if model == "strain" else {}
        bodies = [
            {"mass": rng.uniform(0.2, 1.0), "center": rng.uniform(-0.05, 0.05, 3).tolist(), "at": at,
             "inertia": {"xx": 0.01, "yy": 0.012, "zz": 0.008}} for at in (0.0, 0.4, 1.0)
        ]  # fmt: skip
        mount = {"position": rng.uniform(-0.1, 0.1, 3).tolist(), "rpy": rng.uniform(-1, 1, 3).tolist()}
        links = [{"name": name, "beam": beam | {"root_mount": mount}, "bodies": bodies} for name in "ab"]
        joints = [
            {"name": f"j{name}", "type": "revolute", "child": name, "axis": rng.normal(size=3).tolist(),
             "origin": {"position": rng.uniform(-0.2, 0.2, 3).tolist()}} for name in "ab"
        ]  # fmt: skip
    data = {"format": 1, "kind": "arm", "name": "rigid", "gravity": [1.0, -2.0, -9.0], "joints": joints, "links": links}
    return Robot.from_data(data | more)


def test_a_turned_rod() -> None:
    """N = w q'^2 (L^2 - x^2)/2, Q = -w q'' (L^2 - x^2)/2, M = -w q'' (2 L^3 - 3 L^2 x + x^3)/6 without weight."""
    model = Model(sheet("rigid", gravity=[0.0, 0.0, 0.0]).chain())
    line = elastic_line(model, 0.3, 2.0, 5.0, stations=7)["a"]
    x, length = line.s * 1.2, 1.2
    across = 0.8 * (length**2 - x**2) / 2
    np.testing.assert_allclose(line.axial[0], 4.0 * across, rtol=1e-13, atol=1e-13)
    np.testing.assert_allclose(line.shear[0, :, 0], -5.0 * across, rtol=1e-13, atol=1e-13)
    moment = -0.8 * 5.0 * (2 * length**3 - 3 * length**2 * x + x**3) / 6
    np.testing.assert_allclose(line.moment[0, :, 2], moment, rtol=1e-13, atol=1e-13)
    np.testing.assert_allclose(np.linalg.norm(line.position[0], axis=1), x, atol=1e-15)


@pytest.mark.parametrize("seed", range(12))
def test_it_carries_what_a_bending_one_carries_that_stands_still(seed: int) -> None:
    """Of the same beams with functions whose coordinates, rates and accelerations are zero; points are pushed too."""
    rng = np.random.default_rng(seed)
    state = rng.bit_generator.state
    lines = {}
    for kind in ("rigid", "strain"):
        rng.bit_generator.state = state
        robot = sheet(kind, rng, points=[{"name": "p", "link": "a", "at": 0.6}, {"name": "e", "link": "b"}])
        model, own = Model(robot.chain()), np.random.default_rng(seed + 100)
        joints, values = [model.coordinates.index(name) for name in ("ja", "jb")], np.zeros((3, 4, model.nq))
        values[:, :, joints] = own.normal(size=(3, 4, 2))
        forces = own.normal(size=(4, 3, 6)) * 5.0
        places = line_places(model.chain, 9)
        lines[kind] = elastic_line(model, *values, stations=[*map(float, places)], wrenches=forces)
    assert len(places) == 11
    for name in "ab":
        rigid, still = lines["rigid"][name], lines["strain"][name]
        for quantity in ("position", "rotation", "moment", "shear", "axial"):
            found, expected = getattr(rigid, quantity), getattr(still, quantity)
            np.testing.assert_allclose(found, expected, rtol=1e-10, atol=1e-10 * np.abs(expected).max())


def test_a_result_has_the_moments_of_a_rigid_beam() -> None:
    """Hanging level by its drive, gravity across it: w g L^2/2 at the root, as the summary says."""
    drive = {"joint": "j", "command": "prescribed", "signal": {"type": "constant", "value": 0.0}}
    robot = sheet(
        "rigid", gravity=[0.0, -9.81, 0.0], drives=[drive], integration={"duration": 0.1, "output_step": 0.01}
    )
    result = tmodes.run(robot)
    expected = 0.8 * 9.81 * 1.2**2 / 2
    np.testing.assert_allclose(result.data["moment"].values[:, 0, 0, 2], -expected, rtol=1e-12)
    np.testing.assert_allclose(result.data["deflection"].values, 0.0)
    assert result.summary()["links"]["a"]["bending_moment"]["max_Nm"] == pytest.approx(expected, rel=1e-12)
    assert names_in_summary(robot)["link"] == ["a"]
