"""Which motions jump: none that begins and ends at rest, however long or far it is; a ramp does."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from simulation.sheets import pendulum
from tmodes.simulation.initial_state import RunSetup, run_setup
from tmodes.simulation.plan import planned
from tmodes.simulation.simulate import simulate_motion
from tmodes.simulation.warnings import jumps

RIGID = {"stiffness": float("inf")}
MOTOR = {"inertia": 0.3}
CONTROL = {"type": "pd", "position_gain": 80.0, "velocity_gain": 12.0}


@pytest.fixture(scope="module")
def setup() -> RunSetup:
    return run_setup(prescribed({"type": "constant", "value": 0.0}, 1.0))


def prescribed(signal: dict[str, Any], duration: float) -> Any:
    """An arm of one rigid joint that follows a signal exactly."""
    drive = {"command": "prescribed", "signal": signal}
    return pendulum(MOTOR, RIGID, drive, initial={"state": "zero"}, integration={
        "duration": duration, "output_step": duration / 10,
    })  # fmt: skip


def info(setup: RunSetup, signal: dict[str, Any], duration: float) -> str:
    return jumps(replace(setup, planned=planned(prescribed(signal, duration))))


def test_a_move_from_rest_to_rest_never_jumps(setup: RunSetup) -> None:
    """Its rate is 0 at both knots but for rounding: of many durations, delays, amplitudes, and places to start from."""
    generator = np.random.default_rng(5)
    for duration, amplitude, share, start in zip(
        [0.09, 0.1, 0.2, 0.25, *10 ** generator.uniform(-3, 2, 300)],
        10 ** generator.uniform(-9, 3, 304),
        generator.choice([0.0, 0.3, 40.0], 304),
        generator.choice([0.0, 0.7, -1e3], 304),
        strict=True,
    ):
        move = {"type": "quintic", "start": start, "end": start + amplitude, "duration": duration}
        delay = share * duration
        assert info(setup, {**move, "delay": delay}, delay + 1.5 * duration) == "", (duration, amplitude, delay, start)


@pytest.mark.parametrize("formula", ["0.1", "0.1 + 1e-9*sin(t)", "3*sin(2*pi*t)", "1000 + sin(50*t)"])
def test_rounding_of_a_fitted_formula_is_no_jump(setup: RunSetup, formula: str) -> None:
    assert info(setup, {"type": "expression", "formula": formula}, 1.0) == ""


@pytest.mark.parametrize("duration", [1e-3, 0.1, 100.0])
@pytest.mark.parametrize("rise", [1e-9, 0.5, 1e3])
def test_a_ramp_jumps_in_rate(setup: RunSetup, duration: float, rise: float) -> None:
    times = [0.0, 0.4 * duration, duration]
    ramp = {"type": "table", "interpolation": "linear", "times": times, "values": [0.0, 0.0, rise]}
    assert info(setup, ramp, 2 * duration) == f"the motion of joint joint jumps in rate at t = {times[1]:.6g} s"


def test_a_small_kink_of_a_formula_is_a_jump_in_rate(setup: RunSetup) -> None:
    """A millionth of the position, which is not small against what moves."""
    found = info(setup, {"type": "expression", "formula": "1 + 1e-6*abs(t - 0.3)"}, 1.0)
    assert "jumps in rate" in found
    assert float(found.split()[-2]) == pytest.approx(0.3, abs=1e-4)  # the fit nears the kink by halves


@pytest.mark.parametrize("duration", [0.09, 0.1, 0.2])
def test_a_smooth_move_keeps_its_reference_run(duration: float) -> None:
    """Durations whose last rate is not exactly 0 in floating-point numbers."""
    move = {"type": "quintic", "start": 0.0, "end": 0.5, "duration": duration}
    drive = {"command": "position", "signal": move, "controller": CONTROL}
    run = simulate_motion(pendulum(MOTOR, RIGID, drive, integration={"duration": 0.3, "output_step": 0.01}))
    assert run.reference is not None
    assert not [warning for warning in run.warnings if "jump" in warning]
