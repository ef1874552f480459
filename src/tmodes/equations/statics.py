"""Quasi-static deflection: what the current forces would hold if the elastic motion stood still."""

from __future__ import annotations

import casadi as ca

from tmodes.equations.contact import contact_terms
from tmodes.equations.coordinates import basis, deformation_basis
from tmodes.equations.energy import energies
from tmodes.equations.lagrange import equation_terms
from tmodes.equations.symbols import symbolic_robot
from tmodes.mechanism import Mechanism

__all__ = ["quasistatic_function"]


def quasistatic_function(mechanism: Mechanism) -> ca.Function:
    """Residual (5,) [N*m] and its Jacobian (5, 5), column by column, of (deformations, gross, parameters).

    ``gross`` = [theta, theta', theta'', tip force (3)]: the arm moves as the motor does, without elastic rates and
    accelerations, under gravity, inertia and the given contact force. Its root is T_st, the stationary part of
    Bernoulli's solution y = X (T_st + T_to); at rest it is the gravity sag (section 2 of the paper).
    """
    robot, _, parameters = symbolic_robot()
    angles, gross = ca.SX.sym("angles", 5), ca.SX.sym("gross", 6)
    theta, rate, acceleration, force = gross[0], gross[1], gross[2], gross[3:]
    phi, phid = ca.SX.sym("phi", 6), ca.SX.sym("phid", 6)
    terms = equation_terms(energies(robot, mechanism, phi, phid), phi, phid)
    stiff_motion = ca.DM(basis()[:, 0])
    rows = terms.mass_matrix @ (stiff_motion * acceleration) + terms.internal
    if mechanism.contact:
        rows += contact_terms(robot, mechanism, phi, phid).to_rows @ force
    shapes = ca.DM(deformation_basis())
    residual = ca.substitute(
        [shapes.T @ rows], [phi, phid], [stiff_motion * theta + shapes @ angles, stiff_motion * rate]
    )[0]
    output = ca.vertcat(residual, ca.vec(ca.jacobian(residual, angles)))
    return ca.Function("quasistatic", [angles, gross, parameters], [ca.densify(output)], {"cse": True})
