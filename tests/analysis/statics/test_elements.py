"""Statics of gears, joints, surfaces and single beams against closed forms."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from analysis.statics.beams import clamped
from tmodes.analysis.statics.equilibrium import Load, equilibrium, free_coordinates
from tmodes.analysis.statics.loads import acts_of, surface_act
from tmodes.analysis.statics.system import StaticSystem
from tmodes.chain.chain import Chain, Gear, Joint, Motor, Node, Point
from tmodes.frame import Placement
from tmodes.kinds.contacts.registry import Contact
from tmodes.kinds.drives.registry import drive_kind
from tmodes.kinds.joints.registry import joint_kind
from tmodes.kinds.links.contract import Body
from tmodes.kinds.links.rigid import RigidLink
from tmodes.kinds.links.strain import Beam, BeamPiece  # fmt: skip
from tmodes.model.model import Model

LENGTH, BENDING = 1.2, 7.466666666666667
TORSION = 26e9 * 3.728854453606258e-10
AXIAL = 70e9 * 8e-5
DOWN = np.array([0.0, 0.0, -9.81])
SMALL = 1e-5
"""Share of a load at which the square of the deflection is rounding."""


def strip(**beam) -> Model:
    return clamped((TORSION, BENDING, BENDING), length=LENGTH, mass=2700 * 8e-5, **beam)


def on_joint(joint: Joint, link, *, gravity=DOWN, tip=(0.0, 0.0, 0.0), **more) -> Model:
    """One joint, one link, a point called tip."""
    points = (Point("tip", 0, offset=Placement(position=np.array(tip))),)
    return Model(Chain("one", (Node("link", -1, joint, link),), np.asarray(gravity), points=points, **more))


def geared(stiffness=(300.0,), drive="elastic", kind="revolute", axis=(0.0, 1.0, 0.0), **gear) -> Joint:
    motor = Motor(0.1) if drive == "elastic" else None
    drives, kinds = drive_kind(drive), joint_kind(kind)
    return Joint("hinge", kinds, axis=np.array(axis), drive=drives, motor=motor, gear=Gear(stiffness, **gear))


ROD = RigidLink((Body(2.0, np.array([0.5, 0.0, 0.0]), 0.1 * np.eye(3)),))


@pytest.mark.parametrize(
    ("load", "deflection", "slope"),
    [((0.5, 0.0), 0.03857142857142857, 0.04821428571428571), ((0.0, 0.3), 0.02892857142857143, 0.04821428571428571)],
)
@pytest.mark.parametrize("plane", ["y", "z"])
def test_small_bending(load, deflection, slope, plane):
    """Tip force and tip moment, both planes: Euler and Bernoulli's closed forms to 1e-9."""
    force, moment = SMALL * load[0], SMALL * load[1]
    model = strip(bend_y=3, bend_z=3)
    given = Load("tip", (0, 0, force), (0, -moment, 0)) if plane == "y" else Load("tip", (0, force, 0), (0, 0, moment))
    rest = equilibrium(model, [given])
    travel, turn = rest.displacement()
    assert travel[2 if plane == "y" else 1] == pytest.approx(SMALL * deflection, rel=1e-9)
    assert np.linalg.norm(turn) == pytest.approx(SMALL * slope, rel=1e-9)


def test_small_self_weight():
    model = clamped((TORSION, BENDING, BENDING), length=LENGTH, mass=2700 * 8e-5,
                    gravity=(0.0, 0.0, -9.81 * SMALL), bend_y=3, bend_z=3)  # fmt: skip
    travel, turn = equilibrium(model).displacement()
    assert travel[2] == pytest.approx(-SMALL * 0.07355818285714287, rel=1e-9)
    assert turn[1] == pytest.approx(SMALL * 0.08173131428571428, rel=1e-9)


def test_twist_and_stretch():
    """Uniform along the beam: exact at any load."""
    model = strip(twist=1, bend_y=1, bend_z=1, stretch=1, axial=AXIAL)
    travel, turn = equilibrium(model, [Load("tip", (100.0, 0, 0), (0.4, 0, 0))]).displacement()
    assert turn == pytest.approx([0.049509946529781815, 0, 0], abs=1e-12)
    assert travel == pytest.approx([2.1428571428571428e-05, 0, 0], abs=1e-14)


@pytest.mark.parametrize("drive", ["elastic", "spring"])
def test_posture_of_gear_and_link(drive):
    """k L/EI = 5, payload -0.5 EI/L^2, weight -0.3 EI/L^3: reference values of an independent solver, 1e-9."""
    piece = BeamPiece(1.0, (1.0, 1.0), (1.0, 1.0), (1.0, 1.0), (0.0, 0.0), (1.0, 1.0))
    joint = geared((5.0,), drive, axis=(0.0, 0.0, 1.0))
    model = on_joint(joint, Beam(1.0, (piece,), bend_z=6), gravity=np.array([0.0, -0.3, 0.0]))
    rest = equilibrium(model, [Load("tip", (0, -0.5, 0))])
    (x, y, _), axes = (part[0] for part in rest.model.pose(rest.q))
    assert rest.named["hinge"] == pytest.approx(-0.12356552554910841, abs=2e-9)
    assert (x, y) == pytest.approx((0.9474380826684393, -0.3091033565153305), abs=2e-8)
    assert np.arctan2(axes[1, 0], axes[0, 0]) == pytest.approx(-0.4043824364501555, abs=2e-8)


@pytest.mark.parametrize(("turn", "near"), [(0.05, 4e-3), (5e-6, 1e-8)])
def test_pressing_a_wall(turn, near):
    """F = L phi/(1/kw + L^3/3EI + L^2/kg), reference value 0.7304378449897161 N at 0.05 rad: linear in small angles."""
    piece = BeamPiece(1.0, (7.4667, 7.4667), (7.4667, 7.4667), (1.0, 1.0), (0.0, 0.0), (0.2, 0.2))
    model = on_joint(geared(axis=(0.0, 0.0, 1.0)), Beam(1.2, (piece,), bend_z=3), gravity=np.zeros(3))
    wall = {"type": "plane", "position": [0.0, 0.0, 0.0], "normal": [0.0, -1.0, 0.0]}
    sheet = Contact.of({"shape": wall, "law": "unilateral", "stiffness": 5000.0, "damping": 0.0})
    rest = equilibrium(model, held={"hinge.motor": turn}, contact=sheet)
    assert rest.wrenches is not None
    assert -rest.wrenches[0, 1] == pytest.approx(0.7304378449897161 * turn / 0.05, rel=near)
    assert rest.named["hinge.motor"] == turn
    assert turn - rest.named["hinge"] == pytest.approx(0.7304378449897161 * turn / 0.05 * 1.2 / 300, rel=near)


def test_a_wall_only_pushes():
    """A unilateral surface out of reach does nothing; a bilateral one holds the point back."""
    model = on_joint(geared(), ROD, gravity=np.zeros(3), tip=(1.0, 0.0, 0.0))
    away = {"type": "plane", "position": [0.0, 0.0, -0.01], "normal": [0.0, 0.0, 1.0]}
    sheet = Contact.of({"shape": away, "law": "unilateral", "stiffness": 1000.0, "damping": 0.0})
    assert np.abs(equilibrium(model, contact=sheet).q).max() == 0.0
    held = equilibrium(
        model, contact=Contact.of({"shape": away, "law": "bilateral", "stiffness": 1000.0, "damping": 0.0})
    )
    assert held.named["hinge"] == pytest.approx(0.01 * 1000 / (300 + 1000), rel=1e-3)


def test_weight_on_a_gear_at_a_motor_angle():
    """k (gamma - theta) = m g c cos(gamma), about y: positive turns down. The root of one equation."""
    from scipy.optimize import brentq

    rest = equilibrium(on_joint(geared((40.0,)), ROD), held={"hinge.motor": -0.4})
    root = brentq(lambda g: 40 * (g + 0.4) - 2 * 9.81 * 0.5 * np.cos(g), -1, 1, xtol=1e-15)
    assert rest.named["hinge"] == pytest.approx(root, abs=1e-12)  # pyright: ignore


def test_harmonic_drive_of_two_ranges():
    """10 N*m at 1000, 20 N*m more at 2000 N*m/rad: 0.02 rad."""
    model = on_joint(geared((1000.0, 2000.0), limits=(10.0,)), ROD, gravity=np.zeros(3))
    assert equilibrium(model, [Load("tip", moment=(0, 30.0, 0))]).named["hinge"] == pytest.approx(0.02, abs=1e-12)


def test_backlash_is_crossed():
    """The play, then T/k."""
    model = on_joint(geared((1000.0,), backlash=0.003), ROD, gravity=np.zeros(3))
    assert equilibrium(model, [Load("tip", moment=(0, 5.0, 0))]).named["hinge"] == pytest.approx(0.008, rel=1e-12)


def test_prismatic_spring():
    joint = geared((500.0,), "spring", "prismatic", (0.0, 0.0, 1.0))
    assert equilibrium(on_joint(joint, ROD)).named["hinge"] == pytest.approx(-2 * 9.81 / 500, rel=1e-12)


def test_coupled_motors_turn_the_unloaded_joints():
    """Gear inputs S th: the second motor sits on the base, so its joint turns back with the first."""
    joints = [replace(geared(axis=(0.0, 0.0, 1.0)), name=name) for name in ("one", "two")]
    nodes = tuple(Node(f"link{k}", k - 1, joint, ROD) for k, joint in enumerate(joints))
    model = Model(Chain("two", nodes, np.zeros(3), couplings=np.array([[1.0, 0.0], [-1.0, 1.0]])))
    rest = equilibrium(model, held={"one.motor": 0.3, "two.motor": 0.5})
    assert rest.named == pytest.approx({"one.motor": 0.3, "two.motor": 0.5, "one": 0.3, "two": 0.2}, abs=1e-12)


def test_column_on_a_gear_buckles_at_its_stiffness():
    """P L = k: the load 1000 N on 300 N*m/rad and 0.6 m is lost at one half."""
    model = on_joint(geared(), ROD, gravity=np.zeros(3), tip=(0.6, 0.0, 0.0))
    rest = equilibrium(model, [Load("tip", (-1000.0, 0, 0))])
    assert rest.lost_stability_at == pytest.approx(0.5, rel=1e-9)
    assert rest.unstable_modes[0].coordinate == "hinge"
    inertia = 0.1 + 2 * 0.25
    assert rest.unstable_modes[0].rate == pytest.approx(np.sqrt(300 / inertia), rel=1e-9)


def test_loose_joint_sinks_to_its_lowest_place():
    """No spring holds it: it hangs, stable, at the frequency of a pendulum."""
    joint = Joint("hinge", joint_kind("revolute"), axis=np.array([0.0, 1.0, 0.0]))
    rest = equilibrium(on_joint(joint, ROD), free=["hinge"], start={"hinge": 0.3})
    assert rest.named["hinge"] == pytest.approx(np.pi / 2, abs=1e-9)
    assert rest.stable
    assert rest.lowest_frequency_Hz == pytest.approx(np.sqrt(2 * 9.81 * 0.5 / 0.6) / (2 * np.pi), rel=1e-9)


def test_slope_is_the_difference_quotient():
    """Dead and following loads, a ball that is pressed, weight: every entry of K, in space."""
    model = strip(bend_y=3, bend_z=3)
    ball = {"type": "ball", "center": [1.0, 0.3, 0.5], "radius": 0.8}
    sheet = Contact.of({"shape": ball, "law": "bilateral", "stiffness": 40.0, "damping": 0.0, "preload": 0.5})
    loads = [Load("tip", (0.3, -0.2, 0.4), (0.1, 0.2, -0.3)), Load("tip", (0.2, 0.5, 0.1), (0.3, -0.1, 0.2), True)]
    acts = [*acts_of(model, loads), surface_act(model, sheet)]
    system = StaticSystem(model, acts, free_coordinates(model, {}, []))
    q = np.array([0.3, -0.2, 0.1, -0.4, 0.15, 0.05])
    slope = system.reduced(q, 0.7)[1]
    ahead, behind = ([system.forces(q + sign * step, 0.7).rest for step in 1e-5 * np.eye(6)] for sign in (1, -1))
    assert np.abs((np.array(ahead) - np.array(behind)).T / 2e-5 - slope).max() < 1e-8 * np.abs(slope).max()
