"""One step of the whole robot as one function: reference, controller, motor, gear, link, contact, and the work done."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import casadi as ca

from tmodes.equations.lagrange.dynamics import Motion, motion
from tmodes.equations.lagrange.energy import Energies
from tmodes.equations.lagrange.kinematics import tip, tip_jacobian
from tmodes.equations.lagrange.layout import ENERGIES, OBSERVED, STATE_SIZE, WORKS
from tmodes.equations.lagrange.symbols import symbolic_robot
from tmodes.paper.mechanism import Drive, Mechanism
from tmodes.paper.sheet import PaperRobot

__all__ = ["ClosedLoop", "closed_loop", "observe_function", "polynomial", "powers", "rate_function"]


@dataclass(frozen=True)
class ClosedLoop:
    """Symbols of one instant and what follows from them."""

    robot: PaperRobot
    mechanism: Mechanism
    time: Any
    state: Any
    row: Any
    parameters: Any
    wanted: Any
    voltage: Any
    motion: Motion

    @property
    def phi(self) -> Any:
        """Coordinates, shape (6,)."""
        return self.state[:6]

    @property
    def phid(self) -> Any:
        """Rates, shape (6,)."""
        return self.state[6:12]


def closed_loop(mechanism: Mechanism) -> ClosedLoop:
    """The robot under its drive.

    ``row`` holds the start of the current piece of the schedule and the coefficients of its polynomial: the motor's
    wanted angle [rad] (controlled, prescribed), or its voltage [V].
    """
    robot, parameters = symbolic_robot()
    time, state = ca.SX.sym("time"), ca.SX.sym("state", STATE_SIZE)
    row = ca.SX.sym("row", mechanism.reference_degree + 2)
    phi, phid = state[:6], state[6:12]
    wanted, rate, acceleration = polynomial(row, time)
    if mechanism.drive is Drive.PRESCRIBED:
        moved = motion(robot, mechanism, phi, phid, acceleration)
        current = moved.motor_torque / robot.motor.torque_constant
        voltage = robot.motor.resistance * current + robot.motor.back_emf_constant * phid[5]
    else:
        controlled = mechanism.drive is Drive.CONTROLLED
        voltage = robot.controller.command(wanted, rate, phi[5], phid[5]) if controlled else wanted
        moved = motion(robot, mechanism, phi, phid, voltage)
    return ClosedLoop(robot, mechanism, time, state, row, parameters, wanted, voltage, moved)


def polynomial(row: Any, time: Any) -> tuple[Any, Any, Any]:
    """Value and two derivatives of the piece's polynomial in the time since its start."""
    tau = ca.SX.sym("tau")
    value: Any = 0
    for k in reversed(range(1, row.shape[0])):
        value = value * tau + row[k]
    first = ca.jacobian(value, tau)
    three = ca.vertcat(value, first, ca.jacobian(first, tau))
    three = ca.substitute(three, tau, time - row[0])
    return three[0], three[1], three[2]


def rate_function(loop: ClosedLoop) -> ca.Function:
    """Derivative of the state by time, of (time, state, row, parameters)."""
    moved = loop.motion
    brought = powers(loop.robot, moved.energy, loop.phid, moved.motor_torque, moved.contact_rows)
    rates = ca.vertcat(loop.phid, moved.acceleration, *(brought[name] for name in WORKS))
    return _function("rate", loop, rates)


def observe_function(loop: ClosedLoop, names: Sequence[str] = (*OBSERVED,)) -> ca.Function:
    """:data:`tmodes.equations.lagrange.layout.OBSERVED` (or part of it) of (time, state, row, parameters)."""
    robot, moved, phi, phid = loop.robot, loop.motion, loop.phi, loop.phid
    energy = moved.energy
    seen = {
        "acceleration": moved.acceleration,
        "wanted": loop.wanted,
        "voltage": loop.voltage,
        "current": robot.motor.current(loop.voltage, phid[5]),
        "tip": tip(phi, robot.link),
        "tip_velocity": tip_jacobian(phi, robot.link) @ phid,
        "contact_force": moved.tip_force,
        "radial_force": moved.radial_force,
        "contact_fold": moved.contact_fold,
        "gear_torque": moved.gear_torque(robot, loop.mechanism, phi, phid),
        "energy": ca.vertcat(*(getattr(energy, kind) for kind in ENERGIES)),
    }
    return _function("observe", loop, ca.vertcat(*(seen[name] for name in names)))


def powers(robot: PaperRobot, energy: Energies, phid: Any, motor_torque: Any, contact_rows: Any) -> dict[str, Any]:
    """Power brought in by the motor and taken out by each loss [W], by the names of ``WORKS``."""
    return {
        "motor": motor_torque * phid[5],
        "motor_friction": robot.motor.friction_loss(phid[5]),
        "gear_damping": 2 * energy.rayleigh_gear,
        "link_damping": 2 * energy.rayleigh_link,
        "contact": ca.dot(contact_rows, phid),
    }


def _function(name: str, loop: ClosedLoop, output: Any) -> ca.Function:
    inputs = [loop.time, loop.state, loop.row, loop.parameters]
    return ca.Function(name, inputs, [ca.densify(output)], {"cse": True})
