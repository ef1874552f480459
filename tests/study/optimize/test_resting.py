"""Slopes of numbers at rest are those of fourth-order differences; those of double frequencies, of their mean."""

from __future__ import annotations

import os
from typing import Any

import numpy as np
import pytest

from random_sheets import random_sheet
from study.optimize.test_adjoint import spong, trials_of, uniform
from tmodes.analysis.statics.at_rest import robot_rest
from tmodes.errors import InputError, SimulationError
from tmodes.gradients.changes import number_at
from tmodes.io.sheet_check import sheet_data
from tmodes.robots.load import load
from tmodes.sheet import Robot
from tmodes.simulation.vary.static_numbers import StaticSlopes, static_numbers
from tmodes.study.optimize import gradient
from tmodes.study.optimize.adjoint import Adjoint
from tmodes.study.read import study_from_data

COUNT = int(os.environ.get("TMODES_RESTING_ROBOTS", "4"))
STEP = 1e-3
RULE = np.array([1.0, -8.0, 8.0, -1.0]) / 12
NAMES = ("sag", "sag.x", "sag.z", "mass", "frequency.locked.1", "frequency.locked.2", "frequency.locked.3")


def numbers_of(data: Any, steps: tuple[Any, ...] = ()) -> list[str]:
    """Paths of all numbers in data but zero."""
    if isinstance(data, (dict, list)):
        items = data.items() if isinstance(data, dict) else enumerate(data)
        return [path for key, one in items for path in numbers_of(one, (*steps, key))]
    return [".".join(map(str, steps))] if isinstance(data, float) and data and np.isfinite(data) else []


def free(data: Any, groups: tuple[str, ...]) -> tuple[Robot, list[str]]:
    """The robot under its weight alone, and numbers of these groups."""
    robot = Robot.from_data({key: one for key, one in data.items() if key not in ("contact", "loads")})
    return robot, [
        path for path in numbers_of(sheet_data(robot)) if path.partition(".")[0] in groups and path[-3:] != ".at"
    ][:24]


def check(robot: Robot, paths: list[str], tolerance: float = 1e-8) -> dict[str, tuple[float, np.ndarray]]:
    """Compare along each path with differences of what stands alone."""
    values = np.array([number_at(path, sheet_data(robot)) for path in paths])
    ways = np.diag(values)
    both = [dict(zip(paths, each, strict=True)) for each in (values, ways)]
    found = StaticSlopes(NAMES).at(robot, *both) or StaticSlopes(NAMES[:4]).at(robot, *both)
    if not found:
        return {}
    steps = np.repeat(ways, 4, axis=0) * np.tile([-2.0, -1.0, 1.0, 2.0], len(paths))[:, None] * STEP
    modes = [found[name][0] for name in NAMES[4:] if name in found]
    close = {
        NAMES[4 + k + side] for k in np.flatnonzero(np.diff(modes) < 1e-2 * np.array(modes[1:])) for side in (0, 1)
    }
    names = [name for name in NAMES if name in found and name not in close]
    cases = np.repeat(values + steps, 8, axis=0)  # more than are computed one by one
    rows = static_numbers(robot, dict(zip(paths, cases.T, strict=True)), names).values
    for name in names:
        value, slope = found[name]
        expected = rows[name][::8].reshape(-1, 4) @ RULE / STEP
        size = found["sag"][0] if name.startswith("sag") else value
        np.testing.assert_allclose(slope, expected, rtol=0, atol=tolerance * max(size, np.abs(expected).max(), 1e-12))
    return found


@pytest.mark.parametrize("name", ["quanser_2dsfl", "deluca_siciliano1991", "spong1987", "flexarm1990", "manutec_r3"])
def test_all_numbers_of_a_published_robot(name: str) -> None:
    found = check(*free(sheet_data(load(name)), ("gravity", "links", "joints")))
    assert any(slope.any() for _, slope in found.values())


@pytest.mark.parametrize("seed", range(1, COUNT + 1))
def test_numbers_of_a_random_robot(seed: int) -> None:
    assert check(*free(random_sheet(seed, seed), ("gravity", "links"))) or seed > 4  # some have no rest


def rod(one: float = 150.0, other: float = 150.0) -> Robot:
    """An upright rod that is as stiff about both axes."""
    section = {"bending_stiffness": [one, other], "torsional_stiffness": 100.0, "mass_per_length": 0.4,
               "polar_inertia_per_length": 1e-4}  # fmt: skip
    return Robot.from_data({
        "format": 1, "kind": "arm", "name": "rod", "gravity": 9.81,
        "joints": [{"name": "joint", "type": "revolute", "parent": "base", "child": "link", "axis": [0, 0, 1]}],
        "links": [{"name": "link", "bodies": [{"name": "load", "mass": 0.3, "at": 1.0}], "beam": {
            "model": "strain", "functions": {"bend_y": 2, "bend_z": 2}, "length": 0.8, "damping_time": 0.0,
            "root_mount": {"rpy": [0.0, -np.pi / 2, 0.0]}, "section": section}}],
    })  # fmt: skip


def test_a_double_frequency_moves_by_the_mean_of_both_sides() -> None:
    paths = [f"links.link.beam.section.bending_stiffness.{k}" for k in range(2)]
    case, along = dict.fromkeys(paths, 150.0), np.array([[150.0, 0.0, 150.0], [0.0, 150.0, 150.0]])
    ways = dict(zip(paths, along, strict=True))
    both = [StaticSlopes(NAMES).at(rod(), case, ways)[name] for name in NAMES[4:6]]
    assert both[0][0] == pytest.approx(both[1][0], rel=1e-10)
    step = 1e-3
    sides = [static_numbers(rod(150.0 * (1 + by)), {paths[1]: [150.0]}, [*NAMES[4:6]]).values for by in (-step, step)]
    for (_, slope), name in zip(both, NAMES[4:6], strict=True):
        assert slope[0] == pytest.approx(slope[1], rel=1e-8)
        assert slope[2] == pytest.approx(slope[0] + slope[1], rel=1e-8)  # both together: no kink
        assert slope[0] == pytest.approx((sides[1][name] - sides[0][name])[0] / (2 * step), rel=2e-3)


def test_terms_at_rest_are_exact_in_the_worst_scenario(monkeypatch: pytest.MonkeyPatch) -> None:
    asked = study_from_data({
        "format": 1, "kind": "study", "name": "rods", "robot": "deluca_siciliano1991",
        "set": {"gravity": [0.0, 0.0, -9.81]}, "plan": {"type": "monte_carlo", "runs": 1},
        "parameters": {"mass": uniform("links.1.bodies.0.mass", 0.05, 0.2),
                       "length": uniform("links.0.beam.length", 0.4, 0.6),
                       "share": uniform("links.1.beam.length", 0.9, 1.1, relative=True)},
        "quantities": {"f": {"static": "frequency.locked.1"}, "m": {"static": "mass", "unit": "g"},
                       "both": {"expression": "f**2 + m/100"}},
        "optimize": {"objectives": [{"minimize": "both"}], "limits": ["m <= 900 g"],
                     "design": ["mass", "length"]},
    })  # fmt: skip
    trials = trials_of(asked)
    trials.scenarios = np.repeat(trials.scenarios, 2, axis=0) * [[1.0, 1.0, 0.95], [1.0, 1.0, 1.05]]
    slopes, shares, step = Adjoint(trials, {}), np.array([0.4, 0.5]), 1e-2

    def refused(*_: Any) -> None:
        raise AssertionError("differences")

    found = slopes.at(shares)
    monkeypatch.setattr("tmodes.study.optimize.adjoint.restricted", refused)
    points = [slopes.at(shares + by * step * way) for way in np.eye(2) for by in (-2, -1, 1, 2)]
    terms = np.array([[one.objective, *one.excess] for one in points]).reshape(2, 4, -1)
    expected = np.einsum("kst,s->tk", terms, RULE) / step
    np.testing.assert_allclose([found.slope, *found.slopes], expected, rtol=0, atol=1e-8 * np.abs(expected).max())


def test_numbers_under_loads_have_slopes_by_differences() -> None:
    asked = spong({"f": {"static": "frequency.locked.1"}}, "f", [], mass=uniform("links.link.bodies.0.mass", 0.5, 2.0))
    assert asked.robot is not None
    shares, exact = np.array([0.3]), Adjoint(trials_of(asked), {}).at(np.array([0.3])).slope
    loaded = {**asked.data, "study": {**asked.data["study"], "set": {
        **asked.data["study"]["set"], "loads": [{"point": "tip", "force": [0.0, 0.0, 1e-9]}]}}}  # fmt: skip
    found = Adjoint(trials_of(study_from_data(loaded)), {}).at(shares).slope
    assert found[0] == pytest.approx(exact[0], rel=1e-5)


@pytest.mark.nightly
def test_a_robot_without_a_rest_has_no_slopes() -> None:
    robot, _ = free(random_sheet(38, 38), ())
    with pytest.raises(SimulationError):
        robot_rest(robot)
    assert StaticSlopes(NAMES).at(robot, {"gravity.2": 1.0}, {"gravity.2": np.ones(1)}) == {}


def test_parameters_that_change_structure_are_refused() -> None:
    asked = spong({"sag": {"static": "sag"}}, "sag", [], end=uniform("integration.duration", 1.0, 2.0))
    with pytest.raises(InputError, match="more than numbers"):
        Adjoint(trials_of(asked), {}).at(np.array([0.5]))


def test_slopes_of_neighbours_are_of_a_parabola() -> None:
    shares = np.array([0.0, 0.5, 1.0])
    points = gradient.neighbours(shares)
    values = (points**2).sum(axis=1)
    np.testing.assert_allclose(gradient.slopes(values, shares), 2 * shares, atol=1e-9)
