"""Both readings of the 2010 paper as systems of energies: whole loops, linearisation."""

from __future__ import annotations

import numpy as np
import pytest

from lagrange.robot2010 import chain, close, plan
from tmodes.model.model import Model
from tmodes.simulation.loop import LoopModel


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


def test_linearised_is_a_difference_of_forces() -> None:
    model = Model(chain("printed"))
    q = np.array([0.1, 0.2, 0.02, -0.03, 0.05, 0.04])
    _, damping, stiffness = model.linearize(q)
    step, zero = 1e-6, np.zeros(6)
    for k in range(6):
        change = np.eye(6)[k] * step
        forces = [model.inverse_dynamics(q + side * change, zero, zero) for side in (1, -1)]
        close((forces[0] - forces[1]) / (2 * step), stiffness[:, k], 1e-6)
        forces = [model.inverse_dynamics(q, side * change, zero) for side in (1, -1)]
        close((forces[0] - forces[1]) / (2 * step), damping[:, k], 1e-6)
