"""Laws that compute with the robot as known: against SciPy's integration, eigenvalues and exponentials."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.integrate import cumulative_simpson, solve_ivp
from scipy.linalg import expm
from scipy.signal import lsim

from contracts.test_blocks import LINK, PD, Sheet, angles, constant, law, matrices, spong
from contracts.test_drive_limits import EXACT, INERTIA, public, rotor
from simulation.sheets import arm
from tmodes.simulation.simulate import simulate_motion

Array = NDArray[np.float64]
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


PASSIVE = {"type": "passivity_based", "damping": 6.0, "position_gain": 120.0, "velocity_gain": 25.0}
COMPOSITE = {"type": "singular_perturbation", "position_gain": 36.0, "velocity_gain": 12.0, "fast_damping": 0.6}
FREE = LINK | {"d": 0.0}
SWING = {"type": "sine", "amplitude": 0.8, "frequency": 0.5}


def swing(t: float) -> list[float]:
    """The setpoint and its four derivatives."""
    w = np.pi
    return [0.8 * w**k * np.sin(w * t + k * np.pi / 2) for k in range(5)]


def passive_effort(t: float, x: Array, p: Sheet) -> float:
    """Of one link, its derivatives by hand."""
    (q, th, v, w), r, weight = x, swing(t), p["m"] * p["g"] * p["l"]
    gain, damp = PASSIVE["position_gain"], PASSIVE["damping"]
    a = (p["k"] * (th - q) - weight * np.sin(q)) / p["I"]
    jerk = (p["k"] * (w - v) - weight * np.cos(q) * v) / p["I"]
    n = p["I"] * (r[2] - damp * (v - r[1])) + weight * np.sin(q)
    rate = p["I"] * (r[3] - damp * (a - r[2])) + weight * np.cos(q) * v
    second = p["I"] * (r[4] - damp * (jerk - r[3])) + weight * (np.cos(q) * a - np.sin(q) * v**2)
    far, moves = th - r[0] - n / p["k"], w - r[1] - rate / p["k"]
    turn = r[2] + second / p["k"] - gain * far - PASSIVE["velocity_gain"] * moves
    return float(p["J"] * turn + p["b"] * w + n)


def composite_effort(t: float, x: Array, p: Sheet) -> float:
    """Of one link."""
    (q, _, v, w), r = x, swing(t)
    a = r[2] + COMPOSITE["velocity_gain"] * (r[1] - v) + COMPOSITE["position_gain"] * (r[0] - q)
    fast = 2 * COMPOSITE["fast_damping"] * np.sqrt(p["k"] * p["J"])
    return float((p["I"] + p["J"]) * a + p["m"] * p["g"] * p["l"] * np.sin(q) + p["b"] * v + fast * (v - w))


def integrated(effort: Any, times: Array, p: Sheet) -> Array:
    """Angles (times, 2) of link and motor from rest at 0, by DOP853."""

    def rates(t: float, x: Array) -> list[float]:
        q, th, v, w = x
        wound = p["k"] * (th - q)
        a = (wound - p["m"] * p["g"] * p["l"] * np.sin(q)) / p["I"]
        return [v, w, a, (effort(t, x, p) - wound - p["b"] * w) / p["J"]]

    found = solve_ivp(rates, (0.0, times[-1]), [0.0] * 4, "DOP853", times, rtol=1e-12, atol=1e-13)
    return found.y[:2].T


@pytest.mark.parametrize(("block", "effort"), [(PASSIVE, passive_effort), (COMPOSITE, composite_effort)])
def test_a_law_of_elastic_joints_as_scipy_integrates_it(block: Sheet, effort: Any) -> None:
    """From rest on a moving setpoint."""
    times: Array = 0.05 * np.arange(41, dtype=np.float64)
    robot = spong(SWING, 2.0, 0.05, FREE, control=law(block), integration=EXACT)
    assert angles(robot, times) == pytest.approx(integrated(effort, times, FREE), abs=3e-8)


def elastic_arm(start: Sheet, signals: Any = None, **more: Any) -> Any:
    """Two links in the vertical plane behind elastic gears without damping, under the passivity-based law."""
    signals = signals or [{"type": "sine", "amplitude": a, "frequency": f} for a, f in ((0.7, 0.4), (-0.9, 0.6))]
    gears = [{"stiffness": k, "damping": 0.0} for k in (300.0, 140.0)]
    joints = [{"name": f"j{k}", "type": "revolute", "child": f"l{k}", "axis": [0, 0, 1], "gear": gears[k],
               "motor": {"inertia": (0.3, 0.12)[k], "side": "joint", "friction": {"viscous": 0.2}},
               **({"parent": "l0", "origin": {"position": [0.48, 0, 0]}} if k else {})} for k in range(2)]  # fmt: skip
    bodies = [{"name": "own", "mass": m, "center": [c, 0, 0], "inertia": {"xx": 1e-6, "yy": i, "zz": i}}
              for m, c, i in SIZES]  # fmt: skip
    drives = [{"joint": f"j{k}", "command": "position", "signal": one} for k, one in enumerate(signals)]
    return arm(gravity=[0, -9.81, 0], joints=joints, drives=drives, tip={"link": "l1", "position": [0.41, 0, 0]},
               links=[{"name": f"l{k}", "bodies": [one]} for k, one in enumerate(bodies)],
               control=[{"name": "law", "drives": ["j0", "j1"], "block": PASSIVE}],
               initial={"state": "zero", "coordinates": start},
               integration={"duration": 2.0, "output_step": 2e-3, **EXACT}, **more)  # fmt: skip


SIZES = ((4.2, 0.22, 0.085), (2.6, 0.18, 0.041))
"""Mass, place of its centre, inertia of two links; the first is 0.48 m long."""


@pytest.mark.nightly
def test_stored_energy_falls_by_what_dampers_take() -> None:
    """Of the robot about its motion: links, rotors, gears, springs of the motors; V' = -D e' M e' - h' J Kv h'."""
    robot = elastic_arm({"j0": 0.6, "j1": -0.5, "j0.motor": 0.3, "j1.motor": 0.1})
    run = simulate_motion(robot)
    names = list(robot.chain().coordinates)
    place = [names.index(name) for name in ("j0", "j1", "j0.motor", "j1.motor")]
    q, th, v, w = run.q[:, place[:2]], run.q[:, place[2:]], run.v[:, place[:2]], run.v[:, place[2:]]
    turn = np.array([[0.7, 0.4], [-0.9, 0.6]])
    r = [np.stack([a * (2 * np.pi * f) ** k * np.sin(2 * np.pi * f * run.times + k * np.pi / 2) for a, f in turn], 1)
         for k in range(4)]  # fmt: skip
    stored, lost = [], []
    for k in range(len(run.times)):
        one = _energies(q[k], th[k], v[k], w[k], [each[k] for each in r])
        stored.append(one[0])
        lost.append(one[1])
    stored, taken = np.array(stored), cumulative_simpson(np.array(lost), x=run.times, initial=0)
    assert stored[0] > 10.0
    assert np.diff(stored).max() < 1e-9 * stored[0]
    assert stored + taken == pytest.approx(np.full_like(stored, stored[0]), rel=2e-5)
    assert stored[-1] < 1e-3 * stored[0]


def _energies(q: Array, th: Array, v: Array, w: Array, r: list[Array]) -> tuple[float, float]:
    """V and -V' of two links by hand."""
    (m1, c1, i1), (m2, c2, i2), span = *SIZES, 0.48
    k, inertia, cross = np.array([300.0, 140.0]), np.array([0.3, 0.12]), m2 * span * c2

    def mass(at: Array) -> Array:
        c = np.cos(at[1])
        off = i2 + m2 * c2**2 + cross * c
        return np.array([[i1 + m1 * c1**2 + i2 + m2 * (span**2 + c2**2) + 2 * cross * c, off], [off, i2 + m2 * c2**2]])

    s, ds = -cross * np.sin(q[1]), -cross * np.cos(q[1]) * v[1]
    coriolis = np.array([[s * v[1], s * (v[0] + v[1])], [-s * v[0], 0.0]])
    first, second = 9.81 * (m1 * c1 + m2 * span), 9.81 * m2 * c2
    weight = np.array([first * np.cos(q[0]) + second * np.cos(q.sum()), second * np.cos(q.sum())])
    slope = -second * np.sin(q.sum()) * v.sum() - np.array([first * np.sin(q[0]) * v[0], 0.0])
    a = np.linalg.solve(mass(q), k * (th - q) - coriolis @ v - weight)
    changed = np.array([[2 * s * v[1], s * v[1]], [s * v[1], 0.0]])
    turned = np.array([[ds * v[1] + s * a[1], ds * v.sum() + s * a.sum()], [-ds * v[0] - s * a[0], 0.0]])
    e, push, jerk = v - r[1], r[2] - PASSIVE["damping"] * (v - r[1]), r[3] - PASSIVE["damping"] * (a - r[2])
    n = mass(q) @ push + coriolis @ r[1] + weight
    rate = changed @ push + mass(q) @ jerk + turned @ r[1] + coriolis @ r[2] + slope
    h, moves = th - r[0] - n / k, w - r[1] - rate / k
    wound = h - q + r[0]
    stored = e @ mass(q) @ e + moves @ (inertia * moves) + wound @ (k * wound)
    stored += h @ (inertia * PASSIVE["position_gain"] * h)
    return stored / 2, PASSIVE["damping"] * e @ mass(q) @ e + PASSIVE["velocity_gain"] * moves @ (inertia * moves)


def test_a_composite_law_tends_to_the_rigid_loop() -> None:
    """As 1/sqrt(k), the rate of the gears; of the rigid loop e'' + Kv e' + Kp e = 0, where e begins at -r'."""
    times = 0.02 * np.arange(1, 101)
    rigid = np.array([swing(t)[0] for t in times])
    start, loop = np.array([0.0, -swing(0.0)[1]]), np.array([[0.0, 1.0], [-36.0, -12.0]])
    rigid += np.array([(expm(loop * t) @ start)[0] for t in times])
    far = []
    for stiffness in (4e3, 16e3, 64e3):
        robot = spong(SWING, 2.0, 0.02, FREE | {"k": stiffness}, control=law(COMPOSITE), integration=EXACT)
        far.append(np.abs(angles(robot, times)[:, 0] - rigid).max())
    assert far[0] / far[1] == pytest.approx(2.0, rel=0.15)
    assert far[1] / far[2] == pytest.approx(2.0, rel=0.08)
    assert far[2] < 0.02


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
