"""The 2010 robot as WebAssembly: in another engine, without fused operations, the same motion as natively."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tmodes.live.module import LiveModule
from tmodes.live.wasm_paper import robot_module
from tmodes.paper.mechanism import Drive
from tmodes.paper.model import PaperModel
from tmodes.robots.load import load_sheet
from tmodes.simulation.parts import sample_times
from tmodes.simulation.trajectory import integrate
from wasm.node import in_node

SAME = {
    "rk4": 1e-12,
    "dormand_prince": 1e-12,
    "midpoint": 1e-12,
    "rosenbrock": 1e-12,
    "dop853": 1e-8,
    "extrapolation": 1e-9,
}
"""By how much two engines differ, over the largest number of a state: products and sums are rounded once or twice.

Where the error of a step is next to nothing it is told by rounding alone: steps of dop853 then differ in length.
Extrapolation adds up its rows with weights of thousands.
"""


def _robot(method: str = "dormand_prince") -> Any:
    return load_sheet("filipovic2010").with_({"integration.method": method, "integration.duration": 0.1})


@pytest.fixture(scope="module")
def module() -> LiveModule:
    return robot_module(_robot().pair(), [*SAME])


def _regime(robot: Any, regime: str) -> tuple[Any, PaperModel, Any, Any, Any]:
    drive = Drive.PRESCRIBED if regime == "reference" else Drive.CONTROLLED
    which = robot.pair().nominal if regime == "reference" else robot.pair().real
    mechanism, parameters = which.split(drive)
    model = PaperModel(mechanism)
    schedule = which.wanted(drive).until(which.integration.duration)
    return which.integration, model, parameters, schedule, model.rest(which.reference.start, parameters)


def _job(robot: Any, regime: str) -> tuple[dict[str, Any], Any]:
    settings, model, parameters, schedule, start = _regime(robot, regime)
    spec = {
        "loop": f"{regime}.{settings.method}", "parameters": parameters.vector, "knots": schedule.knots,
        "rows": np.column_stack([schedule.knots[:-1], schedule.coefficients]), "state": start,
        "times": sample_times(settings), "settings": {
            "duration": settings.duration, "relativeTolerance": settings.relative_tolerance,
            "absoluteTolerance": settings.absolute_tolerance, "step": settings.step, "maxSteps": settings.max_steps,
        },
    }  # fmt: skip
    return {"run": spec}, integrate(model, parameters, schedule, start, settings)


def test_motion_is_the_native_one(module: LiveModule, tmp_path: Path) -> None:
    cases = [(method, regime) for method in SAME for regime in ("reference", "real")]
    jobs = [_job(_robot(method), regime) for method, regime in cases]
    found = in_node(module, [job for job, _ in jobs], tmp_path)
    for (method, _), info, (_, native) in zip(cases, found, jobs, strict=True):
        assert info["status"] == native.status == "finished"
        assert info["message"] == native.message
        same = {name: native.statistics[name] for name in ("method", "steps", "rejected", "evaluations")}
        assert {name: info["statistics"][name] for name in same} == same
        np.testing.assert_array_equal(info["times"], native.times)
        states, largest = info["states"].reshape(native.states.shape), np.abs(native.states).max()
        np.testing.assert_allclose(states, native.states, rtol=0, atol=SAME[method] * largest)


@pytest.mark.parametrize("regime", ["reference", "real"])
def test_samples_are_the_native_ones(module: LiveModule, regime: str, tmp_path: Path) -> None:
    _, model, parameters, schedule, start = _regime(_robot(), regime)
    rng = np.random.default_rng(5)
    states = start + np.array([*[1e-3] * 6, *[1e-2] * 6, *[1e-3] * 5]) * rng.normal(size=(7, 17))
    times = np.linspace(0.0, 0.09, 7)
    rows, stations = schedule.rows_at(times), np.linspace(0, 1, 7)
    motion, force = np.column_stack([states[:, :12], rng.normal(size=(7, 6))]), rng.normal(size=(7, 3))
    gross, near = np.column_stack([states[:, :3], force]), states[:, :5]
    instant = {"time": times, "state": states, "row": rows}
    inputs = {
        "observe": instant, "rate": instant,
        "line2": {"station": stations, "motion": np.column_stack([motion, force])},
        "quasistatic": {"angles": near, "gross": gross}, "rest": {"angles": near, "theta": states[:, 5]},
    }  # fmt: skip
    jobs = [
        {"sample": f"{regime}.{name}", "parameters": parameters.vector, "inputs": given, "count": 7}
        for name, given in inputs.items()
    ]
    found = dict(zip(inputs, in_node(module, jobs, tmp_path), strict=True))
    line = model.line(np.column_stack([motion, force]), stations, parameters)
    expected = {
        "observe": model.observe(times, states, rows, parameters),
        "rate": {"rate": model.rate(times, states, rows, parameters)},
        "line2": {name: values[range(7), 1, range(7)] for name, values in line.items()},
    }
    for name, parts in expected.items():
        assert set(found[name]) == set(parts)
        for label, values in parts.items():
            np.testing.assert_allclose(found[name][label], values.ravel(), rtol=1e-9, atol=1e-9 * np.abs(values).max())
    for name in ("quasistatic", "rest"):  # the slope told is that of the residual told
        assert np.isfinite(found[name]["residual"]).all()
        assert _slope_error(found[name], near, jobs[[*inputs].index(name)], module, tmp_path) < 1e-6


def test_memory_grows_with_the_samples(module: LiveModule, tmp_path: Path) -> None:
    _, model, parameters, schedule, start = _regime(_robot(), "real")
    rows, states = schedule.rows_at(np.array([0.05])), start + 1e-3
    instant = {"time": np.array([0.05]), "state": states, "row": rows[0]}
    job = {"sample": "real.rate", "parameters": parameters.vector, "inputs": instant, "count": 3000}
    (found,) = in_node(module, [job], tmp_path)
    rates = found["rate"].reshape(3000, -1)
    assert (rates == rates[0]).all()
    expected = model.rate([0.05], states, rows, parameters)[0]
    np.testing.assert_allclose(rates[0], expected, rtol=1e-9, atol=1e-9)


def test_only_lanes_ask_for_vectors(module: LiveModule) -> None:
    assert module.layout["simd"]  # for extrapolation goes by lanes
    assert not robot_module(_robot().pair(), ["dormand_prince"]).layout["simd"]


def _slope_error(info: dict[str, Any], near: Any, job: dict[str, Any], module: LiveModule, folder: Path) -> float:
    """Of the slope along one direction, against a central difference."""
    along, h = np.array([0.3, -0.5, 0.2, 0.7, -0.1]), 1e-6
    moved = [{**job, "inputs": job["inputs"] | {"angles": near + side * h * along}} for side in (1, -1)]
    ahead, behind = (found["residual"] for found in in_node(module, moved, folder))
    slope = info["slope"].reshape(-1, 5, 5).transpose(0, 2, 1) @ along
    difference = ((ahead - behind) / (2 * h)).reshape(-1, 5)
    return float(np.abs(slope - difference).max() / np.abs(slope).max())


def test_what_is_wrong_is_reported(module: LiveModule, tmp_path: Path) -> None:
    job, _ = _job(_robot(), "real")
    numbers = job["run"]["parameters"]
    jobs = [
        {"sample": "real.nothing", "parameters": numbers, "inputs": {}, "count": 1},
        {"sample": "real.rate", "parameters": numbers[:3], "inputs": {}, "count": 1},
        {"sample": "real.rate", "parameters": numbers, "inputs": {"time": np.zeros(1)}, "count": 1},
        {"run": job["run"] | {"loop": "real.euler"}},
        {"run": job["run"] | {"settings": job["run"]["settings"] | {"maxSteps": 20}}},
        {"run": job["run"] | {"state": np.full(17, 1e300)}},
    ]
    found = in_node(module, jobs, tmp_path)
    assert found[0]["error"].startswith("EngineError: function: got real.nothing; expected one of reference.observe")
    assert found[1]["error"] == f"EngineError: real.rate: parameters: got 3 numbers; expected {len(numbers)}"
    assert found[2]["error"] == "EngineError: state: got nothing; expected 17 numbers for each sample"
    assert found[3]["error"].startswith("EngineError: loop: got real.euler; expected one of reference.rk4")
    assert (found[4]["status"], found[4]["statistics"]["steps"] + found[4]["statistics"]["rejected"]) == ("stopped", 20)
    assert found[4]["message"].endswith("integration.max_steps = 20 is used up")
    assert found[5]["status"] == "diverged"
