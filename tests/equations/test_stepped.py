"""Beams whose section changes along them: compliance of the tip by the unit load, frequencies by finite elements."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.linalg import eigh

from tmodes.chain.chain import Chain, Joint, Node, Point
from tmodes.kinds.joints.registry import joint_kind
from tmodes.kinds.links.contract import Body
from tmodes.kinds.links.strain import Beam, BeamPiece
from tmodes.model.model import Model

Array = NDArray[np.float64]

YOUNG, SHEAR, DENSITY = 210e9, 80e9, 7850.0


def round_piece(end: float, outer: float, inner: float = 0.0, wide: float = 1.0) -> BeamPiece:
    """A piece of a tube; ``wide``: bending stiffness about z over that about y."""
    area, second = np.pi / 4 * (outer**2 - inner**2), np.pi / 64 * (outer**4 - inner**4)
    numbers = (YOUNG * second, wide * YOUNG * second, 2 * SHEAR * second, YOUNG * area, DENSITY * area)
    polar = (2 * DENSITY * second, 2 * DENSITY * second)
    bend_y, bend_z, torsion, axial, mass = ((value, value) for value in numbers)
    return BeamPiece(end, bend_y, bend_z, torsion, axial, mass, (polar, (0.0, 0.0), (0.0, 0.0)))


STEP = (1.0, (round_piece(0.5, 0.02), round_piece(1.0, 0.01)))
TUBES = (
    0.8,
    (round_piece(0.3 / 0.8, 0.04, 0.034), round_piece(0.55 / 0.8, 0.03, 0.026, 1.4), round_piece(1.0, 0.02, 0.016)),
)
CASES = {"step": STEP, "tubes": TUBES}


def clamped(case: tuple[float, tuple[BeamPiece, ...]], **more: Any) -> Model:
    """The beam on a wall, no gravity, its tip as a point of interest."""
    length, pieces = case
    link = Beam(length, pieces, **{"twist": 1, "bend_y": 3, "bend_z": 3, **more})
    node = Node("rod", -1, Joint("wall", joint_kind("fixed")), link)
    return Model(Chain("stepped", (node,), np.zeros(3), points=(Point("tip", 0),)))


def compliance(model: Model) -> Array:
    """(6, 6): motion of the tip (place, then turn) per force and moment on it."""
    rest = np.zeros(len(model.coordinates))
    jacobian = np.asarray(model.jacobian(rest)).reshape(-1, len(rest))[:6]
    return np.asarray(jacobian @ np.linalg.solve(model.linearize(rest)[2], jacobian.T), np.float64)


def unit_load(case: tuple[float, tuple[BeamPiece, ...]], name: str, lever: int) -> float:
    """int (L - x)^lever / stiffness dx of uniform pieces: what a unit load at the tip does there."""
    length, pieces = case
    total, start = 0.0, 0.0
    for piece in pieces:
        low, high = (length * (1 - piece.end)) ** (lever + 1), (length * (1 - start)) ** (lever + 1)
        total += (high - low) / (lever + 1) / getattr(piece, name)[0]
        start = piece.end
    return total


def test_tip_sag_of_a_step() -> None:
    """20 mm, then 10 mm of round steel, half a metre each, 1 N at the tip: a reference value in millimetres."""
    sag = compliance(clamped(STEP))[2, 2]
    assert 1e3 * sag == pytest.approx(unit_load(STEP, "bend_y", 2) * 1e3, rel=1e-12)
    assert 1e3 * sag == pytest.approx(0.58104, rel=1e-5)


@pytest.mark.parametrize("case", CASES)
@pytest.mark.parametrize("functions", [2, pytest.param(3, marks=pytest.mark.nightly)])
def test_tip_compliance_is_exact(case: str, functions: int) -> None:
    """Against forces and moments in every direction: moments of a tip load are linear, which the functions are."""
    beam = CASES[case]
    found = compliance(clamped(beam, bend_y=functions, bend_z=functions, stretch=1))
    expected = np.zeros((6, 6))
    expected[0, 0], expected[3, 3] = unit_load(beam, "axial", 0), unit_load(beam, "torsion", 0)
    for turn, place, sign, name in ((4, 2, -1, "bend_y"), (5, 1, 1, "bend_z")):
        expected[place, place], expected[turn, turn] = unit_load(beam, name, 2), unit_load(beam, name, 0)
        expected[place, turn] = expected[turn, place] = sign * unit_load(beam, name, 1)
    np.testing.assert_allclose(found, expected, rtol=1e-11, atol=1e-18)


@pytest.mark.parametrize("basis", ["legendre", "tip_weighted"])
def test_stretch_and_twist_are_those_of_a_bar_in_both_bases(basis: str) -> None:
    """F L/EA and M L/GJ of a uniform bar."""
    bar = (0.8, (round_piece(1.0, 0.02),))
    found = compliance(clamped(bar, basis=basis, stretch=1))
    assert found[0, 0] == pytest.approx(0.8 / bar[1][0].axial[0], rel=1e-12)
    assert found[3, 3] == pytest.approx(0.8 / bar[1][0].torsion[0], rel=1e-12)


@pytest.mark.parametrize("basis", ["legendre", "tip_weighted"])
@pytest.mark.parametrize(("mass", "root"), [(0.0, np.pi / 2), (1.0, 0.8603335890)])
def test_axial_frequency(basis: str, mass: float, root: float) -> None:
    """Longitudinal waves in a clamped bar with a mass at its end: x tan x = m_bar/m_end."""
    length, bar = 0.8, round_piece(1.0, 0.02)
    own = bar.mass[0] * length
    body = ((1.0, Body(mass * own)),) if mass else ()
    model = clamped((length, (bar,)), basis=basis, twist=0, bend_y=0, bend_z=1, stretch=3, points=6, bodies=body)
    rest = np.zeros(len(model.coordinates))
    inertia, _, stiffness = model.linearize(rest)
    along = [model.coordinates.index(f"rod.stretch{k}") for k in (1, 2, 3)]
    part = np.ix_(along, along)
    first = np.sqrt(eigh(stiffness[part], inertia[part], eigvals_only=True)[0])
    assert first == pytest.approx(root * np.sqrt(bar.axial[0] / bar.mass[0]) / length, rel=1e-4)


def finite_elements(case: tuple[float, tuple[BeamPiece, ...]], count: int = 24) -> Array:
    """Circular frequencies about y by cubic elements, ``count`` in each uniform piece."""
    length, pieces = case
    stiffness = np.zeros((2 * len(pieces) * count + 2,) * 2)
    mass, first, start = stiffness.copy(), 0, 0.0
    for piece in pieces:
        h = length * (piece.end - start) / count
        bent = np.array([[12, 6, -12, 6], [6, 4, -6, 2], [-12, -6, 12, -6], [6, 2, -6, 4]]) / h**3
        moved = np.array([[156, 22, 54, -13], [22, 4, 13, -3], [54, 13, 156, -22], [-13, -3, -22, 4]]) * h / 420
        scale = np.array([1, h, 1, h])
        for _ in range(count):
            own = slice(first, first + 4)
            stiffness[own, own] += piece.bend_y[0] * bent * np.outer(scale, scale)
            mass[own, own] += piece.mass[0] * moved * np.outer(scale, scale)
            first += 2
        start = piece.end
    return np.sqrt(1 / eigh(mass[2:, 2:], stiffness[2:, 2:], eigvals_only=True)[::-1])


@pytest.mark.parametrize("case", CASES)
@pytest.mark.parametrize(
    ("functions", "errors"),
    [(3, (6e-4, 0.03)), (4, (6e-5, 5e-3)), pytest.param(6, (5e-6, 3e-4), marks=pytest.mark.nightly)],
)
def test_frequencies_of_steps(case: str, functions: int, errors: tuple[float, float]) -> None:
    """From above but for the rule of the masses, and as near as those of a uniform beam."""
    model = clamped(CASES[case], twist=0, bend_y=functions, bend_z=0)
    inertia, _, stiffness = model.linearize(np.zeros(functions))
    found = np.sqrt(1 / eigh(inertia, stiffness, eigvals_only=True)[::-1])
    for mode, limit in enumerate(errors):
        error = found[mode] / finite_elements(CASES[case])[mode] - 1
        assert -1e-6 < error < limit


def cone(count: int = 40) -> tuple[float, tuple[BeamPiece, ...]]:
    """20 mm to 10 mm in short pieces whose steps are small: one span with one rule."""
    ends = np.linspace(0, 1, count + 1)
    middles = 0.02 - 0.01 * (ends[1:] + ends[:-1]) / 2
    whole = [round_piece(float(end), float(d)) for end, d in zip(ends[1:], middles, strict=True)]
    return 1.0, tuple(whole)


def test_a_taper_in_many_pieces_is_one_span() -> None:
    """Its steps of 4 % do not divide it; sag 64 F L^3/(3 pi E d1^3 d2) of a cone, Roark's formula."""
    beam = cone(100)
    model = clamped(beam)
    part = model.parts.nodes[0].link
    assert part is not None
    sag = compliance(model)[2, 2]
    assert sag == pytest.approx(64 / (3 * np.pi * YOUNG * 0.02**3 * 0.01), rel=5e-4)


def test_a_rigid_piece_does_not_bend() -> None:
    """Half of it rigid: (L/2)^3/(3 EI) of the tip's half alone."""
    half = round_piece(1.0, 0.02)
    rigid = (np.inf, np.inf)
    stiff = replace(half, end=0.5, bend_y=rigid, bend_z=rigid, torsion=rigid)
    found = compliance(clamped((1.0, (stiff, half))))
    assert found[2, 2] == pytest.approx(0.5**3 / 3 / half.bend_y[0], rel=1e-12)
    assert found[3, 3] == pytest.approx(0.5 / half.torsion[0], rel=1e-12)
