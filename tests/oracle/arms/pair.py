"""A native model next to its oracle: the same state in the order of each, and what both must agree on."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from oracle.arms.lagrange import Lagrangian
from random_chains import random_state
from tmodes.chain.chain import Chain
from tmodes.model.model import Model

__all__ = ["FREE", "SPRUNG", "Pair", "assert_equations_agree", "assert_near", "assert_parts_agree", "reachable"]

Array = NDArray[np.float64]

SPRUNG, FREE = 1e-11, 1e-12
"""Largest difference over largest value, with springs and without."""


class Pair:
    """A chain's native model and its oracle, in one order of coordinates: the model's."""

    def __init__(self, chain: Chain):
        self.model, self.oracle = Model(chain), Lagrangian(chain)
        self.names = tuple(self.model.coordinates)
        assert sorted(self.names) == sorted(self.oracle.coordinates)
        self.order = [self.oracle.coordinates.index(name) for name in self.names]
        self.back = [self.names.index(name) for name in self.oracle.coordinates]

    def state(self, seed: int, bend: float = 0.3) -> tuple[Array, Array, Array]:
        """A random q, v, a in the model's order."""
        q, v, a = random_state(seed, self.names, bend)
        return q, v, a

    def effort(self, seed: int) -> Array:
        """Random efforts, one for each driven joint."""
        return np.random.default_rng(seed).normal(size=len(self.oracle.driven))

    def wrenches(self, seed: int) -> Array:
        """Random forces and moments on every point."""
        points = len(self.oracle.chain.points or (self.oracle.chain.tip,))
        return np.random.default_rng(seed).normal(size=(points, 6))


def assert_near(found: Any, expected: Array, tolerance: float) -> None:
    """Largest difference within ``tolerance`` of the largest value."""
    found = np.asarray(found)
    assert found.shape == expected.shape
    assert np.abs(found - expected).max() <= tolerance * max(np.abs(expected).max(), 1e-3)


def assert_equations_agree(both: Pair, seed: int, tolerance: float) -> None:
    """Forward and inverse dynamics and the residual of the oracle's equations under forces and wrenches."""
    q, v, a = both.state(seed)
    effort, wrenches = both.effort(seed), both.wrenches(seed)
    x, rates, wanted = q[both.back], v[both.back], a[both.back]
    torque = both.oracle.inverse_dynamics(x, rates, wanted, wrenches)
    assert_near(both.model.inverse_dynamics(q, v, a, wrenches=wrenches), torque[both.order], tolerance)
    found = np.asarray(both.model.forward_dynamics(q, v, effort, wrenches=wrenches))
    expected = both.oracle.forward_dynamics(x, rates, effort, wrenches)
    mass = both.oracle.mass_matrix(x)
    assert_near(found, expected[both.order], max(tolerance, reachable(mass)))
    rounding = 4 * np.finfo(float).eps * (np.abs(mass) @ np.abs(expected)).max()  # stiff springs: terms that cancel
    size = np.abs(mass @ expected).max()
    assert_near(mass @ found[both.back], mass @ expected, max(tolerance, rounding / size))


def reachable(mass: Array) -> float:
    """What rounding allows of the accelerations: the unit of rounding times the condition of M with a unit diagonal."""
    scale = 1 / np.sqrt(np.diag(mass))
    return float(np.finfo(float).eps * np.linalg.cond(mass * scale * scale[:, None]))


def assert_parts_agree(both: Pair, seed: int) -> None:
    """Mass matrix, bias, gravity, poses and Jacobians, energies, power lost and momentum."""
    q, v, _ = both.state(seed)
    x, rates = q[both.back], v[both.back]
    mass = both.oracle.mass_matrix(x)[np.ix_(both.order, both.order)]
    assert_near(both.model.mass_matrix(q), mass, 1e-12)
    turn, fall, _, damping = both.oracle.forces(x, rates)
    assert_near(both.model.bias(q, v), (turn + fall)[both.order], 1e-11)
    assert_near(both.model.gravity(q), fall[both.order], 1e-12)
    places, axes, jacobians = both.oracle.points(x)
    found_places, found_axes = both.model.pose(q)
    assert_near(found_places, places, 1e-13)
    assert_near(found_axes, axes, 1e-13)
    assert_near(both.model.jacobian(q), jacobians[:, :, both.order], 1e-12)
    assert float(both.model.power_lost(q, v)) == pytest.approx(rates @ damping, rel=1e-12)
    expected = both.oracle.energies(x, rates)
    for kind, value in both.model.energies(q, v).items():
        assert float(value) == pytest.approx(expected[kind], rel=1e-11, abs=1e-12)
    for found, wanted in zip(both.model.momentum(q, v), both.oracle.momentum(x, rates), strict=True):
        assert_near(found, wanted, 1e-12)
