"""Gears with play: free flight, the blow at its end, teeth that part again, energy, every method, batches, modes."""

from __future__ import annotations

import os
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

from lane_runs import simulate_lanes
from random_chains import random_body
from simulation.sheets import arm
from tmodes.analysis.modes.of_sheet import vibrations
from tmodes.compile.loops.gate import SHORTEST
from tmodes.errors import SimulationError
from tmodes.gradients.gradient import forward_sensitivities
from tmodes.sheet import Robot
from tmodes.simulation.initial_state import run_setup
from tmodes.simulation.problem import problem_of
from tmodes.simulation.simulate import simulate_motion
from tmodes.simulation.solve import solve

METHODS = ["dormand_prince", "dop853", "rosenbrock", "extrapolation", "rk4", "midpoint"]


def geared(gear: dict[str, float], motor: float = 0.01, load: float = 0.02, rate: float = 1.0, **run: Any) -> Robot:
    """A motor that turns towards a load, through the play."""
    torque = {"type": "constant", "value": run.pop("torque", 0.0)}
    return arm(
        gravity=0.0,
        joints=[{"name": "j", "type": "revolute", "child": "load", "axis": [0, 0, 1],
                 "motor": {"inertia": motor, "side": "joint"}, "gear": {"damping": 0.0, **gear}}],
        links=[{"name": "load", "bodies": [{"mass": 1.0, "inertia": load}]}],
        tip={"link": "load", "position": [1, 0, 0]},
        drives=[{"joint": "j", "command": "torque", "signal": torque}],
        initial={"state": "zero", "rates": {"j.motor": rate}}, integration=run,
    )  # fmt: skip


def law_apart(sheet: Robot, times: np.ndarray, torque: float = 0.0) -> np.ndarray:
    """Motor and load (n, 4) by an ODE solver that stops where teeth meet, and where they part."""
    gear = sheet.joints[0].gear
    assert gear is not None
    k, c, play = gear.stiffness[0], gear.damping, gear.backlash
    inertias = sheet.joints[0].motor.inertia, 0.02  # pyright: ignore[reportOptionalMemberAccess]

    def push(s: np.ndarray, side: int) -> float:
        return k * (side * (s[0] - s[2]) - play) + c * side * (s[1] - s[3])

    def apart(s: np.ndarray) -> float:
        return max(min(side * (s[0] - s[2]) - play, push(s, side)) for side in (1, -1))

    state, now, side, found = np.array([0.0, 1.0, 0.0, 0.0]), 0.0, 0, np.empty((0, 4))
    while len(found) < len(times):
        here = side

        def rate(_: float, s: np.ndarray) -> list[float]:
            force = here * push(s, here) if here else 0.0  # noqa: B023
            return [s[1], (torque - force) / inertias[0], s[3], force / inertias[1]]

        def end(_: float, s: np.ndarray) -> float:
            return push(s, here) if here else -apart(s)  # noqa: B023

        end.terminal, end.direction = True, -1  # pyright: ignore[reportFunctionMemberAccess]
        part = solve_ivp(rate, (now, times[-1]), state, "DOP853", times[len(found) :], events=end, max_step=1e-3,
                         rtol=1e-12, atol=1e-14)  # fmt: skip
        found = np.concatenate([found, np.asarray(part.y).T.reshape(-1, 4)])
        if part.status == 1:
            now, state = part.t_events[0][0], part.y_events[0][0]
            side = 0 if side else int(np.sign(state[0] - state[2]))
    return found


@pytest.mark.parametrize("method", METHODS)
def test_nothing_crosses_a_play_and_a_blow_keeps_the_momentum(method: str) -> None:
    """Free until 0.1 s: 0.01 kg m2 at 1 rad/s, through 0.1 rad; the damper of 1 N m s/rad acts in touch alone."""
    gear = {"stiffness": 1000.0, "damping": 1.0, "backlash": 0.1}
    run = simulate_motion(geared(gear, duration=0.2, output_step=1e-3, method=method, step=1e-4))
    assert run.q[90] == pytest.approx([0.09, 0.0], abs=1e-11)
    assert run.v[90] == pytest.approx([1.0, 0.0], abs=1e-9)
    assert run.gear_torque[:100].tolist() == [[0.0]] * 100
    assert run.v @ [0.01, 0.02] == pytest.approx(0.01, abs=1e-9)
    assert run.gear_torque.min() == 0.0  # teeth do not pull
    near = {"rk4": 1e-5, "midpoint": 1e-3, "extrapolation": 1e-5}.get(method, 1e-7)
    wanted = law_apart(run.robot, run.times)
    assert np.column_stack([run.q, run.v]) == pytest.approx(wanted[:, [0, 2, 1, 3]], abs=near)


@settings(max_examples=int(os.environ.get("TMODES_PLAYS", "6")), deadline=None)
@given(
    motor=st.floats(1e-3, 0.3), play=st.floats(1e-3, 0.1), rate=st.floats(60.0, 400.0),
    damped=st.sampled_from([0.0, 0.05, 0.4, 1.0]), torque=st.sampled_from([0.0, 0.3]),
)  # fmt: skip
def test_teeth_meet_and_part_as_the_law_says(
    motor: float, play: float, rate: float, damped: float, torque: float
) -> None:
    """Back and forth between both ends of the play, at the default accuracy."""
    reduced = motor * 0.02 / (motor + 0.02)
    gear = {"stiffness": reduced * rate**2, "damping": 2 * damped * reduced * rate, "backlash": play}
    until = min(0.4, 8 * play + 10 / rate)
    sheet = geared(gear, motor, duration=until, output_step=until / 20, torque=torque)
    run = simulate_motion(sheet)
    wanted = law_apart(sheet, run.times, torque)
    found = np.column_stack([run.q, run.v])[:, [0, 2, 1, 3]]
    assert np.abs(found - wanted).max(axis=0) == pytest.approx(0.0, abs=1e-6 * np.abs(wanted).max())
    assert np.abs(run.energy_balance).max() < 1e-6 * run.energy_moved


def hanging(seed: int) -> Robot:
    """Two or three links in space under their weight, on gears with play, whose motors are kicked."""
    rng = np.random.default_rng(seed)
    joints, links, rates = [], [], {}
    for k in range(int(rng.integers(2, 4))):
        body, axis = random_body(rng), rng.normal(size=3)
        inertia = {f"{'xyz'[i]}{'xyz'[j]}": float(body.inertia[i, j]) for i in range(3) for j in range(i, 3)}
        stiffness = float(10 ** rng.uniform(1.5, 3))
        joints.append({
            "name": f"j{k}", "type": "revolute", "child": f"l{k}", "axis": axis.tolist(),
            "from": "frame", "origin": {"position": (rng.uniform(-0.3, 0.3, 3) * (k > 0)).tolist()},
            "motor": {"inertia": float(rng.uniform(0.01, 0.05)), "side": "joint", "friction": {"viscous": 0.01}},
            "gear": {"stiffness": stiffness, "damping": stiffness * float(rng.choice([0.0, 1e-3, 1e-2])),
                     "backlash": float(10 ** rng.uniform(-3, -1))},
        })  # fmt: skip
        shape = {"mass": body.mass, "center": body.center.tolist(), "inertia": inertia}
        links.append({"name": f"l{k}", "bodies": [shape]})
        rates[f"j{k}.motor"] = float(rng.normal())
    still = {"command": "torque", "signal": {"type": "constant", "value": 0.0}}
    return arm(joints=joints, links=links, tip={"link": links[-1]["name"], "position": [0.2, 0, 0]},
               drives=[{"joint": one["name"], **still} for one in joints], initial={"state": "zero", "rates": rates},
               integration={"duration": 0.5, "output_step": 0.01})  # fmt: skip


@pytest.mark.parametrize("seed", range(int(os.environ.get("TMODES_PLAYS", "3"))))
def test_energy_of_random_robots_with_play_is_accounted_for(seed: int) -> None:
    run = simulate_motion(hanging(seed))
    assert run.status == "finished"
    assert run.statistics["contact_changes"] > 0
    assert np.abs(run.energy_balance).max() < 2e-6 * run.energy_moved
    assert np.diff(run.works["gear_damping"]).min() > -1e-9


@pytest.mark.parametrize("method", ["dormand_prince", "rk4"])
def test_lanes_of_a_batch_meet_the_ends_of_their_own_plays(method: str) -> None:
    gear = {"stiffness": 800.0, "damping": 0.3, "backlash": 0.03}
    setup = run_setup(geared(gear, duration=0.3, output_step=0.01))
    model, schedule, start = setup.model, setup.planned.schedule, setup.start
    chosen = setup.robot.integration.model_copy(update={"method": method, "step": 1e-3})
    starts = np.tile(start, (5, 1))
    starts[:, model.layout.v.start] = [0.5, -0.9, 1.3, 2.0, 3.0]
    batch = simulate_lanes(model, model.numbers, schedule, starts, chosen)
    for lane, begun in enumerate(starts):
        single = solve(problem_of(model, model.numbers, schedule, begun, chosen))
        rows = schedule.rows_at(single.times)
        fastest = np.abs(model.rate(single.times, single.states, rows)).max()
        assert np.abs(batch.states[lane] - single.states).max() < 10 * SHORTEST * fastest
        assert single.statistics["contact_changes"] > 0


def test_derivatives_of_a_run_with_play() -> None:
    """Through blows without a damper, whose torque starts from zero; a damper's jumps there."""
    exact = {"relative_tolerance": 1e-11, "absolute_tolerance": 1e-12, "method": "dormand_prince"}
    sheet = geared({"stiffness": 800.0, "backlash": 0.02}, duration=0.2, output_step=0.01, **exact)
    path = "joints.j.gear.stiffness"
    found = forward_sensitivities(sheet, [path]).by[path][:, :4]
    ends = [forward_sensitivities(sheet.with_({path: value}), [path]).states[:, :4] for value in (799.9, 800.1)]
    assert found == pytest.approx((ends[1] - ends[0]) / 0.2, abs=1e-5 * np.abs(found).max())
    with pytest.raises(SimulationError, match=r"joints\.j\.gear\.damping"):
        forward_sensitivities(sheet.with_({"joints.j.gear.damping": 0.5}), [path])


def test_modes_within_the_play_say_so() -> None:
    """Loose teeth: no spring, no frequency; pressed by the weight, that of spring and load."""
    sheet = geared({"stiffness": 800.0, "backlash": 0.02}).with_({"drives": []})
    loose = vibrations(sheet)
    assert [row["frequency_Hz"] for row in loose.states["locked"]] == [0.0]
    assert any("play" in text and "j" in text for text in loose.warnings)
    heavy = {"gravity": [0.0, 9.81, 0.0], "links.load.bodies.0.center": [0.1, 0.0, 0.0]}
    pressed = vibrations(sheet.with_(heavy))
    lever = 1.0 * 9.81 * 0.1
    rest = 0.02 + lever / 800.0
    wanted = np.sqrt((800.0 - lever * np.sin(rest)) / (0.02 + 0.01)) / (2 * np.pi)
    assert pressed.states["locked"][0]["frequency_Hz"] == pytest.approx(wanted, rel=1e-3)
    assert not any("play" in text for text in pressed.warnings)
