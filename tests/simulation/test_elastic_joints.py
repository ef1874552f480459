"""Arms with elastic joints against an integration of their written equations, and against reference values."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from simulation.sheets import REFERENCE, at_times, pendulum, torque, ur5
from tmodes.simulation.simulate import simulate_motion

MOTOR = {"inertia": 0.3}


def written(effort, damping=0.0, viscous=0.0, stiffness=100.0, gravity=9.8, inertia=0.3):
    """Spong's equations as a right-hand side of (q, th, q', th')."""

    def rate(t, y):
        q, th, qd, thd = y
        gear = stiffness * (th - q) + damping * (thd - qd)
        return [qd, thd, gear - gravity * np.sin(q), (effort(t, th, thd) - viscous * thd - gear) / inertia]

    return rate


def exact(rate, start, times, **more):
    return solve_ivp(rate, (0, times[-1]), start, "DOP853", times, rtol=1e-12, atol=1e-13, **more).y.T


def states(run):
    """q, th, q', th' of the run."""
    return np.column_stack([run.q[:, ::-1], run.v[:, ::-1]])


def test_free_swing():
    arm = pendulum(MOTOR, {"stiffness": 100.0}, torque(0.0), initial={"state": "zero", "coordinates": {"joint": 2.0}})
    run = simulate_motion(arm)
    assert run.status == "finished"
    assert np.abs(states(run) - exact(written(lambda *_: 0.0), [2, 2, 0, 0], run.times)).max() < 1e-9
    case, rows = REFERENCE["c01"], at_times(run, REFERENCE["c01"]["times"])
    for name, values in zip(("q", "theta", "qd", "thetad"), states(run)[rows].T, strict=True):
        assert np.abs(values - case[name]).max() < 1e-8


def test_torque_from_rest():
    motor = {**MOTOR, "friction": {"viscous": 0.2}}
    arm = pendulum(motor, {"stiffness": 100.0, "damping": 0.5}, torque(5.0), initial={"state": "zero"})
    run = simulate_motion(arm)
    assert np.abs(states(run) - exact(written(lambda *_: 5.0, 0.5, 0.2), [0] * 4, run.times)).max() < 1e-9
    case, rows = REFERENCE["c03"], at_times(run, REFERENCE["c03"]["times"])
    assert np.abs(run.q[rows, 1] - case["q"]).max() < 1e-8
    assert np.abs(run.energy_balance).max() < 1e-8 * run.energy_moved


def test_dc_motor_under_the_papers_law():
    """A voltage-driven motor, Eq. (39), under control law (41)."""
    p = REFERENCE["c07"]["params"]
    motor = {"inertia": p["Im"], "friction": {"viscous": p["B"]}, "resistance": p["R"], "back_emf_constant": p["CE"],
             "torque_constant": p["CM"]}  # fmt: skip
    wanted = {"type": "expression", "formula": "0.6*(1-cos(pi*(t+2-abs(t-2))/4))"}
    control = {"type": "pd", "position_gain": p["Klp"], "velocity_gain": p["Klv"]}
    drive = {"command": "position", "signal": wanted, "controller": control}
    arm = pendulum(motor, {"stiffness": p["C"], "damping": p["Bg"]}, drive, initial={"state": "zero"})
    run = simulate_motion(arm)
    case, rows = REFERENCE["c07"], at_times(run, REFERENCE["c07"]["times"])
    for name, values in zip(("q", "theta", "qd", "thetad"), states(run)[rows].T, strict=True):
        assert np.abs(values - case[name]).max() < 1e-8
    th, thd = run.q[:, 0], run.v[:, 0]
    assert np.allclose(run.voltage[:, 0], p["R"] * run.current[:, 0] + p["CE"] * thd, rtol=1e-12, atol=1e-12)
    assert np.allclose(run.effort[:, 0], p["CM"] * run.current[:, 0], rtol=1e-12, atol=1e-12)
    later = run.times > 2.0
    assert np.allclose(run.voltage[later, 0], p["Klp"] * (1.2 - th[later]) - p["Klv"] * thd[later], atol=1e-9)


def test_winding_with_inductance():
    """The current is a state: L i' = u - R i - CE th'."""
    motor = {**MOTOR, "resistance": 1.5, "back_emf_constant": 0.8, "torque_constant": 0.7, "inductance": 0.02}
    drive = {"command": "voltage", "signal": {"type": "sine", "amplitude": 12.0, "frequency": 0.7}}
    arm = pendulum(motor, {"stiffness": 100.0, "damping": 0.5}, drive, initial={"state": "zero"})
    run = simulate_motion(arm)

    def rate(t, y):
        voltage = 12 * np.sin(2 * np.pi * 0.7 * t)
        change = (voltage - 1.5 * y[4] - 0.8 * y[3]) / 0.02
        return [*written(lambda *_: 0.7 * y[4], 0.5)(t, y[:4]), change]

    found = exact(rate, [0] * 5, run.times)
    assert np.abs(states(run) - found[:, :4]).max() < 1e-9
    assert np.abs(run.current[:, 0] - found[:, 4]).max() < 1e-8


def test_ur5_with_elastic_gears():
    run = simulate_motion(ur5())
    case, rows = REFERENCE["g21"], at_times(run, REFERENCE["g21"]["times"])
    found = np.column_stack([run.q[rows, 6:], run.q[rows, :6], run.v[rows, 6:], run.v[rows, :6]])
    assert np.abs(found - np.array(case["y"])).max() < 1e-8
    assert np.abs(run.energy_balance).max() < 1e-8 * run.energy_moved


def test_motor_that_follows_exactly():
    """The nominal run: the motor is where it should be, and the torque that this needs is reported."""
    signal = {"type": "quintic", "start": 0.2, "end": 0.9, "duration": 0.8}
    arm = pendulum(MOTOR | {"friction": {"viscous": 0.2}}, {"stiffness": 100.0, "damping": 0.5},
                   {"command": "prescribed", "signal": signal}, initial={"state": "zero"})  # fmt: skip
    run = simulate_motion(arm)
    schedule = arm.drives[0].signal.schedule(5.0)
    th, thd, thdd = (schedule.at(run.times, k) for k in range(3))
    assert np.abs(run.q[:, 0] - th).max() < 1e-12

    def rate(t, y):
        gear = 100 * (schedule.at(t) - y[0]) + 0.5 * (schedule.at(t, 1) - y[1])
        return [y[1], gear - 9.8 * np.sin(y[0])]

    found = exact(rate, [0.2, 0], run.times, max_step=0.02)
    assert np.abs(run.q[:, 1] - found[:, 0]).max() < 1e-9
    gear = 100 * (th - run.q[:, 1]) + 0.5 * (thd - run.v[:, 1])
    assert np.allclose(run.gear_torque[:, 0], gear, atol=1e-10)
    assert np.allclose(run.effort[:, 0], 0.3 * thdd + 0.2 * thd + gear, atol=1e-9)
    assert np.abs(run.energy_balance).max() < 1e-8 * run.energy_moved


@pytest.mark.parametrize("state", ["held", "rest"])
def test_rest_is_where_springs_and_controller_hold_the_weight(state):
    """Held on its setpoint the motor gives no torque; in equilibrium it stands off it by what its torque takes."""
    control = {"type": "pd", "position_gain": 80.0, "velocity_gain": 12.0}
    wanted = {"type": "constant", "value": 1.0}
    drive = {"command": "position", "signal": wanted, "controller": control}
    run = simulate_motion(
        pendulum(MOTOR, {"stiffness": 100.0}, drive, integration={"duration": 0.1, "output_step": 0.01},
                 initial={"state": state})
    )  # fmt: skip
    off, sag = 1.0 - run.q[0, 0], run.q[0, 0] - run.q[0, 1]
    assert 100 * sag == pytest.approx(9.8 * np.sin(run.q[0, 1]), rel=1e-9)
    assert 80 * off == pytest.approx(0.0 if state == "held" else 100 * sag, rel=1e-9)
    assert run.reference is not None
    assert np.abs(run.reference.q - run.reference.q[0]).max() < 1e-9
    assert run.reference.q[0, 0] == 1.0
    moved = np.abs(run.q - run.q[0]).max()
    assert moved > 1e-3 if state == "held" else moved < 1e-12


def test_rigid_joint_under_control_and_its_reference():
    """A rigid gear: the joint is controlled itself; the nominal run prescribes it and gives its torque."""
    signal = {"type": "quintic", "start": 0.0, "end": 1.0, "duration": 1.0}
    control = {"type": "pd", "position_gain": 400.0, "velocity_gain": 30.0}
    drive = {"command": "position", "signal": signal, "controller": control}
    arm = pendulum({"inertia": 0.3, "friction": {"viscous": 0.1}}, {"stiffness": float("inf")}, drive,
                   initial={"state": "zero"}, integration={"duration": 2.0, "output_step": 0.01})  # fmt: skip
    run = simulate_motion(arm)
    assert run.coordinates == ("joint",)
    assert run.reference is not None
    schedule = arm.drives[0].signal.schedule(2.0)
    angle, rate, acceleration = (schedule.at(run.times, k) for k in range(3))
    needed = 1.3 * acceleration + 0.1 * rate + 9.8 * np.sin(angle)
    assert np.allclose(run.reference.effort[:, 0], needed, atol=1e-9)
    assert np.abs(run.reference.energy_balance).max() < 1e-7 * run.reference.energy_moved

    def moved(t, y):
        effort = 400 * (schedule.at(t) - y[0]) + 30 * (schedule.at(t, 1) - y[1])
        return [y[1], (effort - 0.1 * y[1] - 9.8 * np.sin(y[0])) / 1.3]

    assert np.abs(run.q[:, 0] - exact(moved, [0, 0], run.times, max_step=0.02)[:, 0]).max() < 1e-8
