"""Given motions whose rates jump: what moves freely behind them keeps its momentum, and the books count the work."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from simulation.sheets import arm
from tmodes.errors import InputError
from tmodes.gradients.gradient import forward_sensitivities
from tmodes.kinds.signals.registry import Signal
from tmodes.sheet import Robot
from tmodes.simulation.initial_state import run_setup
from tmodes.simulation.motion_run import RunData
from tmodes.simulation.simulate import simulate_motion
from tmodes.simulation.vary.simulate import simulate_batch
from tmodes.simulation.warnings import start_warnings

INERTIA, COUPLED = 0.1, 0.12  # of the link about its joint; mass * center * distance of the joints


def ramps(*values: float, end: float = 0.5) -> dict[str, Any]:
    """Lines from value to value, in equal times."""
    times = np.linspace(0.0, end, len(values)).tolist()
    return {"type": "table", "times": times, "values": list(values), "interpolation": "linear"}


def hinged(signal: dict[str, Any], **more: Any) -> Robot:
    """A link that turns freely on a hub whose motion is given, both about z."""
    joints = [
        {"name": "h", "type": "revolute", "child": "hub", "axis": [0, 0, 1]},
        {"name": "p", "type": "revolute", "child": "l", "axis": [0, 0, 1], "state": "free",
         "origin": {"position": [0.4, 0, 0]}},
    ]  # fmt: skip
    bodies = [{"name": "b", "mass": 1.0, "center": [x, 0, 0], "inertia": 0.01} for x in (0.0, 0.3)]
    links = [{"name": name, "bodies": [body]} for name, body in zip(("hub", "l"), bodies, strict=True)]
    return arm(**{
        "gravity": 0.0, "joints": joints, "links": links, "tip": {"link": "l", "position": [0.5, 0, 0]},
        "drives": [{"joint": "h", "command": "prescribed", "signal": signal}], "initial": {"state": "zero"},
        "integration": {"duration": 0.5, "output_step": 0.01, "error_estimate": False, "model_error": False}, **more,
    })  # fmt: skip


def apart(times: np.ndarray, signal: dict[str, Any]) -> np.ndarray:
    """The same with another solver, piece by piece: (angle, rate after a jump) of the link at each time."""
    knots, values = signal["times"], signal["values"]
    rates = np.diff(values) / np.diff(knots)
    state, before, found = np.zeros(2), 0.0, np.zeros((len(times), 2))
    for start, end, rate in zip(knots[:-1], knots[1:], rates, strict=True):
        state[1] -= (INERTIA + COUPLED * np.cos(state[0])) / INERTIA * (rate - before)
        here, before = (times >= start) & (times <= end), rate

        def slope(_: float, y: np.ndarray) -> list[float]:
            return [y[1], -COUPLED * np.sin(y[0]) * before**2 / INERTIA]  # noqa: B023

        done = solve_ivp(slope, (start, end + 1e-9), state, "DOP853", dense_output=True, rtol=1e-12, atol=1e-13)
        found[here], state = done.sol(times[here]).T, done.sol(end)
    return found


def closed(run: RunData, share: float = 1e-6) -> None:
    """The books of energy are."""
    assert run.status == "finished"
    assert np.abs(run.energy_balance).max() < share * run.energy_moved
    assert not [warning for warning in run.warnings if "energy" in warning]


@pytest.mark.parametrize("method", ["auto", "dop853", "rk4", "extrapolation", "midpoint", "rosenbrock"])
def test_a_free_joint_behind_a_jump_keeps_its_momentum(method: str) -> None:
    signal = {"type": "table", "times": [0, 0.2, 0.5], "values": [0, 0.5, 0.5], "interpolation": "linear"}
    tight = {"relative_tolerance": 1e-9, "absolute_tolerance": 1e-11, "method": method, "step": 5e-4}
    run = simulate_motion(hinged(signal, integration={"duration": 0.5, "output_step": 0.01, **tight}))
    wanted = apart(run.times, signal)
    assert run.v[0] == pytest.approx([2.5, -5.5], rel=1e-12)
    np.testing.assert_allclose(np.column_stack([run.q[:, 1], run.v[:, 1]]), wanted, rtol=0, atol=1e-5)
    assert run.v[20, 0] == 0.0
    closed(run, 1e-5 if method == "midpoint" else 1e-6)


def test_many_jumps_and_runs_of_a_batch() -> None:
    signal = ramps(0.0, 0.1, -0.2, 0.05, 0.05, 0.4)
    sheet = hinged(signal)
    run = simulate_motion(sheet)
    wanted = apart(run.times, signal)
    np.testing.assert_allclose(np.column_stack([run.q[:, 1], run.v[:, 1]]), wanted, rtol=0, atol=1e-4)
    closed(run)
    batch = simulate_batch(sheet, {"links.l.bodies.b.mass": [0.5, 2.0]})
    for lane, mass in enumerate([0.5, 2.0]):
        one = simulate_motion(sheet.with_({"links.l.bodies.b.mass": mass}))
        np.testing.assert_array_equal(batch.states[lane], one.states)


def test_a_start_with_rates_of_its_own_has_no_impulse_nor_has_a_motion_at_constant_speed() -> None:
    signal = ramps(0.0, 0.5, 0.5)
    run = simulate_motion(hinged(signal, initial={"state": "zero", "rates": {"p": 1.0}}))
    assert run.v[0] == pytest.approx([2.0, 1.0])
    turning = simulate_motion(hinged({"type": "expression", "formula": "2.5*t"}))
    assert turning.v[0] == pytest.approx([2.5, 0.0])
    assert [warning for warning in simulate_motion(hinged(signal)).warnings if "initial.rates" in warning]


LINES = ("2.5*t", "0.3 - 0.1*t", "where(t < 0, 0, 2*t)")
FROM_REST = ("where(t < 0.2, 2.5*t, 0.5)", "0.01*t + t**3", "0.1*t + 0.2*sin(3*t)", "0.1*sqrt(0.7 - t)")


@pytest.mark.parametrize("signal", [
    *({"type": "expression", "formula": formula} for formula in LINES + FROM_REST),
    {"type": "table", "times": [0, 0.3], "values": [0, 0.4], "interpolation": "linear"},
    {"type": "sum", "signals": [{"type": "expression", "formula": "2*t"}, {"type": "constant", "value": 0.3}]},
    {"type": "sine", "amplitude": 0.1, "frequency": 2.0},
])  # fmt: skip
def test_whether_a_motion_begins_at_once_follows_from_its_signal_whatever_the_duration(signal: dict[str, Any]) -> None:
    """0.1 s are too short to see that a line ends: the same rates, the same motion on the common span."""
    steady = signal["type"] == "sum" or signal.get("formula") in LINES
    settings = {"output_step": 0.05, "error_estimate": False, "model_error": False, "method": "rk4", "step": 0.005}
    short, long = (simulate_motion(hinged(signal, integration={"duration": until, **settings})) for until in (0.1, 0.6))
    assert short.v[0] == pytest.approx(long.v[0], rel=1e-9, abs=1e-12)
    assert short.v[0, 1] == pytest.approx(0.0 if steady else -2.2 * short.v[0, 0], rel=1e-9, abs=1e-12)
    np.testing.assert_allclose(long.q[: len(short.q)], short.q, rtol=0, atol=1e-9)


def test_a_rate_of_a_tiny_share_of_later_ones_begins_at_once_in_long_runs_too() -> None:
    signal = {"type": "expression", "formula": "0.01*t + t**3"}
    settings = {"output_step": 1.0, "error_estimate": False, "model_error": False}
    setup = run_setup(hinged(signal, integration={"duration": 200.0, **settings}))
    assert setup.start[setup.model.layout.v] == pytest.approx([0.01, -0.022], rel=1e-6)


def test_a_rate_that_is_given_as_the_signal_has_it_is_not_said_to_be_left_out() -> None:
    robot = hinged(ramps(0.0, 0.5, 0.5), initial={"state": "zero", "rates": {"h": 2.0}})
    assert not [warning for warning in start_warnings(run_setup(robot)) if "left out" in warning]


def test_a_motor_that_begins_at_once_is_said_to_leave_what_its_gear_carries_behind() -> None:
    line = {"type": "expression", "formula": "0.8*t"}
    robot = carried()
    drives = [drive.model_copy(update={"signal": Signal.of(line)}) for drive in robot.drives]
    robot = robot.model_copy(update={"drives": tuple(drives)})
    (said,) = [warning for warning in start_warnings(run_setup(robot)) if "begins with 0.8" in warning]
    assert "joint g" in said
    along = robot.with_({"initial.rates": {"g": 0.8, "g.motor": 0.8}})
    assert not [warning for warning in start_warnings(run_setup(along)) if "begins with" in warning]


def carried(**more: Any) -> Robot:
    """A rigid hub, a prescribed slide, a beam and an elastic gear, all at once."""
    rotor = {"inertia": 0.1, "side": "joint"}
    joints = [
        {"name": "h", "type": "revolute", "child": "hub", "axis": [0, 0.6, 0.8], "motor": rotor | {"inertia": 0.2}},
        {"name": "s", "type": "prismatic", "child": "rod", "axis": [1, 0, 0], "origin": {"position": [0.1, 0.2, 0]}},
        {"name": "g", "type": "revolute", "child": "l", "axis": [0, 0, 1], "motor": rotor,
         "gear": {"stiffness": 300.0, "damping": 0.3}},
    ]  # fmt: skip
    section = {"bending_stiffness": 40.0, "torsional_stiffness": 30.0, "mass_per_length": 0.5,
               "polar_inertia_per_length": 1e-4}  # fmt: skip
    beam = {"model": "strain", "functions": 2, "length": 0.6, "section": section, "damping_time": 1e-3}
    inertia = dict.fromkeys(("xx", "yy", "zz"), 0.02)
    body = {"name": "b", "mass": 1.0, "center": [0.2, 0.1, 0], "inertia": inertia}
    links = [{"name": "hub", "bodies": [body]}, {"name": "rod", "beam": beam}, {"name": "l", "bodies": [body]}]
    drives = [
        {"joint": "h", "command": "prescribed", "signal": ramps(0.0, 0.2, 0.1)},
        {"joint": "s", "command": "prescribed", "signal": ramps(0.0, -0.1, 0.2)},
        {"joint": "g", "command": "prescribed", "signal": ramps(0.0, 0.3, 0.1)},
    ]
    settings = {"duration": 0.5, "output_step": 0.05, "error_estimate": False, "model_error": False}
    given = {"gravity": 9.81, "joints": joints, "links": links, "drives": drives, "initial": {"state": "zero"}}
    return arm(**{**given, "integration": settings, **more})


def test_several_at_once_keep_the_momenta_of_beams_and_of_joints_behind_gears() -> None:
    """At the start, and at a jump underway: its rates before it are the last ones of a run that ends there."""
    run = simulate_motion(carried())
    settings = {"duration": 0.25, "output_step": 0.05, "error_estimate": False, "model_error": False}
    short = simulate_motion(carried(integration=settings))
    free = [k for k, name in enumerate(run.coordinates) if name not in ("h", "s", "g.motor")]
    for change, q in ((run.v[0], run.q[0]), (run.v[5] - short.v[5], run.q[5])):
        momenta = run.model.mass_matrix(q) * change
        assert np.abs(momenta[free].sum(axis=1)).max() < 1e-9 * np.abs(momenta).max()
        assert np.abs(change[free]).max() > 0.1
    closed(run)


def test_a_base_that_jumps_leaves_a_free_block_where_it_is() -> None:
    block = {"name": "b", "mass": 2.0, "center": [0, 0, 0], "inertia": 0.01}
    joints = [{"name": "x", "type": "prismatic", "child": "l", "axis": [1, 0, 0], "state": "free"},
              {"name": "p", "type": "revolute", "child": "m", "axis": [0, 0, 1], "state": "free"}]  # fmt: skip
    offset = {"name": "b", "mass": 1.0, "center": [0.3, 0, 0], "inertia": 0.01}
    run = simulate_motion(arm(
        gravity=0.0, joints=joints, links=[{"name": "l", "bodies": [block]}, {"name": "m", "bodies": [offset]}],
        base_motion={"x": ramps(0.0, 0.0, 0.3, -0.1), "yaw": ramps(0.0, 0.0, 0.6, 0.2)}, initial={"state": "zero"},
        integration={"duration": 0.5, "output_step": 0.01},
    ))  # fmt: skip
    assert np.abs(run.v[17:-1]).max() > 1.0
    closed(run)
    assert np.abs(run.works["base"]).max() > 0.0


@pytest.mark.parametrize("rate", [0.0, 1.5])
def test_dry_friction_does_not_hold_against_an_impulse(rate: float) -> None:
    """A block on a slide that jumps stays behind, whether it sticks or slips, and is taken along by its friction."""
    joints = [{"name": "x", "type": "prismatic", "child": "a", "axis": [1, 0, 0]},
              {"name": "y", "type": "prismatic", "child": "b", "axis": [1, 0, 0],
               "friction": {"viscous": 0.0, "coulomb": 6.0, "static_extra": 2.0}}]  # fmt: skip
    drives = [{"joint": "x", "command": "prescribed", "signal": ramps(0.0, 0.0, 0.25)},
              {"joint": "y", "command": "effort", "signal": {"type": "constant", "value": 0.0}}]  # fmt: skip
    links = [{"name": name, "bodies": [{"name": "m", "mass": 1.5, "center": [0, 0, 0]}]} for name in "ab"]
    run = simulate_motion(arm(
        gravity=0.0, joints=joints, links=links, drives=drives, initial={"state": "zero", "rates": {"y": rate}},
        integration={"duration": 0.5, "output_step": 0.01},
    ))  # fmt: skip
    before, left = np.minimum(run.times, 0.25), 1.0 - max(rate - 1.0, 0.0)  # friction is 4 m/s^2
    slid = np.minimum(np.maximum(run.times - 0.25, 0.0), left / 4)
    moved = (rate * before - 2 * before**2) * (rate > 0) - left * slid + 2 * slid**2
    np.testing.assert_allclose(run.q[:, 1], moved, rtol=0, atol=1e-9)
    closed(run)


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_a_surface_with_mass_is_pushed_along_or_left(side: float) -> None:
    """Momenta of the link (I p' + (I + c) h' = L P) and of the surface (m s' = P) that its tip touches, or leaves."""
    floor = {"type": "plane", "position": [0, 0, 0], "normal": [0, 1, 0]}
    touched = {"law": "unilateral", "shape": floor, "stiffness": 1.0, "damping": 0.0, "mass": 0.7}
    run = simulate_motion(hinged(ramps(0.0, side, 0.0), contact=touched))
    jump, reach = 4.0 * side, 0.5
    pushed = np.linalg.solve([[INERTIA, -reach], [-reach, -1 / 0.7]], [-(INERTIA + COUPLED) * jump, 0.9 * jump])
    left = -(INERTIA + COUPLED) / INERTIA * jump
    assert run.v[0, 1] == pytest.approx(pushed[0] if side > 0 else left, rel=1e-9)
    closed(run)


def test_jumps_in_position_and_derivatives_are_refused() -> None:
    step = {"type": "step", "start": 0.0, "end": 0.5, "time": 0.2}
    with pytest.raises(InputError, match=r"drives\.0\.signal.*position.*0\.2"):
        simulate_motion(hinged(step))
    with pytest.raises(InputError, match=r"base_motion\.z"):
        simulate_motion(hinged(ramps(0.0, 0.1), base_motion={"z": step}))
    with pytest.raises(InputError, match="rate jumps"):
        forward_sensitivities(hinged(ramps(0.0, 0.5, 0.5)), ["links.l.bodies.b.mass"])
    with pytest.raises(InputError, match="rate jumps"):
        simulate_motion(hinged(ramps(0.0, 0.5, 0.5)), controller=lambda time, q, v: [0.0])


def test_energy_that_a_motor_s_jump_makes_is_not_said_to_be_of_the_integration() -> None:
    step = {"type": "step", "start": 0.0, "end": 0.5, "time": 0.2}
    joint = {"name": "g", "type": "revolute", "child": "l", "axis": [0, 0, 1],
             "motor": {"inertia": 0.1, "side": "joint"}, "gear": {"stiffness": 300.0, "damping": 0.3}}  # fmt: skip
    links = [{"name": "l", "bodies": [{"name": "b", "mass": 1.0, "center": [0.3, 0, 0], "inertia": 0.01}]}]
    run = simulate_motion(arm(gravity=0.0, joints=[joint], links=links,
                              integration={"duration": 0.5, "output_step": 0.01},
                              drives=[{"joint": "g", "command": "prescribed", "signal": step}]))  # fmt: skip
    (warning,) = [each for each in run.warnings if "energy" in each]
    assert "motor of joint g" in warning
    assert "coarse" not in warning
