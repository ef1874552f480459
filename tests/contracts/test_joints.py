"""Every kind of joint, and one of a user: what its contract asks, and its motion in the recursion."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from oracle.arms.pair import SPRUNG, Pair, assert_equations_agree, assert_parts_agree
from oracle.arms.robots import GRAVITY, turned
from random_chains import random_body
from tmodes.chain.chain import Chain, Friction, Gear, Joint, Motor, Node, Point
from tmodes.errors import InputError, TmodesError
from tmodes.kinds.drives.registry import drive_kind
from tmodes.kinds.joints.contract import JointKind
from tmodes.kinds.joints.registry import JOINTS, joint_kind
from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.kernel.functions import cos, sin
from tmodes.kinds.links.rigid import RigidLink
from tmodes.kinds.links.strain import Beam, BeamPiece
from tmodes.kinds.schema.quantity import DataSheet, any_sign
from tmodes.model.model import Model
from tmodes.robots.load import load
from tmodes.simulation.simulate import simulate_motion

Array = NDArray[np.float64]


class ScrewNumbers(DataSheet):
    """What a sheet gives of a screw joint."""

    pitch: float = any_sign("m/rad", "h", "advance along the axis over the angle", plausible=(-0.1, 0.1))


class Screw(JointKind):
    """An angle about the axis with an advance along it."""

    name = "screw"
    summary = "turns about its axis and advances along it"
    schema = ScrewNumbers
    drawing = "cylinder"

    def place(self, q: Any, numbers: Any) -> tuple[v.Matrix, v.Vector]:
        axis = v.vec(numbers)
        return v.rodrigues(axis, cos(q[0]), sin(q[0])), v.scale(numbers[3] * q[0], axis)


NAMES = [*JOINTS.names, "screw"]


@pytest.fixture(autouse=True, scope="module")
def user_kind() -> Iterator[None]:
    JOINTS.register(Screw)
    yield
    JOINTS.unregister("screw")


def joint(kind: str, name: str, **changed: Any) -> Joint:
    """On an oblique axis; a screw with its pitch."""
    parameters = (0.07,) if kind == "screw" else ()
    axis = np.array([0.0, 0.6, 0.8])
    return Joint(
        name, joint_kind(kind), turned([1, 1, 0], 0.4, [0.3, 0.0, 0.1]), axis, parameters=parameters, **changed
    )


def chain(kind: str, **changed: Any) -> Chain:
    """The joint on the base, on a rigid link, and on the tip of a beam."""
    rng, piece = np.random.default_rng(0), BeamPiece(1.0, (20, 20), (30, 30), (15, 15), (0, 0), (0.4, 0.4))
    rigid = [RigidLink((random_body(rng), random_body(rng))) for _ in range(3)]
    beam = Beam(0.5, (piece,), bend_y=1, bend_z=2, damping_time=1e-3, bodies=((1.0, random_body(rng)),))
    nodes = (
        Node("one", -1, joint(kind, "a", **changed), rigid[0]),
        Node("two", 0, joint("revolute", "b"), beam),
        Node("three", 1, joint(kind, "c", **changed), rigid[1]),
        Node("four", 0, joint(kind, "d", **changed), rigid[2]),
    )
    return Chain("tree", nodes, GRAVITY, points=(Point("tool", 2), Point("elbow", 3)))


ELASTIC = {"drive": "elastic", "motor": Motor(0.2, Friction(0.1)), "gear": Gear((100.0,), damping=0.5)}
DRIVES: dict[str, dict[str, Any]] = {
    "effort": {"motor": Motor(0.3, Friction(0.2)), "friction": Friction(0.1, 0.3, 0.1, 0.5, 1e-2)},
    "elastic": ELASTIC,
    "spring": {"drive": "spring", "gear": Gear((100.0,), damping=0.5), "rest": 0.2},
    "free": {"drive": "free", "friction": Friction(0.1)},
}


class WidePair(Pair):
    """Coordinates of joints that have names after a dot are as large as all others."""

    def state(self, seed: int, bend: float = 0.3) -> tuple[Array, Array, Array]:
        q, rates, a = super().state(seed, bend)
        joints = [axis.name for axis in self.oracle.chain.axes]
        wide = np.random.default_rng(seed + 99).uniform(-2, 2, len(q))
        return np.where([name in joints for name in self.names], wide, q), rates, a


@pytest.mark.parametrize(
    ("kind", "drive"), [*((kind, "elastic") for kind in NAMES), *(("universal", drive) for drive in DRIVES)][:-1]
)
def test_recursion_is_the_lagrangian(kind: str, drive: str) -> None:
    """Every kind behind a gear; the one of two coordinates by every drive."""
    given = dict(DRIVES[drive])
    both = WidePair(chain(kind, **given | {"drive": drive_kind(given.get("drive", "effort"))}))
    for seed in range(2):
        assert_equations_agree(both, seed, SPRUNG)
        assert_parts_agree(both, seed)


def moved(kind: JointKind, q: Array, numbers: Array) -> tuple[Array, Array]:
    return kind.placement(list(q), list(numbers))


@pytest.mark.parametrize("name", NAMES)
def test_subspace_and_bias_are_the_motion_of_the_placement(name: str) -> None:
    """Central differences of the placement, along rates: S q' and S q'' + bias at q'' = 0."""
    kind, numbers, step = joint_kind(name), joint(name, "j").numbers, 1e-4
    rng = np.random.default_rng(3)
    for _ in range(5):
        q, rates = rng.uniform(-2, 2, (2, kind.size))
        (before, back), (rotation, here), (after, on) = (moved(kind, q + k * step * rates, numbers) for k in (-1, 0, 1))
        assert rotation @ rotation.T == pytest.approx(np.eye(3), abs=1e-14)
        columns = np.array([each.packed() for each in kind.subspace(q, numbers)], dtype=float).reshape(-1, 6)
        rate = rates @ columns
        spin, gain = rotation.T @ (after - before) / (2 * step), rotation.T @ (after + before - 2 * rotation) / step**2
        assert rate[:3] == pytest.approx(_vee(spin), abs=1e-7)
        assert rate[3:] == pytest.approx(rotation.T @ (on - back) / (2 * step), abs=1e-7)
        if kind.moves:
            bias = np.array(kind.bias(q, rates, numbers).packed(), dtype=float)
            assert bias[:3] == pytest.approx(_vee(gain), abs=1e-6)
            assert bias[3:] == pytest.approx(rotation.T @ (on + back - 2 * here) / step**2, abs=1e-6)


def _vee(matrix: Array) -> Array:
    skew = (matrix - matrix.T) / 2
    return np.array([skew[2, 1], skew[0, 2], skew[1, 0]])


@pytest.mark.parametrize("name", NAMES)
def test_energy_is_kept_without_losses(name: str) -> None:
    """Classical Runge-Kutta steps of a free fall from a random state."""
    free = {"drive": drive_kind("free")}
    nodes = (
        Node("one", -1, joint(name, "a", **free), RigidLink((random_body(np.random.default_rng(1)),))),
        Node("two", 0, joint("revolute", "b", **free), RigidLink((random_body(np.random.default_rng(2)),))),
    )
    model = Model(Chain("two", nodes, GRAVITY))
    rng, step = np.random.default_rng(7), 5e-4
    q, rates = rng.uniform(-1, 1, (2, model.nq))

    def rate(x: Array) -> Array:
        return np.concatenate([x[model.nq :], np.asarray(model.forward_dynamics(x[: model.nq], x[model.nq :], []))])

    def energy(x: Array) -> float:
        return float(sum(model.energies(x[: model.nq], x[model.nq :]).values()))

    x = start = np.concatenate([q, rates])
    for _ in range(400):
        one = rate(x)
        two = rate(x + step / 2 * one)
        three = rate(x + step / 2 * two)
        x = x + step / 6 * (one + 2 * two + 2 * three + rate(x + step * three))
    kinetic = model.energies(start[: model.nq], start[model.nq :])["kinetic"]
    assert np.abs(x - start).max() > 0.1
    assert energy(x) == pytest.approx(energy(start), abs=1e-9 * max(1.0, float(kinetic)))


@pytest.mark.parametrize("name", NAMES)
def test_words_units_and_drawing(name: str) -> None:
    kind = joint_kind(name)
    assert kind.name == str(kind) == name
    assert kind.summary
    assert kind.drawing in {"cylinder", "box", "ball", "none"}
    names = [each.of("j") for each in kind.coordinates]
    assert len({*names}) == len(names) == kind.size
    assert all(each.unit in {"rad", "m"} for each in kind.coordinates)
    assert kind.moves == bool(names)
    assert kind == type(kind)()


def test_registry_refuses_a_taken_name_and_another_contract() -> None:
    class Other(JointKind):
        name = "revolute"

        def place(self, q: Any, numbers: Any) -> tuple[v.Matrix, v.Vector]:
            return v.identity(), v.zero()

    with pytest.raises(InputError, match="which is taken"):
        JOINTS.register(Other)
    with pytest.raises(InputError, match="JointKind"):
        JOINTS.register(int)  # pyright: ignore[reportArgumentType]
    with pytest.raises(KeyError, match="Did you mean `screw`"):
        joint_kind("scrw")


SHEET = """
format: 1
kind: arm
name: two
gravity: 9.81
joints:
  - {{name: j, type: {kind}, child: one, {more}}}
  - {{name: k, type: revolute, child: two, axis: [0, 1, 0], origin: {{position: [0.3, 0, 0]}}}}
links:
  - {{name: one, bodies: [{body}]}}
  - {{name: two, bodies: [{body}]}}
drives:
  - joint: {driven}
    command: position
    signal: {{type: quintic, start: 0.0, end: 0.4, duration: 0.2}}
    controller: {{type: pd, position_gain: 300.0, velocity_gain: 20.0}}
integration: {{duration: 0.3, output_step: 2.0e-2, method: dormand_prince}}
"""
BODY = "{name: body, mass: 1.2, center: [0.1, 0.02, 0.05], inertia: {xx: 0.02, yy: 0.03, zz: 0.025}}"
IN_SHEETS = {
    "revolute": ("axis: [0, 0, 1], motor: {inertia: 0.1, side: joint}", "j"),
    "prismatic": ("axis: [0, 0, 1], motor: {inertia: 0.1, side: joint}", "j"),
    "universal": ("motor: {inertia: 0.1, side: joint}, gear: {stiffness: 4000.0, damping: 2.0}", "j.y"),
    "screw": ("axis: [0, 0, 1], parameters: {pitch: 0.02}, motor: {inertia: 0.1, side: joint}", "j"),
}


def read(kind: str, folder: Path) -> Any:
    more, driven = IN_SHEETS[kind]
    path = folder / f"{kind}.yaml"
    path.write_text(SHEET.format(kind=kind, more=more, body=BODY, driven=driven), encoding="utf-8")
    return load(str(path))


@pytest.mark.parametrize("kind", IN_SHEETS)
def test_a_sheet_runs(kind: str, tmp_path: Path) -> None:
    """The works of motors and losses are what the energy gained; parameters and coordinates have their names."""
    robot = read(kind, tmp_path)
    assert robot.chain().nodes[0].joint.kind == joint_kind(kind)
    assert type(robot).model_validate(robot.model_dump(by_alias=True)) == robot
    run = simulate_motion(robot)
    assert np.abs(run.energy_balance).max() < 1e-6 * run.energy_moved
    assert {each.of("j") for each in joint_kind(kind).coordinates} <= {*run.coordinates}
    assert run.q[-1, list(run.coordinates).index(IN_SHEETS[kind][1])] == pytest.approx(0.4, abs=0.1)


@pytest.mark.parametrize(
    ("wrong", "words"),
    [("type: skrew", "Did you mean `screw`"), ("parameters: {pich: 0.02}", "parameters.pitch is missing")],
)
def test_wrong_words_of_a_user_kind_are_named(wrong: str, words: str, tmp_path: Path) -> None:
    read("screw", tmp_path)
    path = tmp_path / "screw.yaml"
    right = "type: screw" if wrong.startswith("type") else "parameters: {pitch: 0.02}"
    path.write_text(path.read_text(encoding="utf-8").replace(right, wrong), encoding="utf-8")
    with pytest.raises(TmodesError, match=words):
        load(str(path))
