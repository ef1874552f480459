"""Arms as WebAssembly: trees of any joints and links, loads, contact, and their picture, as natively."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from random_chains import random_chain, random_state
from tmodes.analysis.line.line import elastic_line
from tmodes.compile.ir.calls import DIRECT
from tmodes.compile.ir.program import kernel_program
from tmodes.compile.wasm.wasm_parts import schedule_samples
from tmodes.live.functions import LiveFunctions, LiveModule, ModelFunctions, live_module, stationed
from tmodes.model.model import Model
from tmodes.model.passes import derivatives
from tmodes.sheet import Robot
from tmodes.simulation.initial_state import RunSetup, run_setup, run_trajectory
from tmodes.simulation.loop import LoopModel
from tmodes.simulation.parts import sample_times
from tmodes.simulation.plan import Follow
from wasm.node import in_node
from wasm.sheets import two_links

SAME = {"dormand_prince": 1e-11, "extrapolation": 1e-8}
"""By how much two engines differ over the largest number of a state, see test_robot.py; a contact adds to it."""

STATIONS = tuple(np.linspace(0, 1, 5))


def _arm(method: str = "extrapolation") -> Robot:
    return two_links(wall=True, method=method, step=1e-4, duration=0.02 if method == "dormand_prince" else 0.12)


@pytest.fixture(scope="module")
def module() -> LiveModule:
    return live_module(ModelFunctions(_arm().pair(), STATIONS), [*SAME])


def _regimes(arm: Robot) -> dict[str, RunSetup]:
    pair = arm.pair()
    return {"reference": run_setup(pair.nominal, Follow.WANTED), "real": run_setup(pair.real)}


def _job(name: str, setup: RunSetup) -> dict[str, Any]:
    settings, schedule = setup.robot.integration, setup.planned.schedule.until(setup.robot.integration.duration)
    return {"run": {
        "loop": f"{name}.{settings.method}", "parameters": setup.model.numbers, "knots": schedule.knots,
        "rows": np.column_stack([schedule.knots[:-1], schedule.coefficients]), "state": setup.start,
        "times": sample_times(settings), "settings": {
            "duration": settings.duration, "relativeTolerance": settings.relative_tolerance,
            "absoluteTolerance": settings.absolute_tolerance, "step": settings.step, "maxSteps": settings.max_steps,
        },
    }}  # fmt: skip


@pytest.mark.nightly
def test_motion_is_the_native_one(module: LiveModule, tmp_path: Path) -> None:
    cases = [(method, *case) for method in SAME for case in _regimes(_arm(method)).items()]
    found = in_node(module, [_job(name, setup) for _, name, setup in cases], tmp_path)
    touched = 0
    for (method, _, setup), info in zip(cases, found, strict=True):
        native = run_trajectory(setup)
        assert info["status"] == native.status == "finished"
        touched += info["statistics"].get("contact_changes", 0)
        states, largest = info["states"].reshape(native.states.shape), np.abs(native.states).max()
        np.testing.assert_allclose(states, native.states, rtol=0, atol=SAME[method] * largest, err_msg=method)
    assert touched


def _states(model: LoopModel, count: int, seed: int) -> np.ndarray:
    states = np.zeros((count, model.layout.size))
    for k in range(count):
        q, v, _ = random_state(seed + k, model.coordinates, bend=0.05)
        states[k, model.layout.q], states[k, model.layout.v] = q, 0.1 * v
    return states


def test_samples_are_the_native_ones(module: LiveModule, tmp_path: Path) -> None:
    regimes, times = _regimes(_arm()), np.linspace(0, 0.05, 4)
    cases = []
    for name, setup in regimes.items():
        states, rows = _states(setup.model, 4, 3), setup.planned.schedule.rows_at(times)
        inputs = {"time": times, "state": states, "row": rows, "step": np.zeros(1)}
        shown = {label: values.reshape(4, -1) for label, values in setup.model.observe(times, states, rows).items()}
        cases += [
            (name, "observe", inputs, shown),
            (name, "rate", inputs, {"rate": setup.model.rate(times, states, rows)}),
        ]
    jobs = [
        {"sample": f"{name}.{label}", "parameters": regimes[name].model.numbers, "inputs": inputs, "count": 4}
        for name, label, inputs, _ in cases
    ]
    for (_, _, _, expected), info in zip(cases, in_node(module, jobs, tmp_path), strict=True):
        assert set(info) == set(expected)
        for label, values in expected.items():
            _same(info[label].reshape(4, -1), values, 1e-8)


def _same(info: np.ndarray, expected: np.ndarray, share: float) -> None:
    np.testing.assert_allclose(info, expected, rtol=0, atol=share * max(np.abs(expected).max(initial=0), 1e-3))


def test_picture_and_energies_are_the_native_ones(module: LiveModule, tmp_path: Path) -> None:
    arm = ModelFunctions(_arm().pair(), STATIONS)
    model = Model(arm.pair.real.model_copy(update={"drives": ()}).chain())
    q, v, a = random_state(11, model.coordinates, bend=0.2)
    numbers, motion = {name: one.parameters for name, one in arm.passes.items()}, {"q": q, "v": v, "a": a}
    base = {"rest": model.at_rest(gravity=0.0), "weight": model.at_rest()}
    jobs = [
        {"sample": "pose", "parameters": numbers["pose"], "inputs": {**motion, "base": base["rest"]}, "count": 1},
        {"sample": "elastic", "parameters": numbers["chain"], "inputs": {**motion, "base": base["weight"]}, "count": 1},
        {"sample": "inertia", "parameters": numbers["chain"], "inputs": {**motion, "base": base["weight"]}, "count": 1},
    ]
    pose, elastic, inertia = in_node(module, jobs, tmp_path)
    points = pose["points"].reshape(2, len(STATIONS), 24)
    exact = Model(stationed(model.chain, STATIONS)).points(q, v, a)
    np.testing.assert_allclose(points[..., 9:12].reshape(-1, 3), exact.position, atol=1e-12)
    for info, line in zip(points, elastic_line(model, q, stations=STATIONS).links.values(), strict=True):
        np.testing.assert_allclose(info[:, :9].reshape(-1, 3, 3), line.rotation[0], atol=1e-5)
        np.testing.assert_allclose(info[:, 9:12], line.position[0], atol=1e-5)
    energies, losses = model.energies(q, v), model.losses(q, v)
    by_kind = elastic["energies"].reshape(-1, 2).sum(axis=0)
    assert by_kind == pytest.approx([energies["elastic_gear"], energies["elastic_link"]], rel=1e-12)
    assert elastic["losses"].reshape(-1, 3).sum(axis=0) == pytest.approx([*losses.values()], rel=1e-12)
    assert -inertia["moment"] @ model.chain.gravity == pytest.approx(energies["gravity"], rel=1e-12)
    _same(inertia["forces"] + a * model.rotor_inertias + elastic["forces"], model.inverse_dynamics(q, v, a), 1e-11)


def test_rest_is_where_nothing_accelerates(module: LiveModule, tmp_path: Path) -> None:
    pair = _arm().pair()
    arm, setup = ModelFunctions(pair, STATIONS), run_setup(pair.real)
    rest = arm.plans["rest"]
    held, row = LoopModel(rest.plan), rest.schedule.rows_at(np.zeros(1))[0]
    state = np.zeros(held.layout.size)
    state[held.layout.q] = setup.held[setup.model.layout.q]
    count, n = len(held.coordinates), held.layout.size
    inputs = {"time": np.zeros(1), "state": state, "row": row, "step": np.zeros(1)}
    directions = {"state": np.eye(count, n)}
    job = {
        "sample": "rest.rate",
        "parameters": held.numbers,
        "inputs": inputs,
        "directions": directions,
        "count": count,
    }
    (info,) = in_node(module, [job], tmp_path)
    accelerations = info["values"]["rate"].reshape(count, n)[0, held.layout.v]
    slope = info["slopes"]["rate"].reshape(count, n)[:, held.layout.v].T
    free = [k for k in range(count) if k not in module.layout["held"]]
    step = np.linalg.solve(slope[np.ix_(free, free)], accelerations[free])
    assert np.abs(step).max() < 1e-12
    blocks = {name: np.tile(values, (count, 1)) for name, values in inputs.items()}
    native = derivatives(held.numbers, held.loop.rate, blocks, directions, count)["rate"][:, held.layout.v].T
    _same(slope, native, 1e-10)


@pytest.mark.nightly
def test_random_chains(tmp_path: Path) -> None:
    chains = [random_chain(seed, 2) for seed in (3, 9)]
    made, jobs, expected = LiveFunctions(), [], []
    for k, chain in enumerate(chains):
        model = Model(chain)
        q, v, a = random_state(k, model.coordinates)
        inputs = {"q": q, "v": v, "a": a, "base": model.at_rest()}
        schedule = model.passes.schedule("inertia")
        made.schedule(f"inertia{k}", schedule_samples(f"inertia{k}", schedule), schedule)
        trimmed = schedule.only(("points",))
        made.schedule(f"points{k}", schedule_samples(f"points{k}", trimmed), trimmed)
        jobs += [
            {"sample": f"{label}{k}", "parameters": model.parameters, "inputs": inputs, "count": 1}
            for label in ("inertia", "points")
        ]
        forces = model.inverse_dynamics(q, v, a) - a * model.rotor_inertias - model.elastic_forces(q, v)
        expected.append((forces, model.points(q, v, a, base=model.at_rest()).position))
    found = in_node(made.module("random"), jobs, tmp_path)
    for k, (forces, positions) in enumerate(expected):
        whole, points = found[2 * k], found[2 * k + 1]
        _same(whole["forces"], forces, 1e-11)
        assert [*points] == ["points"]
        np.testing.assert_array_equal(points["points"], whole["points"])
        np.testing.assert_allclose(points["points"].reshape(-1, 24)[:, 9:12], positions, atol=1e-12)


@pytest.mark.nightly
def test_long_kernels_in_pieces(tmp_path: Path) -> None:
    model = Model(random_chain(3, 2))
    schedule, (q, v, a) = model.passes.schedule("inertia"), random_state(2, model.coordinates)
    longest = max((kernel for kernel, _, _ in schedule.calls), key=lambda kernel: len(kernel_program(kernel).values))
    inputs = {"q": q, "v": v, "a": a, "base": model.at_rest()}
    info = []
    for piece in (10**6, 50):
        made = LiveFunctions()
        made.schedule("inertia", schedule_samples("inertia", schedule, piece=piece), schedule)
        job = {"sample": "inertia", "parameters": model.parameters, "inputs": inputs, "count": 1}
        info += in_node(made.module("pieces"), [job], tmp_path)
    assert len(kernel_program(longest).values) > 100
    for name, values in info[0].items():
        np.testing.assert_array_equal(info[1][name], values)


def test_calls_as_data(tmp_path: Path) -> None:
    """So many calls that they stand in a table, whose address moves with the data."""
    model = Model(random_chain(7, 140, rigid=True))
    schedule, made = model.passes.schedule("inertia"), LiveFunctions()
    assert len(schedule.calls) > DIRECT
    made.schedule("inertia", schedule_samples("inertia", schedule), schedule)
    q, v, a = random_state(2, model.coordinates)
    job = {
        "sample": "inertia", "parameters": model.parameters, "count": 1,
        "inputs": {"q": q, "v": v, "a": a, "base": model.at_rest()},
    }  # fmt: skip
    (found,) = in_node(made.module("long"), [job], tmp_path)
    info = found["forces"] + a * model.rotor_inertias + model.elastic_forces(q, v)
    _same(info, model.inverse_dynamics(q, v, a), 1e-10)


def test_only_what_is_needed_is_computed() -> None:
    schedule = Model(replace(random_chain(4, 4), points=())).passes.schedule("inertia")
    assert len(schedule.only(("points",)).calls) < 0.6 * len(schedule.calls)
    assert set(schedule.only(("forces",)).outputs) == {"forces"}
