"""Laws with efforts that are fed forward: the sampled loop of an elastic joint by SciPy, and by its inverse."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.linalg import expm, solve_discrete_are

from analysis.test_network_modes import WEIGHTS
from contracts.test_blocks import LINK, LQG, LQR, OBSERVER, SHAPED, STATES, law, matrices, spong
from tmodes.errors import TmodesError
from tmodes.kinds.signals.registry import Signal
from tmodes.simulation.simulate import simulate_motion

EXACT = {"relative_tolerance": 1e-11, "absolute_tolerance": 1e-13, "method": "dormand_prince"}
PERIOD, COUNT, TURN = 0.01, 60, 0.9
WEIGHTLESS = LINK | {"g": 0.0}
UNDAMPED = WEIGHTLESS | {"d": 0.0}
MOVE = {"type": "polynomial", "start": 0.0, "end": TURN, "duration": 0.4}
PUSH = {"type": "quintic", "start": -0.5, "end": 1.5, "duration": 0.5}
OWN = LQG | {"sample_time": PERIOD, "estimate": {}}


def trajectory(times: Any, rows: Any) -> Any:
    """Rows of value, rate, acceleration."""
    names = ("positions", "velocities", "accelerations")
    return {
        "type": "trajectory",
        "times": list(times),
        **{name: list(row) for name, row in zip(names, rows, strict=True)},
    }


def joint(block: Any, drive: Any, signal: Any = MOVE, p: Any = WEIGHTLESS, **more: Any) -> Any:
    return spong(signal, PERIOD * COUNT, PERIOD, p, control=law(block, **more), drive=drive, integration=EXACT,
                 initial={"state": "zero"})  # fmt: skip


def held(A: Any, B: Any, time: float) -> tuple[Any, Any]:
    found: Any = expm(np.block([[A, B], [np.zeros((1, 5))]]) * time)
    return found[:4, :4], found[:4, 4:]


def by_scipy(fed: Any, late: int, *, filters: bool) -> Any:
    """(samples, 4): the plant in continuous time, commands ``late`` periods late, the law by its own equations."""
    (A, B), C = matrices(WEIGHTLESS), np.array([[0.0, 1.0, 0.0, 0.0]])
    Ad, Bd = held(A, B, PERIOD)
    X: Any = solve_discrete_are(Ad, Bd, WEIGHTS, np.eye(1))
    K = np.linalg.solve(1.0 + Bd.T @ X @ Bd, Bd.T @ X @ Ad)
    W = np.diag([LQG["process_noise"][name] for name in STATES])
    P: Any = solve_discrete_are(Ad.T, C.T, W, np.array([[1e-5]]))
    M = P @ C.T / (C @ P @ C.T + 1e-5)
    wanted, given = (Signal.of(one).schedule(PERIOD * COUNT) for one in (MOVE, fed))
    end = given.at(PERIOD * COUNT)
    x, estimate, found = np.zeros(4), -TURN * np.array([1.0, 1.0, 0.0, 0.0]), []
    waiting = [float(end - given.at(0.0))] * late  # what holds the robot where it starts
    for k in range(COUNT):
        found.append(x)
        time, added = k * PERIOD, float(given.at(k * PERIOD) - end)
        after = estimate + M @ (x[1:2] - TURN - C @ estimate)
        moved = np.repeat([float(wanted.at(time)) - TURN, float(wanted.at(time, 1))], 2)
        command = float((K @ (moved - (after if filters else estimate)))[0])
        waiting.append(command)
        acts, estimate = waiting.pop(0), Ad @ after + Bd[:, 0] * (command + added)

        def rate(t: float, y: Any, acts: float = acts) -> Any:
            return A @ y + B[:, 0] * (acts + float(given.at(t) - end))

        x = solve_ivp(rate, (time, time + PERIOD), x, "DOP853", rtol=1e-12, atol=1e-14).y[:, -1]
    return np.array(found)


@pytest.mark.parametrize(("form", "late"), [("filter", 0), ("predictor", 1)])
def test_the_filter_knows_what_is_fed_forward(form: str, late: int) -> None:
    """An effort of its own kind on top, which does not end at 0: the rest is one with it."""
    robot = joint(OWN | {"form": form}, {"feed_forward": PUSH}, delay=late * PERIOD)
    run, truth = simulate_motion(robot), by_scipy(PUSH, late, filters=form == "filter")
    own = [run.coordinates.index(name) for name in ("joint", "joint.motor")]
    assert run.q[:COUNT, own] == pytest.approx(truth[:, :2], abs=1e-9)


def inverse() -> tuple[Any, Any]:
    """Motion th = q + I q''/k of the motor and effort J th'' + b th' + I q'' of a joint that moves as it shall."""
    p, times = UNDAMPED, np.linspace(0.0, 0.4, 801)
    move = Signal.of(MOVE).schedule(0.4)
    q = [move.at(times, order) for order in range(7)]
    motor = [q[order] + p["I"] * q[order + 2] / p["k"] for order in range(5)]
    effort = [p["J"] * motor[k + 2] + p["b"] * motor[k + 1] + p["I"] * q[k + 2] for k in range(3)]
    return trajectory(times, motor[:3]), trajectory(times, effort)


@pytest.mark.parametrize(
    "block",
    [
        OWN,
        OWN | {"form": "predictor"},
        OWN | {"delay_in_design": True},
        OWN | {"load_noise": 1e-6},
        OWN | {"measured": ["joint.motor.position", "joint.motor.acceleration"], "measurement_noise": [1e-5, 1.0]},
        LQR,
        SHAPED | {"sample_time": PERIOD},
    ],
)
def test_a_joint_moves_as_its_reference_says(block: Any) -> None:
    """The state that is followed is the reference's, and its effort is known: the law has nothing left to do."""
    motor, effort = inverse()
    own = block | {"reference": {"joint": MOVE}}
    late = {"delay": 1.5 * PERIOD} if "delay_in_design" in block else {}
    robot = joint(own, {"feed_forward": effort}, motor, UNDAMPED, **late)
    run = simulate_motion(robot)
    assert run.q[:, run.coordinates.index("joint")] == pytest.approx(
        Signal.of(MOVE).schedule(0.6).at(run.times), abs=1e-8
    )


def test_a_winding_is_fed_with_volts_and_its_current_is_followed() -> None:
    motor, effort = inverse()
    amperes = effort | {
        name: [value / 2 for value in effort[name]] for name in ("positions", "velocities", "accelerations")
    }
    winding = {"resistance": 1.5, "back_emf_constant": 2.0, "torque_constant": 2.0, "inductance": 0.01}
    weighted = LQR | {"state_weights": LQR["state_weights"] | {"joint.current": 1.0}}
    for reference in ({"joint": MOVE}, {"joint": MOVE, "joint.current": amperes}):
        robot = joint(weighted | {"reference": reference}, {"feed_forward": effort}, motor, UNDAMPED)
        run = simulate_motion(robot.with_({f"joints.0.motor.{name}": value for name, value in winding.items()}))
        off = run.q[:, run.coordinates.index("joint")] - Signal.of(MOVE).schedule(0.6).at(run.times)
        assert (np.abs(off).max() < 1e-7) == ("joint.current" in reference)


@pytest.mark.parametrize("sampled", [{}, {"sample_time": PERIOD}])
def test_an_observer_of_loads_takes_what_is_fed_forward_for_known(sampled: Any) -> None:
    """At its drive, as a block, by a block: nothing is left to estimate, where it took inertia for a load."""
    motor, effort = inverse()
    block, truth = OBSERVER | sampled, Signal.of(MOVE).schedule(0.6)
    fed = {"feed_forward": effort}
    added = {"type": "feed_forward", "inputs": ["law"], "signals": [effort]}
    summed = [*law(block), {"name": "sum", "drives": ["joint"], "block": added}]
    for own in ({"control": law(block), "drive": fed}, {"drive": {"controller": block} | fed}, {"control": summed}):
        run = simulate_motion(spong(motor, 0.6, PERIOD, UNDAMPED, integration=EXACT, initial={"state": "zero"}, **own))
        assert run.q[:, run.coordinates.index("joint")] == pytest.approx(truth.at(run.times), abs=1e-8)
        assert np.abs(run.controls[:, -1]).max() < 1e-6


def test_what_a_reference_names_is_there() -> None:
    with pytest.raises(TmodesError, match=r"control.law.block.reference: unknown state `elbow`"):
        simulate_motion(joint(OWN | {"reference": {"elbow": MOVE}}, {}))
