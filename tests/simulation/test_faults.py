"""Faults within a run, in every native loop: numbers that are none, masses that vanish, callbacks that go wrong."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from simulation.sheets import TIGHT, arm, pendulum, torque
from tmodes.errors import InputErrors
from tmodes.kinds.signals.schedule import SignalPieces
from tmodes.robots.load import load
from tmodes.sheet import Robot
from tmodes.simulation import python_controller
from tmodes.simulation.initial_state import RunSetup, run_setup
from tmodes.simulation.parts import Trajectory
from tmodes.simulation.problem import problem_of
from tmodes.simulation.simulate import simulate_motion
from tmodes.simulation.solve import solve

METHODS = ("dormand_prince", "dop853", "rk4", "extrapolation", "midpoint", "rosenbrock")
BREAK = 0.0537


def swing(**integration: Any) -> Robot:
    settings = {"duration": 0.1, "output_step": 1e-3, "step": 1e-3, **integration}
    return pendulum({"inertia": 0.3}, {"stiffness": 100.0, "damping": 0.1}, torque(1.0),
                    initial={"state": "zero"}, integration=settings)  # fmt: skip


def run_with(setup: RunSetup, value: float) -> Trajectory:
    """The run of an arm whose torque is a value from ``BREAK`` on."""
    first = setup.planned.schedule.coefficients[0]
    pieces = SignalPieces(np.array([0.0, BREAK, 0.1]), np.stack([first, np.full_like(first, value)]))
    return solve(problem_of(setup.model, setup.model.numbers, pieces, setup.start, setup.robot.integration))


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("value", [np.nan, np.inf])
def test_a_force_that_is_no_number_ends_the_run_where_it_comes(method: str, value: float) -> None:
    """No step further: all before is as it was without, all is finite; the coordinate and the time are reported."""
    setup = run_setup(swing(method=method))
    bad, good = run_with(setup, value), run_with(setup, 1.0)
    assert bad.status == "diverged"
    assert f"at t = {BREAK:.6g} s in coordinate joint" in bad.message
    assert "no number among the signals" in bad.message or "its next step leaves" in bad.message
    assert bad.times[-1] == pytest.approx(0.053)
    assert bad.states.tobytes() == good.states[: len(bad.times)].tobytes()
    assert np.isfinite(bad.states).all()


@pytest.mark.parametrize("method", ["dormand_prince", "dop853", "rk4"])
def test_the_2010_robot_keeps_what_was_before_a_reference_that_is_no_number(method: str) -> None:
    """The same with a reference of several pieces, a controller, contact and the equations of Lagrange."""
    changes = {"integration.method": method, "integration.output_step": 1e-2}
    setup = run_setup(load("filipovic2010", changes))
    schedule = setup.planned.schedule
    knot = schedule.knots[1]
    coefficients = schedule.coefficients.copy()
    coefficients[1:] = np.nan
    settings = setup.robot.integration.model_copy(update={"duration": 2 * knot})
    run = solve(
        problem_of(setup.model, setup.model.numbers, SignalPieces(schedule.knots, coefficients), setup.start, settings)
    )
    assert run.status == "diverged"
    assert f"at t = {knot:.6g} s in coordinate " in run.message
    assert np.isfinite(run.states).all()
    assert run.times[-1] <= knot < run.times[-1] + 1.01e-2


def test_a_coordinate_without_mass_is_named_before_the_run() -> None:
    """A joint that carries nothing has no acceleration."""
    with pytest.raises(InputErrors, match="`nothing`, a link that has no mass and is moved by `slide`"):
        arm(
        joints=[{"name": "slide", "type": "prismatic", "parent": "base", "child": "nothing", "axis": [0, 0, 1]}],
        links=[{"name": "nothing"}], integration={"duration": 0.1, **TIGHT}, initial={"state": "zero"},
        drives=[{"joint": "slide", "command": "effort", "signal": {"type": "constant", "value": 1.0}}],
    )  # fmt: skip


def later(answer: Any) -> Any:
    """A controller that goes wrong after 50 ms."""

    def controller(time: float, q: Any, v: Any) -> Any:
        return [0.5] if time < BREAK else answer

    return controller


@pytest.mark.parametrize(
    ("answer", "info"),
    [([np.nan], "nan for joint joint"), ([np.inf], "inf for joint joint"), ([1.0, 2.0], r"shape \(2,\)"),
     (None, r"must return an array of shape \(1,\), the efforts of joint, got an array of shape \(\)"),
     ("text", "could not convert"), ([1j], "complex")],
)  # fmt: skip
def test_a_controller_that_goes_wrong_later(answer: Any, info: str) -> None:
    """Its name, the time and what it gave are reported; what was done is kept as it was."""
    run = simulate_motion(swing(output_step=1e-2), controller=later(answer))
    assert run.status == "stopped"
    assert "controller later.<locals>.controller at t = 0.0" in run.message
    assert np.isfinite(run.states).all()
    assert run.times[-1] == pytest.approx(0.05)
    with pytest.raises(AssertionError, match=info):
        raise AssertionError(run.message)


def test_a_slow_controller_ends_by_the_limit_on_time(monkeypatch: pytest.MonkeyPatch) -> None:
    """Each answer takes 1e6 s by the clock of the run, which ends with the step in which 5e6 s are used up."""
    answers: list[float] = []
    now = python_controller.clock.monotonic
    began = now()

    def slow(time: float, q: Any, v: Any) -> Any:
        answers.append(time)
        return [0.0]

    monkeypatch.setattr(python_controller, "clock", SimpleNamespace(monotonic=lambda: began + 1e6 * len(answers)))
    run = simulate_motion(swing(max_wall_time=5e6, output_step=0.1, method="rk4"), controller=slow)
    assert run.status == "stopped"
    assert "integration.max_wall_time = 5e+06 is used up" in run.message
    assert 5 <= len(answers) < 12
