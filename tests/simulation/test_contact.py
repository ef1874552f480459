"""Contact, loads, and a base that moves, against closed forms and written equations."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from simulation.sheets import REFERENCE, TIGHT, ZERO, arm, at_times, beam, landing
from tmodes.simulation.simulate import simulate_motion


def slider(mass, contact, *, axis=(1, 0, 0), gravity=0.0, drive=None, rate=0.0, **more):
    """A mass on a slider."""
    return arm(
        gravity=gravity,
        joints=[{"name": "slide", "type": "prismatic", "parent": "base", "child": "block", "axis": list(axis)}],
        links=[{"name": "block", "bodies": [{"name": "mass", "mass": mass, "center": [0, 0, 0]}]}],
        drives=[{"joint": "slide", "command": "effort", "signal": drive or ZERO}],
        initial={"state": "zero", "rates": {"slide": rate}}, contact=contact, **more,
    )  # fmt: skip


def test_pressed_on_a_surface_with_mass():
    """Fc = me x'' + be x' + ka x + F0 on a mass pushed from rest: the surface's mass moves with the point."""
    p = REFERENCE["h05"]
    wall = {"type": "wall", "distance": 1e-9}
    contact = {"shape": wall, "law": "bilateral", "stiffness": p["ka"], "damping": p["be"], "preload": p["F0"],
               "mass": p["me"]}  # fmt: skip
    push = {"type": "constant", "value": p["Fp"]}
    run = simulate_motion(slider(p["mt"], contact, drive=push, integration={"duration": 0.5, **TIGHT}))
    assert run.contact_normal is not None
    assert run.contact_force is not None
    rows = at_times(run, p["times"])
    assert np.abs(run.q[rows, 0] - p["kappa"]).max() < 2e-9
    assert np.abs(run.contact_normal[rows] - p["Fc"]).max() < 1e-5
    assert np.allclose(run.contact_force[:, 0], run.contact_normal)
    assert np.abs(run.energy_balance).max() < 1e-8 * run.energy_moved


def test_hits_a_wall_and_leaves_it():
    """A mass on a wall that only pushes: half a swing on its spring, then away at the speed that it came with."""
    p = REFERENCE["h01"]
    contact = {"shape": {"type": "plane", "position": [0.1, 0, 0], "normal": [-2, 0, 0]}, "law": "unilateral",
               "stiffness": p["k"], "damping": p["b"]}  # fmt: skip
    settings = {"duration": 0.3, **TIGHT, "output_step": 1e-5}
    run = simulate_motion(slider(p["m"], contact, rate=p["v0"], integration=settings))
    meets = 0.1 / p["v0"]
    assert run.contact_normal is not None
    assert run.penetration is not None
    assert run.penetration.max() == pytest.approx(p["max_penetration"], rel=1e-6)
    assert run.contact_normal.max() == pytest.approx(p["max_force"], rel=1e-6)
    assert run.times[np.argmax(run.penetration)] == pytest.approx(meets + p["t_max_penetration"], abs=2e-5)
    assert run.v[-1, 0] == pytest.approx(p["v_exit"], rel=1e-8)
    assert run.contact_normal.min() == 0.0
    touching = run.times[run.contact_normal > 0]
    assert touching[-1] - touching[0] == pytest.approx(p["t_end"], abs=3e-5)


@pytest.mark.parametrize(("method", "order"), [("rk4", 4), ("midpoint", 2)])
def test_fixed_steps_end_on_touch_and_release(method, order):
    """So a method keeps its order over bounces on a damped spring."""
    exact = simulate_motion(landing(6.0, 8e3, method="dop853", **{**TIGHT, "output_step": 0.05}))
    runs = [simulate_motion(landing(6.0, 8e3, method=method, step=h, output_step=0.05)) for h in (2e-3, 5e-4)]
    errors = [np.abs(run.q - exact.q).max() for run in runs]
    assert np.log2(errors[0] / errors[1]) / 2 == pytest.approx(order, rel=0.2)
    assert {run.statistics["contact_changes"] for run in (exact, *runs)} == {6}


def test_sliding_stops():
    """A block slides on dry friction and stops: the friction is regularised below 1e-4 m/s."""
    p = REFERENCE["h08"]
    # The slider moves along x; the floor is stiff, and pressed by its preload, the block's weight.
    contact = {"shape": {"type": "plane", "position": [0, 0, 0], "normal": [0, 0, 1]}, "law": "bilateral",
               "stiffness": 1.0, "damping": 0.0, "preload": p["m"] * p["g"], "friction": p["mu"],
               "friction_velocity": 1e-4}  # fmt: skip
    run = simulate_motion(slider(p["m"], contact, rate=p["v0"], integration={
        "duration": 0.5, "output_step": 1e-3, "relative_tolerance": 1e-8, "absolute_tolerance": 1e-10}))  # fmt: skip
    assert run.q[-1, 0] == pytest.approx(p["x_stop"], rel=1e-3)
    stopped = run.times[run.v[:, 0] > 1e-3][-1]
    assert stopped == pytest.approx(p["t_stop"], abs=2e-3)
    assert np.abs(run.energy_balance).max() < 1e-6 * run.energy_moved


def test_pressed_statically():
    """A gear, a beam and a wall in series: F = L phi / (1/kw + L^3/3EI + L^2/kg)."""
    p = REFERENCE["h12"]
    length = p["L"]
    contact = {"shape": {"type": "plane", "position": [0, 0, 0], "normal": [0, -1, 0]}, "law": "bilateral",
               "stiffness": p["kw"], "damping": 0.0}  # fmt: skip
    phi = 1e-4
    joint = {"name": "root", "type": "revolute", "parent": "base", "child": "beam", "axis": [0, 0, 1],
             "motor": {"inertia": 0.1, "side": "joint"}, "gear": {"stiffness": p["kg"], "damping": 0.5}}  # fmt: skip
    drive = {"joint": "root", "command": "prescribed", "signal": {"type": "constant", "value": phi}}
    run = simulate_motion(arm(
        gravity=0.0, joints=[joint], drives=[drive], contact=contact,
        links=[{"name": "beam", "beam": beam({"bend_z": 3}, length, p["EI"], 0.5, basis="tip_weighted")}],
        integration={"duration": 0.01, "output_step": 0.01},
    ))  # fmt: skip
    wanted = length * phi / (1 / p["kw"] + length**3 / (3 * p["EI"]) + length**2 / p["kg"])
    assert wanted == pytest.approx(p["F"] * phi / p["phi"], rel=1e-9)
    assert run.contact_normal == pytest.approx(wanted, rel=1e-6)
    assert run.gear_torque[:, 0] == pytest.approx(wanted * length, rel=1e-6)


@pytest.mark.parametrize(("method", "tolerance"), [("auto", 1e-12), ("extrapolation", 1e-10)])
@pytest.mark.parametrize("inside", [True, False])
def test_bob_on_a_ball(inside, method, tolerance):
    """A pendulum of two joints held to a ball with a mass of its own, written in polar terms of the ball's center."""
    center = np.array([0.2, 0.0, 0.1]) if inside else np.array([1.6, 0.0, 0.0])
    radius = 0.8 if inside else 0.6
    contact = {"shape": {"type": "ball", "center": center.tolist(), "radius": radius, "inside": inside},
               "law": "bilateral", "stiffness": 900.0, "damping": 4.0, "preload": 3.0, "mass": 1.5}  # fmt: skip
    joints = [
        {"name": "x", "type": "prismatic", "parent": "base", "child": "a", "axis": [1, 0, 0]},
        {"name": "z", "type": "prismatic", "child": "b", "axis": [0, 0, 1]},
    ]
    body = {"name": "bob", "mass": 2.0, "center": [0, 0, 0]}
    drives = [{"joint": name, "command": "effort", "signal": ZERO} for name in "xz"]
    run = simulate_motion(arm(
        gravity=9.81, joints=joints, links=[{"name": "b", "bodies": [body]}], drives=drives, contact=contact,
        initial={"state": "zero", "coordinates": {"x": 0.95}, "rates": {"z": 1.0}},
        integration={"duration": 1.0, "output_step": 0.01, "method": method, "relative_tolerance": tolerance,
                     "absolute_tolerance": tolerance / 10},
    ))  # fmt: skip
    side = 1.0 if inside else -1.0

    def rate(t, y):
        place, velocity = y[:2] - center[[0, 2]], y[2:]
        distance = np.hypot(*place)
        along = side * place / distance
        speed = along @ velocity
        curving = side * (velocity @ velocity - speed**2) / distance
        rest = 1.5 * curving + 4 * speed + 900 * side * (distance - radius) + 3
        mass = 2.0 * np.eye(2) + 1.5 * np.outer(along, along)
        return [*velocity, *np.linalg.solve(mass, np.array([0, -2 * 9.81]) - rest * along)]

    found = solve_ivp(rate, (0, 1), [0.95, 0, 0, 1], "DOP853", run.times, rtol=1e-12, atol=1e-13).y.T
    assert np.abs(run.q - found[:, :2]).max() < 1e-9
    assert np.abs(run.energy_balance).max() < 1e-8 * run.energy_moved


def link_under(load, **more):
    """A bob of 2 kg on an arm of 0.5 m that turns about z, free, under a load."""
    return arm(
        joints=[{"name": "turn", "type": "revolute", "parent": "base", "child": "rod", "axis": [0, 0, 1]}],
        links=[{"name": "rod", "bodies": [{"name": "bob", "mass": 2.0, "center": [0.5, 0, 0]}]}],
        tip={"link": "rod", "position": [0.5, 0, 0]}, loads=[load] if load else [],
        drives=[{"joint": "turn", "command": "effort", "signal": ZERO}],
        **{"gravity": 0.0, "initial": {"state": "zero"}, "integration": {"duration": 1.0, **TIGHT}, **more},
    )  # fmt: skip


@pytest.mark.parametrize("frame", ["world", "section"])
def test_loads_dead_and_following(frame):
    """A force times a signal on the tip: one keeps its direction, the other turns with the link."""
    signal = {"type": "sine", "amplitude": 1.0, "frequency": 0.5}
    load = {"point": "tip", "force": [0, 3.0, 0], "moment": [0, 0, 0.2], "frame": frame, "signal": signal}
    run = simulate_motion(link_under(load))

    def rate(t, y):
        lever = 0.5 if frame == "section" else 0.5 * np.cos(y[0])
        return [y[1], np.sin(np.pi * t) * (3 * lever + 0.2) / 0.5]

    found = solve_ivp(rate, (0, 1), [0, 0], "DOP853", run.times, rtol=1e-12, atol=1e-13).y.T
    assert np.abs(run.q[:, 0] - found[:, 0]).max() < 1e-9
    assert np.abs(run.energy_balance).max() < 1e-9 * run.energy_moved


def test_base_that_shakes_and_turns():
    """A free link on a base that travels and turns: written in the inertial frame; the base's work is reported."""
    travel = {"type": "expression", "formula": "0.1*sin(5*t)"}
    turn = {"type": "expression", "formula": "0.4*t**2"}
    run = simulate_motion(link_under(None, base_motion={"x": travel, "yaw": turn}, initial={
        "state": "zero", "coordinates": {"turn": 1.0}}))  # fmt: skip

    # psi = angle in space; the pivot accelerates by -2.5 sin(5 t) along x: psi'' = -x'' (-sin psi)/l.
    def space(t, y):
        return [y[1], -2.5 * np.sin(5 * t) * np.sin(y[0]) / 0.5]

    found = solve_ivp(space, (0, 1), [1.0, 0.0], "DOP853", run.times, rtol=1e-12, atol=1e-13).y.T
    assert np.abs(run.q[:, 0] + 0.4 * run.times**2 - found[:, 0]).max() < 1e-8
    tip = np.column_stack([0.1 * np.sin(5 * run.times) + 0.5 * np.cos(found[:, 0]), 0.5 * np.sin(found[:, 0])])
    assert np.abs(run.points.position[:, 0, :2] - tip).max() < 1e-8
    assert np.abs(run.works["base"]).max() > 0.01
    assert np.abs(run.energy_balance).max() < 1e-8 * run.energy_moved


def test_base_turning_in_space():
    """Roll, pitch and yaw at once: the tip's velocity and acceleration are the derivatives of its place."""
    motion = {"roll": "0.3*sin(2*t)", "pitch": "0.2*t**2", "yaw": "0.5*sin(3*t)", "z": "0.1*t**3"}
    signals = {name: {"type": "expression", "formula": formula} for name, formula in motion.items()}
    sheet = link_under(None, base_motion=signals, base={"position": [0.1, 0.2, 0.3], "rpy": [0.4, 0.5, 0.6]},
                       gravity=9.81, integration={"duration": 0.5, **TIGHT, "output_step": 1e-3})  # fmt: skip
    run = simulate_motion(sheet)
    place, h = run.points.position[:, 0], 1e-3
    middle = slice(2, -2)
    slope = (place[:-4] - 8 * place[1:-3] + 8 * place[3:-1] - place[4:]) / (12 * h)
    bend = (-place[:-4] + 16 * place[1:-3] - 30 * place[2:-2] + 16 * place[3:-1] - place[4:]) / (12 * h * h)
    assert np.abs(run.points.velocity[middle, 0] - slope).max() < 1e-8
    assert np.abs(run.points.acceleration[middle, 0] - bend).max() < 1e-5
    assert np.abs(run.energy_balance).max() < 1e-8 * run.energy_moved
