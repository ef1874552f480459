"""Static deflection: at rest, and what the current forces would hold if the elastic motion stood still."""

from __future__ import annotations

from typing import Any

import casadi as ca

from tmodes.equations.lagrange.contact import contact_terms
from tmodes.equations.lagrange.coordinates import basis, deformation_basis
from tmodes.equations.lagrange.energy import energies
from tmodes.equations.lagrange.lagrange import equation_terms
from tmodes.equations.lagrange.symbols import symbolic_robot
from tmodes.paper.mechanism import Mechanism

__all__ = ["quasistatic_function", "rest_function"]


def quasistatic_function(mechanism: Mechanism) -> ca.Function:
    """Residual (5,) [N*m] and its Jacobian (5, 5), column by column, of (deformations, gross, parameters).

    ``gross`` = [theta, theta', theta'', tip force (3)]: the arm moves as the motor does, without elastic rates and
    accelerations, under gravity, inertia and the given contact force. Its root is T_st, the stationary part of
    Bernoulli's solution y = X (T_st + T_to); at rest it is the gravity sag (section 2 of the paper). The motor's
    acceleration and the contact force are those of the ringing robot, so a few percent of the ringing stay in T_st.
    """
    robot, parameters = symbolic_robot()
    angles, gross = ca.SX.sym("angles", 5), ca.SX.sym("gross", 6)
    theta, rate, acceleration, force = gross[0], gross[1], gross[2], gross[3:]
    phi, phid = ca.SX.sym("phi", 6), ca.SX.sym("phid", 6)
    terms = equation_terms(energies(robot, mechanism, phi, phid), phi, phid)
    rows = terms.mass_matrix @ (_STIFF_MOTION * acceleration) + terms.internal
    if mechanism.contact:
        rows += contact_terms(robot, mechanism, phi, phid).to_rows @ force
    rows = ca.substitute(rows, phid, _STIFF_MOTION * rate)
    output = _residual_and_jacobian(rows, phi, theta, angles)
    return ca.Function("quasistatic", [angles, gross, parameters], [output], {"cse": True})


def rest_function(mechanism: Mechanism) -> ca.Function:
    """The same of (deformations, theta, parameters) at rest, with the force of the environment where it is touched.

    So a run starts at rest: nothing is launched by the preload or by a start off the sphere.
    """
    robot, parameters = symbolic_robot()
    angles, theta = ca.SX.sym("angles", 5), ca.SX.sym("theta")
    phi, phid = ca.SX.sym("phi", 6), ca.SX.sym("phid", 6)
    rows = equation_terms(energies(robot, mechanism, phi, phid), phi, phid).internal
    if mechanism.contact:
        contact = contact_terms(robot, mechanism, phi, phid)
        rows += contact.to_rows @ (contact.normal * contact.at_rest)
    rows = ca.substitute(rows, phid, ca.SX.zeros(6))
    output = _residual_and_jacobian(rows, phi, theta, angles)
    return ca.Function("rest", [angles, theta, parameters], [output], {"cse": True})


_STIFF_MOTION = ca.DM(basis()[:, 0])
"""How the coordinates move with the motor when nothing deforms."""


def _residual_and_jacobian(rows: Any, phi: Any, theta: Any, angles: Any) -> Any:
    """Rows of the equations in the directions of the deformations, and their derivative by the deformations."""
    shapes = ca.DM(deformation_basis())
    residual = ca.substitute(shapes.T @ rows, phi, _STIFF_MOTION * theta + shapes @ angles)
    return ca.densify(ca.vertcat(residual, ca.vec(ca.jacobian(residual, angles))))
