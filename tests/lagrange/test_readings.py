"""Both readings of the 2010 paper as systems of energies: whole loops, implicit steps, linearisation."""

from __future__ import annotations

import numpy as np
import pytest

from lagrange.robot2010 import chain, close, plan
from tmodes.equations.loop.closed_loop import ClosedLoop
from tmodes.model.model import Model
from tmodes.simulation.loop import LoopModel

READINGS = ("printed", "consistent")


@pytest.mark.parametrize("contact", [False, True])
def test_the_recursion_is_the_consistent_reading(contact: bool) -> None:
    """Two makers, nothing in common but the numbers: the same accelerations, forces and works at random states."""
    random = np.random.default_rng(7)
    models = [LoopModel(plan(name, contact=contact)) for name in ("consistent", "recursion")]
    for _ in range(20):
        state = np.concatenate([random.normal(scale=0.3, size=12), np.zeros(7)])
        row = np.array([0.0, random.normal() * 10])
        rates, seen = zip(*((m.rate(0.0, state, row)[0], m.observe(0.0, state, row)) for m in models), strict=True)
        close(rates[1], rates[0], 1e-11)
        for name in ("contact", "gear", "drives", "contact_fold"):
            close(seen[1][name], seen[0][name], 1e-11)


@pytest.mark.parametrize("reading", READINGS)
def test_implicit_steps_begin_as_the_rate(reading: str) -> None:
    """With a step of zero they are the rate; h D + h^2 K is what the derivatives of the forces say."""
    loop = ClosedLoop(plan(reading, contact=True))
    from tmodes.model.evaluator import evaluate

    numbers = loop.parts.numbers.vector
    state = np.concatenate([np.random.default_rng(3).normal(scale=0.2, size=12), np.zeros(7)])[None]
    blocks = {"time": np.zeros((1, 1)), "state": state, "start": state[:, :12], "row": np.array([[0.0, 3.0]])}
    blocks["step"] = np.zeros((1, 1))
    explicit = evaluate(numbers, loop.rate, blocks, 1)["rate"]
    for schedule in (loop.implicit_rate, loop.euler_rate):
        close(evaluate(numbers, schedule, blocks, 1)["rate"], explicit, 1e-12)


def test_linearised_is_a_difference_of_forces() -> None:
    model = Model(chain("printed"))
    q = np.array([0.1, 0.2, 0.02, -0.03, 0.05, 0.04])
    _, damping, stiffness = model.linearised(q)
    step, zero = 1e-6, np.zeros(6)
    for k in range(6):
        change = np.eye(6)[k] * step
        forces = [model.inverse_dynamics(q + side * change, zero, zero) for side in (1, -1)]
        close((forces[0] - forces[1]) / (2 * step), stiffness[:, k], 1e-6)
        forces = [model.inverse_dynamics(q, side * change, zero) for side in (1, -1)]
        close((forces[0] - forces[1]) / (2 * step), damping[:, k], 1e-6)
