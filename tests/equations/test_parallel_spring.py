"""A spring next to the motor: closed forms, energy books, and the same forces behind every kind of drive."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

import tmodes
from random_chains import random_chain, random_state
from tmodes.analysis.modes.modes import MotorState, modes_about
from tmodes.analysis.statics.at_rest import robot_rest
from tmodes.analysis.statics.compliance import springs_of
from tmodes.chain.chain import Chain, ParallelSpring
from tmodes.errors import InputErrors
from tmodes.model.model import Model
from tmodes.sheet import Robot

SPRING = {"stiffness": 20.0, "rest": 0.1, "damping": 0.05}
MOTOR = {"inertia": 0.05, "side": "joint"}
GEAR = {"stiffness": 500.0, "damping": 0.1}
MOVE = {"type": "quintic", "start": 0.0, "end": 0.5, "duration": 0.3}
SERVO = {"type": "pd", "position_gain": 300.0, "velocity_gain": 5.0}
DRIVES = {
    "effort": ({"motor": MOTOR}, {"command": "effort", "signal": {"type": "sine", "amplitude": 1.0, "frequency": 2.0}}),
    "pd": ({"motor": MOTOR}, {"command": "position", "signal": MOVE, "controller": SERVO}),
    "elastic": ({"motor": MOTOR, "gear": GEAR}, {"command": "position", "signal": MOVE, "controller": SERVO}),
    "prescribed": ({}, {"command": "prescribed", "signal": MOVE}),
    "followed": ({"motor": MOTOR, "gear": GEAR}, {"command": "prescribed", "signal": MOVE}),
}
IMPLICIT = ("extrapolation", "midpoint")


def shank(joint: dict[str, Any], drive: dict[str, Any] | None = None, **more: Any) -> Robot:
    """One link, 0.5 kg 0.2 m from a horizontal axis."""
    data = {
        "format": 1,
        "kind": "arm",
        "name": "shank",
        "gravity": 0.0,
        "joints": [{"name": "knee", "type": "revolute", "child": "shank", "axis": [0, 1, 0], **joint}],
        "links": [{"name": "shank", "bodies": [{"mass": 0.5, "center": [0.2, 0, 0], "inertia": 1.0e-3}]}],
        "tip": {"link": "shank", "position": [0.4, 0, 0]},
        "drives": [{"joint": "knee", **drive}] if drive else [],
        "integration": {"duration": 0.5, "output_step": 0.001},
    }
    return Robot.from_data(data | more)


def sprung(chain: Chain, seed: int, damping: float = 1.0) -> Chain:
    """The chain with a spring on every joint."""
    rng = np.random.default_rng(seed)

    def one() -> ParallelSpring:
        return ParallelSpring(float(rng.uniform(5, 80)), float(rng.uniform(-1, 1)), damping)

    nodes = (replace(node, joint=replace(node.joint, spring=one())) for node in chain.nodes)
    return replace(chain, nodes=tuple(nodes))


def test_frequency_and_rest_of_a_sprung_joint() -> None:
    robot = shank({"motor": MOTOR, "spring": {"stiffness": 20.0, "rest": 0.1}}, DRIVES["effort"][1])
    (mode,) = modes_about(robot_rest(robot), MotorState.FREE)
    assert mode.frequency_Hz == pytest.approx(np.sqrt(20 / (0.05 + 0.5 * 0.2**2 + 0.001)) / (2 * np.pi), rel=1e-12)
    assert mode.element == "knee.spring"
    loose = shank({"state": "free", "spring": SPRING}, gravity=9.81)
    rest = robot_rest(loose).named["knee"]
    assert 20 * (rest - 0.1) == pytest.approx(0.5 * 9.81 * 0.2 * np.cos(rest), rel=1e-12)
    assert Model(loose.chain()).gravity([rest])[0] == pytest.approx(-20 * (rest - 0.1), rel=1e-12)


def test_motion_without_torque_is_a_cosine_about_its_rest() -> None:
    still = {"command": "effort", "signal": {"type": "constant", "value": 0.0}}
    robot = shank({"motor": MOTOR, "spring": {"stiffness": 20.0, "rest": 0.1}}, still)
    result = tmodes.run(robot.with_({"integration.method": "rk4"}))
    rate = np.sqrt(20 / 0.071)
    q = result.data["q"].values[:, 0]
    np.testing.assert_allclose(q, 0.1 - 0.1 * np.cos(rate * result.data["time"].values), atol=1e-11)


def test_slider_and_its_unit() -> None:
    slide = {"type": "prismatic", "axis": [1, 0, 0], "state": "free", "spring": {"stiffness": "2 N/mm"}}
    robot = shank(slide)
    (mode,) = modes_about(robot_rest(robot))
    assert mode.frequency_Hz == pytest.approx(np.sqrt(2000 / 0.5) / (2 * np.pi), rel=1e-12)


@pytest.mark.parametrize(
    ("drive", "method"), [*((drive, "dop853") for drive in DRIVES), *(("elastic", m) for m in IMPLICIT)]
)
def test_energy_is_kept_behind_every_drive(drive: str, method: str) -> None:
    joint, command = DRIVES[drive]
    robot = shank(joint | {"spring": SPRING}, command, gravity=9.81)
    result = tmodes.run(robot.with_({"integration.method": method}))
    assert result.summary()["energy"]["worst_residual_over_moved"] < 2e-5


def test_effort_of_a_prescribed_joint_holds_the_spring() -> None:
    drive = {"command": "prescribed", "signal": {"type": "constant", "value": 0.6}}
    result = tmodes.run(shank({"spring": SPRING}, drive))
    np.testing.assert_allclose(result.data["effort"].values, 20 * 0.5, rtol=1e-9)


@pytest.mark.parametrize("seed", range(4))
def test_forces_of_random_chains_differ_by_the_spring_alone(seed: int) -> None:
    bare = random_chain(seed, 3)
    chain = sprung(bare, seed)
    model, plain = Model(chain), Model(bare)
    q, v, a = random_state(seed, tuple(model.coordinates))
    wanted, energy, lost = np.zeros(model.nq), 0.0, 0.0
    for axis in model.parts.axes:
        spring = axis.node.joint.spring
        assert spring
        deflection, rate = q[axis.angle] - spring.rest, v[axis.angle]
        wanted[axis.angle] = spring.stiffness * deflection + spring.damping * rate
        energy += spring.stiffness * deflection**2 / 2
        lost += spring.damping * rate**2
    added = model.elastic_forces(q, v) - plain.elastic_forces(q, v)
    np.testing.assert_allclose(added, wanted, atol=1e-10)
    assert float(np.squeeze(model.energies(q, v)["elastic_gear"] - plain.energies(q, v)["elastic_gear"])) == (
        pytest.approx(energy, abs=1e-9)
    )
    losses = model.losses(q, v)["gear_damping"] - plain.losses(q, v)["gear_damping"]
    assert float(np.squeeze(losses)) == pytest.approx(lost, abs=1e-9)
    forces = model.inverse_dynamics(q, v, a)
    np.testing.assert_allclose(forces - plain.inverse_dynamics(q, v, a), wanted, atol=1e-9)


@pytest.mark.parametrize("seed", range(3))
def test_springs_of_random_chains_sum_to_the_stiffness(seed: int) -> None:
    model = Model(sprung(random_chain(seed, 3), seed))
    q, _, _ = random_state(seed, tuple(model.coordinates))
    whole = model.stiffness(q, base=model.at_rest(gravity=0.0))
    springs = springs_of(model, q)
    assert sum(name.endswith(".spring") for name in springs) == len(model.parts.axes)
    total = sum((spring.matrix for spring in springs.values()), np.zeros_like(whole))
    np.testing.assert_allclose(total, whole, atol=1e-6 * np.abs(whole).max())


def test_free_joint_on_its_spring_is_a_locked_one_behind_a_gear() -> None:
    lever = {"name": "lever", "type": "revolute", "child": "lever", "axis": [0, 1, 0], "motor": MOTOR}
    drive = {"joint": "lever", "command": "position", "controller": SERVO, "signal": MOVE}
    results = []
    ways = (
        {"state": "free", "spring": {"stiffness": 60.0, "rest": 0.2, "damping": 0.1}},
        {"state": "locked", "locked_at": 0.2, "gear": {"stiffness": 60.0, "damping": 0.1}},
    )
    for way in ways:
        joint = {
            "name": "knee",
            "type": "revolute",
            "child": "shank",
            "axis": [0, 1, 0],
            "origin": {"position": [0.3, 0, 0]},
        }
        body = {"name": "lever", "bodies": [{"mass": 1.0, "center": [0.15, 0, 0], "inertia": 0.01}]}
        links = [body, {"name": "shank", "bodies": [{"mass": 0.5, "center": [0.2, 0, 0], "inertia": 1.0e-3}]}]
        robot = shank({}, joints=[lever, joint | way], links=links, drives=[drive], gravity=9.81)
        results.append(tmodes.run(robot))
    one, other = results
    np.testing.assert_allclose(one.data["q"].values, other.data["q"].values, atol=1e-9)
    for part in ("deformation", "deformation_stationary", "deformation_oscillatory"):
        np.testing.assert_allclose(one.data[part].values, other.data[part].values, atol=1e-8)
    assert list(one.data["deformation_kind"].values) == ["knee.spring"]
    parts = [result.summary()["tip_error"]["commanded"]["parts_m"]["gears"] for result in results]
    assert parts[0] == pytest.approx(parts[1], rel=1e-6)


def test_batch_and_derivatives_know_the_spring() -> None:
    joint, command = DRIVES["pd"]
    robot = shank(joint | {"spring": SPRING}, command)
    path = "joints.knee.spring.stiffness"
    sensitivity = tmodes.forward_sensitivities(robot, [path], quantities=["q"]).of["q"][path][-1, 0]
    ends = [tmodes.run(robot.with_({path: value})).data["q"].values[-1, 0] for value in (19.99, 20.01)]
    batch = tmodes.simulate_batch(robot, {path: [19.99, 20.01]})
    np.testing.assert_allclose(batch.states[:, -1, 0], ends, rtol=1e-9)
    assert sensitivity == pytest.approx((ends[1] - ends[0]) / 0.02, rel=1e-3)


@pytest.mark.parametrize("joint", [{"state": "locked"}, {"type": "fixed", "axis": None}])
def test_spring_of_a_joint_that_does_not_move_is_refused(joint: dict[str, Any]) -> None:
    with pytest.raises(InputErrors) as caught:
        shank({**joint, "spring": SPRING})
    assert caught.value.errors[0].which == "joints.knee.spring"
