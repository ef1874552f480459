"""Closed forms of what a drive and its sensors do to a law: saturation, anti-windup, delay, steps of an encoder."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.linalg import expm

from contracts.test_blocks import PD, Sheet, constant
from simulation.sheets import arm
from tmodes import Robot
from tmodes.simulation.simulate import simulate_motion

EXACT = {"relative_tolerance": 1e-10, "absolute_tolerance": 1e-11, "method": "dormand_prince"}
INERTIA, TORQUE, GOAL = 0.21, 12.0, 1.0
PUSH = TORQUE / INERTIA
KP, KI, KV, TRACKING = 60.0, 80.0, 9.0, 0.05


def rotor(until: float, step: float, drive: Sheet, motor: Sheet | None = None, **more: Any) -> Any:
    """A motor alone, with next to nothing on its axis."""
    body = {"name": "bob", "mass": 1e-9, "center": [0, 0, -0.1], "inertia": {"xx": 1e-12, "yy": 1e-12, "zz": 1e-12}}
    own = {"inertia": INERTIA, "side": "joint"} | (motor or {})
    joint = {"name": "joint", "type": "revolute", "child": "link", "axis": [0, 1, 0], "motor": own}
    drive = {"joint": "joint", "command": "position", "signal": constant(GOAL)} | drive
    return arm(joints=[joint], links=[{"name": "link", "bodies": [body]}], drives=[drive],
               tip={"link": "link", "position": [0, 0, -0.1]},
               integration={"duration": until, "output_step": step, **EXACT},
               **{"initial": {"state": "zero", "coordinates": {"joint": 0.0}}} | more)  # fmt: skip


def public(robot: Any) -> Robot:
    """The robot with the methods that users call."""
    return Robot.from_data(robot.model_dump(mode="json", by_alias=True, exclude_none=True))


def test_a_torque_limit_is_a_parabola_and_then_the_linear_loop() -> None:
    """Kp (A - th) - Kv th' = T ends the parabola T t^2/(2 J); then poles of the loop, by the exponential."""
    run = simulate_motion(rotor(0.6, 1e-3, {"controller": PD, "saturation": {"torque": TORQUE}}))
    leaves = np.roots([KP * PUSH / 2, KV * PUSH, TORQUE - KP * GOAL]).max()
    loop = np.array([[0.0, 1.0], [-KP / INERTIA, -KV / INERTIA]])
    start = np.array([PUSH * leaves**2 / 2 - GOAL, PUSH * leaves])
    truth = [PUSH * t**2 / 2 if t < leaves else GOAL + (expm(loop * (t - leaves)) @ start)[0] for t in run.times]
    assert 0.07 < leaves < 0.08
    assert run.q[:, 0] == pytest.approx(np.array(truth), abs=1e-8)


def test_a_voltage_limit_is_a_first_order_run_up() -> None:
    """th' = U/CE (1 - exp(-t/T)), T = J R/(CM CE); and the current is what the voltage leaves."""
    motor = {"resistance": 0.4, "back_emf_constant": 0.7, "torque_constant": 0.6}
    drive = {"controller": PD, "signal": constant(50.0), "saturation": {"voltage": 24.0}}
    result = public(rotor(0.3, 1e-3, drive, motor)).run()
    rate, current = (np.asarray(result.output(f"joint.{name}")) for name in ("velocity", "current"))
    times = np.asarray(result.data["time"])
    truth = 24.0 / 0.7 * (1 - np.exp(-times * 0.6 * 0.7 / (INERTIA * 0.4)))
    assert rate == pytest.approx(truth, abs=1e-8)
    assert current == pytest.approx((24.0 - 0.7 * truth) / 0.4, abs=1e-7)


def _integral(kind: str, t: NDArray[np.float64]) -> NDArray[np.float64]:
    """Of the error, while the torque is at its limit."""
    if kind == "clamp":
        return np.zeros_like(t)
    if kind == "none":
        return GOAL * t - PUSH * t**3 / 6
    # z' = e + (T - Kp e + Kv th' - Ki z)/(Ki Tt): a line of first order under a parabola
    gain = KI * TRACKING
    error = np.array([GOAL, 0.0, -PUSH / 2])
    forced = error + (np.array([TORQUE, KV * PUSH, 0.0]) - KP * error) / gain
    c = TRACKING * forced[2]
    b = TRACKING * (forced[1] - 2 * c)
    a = TRACKING * (forced[0] - b)
    return a + b * t + c * t**2 - a * np.exp(-t / TRACKING)


@pytest.mark.parametrize("kind", ["clamp", "none", "back_calculation"])
def test_the_integral_at_a_limit(kind: str) -> None:
    """It stops, it winds up, or it follows what is cut off."""
    own: Sheet = PD | {"type": "pid", "integral_gain": KI, "anti_windup": kind}
    own |= {"tracking_time": TRACKING} if kind == "back_calculation" else {}
    run = simulate_motion(rotor(0.05, 1e-3, {"controller": own, "saturation": {"torque": TORQUE}}))
    assert run.q[:, 0] == pytest.approx(PUSH * run.times**2 / 2, abs=1e-9)
    assert run.controls[:, 0] == pytest.approx(_integral(kind, run.times), abs=1e-9)


def test_overshoot_with_and_without_anti_windup() -> None:
    """The area that winds up is paid back beyond the goal."""
    past = {}
    for kind in ("clamp", "none"):
        own = PD | {"type": "pid", "integral_gain": 300.0, "anti_windup": kind}
        run = simulate_motion(rotor(2.0, 5e-3, {"controller": own, "saturation": {"torque": 1.5}}))
        past[kind] = run.q[:, 0].max() - GOAL
    assert past["none"] > 2 * past["clamp"]


def test_a_delayed_command_is_a_delayed_parabola() -> None:
    """Nothing moves for 2.5 samples; the next two commands are the first again, for nothing had moved at them."""
    period = 0.01
    run = simulate_motion(rotor(5.5 * period, period / 2, {"controller": PD, "sample_time": period,
                                                           "delay": 2.5 * period}))  # fmt: skip
    truth = KP * GOAL / INERTIA * np.maximum(run.times - 2.5 * period, 0) ** 2 / 2
    assert run.q[:, 0] == pytest.approx(truth, abs=1e-10)


def test_steps_of_an_encoder() -> None:
    """Of a motion a t + b: steps where that is half a step on, held between samples; their variance is D^2/12."""
    step, period, speed = 2e-3, 1e-3, 0.7331
    ramp = {"type": "table", "times": [0.0, 3.0], "values": [0.0, 3 * speed], "interpolation": "linear"}
    teeth = {"type": "encoder", "name": "teeth", "joint": "joint", "resolution": step, "sample_time": period}
    robot = public(rotor(2.0, period / 2, {"command": "prescribed", "signal": ramp}, sensors=[teeth],
                         initial={"state": "rest"}))  # fmt: skip
    found = np.asarray(robot.run().output("teeth"))[:-1]
    times = period / 2 * np.arange(len(found))
    samples = speed * period * np.floor(times / period + 1e-9)
    assert found == pytest.approx(step * np.floor(samples / step + 0.5), abs=1e-12)
    assert np.var((found - samples)[::2]) == pytest.approx(step**2 / 12, rel=0.01)
