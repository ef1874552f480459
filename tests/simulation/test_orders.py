"""Orders of all integrators on an arm whose input jumps: steps end exactly on the jumps, so that none is lost there."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from simulation.sheets import arm
from tmodes.sheet import Robot
from tmodes.simulation.initial_state import run_setup, run_trajectory
from tmodes.simulation.native_run import NativeRun
from tmodes.simulation.parts import Trajectory
from tmodes.simulation.problem import problem_of

JUMPS = (0.1234, 0.3217)
METHODS = ("dormand_prince", "dop853", "rk4", "extrapolation", "midpoint", "rosenbrock")


def double_pendulum(jumps: tuple[float, ...] = JUMPS, **integration: Any) -> Robot:
    """Two rods that swing, each with a torque that jumps at its own time."""
    joints = [{"name": f"j{k}", "type": "revolute", "child": f"l{k}", "axis": [0, 1, 0]} for k in range(2)]
    links = [
        {"name": f"l{k}", "bodies": [{"name": "bob", "mass": 1.0, "center": [0, 0, -1], "inertia": {"yy": 0.1,
         "xx": 0.1, "zz": 0.1}}]} for k in range(2)
    ]  # fmt: skip
    joints[1]["origin"] = {"position": [0, 0, -1]}
    signals = [{"type": "step", "start": -2.0, "end": 6.0 * (k - 0.5), "time": time} for k, time in enumerate(jumps)]
    still = {"type": "constant", "value": 0.0}
    drives = [
        {"joint": f"j{k}", "command": "effort", "signal": signals[k] if k < len(signals) else still} for k in range(2)
    ]
    return arm(
        gravity=9.81, joints=joints, links=links, drives=drives,
        initial={"state": "zero", "coordinates": {"j0": 0.4, "j1": -0.3}},
        integration={"duration": 0.5, "output_step": 0.5, **integration},
    )  # fmt: skip


def end(jumps: tuple[float, ...] = JUMPS, **integration: Any) -> Trajectory:
    return run_trajectory(run_setup(double_pendulum(jumps, **integration)))


def tight(method: str, tolerance: float, jumps: tuple[float, ...] = JUMPS, **more: Any) -> Trajectory:
    return end(jumps, method=method, relative_tolerance=tolerance, absolute_tolerance=tolerance, **more)


@pytest.fixture(scope="module")
def exact() -> np.ndarray:
    return tight("dop853", 1e-13).states[-1, :4]


def off(run: Trajectory, exact: np.ndarray) -> float:
    return float(np.abs(run.states[-1, :4] - exact).max())


@pytest.mark.parametrize(
    ("method", "order", "steps"), [("rk4", 4.0, [16e-3, 8e-3, 4e-3]), ("midpoint", 2.0, [8e-3, 4e-3, 2e-3])]
)
def test_order_at_fixed_step(exact: np.ndarray, method: str, order: float, steps: list[float]) -> None:
    """The error falls with a power of the step, over the jumps."""
    errors = [off(end(method=method, step=step, relative_tolerance=1e-13), exact) for step in steps]
    assert np.polyfit(np.log(steps), np.log(errors), 1)[0] == pytest.approx(order, abs=0.3)


@pytest.mark.parametrize(
    ("method", "order", "around"), [("dormand_prince", 5.0, 0.8), ("dop853", 8.0, 1.0), ("rosenbrock", 5.0, 1.0)]
)
def test_order_of_adaptive_steps(method: str, order: float, around: float) -> None:
    """The error falls with a power of the number of steps: those of a motion without jumps, where none is cut short."""
    long = {"duration": 3.0, "output_step": 3.0}
    reference = tight("dop853", 1e-13, (), **long).states[-1, :4]
    tolerances = np.logspace(-11, -6, 11) if method == "dop853" else np.logspace(-9, -5, 9)
    runs = [tight(method, float(tolerance), (), **long) for tolerance in tolerances]
    counts, errors = [run.statistics["steps"] for run in runs], [off(run, reference) for run in runs]
    assert -np.polyfit(np.log(counts), np.log(errors), 1)[0] == pytest.approx(order, abs=around)


@pytest.mark.parametrize("method", ["dormand_prince", "dop853", "rosenbrock", "extrapolation"])
def test_jumps_cost_no_accuracy(exact: np.ndarray, method: str) -> None:
    """Over the jumps the error stays as proportional to the tolerance as without them."""
    tolerances = np.logspace(-10, -6, 5)
    runs = [tight(method, float(tolerance)) for tolerance in tolerances]
    errors = np.array([off(run, exact) for run in runs])
    assert (errors < 30 * tolerances).all()
    assert np.polyfit(np.log(tolerances), np.log(errors), 1)[0] == pytest.approx(1.0, abs=0.35)


@pytest.mark.parametrize("method", METHODS)
def test_steps_end_exactly_on_jumps(method: str) -> None:
    """One attempt after the other: the segment of the input changes where the time is that of the jump, to the bit."""
    setup = run_setup(double_pendulum(method=method, step=7e-3))
    model, schedule, settings = setup.model, setup.planned.schedule, setup.robot.integration
    run = NativeRun(problem_of(model, model.numbers, schedule, setup.start, settings))
    changes = []
    while run.running:
        segment = run.cell("segment")
        run.advance(1)
        if run.cell("segment") > segment:
            changes.append(run.cell("t"))
    assert changes == [*JUMPS, settings.duration]
