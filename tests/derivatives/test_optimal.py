"""Torques from rest to rest: their functions, the slopes of runs by them, and motions against independent solutions."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.integrate import solve_ivp
from scipy.interpolate import CubicSpline

import tmodes
from command import called
from tmodes.errors import InputError, SimulationError
from tmodes.gradients.optimal import RestToRest, table, under_torques
from tmodes.gradients.torque_functions import torque_functions
from tmodes.kinds.signals.registry import SIGNALS

PAGE = (Path(__file__).resolve().parents[2] / "docs" / "motion.md").read_text(encoding="utf-8")
LENGTH = 0.7
INERTIA, FREQUENCIES = 1.45733, (3.27812, 17.22507, 48.02358)
"""Of the link below, its motor free: reference values computed from the exact modes of the beam [kg*m^2], [rad/s]."""


def flexible(functions: int, **more: Any) -> tmodes.Robot:
    """A rotor on a spring that turns a link softer than its mass asks for (De Luca, Di Giovanni): no damping."""
    beam = {
        "model": "strain", "functions": functions, "length": LENGTH, "damping_time": 0.0, "rotary_inertia": "none",
        "section": {"bending_stiffness": [0.6, 0.6], "mass_per_length": 4.0},
    }  # fmt: skip
    joint = {"name": "hub", "type": "revolute", "child": "link", "axis": [0, -1, 0],
             "motor": {"inertia": 1.0, "side": "joint"}, "gear": {"stiffness": 100.0, "damping": 0.0}}  # fmt: skip
    sheet = {"format": 1, "kind": "arm", "name": "soft_link", "gravity": 0.0, "planar": True, "joints": [joint | more],
             "links": [{"name": "link", "beam": beam}]}  # fmt: skip
    return tmodes.Robot.from_data(sheet)


def two_flexible_links(functions: int = 2) -> tmodes.Robot:
    """The arm to begin with, its upper arm a beam too; harmonic drives."""
    beam = {"model": "strain", "functions": functions, "basis": "tip_weighted", "damping_time": 2e-4}
    changes = {f"links.upper_arm.beam.{key}": value for key, value in beam.items()}
    return tmodes.load("two_link_arm").with_(changes | {"links.forearm.beam.functions": functions})


def swing_of(robot: tmodes.Robot, signal: Any, angle: float, time: float) -> float:
    """Largest distance of the tip from the goal after ``time`` [s], over the length."""
    driven = tmodes.Robot.of(under_torques(robot, {"hub": 0.0}, {"hub": signal}, time + 3.0)[0])
    data = driven.with_({"integration.output_step": 0.01}).run(error_estimate=False, model_error=False).data
    goal = LENGTH * np.array([np.cos(angle), 0.0, np.sin(angle)])
    return float(np.linalg.norm(data["tip"].values[data["time"].values >= time] - goal, axis=1).max() / LENGTH)


def flat_plan(angle: float, time: float) -> Any:
    """The published plan: the flat output of the linear model of three modes is a polynomial of degree 15."""
    x = np.polynomial.Polynomial([0.0, 1.0])
    course = ((x * (1 - x)) ** 7).integ()
    torque = (course * (angle / course(1.0))).deriv(2) / time**2
    for frequency in FREQUENCIES:
        torque = torque + torque.deriv(2) / (time * frequency) ** 2
    at = np.linspace(0.0, 1.0, 2001)
    times, values = np.append(at * time, time), np.append(INERTIA * torque(at), 0.0)
    return SIGNALS["table"](type="table", times=tuple(times), values=tuple(values), interpolation="linear")


@pytest.mark.parametrize(("angle", "time", "peak", "swing", "off"), [
    (5, 2.0, 0.702, 0.0, 1e-3), (90, 2.0, 12.6324, 0.090, 5e-4), (90, 3.0, None, 0.0219, 1e-4),
    (90, 1.0, 123.2392, None, 0),
])  # fmt: skip
def test_the_linear_plan_does_as_published(
    angle: float, time: float, peak: float | None, swing: float | None, off: float
) -> None:
    """Peak torques by the exact modes [N*m]; swing over the length by Exudyn, 24 cable elements."""
    plan = flat_plan(np.radians(angle), time)
    if peak:
        assert np.abs(plan.values).max() == pytest.approx(peak, rel=1e-3)
    if swing is not None:
        assert swing_of(flexible(6), plan, np.radians(angle), time) == pytest.approx(swing, abs=off)


def test_a_link_that_swings_through_its_own_length_stops_dead() -> None:
    """90 degrees in 2 s, where the linear plan leaves 0.09 of the length: the example of docs/motion.md, as it says."""
    space: dict[str, Any] = {}
    for example in re.findall(r"^```python\n(.*?)^```$", PAGE, re.MULTILINE | re.DOTALL):
        exec(compile(example, "docs/motion.md", "exec"), space)  # noqa: S102
    found = space["found"]
    assert found.warnings == []
    assert found.swings["planned"] < 1e-6 * LENGTH
    assert found.swings["finer"] < 1e-6 * LENGTH
    assert found.swings["quintic"] == pytest.approx(0.94 * LENGTH, rel=0.01)
    assert abs(found.data["torque"]).max() < 10
    assert found.found.slopes < 12


def test_the_commands_of_the_page_run(tmp_path: Path) -> None:
    """And what ``--out`` writes is a sheet that stands still after the motion."""
    lines = [line.split()[1:] for line in re.findall(r"^    (tmodes motion .*)$", PAGE, re.MULTILINE)]
    assert len(lines) == 3
    last = ""
    for line in lines:
        done = called(*line, "--json", "--out", tmp_path / "still.yaml", "--overwrite")
        assert done.returncode == 0, done.stderr
        last = done.stdout
    found = json.loads(last)
    assert found["joints"][0]["torque"] <= 20
    assert found["duration"] < 1
    assert found["swing_m"]["planned"] < 1e-5 * found["way_m"]
    still = tmodes.load(tmp_path / "still.yaml")
    assert still.drives[0].command == "torque"
    assert called(*lines[0], "--out", tmp_path / "still.yaml").returncode == 4


@pytest.mark.nightly
def test_limits_are_kept_to() -> None:
    """A torque and a speed of the motor below those of the free motion, 7.8 N*m and 2.01 rad/s."""
    found = flexible(5).motion(goal="hub=90deg", duration=2.0, torque="hub=7", speed="hub=1.9 rad/s", modes=4)
    assert found.found.excess == 0
    assert [warning for warning in found.warnings if "more functions" not in warning] == []
    signal = found.robot.drives[0].signal.schedule(2.0)
    assert np.abs(signal.at(np.linspace(0.0, 2.0, 5001))).max() <= 7.0
    assert abs(found.data["motor_speed"]).max() <= 1.9 * (1 + 1e-4)
    assert found.swing < 1e-6 * LENGTH


def test_functions_are_what_a_table_says() -> None:
    """They vanish with their rate at both ends, are orthogonal, and a table through their rows is the same spline."""
    made = torque_functions(2.0, [17.0, 48.0])
    count = len(made.knots) - 1
    np.testing.assert_allclose(made.values.T @ made.values / count, np.eye(made.values.shape[1]), atol=1e-12)
    ends = CubicSpline(made.knots, made.values, bc_type="clamped")
    for derivative in (0, 1):
        np.testing.assert_allclose(ends([0.0, 2.0], derivative), 0.0, atol=1e-9)
    at = np.linspace(0.0, 2.0, 777)[:-1]
    for k in (0, -1):
        signal = table(made.knots, made.values[:, k]).schedule(2.0)
        np.testing.assert_allclose(signal.at(at), ends(at)[:, k], atol=1e-12)
        piece = np.searchsorted(made.knots, at, side="right") - 1
        powers = (at - made.knots[piece])[:, None] ** np.arange(4)
        np.testing.assert_allclose((made.pieces[k][piece] * powers).sum(axis=1), ends(at)[:, k], atol=1e-12)
    np.testing.assert_allclose(made.fine[2::4], ends((made.knots[:-1] + made.knots[1:]) / 2), atol=1e-12)


@pytest.mark.nightly("two")
@pytest.mark.parametrize("which", ["one link", "two links"])
def test_slopes_are_those_of_runs(which: str) -> None:
    """Against differences of whole runs, torques and speeds included."""
    if which == "one link":
        move = RestToRest(flexible(4), {"hub": 0.0}, {"hub": 1.0}, 2.0, torque={"hub": 9.0}, speed={"hub": 3.0})
    else:
        ends = {"shoulder": -0.4, "elbow": 1.0}, {"shoulder": 0.4, "elbow": 0.4}
        move = RestToRest(two_flexible_links(1), *ends, 0.5, torque={"elbow": 9.0}, speed={"shoulder": 3.0}, modes=2)
    now, way = move._at(move.guess), np.random.default_rng(1).standard_normal(len(move.guess))
    response, uses, _ = move._linear(now)
    step = 1e-4
    after, before = (move._at(move.guess + sign * step * way) for sign in (1, -1))
    slope = (after.residual - before.residual) / (2 * step)
    np.testing.assert_allclose(response[:, :-1] @ way, slope, atol=1e-6 * np.abs(slope).max())
    slope = (after.used - before.used) / (2 * step)
    np.testing.assert_allclose(uses @ way, slope, atol=1e-6 * np.abs(slope).max())


def test_an_elastic_joint_under_gravity_stops_by_its_own_equations() -> None:
    """I q'' + m g l sin q + k (q - th) = 0, J th'' + k (th - q) = u, integrated by SciPy under the torques found."""
    found = tmodes.load("spong1987").motion(goal={"joint": 2.0}, duration=1.2)
    rows: Any = found.robot.drives[0].signal
    torque = CubicSpline(rows.times, rows.values, bc_type="clamped")

    def rates(time: float, state: NDArray[np.float64]) -> list[float]:
        motor, joint, motor_rate, joint_rate = state
        twist = 100.0 * (motor - joint)
        return [motor_rate, joint_rate, (float(torque(time)) - twist) / 0.3, twist - 9.8 * np.sin(joint)]

    end = solve_ivp(rates, (0.0, 1.2), [0.0] * 4, method="DOP853", rtol=1e-11, atol=1e-12, max_step=0.01).y[:, -1]
    assert end[0] == pytest.approx(2.0, abs=2e-7)
    assert 100.0 * (end[0] - end[1]) == pytest.approx(9.8 * np.sin(end[1]), abs=1e-4)
    np.testing.assert_allclose(end[2:], 0.0, atol=5e-6)
    assert rows.values[0] == pytest.approx(0.0, abs=1e-9)
    assert rows.values[-1] == pytest.approx(9.8 * np.sin(end[1]), abs=1e-4)


@pytest.mark.nightly
def test_two_flexible_links_with_elastic_gears_swing_far_less_than_after_a_quintic() -> None:
    """Under gravity, within the limits of torque and speed of the sheet."""
    found = two_flexible_links(1).motion(duration=0.6, modes=2, tolerance=2e-6)
    assert found.found.excess == 0
    assert found.swing < 0.01 * found.swings["quintic"]


@pytest.mark.nightly
def test_the_least_time_of_a_rigid_joint_is_near_that_of_bang_bang() -> None:
    """A smooth torque takes longer than 2 (J a / u)^(1/2) of full torque to and fro, by less than a third."""
    link = {"name": "bar", "bodies": [{"mass": 1.0, "center": [1, 0, 0], "inertia": 0.0}]}
    joint = {"name": "hub", "type": "revolute", "child": "bar", "axis": [0, 0, 1], "limits": {"effort": 4.0}}
    robot = tmodes.Robot.from_data({
        "format": 1, "kind": "arm", "name": "bar", "joints": [joint], "links": [link],
        "tip": {"link": "bar", "position": [1, 0, 0]},
    })  # fmt: skip
    found = robot.motion(goal="hub=1", duration=1.5, least_time=True)
    assert found.warnings == []
    assert 1.0 < found.duration < 4 / 3
    assert found.data["torque"].max() == pytest.approx(4.0, rel=0.01)
    with pytest.raises(SimulationError, match="no motion in up to"):
        robot.motion(goal="hub=1", duration=1.0, least_time=True, torque="hub=1e-9")


@pytest.mark.nightly
def test_a_controller_follows_the_motors() -> None:
    """The sheet's own controllers, their setpoints where the motors are: a reference that contains the deflection."""
    found = tmodes.load("spong1987").motion(duration=1.0)
    run = found.followed.run(error_estimate=False, model_error=False)
    wanted = run.data["wanted"].sel(drive="joint").values
    np.testing.assert_allclose(wanted, found.data["motor"].sel(joint="joint").interp(time=run.data["time"]), atol=1e-3)
    with pytest.raises(InputError, match="no controller of hub"):
        _ = flexible(1).motion(goal="hub=0.1", duration=2.0).followed


@pytest.mark.parametrize(("given", "message"), [
    ({"goal": "hub=0"}, "differs from the start"), ({}, "no drive has a move|no drive of the sheet"),
    ({"goal": "hup=1"}, "(?i)hup.*did you mean `hub`"), ({"goal": "hub=1", "duration": -1.0}, "duration"),
    ({"goal": "hub=1", "modes": 0}, "modes"), ({"goal": "hub=1", "tolerance": 0.0}, "tolerance"),
    ({"goal": "hub=1", "torque": "hub=0"}, "above 0"), ({"goal": "hub=1", "speed": "arm=1"}, "joints that are moved"),
    ({"goal": "hub=1", "torque": "hub=3 m"}, "N.m"), ({"goal": "hub=1", "torque": "hub"}, "COORDINATE=VALUE"),
])  # fmt: skip
def test_what_is_no_motion_is_refused(given: dict[str, Any], message: str) -> None:
    with pytest.raises(InputError, match=message):
        flexible(1).motion(**dict[str, Any]({"duration": 2.0} | given))


def test_disturbances_are_not_planned_for() -> None:
    """A load that begins later leaves torques and swing as they are; one from 0 on counts."""
    robot, how = tmodes.load("spong1987"), {"goal": {"joint": 0.5}, "start": {"joint": 0}, "duration": 1.0}
    push = {"point": "tip", "moment": [0.0, 0.0, 1.0], "frame": "world"}
    step = {"type": "step", "start": 0.0, "end": 1.0, "time": 0.3}
    calm, late, always = (robot.with_(one).motion(**how) for one in (
        {}, {"loads": [push | {"signal": step}]}, {"loads": [push]}))  # fmt: skip
    assert late.data["torque"].values == pytest.approx(calm.data["torque"].values, abs=1e-9)
    assert late.swing < 1e-6
    assert "as at time 0" in late.warnings[0]
    assert calm.warnings == always.warnings == []
    assert getattr(late.robot.loads[0].signal, "type", None) == "step"


def test_a_robot_in_contact_is_refused() -> None:
    with pytest.raises(InputError, match="contact"):
        tmodes.load("filipovic2010").motion(duration=1.0)


@pytest.mark.nightly
def test_what_cannot_be_reached_is_said() -> None:
    found = flexible(2).motion(goal="hub=90deg", duration=0.6, torque="hub=5")
    assert any("is accepted" in warning or "a limit is passed" in warning for warning in found.warnings)
