"""A Python function as the controller: the same motion as the built-in law, and every fault of it told."""

from __future__ import annotations

import numpy as np
import pytest

from arm.run.sheets import pendulum
from tmodes.errors import SimulationError
from tmodes.motion.simulate import simulate_arm

SIGNAL = {"type": "quintic", "start": 0.0, "end": 0.5, "duration": 0.3}
DRIVE = {"command": "position", "signal": SIGNAL,
         "controller": {"type": "pd", "position_gain": 80.0, "velocity_gain": 12.0}}  # fmt: skip


def sheet(**integration):
    settings = {"duration": 0.5, "output_step": 0.01, **integration}
    return pendulum({"inertia": 0.3}, {"stiffness": 100.0, "damping": 0.5}, DRIVE, initial={"state": "zero"},
                    integration=settings)  # fmt: skip


def law(time, q, v):
    schedule = sheet().drives[0].signal.schedule(0.5)
    return [80 * (schedule.at(time) - q[0]) + 12 * (schedule.at(time, 1) - v[0])]


@pytest.mark.parametrize(
    ("settings", "error"),
    [({"method": "rk4", "step": 1e-3}, 1e-8), ({"relative_tolerance": 1e-9, "absolute_tolerance": 1e-11}, 1e-9)],
)
def test_same_motion_as_the_built_in_law(settings, error):
    arm = sheet(**settings)
    native, called = simulate_arm(arm), simulate_arm(arm, controller=law)
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
    ("controller", "told"),
    [
        (changes_the_state, "read-only"),
        (lambda time, q, v: [0.0, 0.0], r"shape \(2,\)"),
        (lambda time, q, v: [float("nan")], "nan for joint joint"),
        (lambda time, q, v: "text", "ValueError"),
    ],
)
def test_faults_at_the_first_call(controller, told):
    with pytest.raises(SimulationError, match=told):
        simulate_arm(sheet(), controller=controller)


def test_a_fault_later_keeps_what_was_done():
    run = simulate_arm(sheet(), controller=raises)
    assert run.status == "stopped"
    assert "raises" in run.message
    assert "by nothing" in run.message
    assert 5 <= len(run.times) <= 12
    assert np.isfinite(run.q).all()


def test_a_run_that_diverges():
    run = simulate_arm(sheet(method="rk4", step=1e-3), controller=lambda time, q, v: [1e6 * v[0] + 1.0])
    assert run.status == "diverged"
    assert np.isfinite(run.q).all()


def test_time_limit():
    run = simulate_arm(sheet(method="rk4", step=1e-4, max_wall_time=0.01), controller=law)
    assert run.status == "stopped"
    assert "max_wall_time" in run.message
