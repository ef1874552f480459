"""Delayed sensors and commands before their first value: as if the robot had always stood where it starts."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.integrate import solve_ivp

import tmodes
from live.node import live_in_node
from simulation.sheets import arm
from tmodes.gradients.gradient import forward_sensitivities
from tmodes.live.bundle import live_bundle
from tmodes.live.map import live_map
from tmodes.simulation.initial_state import run_setup
from tmodes.simulation.python_controller import driven_by
from tmodes.simulation.simulate import simulate_motion

PERIOD, SENSED, COMMANDED, INERTIA, WEIGHT, KP, KI = 0.02, 0.028, 0.012, 0.5, 6.0, 30.0, 20.0
START, RATE, WANTED = 0.4, -0.6, 1.1
LAW = {"type": "sampled_pid", "position_gain": KP, "integral_gain": KI, "velocity_gain": 3.0, "sample_time": PERIOD,
       "measured": "teeth", "filter_time": 0.0}  # fmt: skip


def pendulum(**more: Any) -> Any:
    """A bob of 1 kg, a delayed encoder, and a law whose command is late; not at rest where it starts."""
    joint = {"name": "j", "type": "revolute", "child": "l", "axis": [0, 1, 0]}
    bob = {"name": "bob", "mass": 1.0, "center": [0, 0, -WEIGHT / 9.8], "inertia": INERTIA - (WEIGHT / 9.8) ** 2}
    drive = {"joint": "j", "command": "position", "delay": COMMANDED, "controller": LAW,
             "signal": {"type": "constant", "value": WANTED}}  # fmt: skip
    settings = {"duration": 0.3, "output_step": 0.004, "method": "dormand_prince", "relative_tolerance": 1e-11,
                "absolute_tolerance": 1e-13}  # fmt: skip
    sensor = {"name": "teeth", "type": "encoder", "joint": "j", "sample_time": PERIOD, "delay": SENSED}
    initial = {"coordinates": {"j": START}, "rates": {"j": RATE}}
    whole = {"gravity": 9.8, "joints": [joint], "links": [{"name": "l", "bodies": [bob]}], "drives": [drive],
             "sensors": [sensor], "initial": initial, "integration": settings}  # fmt: skip
    return arm(**(whole | more))


def by_scipy(times: NDArray[np.float64], start: float = START, kp: float = KP, inertia: float = INERTIA) -> Any:
    """Angles: the delay equation by the method of steps, its history constant before 0."""
    angles, commands, state, z, last = [start], [], np.array([start, RATE]), 0.0, start

    def command(k: int) -> float:
        nonlocal z, last
        seen = angles[max(0, k - 2)]  # of the sample that has come at k T: 1.4 periods before
        error, rate = WANTED - seen, (seen - last) / PERIOD
        found, z, last = kp * error + KI * z - 3.0 * rate, z + PERIOD * error, seen
        return found

    knots = np.unique(np.round(np.concatenate([times, np.arange(16) * PERIOD, np.arange(15) * PERIOD + COMMANDED]), 9))
    knots, found, force = knots[knots <= times[-1] + 1e-12], [], WEIGHT * np.sin(start)
    for k, (t, until) in enumerate(zip(knots, [*knots[1:], knots[-1]], strict=True)):
        if abs(t / PERIOD - round(t / PERIOD)) < 1e-6:
            if k:
                angles.append(state[0])
            commands.append(command(round(t / PERIOD)))
        due = (t - COMMANDED) / PERIOD
        if due > -1e-6 and abs(due - round(due)) < 1e-6:
            force = commands[round(due)]
        found.append(state[0])
        if until > t:
            state = solve_ivp(
                lambda _, x, u=force: [x[1], (u - WEIGHT * np.sin(x[0])) / inertia],
                (t, until), state, method="DOP853", rtol=1e-12, atol=1e-14,
            ).y[:, -1]  # fmt: skip
    return np.array(found)[np.searchsorted(knots, np.round(times, 9))]


@pytest.mark.parametrize("method", ["dormand_prince", "extrapolation", "rosenbrock"])
def test_a_run_equals_the_delay_equation(method: str) -> None:
    loose = {} if method == "dormand_prince" else {"relative_tolerance": 1e-8, "absolute_tolerance": 1e-9}
    run = simulate_motion(pendulum().with_({f"integration.{k}": v for k, v in ({"method": method} | loose).items()}))
    assert np.abs(run.q[:, 0] - by_scipy(run.times)).max() < (1e-7 if loose else 1e-10)


def test_batches_and_derivatives_start_so_too() -> None:
    sheet, starts = pendulum(), [0.1, START, 0.7]
    batch = tmodes.simulate_batch(sheet, {"initial.coordinates.j": starts})
    times = simulate_motion(sheet).times
    for lane, start in enumerate(starts):
        assert np.abs(batch.states[lane, :, 0] - by_scipy(times, start)).max() < 1e-10
    paths = {"initial.coordinates.j": "start", "drives.0.controller.position_gain": "kp"}
    found, step = forward_sensitivities(sheet, [*paths]), 1e-5
    for path, name in paths.items():
        value = {"start": START, "kp": KP}[name]
        up, down = (by_scipy(found.times, **{name: value + sign * step}) for sign in (1, -1))
        assert np.abs(found.by[path][:, 0] - (up - down) / (2 * step)).max() < 1e-7


def test_the_page_starts_so_too(tmp_path: Path) -> None:
    sheet = pendulum()
    live = live_map(sheet.pair(), (0.0, 1.0))
    values = [live.start, [1.2 * slider.value for slider in live.sliders]]
    bundle: Any = live_bundle(tmodes.run(sheet))
    for page, one in zip(live_in_node(bundle, values, tmp_path), values, strict=True):
        native = simulate_motion(sheet.with_(live.changes(one)))
        assert np.abs(page["series"]["q"][:, 0] - native.q[:, 0]).max() < 1e-9


def test_a_sensor_says_where_it_stands_where_no_weight_moves_the_robot() -> None:
    """In balance with held motors, where no equilibrium has to be found."""
    run = simulate_motion(pendulum(gravity=0.0, initial={}))
    assert np.abs(run.q - WANTED).max() < 1e-12


def test_outputs_hold_the_reading_and_the_command_of_the_start_by_name() -> None:
    """Those of sensors where a Python function takes the place of the controllers, too."""
    setup = run_setup(pendulum())
    other = driven_by(setup)
    assert (other.start[other.model.layout.controls] == START).all()
    names = setup.model.plan.control_names
    held = dict(zip(names, setup.start[setup.model.layout.controls], strict=True))
    assert held["teeth.value"] == held["teeth.value_due1"] == held["teeth.value_due2"] == START
    assert held["j.controller.command"] == pytest.approx(WEIGHT * np.sin(START))
    assert held["j.controller.integral"] == 0.0
