"""Energies and the Rayleigh function of the seed's robot, in both readings. Everything else is derived from them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import casadi as ca

from tmodes.equations.lagrange.coordinates import deformations
from tmodes.equations.lagrange.kinematics import mode_tips, projected_lengths
from tmodes.paper.mechanism import Mechanism, Reading
from tmodes.paper.sheet import PaperRobot

__all__ = ["Energies", "bending_levers", "energies"]


@dataclass(frozen=True)
class Energies:
    """What the robot weighs, stores and loses: kinetic and potential [J], Rayleigh functions [W]."""

    kinetic: Any
    gravity: Any
    elastic_gear: Any
    elastic_link: Any
    rayleigh_gear: Any
    rayleigh_link: Any


def energies(robot: PaperRobot, mechanism: Mechanism, phi: Any, phid: Any) -> Energies:
    """All energies of the robot in one reading; ``robot`` may hold numbers or symbols."""
    kinetic = _printed_kinetic if mechanism.reading is Reading.PRINTED else _spatial_kinetic
    angles, rates = deformations(phi), deformations(phid)
    levers = bending_levers(robot, mechanism, phi)
    gear_is_rigid = "gear" in mechanism.rigid
    return Energies(
        kinetic=kinetic(robot, phi, phid) + _rotary_kinetic(robot, phid) + robot.motor.kinetic(phid[5]),
        gravity=_gravity(robot, phi),
        elastic_gear=0 if gear_is_rigid else robot.gear.stored(angles.xi),
        elastic_link=_link_quadratic(robot, mechanism, angles, levers, "tip_stiffness"),
        rayleigh_gear=0 if gear_is_rigid else robot.gear.dissipated(rates.xi),
        rayleigh_link=_link_quadratic(robot, mechanism, rates, levers, "tip_damping"),
    )


def _masses(robot: PaperRobot) -> tuple[Any, Any]:
    """Point masses at the tips of mode 1 and mode 2: mel1 and m + mel2 [kg]."""
    first, second = robot.link.modes
    return first.tip_mass, robot.payload.mass + second.tip_mass


def _spatial_kinetic(robot: PaperRobot, phi: Any, phid: Any) -> Any:
    """Translation of the point masses, `consistent` reading: the whole velocity in space.

    Eq. (14) [derived]: 1/2 mel1 v1.v1 + 1/2 (m + mel2) v2.v2 and the rotary terms; the print shows its first terms and
    the coefficient H11 that follows from it. {test_printed_h11_entry}
    Eq. (28) [stated]: mel2, Jel2 at the full length of mode 2 enter here. {test_slip_13_mass}
    Eq. (30) [stated]: mel1, Jel1 at the full length of mode 1 enter here. {test_slip_13_mass}
    """
    first, second = robot.link.modes
    q, delta, vt, e = phid[0], phid[1], phid[3], phid[4]
    inner = _arm_velocity(first.length, phi[3], q, vt)
    outer = _arm_velocity(second.length, phi[3] + phi[4], q + delta, vt + e)
    cross = _in_one_frame(inner, outer, phi[1])
    squares = [sum(part**2 for part in arm) for arm in (inner, outer)]
    masses = _masses(robot)
    return (masses[0] * squares[0] + masses[1] * (squares[0] + squares[1] + 2 * cross)) / 2


def _arm_velocity(length: Any, elevation: Any, azimuth_rate: Any, rate: Any) -> tuple[Any, Any, Any]:
    """Velocity of a chord's end against its root, in the chord's own azimuth: inwards, sideways, up [m/s]."""
    flat, up = length * ca.cos(elevation), length * ca.sin(elevation)
    return up * rate, flat * azimuth_rate, flat * rate


def _in_one_frame(inner: Any, outer: Any, turn: Any) -> Any:
    """Scalar product of two such velocities whose azimuths differ by ``turn`` (outer less inner)."""
    along = inner[0] * outer[0] + inner[1] * outer[1]
    across = inner[0] * outer[1] - inner[1] * outer[0]
    return along * ca.cos(turn) + across * ca.sin(turn) + inner[2] * outer[2]


def _printed_kinetic(robot: PaperRobot, phi: Any, phid: Any) -> Any:
    """Translation of the point masses, `printed` reading: a horizontal part (lm, le held) plus a vertical part."""
    first, second = robot.link.modes
    lm, le = projected_lengths(phi, robot.link)
    horizontal = _planar_squares(lm, le, phi[1], phid[0], phid[1])
    vertical = _planar_squares(first.length, second.length, phi[4], phid[3], phid[4])
    return sum(mass * (h + v) / 2 for mass, h, v in zip(_masses(robot), horizontal, vertical, strict=True))


def _planar_squares(a: Any, b: Any, bend: Any, rate: Any, bend_rate: Any) -> tuple[Any, Any]:
    """Squared speeds of the ends of a planar two-bar chain of lengths a, b."""
    outer = rate + bend_rate
    first = (a * rate) ** 2
    return first, first + (b * outer) ** 2 + 2 * a * b * ca.cos(bend) * rate * outer


def _rotary_kinetic(robot: PaperRobot, phid: Any) -> Any:
    """Rotation of the modes' ends and the payload, with the rates of the line's tangents there."""
    q, delta, gamma, vt, e = (phid[k] for k in range(5))
    first, second = robot.link.modes
    at_first = (3 / 2 * q - gamma / 2) ** 2 + (3 / 2 * vt) ** 2
    at_second = (3 / 4 * q + 3 / 2 * delta + gamma / 4) ** 2 + (3 / 4 * vt + 3 / 2 * e) ** 2
    return first.tip_inertia * at_first / 2 + (robot.payload.inertia + second.tip_inertia) * at_second / 2


def _gravity(robot: PaperRobot, phi: Any) -> Any:
    """Potential energy of the masses [J], zero at z = 0.

    Eq. (15) [stated]: Ep = g (mel1 l1 sin vt + (m + mel2)(l1 sin vt + l2 sin(vt + e))). {test_gravity_energy}
    """
    return robot.gravity * sum(
        mass * point[2] for mass, point in zip(_masses(robot), mode_tips(phi, robot.link), strict=True)
    )


def bending_levers(robot: PaperRobot, mechanism: Mechanism, phi: Any) -> tuple[Any, Any, Any, Any]:
    """Lengths that turn bending angles into deflections r, in the order th11q, th12d, th11m, th12e.

    Eq. (9) [stated]: r11m = l1 th11m. {test_elastic_energy_terms}
    Eq. (10) [stated]: r12e = l2 (e - vt/2). {test_elastic_energy_terms}
    Eq. (11) [stated]: r11q = l1 cos vt (q - gamma). {test_elastic_energy_terms}
    Eq. (12) [stated]: r12d = l2 cos(vt + e) (delta - (q - gamma)/2). {test_elastic_energy_terms}
    """
    first, second = (mode.length for mode in robot.link.modes)
    lm, le = (first, second) if mechanism.reading is Reading.PRINTED else projected_lengths(phi, robot.link)
    return lm, le, first, second


def _link_quadratic(robot: PaperRobot, mechanism: Mechanism, values: Any, levers: Any, constant: str) -> Any:
    """1/2 sum C (lever value)^2 over both modes and both planes: elastic energy, or Rayleigh function of the rates.

    Eq. (16) [stated]: Epels_11m = 1/2 Cs1 th11m^2 l1^2. {test_elastic_energy_terms}
    Eq. (17) [stated]: Epels_12e = 1/2 Cs2 (e - vt/2)^2 l2^2. {test_elastic_energy_terms}
    Eq. (18) [stated]: Epels_11q = 1/2 Cs1 (q - gamma)^2 (l1 cos vt)^2. {test_elastic_energy_terms}
    Eq. (19) [stated]: Epels_12d = 1/2 Cs2 (delta - (q - gamma)/2)^2 (l2 cos(vt + e))^2. {test_elastic_energy_terms}
    Eq. (20) [corrected]: Phi_11m = 1/2 Bs1 th11m'^2 l1^2; the print lost the dot. {test_rayleigh_terms}
    Eq. (21) [corrected]: Phi_12e = 1/2 Bs2 (e' - vt'/2)^2 l2^2; the dots again. {test_rayleigh_terms}
    Eq. (22) [corrected]: Phi_11q = 1/2 Bs1 (q' - gamma')^2 (l1 cos vt)^2; the dots again. {test_rayleigh_terms}
    Eq. (23) [corrected]: Phi_12d = 1/2 Bs2 (delta' - (q' - gamma')/2)^2 (l2 cos(vt + e))^2. {test_rayleigh_terms}
    Eq. (26) [stated]: Epel is the sum of (16)-(19) and (24). {test_elastic_energy_terms}
    Eq. (27) [stated]: Phi_el is the sum of (20)-(23) and (25). {test_rayleigh_terms}
    Slip (20)-(23): the dots of the rates are lost in the print {test_rayleigh_terms}
    """
    total: Any = 0
    for index, mode in enumerate(robot.link.modes):
        if f"mode{index + 1}" in mechanism.rigid:
            continue
        for place in (index, index + 2):
            total += getattr(mode, constant) * (levers[place] * values[place]) ** 2 / 2
    return total
