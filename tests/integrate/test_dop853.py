"""The explicit method of order 8: its table, its order, its dense output, and samples where the motion is stiff."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import DOP853, solve_ivp

from tmodes.integrate.dop853 import DENSE, ERROR_3, ERROR_5, STAGES, A, C
from tmodes.simulation.plan import Follow

from .test_integrators import LOSSLESS, STILL, integrated, prepared
from .test_integrators import plucked as away


@pytest.fixture(scope="module")
def plucked(robot):
    """The arm with its motor held and no losses, away from rest: nothing fast, nothing that jumps."""
    setup = prepared(robot.with_(LOSSLESS | STILL), Follow.WANTED)
    state = away(setup)

    def run(tolerance, method="dop853", output_step=0.5):
        return integrated(
            setup, state, method=method, duration=0.5, output_step=output_step, relative_tolerance=tolerance,
            absolute_tolerance=tolerance * 1e-2,
        )  # fmt: skip

    return run


def dense(rows):
    """The table of dictionaries as arrays."""
    table = np.zeros((len(rows), len(C)))
    for k, row in enumerate(rows):
        table[k, list(row)] = list(row.values())
    return table


def test_table():
    """Row sums, the order conditions of a quadrature of order 8, and SciPy's copy of the published coefficients."""
    a, c = dense(A), np.array(C)
    assert np.allclose(a.sum(axis=1), c, atol=4e-15)
    for power in range(8):
        assert a[STAGES] @ c**power == pytest.approx(1 / (power + 1), abs=1e-14)
    assert np.array_equal(a[:STAGES, :STAGES], DOP853.A)
    assert np.array_equal(a[STAGES + 1 :], DOP853.A_EXTRA)
    assert np.array_equal(dense(DENSE), DOP853.D)
    for weights, theirs in ((ERROR_3, DOP853.E3), (ERROR_5, DOP853.E5)):
        assert np.allclose(dense([weights])[0, : STAGES + 1], theirs, atol=1e-16)


def fitted(exact, runs):
    counts = [run.statistics["steps"] for run in runs]
    errors = [np.abs(run.states - exact.states)[:, :12].max() for run in runs]
    return np.polyfit(np.log(counts), np.log(errors), 1)[0]


def test_order_at_the_end(plucked):
    """The error falls with the eighth power of the number of steps."""
    runs = [plucked(tolerance) for tolerance in (1e-6, 1e-7, 1e-8, 1e-9)]
    assert fitted(plucked(1e-13), runs) == pytest.approx(-8.0, abs=1.0)


def test_order_between_the_steps(plucked):
    """So does that of dense samples: of order 7, one below that of the steps, or better."""
    runs = [plucked(tolerance, output_step=1e-3) for tolerance in (1e-6, 1e-7, 1e-8, 1e-9)]
    assert fitted(plucked(1e-13, output_step=1e-3), runs) < -6.5


def test_agrees_with_scipy_at_its_tightest(robot):
    """SciPy's DOP853 on the same right-hand side, from knot to knot, and its dense output."""
    setup = prepared(robot)
    schedule, state = setup.planned.schedule, setup.start
    ours = integrated(
        setup, method="dop853", duration=0.6, output_step=1e-2, relative_tolerance=1e-12, absolute_tolerance=1e-15
    )
    for start, end in ((0.0, 0.4), (0.4, 0.6)):
        row = schedule.rows_at(np.array([start]))[0]
        inside = (ours.times > start) & (ours.times <= end)
        done = solve_ivp(
            lambda t, y, row=row: setup.model.rate([t], y, row)[0], (start, end), state, "DOP853",
            ours.times[inside], rtol=1e-12, atol=1e-15,
        )  # fmt: skip
        state = done.y[:, -1]
        assert np.abs(ours.states[inside, :6] - done.y[:6].T).max() < 1e-11


def test_samples_are_as_good_as_the_steps_where_stability_holds_the_step(robot):
    """A fast motion that is stable but not followed spoils what lies between steps; it is seen and the step shortened.

    Without that the rates between steps are off by 1e5 tolerances here (SciPy's are too).
    """
    runs = {}
    setup = prepared(robot)
    for method, tolerance in (("dop853", 1e-8), ("dormand_prince", 1e-12)):
        change = {"method": method, "relative_tolerance": tolerance, "absolute_tolerance": tolerance * 1e-3}
        runs[method] = integrated(setup, duration=0.6, **change).states[:, :12]
    assert np.abs(runs["dop853"] - runs["dormand_prince"]).max() < 3e-7
