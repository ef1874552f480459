"""What holds for every chain: laws of mechanics, and that names, frames and places are conventions."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from oracle.arms.robots import arms
from oracle.arms.variants import carried, reordered, rigidified, split_placements, stiffened
from random_chains import random_chain, random_placement, random_state
from tmodes.chain.chain import Chain
from tmodes.kinds.drives.registry import drive_kind
from tmodes.model.model import Model

Array = NDArray[np.float64]

CHAINS = st.integers(0, 5)
"""Few chains, as each is compiled; many states."""
STATES = st.integers(0, 10**9)


@cache
def chain_of(seed: int) -> Chain:
    return random_chain(seed, 2 + seed % 3)


@cache
def model_of(seed: int) -> Any:
    return Model(chain_of(seed))


def state_of(model: Any, seed: int) -> tuple[Array, Array, Array]:
    return random_state(seed, tuple(model.coordinates))


def driven(model: Any, chain: Chain) -> list[int]:
    """Columns of the efforts: a motor's own coordinate, or its joint's."""
    names = list(model.coordinates)
    rows = [(f"{node.joint.name}.motor", node.joint.name, node.joint.drive) for node in chain.nodes]
    return [
        names.index(motor if motor in names else joint)
        for motor, joint, drive in rows
        if joint in names and drive in (drive_kind("effort"), drive_kind("elastic"))
    ]


def assert_near(found: Any, expected: Any, tolerance: float) -> None:
    found, expected = np.asarray(found), np.asarray(expected)
    assert np.abs(found - expected).max(initial=0.0) <= tolerance * max(np.abs(expected).max(initial=0.0), 1e-3)


@given(CHAINS, STATES)
@settings(max_examples=40)
def test_mass_matrix_is_symmetric_and_positive(chain: int, state: int) -> None:
    model = model_of(chain)
    q, v, _ = state_of(model, state)
    mass = np.asarray(model.mass_matrix(q))
    assert_near(mass, mass.T, 1e-13)
    np.linalg.cholesky(mass)
    assert float(model.energies(q, v)["kinetic"]) == pytest.approx(v @ mass @ v / 2, rel=1e-11)


@given(CHAINS, STATES)
@settings(max_examples=40)
def test_inverse_dynamics_undoes_forward_dynamics(chain: int, state: int) -> None:
    """What the found accelerations ask for are the efforts that were given, and nothing on what has no drive."""
    model = model_of(chain)
    q, v, _ = state_of(model, state)
    rows = driven(model, chain_of(chain))
    effort = np.random.default_rng(state).normal(size=len(rows))
    wrenches = np.random.default_rng(state + 1).normal(size=(2, 6))
    a = np.asarray(model.forward_dynamics(q, v, effort, wrenches=wrenches))
    expected = np.zeros(len(q))
    expected[rows] = effort
    resting = np.asarray(model.inverse_dynamics(q, v, np.zeros_like(a), wrenches=wrenches))
    found = np.asarray(model.inverse_dynamics(q, v, a, wrenches=wrenches))
    assert np.abs(found - expected).max() <= 1e-9 * max(1.0, np.abs(resting).max())


@given(CHAINS, STATES)
@settings(max_examples=40)
def test_power_is_balanced(chain: int, state: int) -> None:
    """Power of the forces along any motion = rate of all energies + power lost."""
    model = model_of(chain)
    q, v, a = state_of(model, state)
    power = v @ np.asarray(model.inverse_dynamics(q, v, a))

    def energy(t: float) -> float:
        return sum(float(part) for part in model.energies(q + t * v + t * t / 2 * a, v + t * a).values())

    steps = np.array([-2, -1, 1, 2]) * 1e-3
    rate = np.dot([1, -8, 8, -1], [energy(t) for t in steps]) / 12e-3
    size = sum(abs(float(part)) for part in model.energies(q, v).values())
    assert rate + float(model.power_lost(q, v)) == pytest.approx(power, abs=1e-8 * max(size, 1.0), rel=1e-7)
    assert float(model.power_lost(q, v)) >= 0


@given(CHAINS, STATES)
@settings(max_examples=40)
def test_jacobian_is_the_derivative_of_the_pose(chain: int, state: int) -> None:
    model = model_of(chain)
    q, v, _ = state_of(model, state)
    twist = np.asarray(model.jacobian(q)) @ v
    h = 1e-3
    poses = [model.pose(q + k * h * v) for k in (-2, -1, 1, 2)]
    weights = np.array([1, -8, 8, -1]) / (12 * h)
    places = np.tensordot(weights, [np.asarray(pose[0]) for pose in poses], 1)
    axes = np.tensordot(weights, [np.asarray(pose[1]) for pose in poses], 1)
    turning = axes @ np.asarray(model.pose(q)[1]).transpose(0, 2, 1)
    rates = np.stack([turning[:, 2, 1], turning[:, 0, 2], turning[:, 1, 0]], axis=1)
    scale = max(1.0, np.abs(twist).max())
    np.testing.assert_allclose(places, twist[:, :3], atol=2e-9 * scale**5)
    np.testing.assert_allclose(rates, twist[:, 3:], atol=2e-9 * scale**5)


@given(CHAINS, STATES)
@settings(max_examples=8)
def test_place_in_the_world_does_not_matter(chain: int, state: int) -> None:
    """Base and gravity turned and carried together: the same forces, and the pose carried."""
    model, placement = model_of(chain), random_placement(np.random.default_rng(state), 3.0)
    moved = Model(carried(chain_of(chain), placement))
    q, v, a = state_of(model, state)
    assert_near(moved.inverse_dynamics(q, v, a), model.inverse_dynamics(q, v, a), 1e-11)
    assert_near(moved.mass_matrix(q), model.mass_matrix(q), 1e-12)
    places, axes = (np.asarray(part) for part in model.pose(q))
    assert_near(moved.pose(q)[0], places @ placement.rotation.T + placement.position, 1e-13)
    assert_near(moved.pose(q)[1], placement.rotation @ axes, 1e-13)


@pytest.mark.parametrize("order", [[0, 2, 1, 3], [0, 1, 3, 2]])
def test_order_of_branches_does_not_matter(order: list[int]) -> None:
    chain = arms()["branched"]
    model, other = Model(chain), Model(reordered(chain, order))
    names, renamed = list(model.coordinates), list(other.coordinates)
    back = [renamed.index(name) for name in names]
    for seed in range(5):
        q, v, a = state_of(model, seed)
        turned = [np.empty_like(q) for _ in range(3)]
        for target, source in zip(turned, (q, v, a), strict=True):
            target[back] = source
        assert_near(np.asarray(other.inverse_dynamics(*turned))[back], model.inverse_dynamics(q, v, a), 1e-12)
        effort = dict(zip(driven(model, chain), np.random.default_rng(seed).normal(size=4), strict=False))
        by_name = {names[row]: value for row, value in effort.items()}
        rows = driven(other, reordered(chain, order))
        found = other.forward_dynamics(turned[0], turned[1], np.array([by_name[renamed[row]] for row in rows]))
        expected = model.forward_dynamics(q, v, np.array(list(effort.values())))
        assert_near(np.asarray(found)[back], expected, 1e-11)


@pytest.mark.parametrize("seed", range(4))
def test_frames_between_are_conventions(seed: int) -> None:
    """A joint's placement split in two by a fixed joint and an empty link."""
    chain = chain_of(seed)
    model, other = model_of(seed), Model(split_placements(chain, random_placement(np.random.default_rng(seed))))
    assert list(other.coordinates) == list(model.coordinates)
    for state in range(5):
        q, v, a = state_of(model, state)
        assert_near(other.inverse_dynamics(q, v, a), model.inverse_dynamics(q, v, a), 1e-11)
        assert_near(other.pose(q)[0], model.pose(q)[0], 1e-13)


@pytest.mark.parametrize("name", ["twist_and_bend", "curved_and_stretched", "branched"])
def test_stiff_links_move_as_rigid_ones(name: str) -> None:
    """EI, GJ, EA 1e12 times as large, one implicit step from rest: joints and motors accelerate as with rigid links."""
    chain, step = arms()[name], 1e-3
    stiff, rigid = Model(stiffened(chain, 1e12)), Model(rigidified(chain))
    shared = [list(stiff.coordinates).index(name) for name in rigid.coordinates]
    rows = driven(rigid, chain)
    for seed in range(3):
        q, v, _ = state_of(rigid, seed)
        effort = np.random.default_rng(seed).normal(size=len(rows))
        unbent, still = np.zeros((2, len(stiff.coordinates)))
        unbent[shared], still[shared] = q, v
        found = np.asarray(stiff.forward_dynamics(unbent, still, effort, step=step))
        expected = np.asarray(rigid.forward_dynamics(q, v, effort, step=step))
        assert_near(found[shared], expected, 1e-6)
