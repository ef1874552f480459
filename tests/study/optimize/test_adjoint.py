"""Slopes by the adjoint are those of differences of runs; descents need far fewer runs than a search."""

from __future__ import annotations

import json
from typing import Any

import numpy as np
import pytest

import tmodes
from study.optimize.tubes import EXAMPLES
from tmodes.errors import InputError
from tmodes.gradients.quantities import tracking_error
from tmodes.robots.load import load
from tmodes.study.optimize import optimize
from tmodes.study.optimize.adjoint import Adjoint
from tmodes.study.optimize.goals import goals_of
from tmodes.study.optimize.space import design_space
from tmodes.study.optimize.trials import Trials
from tmodes.study.read import read_study, study_from_data
from tmodes.study.study import Study

GEAR, MASS = "joints.joint.gear.stiffness", "links.link.bodies.0.mass"


def trials_of(asked: Study) -> Trials:
    """Trials of a study at its own values."""
    assert asked.sheet.optimize is not None
    nominal = asked.space.nominal[None]
    units = {**asked.parameter_units, **asked.evaluate(0, nominal).units}
    goals = goals_of(asked.sheet.optimize, units)
    return Trials(asked, design_space(asked, asked.sheet.optimize.design), goals, nominal, None, lambda *_: None, {})


def spong(quantities: dict[str, Any], objective: str, limits: list[str], **parameters: Any) -> Study:
    """A design of the robot spong1987."""
    return study_from_data({
        "format": 1, "kind": "study", "name": "spong", "robot": "spong1987",
        "set": {"integration.relative_tolerance": 1e-10, "integration.absolute_tolerance": 1e-12,
                "joints.joint.gear.damping": 0.5, "integration.duration": 1.5},
        "plan": {"type": "monte_carlo", "runs": 1}, "parameters": parameters, "quantities": quantities,
        "optimize": {"objectives": [{"minimize": objective}], "limits": limits},
    })  # fmt: skip


def uniform(path: str, low: float, high: float, **more: Any) -> dict[str, Any]:
    """A parameter with a range."""
    return {"path": path, "distribution": {"type": "uniform", "low": low, "high": high}, **more}


@pytest.mark.parametrize(
    ("series", "reduce"),
    [("tip_error", "rms"), ("tip_error", "end"), ("tip.z", "mean"), ("joint.velocity", "rms")],
)
def test_slopes_are_those_of_differences_of_runs(series: str, reduce: str) -> None:
    asked = spong(
        {"error": {"series": series, "reduce": reduce, "unit": None}, "both": {"expression": "error**2 + 1e-3*gear"}},
        "both + error", ["error <= 1"],
        gear=uniform(GEAR, 0.6, 1.4, relative=True), mass=uniform(MASS, 0.5, 2.0),
        gain={"path": "drives.0.controller.position_gain",
              "distribution": {"type": "loguniform", "low": 40.0, "high": 120.0}},
        reach=uniform("links.link.bodies.0.center.2", -1.2, -0.8),
    )  # fmt: skip
    slopes = Adjoint(trials_of(asked), {})
    shares, step = np.array([0.4, 0.3, 0.6, 0.5]), 1e-3
    found = slopes.at(shares)
    trials = trials_of(asked)
    points = shares + np.concatenate([np.zeros((1, 4)), step * np.eye(4), -step * np.eye(4)])
    judged = trials.judged(trials.at(trials.space.at(points)))
    values = np.column_stack([judged.objectives, judged.excess])
    expected = (values[1:5] - values[5:]).T / (2 * step)
    np.testing.assert_allclose([found.objective, *found.excess], values[0], rtol=1e-5, atol=1e-7)
    np.testing.assert_allclose(found.slope, expected[0], rtol=2e-3, atol=2e-4 * np.abs(expected[0]).max())
    np.testing.assert_allclose(found.slopes, expected[1:], rtol=2e-3, atol=2e-4 * np.abs(expected[1:]).max())
    assert slopes.runs == 1


@pytest.mark.parametrize("more", [{}, {"drives.0.sample_time": 1e-3, "integration.method": "rk4"}])
def test_slopes_of_the_worst_of_several_cases(more: dict[str, Any]) -> None:
    """Of the case that decides, whatever its place; through samples of a controller, too."""
    asked = spong(
        {"error": {"series": "tip_error", "reduce": "rms", "unit": "mm"},
         "end": {"series": "tip_error", "reduce": "end"}},
        "error", ["end <= 1"], gain=uniform("drives.0.controller.position_gain", 40.0, 120.0),
        rate=uniform("drives.0.controller.velocity_gain", 6.0, 20.0), mass=uniform(MASS, 0.5, 2.0),
    )  # fmt: skip
    data = json.loads(json.dumps(asked.data["study"]))
    data["set"].update(more)
    data["optimize"]["design"] = ["gain", "rate"]
    trials = trials_of(study_from_data(data))
    trials.scenarios = np.repeat(trials.scenarios, 3, axis=0)
    trials.scenarios[:, 2], trials.scenarios[:, 0] = [0.8, 1.7, 1.2], [120.0, 50.0, 80.0]
    start = trials.start  # of the sheet, whatever its scenarios are
    assert trials.space.at(start[None])[0] == pytest.approx(trials.study.space.nominal[:2])
    slopes, shares, step = Adjoint(trials, {}), np.array([0.4, 0.3]), 1e-3
    found = slopes.at(shares)
    assert trials.goals.deciding({name: one[:1] for name, one in trials.values.items()})[0] == 1
    points = shares + step * np.concatenate([np.zeros((1, 2)), np.eye(2), -np.eye(2)])
    judged = trials.judged(trials.at(trials.space.at(points)))
    values = np.column_stack([judged.objectives, judged.excess])
    expected = (values[1:3] - values[3:]).T / (2 * step)
    np.testing.assert_allclose([found.objective, *found.excess], values[0], rtol=1e-5)
    np.testing.assert_allclose([found.slope, *found.slopes], expected, rtol=2e-4, atol=2e-4 * np.abs(expected).max())
    assert slopes.runs == 2  # of the two quantities, in the case that decides both


@pytest.mark.nightly
def test_the_worst_case_of_a_run_along_gradients() -> None:
    """Gains for the worst of 9 stiffnesses: as good as what is found without slopes, which needs more designs."""
    gains = {"kp": (20.0, 600.0), "kv": (2.0, 80.0)}
    parameters = {
        name: {"path": f"drives.0.controller.{long}_gain",
               "distribution": {"type": "loguniform", "low": gains[name][0], "high": gains[name][1]}}
        for name, long in {"kp": "position", "kv": "velocity"}.items()
    }  # fmt: skip
    parameters["k"] = uniform(f"real:{GEAR}", 0.6, 1.2)
    data = spong({"error": {"series": "tip_error", "reduce": "rms", "unit": "mm"}}, "error", [], **parameters).data
    aim = {"objectives": [{"minimize": "error"}], "design": ["kp", "kv"], "worst_case": 9}
    asked = study_from_data({**data, "study": {**data["study"], "optimize": aim}})
    found, other = optimize(asked), optimize(asked, "cobyqa", trials=60)
    assert found.method == "gradient"
    assert found.best
    assert other.best
    assert found.start
    assert found.best.objectives[0] == pytest.approx(other.best.objectives[0], rel=2e-3)
    assert found.best.objectives[0] < 0.9 * found.start.objectives[0]
    low, high = found.best.quantities["error"]
    assert low < high == pytest.approx(found.best.objectives[0])  # of 9 cases
    robot = load("spong1987").with_(data["study"]["set"])
    best = {f"drives.0.controller.{name}_gain": found.best.values[key]
            for key, name in {"kp": "position", "kv": "velocity"}.items()}  # fmt: skip
    assert found.trials
    worst = [
        1e3 * tmodes.Robot.of(robot).with_({**best, "real": {GEAR: float(case[2])}}).run().reduce("tip_error", "rms")
        for case in found.trials.scenarios
    ]
    assert max(worst) == pytest.approx(found.best.objectives[0], rel=1e-4)


@pytest.mark.nightly
def test_gradients_need_a_fifth_of_the_runs_of_a_search() -> None:
    pytest.importorskip("optuna")
    asked = read_study(EXAMPLES / "tracking.yaml")
    searched = optimize(asked, "tpe", trials=128)
    found = optimize(asked)
    assert searched.best is not None
    assert found.best is not None
    assert found.method == "gradient"
    assert found.best.objectives[0] < searched.best.objectives[0]
    (goal_at, goal), reached = searched.history[-1], found.history
    runs = next(number + 1 for number, value in reached if value <= goal)
    assert 5 * runs <= goal_at + 1
    assert found.gradients == found.designs


def test_limits_on_simulated_quantities_and_on_numbers_at_rest() -> None:
    asked = spong(
        {"error": {"series": "tip_error", "reduce": "rms", "unit": "mm"}, "sag": {"static": "sag", "unit": "mm"}},
        "gear/100", ["error <= 60 mm", "sag <= 80 mm"],
        gear=uniform(GEAR, 50.0, 400.0), gain=uniform("drives.0.controller.position_gain", 40.0, 400.0),
    )  # fmt: skip
    found = optimize(asked, "gradient")
    assert found.best is not None
    assert any(limit.active for limit in found.best.limits)
    assert found.best.feasible
    rows = asked.evaluate(0, np.array([[found.best.values["gear"], found.best.values["gain"]]]))
    assert rows.quantities["error"][0] == pytest.approx(found.best.quantities["error"][0], rel=1e-4)


def test_a_functional_of_ones_own() -> None:
    robot = load("spong1987").with_({"joints.joint.gear.damping": 0.5, "integration.duration": 1.5})
    from tmodes.gradients.gradient import adjoint_gradient

    asked = spong(
        {"sag": {"static": "sag"}}, "apart", [], gear=uniform(GEAR, 60.0, 140.0), mass=uniform(MASS, 0.5, 2.0)
    )
    apart = tracking_error("tip", (0.3, 0.0, -0.9))
    found = optimize(asked, functionals={"apart": apart})
    assert found.method == "gradient"
    assert found.best is not None
    start = adjoint_gradient(robot, apart).value
    assert found.best.objectives[0] < start


def test_what_has_no_slope_is_refused() -> None:
    asked = spong({"peak": {"series": "tip_error", "reduce": "max"}}, "peak", [], gear=uniform(GEAR, 60.0, 140.0))
    with pytest.raises(InputError, match="a largest or least value has no slope everywhere"):
        optimize(asked, "gradient")
    asked = spong({"far": {"series": "tip_difference", "reduce": "rms"}}, "far", [], gear=uniform(GEAR, 60.0, 140.0))
    with pytest.raises(InputError, match="another run than the sheet's own"):
        optimize(asked, "gradient")


def test_a_design_may_move_the_nominal_tip_too() -> None:
    asked = spong({"far": {"series": "deviation", "reduce": "rms"}}, "far", [], gear=uniform(GEAR, 60.0, 140.0))
    slopes, shares, step = Adjoint(trials_of(asked), {}), np.array([0.4]), 1e-2
    low, high = (slopes.at(shares + by).objective for by in (-step, step))
    assert slopes.at(shares).slope[0] == pytest.approx((high - low) / (2 * step), rel=2e-3)
