"""The printed errors of a run's numbers against the true ones: bounds hold, estimates are near, the rest is unknown."""

from __future__ import annotations

import json
from dataclasses import replace
from itertools import product
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import tmodes
from error_runs import judged, simulated
from simulation.sheets import arm, landing, pendulum
from simulation.test_extrapolation import stiff
from tmodes.integrate.registry import integrator, integrators
from tmodes.integrate.settings import Integration
from tmodes.interface.summary import error_of
from tmodes.io.sheet_check import sheet_data
from tmodes.kinds.signals.schedule import MergedSchedule
from tmodes.report.page import error_table
from tmodes.result.assemble import ResultAssembly
from tmodes.result.errors import summary_figures
from tmodes.result.summary import summarise_result
from tmodes.sheet import Robot
from tmodes.simulation.initial_state import run_setup, run_trajectory
from tmodes.simulation.parts import Trajectory
from tmodes.simulation.step_refinement import refined_run

EXACT = {"method": "dop853", "relative_tolerance": 1e-12, "absolute_tolerance": 1e-15}


def turning(signal: dict[str, Any], **more: Any) -> Robot:
    """A bob on an elastic joint under control."""
    drive = {"command": "position", "signal": signal,
             "controller": {"type": "pd", "position_gain": 80.0, "velocity_gain": 12.0}}  # fmt: skip
    settings = {"duration": 0.5, "output_step": 5e-3} | more
    return pendulum({"inertia": 0.3}, {"stiffness": 100.0}, drive, integration=settings)


MOVE = {"type": "quintic", "start": 0.0, "end": 1.0, "duration": 0.3}
KINDS = {
    "elastic joint": lambda **more: turning(MOVE, **more),
    "contact": lambda **more: landing(damping=20.0, **{"duration": 0.3, "output_step": 3e-3} | more),
    "beam": lambda **more: stiff(**{"output_step": 5e-3, "duration": 0.25} | more),
}
CASES = [*product(("elastic joint", "contact"), integrators()), ("beam", "dormand_prince"), ("beam", "extrapolation")]
SETTINGS = [{}, *({"relative_tolerance": rtol, "absolute_tolerance": rtol * 1e-2} for rtol in (1e-4, 1e-7))]


@pytest.fixture(scope="module")
def exact() -> dict[str, ResultAssembly]:
    return {kind: simulated(robot(**EXACT)) for kind, robot in KINDS.items()}


@pytest.mark.parametrize(("kind", "method"), CASES)
def test_printed_bounds_hold(kind: str, method: str, exact: dict[str, ResultAssembly]) -> None:
    """Every number, every method, loose, tight and default; most are bounds, which are not far above the truth."""
    steps = [{"step": step} for step in (1e-3, 2e-4)]
    seen = []
    for settings in SETTINGS if integrator(method).adaptive else steps:
        robot = KINDS[kind](**{"relative_tolerance": 1e-9, "absolute_tolerance": 1e-12} | settings, method=method)
        run = simulated(robot)
        if run.ending[0] == "finished":
            seen += [one for one in judged(run, exact[kind], exact[kind]) if one[3] > 1e-12 * one[5]]
    assert seen
    assert [one for one in seen if one[1] and one[3] > one[2]] == []
    assert np.median([printed / true for _, _, printed, true, *_ in seen]) < 30
    assert np.mean([one[1] for one in seen]) > 0.5 or (kind == "contact" and not integrator(method).adaptive)


def test_steps_that_pieces_of_a_signal_hold_short() -> None:
    """A table of so many pieces that no tolerance matters: steps are refined all the same."""
    times = np.linspace(0, 0.5, 60)
    values = np.sin(7 * times).tolist()
    table = {"type": "table", "times": times.tolist(), "values": values, "interpolation": "linear"}
    loose = {"method": "dormand_prince", "relative_tolerance": 1e-3, "absolute_tolerance": 1e-3}
    run, exact = (simulated(turning(table, **how)) for how in (loose, EXACT))
    assert run.run.statistics["steps"] < 1.1 * len(times)
    for _, bound, printed, true, *_ in judged(run, exact, exact):
        assert true < printed * (1 if bound else 3) + 1e-15


@given(st.integers(0, 2**32 - 1))
def test_halved_pieces_are_the_same_signals(seed: int) -> None:
    rng = np.random.default_rng(seed)
    pieces, signals, degree = rng.integers(1, 5), rng.integers(0, 4), rng.integers(0, 6)
    whole = MergedSchedule(np.cumsum(rng.uniform(0.1, 1, pieces + 1)), rng.normal(size=(pieces, signals, degree + 1)))
    halved = whole.halved()
    assert len(halved.knots) == 2 * pieces + 1
    assert set(whole.knots) <= set(halved.knots)
    times = rng.uniform(whole.knots[0], whole.knots[-1], 20)
    assert halved.at(times) == pytest.approx(whole.at(times), abs=1e-12)


@pytest.mark.parametrize("check", [False, True])
@pytest.mark.parametrize("method", [*integrators()])
def test_settings_of_the_second_run(method: str, check: bool) -> None:
    """Finer, and the share by which errors of this order leave the difference; coarser where rounding begins."""
    own = Integration(method=method, check_error=check, relative_tolerance=1e-6)
    one, times = integrator(method), 2 if check else 1
    second, share = own.refined()
    less = 10.0**-times if one.adaptive else 2.0 ** (-times * one.order)
    assert share * (1 - less) == pytest.approx(1)
    assert second.step == own.step / 2**times
    assert second.relative_tolerance == pytest.approx(own.relative_tolerance * 10.0**-times)
    least = own.model_copy(update={"relative_tolerance": max(one.least_tolerance, 1e-13)})
    assert one.least_tolerance <= least.refined()[0].relative_tolerance


def test_a_run_that_is_lost_or_cut_has_no_estimate(monkeypatch: pytest.MonkeyPatch) -> None:
    """No number is made up; Ctrl-C in the second run is passed on, so that the same command resumes."""
    setup = run_setup(turning(MOVE, method="rk4"))
    done = run_trajectory(setup)
    assert refined_run(setup, done) is not None
    assert refined_run(setup, replace(done, status="diverged")) is None
    assert refined_run(replace(setup, callback=True), done) is None
    cut = Trajectory(np.zeros(1), np.zeros((1, 2)), "interrupted", "interrupted")
    monkeypatch.setattr("tmodes.simulation.step_refinement.run_trajectory", lambda *_: cut)
    with pytest.raises(KeyboardInterrupt):
        refined_run(setup, done)


def test_errors_that_are_large_are_estimates() -> None:
    """A chaotic motion: what two runs make of it differs, and is printed as about that."""
    body = {"bodies": [{"name": "bob", "mass": 1.0, "center": [0, 0, -0.5]}]}
    joints = [{"name": "a", "type": "revolute", "parent": "base", "child": "first", "axis": [0, 1, 0]},
              {"name": "b", "type": "revolute", "child": "second", "axis": [0, 1, 0],
               "origin": {"position": [0, 0, -0.5]}}]  # fmt: skip
    robot = arm(gravity=9.81, joints=joints, links=[{"name": "first", **body}, {"name": "second", **body}],
                initial={"state": "zero", "rates": {"a": 9.0, "b": -8.0}},
                integration={"duration": 8.0, "output_step": 0.05, "method": "rk4", "step": 0.01})  # fmt: skip
    info = simulated(robot).errors
    assert "tip_m" in info["approximate"]
    assert error_of({"error": info}, "tip_m", 1.0, "m").startswith("≈ ")
    assert "≈\u00a0" in str(error_table(info))


@pytest.mark.parametrize("resolution", [None, 1e-4])
def test_errors_under_rounded_sensors_are_estimates(resolution: float | None) -> None:
    law = {"type": "lqg", "sample_time": 0.01, "measured": ["teeth"], "measurement_noise": [1e-8],
           "state_weights": {"joint.motor": 100.0},
           "process_noise": {"joint.motor'": 1e-4, "joint'": 1e-4}}  # fmt: skip
    data = sheet_data(tmodes.load("spong1987").with_({"integration.duration": 0.3}))
    drives = [{key: value for key, value in data["drives"][0].items() if key != "controller"}]
    teeth = {"name": "teeth", "type": "encoder", "joint": "joint"} | ({"resolution": resolution} if resolution else {})
    control = [{"name": "law", "drives": ["joint"], "block": law}]
    info = simulated(Robot.from_data(data | {"drives": drives, "sensors": [teeth], "control": control})).errors
    assert ("tip_m" in info["approximate"]) == (resolution is not None)


def test_errors_of_an_earlier_version_are_estimates() -> None:
    """Its sums of local errors were printed as bounds, and were passed."""
    result = tmodes.run(turning(MOVE))
    data: Any = result.data.copy()
    data.attrs["errors"] = json.dumps({"how": "sum of the local errors", "figures": {"tip_m": 1e-9}})
    info = summarise_result(data)
    assert error_of(info, "tip_m", 1e3, "mm") == "≈ 1.0e-06 mm"
    assert error_of(info, "deviation.max_m", 1e3, "mm") == ""
    assert error_of(result.summary(), "tip_m", 1e3, "mm").startswith("< ")


def test_errors_are_left_out_where_that_is_asked() -> None:
    result = tmodes.run(turning(MOVE).with_({"integration.error_estimate": False}))
    assert result.summary()["error"] is None
    assert result.summary()["status"] == "finished"


def test_the_error_of_a_deflection_is_that_at_its_largest() -> None:
    """As the summary reports it: the distance of all directions, whatever one of them does."""
    end = np.array([[3.0, 0.0, 0.0], [0.0, 4.0, 0.0], [2.9, 0.0, 3.9]])
    deflection = np.stack([np.zeros((3, 3)), end], axis=1)[:, None]
    values = {"deflection": deflection, "moment": np.zeros((3, 1, 2, 3)), "stress": np.zeros((3, 0, 2))}
    found = {one.name: one.sample for one in summary_figures(values, {"bending_link": ["rod"], "stressed_link": []})}
    assert found["links.rod.deflection.max_m"] == 2
