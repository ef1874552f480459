"""The model's words against what they mean: energies differentiated numerically, forward against inverse dynamics."""

from __future__ import annotations

import numpy as np
import pytest

import tmodes

STEP = 1e-5
ROBOTS = ("spong1987", "manutec_r3", "flexarm1990", "filipovic2010")


def state(name: str) -> tuple[tmodes.Model, np.ndarray, np.ndarray]:
    """A model, and a state near rest in which everything moves."""
    model = tmodes.Model(tmodes.load(name))
    rng = np.random.default_rng(7)
    q, v = 0.2 * rng.normal(size=(2, model.nq))
    q[model.deformations] *= 0.05
    return model, q, v


def slope(function, q: np.ndarray) -> np.ndarray:
    """Central differences of fourth order by each coordinate, as last axis."""
    ways = STEP * np.eye(len(q))
    each = [
        (8 * (function(q + way) - function(q - way)) - (function(q + 2 * way) - function(q - 2 * way))) / (12 * STEP)
        for way in ways
    ]
    return np.stack(each, axis=-1)


def near(found: np.ndarray, known: np.ndarray, share: float = 1e-7) -> bool:
    return bool(np.abs(found - known).max() <= share * max(np.abs(known).max(), 1e-9))


@pytest.mark.parametrize("name", ROBOTS)
def test_mass_gravity_and_bias_follow_from_the_energies(name: str) -> None:
    """Lagrange's equations, with the derivatives of both energies by differences."""
    model, q, v = state(name)

    def kinetic(rates: np.ndarray) -> float:
        return float(model.energies(q, rates)["kinetic"])

    unit = np.eye(model.nq)
    single = np.array([kinetic(one) for one in unit])
    mass = np.array([[kinetic(a + b) for b in unit] for a in unit]) - single[:, None] - single
    assert near(model.mass_matrix(q), mass, 1e-10)
    pull = slope(lambda at: np.asarray(model.energies(at, 0 * v)["gravity"]), q)
    assert near(model.gravity(q), pull) or np.abs(pull).max() < 1e-6
    turned = slope(model.mass_matrix, q)
    bias = np.einsum("ijk,j,k->i", turned, v, v) - np.einsum("jki,j,k->i", turned, v, v) / 2 + pull
    assert near(model.bias(q, v), bias, 1e-6)


@pytest.mark.parametrize("name", ROBOTS)
def test_the_jacobian_is_the_slope_of_the_pose(name: str) -> None:
    model, q, v = state(name)
    jacobian = model.jacobian(q)
    assert near(jacobian[:, :3], slope(lambda at: model.pose(at)[0], q))
    turns, rotation = slope(lambda at: model.pose(at)[1], q), model.pose(q)[1]
    spin = np.einsum("pijn,pkj->pikn", turns, rotation)  # R' R^T
    angular = np.stack([spin[:, 2, 1], spin[:, 0, 2], spin[:, 1, 0]], axis=1)
    assert near(jacobian[:, 3:], angular) or np.abs(angular).max() < 1e-7
    assert near(model.points(q, v).velocity, jacobian[:, :3] @ v, 1e-10)


@pytest.mark.parametrize("name", ROBOTS)
def test_inverse_dynamics_undo_forward_dynamics(name: str) -> None:
    model, q, v = state(name)
    effort = np.linspace(1.0, 2.0, len(model.efforts))
    a = model.forward_dynamics(q, v, effort)
    needed = model.inverse_dynamics(q, v, a)
    whole = model.mass_matrix(q) @ a + model.bias(q, v) + model.elastic_forces(q, v)
    scale = np.abs(model.elastic_forces(q, v)).max() + np.abs(effort).max()
    assert np.abs(needed - whole).max() < 1e-9 * scale
    assert np.sort(np.abs(needed))[::-1][: len(effort)] == pytest.approx(effort[::-1], rel=1e-6)


@pytest.mark.parametrize("name", ROBOTS)
def test_energy_changes_by_what_is_brought_in_and_lost(name: str) -> None:
    model, q, v = state(name)
    a = model.forward_dynamics(q, v, 1.0)
    forces = model.inverse_dynamics(q, v, a)

    def energy(time: np.ndarray) -> np.ndarray:
        t = float(time[0])
        return np.asarray(sum(model.energies(q + t * v + t * t / 2 * a, v + t * a).values()))

    power = float(slope(energy, np.zeros(1))[0])
    scale = np.abs(v * model.elastic_forces(q, v)).max() + abs(float(forces @ v))
    assert abs(power - float(forces @ v) + float(model.power_lost(q, v))) < 1e-6 * scale


@pytest.mark.parametrize("name", ROBOTS)
def test_the_linearization_is_the_slope_of_the_inverse_dynamics(name: str) -> None:
    model, q, v = state(name)
    a = 0.1 * v
    mass, damping, stiffness = model.linearize(q, v, a)
    assert near(mass, slope(lambda at: model.inverse_dynamics(q, v, at), a), 1e-8)
    assert near(damping, slope(lambda at: model.inverse_dynamics(q, at, a), v), 1e-6) or np.abs(damping).max() < 1e-6
    assert near(stiffness, slope(lambda at: model.inverse_dynamics(at, v, a), q), 1e-6)
