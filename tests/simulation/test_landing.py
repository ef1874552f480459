"""A surface with mass that only pushes: momentum law, joint motion, release, its own motion, restitution, rest."""

from __future__ import annotations

import math
import os
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import solve_ivp
from scipy.linalg import expm

from simulation.sheets import arm
from tmodes.errors import TmodesError
from tmodes.gradients.gradient import forward_sensitivities
from tmodes.result.run import run as result_of
from tmodes.sheet import Robot
from tmodes.simulation.motion_run import RunData
from tmodes.simulation.simulate import simulate_motion

NO_FORCE = {"type": "constant", "value": 0.0}


def falling(height: float, mass: float, contact: dict[str, Any], gravity: float = 9.81, **run: Any) -> Robot:
    """A mass above a plate."""
    floor = {"type": "plane", "position": [0, 0, 0], "normal": [0, 0, 1]}
    return arm(
        gravity=gravity,
        joints=[{"name": "z", "type": "prismatic", "parent": "base", "child": "b", "axis": [0, 0, 1]}],
        links=[{"name": "b", "bodies": [{"name": "m", "mass": mass, "center": [0, 0, 0]}]}],
        tip={"link": "b", "position": [0, 0, 0]},
        drives=[{"joint": "z", "command": "effort", "signal": NO_FORCE}],
        contact={"law": "unilateral", "point": "tip", "shape": floor, **contact},
        initial={"state": "zero", "coordinates": {"z": height}}, integration=run,
    )  # fmt: skip


def surface(run: RunData) -> np.ndarray:
    """Displacement of the surface along the direction into it."""
    return run.states[:, run.setup.model.layout.surface][:, 0]


@pytest.mark.parametrize("method", [None, "dop853", "extrapolation", "rosenbrock", "rk4", "midpoint"])
def test_a_light_plate_is_met_left_and_met_again(method: str | None) -> None:
    """Reference values computed with closed forms in pieces; x is down."""
    plate = {"mass": 0.05, "stiffness": 8000.0, "damping": 6.0}
    chosen = {"duration": 0.7, "output_step": 0.05, **({"method": method, "step": 2e-4} if method else {})}
    run = simulate_motion(falling(0.05, 1.5, plate, **chosen))
    x = [-0.0377375, -0.0009499999999999973, -0.0010982212258100997, -0.031530201473265074, -0.03743718172072003,
         -0.018819161968175006, 0.013051754722705956, -0.016485658957123252, -0.029105062245506113,
         -0.017199465533888982, 0.011589166311339045, -0.012615837951856666, -0.021794687056833642]  # fmt: skip
    y = [0.0, 0.0, -0.0009401169718514018, -9.633039545060715e-05, -3.448892002485964e-06, 3.1867666423149415e-08,
         0.013051754722705956, 0.00031489579184569545]  # fmt: skip
    far = 5e-6 if method == "midpoint" else 1e-6
    np.testing.assert_allclose(-run.q[1:14, 0], x, rtol=0, atol=far)
    np.testing.assert_allclose(surface(run)[1:9], y, rtol=0, atol=far)
    assert run.statistics["switches"] == 6


@settings(max_examples=10, deadline=None)
@given(
    mass=st.floats(0.2, 5.0), plate=st.floats(0.01, 20.0), height=st.floats(0.01, 0.5), rate=st.floats(5.0, 60.0),
    damped=st.floats(0.0, 0.5),
)  # fmt: skip
def test_the_first_contact_is_the_momentum_law_and_one_oscillator(
    mass: float, plate: float, height: float, rate: float, damped: float
) -> None:
    """Against the matrix exponential of the joint motion."""
    both = mass + plate
    stiffness, damping = both * rate**2, 2 * damped * both * rate
    touch = math.sqrt(2 * height / 9.81)
    until = touch + 1.2 / rate
    contact = {"mass": plate, "stiffness": stiffness, "damping": damping}
    run = simulate_motion(falling(height, mass, contact, duration=until, output_step=until / 20))
    start = np.array([0.0, 9.81 * touch * mass / both, 1.0])
    matrix = np.array([[0, 1, 0], [-(rate**2), -2 * damped * rate, 9.81 * mass / both], [0, 0, 0]])
    touched = run.states[:, run.setup.model.layout.modes][:, -1] > 0
    assert touched.any()
    wanted = [(expm(matrix * (t - touch)) @ start)[0] for t in run.times[touched]]
    np.testing.assert_allclose(-run.q[touched, 0], wanted, rtol=1e-6, atol=1e-9)
    np.testing.assert_allclose(surface(run)[touched], wanted, rtol=1e-5, atol=1e-8)
    assert np.abs(run.energy_balance).max() < 1e-6 * run.energy_moved


def test_a_pendulum_meets_a_surface_that_moves_along_its_normal_alone() -> None:
    """Reference values computed with an ODE solver with located events."""
    arm_of_weight = 4.0 / 9.81
    inertia = dict.fromkeys(("xx", "yy", "zz"), 0.25 - arm_of_weight**2)
    wall = {"type": "plane", "position": [0.6 * math.sin(0.1), 0, 0], "normal": [-1, 0, 0]}
    run = simulate_motion(arm(
        joints=[{"name": "q", "type": "revolute", "parent": "base", "child": "b", "axis": [0, -1, 0]}],
        links=[{"name": "b", "bodies": [{"name": "m", "mass": 1.0, "center": [0, 0, -arm_of_weight],
                                         "inertia": inertia}]}],
        tip={"link": "b", "position": [0, 0, -0.6]},
        drives=[{"joint": "q", "command": "effort", "signal": NO_FORCE}],
        contact={"law": "unilateral", "point": "tip", "shape": wall, "stiffness": 3000.0, "damping": 8.0, "mass": 0.4},
        initial={"state": "zero", "coordinates": {"q": -0.8}}, integration={"duration": 2.0, "output_step": 0.2},
    ))  # fmt: skip
    wanted = [-0.5792185289524052, -0.02805810571846713, -0.06223279005466083, -0.3367174914688772,
              -0.4107790461741034, -0.24169905721035223, 0.07204163548645963, -0.01072721642222982,
              -0.17340122073969405, -0.23145387786459518]  # fmt: skip
    np.testing.assert_allclose(run.q[1:, 0], wanted, rtol=0, atol=1e-7)


@settings(max_examples=8, deadline=None)
@given(
    back=st.floats(0.1, 0.8), height=st.floats(0.02, 1.0), mass=st.floats(0.1, 3.0),
    method=st.sampled_from(["auto", "rk4", "midpoint"]),
)  # fmt: skip
def test_infinitely_many_bounces_end_in_rest(back: float, height: float, mass: float, method: str) -> None:
    """On a surface so heavy that it stands: flights of a geometric series, then rest."""
    floor = {"mass": 1e9, "stiffness": 1e9, "damping": 0.0, "restitution": back}
    first = math.sqrt(2 * height / 9.81)
    end = first * (1 + back) / (1 - back)
    chosen = {"method": method, "step": end / 300, "max_wall_time": 20.0}
    run = simulate_motion(falling(height, mass, floor, duration=1.2 * end, output_step=1.2 * end / 50, **chosen))
    start, speed, x = first, 9.81 * first * back, np.maximum(height - 9.81 * run.times**2 / 2, 0.0)
    while speed > 1e-9:
        since = run.times - start
        x = np.where((since > 0) & (since < 2 * speed / 9.81), speed * since - 9.81 * since**2 / 2, x)
        start, speed = start + 2 * speed / 9.81, speed * back
    assert run.status == "finished"
    np.testing.assert_allclose(run.q[:, 0], x, rtol=0, atol=1e-6 * height)
    assert run.contact_normal is not None
    assert run.contact_normal[-1] == pytest.approx(9.81 * mass, rel=1e-3)


def test_a_mass_rests_on_a_plate_where_the_plate_is() -> None:
    plate = {"mass": 2.0, "stiffness": 500.0, "damping": 30.0, "restitution": 0.7}
    run = simulate_motion(falling(0.1, 1.0, plate, duration=3.0, output_step=0.1))
    assert run.status == "finished"
    assert -run.q[-1, 0] == pytest.approx(9.81 / 500, rel=1e-4)
    assert np.abs(run.energy_balance).max() < 1e-6 * run.energy_moved


@pytest.mark.parametrize(
    ("contact", "which"),
    [({"restitution": 0.5}, "contact.restitution"), ({"mass": 1, "preload": 2}, "contact.preload")],
)
def test_surfaces_that_are_none(contact: dict[str, Any], which: str) -> None:
    with pytest.raises(TmodesError, match=which):
        falling(0.1, 1.0, {"stiffness": 1e3, "damping": 0.0, **contact}, duration=1.0)


def test_derivatives_over_a_touch_are_refused_with_the_mass() -> None:
    sheet = falling(0.1, 1.0, {"stiffness": 1e3, "damping": 0.0, "mass": 0.5}, duration=0.1)
    with pytest.raises(TmodesError, match=r"contact\.mass.*0\.5 kg"):
        forward_sensitivities(sheet, ["contact.stiffness"])


@pytest.mark.parametrize("mass", [0.0, 0.2])
def test_surfaces_with_and_without_mass_share_no_code(mass: float) -> None:
    """One after the other, with friction that sticks: energy adds up in both."""
    contact = {"stiffness": 1e5, "damping": 10.0, "friction": 0.3, "static_friction": 0.4, "mass": mass}
    run = simulate_motion(falling(0.02, 1.0, contact, duration=0.2, output_step=0.01))
    assert run.status == "finished"
    assert np.abs(run.energy_balance).max() < 1e-6 * run.energy_moved


def of_plate_and_mass(mass: float, contact: dict[str, float], height: float, times: np.ndarray) -> np.ndarray:
    """Positions of mass and plate (n, 2), down, by an ODE solver that stops at touch and release."""
    plate, stiffness, damping = contact["mass"], contact["stiffness"], contact["damping"]

    def together(_: float, s: np.ndarray) -> list[float]:
        change = (9.81 * mass - stiffness * s[0] - damping * s[1]) / (mass + plate)
        return [s[1], change, s[1], change]

    def apart(_: float, s: np.ndarray) -> list[float]:
        return [s[1], 9.81, s[3], -(stiffness * s[2] + damping * s[3]) / plate]

    def pushed(t: float, s: np.ndarray) -> float:
        return plate * together(t, s)[1] + damping * s[1] + stiffness * s[0]

    def gap(_: float, s: np.ndarray) -> float:
        return s[2] - s[0]

    pushed.terminal = gap.terminal = True  # pyright: ignore[reportFunctionMemberAccess]
    pushed.direction = gap.direction = -1  # pyright: ignore[reportFunctionMemberAccess]
    state, now, touches, found = np.array([-height, 0.0, 0.0, 0.0]), 0.0, False, np.empty((0, 2))
    while len(found) < len(times):
        moves, ends = (together, pushed) if touches else (apart, gap)
        part = solve_ivp(
            moves, (now, times[-1]), state, "DOP853", times[len(found) :], events=ends, rtol=1e-11, atol=1e-13
        )
        found = np.concatenate([found, np.transpose(part.y).reshape(-1, 4)[:, [0, 2]]])
        if part.status == 1:
            now, state, touches = part.t_events[0][0], part.y_events[0][0], not touches
            if touches:
                state[[1, 3]] = (mass * state[1] + plate * state[3]) / (mass + plate)
                touches = pushed(now, state) > 0
    return found


@settings(max_examples=int(os.environ.get("TMODES_PLATES", "6")), deadline=None)
@given(
    mass=st.floats(0.2, 5.0), ratio=st.floats(0.02, 8.0), rate=st.floats(5.0, 80.0), height=st.floats(0.01, 0.3),
    damped=st.sampled_from([0.0, 0.02, 0.3, 1.3]),
)  # fmt: skip
def test_the_spring_of_a_surface_acts_on_both_sides_of_its_rest(
    mass: float, ratio: float, rate: float, height: float, damped: float
) -> None:
    """A surface of any mass, touched beyond its rest: a light one, or a damped one, is released there, or never."""
    both = mass * (1 + ratio)
    contact = {"mass": mass * ratio, "stiffness": both * rate**2, "damping": 2 * damped * both * rate}
    run = simulate_motion(falling(height, mass, contact, duration=0.8, output_step=0.02))
    found = np.column_stack([-run.q[:, 0], surface(run)])
    wanted = of_plate_and_mass(mass, contact, height, run.times)
    np.testing.assert_allclose(found, wanted, rtol=0, atol=1e-6 * height)
    assert run.penetration is not None
    gap = np.where(run.states[:, -1] > 0, 0.0, found[:, 0] - found[:, 1])
    np.testing.assert_allclose(run.penetration, gap, rtol=0, atol=1e-15)


def test_motion_of_the_surface_is_in_the_result() -> None:
    """A body of 1 kg falls 80 mm on 0.6 kg and 4000 N/m: released at 0.19865 s, then it rises to 31.526 mm."""
    contact = {"mass": 0.6, "stiffness": 4000.0, "damping": 0.0}
    done = result_of(falling(0.08, 1.0, contact, duration=0.5, output_step=1e-3, stop=["contact.surface < -0.01"]))
    data = done.data
    assert done.status == "finished"
    assert data["q"].values[200:, 0].max() == pytest.approx(0.0315259, abs=1e-7)
    assert data["surface_displacement"].attrs["units"] == "m"
    assert data["penetration"].values[128:198] == pytest.approx(0.0, abs=0)
    assert done.summary()["contact_force"]["deepest_m"] == data["surface_displacement"].values.max() > 0.01
    inside = simulate_motion(falling(-0.01, 1.0, contact, duration=0.01))
    assert any("10 mm inside" in warning for warning in inside.warnings)
    slope = np.gradient(data["surface_displacement"].values, 1e-3)
    assert data["surface_velocity"].values[140:190] == pytest.approx(slope[140:190], abs=2e-3)
    with pytest.raises(KeyError):
        result_of(falling(0.08, 1.0, {"stiffness": 4000.0, "damping": 0.0}, duration=0.2)).data["surface_velocity"]


def test_bounces_without_end_end_a_run() -> None:
    """Friction of the spring alone pushes a light slider off a heavy surface, which meets it again at once."""
    steep, depth = math.radians(30), 1e-3
    robot = falling(0.0, 0.05, {"mass": 1.0, "stiffness": 1e4, "damping": 1.0, "friction": 0.5,
                                "velocity": [-1.0, 0, 0]}, duration=0.1, output_step=0.05)  # fmt: skip
    run = simulate_motion(robot.with_({
        "joints.z.axis": [math.cos(steep), 0.0, -math.sin(steep)],
        "initial.coordinates": {"z": depth / math.sin(steep)},
    }))  # fmt: skip
    assert run.status == "chattering"
    assert run.times[-1] < 1e-2
