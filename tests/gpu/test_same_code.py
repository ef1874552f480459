"""The code of a GPU's thread on this machine's processor: a case is the run by itself."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import tmodes
from tmodes.compile.gpu.cuda import HostDevice
from tmodes.kinds.signals.schedule import SignalPieces
from tmodes.simulation.initial_state import run_setup

from .conftest import NIGHTLY, on_device, varied


def both(first, second):
    """Two methods of a kind; the second one of the paper's robot each night."""
    late = pytest.param("published", second, marks=NIGHTLY)
    return pytest.mark.parametrize(
        ("name", "method"), [("published", first), late, ("swinging", first), ("swinging", second)]
    )


@pytest.fixture
def cases(request, name):
    return request.getfixturevalue(name)


def states(cases, **how):
    """The states of all cases, and their trajectories."""
    work = cases.work()
    runs = on_device([work], device=HostDevice(**how))
    return work.states, runs


@both("rk4", "midpoint")
def test_fixed_steps_are_those_of_single_runs_bit_by_bit(cases, method):
    cases = cases.by(method)
    found, runs = states(cases)
    assert set(runs.status) == {"finished"}
    for case in range(len(found)):
        single = cases.alone(case)
        assert found[case].tobytes() == single.states.tobytes()
        assert runs.statistics["evaluations"][case] == single.statistics["evaluations"]
        assert runs.message[case] == single.message
    assert len({state.tobytes() for state in found}) == len(found)


@both("dormand_prince", "dop853")
def test_adaptive_steps_differ_by_powers_alone(cases, method):
    """Powers of our own set the lengths of steps: with those of the C library, every bit is that of the single run."""
    cases = cases.by(method)
    own, runs = states(cases)
    exact, _ = states(cases, mathematics=False)
    tolerance = cases.settings.relative_tolerance
    for case in range(len(own)):
        single = cases.alone(case)
        assert exact[case].tobytes() == single.states.tobytes()
        assert np.abs(own[case] - single.states).max() < tolerance * np.abs(single.states).max()
        assert abs(runs.statistics["steps"][case] - single.statistics["steps"]) <= 1
    assert own.tobytes() != exact.tobytes()


@pytest.mark.parametrize("method", ["extrapolation", "rosenbrock"])
def test_implicit_methods_pass_through_unchanged(swinging, method):
    cases = replace(swinging.by(method), numbers=swinging.numbers[:4])
    exact, _ = states(cases, mathematics=False)
    for case in range(4):
        assert exact[case].tobytes() == cases.alone(case).states.tobytes()


@pytest.mark.parametrize("name", ["spong1987", "flexarm1990", "deluca_siciliano1991"])
def test_kernels_that_are_called_are_linked_in(name):
    """A small schedule is one program; of a larger one each kernel is a function of its own."""
    robot = tmodes.load(name)
    settings = robot.integration.model_copy(
        update={"method": "rk4", "duration": 2e-4, "output_step": 1e-4, "step": 2e-6}
    )
    cases = varied(run_setup(robot), settings, 3, 1e-3)
    found, _ = states(cases)
    for case in range(3):
        assert found[case].tobytes() == cases.alone(case).states.tobytes()


def test_each_case_has_its_own_motion_and_start(published):
    """Knots at different times, of different number, padded to the longest."""
    rng, width = np.random.default_rng(2), published.schedules[0].coefficients.shape[1]
    schedules = []
    for case in range(5):
        knots = np.linspace(0.0, 0.005, case + 2) * (1 + 0.3 * (case == 2))
        schedules.append(SignalPieces(knots, 0.1 * rng.normal(size=(case + 1, width))))
    starts = published.starts + 1e-3 * rng.normal(size=(5, published.starts.shape[1]))
    given = replace(
        published.by("rk4"), schedules=tuple(schedules), starts=starts, numbers=np.array(published.numbers[:5])
    )
    work = given.work()
    on_device([work], device=HostDevice())
    for case in range(5):
        until = work.schedules[case]
        single = replace(given, schedules=(until,) * 5).alone(case)
        assert work.states[case].tobytes() == single.states.tobytes()
