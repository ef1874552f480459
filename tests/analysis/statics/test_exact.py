"""The table of exact postures is what shooting gives, and agrees with other solvers' reference values."""

from __future__ import annotations

import numpy as np
import pytest

from analysis.statics.exact import BENDS, PLANAR, Bend, Load, Planar, Rod, bend, solve


@pytest.mark.parametrize("case", PLANAR)
def test_planar_cases(case: Planar) -> None:
    tip = solve(Rod(), case.load)
    np.testing.assert_allclose(tip.place, [case.x, case.y, 0.0], atol=2e-11)
    expected = [np.cos(case.angle), np.sin(case.angle), 0.0]
    np.testing.assert_allclose(tip.axes[:, 0], expected, atol=2e-11)


@pytest.mark.parametrize("case", BENDS)
def test_bends(case: Bend) -> None:
    np.testing.assert_allclose(solve(case.rod, Load(force=(0, 0, case.force))).place, case.place, atol=2e-8)


def test_elliptic_integrals_and_other_solvers() -> None:
    """Tip force 1: elliptic integrals; follower, weight and both: an independent solver, errors below 1e-10."""
    expected = {
        (Load(force=(0, 1, 0))): (1 - 0.056433236283377, 0.30172077379981),
        (Load(follower=(0, 1, 0))): (1 - 0.06435433051930783, 0.3206419946750131),
        (Load(weight=(0, -1, 0))): (1 - 0.0087536046533645, -0.12347140198335164),
        (Load(force=(0, -2, 0), weight=(0, -1, 0))): (0.7994585870084765, -0.5473031317183447),
    }
    for load, place in expected.items():
        np.testing.assert_allclose(solve(Rod(), load).place[:2], place, atol=1e-10)


def test_bend_of_45_degrees_equals_an_energy_minimum() -> None:
    """F = 300, with stretch and shear: (58.77912, 22.24478, 40.19189) to 1e-7 by another method."""
    tip = solve(bend(1e7, 5e6), Load(force=(0, 0, 300)))
    expected = [58.77912248968313, 22.244780945367143, 40.191891670147605]
    np.testing.assert_allclose(tip.place, expected, atol=1e-6)


def test_published_figures_of_the_bend() -> None:
    """Simo and Vu-Quoc 1986: (22.33, 58.84, 40.08) at F = 300 and (15.79, 47.23, 53.37) at 600 with 8 elements."""
    for force, published in ((300, [58.84, 22.33, 40.08]), (600, [47.23, 15.79, 53.37])):
        np.testing.assert_allclose(solve(bend(1e7, 5e6), Load(force=(0, 0, force))).place, published, atol=0.15)
