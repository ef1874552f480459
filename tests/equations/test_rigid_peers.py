"""Rigid robots against Pinocchio (UR5 and Panda as published) and against a table of reference values (UR5)."""

from __future__ import annotations

from functools import cache
from importlib import metadata
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from oracle.arms.pinocchio_bridge import chain_of, model_of
from oracle.arms.robots import ur5, ur5_table
from random_chains import random_chain
from tmodes.model.model import Model

Array = NDArray[np.float64]

STATES = 1000
URDF = {
    "ur5": ("ur_description/urdf/ur5_robot.urdf", "tool0"),
    "panda": ("panda_description/urdf/panda.urdf", "panda_hand"),
}


@cache
def published(name: str) -> tuple[Any, str]:
    """Pinocchio's model of a published robot, its two fingers included; the test is skipped where it is absent."""
    pinocchio: Any = pytest.importorskip("pinocchio")
    path, tip = URDF[name]
    try:
        share = metadata.distribution("example-robot-data").locate_file("cmeel.prefix/share/example-robot-data/robots")
    except metadata.PackageNotFoundError:
        pytest.skip("needs the robots of `pip install example-robot-data`")
    return pinocchio.buildModelFromUrdf(str(Path(str(share)) / path)), tip


def states(size: int, seed: int = 1) -> tuple[Array, Array, Array, Array]:
    """Random positions, rates, accelerations and torques, (STATES, size) each."""
    rng = np.random.default_rng(seed)
    q, (v, a, torque) = rng.uniform(-3, 3, (STATES, size)), rng.normal(size=(3, STATES, size))
    return q, v, a, torque


def assert_near(found: Any, expected: Array, tolerance: float = 1e-10) -> None:
    """Every state's largest difference within ``tolerance`` of that state's largest value."""
    rows = (len(expected), -1)
    difference = np.abs(np.asarray(found).reshape(rows) - expected.reshape(rows)).max(axis=1)
    assert (difference <= tolerance * np.maximum(np.abs(expected.reshape(rows)).max(axis=1), 1.0)).all()


def assert_equal_engines(chain: Any, peer: Any, depth_first: bool = True) -> None:
    """Mass matrix, bias, gravity, inverse and forward dynamics at 1,000 random states."""
    pinocchio: Any = pytest.importorskip("pinocchio")
    model, data = Model(chain), peer.createData()
    order = [list(model.coordinates).index(name) for name in list(peer.names)[1:]]
    q, v, a, torque = states(peer.nv)
    mine = [np.zeros_like(x) for x in (q, v, a, torque)]
    for target, source in zip(mine, (q, v, a, torque), strict=True):
        target[:, order] = source
    inverse = np.array([pinocchio.rnea(peer, data, *row).copy() for row in zip(q, v, a, strict=True)])
    assert_near(np.asarray(model.inverse_dynamics(*mine[:3]))[:, order], inverse)
    bias = np.array([pinocchio.nonLinearEffects(peer, data, *row).copy() for row in zip(q, v, strict=True)])
    assert_near(np.asarray(model.bias(*mine[:2]))[:, order], bias)
    fall = np.array([pinocchio.computeGeneralizedGravity(peer, data, row).copy() for row in q])
    assert_near(np.asarray(model.gravity(mine[0]))[:, order], fall)
    if depth_first:
        masses = [pinocchio.crba(peer, data, row).copy() for row in q]
        mass = np.array([np.triu(m) + np.triu(m, 1).T for m in masses])
        assert_near(np.asarray(model.mass_matrix(mine[0]))[:, order][:, :, order], mass)
    forward = np.array([pinocchio.aba(peer, data, *row).copy() for row in zip(q, v, torque, strict=True)])
    found = np.asarray(model.forward_dynamics(mine[0], mine[1], mine[3][:, _effort_order(chain, model)]))
    assert_near(found[:, order], forward)


def _effort_order(chain: Any, model: Any) -> list[int]:
    """Column of q of each effort: joints in the order of the chain."""
    names = [node.joint.name for node in chain.nodes if node.joint.name in model.coordinates]
    return [list(model.coordinates).index(name) for name in names]


@pytest.mark.peer
@pytest.mark.parametrize("name", list(URDF))
def test_published_robots_equal_pinocchio(name: str) -> None:
    peer, tip = published(name)
    assert_equal_engines(chain_of(peer, tip), peer)


@pytest.mark.peer
@pytest.mark.parametrize("name", list(URDF))
def test_poses_and_jacobians_equal_pinocchio(name: str) -> None:
    pinocchio: Any = pytest.importorskip("pinocchio")
    peer, tip = published(name)
    model, data, frame = Model(chain_of(peer, tip)), peer.createData(), peer.getFrameId(tip)
    q = states(peer.nv, 2)[0][:50]
    places, axes = model.pose(q)
    jacobians = np.asarray(model.jacobian(q))
    for i, row in enumerate(q):
        pinocchio.framesForwardKinematics(peer, data, row)
        np.testing.assert_allclose(np.asarray(places)[i, 0], data.oMf[frame].translation, atol=1e-13)
        np.testing.assert_allclose(np.asarray(axes)[i, 0], data.oMf[frame].rotation, atol=1e-13)
        expected = pinocchio.computeFrameJacobian(peer, data, row, frame, pinocchio.ReferenceFrame.LOCAL_WORLD_ALIGNED)
        np.testing.assert_allclose(jacobians[i, 0], expected, atol=1e-12)


@pytest.mark.peer
@pytest.mark.parametrize("seed", range(4))
def test_random_trees_equal_pinocchio(seed: int) -> None:
    """Branches, slides, fixed joints, rotors and tilted bases."""
    pytest.importorskip("pinocchio")
    chain = random_chain(seed, 7, rigid=True)
    assert_equal_engines(chain, model_of(chain), depth_first=False)


def test_ur5_equals_reference_values() -> None:
    """Six states: two engines and a Newton-Euler recursion agreed on them to 4e-15."""
    model = Model(ur5())
    for state in ur5_table()["states"]:
        q, v, a, torque = (np.array(state[name]) for name in ("q", "v", "a", "tau"))
        np.testing.assert_allclose(model.mass_matrix(q), state["mass_matrix"], atol=1e-12)
        np.testing.assert_allclose(model.bias(q, v), state["bias"], atol=1e-11)
        np.testing.assert_allclose(model.gravity(q), state["gravity"], atol=1e-11)
        np.testing.assert_allclose(model.inverse_dynamics(q, v, a), state["inverse_dynamics"], atol=1e-11)
        np.testing.assert_allclose(model.forward_dynamics(q, v, torque), state["forward_dynamics"], rtol=1e-10)
        places, axes = model.pose(q)
        np.testing.assert_allclose(np.asarray(places)[0], state["position"], atol=1e-13)
        np.testing.assert_allclose(np.asarray(axes)[0], state["rotation"], atol=1e-13)
        np.testing.assert_allclose(np.asarray(model.jacobian(q))[0], state["jacobian"], atol=1e-13)
        energies = model.energies(q, v)
        assert float(energies["kinetic"]) == pytest.approx(state["kinetic_energy"], rel=1e-12)


def test_ur5_with_elastic_gears() -> None:
    """B thdd = tau - gear, M qdd + h = gear, gear = K (th - q) + D (thd - qd): from the table's M and h."""
    table = ur5_table()
    model, gear = Model(ur5(elastic=True)), {name: np.array(row) for name, row in table["elastic"].items()}
    for seed, state in enumerate(table["states"]):
        q, v, torque = (np.array(state[name]) for name in ("q", "v", "tau"))
        rng = np.random.default_rng(seed)
        motor, rate = q + 0.01 * rng.normal(size=6), rng.normal(size=6)
        wound = gear["K"] * (motor - q) + gear["D"] * (rate - v)
        expected = [(torque - wound) / gear["B"], np.linalg.solve(state["mass_matrix"], wound - state["bias"])]
        found = model.forward_dynamics(np.concatenate([motor, q]), np.concatenate([rate, v]), torque)
        np.testing.assert_allclose(found, np.concatenate(expected), rtol=1e-9, atol=1e-9)
