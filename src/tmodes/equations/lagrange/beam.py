"""The elastic line: deflection, slope, bending moment and shear at any point of any mode, from the dynamics (EBA)."""

from __future__ import annotations

from typing import Any

import casadi as ca

from tmodes.equations.lagrange.coordinates import deformations
from tmodes.equations.lagrange.energy import bending_levers
from tmodes.equations.lagrange.kinematics import chord_slopes, line_point, line_tangent, mode_tips, projected_lengths
from tmodes.equations.lagrange.layout import LINE
from tmodes.equations.lagrange.symbols import symbolic_robot
from tmodes.paper.mechanism import Mechanism
from tmodes.paper.mode import shape_deflection, shape_slope
from tmodes.paper.sheet import PaperRobot

__all__ = ["line_function"]


def line_function(mode: int, mechanism: Mechanism) -> ca.Function:
    """The vector of :data:`tmodes.equations.lagrange.layout.LINE` of (s, [phi, phi', phi'', tip force], parameters).

    A rigid mode has no curvature, so no flexibility moment. Moments and shear are those of the motion in space, in
    either reading.

    Eq. (1) [corrected]: M + beta y'' = 0 for one beam alone; here M holds every force of the whole mechanism, and
    beta (y + eta y')'' the damping. {test_line_moments_obey_galerkin}
    Eq. (4) [derived]: M_j + eps_j = 0 for every mode j, with the coupling between modes: the moment at the next mode's
    root is part of M. {test_line_moments_obey_galerkin}
    """
    robot, parameters = symbolic_robot()
    s, motion = ca.SX.sym("s"), ca.SX.sym("motion", 21)
    phi, phid, phidd, force = motion[:6], motion[6:12], motion[12:18], motion[18:]
    moment, shear = _section_loads(robot, mode, s, phi, phid, phidd, force)
    shape = _shape(robot, mechanism, mode, s, phi, phid)
    seen = {"line": line_point(mode, phi, robot.link, s), "bending_moment": moment, "shear_force": shear, **shape}
    output = ca.vertcat(*(seen[name] for name in LINE))
    return ca.Function(f"line{mode}", [s, motion, parameters], [ca.densify(output)], {"cse": True})


def places_function() -> ca.Function:
    """Points of both modes' lines (2, 3) [m] of (s, phi, parameters): where they are, whatever moves or loads them."""
    robot, parameters = symbolic_robot()
    s, phi = ca.SX.sym("s"), ca.SX.sym("phi", 6)
    places = ca.vertcat(*(line_point(mode, phi, robot.link, s) for mode in (1, 2)))
    return ca.Function("places", [s, phi, parameters], [ca.densify(places)], {"cse": True})


def _shape(robot: PaperRobot, mechanism: Mechanism, mode: int, s: Any, phi: Any, phid: Any) -> dict[str, Any]:
    """Deflection, slope and flexibility moment of the line, each (horizontal, vertical)."""
    link = robot.link.modes[mode - 1]
    angles, rates = deformations(phi), deformations(phid)
    planes = (mode - 1, mode + 1)
    flat = projected_lengths(phi, robot.link)[mode - 1]
    levers = [bending_levers(robot, mechanism, phi)[k] for k in planes]
    moments = [link.flexibility_moment(angles[k], rates[k], lever, s) for k, lever in zip(planes, levers, strict=True)]
    is_rigid = f"mode{mode}" in mechanism.rigid
    return {
        "deflection": ca.vertcat(flat * angles[planes[0]], link.length * angles[planes[1]]) * shape_deflection(s),
        "slope": ca.vertcat(*(angles[k] for k in planes)) * shape_slope(s),
        "flexibility_moment": ca.SX.zeros(2) if is_rigid else ca.vertcat(*moments),
    }


def _section_loads(
    robot: PaperRobot, mode: int, s: Any, phi: Any, phid: Any, phidd: Any, force: Any
) -> tuple[Any, Any]:
    """Bending moment [N*m] and shear [N] at the section s, each (horizontal, vertical), by d'Alembert.

    All that lies outboard loads the section: weight and inertia of the masses, the rotary inertia of the line's ends,
    and the environment. Positive moments bend towards positive angles; shear = - d moment/d x.

    Eq. (29) [derived]: M(x) of the flexible line of mode 1, horizontal plane.
    {test_root_moment_is_gear_torque, test_line_moments_obey_galerkin}
    Eq. (31) [derived]: M(x) of the flexible line of mode 2, horizontal plane. {test_line_moments_obey_galerkin}
    Eq. (32) [derived]: M(x) of the flexible line of mode 1, vertical plane.
    {test_line_moments_obey_galerkin, test_static_moments_are_levers}
    Eq. (33) [derived]: M(x) of the flexible line of mode 2, vertical plane.
    {test_line_moments_obey_galerkin, test_static_moments_are_levers}
    """
    first, second = robot.link.modes
    masses = (first.tip_mass, robot.payload.mass + second.tip_mass)
    inertias = (first.tip_inertia, robot.payload.inertia + second.tip_inertia)
    slopes = chord_slopes(phidd)
    here, tangent = (f(mode, phi, robot.link, s) for f in (line_point, line_tangent))
    azimuth = phi[0] if mode == 1 else phi[0] + phi[1]
    axes = ca.vertcat(ca.horzcat(0, 0, 1), ca.horzcat(ca.sin(azimuth), -ca.cos(azimuth), 0))
    moment, total = ca.SX.zeros(2), ca.SX.zeros(3)
    for place, point in enumerate(mode_tips(phi, robot.link)):
        if place + 1 < mode:
            continue
        velocity = ca.jtimes(point, phi, phid)
        acceleration = ca.jtimes(velocity, phi, phid) + ca.jtimes(point, phi, phidd)
        load = masses[place] * (ca.vertcat(0, 0, -robot.gravity) - acceleration) - (force if place == 1 else 0)
        total += load
        moment += axes @ ca.cross(point - here, load) - inertias[place] * ca.vertcat(slopes[place], slopes[place + 2])
    return moment, axes @ ca.cross(tangent, total) / robot.link.modes[mode - 1].length
