"""Laws that compute with the robot as known: against SciPy's integration, eigenvalues and exponentials."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.linalg import expm
from scipy.signal import lsim

from contracts.test_blocks import LINK, PD, Sheet, angles, constant, law, matrices, spong
from contracts.test_drive_limits import EXACT, INERTIA, public, rotor
from tmodes.simulation.simulate import simulate_motion

OBSERVER = PD | {"type": "disturbance_observer", "bandwidth": 6.0}
RATE = 2 * np.pi * OBSERVER["bandwidth"]


@pytest.mark.parametrize("period", [None, 0.004])
def test_an_observer_takes_a_constant_load(period: float | None) -> None:
    """A weight that PD holds off its setpoint is held at it, and the load is known."""
    own = OBSERVER | ({} if period is None else {"sample_time": period})
    weight = LINK["m"] * LINK["g"] * LINK["l"]
    ends = {}
    for name, block in (("pd", PD), ("observer", own)):
        ends[name] = simulate_motion(spong(constant(0.8), 20.0, 0.5, {"d": 4.0}, drive={"controller": block}))
    joint, motor = ends["pd"].q[-1, [1, 0]]
    assert PD["position_gain"] * (0.8 - motor) == pytest.approx(weight * np.sin(joint), rel=1e-6)
    joint, motor = ends["observer"].q[-1, [1, 0]]
    assert motor == pytest.approx(0.8, abs=1e-9)
    assert LINK["k"] * (motor - joint) == pytest.approx(weight * np.sin(joint), rel=1e-7)
    assert ends["observer"].controls[-1, -1] == pytest.approx(weight * np.sin(joint), rel=1e-7)


def test_an_estimate_is_the_load_through_a_low_pass() -> None:
    """Of first order, whatever the feedback does: of what the gear takes from the motor, and constant to its limit."""
    robot = spong(constant(0.8), 1.0, 5e-4, drive={"controller": OBSERVER}, integration=EXACT)
    run, result = simulate_motion(robot), public(robot).run()
    load, rate = (np.asarray(result.output(f"joint.{name}")) for name in ("gear_torque", "motor.velocity"))
    estimate = run.controls[:, -1] - RATE * LINK["J"] * rate
    _, truth, _ = lsim(([RATE], [1.0, RATE]), load, run.times)
    assert estimate == pytest.approx(truth, abs=1e-5 * np.abs(load).max())


@pytest.mark.parametrize("period", [None, 0.01])
def test_a_constant_load_is_found_at_the_rate_of_the_filter(period: float | None) -> None:
    """A rotor alone under a constant moment L: d = -L (1 - exp(-w t)), of whatever gains, sampled too."""
    own, moment, step = OBSERVER | ({} if period is None else {"sample_time": period}), 3.5, 0.01
    motor = {"friction": {"viscous": LINK["b"] if period is None else 0.0}}
    robot = rotor(40 * step, step, {"controller": own, "signal": constant(0.2)}, motor,
                  loads=[{"moment": [0, moment, 0], "frame": "world"}])  # fmt: skip
    run = simulate_motion(robot)
    rate = run.v[:, 0]
    share = RATE if period is None else (1 - np.exp(-RATE * period)) / period
    estimate = run.controls[:, -1] - share * INERTIA * rate
    truth = -moment * (1 - np.exp(-RATE * run.times))
    if period is not None:  # states after a sample are those of the next
        estimate = run.controls[:-1, -1] - share * INERTIA * rate[1:]
        truth = truth[1:]
    assert estimate == pytest.approx(truth, abs=1e-7)


def test_poles_of_an_observer() -> None:
    """About the hanging link: eigenvalues of the closed loop of joint, motor, rates and estimate."""
    p, own = LINK, OBSERVER
    a, b = matrices(p)
    a[2, 0] -= p["m"] * p["g"] * p["l"] / p["I"]
    loop = np.zeros((5, 5))
    row = np.array([0.0, -own["position_gain"], 0.0, -own["velocity_gain"] - RATE * p["J"], 1.0])
    loop[:4, :4], loop[:4] = a, np.column_stack([a, np.zeros(4)]) + b @ row[None]
    loop[4] = RATE * (row + np.array([0.0, 0.0, 0.0, RATE * p["J"] - p["b"], -1.0]))
    robot = spong(constant(0.0), 1.0, 0.1, drive={"controller": own})
    found = public(robot).linearize(closed=True, inputs="joint.setpoint", outputs="joint.position").poles
    assert np.sort_complex(found) == pytest.approx(np.sort_complex(np.linalg.eigvals(loop)), rel=1e-8)


def test_a_sampled_observer_behind_a_block() -> None:
    """It adds to the signal of a block; by the exponential of the matrices."""
    p, period, n = LINK | {"g": 0.0}, 0.01, 80
    own: Sheet = {"type": "disturbance_observer", "bandwidth": 6.0, "sample_time": period, "input": "raw"}
    control = [{"name": "raw", "of": "joint", "block": PD, "sample_time": period}, *law(own)]
    whole: Any = expm(np.block([[*matrices(p)], [np.zeros((1, 5))]]) * period)
    share = 1 - np.exp(-RATE * period)
    x, z, found = np.zeros(4), 0.0, [np.zeros(2)]
    for _ in range(n):
        load = z - share / period * p["J"] * x[3]
        push = PD["position_gain"] * (0.4 - x[1]) - PD["velocity_gain"] * x[3] + load
        z = (1 - share) * load + share * (push - p["b"] * x[3]) + share / period * p["J"] * x[3]
        x = (whole @ np.append(x, push))[:4]
        found.append(x[:2])
    times = period * np.arange(n + 1)
    robot = spong(constant(0.4), period * n, period, p, control=control)
    assert angles(robot, times) == pytest.approx(np.array(found), abs=1e-8)


def test_an_effort_of_a_motor_with_a_resistance() -> None:
    """What computes with the robot commands torques, the same as of a motor without one."""
    own = {"controller": {"type": "gravity_pd", "position_gain": 70.0, "velocity_gain": 6.0}}
    plain = spong(constant(0.9), 2.0, 0.01, drive=own)
    motor = {"joints.joint.motor.resistance": 0.4, "joints.joint.motor.back_emf_constant": 0.7,
             "joints.joint.motor.torque_constant": 0.6}  # fmt: skip
    electric = plain.with_(motor)
    first, second = simulate_motion(plain), simulate_motion(electric)
    assert second.q == pytest.approx(first.q, abs=1e-12)
    result = public(electric).run()
    torque, rate, volts = (
        np.asarray(result.output(f"joint.{name}")) for name in ("effort", "motor.velocity", "voltage")
    )
    assert volts == pytest.approx(0.4 / 0.6 * torque + 0.7 * rate, abs=1e-9)
    limited = public(electric.with_({"drives.0.saturation": {"voltage": 12.0}})).run()
    assert np.abs(np.asarray(limited.output("joint.voltage"))).max() == pytest.approx(12.0, abs=1e-9)
