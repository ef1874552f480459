"""Batches by energies and by the recursion: each lane is the run by itself, whatever stands next to it."""

from __future__ import annotations

import os
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from lane_runs import simulate_lanes
from tmodes.kinds.signals.schedule import SignalPieces
from tmodes.simulation.batch.result import load_batch
from tmodes.simulation.problem import problem_of
from tmodes.simulation.solve import solve

ROBOTS = pytest.mark.parametrize("lot", ["filipovic2010", "pendulum"], indirect=True)


TESTS = Path(__file__).parents[1]


def alone(lot, numbers, schedule=None, start=None, settings=None):
    """The same run on the loop of a single robot."""
    parameters = np.asarray(numbers)
    start = lot.start if start is None else start
    return solve(problem_of(lot.model, parameters, schedule or lot.schedule, start, settings or lot.settings))


@ROBOTS
@pytest.mark.parametrize("method", ["dormand_prince", "rk4"])
def test_each_lane_is_the_run_by_itself(lot, method):
    """Same steps and same ends; the states differ by rounding, far below the tolerance."""
    lot = replace(lot, settings=lot.settings.model_copy(update={"method": method, "output_step": 7.7e-4, "step": 1e-3}))
    batch = lot.run()
    assert batch.finished.all()
    for lane in range(batch.size):
        single = alone(lot, lot.many[lane])
        assert np.array_equal(batch.times, single.times)
        assert np.abs(batch.states[lane] - single.states).max() < 1e-12 * np.abs(single.states).max()
        info = {name: values[lane] for name, values in batch.statistics.items()}
        assert info == {name: single.statistics[name] for name in info}
        assert batch.message[lane] == single.message


@ROBOTS
@pytest.mark.parametrize("method", ["dormand_prince", "rk4"])
@pytest.mark.parametrize("lanes", [[0], [3, 1, 2], [8, 7, 6, 5], [4, 4, 0], [5, 8, 1, 0, 7, 6, 2, 3, 4]])
@pytest.mark.parametrize("threads", [1, 2])
def test_bytes_do_not_depend_on_the_company(lot, method, lanes, threads):
    """Other places, sizes and threads give the same bits."""
    lot = replace(lot, settings=lot.settings.model_copy(update={"method": method}))
    whole, part = lot.run(threads=1), lot.run(lanes, threads=threads)
    assert part.states.tobytes() == whole.states[lanes].tobytes()
    for name, values in part.statistics.items():
        assert np.array_equal(values, whole.statistics[name][lanes])


def test_bytes_do_not_depend_on_the_pieces(lot, monkeypatch):
    """How often the loop is called is not seen in its result."""
    whole = lot.run()
    monkeypatch.setattr("tmodes.simulation.native_run._FIRST_PIECE", 3)
    monkeypatch.setattr(
        "tmodes.simulation.native_run._PIECE_SECONDS", 0.0
    )  # as on a machine so busy that each step takes long
    assert lot.run().states.tobytes() == whole.states.tobytes()


NARROW = """
import sys
import llvmlite.binding as llvm
asked = llvm.get_host_cpu_features
llvm.get_host_cpu_features = lambda: {"avx512f": False}
from tmodes.compile.ir.arithmetic import Wide
llvm.get_host_cpu_features = asked
assert Wide.stride == 4
import numpy as np
import tmodes
from lane_runs import simulate_lanes
from tmodes.simulation.initial_state import run_setup
robot = tmodes.load("filipovic2010")
setup = run_setup(robot)
settings = robot.integration.model_copy(update={"duration": 0.02, "output_step": 5e-4})
with np.load(sys.argv[1]) as info:
    simulate_lanes(setup.model, info["many"], setup.planned.schedule, info["start"], settings, out=sys.argv[2])
"""


def test_bytes_do_not_depend_on_the_width_of_the_vectors(lot, tmp_path):
    """Four lanes on the same processor's instructions, in other surroundings, give the same bits as eight."""
    np.savez(tmp_path / "info.npz", many=lot.many, start=lot.start)
    line = [sys.executable, "-c", NARROW, str(tmp_path / "info.npz"), str(tmp_path / "batch")]
    surroundings = {"PYTHONHASHSEED": "7", "TZ": "Asia/Tokyo", "LC_ALL": "de_DE.UTF-8", "OPENBLAS_NUM_THREADS": "3"}
    env = os.environ | surroundings | {"TMODES_CACHE": str(tmp_path / "cache")}
    subprocess.run(line, check=True, env=env, cwd=TESTS)
    assert load_batch(tmp_path / "batch").states.tobytes() == lot.run().states.tobytes()


def test_each_lane_has_its_own_motion_and_start(lot):
    """Knots at different times, of different number; each lane's steps end on its own."""
    rng = np.random.default_rng(2)
    schedules = []
    for lane in range(5):
        knots = np.linspace(0.0, 0.02, lane + 2) * (1 + 0.3 * (lane == 2))
        schedules.append(SignalPieces(knots, 0.1 * rng.normal(size=(lane + 1, 3))))
    starts = lot.start + 1e-3 * rng.normal(size=(5, len(lot.start)))
    batch = simulate_lanes(lot.model, lot.model.numbers, schedules, starts, lot.settings)
    for lane in range(5):
        single = alone(lot, lot.model.numbers, schedules[lane], starts[lane])
        assert np.abs(batch.states[lane] - single.states).max() < 1e-12 * np.abs(single.states).max()
        assert batch.statistics["steps"][lane] == single.statistics["steps"]


@pytest.mark.parametrize("lot", ["pendulum"], indirect=True)
@pytest.mark.parametrize("threads", [1, 2])
def test_implicit_methods_run_one_by_one(lot, threads):
    """They have no lanes: each robot is the run by itself, bit by bit, and a bad one disturbs none."""
    settings = lot.settings.model_copy(update={"method": "extrapolation", "max_steps": 4000})
    many = lot.many[:4].copy()
    many[2] = np.nan
    lot = replace(lot, settings=settings, many=many)
    batch = lot.run(threads=threads)
    assert [status == "finished" for status in batch.status] == [True, True, False, True]
    for lane in (0, 1, 3):
        assert batch.states[lane].tobytes() == alone(lot, many[lane]).states.tobytes()


def test_order_of_the_method_in_lanes(lot):
    """Ten times the tolerance: the error against a much finer run grows as the control of the step lets it."""
    errors = []
    tolerances = np.array([1e-6, 1e-8, 1e-10])
    fine = replace(lot, settings=lot.settings.model_copy(update={"relative_tolerance": 1e-13})).run([0])
    for tolerance in tolerances:
        info = {"relative_tolerance": float(tolerance), "absolute_tolerance": float(tolerance) * 1e-3}
        run = replace(lot, settings=lot.settings.model_copy(update=info)).run([0])
        errors.append(np.abs(run.states[0, :, :6] - fine.states[0, :, :6]).max())
    slope = np.polyfit(np.log(tolerances), np.log(errors), 1)[0]
    assert 0.7 < slope < 1.3
