"""Direct kinematics: the tip is the point s = 1 of the elastic line."""

from __future__ import annotations

from typing import Any

import casadi as ca

from tmodes.equations.lagrange.coordinates import deformations
from tmodes.paper.mode import FlexibleLink, shape_angle, shape_slope

__all__ = ["chord_slopes", "line_point", "line_tangent", "mode_tips", "projected_lengths", "tip", "tip_jacobian"]


def projected_lengths(phi: Any, link: FlexibleLink) -> tuple[Any, Any]:
    """Lengths of the modes seen from above [m].

    Eq. (8) [stated]: a mode's tip moves on a ball of radius l, without shortening; from above its length is
    lm = l1 cos vt and le = l2 cos(vt + e). {test_line_ends_at_tip}
    """
    first, second = link.modes
    return first.length * ca.cos(phi[3]), second.length * ca.cos(phi[3] + phi[4])


def mode_tips(phi: Any, link: FlexibleLink) -> tuple[Any, Any]:
    """Positions of the tips of mode 1 and mode 2 [m], each of shape (3,)."""
    first, second = link.modes
    lm, le = projected_lengths(phi, link)
    q, azimuth, vt, elevation = phi[0], phi[0] + phi[1], phi[3], phi[3] + phi[4]
    middle = ca.vertcat(lm * ca.cos(q), lm * ca.sin(q), first.length * ca.sin(vt))
    arm = ca.vertcat(le * ca.cos(azimuth), le * ca.sin(azimuth), second.length * ca.sin(elevation))
    return middle, middle + arm


def tip(phi: Any, link: FlexibleLink) -> Any:
    """Position of the tip [m], shape (3,).

    Eq. (42) [stated]: x = lm cos q + le cos(q + delta), y likewise, z = l1 sin vt + l2 sin(vt + e).
    {test_tip_is_the_seed_formula}
    """
    return mode_tips(phi, link)[1]


def tip_jacobian(phi: Any, link: FlexibleLink) -> Any:
    """The full kinematic Jacobian d tip / d phi, shape (3, 6).

    Eq. (44) [corrected]: the print exchanges lm and le and lacks the derivatives of x and y by vt and e.
    {test_slip_44_jacobian}
    Slip (44): lm and le exchanged, derivatives of x, y by vt and e missing {test_slip_44_jacobian}
    """
    return ca.jacobian(tip(phi, link), phi)


def chord_slopes(phi: Any) -> tuple[Any, Any, Any, Any]:
    """Absolute angles of the line's tangent at the tips of mode 1 and 2: horizontal 1, 2, vertical 1, 2 [rad]."""
    angles = deformations(phi)
    first_h, first_v = phi[0] + angles.th11q / 2, phi[3] + angles.th11m / 2
    second_h = first_h + shape_slope(1) * angles.th12d
    second_v = first_v + shape_slope(1) * angles.th12e
    return first_h, second_h, first_v, second_v


def _chord_to(mode: int, phi: Any, s: Any) -> tuple[Any, Any]:
    """Azimuth and elevation of the chord from a mode's root to its point s."""
    angles = deformations(phi)
    root_h, _, root_v, _ = chord_slopes(phi)
    if mode == 1:
        return phi[2] + shape_angle(s) * angles.th11q, shape_angle(s) * angles.th11m
    return root_h + shape_angle(s) * angles.th12d, root_v + shape_angle(s) * angles.th12e


def line_point(mode: int, phi: Any, link: FlexibleLink, s: Any) -> Any:
    """Position of the point ``s`` in 0..1 of the elastic line of a mode (1 or 2) [m], shape (3,).

    Eq. (3) [derived]: the line is the sum of the modes' deflections y = X(x) T(t), carried by the motion of the
    modes before them: direct kinematics. {test_line_ends_at_tip}
    """
    azimuth, elevation = _chord_to(mode, phi, s)
    length = link.modes[mode - 1].length * s
    flat = length * ca.cos(elevation)
    arm = ca.vertcat(flat * ca.cos(azimuth), flat * ca.sin(azimuth), length * ca.sin(elevation))
    return arm if mode == 1 else mode_tips(phi, link)[0] + arm


def line_tangent(mode: int, phi: Any, link: FlexibleLink, s: Any) -> Any:
    """Derivative of the line by arc parameter s [m], shape (3,): tangent times the mode's length."""
    station = ca.SX.sym("station")
    tangent = ca.jacobian(line_point(mode, phi, link, station), station)
    return ca.substitute(tangent, station, s)
