"""Every registered integrator, and two defined here: order, samples, batch, derivatives and stability."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

import tmodes
from tmodes.errors import InputError
from tmodes.integrate.method import EXPLICIT, Integrator, explicit
from tmodes.integrate.registry import AUTO, INTEGRATORS, integrator, integrators
from tmodes.integrate.settings import Integration
from tmodes.sheet import Robot
from tmodes.simulation.simulate import simulate_motion
from tmodes.simulation.step_refinement import refined_run

BOGACKI_SHAMPINE = explicit(
    "bogacki_shampine", "explicit, order 3(2), for rough tolerances", 3,
    a=((), (1 / 2,), (0.0, 3 / 4)), b=(2 / 9, 1 / 3, 4 / 9), lower=(7 / 24, 1 / 4, 1 / 3, 1 / 8),
)  # fmt: skip
RALSTON = explicit("ralston", "explicit, order 2, fixed step", 2, a=((), (2 / 3,)), b=(1 / 4, 3 / 4))
OWN = (BOGACKI_SHAMPINE, RALSTON)
NAMES = [*integrators(), *(one.name for one in OWN)]

START, DURATION = 0.6, 0.8


@pytest.fixture(autouse=True)
def registered() -> Iterator[None]:
    """The two of this file are known while its tests run."""
    for one in OWN:
        INTEGRATORS.register(one)
    yield
    for one in OWN:
        INTEGRATORS.unregister(one.name)


def pendulum(method: str, **integration: Any) -> Robot:
    """Two links in gravity, let go: chaotic later, smooth over this time."""
    joints = [
        {"name": "a", "type": "revolute", "parent": "base", "child": "first", "axis": [0, 1, 0]},
        {"name": "b", "type": "revolute", "parent": "first", "child": "second", "axis": [0, 1, 0],
         "origin": {"position": [0, 0, -0.5]}},
    ]  # fmt: skip
    body = {"bodies": [{"name": "bob", "mass": 1.0, "center": [0, 0, -0.5]}]}
    return Robot.from_data({
        "format": 1, "kind": "arm", "name": "pendulum", "gravity": 9.81, "joints": joints,
        "links": [{"name": "first", **body}, {"name": "second", **body}],
        "tip": {"link": "second", "position": [0, 0, -0.5]},
        "initial": {"state": "zero", "coordinates": {"a": START, "b": -START}},
        "drives": [{"joint": name, "command": "effort", "signal": {"type": "constant", "value": 0.0}} for name in "ab"],
        "integration": {"duration": DURATION, "output_step": 0.05, "method": method} | integration,
    })  # fmt: skip


@pytest.fixture(scope="module")
def exact() -> np.ndarray:
    """States at the samples, of a run of order 8 whose error is rounding."""
    return simulate_motion(pendulum("dop853", relative_tolerance=1e-13, absolute_tolerance=1e-15)).states[:, :4]


def accuracy(one: Integrator, part: float) -> dict[str, float]:
    """Settings of which ``part`` makes the error smaller."""
    if one.adaptive:
        tolerance = max(1e-3 * part ** (one.order + 1), one.least_tolerance)
        return {"relative_tolerance": tolerance, "absolute_tolerance": tolerance}
    return {"step": 0.01 * part}


def off(name: str, part: float, exact: np.ndarray) -> float:
    """The largest error of all samples, those within steps too."""
    run = simulate_motion(pendulum(name, **accuracy(integrator(name), part)))
    assert run.status == "finished"
    assert run.statistics["method"] == name
    return float(np.abs(run.states[:, :4] - exact).max())


@pytest.mark.parametrize("name", NAMES)
def test_finer_settings_make_the_error_smaller_by_the_order(name: str, exact: np.ndarray) -> None:
    """Half the step: the error goes down by about 2^order; samples within steps may be of lower order."""
    rough, fine = off(name, 1.0, exact), off(name, 0.25, exact)
    assert fine < 2e-3
    least = 2.0 if integrator(name).adaptive else integrator(name).order - 0.5
    assert rough / fine > 4 ** min(least, 3.5)


@pytest.mark.parametrize("name", NAMES)
def test_it_says_what_it_is(name: str) -> None:
    one = integrator(name)
    assert one.name == name
    assert one.description
    assert one.order >= 1
    assert (one.reach is None) == (one.asks != EXPLICIT)
    if one.tableau is not None:
        z = np.array([-0.02 + 0.01j])
        assert one.tableau.amplification(z)[0] == pytest.approx(np.exp(z[0]), abs=abs(z[0]) ** (one.order + 1))


@pytest.mark.parametrize("name", [name for name in NAMES if name in ("rk4", "dormand_prince", *(o.name for o in OWN))])
def test_side_by_side_as_alone(name: str) -> None:
    """A batch of runs in the vectors of the processor gives the numbers of single runs."""
    robot = pendulum(name, **accuracy(integrator(name), 0.5))
    batch = tmodes.simulate_batch(robot, {"links.first.bodies.bob.mass": [1.0, 1.5, 2.0]})
    assert all(batch.finished)
    single = simulate_motion(robot)
    assert batch.states[0] == pytest.approx(single.states, rel=1e-11, abs=1e-11)
    assert np.abs(batch.states[2] - batch.states[0]).max() > 1e-3


@pytest.mark.parametrize("name", [one.name for one in OWN])
def test_own_ones_are_differentiated(name: str) -> None:
    """The sensitivity of the steps that were taken, against a difference of runs with a fine step."""
    path, settings = "links.second.bodies.bob.mass", accuracy(integrator(name), 0.1)
    found = tmodes.forward_sensitivities(pendulum(name, **settings), [path])
    runs = [simulate_motion(pendulum(name, **settings).with_({path: 1.0 + by})) for by in (-1e-4, 1e-4)]
    slope = (runs[1].states[-1, :4] - runs[0].states[-1, :4]) / 2e-4
    assert found.by[path][-1, :4] == pytest.approx(slope, rel=2e-3, abs=1e-5)


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("part", [1.0, 0.3])
def test_a_second_run_finds_its_error(name: str, part: float, exact: np.ndarray) -> None:
    """Within a factor of two, loose or tight, whatever the order."""
    run = simulate_motion(pendulum(name, **accuracy(integrator(name), part)))
    second = refined_run(run.setup, run)
    assert second is not None
    estimate = run.robot.integration.refined()[1] * np.abs(second.states - run.states)[:, :4].max()
    true = np.abs(run.states[:, :4] - exact).max()
    assert true / 2 < estimate < 2 * true + 1e-12


def test_too_long_a_fixed_step_is_seen_before_the_run() -> None:
    """A stiff spring: the verdict is by the method's own polynomial, 1 + z + z^2/2 of Ralston's."""
    z = np.array([-1.9 + 0j, -2.1 + 0j])
    assert RALSTON.tableau is not None
    assert (np.abs(RALSTON.tableau.amplification(z)) > 1).tolist() == [False, True]
    assert pytest.approx(2.0, abs=0.02) == RALSTON.reach


def test_names_and_tableaus_are_checked() -> None:
    assert INTEGRATORS.register(RALSTON) is RALSTON  # the same again
    for taken in ("ralston", AUTO):
        with pytest.raises(InputError, match="which is taken"):
            INTEGRATORS.register(replace(RALSTON, name=taken, order=3))
    with pytest.raises(InputError, match="tableau"):
        INTEGRATORS.register(Integrator(name="empty", description="nothing", order=1))
    with pytest.raises(InputError, match="sum is 1"):
        explicit("wrong", "weights that do not sum up", 2, a=((), (1.0,)), b=(0.5, 0.6))
    with pytest.raises(ValueError, match="ralston"):
        Integration(method="ralstone")
    assert AUTO not in integrators()
