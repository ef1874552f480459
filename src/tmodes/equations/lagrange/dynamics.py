"""Forward dynamics: Eq. (40) solved for the accelerations, with the environment's mass and rigid elements inside."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import casadi as ca

from tmodes.equations.lagrange.contact import ContactTerms, contact_terms, friction_sign
from tmodes.equations.lagrange.coordinates import basis, deformations, free_columns
from tmodes.equations.lagrange.energy import Energies, energies
from tmodes.equations.lagrange.lagrange import EquationTerms, equation_terms
from tmodes.paper.environment import FrictionLaw
from tmodes.paper.mechanism import Drive, Mechanism
from tmodes.paper.sheet import PaperRobot

__all__ = ["Motion", "accelerations", "motion", "torque_of_prescribed_motor"]


@dataclass(frozen=True)
class Motion:
    """Everything that is known of the robot at one state and one drive.

    ``inputs`` (6,) is Q [N*m]; ``contact_fold`` [-]: 1 + me times the tip's mobility along the push. Where friction and
    the environment's mass are so large that it is not positive, the contact jams: the forces have no or two answers.
    """

    energy: Energies
    terms: EquationTerms
    acceleration: Any
    inputs: Any
    motor_torque: Any
    radial_force: Any
    tip_force: Any
    contact_rows: Any
    contact_fold: Any

    def gear_torque(self, robot: PaperRobot, mechanism: Mechanism, phi: Any, phid: Any) -> Any:
        """Gear torque sigma [N*m]; of a rigid gear it is what the link's side asks of it."""
        if "gear" not in mechanism.rigid:
            return robot.gear.torque(deformations(phi).xi, deformations(phid).xi)
        rows = self.terms.mass_matrix @ self.acceleration + self.terms.internal + self.contact_rows
        return -(rows[0] + rows[2])


def motion(robot: PaperRobot, mechanism: Mechanism, phi: Any, phid: Any, drive: Any) -> Motion:
    """Accelerations and forces.

    ``drive`` is the motor's voltage [V], or its acceleration theta'' [rad/s^2] where the motor is prescribed.

    Eq. (39) [corrected]: CM i = I theta'' + Bm theta' - sigma with u = R i + CE theta' put in; in the print this row
    is in volts where the others are in N*m. {test_motor_row_is_in_newton_metres}
    Eq. (40) [derived]: H phi'' + h + f_elastic + f_damping + J^T F = Q. {test_samples}
    Slip (40): the motor's row is in volts, the others in N*m {test_motor_row_is_in_newton_metres}
    """
    energy = energies(robot, mechanism, phi, phid)
    terms = equation_terms(energy, phi, phid)
    prescribed = mechanism.drive is Drive.PRESCRIBED
    known = ca.DM(basis()[:, 0]) * drive if prescribed else ca.SX.zeros(6)
    torque = 0 if prescribed else robot.motor.torque(drive, phid[5])
    inputs = ca.vertcat(ca.SX.zeros(5), torque - robot.motor.friction * phid[5])
    load = inputs - terms.internal
    directions = ca.DM(free_columns(mechanism.rigid, prescribed))
    contact = contact_terms(robot, mechanism, phi, phid) if mechanism.contact else None
    solved = accelerations(terms.mass_matrix, load, directions, known, contact, mechanism.contact)
    acceleration, radial_force, tip_force, rows, fold = solved
    if prescribed:
        others = terms.mass_matrix @ acceleration + terms.internal + rows
        torque = torque_of_prescribed_motor(others, robot, phid[5])
    return Motion(energy, terms, acceleration, inputs, torque, radial_force, tip_force, rows, fold)


def torque_of_prescribed_motor(rows: Any, robot: PaperRobot, speed: Any) -> Any:
    """Torque of a motor that follows its prescribed motion: ``rows`` of all others that move with it, balanced."""
    return ca.dot(ca.DM(basis()[:, 0]), rows) + robot.motor.friction * speed


def accelerations(
    mass: Any, load: Any, directions: Any, known: Any, contact: ContactTerms | None, law: FrictionLaw | None
) -> tuple[Any, Any, Any, Any, Any]:
    """Solve for phi'' in the free directions; the contact's mass is a rank-one change of H (Sherman-Morrison)."""
    if not directions.shape[1]:
        return _held(known, contact, law)
    reduced = directions.T @ mass @ directions
    right = directions.T @ (load - mass @ known)
    if contact is None:
        acceleration = directions @ _solve_ldl(reduced, right) + known
        return acceleration, ca.SX(0), ca.SX.zeros(3), ca.SX.zeros(6), ca.SX(1)
    row = directions.T @ contact.row
    at_rest = contact.at_rest + contact.mass * ca.dot(contact.row, known)
    # Without the contact's own push, Fc has this sign; the push only scales it, unless the contact jams.
    pull = at_rest + contact.mass * ca.dot(row, _solve_ldl(reduced, right))
    direction = contact.direction(friction_sign(pull, law))
    push = contact.to_rows @ direction
    answer = _solve_ldl(reduced, ca.horzcat(right, directions.T @ push))
    freely, pushed = answer[:, 0], answer[:, 1]
    fold = 1 + contact.mass * ca.dot(row, pushed)
    radial = pull / fold
    acceleration = directions @ (freely - pushed * radial) + known
    return acceleration, radial, radial * direction, push * radial, fold


def _held(known: Any, contact: ContactTerms | None, law: FrictionLaw | None) -> tuple[Any, Any, Any, Any, Any]:
    """The same where no direction is free: a rigid arm whose motor's motion is prescribed."""
    if contact is None:
        return known, ca.SX(0), ca.SX.zeros(3), ca.SX.zeros(6), ca.SX(1)
    radial = contact.at_rest + contact.mass * ca.dot(contact.row, known)
    force = radial * contact.direction(friction_sign(radial, law))
    return known, radial, force, contact.to_rows @ force, ca.SX(1)


def _solve_ldl(matrix: Any, right: Any) -> Any:
    """Solve a symmetric positive definite system by LDL^T, unrolled; zeros of the matrix cost nothing."""
    size = matrix.shape[0]
    lower = [[ca.SX(0)] * size for _ in range(size)]
    diagonal: list[Any] = []
    for j in range(size):
        diagonal.append(matrix[j, j] - sum(lower[j][k] ** 2 * diagonal[k] for k in range(j)))
        for i in range(j + 1, size):
            rest = sum(lower[i][k] * lower[j][k] * diagonal[k] for k in range(j))
            lower[i][j] = (matrix[i, j] - rest) / diagonal[j]
    rows: list[Any] = []
    for i in range(size):
        rows.append(right[i, :] - sum(lower[i][k] * rows[k] for k in range(i)))
    rows = [row / d for row, d in zip(rows, diagonal, strict=True)]
    for i in reversed(range(size)):
        rows[i] = rows[i] - sum(lower[k][i] * rows[k] for k in range(i + 1, size))
    return ca.vertcat(*rows)
