"""Exact statics of an elastic rod: shooting with an adaptive method of order 8, and a table of cases for tests.

The rod starts at the origin along x. r' = R (1 + n1/EA, n2/GA, n3/GA), R' = R [rest + (m1/GJ, m2/EI_y, m3/EI_z)]^,
n' = -weight, m' = -r' x n, with n and m the force and moment that the outer part exerts, in world axes; m1.. and n1..
are their components along the section's axes. At the tip n = force + R follower and m = moment.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
import pytest
from numpy.typing import NDArray

__all__ = ["BENDS", "PLANAR", "Load", "Planar", "Rod", "Tip", "solve"]

Array = NDArray[np.float64]
Vector = tuple[float, float, float]

ZERO = (0.0, 0.0, 0.0)


@dataclass(frozen=True)
class Rod:
    """Length [m], stiffness against twist and bending about y and z [N*m^2], stretch and shear [N]; rest curvature."""

    length: float = 1.0
    torsion: float = 1.0
    bend_y: float = 1.0
    bend_z: float = 1.0
    axial: float = np.inf
    shear: float = np.inf
    rest_curvature: Vector = ZERO


@dataclass(frozen=True)
class Load:
    """At the tip: a dead force and moment (world axes), a force that turns with the section; weight per length."""

    force: Vector = ZERO
    moment: Vector = ZERO
    follower: Vector = ZERO
    weight: Vector = ZERO


class Tip(NamedTuple):
    """Where the tip is (3,), its axes (3, 3) as columns, and the moment at the root (3,)."""

    place: Array
    axes: Array
    root_moment: Array


def _rates(s: float, y: Array, rod: Rod, weight: Array) -> Array:
    axes, n, m = y[3:12].reshape(3, 3), y[12:15], y[15:18]
    inside_n, inside_m = n @ axes, m @ axes
    strain = np.array([1 + inside_n[0] / rod.axial, inside_n[1] / rod.shear, inside_n[2] / rod.shear])
    k1, k2, k3 = inside_m / (rod.torsion, rod.bend_y, rod.bend_z) + rod.rest_curvature
    turn = np.array([[0, -k3, k2], [k3, 0, -k1], [-k2, k1, 0]])
    x, y_, z = tangent = axes @ strain
    moment = [n[1] * z - n[2] * y_, n[2] * x - n[0] * z, n[0] * y_ - n[1] * x]
    return np.concatenate([tangent, (axes @ turn).ravel(), -weight, moment])


def _shot(root: Array, rod: Rod, weight: Array, tolerance: float) -> Array:
    """State at the tip for a force and moment (6,) at the root."""
    from scipy.integrate import solve_ivp

    start = np.concatenate([np.zeros(3), np.eye(3).ravel(), root])
    path = solve_ivp(
        _rates, (0.0, rod.length), start, "DOP853", rtol=tolerance, atol=tolerance / 10, args=(rod, weight)
    )
    return path.y[:, -1]


def solve(rod: Rod, load: Load, steps: int = 4) -> Tip:
    """The posture that grows out of the unloaded one as the load rises in ``steps``."""
    from scipy.optimize import root

    found = np.zeros(6)
    dead, moment, follower, weight = (np.array(p) for p in (load.force, load.moment, load.follower, load.weight))

    def residual(unknown: Array, share: float, tolerance: float) -> Array:
        end = _shot(unknown, rod, share * weight, tolerance)
        force = share * (dead + end[3:12].reshape(3, 3) @ follower)
        return np.concatenate([end[12:15] - force, end[15:18] - share * moment])

    for share in np.linspace(0, 1, steps + 1)[1:]:
        found = root(residual, found, args=(share, 1e-6), tol=1e-5).x
    found = root(residual, found, args=(1.0, 1e-12), tol=1e-12).x
    end = _shot(found, rod, weight, 1e-13)
    assert np.abs(residual(found, 1.0, 1e-13)).max() < 1e-9 * max(1.0, np.abs(found).max())
    return Tip(end[:3], end[3:12].reshape(3, 3), found[3:])


class Planar(NamedTuple):
    """A case with L = EI = 1 in the x-y plane: the load, the tip's x, y and the angle of its tangent [rad]."""

    load: Load
    x: float
    y: float
    angle: float


def _circle(turn: float) -> tuple[float, float, float]:
    """Tip of a rod bent by a moment: an arc of angle M L/EI."""
    return np.sin(turn) / turn, (1 - np.cos(turn)) / turn, turn


def _dead(force: float) -> Load:
    return Load(force=(0.0, force, 0.0))


PLANAR_CASES: dict[str, Planar] = {
    "dead_1": Planar(_dead(1.0), 0.943566763717, 0.301720773800, 0.461351949712),
    "dead_5": Planar(_dead(5.0), 0.612371639276, 0.713791523612, 1.215368117612),
    "dead_10": Planar(_dead(10.0), 0.445004402246, 0.810609024880, 1.430285538804),
    "follower_1": Planar(Load(follower=(0.0, 1.0, 0.0)), 0.935645669481, 0.320641994675, 0.495884642423),
    "follower_5": Planar(Load(follower=(0.0, 5.0, 0.0)), 0.172277875399, 0.780690142778, 2.098157239941),
    "follower_10": Planar(Load(follower=(0.0, 10.0, 0.0)), -0.092123181189, 0.546983264594, 2.992714816235),
    "weight_1": Planar(Load(weight=(0.0, -1.0, 0.0)), 0.991246395347, -0.123471401983, -0.165115560502),
    "weight_5": Planar(Load(weight=(0.0, -5.0, 0.0)), 0.846657179954, -0.495905044622, -0.697004777536),
    "weight_10": Planar(Load(weight=(0.0, -10.0, 0.0)), 0.656353761239, -0.700199715514, -1.052643117197),
    "weight_and_payload": Planar(
        Load(force=(0.0, -2.0, 0.0), weight=(0.0, -1.0, 0.0)), 0.799458587008, -0.547303131718, -0.862750239889
    ),
}
"""Dead and follower force P L^2/EI, weight q L^3/EI, by the shooting above; the loads 1 and the last one agree with
an independent solver to 1e-10."""

MOMENTS = {
    f"moment_{turn:g}_rad": Planar(Load(moment=(0.0, 0.0, turn)), *_circle(turn))
    for turn in (0.5, np.pi / 2, np.pi, 2 * np.pi)
}
"""Tip moments up to the closed circle: exact."""

PLANAR: list[Any] = [pytest.param(case, id=name) for name, case in (PLANAR_CASES | MOMENTS).items()]


def bend(axial: float = np.inf, shear: float = np.inf) -> Rod:
    """Bathe and Bolourchi's bend of 45 degrees: radius 100, section 1 x 1, E = 1e7, GJ = EI = E/12 (their nu = 0)."""
    stiffness = 1e7 / 12
    return Rod(100 * np.pi / 4, stiffness, stiffness, stiffness, axial, shear, (0.0, 0.0, 0.01))


class Bend(NamedTuple):
    """A case of the bend: the rod, the tip force along z [N] and where the tip comes to (3,)."""

    rod: Rod
    force: float
    place: Vector


BEND_CASES = {
    "rigid_line_300": Bend(bend(), 300.0, (58.779685391, 22.245034742, 40.188283838)),
    "rigid_line_450": Bend(bend(), 450.0, (52.239298421, 18.508464046, 48.497982621)),
    "rigid_line_600": Bend(bend(), 600.0, (47.151294400, 15.685078162, 53.468598442)),
    "stretch_300": Bend(bend(1e7), 300.0, (58.780248296, 22.245288539, 40.189388420)),
    "stretch_450": Bend(bend(1e7), 450.0, (52.240038829, 18.508749160, 48.500106534)),
    "stretch_600": Bend(bend(1e7), 600.0, (47.152150218, 15.685355777, 53.471762950)),
    "stretch_and_shear_300": Bend(bend(1e7, 5e6), 300.0, (58.779122490, 22.244780945, 40.191891670)),
    "stretch_and_shear_450": Bend(bend(1e7, 5e6), 450.0, (52.238558011, 18.508178925, 48.502927344)),
    "stretch_and_shear_600": Bend(bend(1e7, 5e6), 600.0, (47.150438574, 15.684800534, 53.474858792)),
}
"""Tip of the bend; with shear (GA = 5e6) at F = 300 also from a second method, minimum of energy, to 4e-7.

Without shear and stretch, and with stretch alone (EA = 1e7), by the shooting above.
"""

BENDS: list[Any] = [pytest.param(case, id=name) for name, case in BEND_CASES.items()]
