"""The tip on the environment's sphere: a force that holds an acceleration, and the map that carries it to the rows."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import casadi as ca

from tmodes.equations.lagrange.kinematics import projected_lengths, tip, tip_jacobian
from tmodes.paper.environment import FrictionLaw
from tmodes.paper.mechanism import Mechanism, Reading
from tmodes.paper.sheet import PaperRobot

__all__ = ["ContactTerms", "contact_terms", "friction_sign"]


@dataclass(frozen=True)
class ContactTerms:
    """Fc = me (row . phi'') + at_rest, acting along ``direction`` (of the sign that friction takes).

    ``row`` (6,) [m]; ``at_rest`` [N]: Fc but for the accelerations; ``normal`` (3,); ``slip`` (3,): friction over
    normal force; ``to_rows`` (6, 3): the print's J^T that carries the force to the rows of (40).
    """

    mass: Any
    row: Any
    at_rest: Any
    normal: Any
    slip: Any
    to_rows: Any

    def direction(self, sign: Any) -> Any:
        """Force per radial force, shape (3,): n + sign mu v/sqrt(v.v + veps^2)."""
        return self.normal + sign * self.slip


def contact_terms(robot: PaperRobot, mechanism: Mechanism, phi: Any, phid: Any) -> ContactTerms:
    """The contact at a state, linear in the accelerations: Fc adds to H and is never differentiated numerically.

    Slip (34)-(38): a force at the tip reaches each row by its own column of Je, where the print writes the planes'
    rows {test_every_row_needs_its_column_of_the_jacobian}
    """
    position, jacobian = tip(phi, robot.link), tip_jacobian(phi, robot.link)
    velocity = jacobian @ phid
    drift = ca.jtimes(velocity, phi, phid)  # J' phi'
    distance = ca.norm_2(position)
    normal = position / distance
    rate = ca.dot(normal, velocity)
    curving = ca.dot(normal, drift) + (ca.sumsqr(velocity) - rate**2) / distance
    reach = sum(mode.length for mode in robot.link.modes)
    environment = robot.environment
    return ContactTerms(
        mass=environment.mass,
        row=jacobian.T @ normal,
        at_rest=environment.radial_force(distance - reach, rate, curving),
        normal=normal,
        slip=environment.slip_ratio(ca.sumsqr(velocity), ca.sqrt) * velocity,
        to_rows=_planar_map(robot, phi) if mechanism.reading is Reading.PRINTED else jacobian.T,
    )


def friction_sign(radial: Any, law: FrictionLaw | None) -> Any:
    """Sign with which the radial force enters friction: its own makes mu |Fc| of mu Fc."""
    return ca.if_else(radial >= 0, 1, -1) if law is FrictionLaw.MAGNITUDE else 1


def _planar_map(robot: PaperRobot, phi: Any) -> Any:
    """The paper's block Jacobian, transposed, shape (6, 3): it counts F_x in both planes and takes or brings power.

    Eq. (40) [stated]: Je = [Jh 0; 0 Jv], each of its own plane; the vertical plane takes the component along the
    tip's horizontal radius. {test_slip_planar_map_is_not_power}
    Slip (40): F_x is counted in both planes {test_slip_planar_map_is_not_power}
    """
    position = tip(phi, robot.link)
    lm, le = projected_lengths(phi, robot.link)
    first, second = (mode.length for mode in robot.link.modes)
    horizontal = _planar_jacobian(lm, le, phi[0], phi[1])
    vertical = _planar_jacobian(first, second, phi[3], phi[4])
    radius = ca.norm_2(position[:2])
    to_radial = ca.vertcat(
        ca.horzcat(position[0] / radius, position[1] / radius, 0),
        ca.DM([[0, 0, 1]]),
    )
    empty = ca.SX.zeros(1, 3)
    return ca.vertcat(ca.horzcat(horizontal.T, ca.SX.zeros(2, 1)), empty, vertical.T @ to_radial, empty)


def _planar_jacobian(a: Any, b: Any, angle: Any, bend: Any) -> Any:
    """Jacobian of a planar two-bar chain of lengths a, b by its two angles, shape (2, 2)."""
    outer = angle + bend
    far = ca.vertcat(-b * ca.sin(outer), b * ca.cos(outer))
    return ca.horzcat(ca.vertcat(-a * ca.sin(angle), a * ca.cos(angle)) + far, far)
