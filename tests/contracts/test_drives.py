"""Every kind of drive, and one of a user: forces, energies and losses that belong together, coordinates and inputs."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from oracle.arms.robots import GRAVITY
from random_chains import random_body
from simulation.sheets import arm
from tmodes.chain.chain import Chain, Friction, Gear, Joint, Motor, Node
from tmodes.compile.ir.program import kernel_function
from tmodes.equations.recursion.drive_kernels import LOCK, drive_kernels, drive_numbers
from tmodes.errors import TmodesError
from tmodes.gradients.gradient import forward_sensitivities
from tmodes.kinds.drives.contract import Angles, DriveKind, DriveLaw, Dry, Elastic, Forward
from tmodes.kinds.drives.registry import DRIVES, drive_kind
from tmodes.kinds.joints.registry import joint_kind
from tmodes.kinds.links.rigid import RigidLink
from tmodes.kinds.schema.quantity import DataSheet, positive
from tmodes.model.model import Model
from tmodes.simulation.simulate import simulate_motion

Array = NDArray[np.float64]

HARDENING = 40.0


class MuscleNumbers(DataSheet):
    """What a sheet gives of a muscle."""

    hardening: float = positive("N*m/rad^3", "c", "effort over the cubed angle")


class Muscle(DriveKind):
    """An effort next to a cubic spring about zero and the joint's friction."""

    name = "muscle"
    summary = "effort and a hardening spring"
    schema = MuscleNumbers
    takes_effort = True

    def forward(self, law: DriveLaw, at: Angles, effort: Any, held: Any, step: Any) -> Forward:
        joint, slope = law.joint_friction(at.joint_rate)
        stiffness = 3 * law.own[0] * at.joint * at.joint
        own = law.inertia + step * slope + step * step * stiffness + held
        return Forward(effort - law.own[0] * at.joint**3 - joint, own)

    def elastic(self, law: DriveLaw, at: Angles) -> Elastic:
        joint, _ = law.joint_friction(at.joint_rate)
        energy = law.own[0] * at.joint**4 / 4
        return Elastic(law.own[0] * at.joint**3 + joint, 0.0, energy, 0.0, joint * at.joint_rate)


NAMES = [*DRIVES.names, "muscle"]


@pytest.fixture(autouse=True, scope="module")
def user_kind() -> Iterator[None]:
    DRIVES.register(Muscle)
    yield
    DRIVES.unregister("muscle")


def joint(kind: str, *, rubbed: float = 1.0) -> Joint:
    """With all that a drive may have; ``rubbed`` scales friction and damping, without which the gear is linear."""
    friction = Friction(0.3 * rubbed, 0.5 * rubbed, 0.2 * rubbed, 0.4, 1e-2)
    gear = Gear((100.0, 250.0), (5.0,), damping=0.5) if rubbed else Gear((5.0,))
    drive = drive_kind(kind)
    motor = Motor(0.2, friction) if drive.takes_effort else None
    rest = 0.1 if drive.has_gear and not drive.has_motor else 0.0
    own = (HARDENING,) * drive.own_numbers
    return Joint(
        "j", joint_kind("revolute"), drive=drive, motor=motor, gear=gear, friction=friction, rest=rest,
        drive_parameters=own,
    )  # fmt: skip


def law(kind: str) -> DriveLaw:
    one = joint(kind)
    kernels = drive_kernels(one, drive_kind(kind))
    packed = drive_numbers(one, drive_kind(kind))
    assert len(packed) == kernels.size
    return DriveLaw(packed, ranges=kernels.ranges, dead_zone=False, dry_motor=kernels.dry_motor,
                    dry_joint=kernels.dry_joint, own=kernels.kind.own_numbers)  # fmt: skip


def states(kind: str) -> Iterator[Angles]:
    for row in np.random.default_rng(4).uniform(-0.4, 0.4, (8, 4)):
        th, speed = row[:2] if drive_kind(kind).has_motor else (0.0, 0.0)
        yield Angles(float(th), float(speed), float(row[2]), float(row[3]))


@pytest.mark.parametrize("name", NAMES)
def test_forces_are_the_slopes_of_the_energy_and_what_is_lost(name: str) -> None:
    kind, drive, step = drive_kind(name), law(name), 1e-6
    for at in states(name):
        found = kind.elastic(drive, at)
        power = found.on_joint * at.joint_rate + found.on_motor * at.motor_rate
        ahead, behind = (
            kind.elastic(drive, at._replace(motor=at.motor + k * at.motor_rate, joint=at.joint + k * at.joint_rate))
            for k in (step, -step)
        )
        stored = (ahead.energy - behind.energy) / (2 * step)
        lost = found.lost_in_gear + found.lost_in_friction
        assert lost >= 0
        assert power == pytest.approx(stored + lost, rel=1e-6, abs=1e-8)


@pytest.mark.parametrize("name", NAMES)
def test_forward_without_a_step_is_the_effort_less_those_forces(name: str) -> None:
    kind, drive = drive_kind(name), law(name)
    for at in states(name):
        found, forces = kind.forward(drive, at, 1.7, 0.0, 0.0), kind.elastic(drive, at)
        direct = 1.7 if kind.is_given or kind.carries_rotor else 0.0
        assert found.effort == pytest.approx(direct - forces.on_joint, rel=1e-12)
        assert found.own == pytest.approx(drive.inertia if kind.carries_rotor else 0.0)
        if kind.has_motor:
            pushed, _, share = found.motor
            assert share * pushed == pytest.approx((1.7 - forces.on_motor) / drive.inertia)


@pytest.mark.parametrize("name", NAMES)
def test_what_an_implicit_step_adds_is_the_derivative_of_the_forces(name: str) -> None:
    """h D + h^2 K of joint and motor by exact derivatives, the motor's row eliminated; ``held`` is along the effort."""
    ca = pytest.importorskip("casadi")
    kind, drive, held = drive_kind(name), law(name), 0.37
    if kind.is_given:
        return
    place, rate = ca.SX.sym("place", 2), ca.SX.sym("rate", 2)
    forces = kind.elastic(drive, Angles(place[0], rate[0], place[1], rate[1]))
    both = ca.vertcat(forces.on_motor, forces.on_joint)
    slopes = ca.Function("slopes", [place, rate], [ca.jacobian(both, place), ca.jacobian(both, rate)])
    for at in states(name):
        for step in (1e-3, 0.3):
            stiffness, damping = (np.array(m) for m in slopes([at.motor, at.joint], [at.motor_rate, at.joint_rate]))
            added = step * damping + step**2 * stiffness
            wanted = added[1, 1]
            if kind.has_motor:
                wanted -= added[1, 0] * added[0, 1] / (drive.inertia + held + added[0, 0])
            elif kind.carries_rotor:
                wanted += drive.inertia + held
            assert kind.forward(drive, at, 1.7, held, step).own == pytest.approx(wanted, rel=1e-10)


@pytest.mark.parametrize("name", NAMES)
def test_flags_are_the_coordinates_and_inputs(name: str) -> None:
    kind = drive_kind(name)
    nodes = (Node("link", -1, joint(name), RigidLink((random_body(np.random.default_rng(1)),))),)
    model = Model(Chain("one", nodes, GRAVITY))
    assert kind.name == str(kind) == name
    assert kind.summary
    assert not (kind.is_given and kind.takes_effort)
    assert tuple(model.coordinates) == (("j.motor", "j") if kind.has_motor else ("j",))
    assert len(model.parts.efforts) == int(kind.takes_effort)
    assert len(model.parts.given) == int(kind.is_given)


@pytest.mark.parametrize("name", [name for name in NAMES if name != "prescribed"])
def test_energy_is_kept_without_losses(name: str) -> None:
    nodes = (Node("link", -1, joint(name, rubbed=0.0), RigidLink((random_body(np.random.default_rng(1)),))),)
    model = Model(Chain("one", nodes, GRAVITY))
    effort = np.zeros(len(model.parts.efforts))
    x = start = np.concatenate([np.full(model.nq, 0.2), np.full(model.nq, -0.5)])

    def rate(x: Array) -> Array:
        q, rates = x[: model.nq], x[model.nq :]
        return np.concatenate([rates, np.asarray(model.forward_dynamics(q, rates, effort))])

    def energy(x: Array) -> float:
        return float(sum(model.energies(x[: model.nq], x[model.nq :]).values()))

    step = 2e-4
    for _ in range(400):
        one = rate(x)
        two = rate(x + step / 2 * one)
        three = rate(x + step / 2 * two)
        x = x + step / 6 * (one + 2 * two + 2 * three + rate(x + step * three))
    assert np.abs(x - start).max() > 0.01
    assert energy(x) == pytest.approx(energy(start), abs=1e-8)


def sheet(**changed: Any) -> Any:
    """A pendulum about a vertical axis, on a muscle."""
    given = {"name": "j", "type": "revolute", "child": "l", "axis": [0, 0, 1], "drive": "muscle",
             "drive_parameters": {"hardening": HARDENING}, "motor": {"inertia": 0.3, "side": "joint"}}  # fmt: skip
    still = {"type": "constant", "value": 0.0}
    return arm(gravity=0.0, joints=[given | changed], links=[{"name": "l"}],
               drives=[{"joint": "j", "command": "torque", "signal": still}],
               initial={"state": "zero", "coordinates": {"j": 0.4}},
               integration={"duration": 1.0, "relative_tolerance": 1e-10, "absolute_tolerance": 1e-11})  # fmt: skip


def test_a_sheet_names_a_drive_of_a_user() -> None:
    """A quarter of the period of I x'' = -c x^3 from rest at A is 1.8540746773 / (A sqrt(c/I)); energy is kept."""
    run = simulate_motion(sheet())
    quarter = 1.8540746773013719 / (0.4 * np.sqrt(HARDENING / 0.3))
    assert np.interp(quarter, run.times, run.q[:, 0]) == pytest.approx(0.0, abs=1e-4)
    assert sum(kind[0] for kind in run.energies.values()) == pytest.approx(HARDENING * 0.4**4 / 4)
    assert np.abs(run.energy_balance).max() < 1e-8 * run.energy_moved
    slope = forward_sensitivities(sheet(), ["joints.j.drive_parameters.hardening"]).by
    ends = [simulate_motion(sheet(drive_parameters={"hardening": HARDENING + s})).q[-1, 0] for s in (1e-3, -1e-3)]
    assert slope["joints.j.drive_parameters.hardening"][-1, 0] == pytest.approx((ends[0] - ends[1]) / 2e-3, rel=1e-5)


@pytest.mark.parametrize(
    ("changed", "words"),
    [({"drive": "muscel"}, "muscle"), ({"drive": "spring", "drive_parameters": None}, "takes no effort"),
     ({"drive_parameters": {}}, "hardening"), ({"drive": "elastic", "drive_parameters": None}, "elastic gear")],
)  # fmt: skip
def test_a_drive_that_cannot_be_is_refused(changed: dict[str, Any], words: str) -> None:
    with pytest.raises(TmodesError, match=words):
        sheet(**changed)


@given(
    rate=st.floats(-3.0, 3.0).filter(lambda v: abs(v) > 1e-3), viscous=st.floats(0.0, 2.0), level=st.floats(0.1, 5.0),
    extra=st.floats(0.0, 5.0), stribeck=st.floats(1e-2, 1.0), width=st.floats(1e-2, 1.0), dry=st.sampled_from(Dry),
)  # fmt: skip
def test_the_slope_of_friction_is_its_derivative(
    rate: float, viscous: float, level: float, extra: float, stribeck: float, width: float, dry: Dry
) -> None:
    """Of motor and joint, for every structure; implicit steps and Jacobians use it."""
    numbers = [0.0, 0.0, *[viscous, level, extra, stribeck, width] * 2]
    law = DriveLaw(numbers, ranges=0, dead_zone=False, dry_motor=dry, dry_joint=dry)
    step = 1e-5 * min(abs(rate), stribeck, width)
    for friction in (law.motor_friction, law.joint_friction):
        (ahead, _), (behind, _) = friction(rate + step), friction(rate - step)
        assert friction(rate)[1] == pytest.approx((ahead - behind) / (2 * step), rel=1e-5, abs=1e-5 * (level + extra))
        assert friction(-rate)[0] == pytest.approx(-friction(rate)[0], rel=1e-12)


@pytest.mark.parametrize("kind", DRIVES.names)
def test_what_sticks_has_no_acceleration_and_shows_the_force_that_friction_bears(kind: str) -> None:
    """Of every kind, explicit and in an implicit step: against the same drive that does not stick."""
    friction = Friction(0.3, 0.5, 0.2)
    made = replace(joint(kind), friction=friction)
    if made.motor is not None:
        made = replace(made, motor=replace(made.motor, friction=friction))
    drive = drive_kind(kind)
    if drive.is_given:
        return
    kernels = drive_kernels(made, drive)
    assert kernels.set_sides == (drive.has_motor, True)
    numbers = drive_numbers(made, drive)
    forward = kernel_function(kernels.forward())
    for step in (0.0, 0.01):
        for motor_side, joint_side in ((1.0, 0.0), (0.0, 1.0), (0.0, 0.0)):
            sides = [motor_side, LOCK * (motor_side == 0), joint_side, LOCK * (joint_side == 0)]
            effort, own, motor = forward(numbers, 0.3, 0.0, 0.1, 0.0, 2.0, [0.0, 0.0], step, sides)
            acceleration = float(effort) / (1.0 + float(own))  # of a joint with an inertia of 1
            pushed, pull, share = (float(x) for x in motor.full().ravel())
            turned = share * (pushed + pull * acceleration)
            assert (abs(acceleration) < 1e-20) == (joint_side == 0)
            if drive.has_motor:
                assert (abs(turned) < 1e-20) == (motor_side == 0)
