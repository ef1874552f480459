"""Statics that cannot be: wrong names and numbers, arms that nothing holds, that snap, that have no mass."""

from __future__ import annotations

import numpy as np
import pytest

from analysis.statics.beams import clamped
from analysis.statics.test_elements import DOWN, ROD, geared, on_joint
from tmodes.analysis.statics.equilibrium import Load, equilibrium
from tmodes.chain.chain import Gear, Joint
from tmodes.errors import InputError, SimulationError
from tmodes.kinds.joints.registry import joint_kind
from tmodes.kinds.links.rigid import RigidLink


@pytest.mark.parametrize(
    ("load", "info"),
    [
        (Load("tyre", (0, 0, 1)), "tyre"),
        (Load("tip", (0, np.nan, 1)), "force"),
        (Load("tip", (0, 0, 1), (np.inf, 0, 0)), "moment"),
        (Load("tip", (1.0, 2.0)), "force"),
        (Load("tip", (1e300, 0.0, 0.0)), "force"),
    ],
)
def test_wrong_loads_are_refused(load, info):
    with pytest.raises(InputError, match=info):
        equilibrium(clamped(bend_z=4), [load])


@pytest.mark.parametrize(
    "given",
    [
        {"held": {"hinge.moter": 0.1}},
        {"held": {"hinge.motor": float("nan")}},
        {"held": {"hinge.motor": 1e9}},
        {"free": ["elbow"]},
        {"start": {"elbow": 0.0}},
        {"held": {"hinge.motor": 0.0}, "free": ["hinge.motor"]},
    ],
)
def test_wrong_coordinates_are_refused(given):
    with pytest.raises(InputError, match="hinge"):
        equilibrium(on_joint(geared(), ROD), **given)


@pytest.mark.nightly
def test_a_snap_is_reported_with_the_load_it_carried():
    """A gear that softens at 50 N*m under an eccentric column: P = T/(L sin g + e cos g) has its peak at 0.05 rad."""
    joint = geared((1000.0, 10.0), limits=(50.0,))
    model = on_joint(joint, ROD, gravity=np.zeros(3), tip=(1.0, 0.0, 0.05))
    peak = 50 / (np.sin(0.05) + 0.05 * np.cos(0.05))
    with pytest.raises(SimulationError, match="load factor") as info:
        equilibrium(model, [Load("tip", (-1000.0, 0, 0))])
    reached = float(str(info.value).split("load factor ")[1].split(" ")[0])
    assert reached == pytest.approx(peak / 1000, rel=1e-4)
    assert equilibrium(model, [Load("tip", (-0.99 * peak, 0, 0))]).stable


def test_a_loose_joint_that_a_moment_spins_has_no_rest():
    joint = Joint("hinge", joint_kind("revolute"), axis=np.array([0.0, 1.0, 0.0]))
    model = on_joint(joint, ROD, gravity=np.zeros(3))
    with pytest.raises(SimulationError, match="hinge"):
        equilibrium(model, [Load("tip", moment=(0, 5.0, 0))], free=["hinge"])


def test_a_loose_joint_without_load_is_not_stable():
    """It rests anywhere, and stays nowhere."""
    joint = Joint("hinge", joint_kind("revolute"), axis=np.array([0.0, 1.0, 0.0]))
    rest = equilibrium(on_joint(joint, ROD, gravity=np.zeros(3)), free=["hinge"])
    assert not rest.stable
    assert rest.unstable_modes == ()


@pytest.mark.nightly
def test_a_following_moment_that_winds_without_end_is_stopped():
    model = on_joint(geared((1.0,)), ROD, gravity=np.zeros(3))
    with pytest.raises(SimulationError, match="load factor"):
        equilibrium(model, [Load("tip", moment=(0, 1e6, 0), follows=True)])


def test_nothing_free_is_rigid():
    rest = equilibrium(on_joint(Joint("hinge", joint_kind("revolute")), ROD))
    assert rest.stable
    assert rest.lowest_frequency_Hz == np.inf
    assert rest.residual == 0.0


def test_no_mass_is_reported():
    joint = geared()
    assert joint.gear == Gear((300.0,))
    with pytest.raises(SimulationError, match="mass"):
        equilibrium(on_joint(joint, RigidLink(), gravity=DOWN))
