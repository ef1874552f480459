"""Frequencies of strain links and of the paper's segments against exact roots and the Ritz method in 40 digits."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.linalg import eigh

from equations.exact_beams import bending, ritz_errors, rotating, torsion
from oracle.arms.robots import piece
from tmodes.chain.chain import Chain, Joint, Node
from tmodes.frame import Placement
from tmodes.kinds.joints.registry import joint_kind
from tmodes.kinds.links.contract import Body
from tmodes.kinds.links.rigid import RigidLink
from tmodes.kinds.links.segment import Segment
from tmodes.kinds.links.strain import Beam
from tmodes.model.model import Model

Array = NDArray[np.float64]

LENGTH, BENDING, MASS = 2.5, 30.0, 0.7
UNIT = np.sqrt(BENDING / (MASS * LENGTH**4))
"""Unit of circular frequency [rad/s] of a beam that bends."""

FLOOR = 1e-11
"""Relative errors below this are rounding, not the model's."""

PRINTED = {
    0: {
        1: [27.193],
        2: [0.47543, 57.965],
        3: [0.03017, 0.90254, 91.491],
        4: [1.5392e-4, 0.55976, 2.6733, 132.91],
        5: [3.8477e-6, 2.8294e-3, 2.5002, 6.3005],
        6: [8.1333e-9, 1.3898e-3, 0.030923, 6.1930],
    },
    1: {
        1: [17.238],
        2: [0.017131, 34.742],
        3: [1.1572e-3, 0.19019, 52.633],
        4: [8.2211e-6, 0.12802, 1.4890, 75.703],
        5: [9.8485e-8, 2.1210e-3, 0.94003, 4.2973],
        6: [1.1033e-11, 2.6136e-4, 0.028054, 2.9232],
    },
    10: {
        1: [15.673],
        2: [2.4624e-4, 33.116],
        3: [1.6811e-5, 0.20835, 50.964],
        4: [1.2713e-7, 0.10004, 1.5149, 74.001],
        5: [1.2995e-9, 1.9379e-3, 0.85865, 4.3140],
        6: [2.3e-15, 2.0468e-4, 0.028007, 2.7865],
    },
}
"""Errors [%] of f1..f4 by tip mass over beam mass and number of functions: reference values of a 40-digit solver."""


def cantilever(number: int, mu: float = 0.0, j: float = 0.0, **beam: Any) -> Beam:
    """A planar beam with a tip body; mu and j over the beam's mass and mass times length^2."""
    tip = Body(mu * MASS * LENGTH, inertia=j * MASS * LENGTH**3 * np.diag([0.0, 0.0, 1.0]))
    bodies = ((1.0, tip),) if mu or j else ()
    return Beam(LENGTH, (piece(BENDING / 1.3, MASS),), bend_z=number, points=number + 2, bodies=bodies, **beam)


def clamped(link: Any) -> Chain:
    """The link on a fixed base, no gravity."""
    return Chain("clamped", (Node("beam", -1, Joint("clamp", joint_kind("fixed")), link),), np.zeros(3))


def frequencies(chain: Chain, shift: float = 0.0) -> Array:
    """Circular frequencies [rad/s], rising; as largest eigenvalues 1/w^2, which keeps the digits of the first.

    ``shift`` [1/s^2] makes K positive where the whole chain can turn freely; that motion is left out.
    """
    model = Model(chain)
    mass, _, stiffness = model.linearize(np.zeros(len(model.coordinates)))
    values = eigh(mass, stiffness + shift * mass, eigvals_only=True)[::-1]
    return np.sqrt(1 / values[1:] - shift) if shift else np.sqrt(1 / values)


def assert_errors(found: Array, exact: list[Any], expected: list[float], floor: float = FLOOR) -> None:
    """Each relative error is within 1 % of the expected one and not negative; or both are below ``floor``."""
    errors = np.array([float(w / e - 1) for w, e in zip(found, exact, strict=False)])
    for error, wanted in zip(errors, expected, strict=False):
        if abs(wanted) > floor:
            assert error == pytest.approx(wanted, rel=0.01)
            assert error > 0
        else:
            assert abs(error) < floor


@pytest.mark.parametrize("number", range(1, 7))
@pytest.mark.parametrize("mu", [0, 1, 10])
def test_cantilever_with_tip_mass_has_the_printed_errors(number: int, mu: int) -> None:
    found = frequencies(clamped(cantilever(number, mu))) / UNIT
    assert_errors(found, bending(number, mu), [error / 100 for error in PRINTED[mu][number]])


@pytest.mark.parametrize("number", range(1, 7))
@pytest.mark.parametrize("mu", [0.0, 0.1, 1.0, 10.0])
def test_cantilever_has_the_errors_of_the_ritz_method(number: int, mu: float) -> None:
    found = frequencies(clamped(cantilever(number, mu))) / UNIT
    assert_errors(found, bending(number, mu), ritz_errors(number, mu=mu))


@pytest.mark.parametrize(("mu", "j"), [(0.0, 0.0), (1.0, 0.0), (10.0, 0.0), (1.0, 0.3), (1.0, 0.01)])
@pytest.mark.parametrize("basis", ["legendre", "tip_weighted"])
@pytest.mark.parametrize("number", [1, 3, 5])
def test_both_bases_have_the_errors_of_the_ritz_method(number: int, basis: str, mu: float, j: float) -> None:
    """One Gauss point more than the default: the second basis is one degree higher."""
    beam = cantilever(number, mu, j, basis=basis)
    beam = Beam(**{**beam.__dict__, "points": number + 3})
    expected = ritz_errors(number, tip_weighted=basis == "tip_weighted", mu=mu, j=j)
    assert_errors(frequencies(clamped(beam)) / UNIT, bending(number, mu, j), expected)


@pytest.mark.parametrize("number", range(2, 7))
@pytest.mark.parametrize("hub", [0.1, 1.0])
@pytest.mark.parametrize(("mu", "j"), [(0.0, 0.0), (0.5, 0.02)])
def test_hub_beam_payload(number: int, hub: float, mu: float, j: float) -> None:
    """A free hub with inertia, the beam clamped to it, a payload with inertia at its end."""
    rotor = Body(1.0, inertia=hub * MASS * LENGTH**3 * np.eye(3))
    nodes = (
        Node("hub", -1, Joint("pin", joint_kind("revolute")), RigidLink((rotor,))),
        Node("beam", 0, Joint("clamp", joint_kind("fixed")), cantilever(number, mu, j)),
    )
    found = frequencies(Chain("hub", nodes, np.zeros(3)), shift=UNIT**2) / UNIT
    assert_errors(found, bending(number, mu, j, hub), ritz_errors(number, mu=mu, j=j, hub=hub), floor=1e-9)


@pytest.mark.parametrize(("number", "r"), [(1, 0.0), (2, 0.0), (3, 0.0), (4, 0.0), (3, 1.0)])
def test_torsion(number: int, r: float) -> None:
    """Clamped bar, inertia r of the bar's own at the tip."""
    polar, rigidity = 0.02, 12.0
    tip = Body(1.0, inertia=r * polar * LENGTH * np.diag([1.0, 0.0, 0.0]))
    bar = piece(BENDING, MASS, torsion=rigidity, polar=polar)
    beam = Beam(LENGTH, (bar,), twist=number, points=number + 2, bodies=((1.0, tip),) if r else ())
    found = frequencies(clamped(beam)) / np.sqrt(rigidity / (polar * LENGTH**2))
    assert_errors(found, torsion(number, r), _twist_errors(number, r))


def _twist_errors(number: int, r: float) -> list[float]:
    """The printed ones for a free end (rounded), else those of the Ritz method: tip inertia enters as a tip mass."""
    return ritz_errors(number, mu=r, twist=True)


def test_torsion_has_the_printed_errors() -> None:
    """Percent, clamped-free: one, two and three functions."""
    for printed in ([10.3], [0.375, 20.4], [0.00683, 2.63, 33.0]):
        assert 100 * np.array(_twist_errors(len(printed), 0.0)) == pytest.approx(printed, rel=5e-3)


SEGMENTS = {
    1: [-18.8],
    2: [31.3, 3.9],
    3: [57.7, 39, 6.4],
    5: [84, 75, 57],
    10: [109, 105, 99],
    20: [123, 122, 120],
    40: [130, 130, 129],
    80: [134, 134, 134],
}
"""Errors [%] of f1..f3 of the paper's segments: reference values, as many digits as stated."""


def segments(number: int, rotary: bool = True) -> Chain:
    """A cantilever of segments: 33/140 of the mass at each tip, its inertia m (l/2)^2, stiffness 3 EI/l^3."""
    part = LENGTH / number
    mass = 33 / 140 * MASS * part
    lump = Body(mass, inertia=(mass * part**2 / 4 if rotary else 0.0) * np.diag([0.0, 0.0, 1.0]))
    link = Segment(part, 0.0, 3 * BENDING / part**3, bend_y=False, bodies=(lump,))
    nodes = (Node(f"part{i}", i - 1, Joint(f"weld{i}", joint_kind("fixed")), link) for i in range(number))
    return Chain("segments", tuple(nodes), np.zeros(3))


@pytest.mark.parametrize("number", SEGMENTS)
def test_segments_have_the_known_errors(number: int) -> None:
    found = 100 * (frequencies(segments(number))[:3] / UNIT / np.array([float(w) for w in bending(3)])[:number] - 1)
    expected = SEGMENTS[number]
    digits = [0.05 if "." in str(value) else 0.5 for value in expected]
    assert np.all(np.abs(found - expected) <= np.array(digits) * 1.001 + 0.01)


def test_segments_without_their_inertia() -> None:
    """One segment as a mass on a spring: 33/140 is Rayleigh's quotient of the static shape, 1.47 % high."""
    found = frequencies(segments(1, rotary=False))[0] / UNIT / float(bending(1)[0])
    assert 100 * (found - 1) == pytest.approx(1.47, abs=0.01)


def test_segments_converge_to_the_wrong_beam() -> None:
    """sqrt((4/3)/(33/140)) = 2.378 times the exact frequency in the limit."""
    found = frequencies(segments(80))[0] / UNIT / float(bending(1)[0])
    assert found == pytest.approx(2.339, abs=0.002)
    assert found < np.sqrt((4 / 3) / (33 / 140))


def steady(chain: Chain, speed: float) -> Array:
    """Frequencies of the links when the first joint turns at a constant speed: its own row and column are left out."""
    model = Model(chain)
    size = len(model.coordinates)
    v = np.zeros(size)
    v[model.coordinates.index("spin")] = speed
    mass, damping, stiffness = model.linearize(np.zeros(size), v)
    free = [i for i in range(size) if model.coordinates[i] != "spin"]
    part = np.ix_(free, free)
    first = np.block([[0 * mass[part], np.eye(len(free))], [-stiffness[part], -damping[part]]])
    second = np.block([[np.eye(len(free)), 0 * mass[part]], [0 * mass[part], mass[part]]])
    values = np.linalg.eigvals(np.linalg.solve(second, first)).imag
    return np.asarray(np.sort(values[values > 0]), np.float64)


@pytest.mark.slow
@pytest.mark.parametrize("speed", [0.0, 1.0, 2.0, 4.0, 12.0])
@pytest.mark.parametrize(("radius", "mu"), [(0.0, 0.0), (0.0, 1.0), (0.5, 0.3)])
@pytest.mark.parametrize("lag", [False, True])
def test_rotating_cantilever(speed: float, radius: float, mu: float, lag: bool) -> None:
    """Centrifugal stiffening out of (flap) and in (lag) the plane of turning, modes 1 to 3, with no term put in."""
    number = 8
    body = ((1.0, Body(mu * MASS * LENGTH)),) if mu else ()
    section = piece(BENDING / (1.3 if lag else 1.0), MASS)
    flap, swing = (0, number) if lag else (number, 0)
    beam = Beam(LENGTH, (section,), bend_y=flap, bend_z=swing, points=number + 2, bodies=body)
    hub = RigidLink((Body(1.0, inertia=np.eye(3)),))
    shaft = Node("hub", -1, Joint("spin", joint_kind("revolute")), hub)
    clamp = Joint("clamp", joint_kind("fixed"), Placement(position=np.array([radius * LENGTH, 0.0, 0.0])))
    nodes = (shaft, Node("beam", 0, clamp, beam))
    found = steady(Chain("rotor", nodes, np.zeros(3)), speed * UNIT) / UNIT
    expected = rotating(3, speed, lag=lag, radius=radius, mu=mu)
    np.testing.assert_allclose(found[:3], expected, rtol=1e-4)
