"""Dry friction that is a set at rest: onset and end of slip are located, and what sticks does not creep."""

from __future__ import annotations

import math
from functools import cache
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

from simulation.sheets import arm
from tmodes.equations.recursion.drive_kernels import LOCK
from tmodes.errors import InputError, TmodesError
from tmodes.gradients.gradient import forward_sensitivities
from tmodes.model.model import Model
from tmodes.sheet import Robot
from tmodes.simulation.motion_run import RunData
from tmodes.simulation.simulate import simulate_motion
from tmodes.simulation.vary.simulate import simulate_batch

METHODS = ("dormand_prince", "dop853", "rk4", "extrapolation", "midpoint", "rosenbrock")

fast = settings(max_examples=12, deadline=None)
angles, shares = st.floats(3.0, 40.0), st.floats(0.05, 0.95)
masses = st.floats(0.1, 50.0)
speeds = st.one_of(st.just(0.0), st.floats(0.01, 2.0), st.floats(-2.0, -0.01))


def block(mass: float, friction: dict[str, float], gravity: Any = 0.0, **more: Any) -> Robot:
    """A mass that slides along x."""
    signal = more.pop("signal", {"type": "constant", "value": 0.0})
    return arm(
        gravity=gravity,
        joints=[{"name": "x", "type": "prismatic", "parent": "base", "child": "block", "axis": [1, 0, 0],
                 "friction": {"viscous": 0.0, **friction}}],
        links=[{"name": "block", "bodies": [{"name": "mass", "mass": mass, "center": [0, 0, 0]}]}],
        tip={"link": "block", "position": [0, 0, 0]},
        drives=[{"joint": "x", "command": "effort", "signal": signal}], **more,
    )  # fmt: skip


def incline(angle: float, mu_s: float, mu_k: float, mass: float, speed: float) -> RunData:
    """With default settings; x down the slope."""
    down, normal = 9.81 * math.sin(angle), mass * 9.81 * math.cos(angle)
    friction = {"coulomb": mu_k * normal, "static_extra": (mu_s - mu_k) * normal}
    start = {"state": "zero", "rates": {"x": speed}}
    return simulate_motion(
        block(mass, friction, [down, 0, -9.81], initial=start, integration={"duration": 2.0, "output_step": 0.1})
    )


def on_incline(times: np.ndarray, angle: float, mu_s: float, mu_k: float, speed: float) -> np.ndarray:
    """In closed form, piece by piece."""
    down, rub = 9.81 * math.sin(angle), 9.81 * mu_k * math.cos(angle)
    place, start, x = 0.0, 0.0, np.zeros_like(times)
    for _ in range(3):
        side = math.copysign(1.0, speed) if speed else 1.0
        pull = down - side * rub
        if speed == 0.0 and math.tan(angle) <= mu_s:
            pull = 0.0
        end = -speed / pull if speed * pull < 0 else math.inf
        here = (times >= start) & (times <= start + end)
        x[here] = (place + speed * (times - start) + pull * (times - start) ** 2 / 2)[here]
        if end == math.inf:
            break
        place, start, speed = place + speed * end + pull * end**2 / 2, start + end, 0.0
    return x


@fast
@given(angle=angles, slack=shares, drop=shares, mass=masses, speed=speeds)
def test_a_block_on_an_incline_moves_in_closed_form(
    angle: float, slack: float, drop: float, mass: float, speed: float
) -> None:
    turn, mu_s = math.radians(angle), 1.8 * slack * math.tan(math.radians(angle))
    run = incline(turn, mu_s, drop * mu_s, mass, speed)
    wanted = on_incline(run.times, turn, mu_s, drop * mu_s, speed)
    np.testing.assert_allclose(run.q[:, 0], wanted, rtol=1e-6, atol=1e-9)


@fast
@given(angle=angles, slack=st.floats(1.001, 3.0), mass=masses)
def test_below_the_friction_angle_nothing_creeps(angle: float, slack: float, mass: float) -> None:
    turn = math.radians(angle)
    run = incline(turn, slack * math.tan(turn), 0.5 * math.tan(turn), mass, 0.0)
    assert np.abs(run.q).max() < 1e-20


def test_a_steep_incline_accelerates_from_the_first_sample_on() -> None:
    run = incline(0.7, 0.3, 0.2, 1.0, 0.0)
    assert run.a[0, 0] == pytest.approx(9.81 * (math.sin(0.7) - 0.2 * math.cos(0.7)), rel=1e-12)


def shaken(mass: float, friction: dict[str, float], size: float, rate: float, method: str | None = None) -> RunData:
    """A block under a force of one frequency [Hz]."""
    chosen: dict[str, Any] = {"duration": 2.0, "output_step": 0.02}
    chosen |= {"method": method, "step": 5e-4} if method else {}
    signal = {"type": "sine", "amplitude": size, "frequency": rate}
    return simulate_motion(block(mass, friction, signal=signal, integration=chosen))


def law_apart(times: np.ndarray, mass: float, friction: dict[str, float], size: float, rate: float) -> np.ndarray:
    """The same law with another solver, each phase to its end."""
    level, limit = friction["coulomb"], friction["coulomb"] + friction["static_extra"]
    viscous, turn = friction["viscous"], 2 * math.pi * rate
    tight: dict[str, Any] = {"method": "DOP853", "rtol": 1e-12, "atol": 1e-13, "dense_output": True, "max_step": 0.01}

    def force(t: float) -> float:
        return size * math.sin(turn * t)

    t, x, side, found = 0.0, 0.0, 0, np.zeros_like(times)
    while t < times[-1]:
        if not side:

            def left(s: float, _: Any) -> float:
                return limit - abs(force(s))

            left.terminal = True  # type: ignore[attr-defined]
            done = solve_ivp(lambda s, _: [0.0], (t, times[-1]), [0.0], events=left, **tight)
            here = (times >= t) & (times <= done.t[-1])
            found[here], t = x, float(done.t[-1])
            side = int(math.copysign(1, force(t)))
            continue

        def speed(s: float, y: Any) -> float:
            return y[1] * side if s > t + 1e-12 else 1.0  # noqa: B023

        speed.terminal, speed.direction = True, -1  # type: ignore[attr-defined]
        done = solve_ivp(
            lambda s, y: [y[1], (force(s) - side * level - viscous * y[1]) / mass],  # noqa: B023
            (t, times[-1]), [x, 0.0], events=speed, **tight,
        )  # fmt: skip
        here = (times >= t) & (times <= done.t[-1])
        found[here], t, x = done.sol(times[here])[0], float(done.t[-1]), float(done.y[0, -1])
        side = 0 if abs(force(t)) <= limit else -side
    return found


@fast
@given(mass=masses, level=st.floats(0.5, 10.0), extra=st.floats(0.0, 5.0), rate=st.floats(0.3, 2.0), over=shares)
def test_a_shaken_block_sticks_and_slips_as_the_law_says(
    mass: float, level: float, extra: float, rate: float, over: float
) -> None:
    friction = {"coulomb": level, "static_extra": extra, "viscous": 0.2 * mass}
    size = (level + extra) * (1.02 + 2 * over)
    run = shaken(mass, friction, size, rate)
    assert run.status == "finished"
    assert not run.warnings
    wanted = law_apart(run.times, mass, friction, size, rate)
    assert np.abs(run.q[:, 0] - wanted).max() < 1e-6 * np.abs(wanted).max()


@pytest.mark.parametrize("method", METHODS)
def test_every_method_locates_the_switches(method: str) -> None:
    """Reference values computed with closed forms in pieces."""
    friction = {"coulomb": 3.0, "static_extra": 1.0}
    run = shaken(1.0, friction, 5.0, 1.0, method)
    stroke = 0.08976932774870089
    assert np.abs(run.q[[55, 80], 0] - [0.0, stroke]).max() < 1e-6 * stroke
    assert run.statistics["switches"] == 7
    assert set(np.unique(run.states[:, run.setup.model.layout.modes])) <= {-1.0, 0.0, 1.0}


def geared(method: str | None = None, **more: Any) -> Robot:
    """Two links behind elastic gears, dry friction in all motors and joints, one with Stribeck's curve."""
    rub = {"viscous": 0.1, "coulomb": 1.0, "static_extra": 0.4}
    origins = ([0.0, 0.0, 0.0], [0.5, 0.0, 0.0])
    joints = [
        {"name": f"j{k}", "type": "revolute", "parent": parent, "child": child, "axis": [0, 1, 0],
         "origin": {"position": origin}, "motor": {"inertia": 0.3, "side": "joint", "friction": rub},
         "gear": {"stiffness": 800.0, "damping": 1.0}, "friction": {**rub, **({"stribeck_rate": 0.05} if k else {})}}
        for k, (parent, child, origin) in enumerate(zip(("base", "a"), "ab", origins, strict=True))
    ]  # fmt: skip
    inertia = dict.fromkeys(("xx", "yy", "zz"), 0.05)
    links = [{"name": n, "bodies": [{"name": f"{n}m", "mass": 2.0, "center": [0.4, 0, 0], "inertia": inertia}]}
             for n in "ab"]  # fmt: skip
    drives = [
        {"joint": f"j{k}", "command": "torque", "signal": {"type": "sine", "amplitude": size, "frequency": rate}}
        for k, (size, rate) in enumerate(((9.0, 0.7), (3.0, 1.1)))
    ]
    chosen = {"duration": 1.0, "output_step": 0.02, **({"method": method, "step": 1e-3} if method else {}), **more}
    return arm(gravity=0.0, joints=joints, links=links, tip={"link": "b", "position": [0.5, 0, 0]}, drives=drives,
               integration=chosen)  # fmt: skip


@cache
def exact() -> RunData:
    return simulate_motion(geared("dop853", relative_tolerance=1e-12, absolute_tolerance=1e-13))


@pytest.mark.parametrize("method", [None, "dop853", "extrapolation", "rk4"])
def test_all_methods_agree_where_several_stick_at_once(method: str | None) -> None:
    run, wanted = simulate_motion(geared(method)), exact()
    stuck = wanted.states[:, wanted.setup.model.layout.modes] == 0
    assert (stuck.sum(axis=1) > 1).any()
    assert np.abs(run.q - wanted.q).max() < 2e-6
    assert run.statistics["switches"] == wanted.statistics["switches"] > 5
    assert np.abs(run.energy_balance).max() < 1e-6 * run.energy_moved


def test_what_sticks_needs_the_force_that_is_shown() -> None:
    """While a motor sticks, its friction bears effort and gear; while a joint sticks, gear and the inertia of links."""
    run = exact()
    model, layout = run.setup.model, run.setup.model.layout
    seen = model.observe(run.times, run.states, run.planned.schedule.rows_at(run.times))
    motor = run.states[:, layout.modes][:, 0] == 0
    held = LOCK * seen["a"][motor, 0]
    np.testing.assert_allclose(held, (run.effort - run.gear_torque)[motor, 0], rtol=0, atol=1e-9)
    assert np.abs(held).max() <= 1.4 + 1e-9


def test_a_model_by_itself_slips_as_its_rates_say() -> None:
    model = Model(geared().chain())
    v = np.array([0.3, -0.2, 0.0, 0.4])  # motors, then joints
    rubbed = 0.1 * v + (1.0 + np.array([0, 0, 0, 0.4 / (1 + 0.4**2 / 0.05**2)])) * np.sign(v)
    gears = np.repeat([1.0, -1.0], 2) * np.tile(v[:2] - v[2:], 2)
    np.testing.assert_allclose(model.elastic_forces(0 * v, v), rubbed + gears, rtol=0, atol=1e-12)


def test_runs_of_a_batch_are_single_runs() -> None:
    sheet = geared(duration=0.3)
    batch = simulate_batch(sheet, {"joints.j0.friction.coulomb": [0.4, 2.0]})
    for lane, value in enumerate([0.4, 2.0]):
        one = simulate_motion(sheet.with_({"joints.j0.friction.coulomb": value}))
        np.testing.assert_array_equal(batch.states[lane], one.states)


def test_derivatives_of_a_run_ask_for_a_smooth_friction() -> None:
    with pytest.raises(InputError, match=r"joints\.x\.friction.*smoothing"):
        forward_sensitivities(block(1.0, {"coulomb": 1.0}), ["links.0.bodies.0.mass"])


def test_a_python_controller_asks_for_a_smooth_friction() -> None:
    """Its loop locates no switches: what sticks at the start would stick for ever."""
    with pytest.raises(InputError, match=r"joints\.x\.friction.*smoothing"):
        simulate_motion(block(1.0, {"coulomb": 1.0}), controller=lambda time, q, v: [5.0])


def on_floor(gravity: Any, normal: float, law: dict[str, Any], **more: Any) -> Robot:
    """A block of 1 kg that lies on a floor with this force [N], free along x, y and z; a spring along x if given."""
    names, axes, spring = ("x", "y", "z"), np.eye(3).tolist(), more.pop("spring", None)
    parents, zero = ("base", "l0", "l1"), {"type": "constant", "value": 0.0}
    joints = [{"name": n, "type": "prismatic", "parent": p, "child": f"l{k}", "axis": axis}
              for k, (n, p, axis) in enumerate(zip(names, parents, axes, strict=True))]  # fmt: skip
    if spring:
        joints[0] |= {"state": "locked", "gear": {"stiffness": spring, "damping": 0.0}}
    links = [{"name": "l0", "bodies": []}, {"name": "l1", "bodies": []},
             {"name": "l2", "bodies": [{"name": "mass", "mass": 1.0, "center": [0, 0, 0]}]}]  # fmt: skip
    signals = {name: {"command": "effort", "signal": more.pop(name, zero)} for name in names[bool(spring) :]}
    start = {"state": "zero", "coordinates": {"z": -normal / 1e6}, "rates": more.pop("rates", {})}
    floor = {"type": "plane", "position": [0, 0, 0], "normal": [0, 0, 1]}
    return arm(
        gravity=gravity, joints=joints, links=links, tip={"link": "l2", "position": [0, 0, 0]},
        drives=[{"joint": name, **drive} for name, drive in signals.items()], initial=start,
        contact={"law": "unilateral", "point": "tip", "shape": floor, "stiffness": 1e6, "damping": 2e3, **law}, **more,
    )  # fmt: skip


@fast
@given(turn=st.floats(0.0, 6.2), speed=st.floats(0.1, 2.0), mu=st.floats(0.05, 0.8), heading=st.floats(0.0, 6.2))
def test_a_block_on_a_belt_comes_to_rest_along_a_straight_line(
    turn: float, speed: float, mu: float, heading: float
) -> None:
    """Against the belt it moves against its slip, in space."""
    belt = 0.3 * np.array([math.cos(heading), math.sin(heading), 0.0])
    way, pull = np.array([math.cos(turn), math.sin(turn)]), 9.81 * mu
    start = belt[:2] + speed * way
    law = {"friction": mu, "static_friction": 1.2 * mu, "velocity": belt.tolist()}
    settings_ = {"duration": 1.0, "output_step": 0.05}
    rates = {"x": float(start[0]), "y": float(start[1])}
    run = simulate_motion(on_floor(9.81, 9.81, law, rates=rates, integration=settings_))
    slid = np.minimum(run.times, speed / pull)
    along = (speed * slid - pull * slid**2 / 2)[:, None] * way + run.times[:, None] * belt[:2]
    np.testing.assert_allclose(run.q[:, :2], along, rtol=0, atol=1e-7 * speed)


@pytest.mark.parametrize("method", [None, "dop853", "extrapolation", "rosenbrock"])
def test_below_the_friction_angle_a_contact_does_not_creep(method: str | None) -> None:
    turn = math.radians(15)
    chosen = {"duration": 10.0, "output_step": 1.0, **({"method": method} if method else {})}
    gravity = [9.81 * math.sin(turn), 0.0, -9.81 * math.cos(turn)]
    law = {"friction": 0.25, "static_friction": 0.3}
    run = simulate_motion(on_floor(gravity, -gravity[2], law, integration=chosen))
    assert run.status == "finished"
    assert np.abs(run.q[:, :2]).max() < 1e-10
    assert run.contact_force is not None
    assert run.contact_force[-1, 0] == pytest.approx(gravity[0], rel=1e-6)


@pytest.mark.parametrize("method", [None, "extrapolation"])
def test_a_stick_slip_oscillator_on_a_belt(method: str | None) -> None:
    """Reference values computed with closed forms in pieces."""
    chosen = {"duration": 4.0, "output_step": 0.4, **({"method": method} if method else {})}
    law = {"friction": 0.4, "static_friction": 0.6, "velocity": [0.05, 0.0, 0.0]}
    run = simulate_motion(on_floor(20.0, 20.0, law, spring=100.0, rates={"x": 0.05}, integration=chosen))
    wanted = [0.02, 0.04, 0.06, 0.08, 0.1, 0.12, 0.04304848678658342, 0.06304848678658344, 0.08304848678658343,
              0.10304848678658343]  # fmt: skip
    np.testing.assert_allclose(run.q[1:, 0], wanted, rtol=0, atol=1e-6 * 0.12)


def test_the_direction_of_a_slip_stays_a_unit_vector() -> None:
    """Step by step, by rows of steps too: a slip that has almost come to rest has no other direction than that."""
    chosen = {"duration": 0.4, "output_step": 2e-3, "method": "extrapolation"}
    law = {"friction": 0.1, "velocity": [0.05, -0.02, 0.0]}
    rates = {"y": 0.3, "x": 0.1}
    run = simulate_motion(on_floor(9.81, 9.81, law, spring=5e3, rates=rates, integration=chosen))
    sizes = np.linalg.norm(run.states[:, run.setup.model.layout.modes], axis=1)
    moving = sizes > 0.5
    assert moving.sum() > 100
    np.testing.assert_allclose(sizes[moving], 1.0, rtol=0, atol=1e-15)
    assert run.statistics["rejected"] < run.statistics["steps"]


def test_derivatives_ask_for_a_smooth_friction_of_a_contact() -> None:
    with pytest.raises(InputError, match=r"contact\.friction_velocity"):
        forward_sensitivities(on_floor(9.81, 9.81, {"friction": 0.2}), ["contact.stiffness"])


def smoothed(width: float, **chosen: Any) -> RunData:
    """A block on a slope below its friction angle, friction smoothed."""
    turn = math.radians(15)
    gravity = [9.81 * math.sin(turn), 0.0, -9.81 * math.cos(turn)]
    law = {"friction": 0.3, "friction_velocity": width}
    return simulate_motion(
        on_floor(gravity, -gravity[2], law, integration={"duration": 2.0, "output_step": 0.1, **chosen})
    )


@pytest.mark.parametrize(("width", "method"), [(1e-3, "dormand_prince"), (1e-6, "rosenbrock")])
def test_auto_takes_stiff_friction_at_the_end_of_a_step(width: float, method: str) -> None:
    """It creeps at v where 0.3 v/sqrt(v^2 + width^2) = tan 15 degrees, down."""
    run = smoothed(width)
    share = math.tan(math.radians(15)) / 0.3
    assert (run.status, run.statistics["method"]) == ("finished", method)
    assert run.q[-1, 0] == pytest.approx(2.0 * width * share / math.sqrt(1 - share**2), rel=2e-2)


@pytest.mark.parametrize("method", ["extrapolation", "rosenbrock"])
@pytest.mark.parametrize("rub", [{"smoothing": 1e-5}, {}])
def test_implicit_steps_do_not_pass_over_narrow_friction(method: str, rub: dict[str, float]) -> None:
    """Stribeck's peak of 1e-4 rad/s, in a motion of 1 rad/s."""
    friction = {"viscous": 0.0, "coulomb": 3.0, "static_extra": 5.0, "stribeck_rate": 1e-4, **rub}
    inertia = dict.fromkeys(("xx", "yy", "zz"), 0.5)

    def run(method: str, **more: Any) -> RunData:
        return simulate_motion(arm(
            gravity=0.0,
            joints=[{"name": "j", "type": "revolute", "parent": "base", "child": "l", "axis": [0, 0, 1],
                     "motor": {"inertia": 0.1, "side": "joint"}, "gear": {"stiffness": 200.0, "damping": 0.5},
                     "friction": friction}],
            links=[{"name": "l", "bodies": [{"name": "b", "mass": 1.0, "center": [0, 0, 0], "inertia": inertia}]}],
            tip={"link": "l", "position": [0, 0, 0]},
            drives=[{"joint": "j", "command": "prescribed",
                     "signal": {"type": "table", "times": [0, 1], "values": [0, 0.2], "interpolation": "linear"}}],
            integration={"duration": 1.0, "output_step": 0.02, "method": method, **more},
        ))  # fmt: skip

    wanted = run("dop853", relative_tolerance=1e-10, absolute_tolerance=1e-11)
    assert np.abs(run(method).q - wanted.q).max() < 5e-4
    loose = run(method, relative_tolerance=1e-4, absolute_tolerance=1e-6)
    assert np.abs(loose.q - wanted.q).max() < 1e-2


def test_a_motion_with_energy_from_nowhere_has_not_finished() -> None:
    run = smoothed(1e-6, method="rk4", step=1e-3)
    assert run.status == "diverged"


@pytest.mark.parametrize(("method", "mass"), [("dormand_prince", 0.2), ("rk4", 0.2), ("extrapolation", 0.0)])
def test_a_joint_and_its_tip_stick_at_once(method: str, mass: float) -> None:
    """On a rough floor: the joint bears its weight's share and holds the tip; no force comes from nowhere."""
    floor = {"type": "plane", "position": [0, 0, -0.02], "normal": [0, 0, 1]}
    run = simulate_motion(arm(
        gravity=9.81, tip={"link": "l", "position": [0.5, 0, 0]},
        joints=[{"name": "j", "type": "revolute", "child": "l", "axis": [0, -1, 0],
                 "motor": {"inertia": 0.1, "side": "joint"}, "gear": {"stiffness": 120.0, "damping": 0.5},
                 "friction": {"viscous": 0.1, "coulomb": 0.2, "static_extra": 0.1}}],
        links=[{"name": "l", "bodies": [{"name": "m", "mass": 2.0, "center": [0.4, 0, 0]}]}],
        drives=[{"joint": "j", "command": "prescribed", "signal": {"type": "constant", "value": 0.0}}],
        contact={"law": "unilateral", "shape": floor, "stiffness": 2e3, "damping": 20.0, "mass": mass,
                 "friction": 0.3, "static_friction": 0.5},
        integration={"duration": 0.1, "output_step": 0.02, "method": method, "step": 1e-3},
    ))  # fmt: skip
    assert run.status == "finished"
    assert np.abs(run.q - run.q[0]).max() < 1e-12
    assert run.contact_force is not None
    assert run.contact_normal is not None
    assert np.abs(run.contact_force[:, :2]).max() < 1e-9
    assert run.contact_force[:, 2] == pytest.approx(-run.contact_normal, rel=1e-9)


def test_friction_of_a_flat_block_by_its_normal_force() -> None:
    """Coefficients under 10 N as by their forces; under its weight the block stops in closed form."""
    flat = {"normal_force": 10.0, "coefficient": 0.3, "static_coefficient": 0.4, "viscous": 0.0}
    forces = {"coulomb": 3.0, "static_extra": 1.0}
    one, other = (shaken(1.0, rub, 5.0, 1.0) for rub in (flat, forces))
    np.testing.assert_allclose(one.q, other.q, rtol=0, atol=1e-12)
    p = {"m": 2.0, "mu": 0.35, "v0": 1.2, "t": 0.3494975972040192, "x": 0.20969855832241152}  # closed form
    slide = block(p["m"], {"normal_force": p["m"] * 9.81, "coefficient": p["mu"]},
                  initial={"state": "zero", "rates": {"x": p["v0"]}}, integration={"duration": 1.0})  # fmt: skip
    run = simulate_motion(slide)
    assert run.q[-1, 0] == pytest.approx(p["x"], abs=1e-9)
    assert run.changes[0].time == pytest.approx(p["t"], abs=1e-9)


@pytest.mark.parametrize(
    ("rub", "which"),
    [
        ({"normal_force": 10.0}, r"friction\.coefficient"),
        ({"coefficient": 0.3}, r"friction\.normal_force"),
        ({"static_coefficient": 0.3}, r"friction\.coefficient"),
        ({"normal_force": 10.0, "coefficient": 0.3, "coulomb": 1.0}, r"friction\.coulomb"),
        ({"normal_force": 10.0, "coefficient": 0.3, "static_coefficient": 0.2}, r"friction\.static_coefficient"),
        ({"normal_force": -1.0, "coefficient": 0.3}, r"friction\.normal_force"),
    ],
)
def test_normal_forces_that_are_none(rub: dict[str, float], which: str) -> None:
    with pytest.raises(TmodesError, match=which):
        block(1.0, rub)


def test_a_normal_force_is_of_a_slide_alone() -> None:
    rub = {"viscous": 0.0, "normal_force": 10.0, "coefficient": 0.3}
    with pytest.raises(TmodesError, match=r"joints\.x\.friction\.normal_force"):
        block(1.0, rub).with_({"joints.x.type": "revolute"})
    with pytest.raises(TmodesError, match=r"joints\.x\.motor\.friction\.normal_force"):
        block(1.0, {}).with_({"joints.x.motor": {"inertia": 1.0, "side": "joint", "friction": rub}})
