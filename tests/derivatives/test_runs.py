"""Derivatives of whole runs: forwards, in reverse, by differences on the same steps and on steps of their own."""

from __future__ import annotations

import tracemalloc
from functools import cache
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from io_cases import value_of
from tmodes.errors import InputError, SimulationError
from tmodes.gradients.changes import Change, changes_of
from tmodes.gradients.gradient import adjoint_gradient, forward_sensitivities
from tmodes.gradients.lowering import Lowered, lowered
from tmodes.gradients.quantities import Functional
from tmodes.robots.load import load
from tmodes.sheet import Robot
from tmodes.simulation.recording import record
from tmodes.simulation.replay import Replay

Array = NDArray[np.float64]

SHORT = {"integration.duration": 0.3, "integration.output_step": 0.007}
SEED_PATHS = ("gear.stiffness", "link.modes.0.bending_stiffness", "payload.mass", "controller.position_gain")
ARM_PATHS = ("links.link.beam.section.bending_stiffness", "joints.joint.gear.stiffness", "links.link.beam.length")
EXPLICIT = ("dormand_prince", "dop853", "rk4")
CASES = [*((name, method) for name in ("seed", "arm") for method in EXPLICIT), ("arm", "extrapolation")]
IN_REVERSE = [*CASES, ("seed", "extrapolation")]


@cache
def seed_robot(method: str = "dormand_prince") -> Robot:
    return load("filipovic2010").with_({**SHORT, "integration.method": method})


@cache
def bending_arm(**integration: Any) -> Robot:
    """A beam that hangs to the side of an elastic joint whose motor is led to another angle."""
    info = {"duration": 0.2, "output_step": 0.006, "method": "dormand_prince", **integration}
    motion = {"type": "quintic", "start": 0.0, "end": 0.4, "duration": 0.15}
    return Robot.from_data({
        "format": 1, "kind": "arm", "name": "test", "gravity": 9.81,
        "joints": [{"name": "joint", "type": "revolute", "parent": "base", "child": "link", "axis": [0, 1, 0],
                    "motor": {"side": "joint", "inertia": 0.05, "friction": {"viscous": 0.3}},
                    "gear": {"stiffness": 300.0, "damping": 0.4}}],
        "links": [{"name": "link", "bodies": [{"name": "load", "mass": 0.3, "at": 1.0}],
                   "beam": {"model": "strain", "functions": {"bend_y": 1}, "length": 0.6, "damping_time": 1e-3,
                            "section": {"bending_stiffness": 20.0, "mass_per_length": 0.5}}}],
        "drives": [{"joint": "joint", "command": "position", "signal": motion,
                    "controller": {"type": "pd", "position_gain": 90.0, "velocity_gain": 6.0}}],
        "integration": info,
    })  # fmt: skip


@cache
def loaded_arm() -> Robot:
    """The same arm under a force that ends when the motion does."""
    data = bending_arm().model_dump(mode="json", exclude_none=True)
    fading = {"type": "quintic", "start": 1.0, "end": 0.0, "duration": 0.15}
    return Robot.from_data(
        data | {"loads": [{"point": "tip", "frame": "world", "force": [0.0, 0.0, -2.0], "signal": fading}]}
    )


def sheet_of(name: str, method: str) -> Any:
    return seed_robot(method) if name == "seed" else bending_arm(method=method)


def paths_of(name: str) -> tuple[str, ...]:
    return SEED_PATHS if name == "seed" else ARM_PATHS


def value_at(name: str, path: str) -> float:
    found = value_of(sheet_of(name, "rk4"), path)
    return found[0] if isinstance(found, list) else found  # the same stiffness in both planes


@cache
def lowered_once(name: str, method: str) -> Lowered:
    return lowered(sheet_of(name, method))


@cache
def replay_of(name: str, method: str, most_bytes: float = 1e9) -> Replay:
    return lowered_once(name, method).recorded(most_bytes)


def squares(times: Array, states: Array) -> tuple[float, Array]:
    """An integral of squares of three coordinates about some other value, as a sum over the samples."""
    count = 3
    step, weights = times[1] - times[0], np.zeros_like(states)
    weights[:, :count] = 2 * step * (states[:, :count] - 0.2)
    return float(((states[:, :count] - 0.2) ** 2).sum() * step), weights


def richardson(function: Any, step: float) -> float:
    ways = [(function(step * k) - function(-step * k)) / (2 * step * k) for k in (1, 2, 3)]
    return (15 * ways[0] - 6 * ways[1] + ways[2]) / 10


SQUARES = Functional(("state",), lambda times, info: _of_states(*squares(times, info["state"])))


def _of_states(value: float, weights: Array) -> tuple[float, dict[str, Array]]:
    return value, {"state": weights}


@pytest.mark.parametrize(("name", "method"), CASES)
def test_the_same_steps_give_the_same_samples(name: str, method: str) -> None:
    replay = replay_of(name, method)
    samples = replay.recording.samples
    rounding = 1e-10 if method == "extrapolation" else 1e-11  # weights of its rows reach 400
    assert np.abs(replay.samples() - samples).max() <= rounding * np.abs(samples).max()


@pytest.mark.parametrize(("name", "method"), IN_REVERSE)
def test_the_gradient_is_that_of_differences_on_the_same_steps(name: str, method: str) -> None:
    here, replay = lowered_once(name, method), replay_of(name, method)
    times, samples = replay.recording.times, replay.recording.samples
    found = replay.back(squares(times, samples)[1])
    for path, change in changes_of(sheet_of(name, method), here, replay, paths_of(name)).items():
        scale = 3e-3 * value_at(name, path)

        def value(by: float, change: Any = change) -> float:
            moved = replay.samples(here.parameters + by * change.parameters, here.start + by * change.start)
            return squares(times, moved)[0]

        expected = richardson(value, scale)
        gradient = found.parameters @ change.parameters + found.start @ change.start
        assert gradient == pytest.approx(expected, rel=1e-7, abs=1e-12 * abs(value(0.0)) / scale)


@pytest.mark.parametrize(("name", "method"), IN_REVERSE)
def test_slopes_forwards_and_weights_in_reverse_tell_the_same_number(name: str, method: str) -> None:
    replay, rng = replay_of(name, method), np.random.default_rng(4)
    samples, rows = replay.recording.samples, replay.recording.rows
    count = 9  # more than one sweep of eight
    start, weights = rng.normal(size=(count, samples.shape[1])), rng.normal(size=samples.shape)
    parameters = replay.parameters * rng.normal(size=(count, len(replay.parameters)))
    signals = np.zeros((count, *rows.shape))
    signals[:, :, 1:] = 0.1 * rng.normal(size=(count, *rows[:, 1:].shape))
    slopes, found = replay.along(start, parameters, signals), replay.back(weights)
    one = np.tensordot(slopes, weights, 2)
    other = start @ found.start + parameters @ found.parameters + np.tensordot(signals, found.rows, 2)
    assert np.abs(one - other).max() <= 1e-10 * np.abs(slopes * weights).sum(axis=(1, 2)).max()


def test_few_kept_states_give_the_same_derivatives() -> None:
    whole, sparse = replay_of("seed", "dormand_prince"), replay_of("seed", "dormand_prince", 20_000.0)
    assert sparse.recording.every >= 4 * whole.recording.every == 4
    assert sparse.recording.kept.nbytes <= 20_000
    weights = np.random.default_rng(1).normal(size=whole.recording.samples.shape)
    step = len(whole.recording.t) // 2 + 1
    (*one, inner), (*other, same) = (replay.back(weights, [step]) for replay in (whole, sparse))
    for here, there in zip([*one, inner[step]], [*other, same[step]], strict=True):
        assert np.abs(here - there).max() <= 1e-9 * np.abs(here).max()


def test_states_between_those_kept_are_there_one_piece_at_a_time() -> None:
    here = lowered(seed_robot("rk4").with_({"integration.step": 1e-5}))
    whole, sparse = here.recorded(), here.recorded(50_000.0)
    weights = np.ones_like(whole.recording.samples)
    peaks = []
    for replay in (whole, sparse):
        replay.back(weights)  # all code is there
        tracemalloc.start()
        replay.back(weights)
        peaks.append(tracemalloc.get_traced_memory()[1])
        tracemalloc.stop()
    assert peaks[1] - peaks[0] <= 0.1 * whole.recording.kept.nbytes


@pytest.mark.parametrize("name", ["seed", "arm"])
def test_gradients_by_quantities_are_those_of_runs_with_other_sheets(name: str) -> None:
    tight = {"integration.relative_tolerance": 1e-12, "integration.absolute_tolerance": 1e-14}
    sheet = sheet_of(name, "dormand_prince").with_(tight)
    paths = paths_of(name)
    gradient, forwards = adjoint_gradient(sheet, SQUARES, paths), forward_sensitivities(sheet, paths)
    weights = squares(forwards.times, forwards.states)[1]
    for path in paths:
        assert (weights * forwards.by[path]).sum() == pytest.approx(gradient.by[path], rel=1e-9)
    path, value = paths[0], value_at(name, paths[0])

    def measured(share: float) -> float:
        here = lowered(sheet.with_({path: value * (1 + share)}))
        done = record(here.setup.problem())
        return squares(done.times, done.samples)[0]

    assert gradient.by[path] * value == pytest.approx(richardson(measured, 0.01), rel=2e-6)


def test_a_signal_and_the_start_are_differentiated_too() -> None:
    sheet = bending_arm()
    path = "drives.0.signal.end"
    found = forward_sensitivities(sheet, [path], start={"own": np.eye(len(lowered(sheet).start))[0]})
    lines = [forward_sensitivities(sheet.with_({path: value})).states for value in (0.4 - 1e-4, 0.4 + 1e-4)]
    expected = (lines[1] - lines[0])[:, :6] / 2e-4
    assert np.abs(found.by[path][:, :6] - expected).max() <= 1e-5 * np.abs(expected).max()
    assert found.by["own"][0, 0] == 1.0


def test_where_an_instant_moves_at_which_rates_jump_slopes_jump() -> None:
    quintic = {"type": "quintic", "start": 0.0, "end": 0.4, "duration": 0.15}
    step, path = {"type": "step", "start": 0.0, "end": 0.1, "time": 0.0671}, "drives.0.signal.signals.1.time"
    sheet = bending_arm().with_({"drives.0.signal": {"type": "sum", "signals": [quintic, step]}})
    sheet = sheet.with_({"integration.relative_tolerance": 1e-11, "integration.absolute_tolerance": 1e-13})
    found, back = forward_sensitivities(sheet, [path]), adjoint_gradient(sheet, SQUARES, [path])
    lines = [forward_sensitivities(sheet.with_({path: 0.0671 + by})).states for by in (-1e-5, 1e-5)]
    expected = (lines[1] - lines[0])[:, :6] / 2e-5
    assert np.abs(found.by[path][:, :6] - expected).max() <= 1e-5 * np.abs(expected).max()
    assert (squares(found.times, found.states)[1] * found.by[path]).sum() == pytest.approx(back.by[path], rel=1e-10)


def change_by(sheet: Robot, path: str) -> Change:
    here = lowered(sheet)
    return changes_of(sheet, here, here.recorded(), [path])[path]


@pytest.mark.parametrize(
    ("path", "problem"),
    [
        ("links.link.beam.section.mas", "unknown"),
        ("links.link.beam.functions.bend_y", "structure"),
        ("integration.duration", "structure"),
        ("joints.joint.gear.backlash", "at 0 it is at an edge"),
        ("drives.0.signal.type", "finite number"),
    ],
)
def test_what_cannot_be_differentiated_is_refused(path: str, problem: str) -> None:
    with pytest.raises(InputError, match=problem):
        change_by(bending_arm(), path)


def test_a_load_changes_the_rest_too() -> None:
    sheet = loaded_arm()
    path, state = "loads.0.force.2", lowered(sheet).start
    ends = [lowered(sheet.with_({path: -2.0 + by})).start for by in (-1e-3, 1e-3)]
    assert np.abs(state).max() > 0
    assert change_by(sheet, path).start == pytest.approx((ends[1] - ends[0]) / 2e-3, rel=1e-5, abs=1e-9)


def test_methods_and_runs_without_derivatives_are_refused() -> None:
    with pytest.raises(InputError, match="dormand_prince, dop853, rk4 or extrapolation"):
        adjoint_gradient(bending_arm(method="midpoint", step=1e-3), SQUARES)
    with pytest.raises(SimulationError, match="max_steps"):
        adjoint_gradient(bending_arm(max_steps=3, duration=2.0), SQUARES)


def test_steps_at_the_limit_of_stability_are_left_for_implicit_ones() -> None:
    """A link whose second mode is stiff and at rest: along explicit steps derivatives grew by 1e50."""
    joint = {"name": "joint", "type": "revolute", "child": "link", "axis": [0, 0, 1],
             "motor": {"side": "joint", "inertia": 0.15}, "gear": {"stiffness": 5000.0, "damping": 4.0}}  # fmt: skip
    beam = {"model": "strain", "functions": {"bend_y": 2, "bend_z": 2}, "length": 0.5, "damping_time": 1e-4,
            "section": {"shape": "box", "height": 0.025, "width": 0.02, "thickness": 0.0015},
            "material": "aluminium_6061"}  # fmt: skip
    drive = {"joint": "joint", "command": "position",
             "controller": {"type": "pd", "position_gain": 2e3, "velocity_gain": 40.0},
             "signal": {"type": "quintic", "start": 0.9, "end": 0.3, "duration": 0.4}}  # fmt: skip
    robot = Robot.from_data({
        "format": 1, "kind": "arm", "name": "stiff", "joints": [joint], "drives": [drive],
        "links": [{"name": "link", "bodies": [{"name": "load", "mass": 1.0, "at": 1.0}], "beam": beam}],
        "integration": {"duration": 0.8, "output_step": 5e-3},
    })  # fmt: skip
    path = "joints.joint.gear.stiffness"
    found, wanted = (
        adjoint_gradient(robot.with_({"integration.method": method}), SQUARES, [path]).by[path]
        for method in ("auto", "extrapolation")
    )
    assert found == pytest.approx(wanted, rel=1e-6)
    with pytest.raises(SimulationError, match="stability"):
        adjoint_gradient(robot.with_({"integration.method": "dormand_prince"}), SQUARES, [path])


@pytest.mark.parametrize("kind", ["clamp", "none", "back_calculation"])
def test_a_command_that_meets_its_limit(kind: str) -> None:
    """Against central differences of runs; along steps over the kinks they were up to 87 % off."""
    more = {"tracking_time": 0.05} if kind == "back_calculation" else {}
    law = {"type": "pid", "position_gain": 80.0, "velocity_gain": 8.0, "integral_gain": 300.0, "limit": 14.0,
           "anti_windup": kind, **more}  # fmt: skip
    robot = load("spong1987").with_({
        "drives.0": {"joint": "joint", "command": "position", "controller": law,
                     "signal": {"type": "septic", "start": 0.0, "end": 1.0, "duration": 0.5}},
        "integration.duration": 1.5, "integration.output_step": 2e-3,
    })  # fmt: skip
    path = "drives.0.controller.position_gain"
    tight = robot.with_({"integration.relative_tolerance": 1e-12, "integration.absolute_tolerance": 1e-14})

    def measured(share: float) -> float:
        done = record(lowered(tight.with_({path: 80.0 * (1 + share)})).setup.problem())
        return squares(done.times, done.samples)[0]

    found = adjoint_gradient(robot, SQUARES, [path]).by[path] * 80.0
    assert found == pytest.approx((measured(1e-4) - measured(-1e-4)) / 2e-4, rel=1e-3)
