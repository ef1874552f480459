"""All terms of the equations at a given state and voltage: the door for a comparison with another program."""

from __future__ import annotations

import casadi as ca

from tmodes.equations.lagrange.dynamics import motion
from tmodes.equations.lagrange.kinematics import tip, tip_jacobian
from tmodes.equations.lagrange.layout import EVALUATED
from tmodes.equations.lagrange.symbols import symbolic_robot
from tmodes.paper.mechanism import Mechanism

__all__ = ["evaluation_function"]


def evaluation_function(mechanism: Mechanism) -> ca.Function:
    """The vector of :data:`tmodes.equations.lagrange.layout.EVALUATED` of (phi, phid, u, parameters)."""
    robot, parameters = symbolic_robot()
    phi, phid, voltage = ca.SX.sym("phi", 6), ca.SX.sym("phid", 6), ca.SX.sym("u")
    moved = motion(robot, mechanism, phi, phid, voltage)
    energy, terms = moved.energy, moved.terms
    elastic = energy.elastic_gear + energy.elastic_link
    seen = {
        "phidd": moved.acceleration,
        "H": ca.vec(terms.mass_matrix.T),
        "h": terms.bias,
        "f_el": terms.elastic,
        "f_di": terms.damping,
        "Q": moved.inputs,
        "tip": tip(phi, robot.link),
        "J": ca.vec(tip_jacobian(phi, robot.link).T),
        "kinetic": energy.kinetic,
        "potential_gravity": energy.gravity,
        "potential_elastic": elastic,
        "rayleigh": energy.rayleigh_gear + energy.rayleigh_link,
        "energy": energy.kinetic + energy.gravity + elastic,
        "F_tip_on_environment": moved.tip_force,
    }
    output = ca.vertcat(*(ca.SX(seen[name]) for name in EVALUATED))
    return ca.Function("evaluation", [phi, phid, voltage, parameters], [ca.densify(output)], {"cse": True})
