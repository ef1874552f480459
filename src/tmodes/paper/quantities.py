"""What stop conditions may name of the 2010 robot: the numbers that a result holds, by name and with their units."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from tmodes.equations.lagrange.coordinates import deformations
from tmodes.equations.lagrange.layout import COORDINATES, DEFORMATIONS, ENERGIES
from tmodes.paper.mechanism import Drive, Parameters
from tmodes.paper.model import PaperModel
from tmodes.paper.sheet import PaperRobot
from tmodes.simulation.stops import Instants, Quantity, Stops, resolved

__all__ = ["robot_quantities", "robot_stops"]

_AXES = ("x", "y", "z")


def robot_stops(robot: PaperRobot, more: Sequence[str] = (), drive: Drive = Drive.CONTROLLED) -> Stops:
    """The stop conditions of a robot's sheet, and ``more`` of them; nothing is compiled for it.

    Raises :class:`tmodes.errors.InputError` as :func:`tmodes.simulation.stops.resolved`.
    """
    mechanism, parameters = robot.split(drive)
    known = robot_quantities(PaperModel(mechanism), parameters)
    return Stops((*resolved(robot.integration.stop, known), *resolved(more, known, "stop")))


def robot_quantities(model: PaperModel, parameters: Parameters) -> dict[str, Quantity]:
    """The quantities by name: coordinates, elastic angles, tip, gear, motor, contact and energies."""

    def state(column: int) -> Quantity:
        unit = "rad" if column < len(COORDINATES) else "rad/s"
        return Quantity(unit, lambda at: at.states[:, column])

    def seen(name: str, unit: str, column: int | None = None) -> Quantity:
        def of(at: Instants) -> NDArray[np.float64]:
            info = model.observe(at.times, at.states, at.rows, parameters)[name]
            return info if column is None else info[:, column]

        return Quantity(unit, of)

    def angle(column: int) -> Quantity:
        return Quantity("rad", lambda at: deformations(at.states[:, :6].T)[column])

    def speed(at: Instants) -> NDArray[np.float64]:
        info = model.observe(at.times, at.states, at.rows, parameters)["tip_velocity"]
        return np.linalg.norm(info, axis=1)

    def energy(at: Instants) -> NDArray[np.float64]:
        return model.observe(at.times, at.states, at.rows, parameters)["energy"].sum(axis=1)

    found = {f"{name}.position": state(k) for k, name in enumerate(COORDINATES)}
    found |= {f"{name}.velocity": state(k + len(COORDINATES)) for k, name in enumerate(COORDINATES)}
    found |= {f"deformation.{name}": angle(k) for k, name in enumerate(DEFORMATIONS)}
    found |= {f"tip.{axis}": seen("tip", "m", k) for k, axis in enumerate(_AXES)}
    found |= {f"tip.velocity.{axis}": seen("tip_velocity", "m/s", k) for k, axis in enumerate(_AXES)}
    found |= {"tip.speed": Quantity("m/s", speed), "gear.torque": seen("gear_torque", "N*m")}
    found |= {"motor.voltage": seen("voltage", "V"), "motor.current": seen("current", "A")}
    found |= {f"energy.{name}": seen("energy", "J", k) for k, name in enumerate(ENERGIES)}
    found["energy.total"] = Quantity("J", energy)
    if model.mechanism.contact:
        found["contact.force"] = seen("radial_force", "N")
    return found
