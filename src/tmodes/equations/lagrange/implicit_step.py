"""Rates for a step of the 2010 robot whose springs, dampers and control are taken at its end.

M a = f(ahead) + s(start) with M = H + h D + h^2 K: s are the forces of gear, link, environment and motor, K and D their
derivatives. ``start``: coordinates and rates from which they move on, by h^2 a and h a, to the step's end; all else is
taken at ``ahead``. With h = 0 and both the same state it is the rate of the closed loop.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import casadi as ca

from tmodes.equations.lagrange.closed_loop import polynomial, powers
from tmodes.equations.lagrange.contact import ContactTerms, contact_terms
from tmodes.equations.lagrange.coordinates import basis, free_columns
from tmodes.equations.lagrange.dynamics import accelerations, torque_of_prescribed_motor
from tmodes.equations.lagrange.energy import energies
from tmodes.equations.lagrange.lagrange import equation_terms
from tmodes.equations.lagrange.layout import STATE_SIZE, WORKS
from tmodes.equations.lagrange.symbols import symbolic_robot
from tmodes.paper.mechanism import Drive, Mechanism
from tmodes.paper.sheet import PaperRobot

__all__ = ["implicit_rate_function"]


@dataclass(frozen=True)
class _Soft:
    """What is taken at the step's end: forces at its start (6,) [N*m], and their derivatives K, D (6, 6)."""

    force: Any
    stiffness: Any
    damping: Any


def implicit_rate_function(mechanism: Mechanism) -> ca.Function:
    """Derivative of the state by time, of (time, ahead, start, row, step, parameters)."""
    robot, parameters = symbolic_robot()
    time, step = ca.SX.sym("time"), ca.SX.sym("step")
    ahead, start = ca.SX.sym("ahead", STATE_SIZE), ca.SX.sym("start", 12)
    row = ca.SX.sym("row", mechanism.reference_degree + 2)
    drive = polynomial(row, time)
    terms = equation_terms(energies(robot, mechanism, ahead[:6], ahead[6:12]), ahead[:6], ahead[6:12])
    soft = _soft(robot, mechanism, start[:6], start[6:12], drive)
    mass = terms.mass_matrix + step * soft.damping + step**2 * soft.stiffness
    prescribed = mechanism.drive is Drive.PRESCRIBED
    known = ca.DM(basis()[:, 0]) * drive[2] if prescribed else ca.SX.zeros(6)
    directions = ca.DM(free_columns(mechanism.rigid, prescribed))
    contact = _contact(robot, mechanism, ahead, start, step) if mechanism.contact else None
    solved = accelerations(mass, soft.force - terms.bias, directions, known, contact, mechanism.contact)
    acceleration, rows = solved[0], solved[3]
    end = start[:6] + step**2 * acceleration, start[6:12] + step * acceleration
    torque = _torque(robot, mechanism, end, drive, mass @ acceleration + terms.bias - soft.force + rows)
    brought = powers(robot, energies(robot, mechanism, *end), end[1], torque, rows)
    rates = ca.vertcat(ahead[6:12], acceleration, *(brought[name] for name in WORKS))
    inputs = [time, ahead, start, row, step, parameters]
    return ca.Function("implicit_rate", inputs, [ca.densify(rates)], {"cse": True})


def _soft(robot: PaperRobot, mechanism: Mechanism, phi: Any, phid: Any, drive: Any) -> _Soft:
    """Gear, link and motor at the start; both matrices are symmetric: second derivatives of energies."""
    energy = energies(robot, mechanism, phi, phid)
    terms = equation_terms(energy, phi, phid)
    stiffness = ca.hessian(ca.SX(energy.elastic_gear + energy.elastic_link), phi)[0]
    damping = ca.hessian(ca.SX(energy.rayleigh_gear + energy.rayleigh_link), phid)[0]
    force = -terms.elastic - terms.damping
    if mechanism.drive is not Drive.PRESCRIBED:
        torque = _motor_torque(robot, mechanism, phi, phid, drive) - robot.motor.friction * phid[5]
        force[5] += torque
        stiffness[5, 5] -= ca.jacobian(torque, phi)[5]
        damping[5, 5] -= ca.jacobian(torque, phid)[5]
    return _Soft(force, stiffness, damping)


def _motor_torque(robot: PaperRobot, mechanism: Mechanism, phi: Any, phid: Any, drive: Any) -> Any:
    wanted, rate, _ = drive
    voltage = wanted
    if mechanism.drive is Drive.CONTROLLED:
        voltage = robot.controller.command(wanted, rate, phi[5], phid[5])
    return robot.motor.torque(voltage, phid[5])


def _torque(robot: PaperRobot, mechanism: Mechanism, end: tuple[Any, Any], drive: Any, rows: Any) -> Any:
    """What the motor brings in at the step's end; prescribed, it is what ``rows`` of the other forces ask of it."""
    if mechanism.drive is Drive.PRESCRIBED:
        return torque_of_prescribed_motor(rows, robot, end[1][5])
    return _motor_torque(robot, mechanism, *end, drive)


def _contact(robot: PaperRobot, mechanism: Mechanism, ahead: Any, start: Any, step: Any) -> ContactTerms:
    """The environment at ``ahead``, its spring and damper at ``start``, and what they add to its mass."""
    here = contact_terms(robot, mechanism, ahead[:6], ahead[6:12])
    begun = contact_terms(robot, mechanism, start[:6], start[6:12])
    motion = ca.SX.sym("motion", 3)
    slopes = ca.jacobian(robot.environment.radial_force(motion[0], motion[1], motion[2]), motion)
    mass = here.mass + step * slopes[1] + step**2 * slopes[0]
    return replace(here, mass=mass, at_rest=begun.at_rest)
