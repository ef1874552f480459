"""The robot of Filipovic & Djuric (2010) by its energies, in both readings of the paper: two systems.

One joint about z, one link of the kind ``modes`` with two modes and a payload at its tip. The energies are stated in
the paper's coordinates [q, delta, gamma, vt, e]; a robot's own are its joint's angle and the modes' bending angles,
from which the paper's follow by a constant map, Eq. (5). Motor, gear, control and contact are those of any robot.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import casadi as ca
import numpy as np

from tmodes.chain.chain import Chain
from tmodes.equations.lagrange.system import System
from tmodes.errors import InputError
from tmodes.frame import Placement
from tmodes.kinds.noted.functions import allclose, array, isfinite, number

__all__ = ["CONSISTENT", "COORDINATES", "NUMBERS", "OWN", "PRINTED", "basis", "matches", "numbers"]

COORDINATES = ("joint", "azimuth1", "azimuth2", "elevation1", "elevation2")
"""Coordinates of the robot: its joint, and the bending angles of both modes."""

NUMBERS = ("l1", "l2", "m1", "m2", "j1", "j2", "c1", "c2", "b1", "b2")
"""Lengths, point masses, rotary inertias, springs and dampers of the modes."""

_MODES = 2


def numbers(chain: Chain) -> Mapping[str, float]:
    """Lengths, masses, inertias, springs and dampers of the robot's link and of what it carries at its tip.

    Eq. (28) [stated]: mel2, Jel2 at the full length of mode 2 enter here. {test_slip_13_mass}
    Eq. (30) [stated]: mel1, Jel1 at the full length of mode 1 enter here. {test_slip_13_mass}

    Raises :class:`tmodes.errors.InputError` for a robot that is not one joint with one link of two modes.
    """
    link: Any = chain.nodes[-1].link
    modes = getattr(link, "modes", ())
    if len(chain.nodes) != 1 or len(modes) != _MODES:
        expected = "one joint that carries one link of the kind `modes` with two modes"
        raise InputError("equations", "another robot", expected, "take `equations: recursion`, which suits all robots")
    _refuse_elsewhere(chain, number(modes[0].length + modes[1].length))
    mass = [modes[0].tip_mass, modes[1].tip_mass]
    inertia = [modes[0].tip_inertia, modes[1].tip_inertia]
    for s, body in link.carried:
        if s < 1.0 or np.any(body.center) or np.ptp(np.diag(body.inertia)) or not _is_diagonal(body.inertia):
            expected = "bodies at the tip itself, with the same rotary inertia about all axes"
            raise InputError("links", "another body on the link", expected, "take `equations: recursion`")
        mass[1] += body.mass
        inertia[1] += number(body.inertia[0, 0])
    bends = [isfinite(mode.bending_stiffness) for mode in modes]
    springs = [mode.tip_stiffness if free else 0.0 for mode, free in zip(modes, bends, strict=True)]
    dampers = [mode.tip_damping if free else 0.0 for mode, free in zip(modes, bends, strict=True)]
    values = (modes[0].length, modes[1].length, *mass, *inertia, *springs, *dampers)
    return dict(zip(NUMBERS, map(number, values), strict=True))


def _refuse_elsewhere(chain: Chain, length: float) -> None:
    """Refuse a joint, a weight or a tip that the energies do not know of."""
    node, down = chain.nodes[0], array(chain.gravity)
    turned = [*node.joint.axis, *node.joint.placement.rotation.ravel(), *node.joint.placement.position]
    end = chain.points[0].offset if chain.points else Placement()
    expected = np.zeros(3) if node.link.bends else np.array([length, 0.0, 0.0])
    issues = {
        "joints": (chain.sliding or np.any(turned != np.array([0, 0, 1, *np.eye(3).ravel(), 0, 0, 0])),
                   "one revolute joint about z at the base, with the link's root on its axis"),
        "gravity": (down[0] or down[1] or down[2] > 0, "gravity along -z"),
        "tip": (not allclose(end.position, expected) or not allclose(end.rotation, np.eye(3)),
                "the tip at the end of the last mode"),
    }  # fmt: skip
    for path, (wrong, needed) in issues.items():
        if wrong:
            raise InputError(path, "another one", needed, "take `equations: recursion`, which suits all robots")


def _is_diagonal(matrix: Any) -> bool:
    return not np.any(matrix - np.diag(np.diag(matrix)))


def matches(names: Sequence[str]) -> list[str]:
    """A robot's names of the coordinates: its joint is the one without a link's name before it."""
    found = []
    for own in COORDINATES:
        there = [name for name in names if (name.endswith(f".{own}") if own != "joint" else "." not in name)]
        found.append(there[0] if there else "")
    return found


OWN = ("q", "delta", "gamma", "vt", "e")
"""The paper's coordinates but for the motor's."""


def basis() -> Any:
    """Constant map A (5, 5): [q, delta, gamma, vt, e] = A [joint, th11q, th12d, th11m, th12e]; the inverse of (5)."""
    return np.array(
        [[1, 1, 0, 0, 0], [0, 0.5, 1, 0, 0], [1, 0, 0, 0, 0], [0, 0, 0, 1, 0], [0, 0, 0, 0.5, 1]],
    )  # fmt: skip


def _deformations(x: Any) -> tuple[Any, Any, Any, Any]:
    """Bending angles th11q, th12d, th11m, th12e of coordinates; the same map takes rates to rates.

    Eq. (5) [stated]: q = gamma + th11q, gamma = theta + xi, delta = omega_q + th12d, e = omega_m + th12e,
    solved for the angles with omega = th/2 of (6) and (7); xi is the deflection of the gear. {test_deformation_angles}
    """
    bent = x.q - x.gamma
    return bent, x.delta - bent / 2, x.vt, x.e - x.vt / 2


def _lengths(q: Any, p: Any) -> tuple[Any, Any]:
    """Lengths of the modes seen from above [m].

    Eq. (8) [stated]: a mode's tip moves on a ball of radius l, without shortening; from above its length is
    lm = l1 cos vt and le = l2 cos(vt + e). {test_tip_is_the_paper_formula}
    """
    return p.l1 * ca.cos(q.vt), p.l2 * ca.cos(q.vt + q.e)


def _tips(q: Any, p: Any) -> tuple[Any, Any]:
    """Positions of the modes' tips [m].

    Eq. (42) [stated]: x = lm cos q + le cos(q + delta), y likewise, z = l1 sin vt + l2 sin(vt + e).
    {test_tip_is_the_paper_formula}
    """
    lm, le = _lengths(q, p)
    middle = ca.vertcat(lm * ca.cos(q.q), lm * ca.sin(q.q), p.l1 * ca.sin(q.vt))
    azimuth = q.q + q.delta
    arm = ca.vertcat(le * ca.cos(azimuth), le * ca.sin(azimuth), p.l2 * ca.sin(q.vt + q.e))
    return middle, middle + arm


def _spatial(q: Any, v: Any, p: Any) -> Any:
    """Translation of the point masses, ``consistent``: the whole velocity in space.

    Eq. (14) [derived]: 1/2 mel1 v1.v1 + 1/2 (m + mel2) v2.v2 and the rotary terms; the print shows its first terms and
    the coefficient H11 that follows from it. {test_printed_h11_entry}
    """
    inner = _arm_velocity(p.l1, q.vt, v.q, v.vt)
    outer = _arm_velocity(p.l2, q.vt + q.e, v.q + v.delta, v.vt + v.e)
    along = inner[0] * outer[0] + inner[1] * outer[1]
    across = inner[0] * outer[1] - inner[1] * outer[0]
    cross = along * ca.cos(q.delta) + across * ca.sin(q.delta) + inner[2] * outer[2]
    squares = [sum(part**2 for part in arm) for arm in (inner, outer)]
    return (p.m1 * squares[0] + p.m2 * (squares[0] + squares[1] + 2 * cross)) / 2


def _arm_velocity(length: Any, elevation: Any, azimuth_rate: Any, rate: Any) -> tuple[Any, Any, Any]:
    """Velocity of a chord's end against its root, in the chord's own azimuth: inwards, sideways, up [m/s]."""
    flat, up = length * ca.cos(elevation), length * ca.sin(elevation)
    return up * rate, flat * azimuth_rate, flat * rate


def _planar(q: Any, v: Any, p: Any) -> Any:
    """Translation of the point masses, ``printed``: a horizontal part (lm, le held) plus a vertical part."""
    horizontal = _planar_squares(*_lengths(q, p), q.delta, v.q, v.delta)
    vertical = _planar_squares(p.l1, p.l2, q.e, v.vt, v.e)
    return sum(mass * (h + up) / 2 for mass, h, up in zip((p.m1, p.m2), horizontal, vertical, strict=True))


def _planar_squares(a: Any, b: Any, bend: Any, rate: Any, bend_rate: Any) -> tuple[Any, Any]:
    """Squared speeds of the ends of a planar two-bar chain of lengths a, b."""
    outer = rate + bend_rate
    first = (a * rate) ** 2
    return first, first + (b * outer) ** 2 + 2 * a * b * ca.cos(bend) * rate * outer


def _rotary(v: Any, p: Any) -> Any:
    """Rotation of the modes' ends and the payload, with the rates of the line's tangents there."""
    at_first = (3 / 2 * v.q - v.gamma / 2) ** 2 + (3 / 2 * v.vt) ** 2
    at_second = (3 / 4 * v.q + 3 / 2 * v.delta + v.gamma / 4) ** 2 + (3 / 4 * v.vt + 3 / 2 * v.e) ** 2
    return p.j1 * at_first / 2 + p.j2 * at_second / 2


def _gravity(q: Any, p: Any) -> Any:
    """Potential energy of the masses [J], zero at z = 0.

    Eq. (15) [stated]: Ep = g (mel1 l1 sin vt + (m + mel2)(l1 sin vt + l2 sin(vt + e))). {test_gravity_energy}
    """
    return p.g * sum(mass * tip[2] for mass, tip in zip((p.m1, p.m2), _tips(q, p), strict=True))


def _bent(values: tuple[Any, ...], levers: tuple[Any, ...], constants: tuple[Any, ...]) -> Any:
    """1/2 sum C (lever value)^2: elastic energy, or Rayleigh's function of the rates.

    Eq. (16) [stated]: Epels_11m = 1/2 Cs1 th11m^2 l1^2. {test_elastic_energy_terms}
    Eq. (17) [stated]: Epels_12e = 1/2 Cs2 (e - vt/2)^2 l2^2. {test_elastic_energy_terms}
    Eq. (18) [stated]: Epels_11q = 1/2 Cs1 (q - gamma)^2 (l1 cos vt)^2. {test_elastic_energy_terms}
    Eq. (19) [stated]: Epels_12d = 1/2 Cs2 (delta - (q - gamma)/2)^2 (l2 cos(vt + e))^2. {test_elastic_energy_terms}
    Eq. (20) [corrected]: Phi_11m = 1/2 Bs1 th11m'^2 l1^2; the print lost the dot. {test_rayleigh_terms}
    Eq. (21) [corrected]: Phi_12e = 1/2 Bs2 (e' - vt'/2)^2 l2^2; the dots again. {test_rayleigh_terms}
    Eq. (22) [corrected]: Phi_11q = 1/2 Bs1 (q' - gamma')^2 (l1 cos vt)^2; the dots again. {test_rayleigh_terms}
    Eq. (23) [corrected]: Phi_12d = 1/2 Bs2 (delta' - (q' - gamma')/2)^2 (l2 cos(vt + e))^2. {test_rayleigh_terms}
    Slip (20)-(23): the dots of the rates are lost in the print {test_rayleigh_terms}
    """
    return sum(c * (lever * x) ** 2 / 2 for c, lever, x in zip(constants, levers, values, strict=True))


def _levers(q: Any, p: Any, *, printed: bool) -> tuple[Any, ...]:
    """Lengths that turn bending angles into deflections r, in the order th11q, th12d, th11m, th12e.

    Eq. (9) [stated]: r11m = l1 th11m. {test_elastic_energy_terms}
    Eq. (10) [stated]: r12e = l2 (e - vt/2). {test_elastic_energy_terms}
    Eq. (11) [stated]: r11q = l1 cos vt (q - gamma). {test_elastic_energy_terms}
    Eq. (12) [stated]: r12d = l2 cos(vt + e) (delta - (q - gamma)/2). {test_elastic_energy_terms}
    """
    return (*((p.l1, p.l2) if printed else _lengths(q, p)), p.l1, p.l2)


def _points(q: Any, p: Any) -> dict[str, Any]:
    """The tip, in the axes of the line's tangent there."""
    th11q, th12d, th11m, th12e = _deformations(q)
    azimuth, elevation = q.gamma + 3 / 2 * (th11q + th12d), 3 / 2 * (th11m + th12e)
    (ca_, sa), (ce, se) = ((ca.cos(x), ca.sin(x)) for x in (azimuth, elevation))
    rotation = ca.vertcat(
        ca.horzcat(ca_ * ce, -sa, -ca_ * se), ca.horzcat(sa * ce, ca_, -sa * se), ca.horzcat(se, 0, ce)
    )
    return {"tip": (_tips(q, p)[1], rotation)}


def _planar_map(q: Any, p: Any) -> Any:
    """The paper's block Jacobian, transposed (5, 3): it counts F_x in both planes and takes or brings power.

    Eq. (40) [stated]: Je = [Jh 0; 0 Jv], each of its own plane; the vertical plane takes the component along the
    tip's horizontal radius. {test_slip_planar_map_is_not_power}
    Slip (40): F_x is counted in both planes {test_slip_planar_map_is_not_power}
    """
    position = _tips(q, p)[1]
    horizontal = _planar_jacobian(*_lengths(q, p), q.q, q.delta)
    vertical = _planar_jacobian(p.l1, p.l2, q.vt, q.e)
    radius = ca.norm_2(position[:2])
    to_radial = ca.vertcat(ca.horzcat(position[0] / radius, position[1] / radius, 0), ca.DM([[0, 0, 1]]))
    return ca.vertcat(ca.horzcat(horizontal.T, ca.SX.zeros(2, 1)), ca.SX.zeros(1, 3), vertical.T @ to_radial)


def _planar_jacobian(a: Any, b: Any, angle: Any, bend: Any) -> Any:
    """Jacobian of a planar two-bar chain of lengths a, b by its two angles, shape (2, 2)."""
    outer = angle + bend
    far = ca.vertcat(-b * ca.sin(outer), b * ca.cos(outer))
    return ca.horzcat(ca.vertcat(-a * ca.sin(angle), a * ca.cos(angle)) + far, far)


def _system(name: str, title: str, *, printed: bool) -> System:
    translation = _planar if printed else _spatial

    def kinetic(q: Any, v: Any, p: Any) -> Any:
        return translation(q, v, p) + _rotary(v, p)

    def elastic(q: Any, p: Any) -> Any:
        return _bent(_deformations(q), _levers(q, p, printed=printed), (p.c1, p.c2, p.c1, p.c2))

    def dissipation(q: Any, v: Any, p: Any) -> Any:
        return _bent(_deformations(v), _levers(q, p, printed=printed), (p.b1, p.b2, p.b1, p.b2))

    return System(
        name=name, title=title, coordinates=dict.fromkeys(COORDINATES, "rad"), parameters=dict.fromkeys(NUMBERS, 0.0),
        kinetic=kinetic, gravity=_gravity, elastic=elastic, dissipation=dissipation, points=_points, lines=(),
        numbers=numbers, own=OWN, directions=basis(), contact_map=_planar_map if printed else None, matches=matches,
    )  # fmt: skip


CONSISTENT = _system("consistent", "Filipovic & Djuric 2010, with the whole velocity in space", printed=False)
PRINTED = _system("printed", "Filipovic & Djuric 2010, with the block structure of the print", printed=True)
