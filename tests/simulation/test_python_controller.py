"""A Python function as the controller: the same motion as the built-in law, and every fault of it reported."""

from __future__ import annotations

import numpy as np
import pytest

from simulation.sheets import pendulum
from tmodes.errors import SimulationError
from tmodes.simulation.simulate import simulate_motion

SIGNAL = {"type": "quintic", "start": 0.0, "end": 0.5, "duration": 0.3}
DRIVE = {"command": "position", "signal": SIGNAL,
         "controller": {"type": "pd", "position_gain": 80.0, "velocity_gain": 12.0}}  # fmt: skip


def sheet(initial=None, **integration):
    settings = {"duration": 0.5, "output_step": 0.01, **integration}
    return pendulum({"inertia": 0.3}, {"stiffness": 100.0, "damping": 0.5}, DRIVE, initial=initial or {"state": "zero"},
                    integration=settings)  # fmt: skip


WANTED = sheet().drives[0].signal.schedule(0.5)


def law(time, q, v):
    return [80 * (WANTED.at(time) - q[0]) + 12 * (WANTED.at(time, 1) - v[0])]


@pytest.mark.parametrize(
    ("settings", "error"),
    [
        ({"method": "rk4", "step": 1e-3}, 1e-8),
        ({"method": "dormand_prince", "relative_tolerance": 1e-9, "absolute_tolerance": 1e-11}, 1e-9),
        ({}, 1e-6),
    ],
)
def test_same_motion_as_the_built_in_law(settings, error):
    arm = sheet(**settings)
    native, called = simulate_motion(arm), simulate_motion(arm, controller=law)
    assert called.status == "finished"
    assert np.abs(called.q - native.q).max() < error
    assert np.abs(called.effort - native.effort).max() < 100 * error
    assert np.abs(called.a - native.a).max() < 1000 * error
    assert np.abs(called.energy_balance).max() < 1e-6 * called.energy_moved


def raises(time, q, v):
    if time > 0.1:
        raise ZeroDivisionError("by nothing")
    return [0.0]


def changes_the_state(time, q, v):
    q[0] = 1.0
    return [0.0]


@pytest.mark.parametrize(
    ("controller", "info"),
    [
        (changes_the_state, "read-only"),
        (lambda time, q, v: [0.0, 0.0], r"shape \(2,\)"),
        (lambda time, q, v: [float("nan")], "nan for joint joint"),
        (lambda time, q, v: "text", "ValueError"),
    ],
)
def test_faults_at_the_first_call(controller, info):
    with pytest.raises(SimulationError, match=info):
        simulate_motion(sheet(), controller=controller)


def test_a_fault_later_keeps_what_was_done():
    run = simulate_motion(sheet(), controller=raises)
    assert run.status == "stopped"
    assert "raises" in run.message
    assert "by nothing" in run.message
    assert 5 <= len(run.times) <= 12
    assert np.isfinite(run.q).all()


def test_a_run_that_diverges():
    run = simulate_motion(sheet(method="rk4", step=1e-3), controller=lambda time, q, v: [1e6 * v[0] + 1.0])
    assert run.status == "diverged"
    assert np.isfinite(run.q).all()


def test_time_limit():
    run = simulate_motion(sheet(method="rk4", step=1e-4, max_wall_time=0.01), controller=law)
    assert run.status == "stopped"
    assert "max_wall_time" in run.message


def test_steps_that_fail_end_the_run():
    """An effort of 1e308 N*m after 0.12 s: no step across is small enough; what was done before is kept as it was."""
    run = simulate_motion(sheet(method="dormand_prince"), controller=lambda time, q, v: [1e308 if time > 0.12 else 1.0])
    free = simulate_motion(sheet(method="dormand_prince"), controller=lambda time, q, v: [1.0])
    assert run.status == "stopped"
    assert "no step is small enough" in run.message
    assert run.times[-1] == pytest.approx(0.12)
    assert np.array_equal(run.q, free.q[: len(run.times)])


def test_no_acceleration_from_the_start():
    """No length of a first step can be found; the run ends at once."""
    moving = {"state": "zero", "rates": {"joint": 1.0}}
    run = simulate_motion(sheet(moving, method="dormand_prince"), controller=lambda time, q, v: [1e308])
    assert run.status == "stopped"
    assert len(run.times) == 1


def chatters(time, q, v):
    """A bang-bang law with a steep switching line, on which an adaptive step shrinks to nearly nothing."""
    return [50.0 * np.sign(0.1 - q[0] - 0.2 * v[0])]


@pytest.mark.parametrize("limit", [{"max_steps": 60}, {"max_wall_time": 0.05}])
def test_limits_hold_within_an_interval(limit):
    """One sample, at 0.5 s, is not reached; what is left is the start."""
    run = simulate_motion(sheet(output_step=0.5, method="dormand_prince", **limit), controller=chatters)
    assert run.status == "stopped"
    assert f"integration.{next(iter(limit))} = " in run.message
    assert "is used up; raise it" in run.message
    assert run.statistics["steps"] <= limit.get("max_steps", np.inf)
    assert run.times.tolist() == [0.0]


def test_all_steps_may_be_used():
    """500 steps of 1 ms reach the end; 17 of at most 0.6 ms for each sample are 850, more than 834."""
    assert simulate_motion(sheet(method="rk4", step=1e-3, max_steps=500), controller=law).status == "finished"
    stopped = simulate_motion(sheet(method="rk4", step=6e-4, max_steps=834), controller=law)
    assert stopped.status == "stopped"
    assert "max_steps" in stopped.message
    assert len(stopped.times) == 1 + 834 // 17


@pytest.mark.parametrize(("method", "status"), [("auto", "finished"), ("dormand_prince", "stopped")])
def test_noise_cannot_hang_a_run(method, status):
    """Fixed steps pass through it; those of an adaptive method collapse, which ends the run with the reason."""
    generator = np.random.default_rng(1)
    run = simulate_motion(sheet(method=method), controller=lambda time, q, v: [0.1 * generator.normal()])
    assert run.status == status
    assert ("fixed steps of 0.0" if status == "finished" else "is not smooth (noise") in run.message
