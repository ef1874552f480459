"""Implicit methods for the 2010 robot: consistent with its rate, of their order, right where gears are stiff."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest

import tmodes
from tmodes.errors import InputErrors
from tmodes.model.passes import evaluate
from tmodes.simulation.plan import Follow

from .test_integrators import LOSSLESS, STILL, energies, integrated, plucked, prepared, run, slope

READINGS = ("printed", "consistent", "recursion")
RIGID = {"none": {}, "gear": {"gear.stiffness": math.inf}}
STRUCTURES = [*itertools.product(READINGS, ["free", "signed", "magnitude"], Follow, RIGID)]


@pytest.mark.parametrize(("reading", "law", "follow", "rigid"), STRUCTURES)
def test_a_step_without_length_is_the_rate(robot, reading, law, follow, rigid):
    """The forces at a step's end, sorted again, are the forces."""
    changes = RIGID[rigid] | ({} if law == "free" else {"environment.friction_law": law})
    setup = prepared(robot.with_(changes), follow, reading=reading, contact=law != "free")
    loop, random, size = setup.model.loop, np.random.default_rng(5), len(setup.model.coordinates)
    state = np.zeros((1, len(setup.start)))
    state[0, : 2 * size] = 0.2 * random.normal(size=2 * size)
    blocks = {"time": np.full((1, 1), 0.4), "state": state, "row": setup.planned.schedule.rows_at(np.array([0.4]))}
    blocks |= {"start": state[:, : 2 * size], "step": np.zeros((1, 1))}
    plain, found = (
        evaluate(setup.model.numbers, schedule, blocks, 1)["rate"][0] for schedule in (loop.rate, loop.implicit_rate)
    )
    np.testing.assert_allclose(found, plain, rtol=1e-11, atol=1e-12 * abs(plain).max())


@pytest.mark.parametrize("method", ["extrapolation", "rosenbrock"])
@pytest.mark.parametrize("contact", [False, True])
@pytest.mark.parametrize("reading", READINGS[:2])
def test_agree_with_explicit_steps_along_the_path(robot, method, reading, contact):
    """Coordinates, rates and works, from rest over the jumps of the move; tighter tolerances, smaller errors."""
    kind = {"reading": reading, "contact": contact, "duration": 0.5}
    exact = run(robot, method="dop853", relative_tolerance=1e-13, absolute_tolerance=1e-15, **kind)
    errors = []
    for tolerance in (1e-6, 1e-9):
        one = run(robot, method=method, relative_tolerance=tolerance, absolute_tolerance=1e-3 * tolerance, **kind)
        errors.append(np.abs(one.states - exact.states)[:, [*range(6), *range(12, exact.states.shape[1])]].max())
    assert errors[0] < 2e-6
    assert errors[1] < 4e-9


def test_order_of_midpoint(robot):
    """Works included, in contact."""
    exact = run(robot, contact=True, method="dop853", duration=0.3, relative_tolerance=1e-13).states[-1]
    steps = np.array([4e-4, 2e-4, 1e-4])
    ends = [run(robot, contact=True, method="midpoint", step=h, duration=0.3).states[-1] for h in steps]
    assert slope(steps, [np.abs(end - exact).max() for end in ends]) == pytest.approx(2.0, abs=0.1)


@pytest.mark.parametrize("reading", READINGS[:2])
def test_midpoint_keeps_the_energy(robot, reading):
    """Without losses the energy of the plucked arm stays in a band, which beats slowly, over many periods: no drift."""
    setup = prepared(robot.with_(LOSSLESS | STILL), Follow.WANTED, reading=reading)
    done = integrated(setup, plucked(setup), method="midpoint", step=5e-4, duration=100.0, output_step=1e-2)
    energy = energies(setup, done)
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


@pytest.mark.nightly
def test_a_gear_that_is_all_but_rigid(published):
    """Explicit steps would be held back by it; the motion is that of a rigid gear, the nearer the stiffer."""
    rigid = tmodes.run(published.with_({"gear.stiffness": float("inf")}))
    apart = []
    for stiffness in (1e7, 1e8):
        stiff = tmodes.run(published.with_({"gear.stiffness": stiffness, "gear.damping": 1e-4 * stiffness}))
        assert "rosenbrock chosen" in stiff.message  # smooth friction of the contact may be stiff too
        assert stiff.statistics["real"]["method"] == "rosenbrock"
        apart.append(float(np.abs(stiff.data["tip"] - rigid.data["tip"]).max()))
    assert apart[0] < 1e-5
    assert apart[0] / apart[1] == pytest.approx(10.0, rel=0.1)


def test_the_default_reports_its_choice(published):
    """Not stiff: explicit, and why."""
    done = tmodes.run(published.with_({"integration.duration": 0.1}))
    assert "(dormand_prince chosen: fastest eigenvalue" in done.message


@pytest.mark.parametrize("stiffness", [1e8, 1e10, 1e12])
def test_rest_on_a_surface_that_hardly_gives(robot, stiffness):
    """Rounding alone moves the arm there, yet it stands; its bend gives way: the tip comes near to the sphere."""
    setup = prepared(robot.with_({"environment.stiffness": stiffness}), contact=True)
    assert np.abs(setup.model.rate(0.0, setup.start, setup.first_row)).max() < 1e-6
    seen = setup.mechanics.pose(setup.start[setup.model.layout.q])[0][0]
    assert abs(np.linalg.norm(seen) - 0.9) < 0.1 / np.sqrt(stiffness)


def test_tolerances_below_the_rounding_of_extrapolation():
    """Named it is refused in words; chosen by the stiffness it is not."""
    gear = {"joints.joint.gear.stiffness": 1e9, "joints.joint.gear.damping": 1e3}
    stiff, robot = gear | {"integration.relative_tolerance": 1e-11}, tmodes.load("spong1987")
    with pytest.raises(InputErrors, match=r"relative_tolerance.*at least 1e-10 for extrapolation"):
        robot.with_({**stiff, "integration.method": "extrapolation"})
    done = tmodes.run(robot.with_({**stiff, "integration.duration": 1.5}))
    assert "extrapolation would round above the tolerance" in done.message
