"""Cases on the NVIDIA GPU of this machine, where there is one: what it computes is what the processor computes."""

from __future__ import annotations

import numpy as np
import pytest

import tmodes
from simulation.sheets import pendulum, torque
from tmodes.compile.gpu.cuda import HostDevice, first_gpu, unavailable
from tmodes.simulation.gpu.run import OnDevice
from tmodes.simulation.initial_state import run_setup
from tmodes.simulation.vary import arrays
from tmodes.simulation.vary.reduce import Reduction, reduced

from .conftest import on_device, varied
from .test_series import ROBOTS, asked

pytestmark = pytest.mark.skipif(bool(unavailable()), reason=f"no GPU: {unavailable()}")

METHODS = ("rk4", "midpoint", "dormand_prince", "dop853", "extrapolation", "rosenbrock")


def on_both(cases):
    """States of cases on the processor and on the GPU, where all must end alike."""
    here, there = cases.work(), cases.work()
    before, runs = on_device([here], device=HostDevice()), on_device([there], device=first_gpu())
    assert set(runs.status) == set(before.status) == {"finished"}
    return here.states, there.states


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("name", ["published", "swinging"])
def test_states_of_all_methods(request, name, method):
    """Products and sums that the GPU rounds once differ by rounding: differences of extrapolated rows enlarge it."""
    cases = request.getfixturevalue(name).by(method)
    here, there = on_both(cases)
    allowed = cases.settings.relative_tolerance * (10 if method == "extrapolation" else 1)
    assert np.abs(there - here).max() < allowed * np.abs(here).max()


@pytest.mark.parametrize("name", ["spong1987", "flexarm1990", "deluca_siciliano1991"])
def test_kernels_that_are_called(name):
    robot = tmodes.load(name)
    settings = robot.integration.model_copy(
        update={"method": "rk4", "duration": 2e-3, "output_step": 1e-4, "step": 2e-6}
    )
    here, there = on_both(varied(run_setup(robot), settings, 130, 1e-3))
    assert np.abs(there - here).max() < 1e-9 * np.abs(here).max()


@pytest.mark.parametrize("name", [name for name in ROBOTS if name != "deluca_siciliano1991"])
def test_reductions(monkeypatch, name):
    monkeypatch.setattr(arrays, "_FEW", 2)
    changes, vary = ROBOTS[name]
    robot = tmodes.load(name).with_(changes)
    wanted = asked(robot)
    there = reduced(robot, vary, wanted, threads=1)
    here = reduced(robot, vary, wanted, threads=1, executor=OnDevice(first_gpu()))
    assert here.status.tolist() == there.status.tolist() == ["finished"] * 5
    for one in wanted:
        if one.how != "time_of_max":  # of what is flat any sample may be the largest by rounding
            size = max(np.abs(there.values[Reduction(one.series, "max_abs")]).max(), 1e-5)
            assert here.values[one] == pytest.approx(there.values[one], abs=1e-7 * size), one


def test_sines_of_large_angles():
    """Our own reduction of angles: a pendulum that has turned many times."""
    robot = pendulum({"inertia": 0.3}, {"stiffness": 100.0}, torque(50.0), integration={"duration": 5.0})
    settings = robot.integration.model_copy(update={"method": "dop853"})
    here, there = on_both(varied(run_setup(robot), settings, 70, 0.02))
    assert np.abs(there - here).max() < 1e-5 * np.abs(here).max()
