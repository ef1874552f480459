"""The equations, linear about a state of rest: M x'' + D x' + K x = 0."""

from __future__ import annotations

import casadi as ca

from tmodes.equations.lagrange.contact import contact_terms, friction_sign
from tmodes.equations.lagrange.energy import energies
from tmodes.equations.lagrange.lagrange import equation_terms
from tmodes.equations.lagrange.symbols import symbolic_robot
from tmodes.paper.mechanism import Mechanism

__all__ = ["linear_function"]


def linear_function(mechanism: Mechanism) -> ca.Function:
    """M, D, K, each (6, 6) row by row, of (phi, parameters), at rest and without current in the motor."""
    robot, parameters = symbolic_robot()
    phi, phid, phidd = (ca.SX.sym(name, 6) for name in ("phi", "phid", "phidd"))
    terms = equation_terms(energies(robot, mechanism, phi, phid), phi, phid)
    rows = terms.mass_matrix @ phidd + terms.internal
    rows[5] += robot.motor.friction * phid[5]
    if mechanism.contact:
        contact = contact_terms(robot, mechanism, phi, phid)
        radial = contact.mass * ca.dot(contact.row, phidd) + contact.at_rest
        # Of |Fc| only its sign at rest matters to a small motion.
        sign = friction_sign(contact.at_rest, mechanism.contact)
        rows += contact.to_rows @ (contact.direction(sign) * radial)
    matrices = [ca.jacobian(rows, variable) for variable in (phidd, phid, phi)]
    rest = ca.SX.zeros(6)
    matrices = ca.substitute(matrices, [phid, phidd], [rest, rest])
    output = ca.vertcat(*(ca.vec(matrix.T) for matrix in matrices))
    return ca.Function("linear", [phi, parameters], [ca.densify(output)], {"cse": True})
