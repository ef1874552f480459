"""Large deflection of clamped strain links against exact rods: dead, following and weight loads, moments, a bend."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.special import ellipe, ellipk

from analysis.statics.beams import clamped, loads_of
from analysis.statics.exact import BENDS, PLANAR, Bend, Planar, Rod, solve
from analysis.statics.exact import Load as ExactLoad
from tmodes.analysis.statics.equilibrium import Equilibrium, Load, equilibrium

PUBLISHED = {1: {4: 2e-7, 6: 1e-11}, 5: {4: 2e-5, 6: 2e-7}, 10: {4: 3e-5, 6: 3e-6}}
"""Distance of the tip from exact over L, by P L^2/EI and number of functions: of a prototype of this model."""


def rest_of(case: Planar, functions: int, basis: str = "legendre") -> Equilibrium:
    model = clamped(gravity=case.load.weight, bend_z=functions, basis=basis)
    return equilibrium(model, loads_of(case.load))


def tip_of(rest: Equilibrium) -> tuple[float, float, float]:
    (x, y, _), turn = rest.model.pose(rest.q)[0][0], rest.model.pose(rest.q)[1][0]
    return x, y, float(np.arctan2(turn[1, 0], turn[0, 0]))


@pytest.mark.parametrize("functions", [4, 6])
@pytest.mark.parametrize("force", [1, 5, 10])
def test_tip_force_is_as_exact_as_the_model_can_be(force, functions):
    case = next(param.values[0] for param in PLANAR if param.id == f"dead_{force}")
    x, y, _ = tip_of(rest_of(case, functions))
    assert np.hypot(x - case.x, y - case.y) <= PUBLISHED[force][functions]


@pytest.mark.parametrize("case", PLANAR)
def test_all_planar_cases(case):
    """Six functions: within 1e-4 L of exact, whatever the load; the angle too, the circle closed."""
    rest = rest_of(case, 6)
    x, y, angle = tip_of(rest)
    assert np.hypot(x - case.x, y - case.y) <= 1e-4
    assert abs(np.angle(np.exp(1j * (angle - case.angle)))) <= 1e-4
    assert rest.residual <= 1e-9
    assert rest.stable
    assert rest.lost_stability_at is None


@pytest.mark.parametrize("name", ["dead_10", "follower_5", "weight_10", "weight_and_payload"])
def test_more_functions_converge(name):
    """Four, six and eight functions of a free end: every pair at least five times nearer, in the end 1e-6 L."""
    case = next(param.values[0] for param in PLANAR if param.id == name)
    tips = [tip_of(rest_of(case, functions, "tip_weighted")) for functions in (4, 6, 8)]
    errors = [np.hypot(x - case.x, y - case.y) for x, y, _ in tips]
    assert errors[1] < errors[0] / 5
    assert errors[2] < errors[1] / 5
    assert errors[2] < 1e-6


def test_a_moment_winds_the_beam_to_a_closed_circle():
    """One constant curvature: the lowest function alone, on a path that never jumps."""
    rest = equilibrium(clamped(bend_z=4), [Load("tip", moment=(0, 0, 2 * np.pi))])
    assert rest.q == pytest.approx([2 * np.pi, 0, 0, 0], abs=1e-12)
    assert np.abs(np.diff(rest.load_path[:, 0])).max() < 0.1
    assert np.abs(rest.load_path[:, 1] - 2 * np.pi * rest.load_path[:, 0]).max() < 1e-12


@pytest.mark.parametrize("case", BENDS)
def test_bend_of_45_degrees(case: Bend):
    """Out of its plane, twisted and bent: within 1e-4 L, also of the beam that shears, which the link does not."""
    rod = case.rod
    model = clamped(
        (rod.torsion, rod.bend_y, rod.bend_z), length=rod.length, twist=4, bend_y=4, bend_z=4,
        rest_curvature=np.array(rod.rest_curvature),
    )  # fmt: skip
    rest = equilibrium(model, [Load("tip", (0, 0, case.force))])
    place = rest.model.pose(rest.q)[0][0]
    assert np.linalg.norm(place - np.array(case.place)) <= 1e-4 * rod.length
    assert rest.stable


def test_forces_and_moments_in_space():
    """Three stiffnesses, a dead force and a dead moment about world axes, which makes the slope unsymmetric."""
    rod = Rod(torsion=0.8, bend_y=1.0, bend_z=2.0)
    load = ExactLoad(force=(-0.3, 0.8, 0.5), moment=(0.2, 0.3, -0.4))
    exact = solve(rod, load)
    rest = equilibrium(clamped((0.8, 1.0, 2.0), twist=4, bend_y=4, bend_z=4), loads_of(load))
    place, axes = (part[0] for part in rest.model.pose(rest.q))
    assert np.linalg.norm(place - exact.place) < 2e-5
    assert np.abs(axes - exact.axes).max() < 2e-5
    stiffness = rest.matrices[2]
    assert np.abs(stiffness - stiffness.T).max() > 1e-3


def test_euler_column_loses_its_stability_where_it_buckles():
    """Straight all the way: reported unstable, with the factor pi^2/4 EI/L^2 over the load."""
    rest = equilibrium(clamped(bend_z=6), [Load("tip", (-5.0, 0, 0))])
    assert rest.lost_stability_at == pytest.approx(np.pi**2 / 4 / 5, rel=1e-8)
    assert np.abs(rest.q).max() == 0.0
    assert not rest.stable
    assert rest.lowest_frequency_Hz == 0.0
    assert [mode.frequency_Hz for mode in rest.unstable_modes] == [0.0]


def test_nearly_straight_column_buckles_aside_and_holds():
    """The elastica: tip angle 60 degrees at P/P_cr = (2 K/pi)^2, k = sin(30 degrees)."""
    m = np.sin(np.pi / 6) ** 2
    load = ellipk(m) ** 2
    rest = equilibrium(clamped(bend_z=6), [Load("tip", (-load, 1e-7, 0))])
    x, y, angle = tip_of(rest)
    assert (x, y) == pytest.approx((2 * ellipe(m) / ellipk(m) - 1, 2 * np.sqrt(m) / ellipk(m)), abs=1e-5)
    assert angle == pytest.approx(np.pi / 3, abs=1e-5)
    assert rest.stable
    assert rest.lost_stability_at is None


def test_following_compression_flutters():
    """Beck's column: no other equilibrium, and yet lost at 20.0509 EI/L^2 to a growing vibration."""
    rest = equilibrium(clamped(bend_z=6), [Load("tip", (-30.0, 0, 0), follows=True)])
    assert 30 * (rest.lost_stability_at or 0.0) == pytest.approx(20.0509, rel=1e-4)
    assert rest.unstable_modes[0].frequency_Hz > 0.1


@pytest.mark.parametrize("ratio", [1.0, 1e4, 1e8])
def test_a_column_buckles_at_eulers_load_however_stiff_it_is_the_other_way(ratio: float) -> None:
    """pi^2 EI/4 L^2; frequencies of the stiff direction are 1e4 times higher, and their rounding beyond the lowest."""
    model, euler = clamped((1.0, ratio, 1.0), bend_y=3, bend_z=3, twist=1), np.pi**2 / 4
    below = equilibrium(model, [Load("tip", [-0.999 * euler, 0.0, 0.0])])
    assert below.stable
    assert below.lowest_frequency_Hz == pytest.approx(0.01966295, rel=1e-6)
    beyond = equilibrium(model, [Load("tip", [-1.05 * euler, 0.0, 0.0])])
    assert not beyond.stable
    assert beyond.lost_stability_at == pytest.approx(1 / 1.05, rel=2e-4)
