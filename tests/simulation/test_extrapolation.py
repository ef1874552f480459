"""The integrator of stiff arms: against the explicit one along the whole path, at contact, at knots."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from simulation.sheets import arm, landing, pendulum, sunk, torque
from tmodes.simulation.simulate import simulate_motion

Integration = dict[str, Any]


def stiff(**integration: Any) -> Any:
    """A gear and a short tube that bends in both planes, driven by a motor; damped, so that fast modes are stiff."""
    beam = {
        "model": "strain", "functions": {"bend_y": 2, "bend_z": 2}, "length": 0.4, "damping_time": 3e-5,
        "section": {"bending_stiffness": 900.0, "mass_per_length": 0.8}, "rotary_inertia": "none",
    }  # fmt: skip
    return arm(
        gravity=9.81,
        joints=[{"name": "j", "type": "revolute", "child": "link", "axis": [0, 0.6, 0.8],
                 "motor": {"side": "joint", "inertia": 0.2, "friction": {"viscous": 0.1}},
                 "gear": {"stiffness": 4000.0, "damping": 0.5}}],
        links=[{"name": "link", "beam": beam, "bodies": [{"name": "load", "mass": 0.7}]}],
        drives=[{"joint": "j", "command": "position", "controller": {"type": "pd", "position_gain": 800.0,
                 "velocity_gain": 40.0}, "signal": {"type": "quintic", "start": 0.0, "end": 0.5, "duration": 0.2}}],
        integration={"duration": 0.3, "output_step": 1e-3, **integration},
    )  # fmt: skip


def test_agrees_with_explicit_steps_along_the_path() -> None:
    exact = simulate_motion(stiff(method="dormand_prince", relative_tolerance=1e-11, absolute_tolerance=1e-13))
    errors = []
    for tolerance in (1e-6, 1e-8):
        run = simulate_motion(
            stiff(method="extrapolation", relative_tolerance=tolerance, absolute_tolerance=tolerance / 100)
        )
        assert run.status == "finished"
        errors.append(np.abs(run.q - exact.q).max())
    assert errors[0] < 2e-6
    assert errors[1] < 2e-8


def test_taken_where_explicit_steps_are_dear() -> None:
    assert "extrapolation chosen" in simulate_motion(stiff(duration=6.0, output_step=0.01)).message
    soft = simulate_motion(pendulum({"inertia": 0.3}, {"stiffness": 100.0}, torque(1.0), integration={"duration": 0.5}))
    assert "dormand_prince chosen" in soft.message


@pytest.mark.parametrize("method", ["extrapolation", "dormand_prince"])
def test_contact_sets_in_where_it_does(method: str) -> None:
    """A mass flies over a gap onto a spring and damper and off again: closed form of the first push."""
    mass, stiffness, damping, speed, gap = 1.5, 2e4, 60.0, 0.8, 0.05
    sheet = arm(
        gravity=0.0,
        joints=[{"name": "s", "type": "prismatic", "child": "b", "axis": [1, 0, 0]}],
        links=[{"name": "b", "bodies": [{"name": "m", "mass": mass}]}],
        drives=[{"joint": "s", "command": "effort", "signal": {"type": "constant", "value": 0.0}}],
        initial={"state": "zero", "coordinates": {"s": -gap}, "rates": {"s": speed}},
        contact={"shape": {"type": "plane", "position": [0, 0, 0], "normal": [-1, 0, 0]}, "law": "unilateral",
                 "stiffness": stiffness, "damping": damping},
        integration={"duration": 0.2, "output_step": 0.02, "method": method, "relative_tolerance": 1e-10,
                     "absolute_tolerance": 1e-12},
    )  # fmt: skip
    run = simulate_motion(sheet)
    decay, omega = damping / (2 * mass), np.sqrt(stiffness / mass)
    ringing = np.sqrt(omega**2 - decay**2)
    # The push k x + b x' ends where tan(ringing t) = -2 decay ringing/(omega^2 - 2 decay^2), first after zero.
    end = (np.pi - np.arctan2(2 * decay * ringing, omega**2 - 2 * decay**2)) / ringing
    leaving = speed * np.exp(-decay * end) * (np.cos(ringing * end) - decay / ringing * np.sin(ringing * end))
    assert run.v[-1, 0] == pytest.approx(leaving, abs=2e-7)


@pytest.mark.parametrize(("output_step", "time"), [(0.05, 0.7), (0.1, 0.3), (0.01, 0.35), (0.02, 0.7)])
def test_knots_that_are_samples_but_for_rounding(output_step: float, time: float) -> None:
    drive = {"command": "torque", "signal": {"type": "step", "start": 0.0, "end": 4.0, "time": time}}
    integration = {"duration": 1.0, "output_step": output_step, "method": "extrapolation"}
    run = simulate_motion(pendulum({"inertia": 0.3}, {"stiffness": 100.0}, drive, integration=integration))
    assert run.status == "finished"
    assert len(run.times) == round(1.0 / output_step) + 1
    assert np.isfinite(run.q).all()


def test_a_hard_landing_takes_few_steps() -> None:
    """Spring and damper of a surface are taken at the end of a step: 2e5 1/s hold back nothing."""
    run = simulate_motion(landing(method="extrapolation"))
    assert np.abs(run.q[:, 0] - sunk(run.times)).max() < 1e-9
    assert run.statistics["steps"] < 300


def test_passes_and_evaluations_are_reported_apart() -> None:
    """Eight rows: 36 evaluations of the motion in nine passes of four lanes, whatever is rejected."""
    info = simulate_motion(stiff(method="extrapolation")).statistics
    tried = info["steps"] + info["rejected"]
    assert info["passes"] == 9 * tried
    assert info["evaluations"] == 36 * tried
