# pyright: reportArgumentType=false, reportCallIssue=false
"""Friction of the whole normal force, the moving mass in it: against H, h and J of the same robot, and energy."""

from __future__ import annotations

import numpy as np
import pytest

from simulation.sheets import TIGHT, ZERO, arm, beam
from tmodes.equations.lagrange.filipovic2010 import CONSISTENT
from tmodes.model.model import Model
from tmodes.robots.load import load
from tmodes.simulation.loop import LoopModel
from tmodes.simulation.plan import planned
from tmodes.simulation.simulate import simulate_motion

ME, BE, KA, F0, MU, VEPS = 1.7, 12.0, 900.0, 3.0, 0.4, 1e-3


def robot(law, *, on_beam=True, method="auto", command="position", **more):
    """An elastic joint, a bending link and, if the tip is not on it, a rigid link, inside of a ball."""
    joints = [
        {"name": "lift", "type": "revolute", "parent": "base", "child": "beam", "axis": [0, -1, 0.2],
         "motor": {"inertia": 0.3, "side": "joint", "resistance": 0.7, "back_emf_constant": 0.4,
                   "torque_constant": 0.5},
         "gear": {"stiffness": 400.0, "damping": 2.0}},
        {"name": "turn", "type": "revolute", "child": "rod", "axis": [0, 0, 1], "origin": {"at": 1.0}},
    ][: 1 if on_beam else 2]  # fmt: skip
    if not on_beam:
        joints[1].pop("origin")
    control = {"type": "pd", "position_gain": 90.0, "velocity_gain": 9.0}
    signal = {"type": "quintic", "start": 0.3, "end": 0.5, "duration": 0.2}
    drives = [
        {
            "joint": "lift",
            "command": command,
            "signal": signal,
            **({"controller": control} if command == "position" else {}),
        },
        {"joint": "turn", "command": "effort", "signal": ZERO},
    ][: 1 if on_beam else 2]
    links = [
        {
            "name": "beam",
            "beam": beam({"bend_z": 2, "bend_y": 1}, 0.8, 60.0, 0.9),
            "bodies": [{"name": "load", "mass": 0.6, "center": [0, 0, 0], "at": 1.0}],
        },
        {"name": "rod", "bodies": [{"name": "bob", "mass": 0.8, "center": [0.3, 0.1, 0.0]}]},
    ][: 1 if on_beam else 2]
    tip = {} if on_beam else {"tip": {"link": "rod", "position": [0.4, 0.1, 0.05]}}
    contact = {"shape": {"type": "ball", "center": [0.1, 0.05, -0.1], "radius": 0.78, "inside": True},
               "law": "dynamic_environment", "stiffness": KA, "damping": BE, "preload": F0, "mass": ME,
               "friction": MU, "friction_velocity": VEPS, "friction_law": law}  # fmt: skip
    settings = {"duration": 0.2, **TIGHT, "method": method} | more
    return arm(gravity=9.81, joints=joints, links=links, drives=drives, contact=contact,
               initial={"state": "zero", "coordinates": {"lift": 0.3, "lift.motor": 0.3}},
               integration=settings, **tip)  # fmt: skip


def states(loop, count, seed=3):
    rng = np.random.default_rng(seed)
    made = 0.4 * rng.standard_normal((count, loop.layout.size))
    made[:, loop.layout.v] *= 4
    return made


@pytest.mark.parametrize("law", ["signed", "magnitude"])
@pytest.mark.parametrize("on_beam", [True, False])
def test_accelerations_and_forces_are_found_together(law, on_beam):
    """H a + h + f = Q - J^T (n + s mu v/sqrt(v.v + veps^2)) Fc with Fc = me x'' + be x' + ka x + F0, in NumPy."""
    sheet = robot(law, on_beam=on_beam)
    found = planned(sheet)
    loop, model = LoopModel(found.plan), Model(found.chain)
    made = states(loop, 12)
    times, rows = np.full(12, 0.1), found.schedule.rows_at(np.full(12, 0.1))
    rates = loop.rate(times, made, rows)
    seen = loop.observe(times, made, rows)
    center, side = np.array([0.1, 0.05, -0.1]), 1.0
    for k in range(12):
        q, v = made[k, loop.layout.q], made[k, loop.layout.v]
        mass, push = model.mass_matrix(q), np.zeros(len(q))
        push[model.motors[0]] = seen["drives"][k, 0, 0]
        load = push - model.bias(q, v) - model.elastic_forces(q, v)
        jacobian = model.jacobian(q[None])[0, -1, :3] if on_beam else model.jacobian(q[None])[0, 0, :3]
        moved = model.points(q[None], v[None], np.zeros((1, len(q))))
        index = moved.position.shape[1] - 1 if on_beam else 0
        place, speed, drift = (x[0, index] for x in (moved.position, moved.velocity, moved.acceleration))
        distance = np.linalg.norm(place - center)
        normal = side * (place - center) / distance
        rate = normal @ speed
        curving = (speed @ speed - rate**2) / distance + normal @ drift
        rest = BE * rate + KA * (distance - 0.78) + F0 + ME * curving
        row = jacobian.T @ normal
        pull = rest + ME * row @ np.linalg.solve(mass, load)
        sign = -1.0 if law == "magnitude" and pull < 0 else 1.0
        along = normal + sign * MU / np.hypot(np.linalg.norm(speed), VEPS) * speed
        fold = 1 + ME * row @ np.linalg.solve(mass, jacobian.T @ along)
        force = pull / fold
        wanted = np.linalg.solve(mass, load - jacobian.T @ along * force)
        scale = np.abs(wanted).max() * np.linalg.cond(mass)
        assert np.abs(rates[k, loop.layout.v] - wanted).max() < 1e-14 * scale
        assert seen["contact"][k, 3] == pytest.approx(force, rel=1e-9, abs=1e-9 * abs(pull))
        assert seen["contact"][k, :3] == pytest.approx(force * along, rel=1e-9, abs=1e-9 * abs(pull))
        assert seen["contact_fold"][k, 0] == pytest.approx(fold, rel=1e-9)


@pytest.mark.parametrize("method", ["auto", "extrapolation", "rosenbrock"])
def test_energy_balances_in_every_method(method):
    sheet = robot("magnitude", method=method, relative_tolerance=1e-9, absolute_tolerance=1e-10)
    run = simulate_motion(sheet)
    best = simulate_motion(robot("magnitude"))
    assert np.abs(run.q[-1] - best.q[-1]).max() < 2e-7
    assert np.abs(run.energy_balance).max() < 1e-6 * run.energy_moved
    assert np.ptp(best.contact_normal) > 1.0


def test_a_motor_with_a_given_motion_feels_the_friction():
    """The power of a motor whose motion is prescribed balances all others."""
    run = simulate_motion(robot("signed", on_beam=False, command="prescribed"))
    assert np.abs(run.energy_balance).max() < 1e-8 * run.energy_moved


@pytest.mark.parametrize("law", ["signed", "magnitude"])
def test_the_recursion_is_the_lagrangian(law):
    """The 2010 robot on its environment: its consistent Lagrangian and the recursion, on random states."""
    sheet, found = load("filipovic2010").with_({"contact.friction_law": law}), []
    for equations in (CONSISTENT.name, "recursion"):
        plan = planned(sheet.with_({"equations": equations}))
        loop, times = LoopModel(plan.plan), np.full(20, 0.3)
        made = states(loop, 20) / 4
        rows = plan.schedule.rows_at(times)
        found.append({"rate": loop.rate(times, made, rows), **loop.observe(times, made, rows)})
    for name, tolerance in {"rate": 1e-12, "contact": 1e-12, "contact_fold": 1e-11, "powers": 1e-12}.items():
        one, other = (values[name] for values in found)
        assert np.abs(one - other).max() < tolerance * np.abs(one).max(), name
