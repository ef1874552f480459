"""Modes about motion at constant speed, against closed forms and an independent Galerkin solution of rotating beams."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from numpy.polynomial import Legendre, Polynomial
from scipy.linalg import eigh

import tmodes
from tmodes.analysis.describe.describe import describe, statics_info
from tmodes.analysis.modes.of_sheet import vibrations
from tmodes.analysis.statics.at_rest import robot_rest
from tmodes.sheet import Robot

UP = [0, 0, 1]
UNSTEADY = "not steady"


def turning(speed: float, joints: list[dict], links: list[dict], how: dict | None = None, **more: Any) -> Robot:
    """A hub about z at constant speed; its joints carry the rest."""
    hub = {"name": "hub", "type": "revolute", "parent": "base", "child": "rotor", "axis": UP, **more.pop("hub", {})}
    signal = {"type": "expression", "formula": f"0.3 + {float(speed)!r}*t"}
    return Robot.from_data({
        "format": 1, "kind": "arm", "name": "turning", "gravity": 0.0, "joints": [hub, *joints], "links": links,
        "drives": [{"joint": "hub", "signal": signal, **(how or {"command": "prescribed"})}],
        "integration": {"duration": 0.1, "output_step": 0.05}, **more,
    })  # fmt: skip


def disc(speed: float, springs: tuple[float, float], mass: float, **more: Any) -> Robot:
    """A mass on two springs that turn."""
    joints = [
        {"name": name, "type": "prismatic", "parent": parent, "child": name, "axis": axis, "state": "locked",
         "gear": {"stiffness": k, "damping": 0.0}}
        for name, parent, axis, k in zip("xy", ("rotor", "x"), np.eye(3)[:2].tolist(), springs, strict=True)
    ]  # fmt: skip
    bodies = [{"name": "mass", "mass": mass, "inertia": {"xx": 0.1, "yy": 0.1, "zz": 0.1}}]
    links = [{"name": "rotor", "bodies": bodies}, {"name": "y", "bodies": bodies}]
    return turning(speed, joints, links, **more)


def frequencies(robot: Robot, state: str = "locked", element: str = "") -> list[float]:
    """Circular frequencies, rising [rad/s]."""
    rows = [row for row in vibrations(robot).states[state] if row["element"].endswith(element)]
    return sorted(2 * np.pi * row["frequency_Hz"] for row in rows)


MOTOR = {"inertia": 0.2, "side": "joint"}
PD = {"command": "position", "controller": {"type": "pd", "position_gain": 10.0, "velocity_gain": 1.0}}
DRIVES = {"prescribed": ({}, None), "controlled": ({}, PD), "elastic": (
    {"motor": MOTOR, "gear": {"stiffness": 1e9, "damping": 0.0}}, None)}  # fmt: skip


@pytest.mark.parametrize("drive", DRIVES)
@pytest.mark.parametrize("seed", range(3))
def test_a_mass_on_turning_springs(drive: str, seed: int) -> None:
    """w^4 - (a + b + 4 W^2) w^2 + a b = 0 with a, b = k/m - W^2; whatever turns the hub, also through a stiff gear."""
    rng = np.random.default_rng(seed)
    mass, springs, speed = rng.uniform(0.5, 3), rng.uniform(50, 300, 2), rng.uniform(-4, 4)
    hub, how = DRIVES[drive]
    found = frequencies(disc(speed, tuple(springs), mass, hub=hub, how=how))[:2]
    a, b = springs / mass - speed**2
    exact = np.sqrt(np.sort(np.roots([1, -(a + b + 4 * speed**2), a * b]).real))
    assert found == pytest.approx(exact, rel=1e-6)


def test_beyond_the_critical_speed() -> None:
    """Equal springs: |w0 - W| and w0 + W; softer in one direction it diverges between both critical speeds."""
    for speed in (3.0, 15.0):
        assert frequencies(disc(speed, (200.0, 200.0), 2.0)) == pytest.approx([abs(10 - speed), 10 + speed])
    rows = vibrations(disc(12.0, (200.0, 400.0), 2.0)).states["locked"]
    assert [row["stable"] for row in rows].count(False) == 1


@pytest.mark.parametrize("seed", range(2))
def test_flap_and_lag_of_a_rigid_blade(seed: int) -> None:
    """k/I + W^2 (1 + e S/I) and k/I + W^2 e S/I: hinged at a distance e from the axis, S = m c, about the hinge I."""
    rng = np.random.default_rng(seed)
    (stiffness, mass, center, offset, speed), inertia = rng.uniform(0.5, 2, 5), 0.03
    moment, about = mass * center, mass * center**2 + inertia
    for axis, own in (([0, 1, 0], 1.0), (UP, 0.0)):
        joints = [
            {
                "name": "hinge",
                "type": "revolute",
                "child": "blade",
                "axis": axis,
                "state": "locked",
                "from": "frame",
                "origin": {"position": [offset, 0, 0]},
                "gear": {"stiffness": stiffness, "damping": 0.0},
            }
        ]
        body = {"name": "b", "mass": mass, "center": [center, 0, 0], "inertia": {"xx": 0, "yy": inertia, "zz": inertia}}
        (found,) = frequencies(turning(speed, joints, [{"name": "blade", "bodies": [body]}]))
        exact = stiffness / about + speed**2 * (own + offset * moment / about)
        assert found == pytest.approx(np.sqrt(exact), rel=1e-6)


def galerkin(speed: float, hub: float, tip: float, lag: bool) -> np.ndarray:
    """EI w'''' - (T w')' = (w^2 + [W^2 in the plane]) m w; EI = m = L = 1, T = W^2 (int (r + x) dx + tip (r + 1))."""
    x = Polynomial([0, 1])
    shapes = [x**2 * Legendre.basis(k, domain=[0, 1]).convert(kind=Polynomial, domain=[-1, 1]) for k in range(9)]
    tension = speed**2 * (hub * (1 - x) + (1 - x**2) / 2 + tip * (hub + 1))

    def integral(p: Polynomial) -> float:
        whole = p.integ()
        return whole(1.0) - whole(0.0)

    def matrix(function: Any) -> np.ndarray:
        return np.array([[function(a, b) for b in shapes] for a in shapes])

    mass = matrix(lambda a, b: integral(a * b) + tip * a(1.0) * b(1.0))
    stiffness = matrix(lambda a, b: integral(a.deriv(2) * b.deriv(2)) + integral(tension * a.deriv() * b.deriv()))
    return np.sqrt(eigh(stiffness - (speed**2 if lag else 0.0) * mass, mass, eigvals_only=True)[:2])


@pytest.mark.nightly("0.0-0.0-0.0")
@pytest.mark.parametrize(("speed", "hub", "tip"), [(0.0, 0.0, 0.0), (3.0, 0.0, 0.0), (6.0, 0.5, 0.3), (2.0, 1.0, 1.0)])
def test_a_rotating_beam(speed: float, hub: float, tip: float) -> None:
    """It stiffens out of the plane and less so in it; with a hub and a tip mass."""
    beam = {"model": "strain", "functions": {"bend_y": 5, "bend_z": 5}, "length": 1.0, "damping_time": 0.0,
            "section": {"bending_stiffness": 1.0, "mass_per_length": 1.0}, "rotary_inertia": "none"}  # fmt: skip
    bodies = [{"name": "tip", "mass": tip, "at": 1.0}] if tip else []
    root = {"name": "root", "type": "fixed", "child": "blade", "from": "frame", "origin": {"position": [hub, 0, 0]}}
    robot = turning(speed, [root], [{"name": "blade", "beam": beam, "bodies": bodies}])
    rows = vibrations(robot).states["locked"]
    for direction, lag in (("bend_y", False), ("bend_z", True)):
        found = sorted(2 * np.pi * row["frequency_Hz"] for row in rows if row["element"] == f"blade.{direction}")
        exact = galerkin(speed, hub, tip, lag)
        assert found[0] == pytest.approx(exact[0], rel=3e-4)
        assert found[1] == pytest.approx(exact[1], rel=3e-3)


@pytest.mark.parametrize(("axis", "steady"), [(UP, True), ([0, 1, 0], False)])
def test_weight_that_turns_is_reported(axis: list[int], steady: bool) -> None:
    """As seen by the robot its weight stands still only where it turns about the vertical."""
    warnings = vibrations(disc(3.0, (200.0, 300.0), 2.0, gravity=9.81, hub={"axis": axis})).warnings
    assert any(UNSTEADY in warning for warning in warnings) != steady


def on_a_turntable(robot: Robot) -> Robot:
    """The same with the motion of its hub given to its base."""
    info = robot.model_dump(mode="json", exclude_none=True)
    hub, (drive,) = info["joints"][0], info.pop("drives")
    hub["type"] = "fixed"
    del hub["axis"]
    return Robot.from_data(info | {"base_motion": {"yaw": drive["signal"]}})


def test_a_base_that_turns_is_as_a_hub_that_turns() -> None:
    """Loads that turn along are steady, those of the world are not."""
    robot = disc(3.0, (200.0, 300.0), 2.0, gravity=9.81)
    for one in robot, on_a_turntable(robot):
        assert frequencies(one)[:2] == pytest.approx(np.sqrt(np.sort(np.roots([1, -268, 91 * 141]).real)))
        assert not any(UNSTEADY in warning for warning in vibrations(one).warnings)
    for frame, steady in (("section", True), ("world", False)):
        loads = [{"point": "tip", "frame": frame, "force": [1.0, 0.0, 0.0]}]
        loaded = Robot.from_data(on_a_turntable(robot).model_dump(mode="json", exclude_none=True) | {"loads": loads})
        assert any(UNSTEADY in warning for warning in vibrations(loaded).warnings) != steady


@pytest.mark.parametrize("made", [lambda robot: robot, on_a_turntable])
def test_statics_in_steady_motion(made: Any) -> None:
    """k x = m W^2 (a + x) at a distance a from the axis; the base holds the mass on its circle."""
    mass, stiffness, speed, offset = 2.0, 300.0, 5.0, 0.4
    robot = disc(speed, (stiffness, 500.0), mass)
    info = robot.model_dump(mode="json", exclude_none=True)
    info["joints"][1] |= {"from": "frame", "origin": {"position": [offset, 0, 0]}}
    robot = made(Robot.from_data(info))
    found = statics_info(robot, robot_rest(robot, moving=True))
    travel = mass * speed**2 * offset / (stiffness - mass * speed**2)
    assert found["coordinates"]["x"] == pytest.approx(travel)
    assert np.linalg.norm(found["reactions"][0]["force_N"]) == pytest.approx(stiffness * travel)
    assert list(found["moving"].values()) == pytest.approx([speed])
    assert found["stable"]
    assert found["lowest_frequency_Hz"] is None
    assert any("standing still" in note for note in describe(robot)["notes"])


@pytest.mark.parametrize(("springs", "stable"), [((200.0, 200.0), True), ((200.0, 400.0), False)])
def test_gyroscopic_forces_hold_a_disc_beyond_its_critical_speed(springs: tuple[float, float], stable: bool) -> None:
    """Not one with unequal springs, between both."""
    rest = robot_rest(disc(12.0, springs, 2.0), moving=True)
    assert (rest.stable, rest.lost_stability_at) == (stable, None)


def test_a_base_that_begins_tilted_is_reported() -> None:
    tilted = on_a_turntable(disc(3.0, (200.0, 300.0), 2.0)).model_dump(mode="json", exclude_none=True)
    tilted["base_motion"] = {"roll": {"type": "expression", "formula": "0.3"}}
    assert any("tilt" in warning for warning in vibrations(Robot.from_data(tilted)).warnings)


@pytest.mark.parametrize("signal", [{"type": "sine", "amplitude": 0.3, "frequency": 1.0},
                                    {"type": "quintic", "start": 0.3, "end": 0.9, "duration": 0.1},
                                    {"type": "trapezoid", "start": 0.3, "end": 9, "speed": 3, "acceleration": 900},
                                    {"type": "step", "start": 0.3, "end": 0.9, "time": 0.05}])  # fmt: skip
def test_motion_that_is_not_at_constant_speed_is_none(signal: dict) -> None:
    how = {"command": "prescribed", "signal": signal}
    assert frequencies(disc(3.0, (200.0, 300.0), 2.0, how=how)) == pytest.approx(np.sqrt([100.0, 150.0]))


def test_a_result_has_the_frequencies_of_its_motion() -> None:
    robot = disc(3.0, (200.0, 200.0), 2.0)
    found = sorted(row["frequency_Hz"] for row in tmodes.run(robot).frequencies["locked"])
    assert 2 * np.pi * np.array(found) == pytest.approx([7.0, 13.0])
