"""Sampled controllers: exact on their samples in every way to run, their states on show, their poles exact."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from numpy.typing import ArrayLike, NDArray
from scipy.linalg import expm

import tmodes
from contracts.test_controllers import gains, robot
from lane_runs import simulate_lanes
from simulation.sheets import arm
from tmodes.analysis.modes.of_sheet import vibrations
from tmodes.gradients.gradient import forward_sensitivities
from tmodes.live.bundle import live_bundle, why_not_live
from tmodes.model.model import Model
from tmodes.simulation.initial_state import run_setup, run_trajectory
from tmodes.simulation.parts import sample_times
from tmodes.simulation.simulate import simulate_motion
from wasm.node import page_states

PERIOD, INERTIA, KP, KI, KV = 0.03, 0.5, 20.0, 10.0, 3.0
LAW = {"type": "sampled_pid", "position_gain": KP, "integral_gain": KI, "velocity_gain": KV, "sample_time": PERIOD}


def motor(**integration: Any) -> Any:
    """One inertia, which a sampled controller moves; its wanted position jumps between two samples."""
    joint = {"name": "j", "type": "revolute", "child": "l", "axis": [0, 0, 1],
             "motor": {"inertia": INERTIA, "side": "joint"}}  # fmt: skip
    signal = {"type": "step", "start": 0.0, "end": 1.0, "time": 0.13}
    settings = {"duration": 1.0, "output_step": 0.01, "relative_tolerance": 1e-9, "absolute_tolerance": 1e-10}
    return arm(gravity=0.0, joints=[joint], links=[{"name": "l"}],
               drives=[{"joint": "j", "command": "position", "signal": signal, "controller": LAW}],
               integration=settings | integration)  # fmt: skip


def exact(times: Any, inertia: float = INERTIA, kp: float = KP, ki: float = KI) -> np.ndarray:
    """Angle, held torque and integral (n, 3): parabolas between samples, each from the state at the last."""
    q = v = z = u = t = 0.0
    rows, samples = [], 0
    for time in times:
        while samples * PERIOD <= time + 1e-12:
            h = samples * PERIOD - t
            q, v, t = q + v * h + u / inertia * h * h / 2, v + u / inertia * h, samples * PERIOD
            error = (1.0 if t >= 0.13 else 0.0) - q
            u, z = kp * error + ki * z - KV * v, z + PERIOD * error
            samples += 1
        h = time - t
        rows.append((q + v * h + u / inertia * h * h / 2, u, z))
    return np.array(rows)


@pytest.mark.parametrize("method", ["dormand_prince", "dop853", "rk4", "extrapolation", "rosenbrock", "midpoint"])
def test_equals_the_exact_solution(method: str) -> None:
    run = simulate_motion(motor(method=method, **({"step": 2e-3} if method in {"rk4", "midpoint"} else {})))
    true = exact(run.times)
    assert np.abs(run.q[:, 0] - true[:, 0]).max() < 1e-9
    # Where the run ends on a sample, that sample is not taken any more.
    assert np.abs(run.effort[:-1, 0] - true[:-1, 1]).max() < 1e-8
    assert np.abs(run.controls[:-1] - true[:-1, 1:]).max() < 1e-8
    assert np.abs(run.energy_balance).max() < 1e-9 * run.energy_moved


@pytest.mark.parametrize("method", ["dormand_prince", "rk4"])
def test_side_by_side(method: str) -> None:
    """In a batch each robot has its own gains, and signals whose knots are its own."""
    setup = run_setup(motor(method=method, step=2e-3))
    rows = np.array([setup.model.numbers] * 5)
    batch = simulate_lanes(setup.model, rows, setup.planned.schedule, setup.start, setup.robot.integration)
    true = exact(sample_times(setup.robot.integration))[:, 0]
    assert np.abs(batch.states[:, :, 0] - true).max() < 1e-9


def test_in_a_page(tmp_path: Any) -> None:
    """The module of the page samples at the same instants; the page's bundle is made."""
    setup = run_setup(motor(method="dormand_prince"))
    assert np.abs(page_states(setup, tmp_path) - run_trajectory(setup).states).max() < 1e-12
    result = tmodes.run(motor())
    assert why_not_live(result) == ""
    assert live_bundle(result) is not None


def test_states_are_series_figures_and_stop_quantities(tmp_path: Any) -> None:
    """By name and unit, also after a round trip; a run ends where one of them passes a value."""
    result = tmodes.run(motor())
    result.save(tmp_path / "run.nc")
    again = tmodes.Result.load(tmp_path / "run.nc")
    series = again.data["controller_states"]
    assert series["controller_state"].values.tolist() == ["j.controller.command", "j.controller.integral"]
    assert series["controller_state_unit"].values.tolist() == ["N*m", "rad*s"]
    assert np.abs(series.values[:-1] - exact(again.data["time"].values)[:-1, 1:]).max() < 1e-8
    assert "controller_states" in again.figures()
    stopped = tmodes.run(motor(stop=["j.controller.integral > 0.1"]))
    assert stopped.status == "stopped_by_condition"
    assert (stopped.data["time"].values[-1] / PERIOD) % 1 == pytest.approx(0.0, abs=1e-9)
    before = tmodes.run(motor(stop=["abs(j.controller.command) > 1"]))
    assert before.data["time"].values[-1] == pytest.approx(0.15, abs=1e-12)


@pytest.mark.parametrize("method", ["dormand_prince", "rk4", "extrapolation"])
def test_derivatives_are_those_of_the_exact_solution(method: str) -> None:
    paths = {
        "joints.j.motor.inertia": 0,
        "drives.0.controller.position_gain": 1,
        "drives.0.controller.integral_gain": 2,
    }
    found = forward_sensitivities(motor(method=method, **({"step": 2e-3} if method == "rk4" else {})), [*paths])
    for path, k in paths.items():
        numbers, step = np.array([INERTIA, KP, KI]), 1e-4 * np.eye(3)[k]
        slope = (exact(found.times, *(numbers + step)) - exact(found.times, *(numbers - step))) / 2e-4
        assert np.abs(found.by[path][:, 0] - slope[:, 0]).max() < 1e-7


def ordered(values: ArrayLike) -> NDArray[np.complex128]:
    """By real part, whose rounding does not tear a pair apart, then by imaginary part."""
    found = np.asarray(values, dtype=np.complex128)
    return found[np.lexsort((found.imag, found.real.round(6)))]


def poles(sheet: Any) -> np.ndarray:
    return ordered(np.array([complex(*pole) for pole in vibrations(sheet).poles]))


def open_loop() -> tuple[np.ndarray, np.ndarray]:
    """State matrix (q, v) and input column of the robot of the controllers' tests."""
    model = Model(robot({"type": "pd", "position_gain": 0.0, "velocity_gain": 0.0}).chain())
    n = model.nq
    mass, damping, stiffness = model.linearize(np.zeros(n))
    a, b = np.zeros((2 * n, 2 * n)), np.zeros((2 * n, 1))
    a[:n, n:], a[n:, :n], a[n:, n:] = np.eye(n), -np.linalg.solve(mass, stiffness), -np.linalg.solve(mass, damping)
    b[n:, 0] = np.linalg.solve(mass, np.eye(n)[:, 0])
    return a, b


def test_poles_under_full_feedback_with_an_integral() -> None:
    """Those of A - B K, for which the gains were made; the modes are among them."""
    row = np.array([gains()])
    a, b = open_loop()
    n = len(a)
    whole = np.block([[a, np.zeros((n, 1))], [np.eye(1, n), np.zeros((1, 1))]]) - np.vstack([b, [[0.0]]]) @ row
    sheet = robot({"type": "own_lqr", "row": row[0].tolist()})
    found = poles(sheet)
    assert found == pytest.approx(ordered(np.linalg.eigvals(whole)), rel=1e-8)
    for mode in vibrations(sheet).states["controlled"]:
        if mode["damped_frequency_Hz"]:
            assert np.abs(np.abs(found) / (2 * np.pi) - mode["frequency_Hz"]).min() < 1e-8 * mode["frequency_Hz"]


def test_poles_of_a_sampled_controller() -> None:
    """log(z)/T of the discrete system, found by the exponential of its matrices."""
    period = 0.004
    law = {"type": "sampled_pid", "position_gain": 80.0, "integral_gain": 50.0, "velocity_gain": 9.0}
    a, b = open_loop()
    n = len(a)
    both = expm(np.block([[a, b], [np.zeros((1, n + 1))]]) * period)
    step, pushed = both[:n, :n], both[:n, n:]
    fed = np.zeros((1, n))
    fed[0, 0], fed[0, n // 2] = 80.0, 9.0
    z = np.linalg.eigvals(np.block([[step - pushed @ fed, 50.0 * pushed], [-period * np.eye(1, n), np.eye(1)]]))
    found = poles(robot(law | {"sample_time": period}))
    assert found == pytest.approx(ordered(np.log(z) / period), rel=1e-7)
