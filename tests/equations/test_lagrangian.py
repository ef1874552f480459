"""The recursion equals an independent Lagrangian on arms in space that hold every kind of joint and link.

With springs the accelerations are huge and hide wrong inertia forces; so each arm is also run without any spring.
"""

from __future__ import annotations

import os
from functools import cache

import numpy as np
import pytest

from oracle.arms.pair import FREE, SPRUNG, Pair, assert_equations_agree, assert_near, assert_parts_agree
from oracle.arms.robots import arms
from oracle.arms.variants import without_springs
from random_chains import random_chain

STATES = 5
CHAINS = int(os.environ.get("TMODES_CHAINS", "4"))
"""How many random trees are drawn."""


@cache
def pair(name: str, springs: bool) -> Pair:
    chain = arms()[name]
    return Pair(chain if springs else without_springs(chain))


@cache
def random_pair(seed: int, springs: bool) -> Pair:
    chain = random_chain(seed, 2 + seed % 3)
    return Pair(chain if springs else without_springs(chain))


@pytest.mark.nightly("curved_and_stretched-springs")
@pytest.mark.parametrize("springs", [True, pytest.param(False, marks=pytest.mark.nightly)], ids=["springs", "free"])
@pytest.mark.parametrize("name", list(arms()))
def test_forward_and_inverse_dynamics(name: str, springs: bool) -> None:
    for seed in range(STATES):
        assert_equations_agree(pair(name, springs), seed, SPRUNG if springs else FREE)


@pytest.mark.nightly("2-", "3-")
@pytest.mark.slow
@pytest.mark.parametrize("springs", [True, False], ids=["springs", "free"])
@pytest.mark.parametrize("seed", range(CHAINS))
def test_random_chains(seed: int, springs: bool) -> None:
    """Trees of joints and links drawn at random; some have mass matrices of poor condition."""
    for state in range(3):
        assert_equations_agree(random_pair(seed, springs), 100 * seed + state, SPRUNG)


@pytest.mark.parametrize("step", [1e-5, 1e-3, 5e-3])
@pytest.mark.parametrize("name", list(arms()))
def test_implicit_springs(name: str, step: float) -> None:
    """(M + h D + h^2 K) a = forces with the springs at q + h v: one step of a linearly implicit Euler method."""
    both = pair(name, True)
    for seed in range(STATES):
        q, v, _ = both.state(seed)
        effort = both.effort(seed)
        expected = both.oracle.forward_dynamics(q[both.back], v[both.back], effort, step=step)
        found = both.model.forward_dynamics(q, v, effort, step=step)
        assert_near(found, expected[both.order], SPRUNG)


@pytest.mark.parametrize("name", list(arms()))
def test_parts(name: str) -> None:
    """Mass matrix, bias, gravity, poses and Jacobians, energies, power lost and momentum."""
    for seed in range(STATES):
        assert_parts_agree(pair(name, True), seed)


@pytest.mark.parametrize("name", list(arms()))
def test_many_states_at_once_equal_one_by_one(name: str) -> None:
    both = pair(name, True)
    states = [both.state(seed) for seed in range(7)]
    q, v, a = (np.array([state[i] for state in states]) for i in range(3))
    effort = np.array([both.effort(seed) for seed in range(7)])
    wrenches = np.array([both.wrenches(seed) for seed in range(7)])
    together = both.model.forward_dynamics(q, v, effort, wrenches=wrenches)
    torque = both.model.inverse_dynamics(q, v, a, wrenches=wrenches)
    for i in range(7):
        assert_near(
            together[i], np.asarray(both.model.forward_dynamics(q[i], v[i], effort[i], wrenches=wrenches[i])), 1e-14
        )
        assert_near(torque[i], np.asarray(both.model.inverse_dynamics(q[i], v[i], a[i], wrenches=wrenches[i])), 1e-14)


@pytest.mark.nightly("curved", "twist")
@pytest.mark.parametrize("name", list(arms()))
def test_linearisation(name: str) -> None:
    """M, D, K: derivatives of the inverse dynamics by acceleration, rate and position about a moving state."""
    both = pair(name, True)
    q, v, _ = both.state(11)
    expected = both.oracle.linearize(q[both.back], v[both.back])
    for found, wanted in zip(both.model.linearize(q, v), expected, strict=True):
        assert_near(found, wanted[np.ix_(both.order, both.order)], 1e-6)
