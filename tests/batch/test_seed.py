"""Batches of the paper's robot: each lane is the run by itself, whatever stands next to it."""

from __future__ import annotations

import os
import subprocess
import sys
from dataclasses import replace

import numpy as np
import pytest

from tmodes.kinds.signals.schedule import Schedule
from tmodes.simulation.batch.result import load_batch
from tmodes.simulation.batch.simulate import simulate_lanes
from tmodes.simulation.trajectory import integrate


def alone(seed, numbers, schedule=None, start=None, settings=None):
    """The same run on the loop of a single robot."""
    parameters = np.asarray(numbers)
    start = seed.start if start is None else start
    return integrate(seed.model, parameters, schedule or seed.schedule, start, settings or seed.settings)


@pytest.mark.parametrize("method", ["dormand_prince", "rk4"])
def test_each_lane_is_the_run_by_itself(seed, method):
    """Same steps and same ends; the states differ by rounding, far below the tolerance."""
    seed = replace(seed, settings=seed.settings.model_copy(update={"method": method, "output_step": 7.7e-4}))
    batch = seed.run()
    assert batch.finished.all()
    for lane in range(batch.size):
        single = alone(seed, seed.many[lane])
        assert np.array_equal(batch.times, single.times)
        assert np.abs(batch.states[lane] - single.states).max() < 1e-12 * np.abs(single.states).max()
        info = {name: values[lane] for name, values in batch.statistics.items()}
        assert info == {name: single.statistics[name] for name in info}
        assert batch.message[lane] == single.message


@pytest.mark.parametrize("method", ["dormand_prince", "rk4"])
@pytest.mark.parametrize("lanes", [[0], [3, 1, 2], [8, 7, 6, 5], [4, 4, 0], [5, 8, 1, 0, 7, 6, 2, 3, 4]])
@pytest.mark.parametrize("threads", [1, 2])
def test_bytes_do_not_depend_on_the_company(seed, method, lanes, threads):
    """Other places, sizes and threads give the same bits."""
    seed = replace(seed, settings=seed.settings.model_copy(update={"method": method}))
    whole, part = seed.run(threads=1), seed.run(lanes, threads=threads)
    assert part.states.tobytes() == whole.states[lanes].tobytes()
    for name, values in part.statistics.items():
        assert np.array_equal(values, whole.statistics[name][lanes])


def test_bytes_do_not_depend_on_the_pieces(seed, monkeypatch):
    """How often the loop is called is not seen in its result."""
    whole = seed.run()
    monkeypatch.setattr("tmodes.simulation.batch.workers._FIRST_PIECE", 3)
    monkeypatch.setattr(
        "tmodes.simulation.batch.workers._PIECE_SECONDS", 0.0
    )  # as on a machine so busy that each step takes long
    assert seed.run().states.tobytes() == whole.states.tobytes()


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
from tmodes.simulation.batch.simulate import simulate_lanes
from tmodes.simulation.start import run_setup
robot = tmodes.load("filipovic2010")
setup = run_setup(robot)
settings = robot.integration.model_copy(update={"duration": 0.02, "output_step": 5e-4})
with np.load(sys.argv[1]) as info:
    simulate_lanes(setup.model, info["many"], setup.planned.schedule, info["start"], settings, out=sys.argv[2])
"""


def test_bytes_do_not_depend_on_the_width_of_the_vectors(seed, tmp_path):
    """Four lanes on the same processor's instructions, in other surroundings, give the same bits as eight."""
    np.savez(tmp_path / "info.npz", many=seed.many, start=seed.start)
    line = [sys.executable, "-c", NARROW, str(tmp_path / "info.npz"), str(tmp_path / "batch")]
    surroundings = {"PYTHONHASHSEED": "7", "TZ": "Asia/Tokyo", "LC_ALL": "de_DE.UTF-8", "OMP_NUM_THREADS": "3"}
    subprocess.run(line, check=True, env=os.environ | surroundings | {"TMODES_CACHE": str(tmp_path / "cache")})
    assert load_batch(tmp_path / "batch").states.tobytes() == seed.run().states.tobytes()


def test_each_lane_has_its_own_motion_and_start(seed):
    """Knots at different times, of different number; each lane's steps end on its own."""
    rng = np.random.default_rng(2)
    schedules = []
    for lane in range(5):
        knots = np.linspace(0.0, 0.02, lane + 2) * (1 + 0.3 * (lane == 2))
        schedules.append(Schedule(knots, 0.1 * rng.normal(size=(lane + 1, 3))))
    starts = seed.start + 1e-3 * rng.normal(size=(5, len(seed.start)))
    batch = simulate_lanes(seed.model, seed.model.numbers, schedules, starts, seed.settings)
    for lane in range(5):
        single = alone(seed, seed.model.numbers, schedules[lane], starts[lane])
        assert np.abs(batch.states[lane] - single.states).max() < 1e-12 * np.abs(single.states).max()
        assert batch.statistics["steps"][lane] == single.statistics["steps"]


def test_order_of_the_method_in_lanes(seed):
    """Ten times the tolerance: the error against a much finer run grows as the control of the step lets it."""
    errors = []
    tolerances = np.array([1e-6, 1e-8, 1e-10])
    fine = replace(seed, settings=seed.settings.model_copy(update={"relative_tolerance": 1e-13})).run([0])
    for tolerance in tolerances:
        info = {"relative_tolerance": float(tolerance), "absolute_tolerance": float(tolerance) * 1e-3}
        run = replace(seed, settings=seed.settings.model_copy(update=info)).run([0])
        errors.append(np.abs(run.states[0, :, :6] - fine.states[0, :, :6]).max())
    slope = np.polyfit(np.log(tolerances), np.log(errors), 1)[0]
    assert 0.7 < slope < 1.3
