"""Derivatives of the forward dynamics against differences, against each other, and against Pinocchio."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from random_chains import random_chain, random_state
from tmodes.chain.chain import Chain, Joint, Motor, Node
from tmodes.errors import InputError, SimulationError
from tmodes.frame import Placement
from tmodes.kinds.drives.registry import drive_kind
from tmodes.kinds.joints.registry import joint_kind
from tmodes.kinds.links.contract import Body
from tmodes.kinds.links.rigid import RigidLink
from tmodes.kinds.links.segment import Segment
from tmodes.model.model import Model

Array = NDArray[np.float64]

SEEDS = (0, pytest.param(26, marks=pytest.mark.nightly))
"""A rigid tree; a prismatic joint with a link of one segment, and behind an elastic drive a beam of two functions."""
GRAVITY = np.array([0.0, 0.0, -9.81])
KINDS = ("q", "v", "effort", "parameters")


@cache
def model_of(seed: int) -> Model:
    return Model(random_chain(seed, 2 if seed else 4, rigid=not seed))


@cache
def gripped() -> Model:
    """A bending link between a joint that is prescribed and one that is driven."""
    body = Body(1.0, np.array([0.1, 0.02, -0.03]), np.diag([0.02, 0.03, 0.04]))
    first = Joint("lift", joint_kind("prismatic"), Placement(), np.array([0.0, 0.0, 1.0]), drive_kind("prescribed"))
    second = Joint("turn", joint_kind("revolute"), Placement(), np.array([0.0, 1.0, 0.0]), drive_kind("effort"))
    segment = Segment(0.5, stiffness_y=40.0, stiffness_z=60.0, bodies=(body,))
    nodes = (Node("a", -1, first, segment), Node("b", 0, second, RigidLink((body,))))
    return Model(Chain("gripped", nodes, GRAVITY))


def state_of(model: Model, seed: int = 7) -> dict[str, Array]:
    q, v, _ = random_state(seed, tuple(model.coordinates))
    return {"q": q, "v": v, "effort": np.random.default_rng(seed).normal(size=len(model.efforts))}


def richardson(function: Any, step: float = 1e-3) -> Array:
    """The derivative of a function of one number at 0, of sixth order."""
    ways = [(function(step * k) - function(-step * k)) / (2 * step * k) for k in (1, 2, 3)]
    return (15 * ways[0] - 6 * ways[1] + ways[2]) / 10


def accelerations(model: Model, state: dict[str, Array]) -> Array:
    return model.forward_dynamics(state["q"], state["v"], state["effort"])


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("kind", ["q", "v", "effort"])
def test_slope_along_a_direction_is_that_of_differences(seed: int, kind: str) -> None:
    model = model_of(seed)
    state = state_of(model)
    way = np.random.default_rng(seed).normal(size=state[kind].shape)
    found = model.forward_dynamics_jvp(**state, directions={kind: way})
    expected = richardson(lambda by: accelerations(model, state | {kind: state[kind] + by * way}))
    assert np.abs(found - expected).max() <= 1e-7 * max(1.0, np.abs(expected).max())


@pytest.mark.parametrize("seed", SEEDS)
def test_weights_in_reverse_and_slopes_forwards_tell_the_same_number(seed: int) -> None:
    model, rng = model_of(seed), np.random.default_rng(seed)
    states = [state_of(model, k) for k in range(4)]
    many = {name: np.stack([state[name] for state in states]) for name in states[0]}
    ways: dict[str, Array] = {name: rng.normal(size=value.shape) for name, value in many.items()}
    ways["parameters"] = model.parameters * rng.normal(size=model.parameters.shape)
    weights = rng.normal(size=many["q"].shape)
    slopes = model.forward_dynamics_jvp(**many, directions=ways)
    carried = model.forward_dynamics_vjp(many["q"], many["v"], many["effort"], weights=weights)
    one, other = (weights * slopes).sum(), sum((carried[name] * ways[name]).sum() for name in KINDS)
    assert abs(one - other) <= 1e-12 * np.abs(weights * slopes).sum()


@pytest.mark.parametrize("seed", SEEDS)
def test_the_analytic_route_agrees_with_the_derivative_of_the_recursion(seed: int) -> None:
    model = model_of(seed)
    state = state_of(model)
    found = model.forward_dynamics_derivatives(**state)
    for kind, matrix in zip(("q", "v", "effort"), found, strict=True):
        size, units = len(state[kind]), np.eye(len(state[kind]))
        many = {name: np.tile(value, (size, 1)) for name, value in state.items()}
        columns = model.forward_dynamics_jvp(**many, directions={kind: units}).T if size else matrix
        assert np.abs(matrix - columns).max(initial=0) <= 1e-10 * max(1.0, np.abs(columns).max(initial=0))


def test_prescribed_joints_do_not_answer() -> None:
    model = gripped()
    state = state_of(model)
    found = model.forward_dynamics_derivatives(**state, given=[0.3])
    lift = model.coordinates.index("lift")
    assert not any(matrix[lift].any() for matrix in found)
    way = np.random.default_rng(0).normal(size=model.nq)
    expected = model.forward_dynamics_jvp(**state, given=[0.3], directions={"q": way})
    assert found.q @ way == pytest.approx(expected, rel=1e-10, abs=1e-10 * np.abs(expected).max())


def test_the_inverse_mass_matrix_is_symmetric_and_the_inverse() -> None:
    model = model_of(0)
    state = state_of(model)
    inverse = model.forward_dynamics_derivatives(**state).effort
    rows = [model.coordinates.index(name) for name in model.efforts]
    assert np.abs(inverse[rows] - inverse[rows].T).max() <= 1e-12 * np.abs(inverse).max()
    assert np.abs(model.mass_matrix(state["q"]) @ inverse - np.eye(model.nq)[:, rows]).max() <= 1e-11


def test_wrenches_are_inputs_too() -> None:
    model = model_of(26)
    state, rng = state_of(model), np.random.default_rng(2)
    wrenches, way = rng.normal(size=(2, len(model.parts.points), 6))
    found = model.forward_dynamics_jvp(**state, wrenches=wrenches, directions={"wrenches": way})
    further = model.forward_dynamics(*state.values(), wrenches=wrenches + way)
    expected = further - model.forward_dynamics(*state.values(), wrenches=wrenches)  # it is linear
    assert found == pytest.approx(expected, rel=1e-8, abs=1e-9 * np.abs(expected).max())
    with pytest.raises(InputError, match="wrenches"):
        model.forward_dynamics_jvp(**state, directions={"wrenches": way})


def test_linearisation_is_that_of_the_inverse_dynamics() -> None:
    model, rng = model_of(26), np.random.default_rng(5)
    (q, v, a), way = random_state(5, tuple(model.coordinates)), rng.normal(size=model.nq)
    mass, damping, stiffness = model.linearize(q, v, a)
    by_q = richardson(lambda by: model.inverse_dynamics(q + by * way, v, a))
    by_v = richardson(lambda by: model.inverse_dynamics(q, v + by * way, a))
    assert stiffness @ way == pytest.approx(by_q, rel=1e-7, abs=1e-8 * np.abs(by_q).max())
    assert damping @ way == pytest.approx(by_v, rel=1e-7, abs=1e-8 * np.abs(by_v).max())
    assert mass == pytest.approx(model.mass_matrix(q), rel=1e-12, abs=1e-13 * np.abs(mass).max())


@pytest.mark.parametrize("seed", SEEDS)
def test_derivatives_of_the_inverse_dynamics_are_those_of_differences(seed: int) -> None:
    model = model_of(seed)
    states = [random_state(k, tuple(model.coordinates)) for k in range(3)]
    state = {name: np.stack([one[k] for one in states]) for k, name in enumerate("qva")}
    found = model.inverse_dynamics_derivatives(**state)
    way = np.random.default_rng(seed).normal(size=state["q"].shape)
    for name, part in found._asdict().items():

        def forces(by: float, name: str = name) -> Array:
            return model.inverse_dynamics(**state | {name: state[name] + by * way})

        expected = richardson(forces)
        off = np.einsum("nij,nj->ni", part, way) - expected
        assert np.abs(off).max() <= 1e-7 * max(1.0, np.abs(expected).max()), name
    one = model.inverse_dynamics_derivatives(*(state[name][1] for name in "qva"))
    assert np.array_equal(one.v, found.v[1])


def test_derivatives_at_many_states_are_those_at_each() -> None:
    """By a table of all columns, under wrenches, against one direction after the other."""
    model = model_of(26)
    states = [random_state(k, tuple(model.coordinates)) for k in range(5)]
    q, v, a = (np.stack([one[k] for one in states]) for k in range(3))
    wrenches = np.random.default_rng(1).normal(size=(len(q), len(model.parts.points), 6))
    few = model.inverse_dynamics_derivatives(q, v, a, wrenches=wrenches)
    many = model.inverse_dynamics_derivatives(
        *(np.tile(one, (60, 1)) for one in (q, v, a)), wrenches=np.tile(wrenches, (60, 1, 1))
    )
    for one, other in zip(few, many, strict=True):
        assert np.abs(other - np.tile(one, (60, 1, 1))).max() <= 1e-12 * np.abs(one).max()


def test_a_coordinate_without_mass_is_named() -> None:
    axis = np.array([0.0, 0.0, 1.0])
    joint = Joint("idle", joint_kind("revolute"), Placement(), axis, drive_kind("effort"), motor=Motor(0.0))
    model = Model(Chain("bare", (Node("a", -1, joint, RigidLink()),), GRAVITY))
    with pytest.raises(SimulationError, match="idle"):
        model.forward_dynamics_derivatives([0.0], [0.0])


@pytest.mark.peer
def test_derivatives_are_those_of_pinocchio() -> None:
    pinocchio: Any = pytest.importorskip("pinocchio")
    from benchmarks.engines.peers import pinocchio_model
    from benchmarks.engines.rigid import RigidChain

    count, rng = 12, np.random.default_rng(3)
    robot = RigidChain(count)
    model, (_, peer) = Model(robot.chain()), pinocchio_model(robot)
    data = peer.createData()
    q, v, effort = rng.normal(size=(3, count))
    pinocchio.computeABADerivatives(peer, data, q, v, effort)
    inverse = np.triu(data.Minv) + np.triu(data.Minv, 1).T
    for found, expected in zip(
        model.forward_dynamics_derivatives(q, v, effort), (data.ddq_dq, data.ddq_dv, inverse), strict=True
    ):
        assert np.abs(found - expected).max() <= 1e-11 * np.abs(expected).max()
