"""Implicit methods for the 2010 robot: consistent with its rate, of their order, right where gears are stiff."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
from tmodes.equations.lagrange.implicit_step import implicit_rate_function
from tmodes.paper.environment import FrictionLaw
from tmodes.paper.mechanism import Drive, Mechanism, Reading
from tmodes.paper.model import PaperModel
from tmodes.paper.model_loops import rate_of

import tmodes
from tmodes.errors import InputErrors
from tmodes.kinds.signals.schedule import Schedule

from .test_integrators import LOSSLESS, plucked, run, slope

RIGID = [frozenset[str](), frozenset(["gear"]), frozenset(["mode1", "mode2"])]
STRUCTURES = [
    Mechanism(*one) for one in itertools.product(Reading, [None, *FrictionLaw], Drive, RIGID)
]  # fmt: skip


@pytest.fixture(scope="module")
def numbers(robot):
    return np.array([value for _, value in robot.numbers()])


@pytest.mark.parametrize("mechanism", STRUCTURES, ids=lambda one: one.key)
def test_a_step_without_length_is_the_rate(mechanism, numbers):
    """The forces at a step's end, sorted again, are the forces."""
    rate, implicit = rate_of(mechanism), implicit_rate_function(mechanism)
    random = np.random.default_rng(5)
    state, row = 0.3 * random.normal(size=17), random.normal(size=mechanism.reference_degree + 2)
    plain = rate(0.4, state, row, numbers).full().ravel()
    found = implicit(0.4, state, state[:12], row, 0.0, numbers).full().ravel()
    np.testing.assert_allclose(found, plain, rtol=1e-12, atol=1e-12 * abs(plain).max())


@pytest.mark.parametrize("method", ["extrapolation", "rosenbrock"])
@pytest.mark.parametrize("contact", [False, True])
@pytest.mark.parametrize("reading", Reading)
def test_agree_with_explicit_steps_along_the_path(robot, method, reading, contact):
    """Coordinates, rates and works, from rest over the jumps of the move; tighter tolerances, smaller errors."""
    kind = {"reading": reading, "contact": contact, "duration": 0.5}
    exact = run(robot, method="dop853", relative_tolerance=1e-13, absolute_tolerance=1e-15, **kind)
    errors = []
    for tolerance in (1e-6, 1e-9):
        one = run(robot, method=method, relative_tolerance=tolerance, absolute_tolerance=1e-3 * tolerance, **kind)
        errors.append(np.abs(one.states - exact.states)[:, [*range(6), *range(12, 17)]].max())
    assert errors[0] < 2e-6
    assert errors[1] < 2e-9


def test_order_of_midpoint(robot):
    """Works included, in contact."""
    exact = run(robot, contact=True, method="dop853", duration=0.3, relative_tolerance=1e-13).states[-1]
    steps = np.array([4e-4, 2e-4, 1e-4])
    ends = [run(robot, contact=True, method="midpoint", step=h, duration=0.3).states[-1] for h in steps]
    assert slope(steps, [np.abs(end - exact).max() for end in ends]) == pytest.approx(2.0, abs=0.1)


@pytest.mark.parametrize("reading", Reading)
def test_midpoint_keeps_the_energy(robot, reading):
    """Without losses the energy of the plucked arm stays in a band, which beats slowly, over many periods: no drift."""
    lossless, still = robot.with_(LOSSLESS), Schedule(np.array([0.0, 100.0]), np.zeros((1, 3)))
    done = run(
        lossless, Drive.PRESCRIBED, still, plucked, reading, method="midpoint", step=5e-4, duration=100.0,
        output_step=1e-2,
    )  # fmt: skip
    mechanism, parameters = lossless.split(Drive.PRESCRIBED, reading=reading, contact=False)
    rows = still.rows_at(done.times)
    energy = PaperModel(mechanism).observe(done.times, done.states, rows, parameters)["energy"].sum(axis=1)
    drift = np.polyfit(done.times, energy, 1)[0] * done.times[-1]
    half = len(energy) // 2
    bands = [np.ptp(part) for part in (energy[:half], energy[half:])]
    assert bands[0] < 5e-5 * energy[0]
    assert bands[1] / bands[0] == pytest.approx(1.0, abs=0.25)
    assert abs(drift) < 0.2 * bands[0]


@pytest.fixture(scope="module")
def published():
    """The paper's robot as every robot is loaded."""
    return tmodes.load("filipovic2010")


def test_a_gear_that_is_all_but_rigid(published):
    """Explicit steps would be held back by it; the motion is that of a rigid gear, the nearer the stiffer."""
    rigid = tmodes.run(published.with_({"gear.stiffness": float("inf")}))
    apart = []
    for stiffness in (1e7, 1e8):
        stiff = tmodes.run(published.with_({"gear.stiffness": stiffness, "gear.damping": 1e-4 * stiffness}))
        assert "by extrapolation" in stiff.message
        assert stiff.statistics["real"]["method"] == "extrapolation"
        apart.append(float(np.abs(stiff.data["tip"] - rigid.data["tip"]).max()))
    assert apart[0] < 1e-5
    assert apart[0] / apart[1] == pytest.approx(10.0, rel=0.1)


def test_the_default_reports_its_choice(published):
    """Not stiff: explicit, and why."""
    done = tmodes.run(published.with_({"integration.duration": 0.1}))
    assert "by dormand_prince: the fastest eigenvalue" in done.message


@pytest.mark.parametrize("stiffness", [1e8, 1e10, 1e12])
def test_rest_on_a_surface_that_hardly_gives(robot, stiffness):
    """Rounding alone moves the arm there, yet it stands; its bend gives way: the tip comes near to the sphere."""
    mechanism, parameters = robot.with_({"environment.stiffness": stiffness}).split(contact=True)
    model, row = PaperModel(mechanism), np.zeros(mechanism.reference_degree + 2)
    state = model.rest(0.0, parameters)
    assert np.abs(model.rate(0.0, state, row, parameters)).max() < 1e-6
    reach = sum(mode.length for mode in robot.link.modes)
    tip = model.observe(0.0, state, row, parameters)["tip"]
    assert abs(np.linalg.norm(tip) - reach) < 0.1 / np.sqrt(stiffness)


def test_tolerances_below_the_rounding_of_extrapolation(published):
    """Named it is refused in words; chosen by the stiffness it is not."""
    stiff = {"gear.stiffness": 1e9, "gear.damping": 1e3, "integration.relative_tolerance": 1e-11}
    with pytest.raises(InputErrors, match=r"relative_tolerance.*at least 1e-10 for extrapolation"):
        published.with_({**stiff, "integration.method": "extrapolation"})
    done = tmodes.run(published.with_({**stiff, "integration.duration": 0.5}))
    assert "by dormand_prince, because extrapolation rounds above its tolerance" in done.message
