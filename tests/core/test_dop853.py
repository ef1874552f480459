"""The explicit method of order 8: its table, its order, its dense output, and samples where the motion is stiff."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import DOP853, solve_ivp
from tmodes.paper.mechanism import Drive
from tmodes.paper.model import PaperModel

from tmodes.integrate.dop853 import DENSE, ERROR_3, ERROR_5, STAGES, A, C
from tmodes.integrate.settings import Integration
from tmodes.kinds.signals.schedule import Schedule
from tmodes.simulation.trajectory import integrate

STILL = Schedule(np.array([0.0, 10.0]), np.zeros((1, 3)))


@pytest.fixture(scope="module")
def plucked(robot):
    """The arm with its motor held and no losses, away from rest: nothing fast, nothing that jumps."""
    free = {"motor.friction": 0.0, "gear.damping": 0.0, "link.modes.0.damping_time": 0.0}
    mechanism, parameters = robot.with_(free).split(Drive.PRESCRIBED, contact=False)
    model = PaperModel(mechanism)
    state = model.rest(0.0, parameters)
    state[:5] += [0.010, 0.03, 0.008, 0.004, -0.03]

    def run(tolerance, method="dop853", output_step=0.5):
        settings = Integration(
            method=method, duration=0.5, output_step=output_step, relative_tolerance=tolerance,
            absolute_tolerance=tolerance * 1e-2,
        )  # fmt: skip
        return integrate(model, parameters, STILL, state, settings)

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
    mechanism, parameters = robot.split(Drive.CONTROLLED, contact=False)
    model, schedule = PaperModel(mechanism), robot.reference.schedule()
    state = model.rest(0.0, parameters)
    settings = Integration(
        method="dop853", duration=0.6, output_step=1e-2, relative_tolerance=1e-12, absolute_tolerance=1e-15
    )
    ours = integrate(model, parameters, schedule, state, settings)
    for start, end in ((0.0, 0.4), (0.4, 0.6)):
        row = schedule.rows_at([start])[0]
        inside = (ours.times > start) & (ours.times <= end)
        done = solve_ivp(
            lambda t, y, row=row: model.rate([t], y, row, parameters)[0], (start, end), state, "DOP853",
            ours.times[inside], rtol=1e-12, atol=1e-15,
        )  # fmt: skip
        state = done.y[:, -1]
        assert np.abs(ours.states[inside, :6] - done.y[:6].T).max() < 1e-11


def test_samples_are_as_good_as_the_steps_where_stability_holds_the_step(robot):
    """A fast motion that is stable but not followed spoils what lies between steps; it is seen and the step shortened.

    Without that the rates between steps are off by 1e5 tolerances here (SciPy's are too).
    """
    runs = {}
    for method, tolerance in (("dop853", 1e-8), ("dormand_prince", 1e-12)):
        change = {"method": method, "relative_tolerance": tolerance, "absolute_tolerance": tolerance * 1e-3}
        sheet = robot.with_({f"integration.{name}": value for name, value in change.items()})
        mechanism, parameters = sheet.split(Drive.CONTROLLED, contact=False)
        model = PaperModel(mechanism)
        settings = sheet.integration.model_copy(update={"duration": 0.6})
        start = model.rest(0.0, parameters)
        runs[method] = integrate(model, parameters, sheet.reference.schedule(), start, settings).states[:, :12]
    assert np.abs(runs["dop853"] - runs["dormand_prince"]).max() < 3e-7
