"""Paths of the tip: places against closed forms, references against the model's own kinematics, limits, messages."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Literal

import numpy as np
import pytest
from pydantic import Field
from scipy.integrate import solve_ivp
from scipy.spatial.transform import Rotation

import tmodes
from command import tmodes as command
from tmodes.errors import TmodesError
from tmodes.kinds.paths.registry import PATHS, Course, Place, Way
from tmodes.kinds.paths.registry import Path as TipPath
from tmodes.kinds.schema.quantity import positive
from tmodes.simulation.departure import departure
from tmodes.simulation.initial_state import run_setup

ARM = tmodes.load("two_link_arm")
LIMITS = {"speed": 0.5, "acceleration": 3.0, "jerk": 60.0}
S_CURVE = {"type": "s_curve", **LIMITS}
START = np.array([0.8731983, 0.0, 0.0876121])


@PATHS.register
class Wave(TipPath):
    """Up and down while it goes along x."""

    type: Literal["wave"] = Field(description="kind of path")
    height: float = positive("m", "h", "height")

    def course(self, start: Place) -> Course:
        """Not by its length but along x, over 0.2 m."""

        def at(way: float) -> Way:
            k = 2 * np.pi / 0.2
            value = start.point + np.array([-way, 0, self.height * (1 - np.cos(k * way))])
            slope = np.array([-1, 0, self.height * k * np.sin(k * way)])
            return Way(value, slope, np.array([0, 0, self.height * k**2 * np.cos(k * way)]))

        return Course(0.2, at)


EXAMPLES: dict[str, dict[str, Any]] = {
    "line": {"to": [0.7, 0.0, 0.2]},
    "arc": {"through": [0.8, 0.0, 0.2], "to": [0.7, 0.0, 0.1]},
    "via": {"points": [[0.8, 0.0, 0.2], [0.7, 0.0, 0.2], [0.7, 0.0, 0.05]], "blend": 0.03},
    "joints": {"points": [[-0.2, 0.8], [0.1, 0.5]], "blend": 0.1},
    "wave": {"height": 0.02},
}
"""One of each path of a planar arm; `turn` needs more joints."""


def references(robot: Any, times: Any, order: int = 0) -> Any:
    return np.stack([drive.signal.schedule(9.0).at(times, order) for drive in robot.drives], axis=-1)


def tip(robot: Any, joints: Any) -> tuple[Any, Any]:
    """Of the undeformed robot: joints where their motors are."""
    model = tmodes.Model(robot.undriven.chain())
    whole = np.zeros((len(joints), model.nq))
    for k, drive in enumerate(robot.drives):
        for name in (drive.joint, f"{drive.joint}.motor"):
            if name in model.coordinates:
                whole[:, model.coordinates.index(name)] = joints[:, k]
    position, rotation = model.pose(whole)
    place = [point.name for point in model.chain.points].index("tip")
    return position[:, place], rotation[:, place]


def test_every_path_has_an_example() -> None:
    assert set(PATHS) == {*EXAMPLES, "turn"}


@pytest.mark.parametrize("name", EXAMPLES)
def test_path(name: str) -> None:
    """On the way all along, from rest to rest, smooth in position, rate and, but for the jerk, acceleration."""
    found = ARM.follow({"type": name, **EXAMPLES[name]}, profile=S_CURVE, fit=1e-8)
    (leg,) = found.found.legs
    assert max(found.error, found.found.turned) <= 1e-8
    times = np.linspace(0.0, found.duration, 501)
    joints = references(found.robot, times)
    ways = leg.signal.schedule(found.duration).at(times)
    exact = np.array([leg.course.at(way).value for way in np.clip(ways, 0, leg.course.length)])
    shown = joints if name == "joints" else tip(ARM, joints)[0]
    assert np.abs(shown - exact).max() < 2e-8
    for order in (1, 2):
        ends = references(found.robot, [0.0, np.nextafter(found.duration, 0)], order)
        assert np.abs(ends).max() < 1e-4
    knots = found.found.times[1:-1]
    for order, size in ((0, 1e-12), (1, 1e-9)):
        jumps = references(found.robot, knots, order) - references(found.robot, np.nextafter(knots, 0), order)
        assert np.abs(jumps).max() < size
    if name not in ("joints", "wave"):  # of a length by itself the speed is that of the profile
        speed = np.linalg.norm(np.gradient(shown, times, axis=0), axis=1)
        assert speed.max() <= LIMITS["speed"] * (1 + 1e-3)


@pytest.mark.parametrize("name", EXAMPLES)
def test_derivatives_of_a_course(name: str) -> None:
    place = Place(START, np.eye(3), np.array([-0.4, 1.0]))
    course = TipPath.of({"type": name, **EXAMPLES[name]}).course(place)
    assert course.at(0.0).value == pytest.approx(place.joints if course.of_joints else START, abs=1e-12)
    h = 1e-5 * course.length
    for share in (0.1, 0.31, 0.5, 0.77, 0.9):
        low, here, high = (course.at(share * course.length + k * h) for k in (-1, 0, 1))
        assert (high.value - low.value) / (2 * h) == pytest.approx(here.slope, abs=1e-7)
        bend = (high.slope - low.slope) / (2 * h)
        assert bend == pytest.approx(here.bend, abs=1e-6 * max(1.0, float(np.abs(here.bend).max())))
        if name != "wave":
            assert np.linalg.norm(here.slope) == pytest.approx(1.0, abs=1e-12)
    for way in course.knots:  # corners begin and end with the curvature of the line
        low, high = course.at(way - 1e-9), course.at(way + 1e-9)
        assert low.slope == pytest.approx(high.slope, abs=1e-6)
        assert low.bend == pytest.approx(high.bend, abs=1e-3)


def test_an_arc_is_on_its_circle() -> None:
    a, b, c = START, np.array([0.8, 0.0, 0.2]), np.array([0.7, 0.0, 0.1])
    course = TipPath.of({"type": "arc", "through": b.tolist(), "to": c.tolist()}).course(Place(a, np.eye(3), a[:2]))
    places = np.array([course.at(way).value for way in np.linspace(0, course.length, 2001)])
    assert places[-1] == pytest.approx(c, abs=1e-12)
    assert np.linalg.norm(places - b, axis=1).min() < 1e-4
    centre = places[0] + course.at(0.0).bend / np.dot(course.at(0.0).bend, course.at(0.0).bend)
    assert np.linalg.norm(places - centre, axis=1) == pytest.approx(np.linalg.norm(a - centre), abs=1e-12)


def near(place: Any, away: list[float]) -> list[float]:
    return (place + np.array(away)).tolist()


def six_axes() -> Any:
    """A wrist at the end of two links; joints behind elastic gears, and without."""
    axes = ([0, 0, 1], [0, 1, 0], [0, 1, 0], [1, 0, 0], [0, 1, 0], [1, 0, 0])
    at = ([0, 0, 0.3], [0, 0, 0], [0, 0, 0.5], [0.3, 0, 0], [0.1, 0, 0], [0.05, 0, 0])
    start = (0.3, 0.4, 0.5, 0.2, 0.7, 0.1)
    joints = [
        {"name": f"j{k}", "type": "revolute", "child": f"l{k}", "axis": axis, "origin": {"position": place},
         "motor": {"inertia": 0.1, "side": "joint"}, **({"gear": {"stiffness": 1e4, "damping": 1.0}} if k < 3 else {})}
        for k, (axis, place) in enumerate(zip(axes, at, strict=True))
    ]  # fmt: skip
    body = {"name": "b", "mass": 1.0, "center": [0.05, 0, 0], "inertia": 0.01}
    return tmodes.Robot.from_data({
        "format": 1, "kind": "arm", "name": "six", "joints": joints,
        "links": [{"name": f"l{k}", "bodies": [body]} for k in range(6)],
        "drives": [{"joint": f"j{k}", "command": "prescribed", "signal": {"type": "constant", "value": value}}
                   for k, value in enumerate(start)],
        "integration": {"duration": 3.0, "output_step": 0.01}})  # fmt: skip


@pytest.mark.parametrize("kind", ["line", "turn", "arc", "via"])
def test_poses_of_six_axes(kind: str) -> None:
    """Place and orientation: the latter on the great circle from the first to the last, at the share of the way."""
    robot = six_axes()
    joints = np.array([[drive.signal.value for drive in robot.drives]])
    ((place,), (first,)) = tip(robot, joints)
    last = Rotation.from_euler("xyz", [0.4, 0.9, -0.2]).as_matrix()
    there = {
        "line": {"to": near(place, [0.1, -0.15, 0.05])}, "turn": {},
        "arc": {"through": near(place, [0.05, 0.1, 0.0]), "to": near(place, [-0.02, 0.15, 0.03])},
        "via": {"points": [near(place, [0.1, 0, 0]), near(place, [0.1, 0.1, 0.1])], "blend": 0.02},
    }[kind]  # fmt: skip
    path = {"type": kind, "rpy": [0.4, 0.9, -0.2], **there}
    found = robot.follow(path, profile=S_CURVE, fit=1e-8)
    assert max(found.error, found.found.turned) <= 1e-8
    (leg,) = found.found.legs
    times = np.linspace(0, found.duration, 201)
    ways = np.clip(leg.signal.schedule(found.duration).at(times), 0, leg.course.length)
    places, rotations = tip(robot, references(found.robot, times))
    exact = np.array([leg.course.at(way).value for way in ways])
    assert np.abs(places - exact).max() < 2e-8
    whole = Rotation.from_matrix(last @ first.T).as_rotvec()
    for way, rotation in zip(ways, rotations, strict=True):
        wanted = Rotation.from_rotvec(whole * way / leg.course.length).as_matrix() @ first
        assert np.abs(rotation - wanted).max() < 3e-8
    assert rotations[-1] == pytest.approx(last, abs=3e-8)


def test_paths_follow_one_another_and_a_run_follows_them() -> None:
    """There and back; the motors of a run under prescribed motion are where the references are."""
    there, back = {"type": "line", "to": [0.7, 0.0, 0.2]}, {"type": "line", "to": START.tolist()}
    found = ARM.follow([there, back], profile=S_CURVE)
    assert found.length == pytest.approx(2 * np.linalg.norm(START - [0.7, 0, 0.2]), abs=1e-6)
    assert found.found.values[-1] == pytest.approx(found.found.values[0], abs=1e-6)
    run = found.robot.run(error_estimate=False, model_error=False)
    assert float(np.abs(run.data["tip_commanded"].values[-1] - START).max()) < 1e-6
    shaped = found.robot.shaper(kind="zv").robot.drives[0].signal
    assert (shaped.type, shaped.signal.type) == ("shaped", "trajectory")


LINE = {"type": "line", "to": [0.7, 0.0, 0.2]}


@pytest.mark.parametrize(("path", "more", "which"), [
    (LINE, {"profile": {"type": "septic", "duration": 1e-6}}, "task.profile"),
    ({"type": "line", "to": [3.0, 0.0, 0.2]}, {}, "path 1"), ({"type": "line", "to": [0.7, 0.1, 0.2]}, {}, "path 1"),
    ({"type": "line", "to": [0.7, 0.0]}, {}, "task.path.to"), ({"type": "lne"}, {}, "task.path.type"),
    ({}, {}, "task.path.type"), ("[1, 2]", {}, "task.path.0"), ([], {}, "task.path"), (None, {}, "task.path"),
    ([LINE, {"type": "line"}], {}, "task.path.1.to"),
    ({"type": "arc", "through": [0.7, 0, 0.2], "to": [0.7, 0, 0.2]}, {}, "path 1: path.through"),
    ({"type": "joints", "points": [[1.0]]}, {}, "path 1: path.points"),
    ({"type": "via", "points": [[0.7, 0.0, 0.2], [0.7, 0.0, 0.2]], "blend": 0.1}, {}, "path 1: path"),
    (LINE, {"profile": {"type": "constant", "value": 1.0}}, "task.profile.type"),
    (LINE, {"profile": {"type": "s_curve"}}, "task.profile.speed"), (LINE, {"profile": "quintic"}, "task.profile"),
    (LINE, {"profile": {"type": "step", "time": 0.0}}, "task.profile"),
    (LINE, {"shaper": {"type": "zvx"}}, "task.shaper.type"),
    (LINE, {"shaper": {"kind": "zv"}}, "task.shaper.type"), (LINE, {"fit": 0.0}, "task.fit"),
    (LINE, {"profile": {"type": "toppra", "share": 2.0}}, "task.profile.share"),
    (LINE, {"profile": {"type": "toppra"}, "least_time": True}, "task.least_time"),
    (LINE, {"reference": "sga"}, "task.reference"),
])  # fmt: skip
def test_what_is_wrong_is_said(path: Any, more: dict, which: str) -> None:
    with pytest.raises(TmodesError) as caught:
        ARM.follow(path, **more)
    assert which in [one.which for one in getattr(caught.value, "errors", [caught.value])]


def test_a_redundant_robot_moves_with_the_least_rates() -> None:
    """Six joints, three directions: q' = J^+ x' by SciPy, where each row is, how fast and with which acceleration."""
    robot = six_axes()
    start = np.array([drive.signal.value for drive in robot.drives])
    aim = tip(robot, start[None])[0][0] + [0.1, -0.15, 0.1]
    found = robot.follow({"type": "line", "to": aim.tolist()}, profile=S_CURVE, fit=1e-8)
    assert found.error <= 1e-8
    (leg,) = found.found.legs

    def rates(time: float, joints: Any) -> Any:
        """Of the joints, by differences of the tip's place."""
        near = np.concatenate([joints + 1e-5 * np.eye(6), joints - 1e-5 * np.eye(6)])
        places = tip(robot, near)[0]
        slopes = (places[:6] - places[6:]).T / 2e-5
        speed = float(leg.pieces.at(time, 1)) * (aim - leg.course.at(0.0).value) / leg.course.length
        return np.linalg.pinv(slopes, rcond=1e-6) @ speed

    times, step = np.linspace(0.1, found.duration - 0.1, 9), 1e-3
    around = np.sort(np.concatenate([times - step, times, times + step]))
    exact = solve_ivp(rates, (0, found.duration), start, t_eval=around, rtol=1e-9, atol=1e-11).y.T.reshape(9, 3, 6)
    wanted = np.array([[rates(t, q) for t, q in zip(ts, qs, strict=True)]
                       for ts, qs in zip(around.reshape(9, 3), exact, strict=True)])  # fmt: skip
    assert references(found.robot, times) == pytest.approx(exact[:, 1], abs=1e-7)
    assert references(found.robot, times, 1) == pytest.approx(wanted[:, 1], abs=1e-6)
    gain = (wanted[:, 2] - wanted[:, 0]) / (2 * step)
    assert references(found.robot, times, 2) == pytest.approx(gain, abs=1e-3 * np.abs(gain).max())


def test_files_of_the_command(tmp_path: Path) -> None:
    sheet, figure = tmp_path / "line.yaml", tmp_path / "line.svg"
    path = "{type: line, to: [0.7, 0, 0.2]}"
    said = command("follow", "two_link_arm", "--path", path, "--out", str(sheet), "--figure", str(figure)).stdout
    assert "line of 0.2065 in 1.176 s" in said
    assert str(tmodes.load(sheet).drives[1].signal.type) == "trajectory"
    assert figure.read_bytes().startswith(b"<?xml")


@pytest.mark.parametrize("profile", [S_CURVE, {"type": "polynomial", "duration": 1.0}], ids=["s_curve", "polynomial"])
def test_setpoints_with_sag_start_and_end_at_rest(profile: dict[str, Any]) -> None:
    found = ARM.follow(LINE, profile=profile, reference="sag")
    for drive in found.robot.drives:
        pieces = drive.signal.schedule(found.duration)
        ends = [pieces.at(time, order) for time in (0.0, found.duration) for order in (1, 2)]
        assert ends == pytest.approx(np.zeros(4), abs=1e-9)
    setup = run_setup(found.robot.pair().nominal)
    assert departure(setup, setup.first_row) is None


def test_with_the_sag_the_bent_tip_is_on_the_path_at_rest() -> None:
    """Motors of three rows, put into the equilibrium of the robot; and runs are nearer by what bends."""
    path = {"type": "line", "to": [0.7, 0.0, 0.2]}
    rigid, own = ARM.follow(path), ARM.follow(path, reference="sag")
    assert own.motors is not None
    for row in (0, len(rigid.found.times) // 2, -1):
        motors = dict(zip((f"{one}.motor" for one in own.found.joints), own.motors.positions.values[row].tolist(),
                          strict=True))  # fmt: skip
        held = ARM.static(hold=motors).data["position"].sel(point="tip").values
        assert held == pytest.approx(tip(ARM, rigid.found.values[[row]])[0][0], abs=1e-9)
    assert own.checks["this"] < own.checks["rigid"] / 3
    assert not rigid.checks


TRAPEZOID = {"type": "trapezoid", "speed": 0.6, "acceleration": 4.0}


def test_a_shaped_way_stays_on_the_path_and_does_not_ring() -> None:
    path = {"type": "line", "to": [0.7, 0.0, 0.2]}
    plain, shaped = (ARM.follow(path, profile=TRAPEZOID, shaper=one) for one in (None, {"type": "zv"}))
    assert shaped.error < 1e-7
    shaper = shaped.found.legs[0].signal.shaper
    assert shaped.duration == pytest.approx(plain.duration + 0.5 / shaper.frequencies[0], rel=0.02)  # half a period
    low, high = plain.robot.shaper(where="path").info()["modes"][0]["frequency_Hz"]
    assert shaper.frequencies[0] == pytest.approx((low + high) / 2)
    swings = []
    for found in (plain, shaped):
        done = found.robot.with_({"real": {}, "integration.duration": 1.5}).run()
        after = done.data["tip"].values[done.data["tip"].time.values > found.duration]
        swings.append(float(np.ptp(after, axis=0).max()))
    assert swings[1] < swings[0] / 10


def test_sag_along_a_profile_whose_acceleration_jumps() -> None:
    """Two rows at one instant, with different accelerations."""
    path = {"type": "line", "to": [0.7, 0.0, 0.2]}
    found = ARM.follow(path, profile=TRAPEZOID, reference="sag")
    assert (np.diff(found.found.times) == 0).any()
    assert found.checks["this"] < found.checks["rigid"]
