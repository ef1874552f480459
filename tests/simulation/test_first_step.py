"""The first step of adaptive methods: a robot at rest, whose state is no more than rounding, is set in motion."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import tmodes
from tmodes.integrate.registry import integrators
from tmodes.robots import installed_models
from tmodes.robots.load import sheet_names
from tmodes.sheet import Robot
from tmodes.simulation.initial_state import run_setup, run_trajectory
from tmodes.simulation.plan import Follow
from wasm.node import page_states

SIGNALS = {
    "sine": {"type": "sine", "amplitude": 0.3, "frequency": 1.0},
    "ramp": {"type": "expression", "formula": "0.5*t"},
    "parabola": {"type": "expression", "formula": "0.5*t**2"},
}
ROBOTS = [name for name in sheet_names() if installed_models() or name not in ("panda_elastic", "ur5_elastic")]
ADAPTIVE = [one.name for one in integrators().values() if one.adaptive]
LIGHTEST = "spong1987"
"""Its arm hangs at rest exactly where its motor is commanded to be."""


def moved(name: str, signal: str, method: str, **settings: float) -> Robot:
    """A published robot whose drives all follow a signal, from rest."""
    robot = tmodes.load(name)
    drives = {f"drives.{k}.signal": SIGNALS[signal] for k in range(len(robot.drives))}
    rest = {"initial": {"state": "rest"}, "integration.method": method}
    return robot.with_({**drives, **rest, **{f"integration.{key}": value for key, value in settings.items()}})


@pytest.mark.parametrize(
    ("name", "method"), [*((name, ADAPTIVE[0]) for name in ROBOTS), *((LIGHTEST, method) for method in ADAPTIVE[1:])]
)
def test_every_robot_gets_under_way(name: str, method: str) -> None:
    """By one method, and one by every method: with every signal, as planned and under control.

    Over a span by which rounding is measured (2 s).
    """
    for signal in SIGNALS:
        robot = moved(name, signal, method, duration=2.0, output_step=0.1, max_steps=3)
        follows = (Follow.SHEET, Follow.WANTED) if method == ADAPTIVE[0] else (Follow.SHEET,)
        for follow in follows:
            run = run_trajectory(run_setup(robot.pair().real, follow))
            assert (run.status, run.statistics["steps"] + run.statistics["rejected"]) == ("stopped", 3), run.message


@pytest.mark.parametrize("signal", SIGNALS)
def test_side_by_side_and_in_a_page_as_alone(signal: str, tmp_path: Path) -> None:
    """All loops begin with the same step."""
    robot = moved(LIGHTEST, signal, "dormand_prince", duration=0.1, output_step=0.01)
    setup = run_setup(robot.pair().real)
    alone = run_trajectory(setup)
    assert alone.status == "finished"
    batch = tmodes.simulate_batch(robot, {"gravity": [9.8, 9.7]})
    assert batch.finished.all()
    largest = np.abs(alone.states).max()
    np.testing.assert_allclose(batch.states[0], alone.states, rtol=0, atol=1e-11 * largest)
    np.testing.assert_allclose(page_states(setup, tmp_path), alone.states, rtol=0, atol=1e-11 * largest)
    assert batch.statistics["evaluations"][0] == alone.statistics["evaluations"]
