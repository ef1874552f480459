"""Series of cases on a device: what is made of them is what the processor makes of runs side by side."""

from __future__ import annotations

import numpy as np
import pytest

import tmodes
from tmodes.compile.gpu.cuda import HostDevice
from tmodes.simulation.batch.executor import Executor
from tmodes.simulation.gpu.block import loop_of
from tmodes.simulation.gpu.run import OnDevice, run_on_gpu
from tmodes.simulation.outputs import robot_outputs
from tmodes.simulation.vary import arrays
from tmodes.simulation.vary.reduce import Reduction, reduced

from .conftest import NIGHTLY

pytestmark = pytest.mark.nightly

HOWS = ("max", "min", "max_abs", "mean", "rms", "end", "range", "time_of_max")

ROBOTS = {
    "filipovic2010": (
        {"integration.duration": 0.3, "integration.output_step": 0.013},
        {"real.gear.stiffness": [0.16, 0.2, 0.24, 0.21, 0.19], "payload.mass": [0.45, 0.5, 0.55, 0.52, 0.51]},
    ),
    "spong1987": ({"integration.duration": 0.3}, {"joints.joint.gear.stiffness": [60.0, 80, 140, 120, 90]}),
    "flexarm1990": (
        {"integration.duration": 0.2},
        {"real.links.forearm.beam.section.bending_stiffness": [0.9, 1.1, 1.0, 0.95, 1.05]},
    ),
    "deluca_siciliano1991": (
        {"integration.duration": 1.0}, {"links.forearm.bodies.payload.mass": [0.05, 0.07, 0.1, 0.2, 0.12]},
    ),
}  # fmt: skip
"""The last one is stiff: its method has no series on a device, and they are made of its samples."""


@pytest.fixture(autouse=True)
def as_arrays(monkeypatch):
    """Also few cases are prepared as arrays."""
    monkeypatch.setattr(arrays, "_FEW", 2)


class Everything(Executor):
    """Runs all methods on a device; ``used``: which of the works had series there."""

    def __init__(self):
        self.used = []

    def run(self, problems, results, threads, progress):
        self.used.extend(loop_of(work).series is not None for work in problems)
        run_on_gpu(problems, results, progress, device=HostDevice())


def asked(robot):
    """All reductions of all series that are compiled."""
    names = [each for each in robot_outputs(robot) if not each.startswith(("energy.", "power.", "base."))]
    return [Reduction(series, how) for series in names for how in HOWS]


@pytest.mark.parametrize(("name", "written"), [
    ("filipovic2010", False), pytest.param("filipovic2010", True, marks=NIGHTLY),
    pytest.param("spong1987", False, marks=NIGHTLY), ("spong1987", True),
    ("flexarm1990", False), pytest.param("flexarm1990", True, marks=NIGHTLY),
    pytest.param("deluca_siciliano1991", False, marks=NIGHTLY), ("deluca_siciliano1991", True),
])  # fmt: skip
def test_reductions_of_all_series(name, written):
    """Reduced after each launch, or written for percentiles; distances from a nominal tip are among them."""
    changes, vary = ROBOTS[name]
    robot = tmodes.load(name).with_(changes)
    wanted, device = asked(robot), Everything()
    wanted += [Reduction(one.series, "percentile:90") for one in wanted[:: len(HOWS)] if written]
    there = reduced(robot, vary, wanted, threads=1)
    here = reduced(robot, vary, wanted, threads=1, executor=device)
    assert device.used[-1] == (name != "deluca_siciliano1991")  # after those of nominal robots
    assert tuple(here.status) == tuple(there.status) == ("finished",) * 5
    assert (here.method == there.method).all()
    for one in wanted:
        size = max(np.abs(there.values[Reduction(one.series, "max_abs")]).max(), 1e-5)
        size = 1.0 if one.how == "time_of_max" else size
        if one.how == "time_of_max" and name != "spong1987":
            continue  # of what is flat any sample may be the largest by rounding
        error = (4e-6 if name == "deluca_siciliano1991" else 1e-7) * size
        error *= 100 if "acceleration" in one.series else 1  # an error of a deflection times how stiff it is
        assert here.values[one] == pytest.approx(there.values[one], abs=error), one
    for count in ("steps", "rejected"):
        assert np.abs(here.statistics[count] - there.statistics[count]).max() <= 2


def test_launches_and_blocks_change_no_bit_of_a_reduction(monkeypatch):
    changes, vary = ROBOTS["filipovic2010"]
    robot = tmodes.load("filipovic2010").with_(changes)
    wanted = asked(robot)
    whole = reduced(robot, vary, wanted, threads=1, executor=Everything())
    monkeypatch.setattr("tmodes.simulation.gpu.run._FIRST", 3)
    monkeypatch.setattr("tmodes.simulation.native_run._PIECE_SECONDS", 0.0)
    monkeypatch.setattr("tmodes.simulation.gpu.run.block_size", lambda work, loop, device: 2)
    parted = reduced(robot, vary, wanted, threads=1, executor=Everything())
    for one in wanted:
        assert parted.values[one].tobytes() == whole.values[one].tobytes()


class Counting(OnDevice):
    """Knows how many cases each call had."""

    def __init__(self):
        super().__init__(HostDevice())
        self.cases = []

    def run(self, problems, results, threads, progress):
        self.cases.append(sum(work.size for work in problems))
        super().run(problems, results, threads, progress)


@pytest.mark.parametrize(("vary", "calls"), [
    ({"real.gear.stiffness": [0.16, 0.2, 0.24]}, [3]), ({"gear.stiffness": [0.16, 0.2, 0.24]}, [3, 3]),
])  # fmt: skip
def test_a_nominal_run_that_stands_for_all_is_on_the_processor(vary, calls):
    """One thread of a GPU is slower than a core; of nominal robots that differ each is a case."""
    robot = tmodes.load("filipovic2010").with_({"integration.duration": 0.01, "integration.method": "rk4"})
    device = Counting()
    found = reduced(robot, vary, [Reduction("deviation", "max")], threads=1, executor=device)
    assert tuple(found.status) == ("finished",) * 3
    assert device.cases == calls
    assert device.there == sum(calls)
