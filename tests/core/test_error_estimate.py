"""The estimated error of a run, against the true one: of its states and of its headline figures."""

from __future__ import annotations

import numpy as np
import pytest

import tmodes
from tmodes.simulation.start import run_setup, run_trajectory

TIGHT = {"relative_tolerance": 1e-13, "absolute_tolerance": 1e-16}


def with_settings(robot, **changes):
    return robot.with_({f"integration.{name}": value for name, value in changes.items()})


def trajectory(robot, **changes):
    return run_trajectory(run_setup(with_settings(robot, **changes)))


def sizes(run, exact):
    """Largest true and estimated error of each coordinate and rate, and whether the estimate has a sign."""
    assert run.error is not None
    true = np.abs(run.states - exact.states)[:, :12].max(axis=0)
    assert (np.diff(run.error.values, axis=0) >= 0).all() != run.error.signed
    return true, np.abs(run.error.values)[:, :12].max(axis=0), run.error.signed


@pytest.fixture(scope="module")
def exact(robot):
    return trajectory(robot, **TIGHT)


@pytest.mark.parametrize("method", ["dormand_prince", "dop853"])
@pytest.mark.parametrize("tolerance", [1e-6, 1e-9])
def test_local_errors_bound_a_stable_motion(robot, exact, method, tolerance):
    """Their sum is above the true error, of each component, and not beyond all reason."""
    run = trajectory(robot, method=method, relative_tolerance=tolerance, absolute_tolerance=tolerance * 1e-3)
    true, info, signed = sizes(run, exact)
    assert not signed
    assert (info > true / 3).all()
    assert info.max() < 2e3 * true.max()


@pytest.mark.parametrize(
    "changes",
    [
        {"check_error": True},
        {"check_error": True, "method": "dop853", "relative_tolerance": 1e-7, "absolute_tolerance": 1e-10},
        {"method": "rk4", "step": 1e-4},
        {"method": "rk4", "step": 1e-4, "check_error": True},
    ],
)
def test_second_runs_give_the_error_itself(robot, exact, changes):
    """By tolerances ten times smaller, or steps twice as long or half: right within a factor of three."""
    run = trajectory(robot, **changes)
    true, info, signed = sizes(run, exact)
    assert signed
    assert (info > true / 3).all()
    assert (info < 3 * true).all()


def test_no_estimate_from_a_run_that_is_lost(robot):
    """Twice a step that is just stable is not: rk4 gives no error then, and the run is whole."""
    run = trajectory(robot, method="rk4", step=1.4e-3, duration=0.2)
    assert run.status == "finished"
    assert run.error is None


def test_estimate_interrupted(robot):
    """Ctrl-C in the second run: the run counts as interrupted, so that the same command continues."""
    from tmodes.simulation.parts import Trajectory
    from tmodes.simulation.trajectory import with_error

    done = Trajectory(np.zeros(1), np.zeros((1, 2)), "finished", "reached the end")
    cut = Trajectory(np.zeros(1), np.zeros((1, 2)), "interrupted", "interrupted")
    settings = with_settings(robot, check_error=True).integration
    assert with_error(done, settings, lambda changed: cut).status == "interrupted"


def flat(info, start=""):
    """All numbers of a summary by their path."""
    found = {}
    for key, value in info.items():
        if isinstance(value, dict):
            found |= flat(value, f"{start}{key}.")
        elif isinstance(value, float):
            found[start + key] = value
    return found


@pytest.mark.parametrize(("changes", "most"), [({}, 3e3), ({"check_error": True}, 3.0)])
def test_headline_figures(robot, changes, most):
    """Next to every figure stands an error that is not far below the true one; sharp where it was asked for."""
    coarse = {"relative_tolerance": 1e-7, "absolute_tolerance": 1e-10}
    published = tmodes.load("filipovic2010")
    result, exact = (tmodes.run(with_settings(published, **given)) for given in (coarse | changes, TIGHT))
    info = result.summary()["error"]["figures"]
    is_, should = flat(result.summary()), flat(exact.summary())
    true = {name: abs(is_[name] - should[name]) for name in info if name in is_}
    tips = [one.data["tip"].values for one in (result, exact)]
    true["tip_m"] = np.linalg.norm(tips[0] - tips[1], axis=1).max()
    assert set(true) == set(info)
    assert all(info[name] > true[name] / 2 - 1e-16 for name in info)
    assert info["tip_m"] < most * true["tip_m"]
    deviations = [name for name in info if name.startswith(("deviation", "deformations"))]
    assert len(deviations) == 7
    assert all(info[name] < 1e-4 * is_[name] for name in deviations)
