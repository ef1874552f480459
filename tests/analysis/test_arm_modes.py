"""Modes of arms against exact frequencies: beams, two inertias on a gear, controllers, dampers."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.linalg import eigh
from scipy.optimize import brentq

from analysis.statics.beams import clamped
from analysis.statics.test_elements import ROD, geared, on_joint
from tmodes.analysis.modes.modes import LinearServo, MotorState, modes_about
from tmodes.analysis.modes.of_sheet import sheet_frequencies
from tmodes.analysis.modes.shapes import undamped_shapes
from tmodes.analysis.statics.equilibrium import Load, equilibrium
from tmodes.chain.chain import Chain, Friction, Joint, Motor, Node
from tmodes.kinds.contacts.registry import Contact
from tmodes.kinds.joints.registry import joint_kind
from tmodes.kinds.links.contract import Body
from tmodes.kinds.links.segment import Segment
from tmodes.kinds.links.strain import Beam, BeamPiece
from tmodes.model.model import Model
from tmodes.robots.load import load

INERTIA, ROTOR, STIFFNESS = 0.1 + 2 * 0.25, 0.1, 300.0
NONE = np.zeros(3)


def test_clamped_beam():
    """beta L = 1.87510407, 4.69409113; Kelvin-Voigt damping: ratio eta w/2 of each mode."""
    eta = 1e-3
    modes = modes_about(equilibrium(clamped((1.0, 2.0, 5.0), bend_y=6, damping_time=eta)))
    exact = np.array([1.8751040687119611, 4.694091132974175]) ** 2 * np.sqrt(2.0)
    assert [2 * np.pi * mode.frequency_Hz for mode in modes[:2]] == pytest.approx(exact, rel=2e-5)
    assert [mode.damping_ratio for mode in modes[:2]] == pytest.approx(eta * exact / 2, rel=2e-5)
    assert {mode.element for mode in modes} == {"beam.bend_y"}
    assert all(mode.stable for mode in modes)
    damped = modes[0].damped_frequency_Hz
    assert damped == pytest.approx(modes[0].frequency_Hz * np.sqrt(1 - modes[0].damping_ratio ** 2), rel=1e-9)


def test_compression_lowers_the_frequency_to_nothing():
    """Half the buckling load, exact: wIV + P w2 - W^2 w = 0 (w2 = second derivative), clamped, w2 = w3 + P w1 = 0."""
    load = np.pi**2 / 8

    def determinant(frequency: float) -> float:
        middle = np.sqrt(load**2 / 4 + frequency**2)
        a, b = np.sqrt(middle + load / 2), np.sqrt(middle - load / 2)
        bent = (-(a**2) * np.cos(a) - b**2 * np.cosh(b), -(a**2) * np.sin(a) - a * b * np.sinh(b))
        cosine = (a**3 - load * a) * np.sin(a) - (b**3 + load * b) * np.sinh(b)
        sine = (load * a - a**3) * np.cos(a) - (a * b**2 + load * a) * np.cosh(b)
        return bent[0] * sine - bent[1] * cosine

    exact = brentq(determinant, 1.0, 3.5, xtol=1e-14)
    pressed = modes_about(equilibrium(clamped(bend_z=6), [Load("tip", (-load, 0, 0))]))[0]
    assert 2 * np.pi * pressed.frequency_Hz == pytest.approx(exact, rel=1e-7)


def test_motor_locked_and_free():
    """sqrt(k/I); sqrt(k (1/I + 1/J)) and a free turn of the whole arm."""
    rest = equilibrium(on_joint(geared(), ROD, gravity=NONE))
    (locked,) = modes_about(rest)
    assert 2 * np.pi * locked.frequency_Hz == pytest.approx(np.sqrt(STIFFNESS / INERTIA), rel=1e-10)
    turn, ringing = modes_about(rest, MotorState.FREE)
    assert (turn.frequency_Hz, turn.element, turn.stable) == (0.0, "whole arm, free", True)
    assert 2 * np.pi * ringing.frequency_Hz == pytest.approx(np.sqrt(STIFFNESS * (1 / INERTIA + 1 / ROTOR)), rel=1e-10)
    assert ringing.shape == pytest.approx([1.0, -ROTOR / INERTIA], rel=1e-9)
    assert (ringing.element, ringing.share) == ("hinge.gear", pytest.approx(1.0))


@pytest.mark.parametrize("follows", [False, True])
def test_a_motor_without_inertia_has_no_motion_of_its_own(follows):
    """Its motion is prescribed, or it could have none; also where a following force makes the stiffness asymmetric."""
    same, none = (50.0, 50.0), (0.0, 0.0)
    piece = BeamPiece(1.0, same, same, same, none, (1.0, 1.0), (none, none, none))
    model = on_joint(replace(geared(), motor=Motor(0.0)), Beam(0.6, (piece,), bend_y=2), gravity=NONE)
    rest = equilibrium(model, [Load("tip", (-5.0, 0.0, 1.0), follows=follows)])
    stiffness = rest.matrices[2]
    assert (np.abs(stiffness - stiffness.T).max() > 1e-6 * np.abs(stiffness).max()) == follows
    locked, free = modes_about(rest), modes_about(rest, MotorState.FREE)
    assert len(locked) == len(free) == 3
    assert [one.frequency_Hz for one in free] == [one.frequency_Hz for one in locked]


def test_motor_under_control():
    """Roots of the fourth-degree polynomial of two inertias, the motor on a spring and a damper."""
    rest = equilibrium(on_joint(geared(), ROD, gravity=NONE))
    stiffness, damping = 200.0, 3.0
    modes = modes_about(rest, MotorState.CONTROLLED, {"hinge.motor": LinearServo(stiffness, damping)})
    motor = np.polynomial.Polynomial([stiffness + STIFFNESS, damping, ROTOR])
    joint = np.polynomial.Polynomial([STIFFNESS, 0, INERTIA])
    roots = (motor * joint - STIFFNESS**2).roots()
    exact = sorted(root.imag / (2 * np.pi) for root in roots if root.imag > 0)
    assert sorted(mode.damped_frequency_Hz or 0.0 for mode in modes) == pytest.approx(exact, rel=1e-9)
    assert sum(modes[0].shares.values()) == pytest.approx(1.0)
    assert "hinge.controller" in modes[0].shares


def test_over_damped_mode_is_two_motions_without_vibration():
    """Time constants of the roots of J s^2 + d s + c."""
    modes = modes_about(equilibrium(on_joint(geared(damping=1000.0), ROD, gravity=NONE)))
    assert [(mode.frequency_Hz, mode.damped_frequency_Hz, mode.damping_ratio) for mode in modes] == [(0, None, 1)] * 2
    exact = -1 / np.roots([INERTIA, 1000.0, STIFFNESS])
    assert [mode.time_constant_s for mode in modes] == pytest.approx(sorted(exact, reverse=True), rel=1e-9)
    (undamped,) = [one for mode in modes if (one := mode.undamped_frequency_Hz) is not None]
    assert 2 * np.pi * undamped == pytest.approx(np.sqrt(STIFFNESS / INERTIA), rel=1e-10)


def test_natural_frequency_is_that_of_the_pole():
    """Of any damping; that of the undamped robot is named so."""
    joint, motor = geared(damping=3.0), Motor(ROTOR, Friction(viscous=0.9))
    modes = modes_about(equilibrium(on_joint(replace(joint, motor=motor), ROD, gravity=NONE)), MotorState.FREE)
    ringing = [mode for mode in modes if mode.damped_frequency_Hz]
    assert ringing
    for mode in ringing:
        assert 2 * np.pi * mode.frequency_Hz == pytest.approx(abs(complex(*mode.pole)), rel=1e-9)
        assert mode.undamped_frequency_Hz == pytest.approx(mode.frequency_Hz, rel=0.1)


def test_dry_friction_has_no_part():
    """Its slope at rest would hold everything; viscous friction stays."""
    joint = geared()
    viscous, dry = Friction(viscous=0.6), Friction(viscous=0.6, coulomb=5.0, static_extra=1.0)
    ratios = []
    for friction in (viscous, dry):
        own = replace(joint, friction=friction, motor=Motor(ROTOR, friction))
        ratios.append(modes_about(equilibrium(on_joint(own, ROD, gravity=NONE)))[0].damping_ratio)
    assert ratios[0] == pytest.approx(0.6 / (2 * np.sqrt(STIFFNESS * INERTIA)), rel=1e-9)
    assert ratios[1] == ratios[0]


def test_a_buckled_arm_is_unstable():
    rest = equilibrium(on_joint(geared(), ROD, gravity=NONE, tip=(1.0, 0.0, 0.0)), [Load("tip", (-400.0, 0, 0))])
    (mode,) = modes_about(rest)
    assert not mode.stable
    assert mode.frequency_Hz == 0.0


@pytest.mark.parametrize("ratio", [0.0, 0.5])
def test_a_surface_brings_its_mass_and_damper(ratio):
    """Tip on a spring of 100 EI/L^3 and a mass of ``ratio`` times the beam's: EI w3 = (k - m W^2) w there, w2 = 0."""
    stiffness, damping = 100.0, 0.02
    floor = {"type": "plane", "position": [0.0, 0.0, 0.0], "normal": [0.0, 0.0, 1.0]}
    law = {"law": "bilateral", "stiffness": stiffness, "damping": damping, "mass": ratio or 0.0}
    surface = Contact.of({"shape": floor, **law})
    modes = modes_about(equilibrium(clamped(bend_y=8), contact=surface))

    def determinant(b: float) -> float:
        own = stiffness - ratio * b**4
        cosine, sine = np.cos(b) - np.cosh(b), np.sin(b) - np.sinh(b)
        rows = [
            [-np.cos(b) - np.cosh(b), -np.sin(b) - np.sinh(b)],
            [b**3 * (np.sin(b) - np.sinh(b)) - own * cosine, b**3 * (-np.cos(b) - np.cosh(b)) - own * sine],
        ]
        return float(np.linalg.det(rows)) / np.cosh(b)

    grid = np.linspace(0.5, 8.0, 400)
    signs = [determinant(b) for b in grid]
    roots = [brentq(determinant, grid[k], grid[k + 1]) for k in range(399) if signs[k] * signs[k + 1] < 0][:2]
    exact = np.array(roots, dtype=float) ** 2
    assert [2 * np.pi * mode.frequency_Hz for mode in modes[:2]] == pytest.approx(exact, rel=1e-5)

    def shape(b: float, s: np.ndarray) -> np.ndarray:
        share = -(np.cos(b) + np.cosh(b)) / (np.sin(b) + np.sinh(b))
        return np.cos(b * s) - np.cosh(b * s) + share * (np.sin(b * s) - np.sinh(b * s))

    s = np.linspace(0, 1, 4001)
    for b, mode in zip(np.sqrt(exact), modes, strict=False):
        mass = np.trapezoid(shape(b, s) ** 2, s) + ratio * shape(b, s)[-1] ** 2
        assert mode.damping_ratio == pytest.approx(damping * shape(b, s)[-1] ** 2 / (2 * b**2 * mass), rel=2e-3)


def test_natural_frequency_under_control():
    """Of ringing modes |lambda|/2 pi: with the damped frequency and the ratio it makes a right triangle."""
    rest = equilibrium(on_joint(geared(), ROD, gravity=NONE))
    for mode in modes_about(rest, MotorState.CONTROLLED, {"hinge.motor": LinearServo(200.0, 30.0)}):
        if mode.damped_frequency_Hz:
            natural = mode.damped_frequency_Hz / np.sqrt(1 - mode.damping_ratio**2)
            assert mode.frequency_Hz == pytest.approx(natural, rel=1e-9)


def test_growth_time():
    """Pressed by F > k/L: I a = (F L - k) angle grows by e in sqrt(I/(F L - k))."""
    rest = equilibrium(on_joint(geared(), ROD, gravity=NONE, tip=(1.0, 0.0, 0.0)), [Load("tip", (-400.0, 0, 0))])
    (mode,) = modes_about(rest)
    assert mode.growth_time_s == pytest.approx(np.sqrt(INERTIA / (400.0 - STIFFNESS)), rel=1e-6)


def test_of_a_large_arm_the_lowest_modes_are_reported():
    """A pile of 70 segments: the first modes are those that all of them together have."""
    segment = Segment(1 / 70, 3e4, 3e4, 0.3, 0.3, bodies=(Body(0.01, NONE, np.zeros((3, 3))),))
    joints = [Joint(f"j{k}", joint_kind("fixed")) for k in range(70)]
    nodes = tuple(Node(f"n{k}", k - 1, joint, segment) for k, joint in enumerate(joints))
    rest = equilibrium(Model(Chain("pile", nodes, NONE)))
    modes = modes_about(rest)
    mass, damping, stiffness = rest.matrices
    squares = eigh(stiffness, mass, eigvals_only=True)
    assert len(modes) == 60
    assert [2 * np.pi * mode.frequency_Hz for mode in modes] == pytest.approx(np.sqrt(squares[:60]), rel=1e-6)
    assert damping == pytest.approx(1e-5 * stiffness, abs=1e-9 * np.abs(stiffness).max())
    ratios = [1e-5 * np.pi * mode.frequency_Hz for mode in modes]
    assert [mode.damping_ratio for mode in modes] == pytest.approx(ratios, rel=1e-6)


@pytest.mark.parametrize("stiffness", [100.0, 300.0, 700.0, 0.3, 1.1])
def test_free_motors_on_gears_whatever_rounding_says(stiffness: float):
    """Three free rotors on gears: K = k (1 -1; -1 1) each is singular, and passes for definite at some values of k."""
    pair = np.array([[1.0, -1.0], [-1.0, 1.0]])
    turned = np.linalg.qr(np.random.default_rng(1).normal(size=(6, 6)))[0]
    mass, springs = np.diag([0.1, 1.0] * 3), np.asarray(np.kron(np.eye(3), stiffness * pair), dtype=np.float64)
    squares = undamped_shapes(turned.T @ mass @ turned, turned.T @ springs @ turned)[0]
    assert squares[:3] == pytest.approx(0.0, abs=1e-9 * stiffness)
    assert squares[3:] == pytest.approx(stiffness * 11.0, rel=1e-9)


@pytest.mark.parametrize("seed", range(30))
def test_directions_without_mass_leave_the_others_as_they_are(seed: int) -> None:
    """Modes are those of K condensed statically, whether the robot is free, sprung, or both in any coordinates."""
    rng = np.random.default_rng(seed)
    size, massless, free = int(rng.integers(3, 9)), int(rng.integers(1, 6)), int(rng.integers(0, 3))
    root = rng.normal(size=(size + massless, size + massless))
    root[:, :free] = 0.0
    springs, turned = root.T @ root, np.linalg.qr(rng.normal(size=root.shape))[0] * rng.uniform(0.1, 10, len(root))
    part = rng.normal(size=(size, size))
    mass = np.diag([*np.ones(size), *rng.choice([0.0, 1e-16, 1e-13]) * rng.uniform(0.5, 1, massless)])
    mass[:size, :size] += part.T @ part
    own, others = slice(size), slice(size, None)
    condensed = springs[own, own] - springs[own, others] @ np.linalg.solve(
        springs[others, others], springs[others, own]
    )
    exact = eigh(condensed, mass[own, own], eigvals_only=True)
    found = undamped_shapes(turned.T @ mass @ turned, turned.T @ springs @ turned)
    assert (np.abs(found.squares) <= found.zero).sum() == free
    slow = exact[free:] < 1e4 * exact[free]
    assert found.squares[free : len(exact)][slow] == pytest.approx(exact[free:][slow], rel=1e-7)


def test_the_damper_of_a_surface_stays_where_joints_rub() -> None:
    """Modes of a robot with dry friction are those without it: the damping of what its tip touches included."""
    wall = {"law": "bilateral", "stiffness": 2e3, "damping": 40.0,
            "shape": {"type": "plane", "position": [0.82, 0.0, 0.0], "normal": [-1.0, 0.0, 0.0]}}  # fmt: skip
    plain = load("two_link_arm").with_({"contact": wall})
    rough = plain.with_({"joints.shoulder.friction": {"viscous": 0.0, "coulomb": 1.0}})
    own, other = (sheet_frequencies(one)["locked"] for one in (rough, plain))
    assert [mode["damping_ratio"] for mode in own] == pytest.approx([mode["damping_ratio"] for mode in other], rel=1e-9)
    weak = sheet_frequencies(plain.with_({"contact.damping": 0.0}))["locked"]
    assert own[0]["damping_ratio"] != pytest.approx(weak[0]["damping_ratio"], rel=0.1)
