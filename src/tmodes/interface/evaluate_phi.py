"""All terms of the 2010 robot's equations at given states, in the coordinates and with the names of its paper."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmodes.errors import SimulationError
from tmodes.io.filipovic2010.importer import COORDINATES, to_robot
from tmodes.model.model import Model
from tmodes.simulation.loop import LoopModel
from tmodes.simulation.plan import planned

if TYPE_CHECKING:
    from tmodes.sheet import Robot

__all__ = ["COORDINATES", "check_finite", "evaluate_phi"]

NEAREST = 1e-9
"""Distance of the tip from the base point [m] below which its direction is rounding."""

Array = NDArray[np.float64]


class _States(NamedTuple):
    """States in the robot's coordinates, and the motor's voltage [V]."""

    q: Array
    v: Array
    voltage: Array


def evaluate_phi(robot: Robot, records: Sequence[dict[str, Any]]) -> list[dict[str, Any]]:
    """Each record (phi (6,), phid (6,), u [V]) with the terms of H phidd + h + f_el + f_di + J^T F = Q.

    The tip force is left out in free space. Raises :class:`tmodes.errors.SimulationError` that names the state where
    a term is not finite, or where the tip is at the base point and the contact force has no direction.
    """
    model = Model(robot.model_copy(update={"drives": ()}).chain())
    back = to_robot(model.coordinates)
    phi, phid, voltage = (np.array([record[key] for record in records], dtype=float) for key in ("phi", "phid", "u"))
    states = _States(phi @ back.T, phid @ back.T, voltage)
    terms = _terms(robot, model, back, states)
    if robot.contact:
        _check_distance(terms["tip"])
    check_finite(terms, "keep phi and phid within what a robot can do")
    return [
        {
            **{key: record[key] for key in ("phi", "phid", "u")},
            "reading": "printed" if robot.equations == "printed" else "consistent",
            **{name: np.asarray(values)[index].tolist() for name, values in terms.items()},
        }
        for index, record in enumerate(records)
    ]


def _terms(robot: Robot, model: Model, back: Array, states: _States) -> dict[str, Array]:
    q, v = states.q, states.v
    motor, speed = robot.joints[0].motor, v[:, model.coordinates.index("joint.motor")]
    if motor is None or motor.resistance is None:
        raise SimulationError("the states hold a motor voltage u, and the robot has no electric motor")
    numbers = motor.at_joint()
    current = (states.voltage - numbers.back_emf * speed) / (numbers.resistance or 1.0)
    row = back[model.coordinates.index("joint.motor")]
    springs, losses = model.elastic_forces(q, 0 * v) @ back, model.losses(q, v)
    dampers = model.elastic_forces(q, v) @ back - springs - np.outer(numbers.viscous * speed, row)
    energies = model.energies(q, v)
    elastic = energies["elastic_gear"] + energies["elastic_link"]
    moved = _moved(robot, states)
    terms = {
        "phidd": moved["a"] @ np.linalg.pinv(back).T,
        "H": back.T @ model.mass_matrix(q) @ back,
        "h": model.bias(q, v) @ back,
        "f_el": springs,
        "f_di": dampers,
        "Q": np.outer(numbers.torque_constant * current - numbers.viscous * speed, row),
        "tip": model.points(q, v).position[:, 0],
        "J": model.jacobian(q)[:, 0, :3] @ back,
        "kinetic": energies["kinetic"],
        "potential_gravity": energies["gravity"],
        "potential_elastic": elastic,
        "rayleigh": (losses["gear_damping"] + losses["link_damping"]) / 2,
        "energy": energies["kinetic"] + energies["gravity"] + elastic,
    }
    return terms | ({"F_tip_on_environment": moved["contact"][:, :3]} if robot.contact else {})


def _moved(robot: Robot, states: _States) -> dict[str, Array]:
    """Accelerations and contact force of the robot at these states with these voltages."""
    drive = {"joint": "joint", "command": "voltage", "signal": {"type": "constant", "value": 0.0}}
    loop = LoopModel(planned(robot.with_({"drives": [drive], "real": {}})).plan)
    rows = np.column_stack([np.zeros(len(states.q)), states.voltage])
    whole = np.zeros((len(states.q), loop.layout.size))
    whole[:, loop.layout.q], whole[:, loop.layout.v] = states.q, states.v
    return loop.observe(np.zeros(len(states.q)), whole, rows)


def _check_distance(tip: Array) -> None:
    distance = np.linalg.norm(tip, axis=1)
    index = int(np.argmin(distance))
    if distance[index] <= NEAREST:
        raise SimulationError(
            f"states[{index}]: the tip is {distance[index]:.1g} m from the base point, where the contact force has no "
            "direction; change phi, or leave --contact out"
        )


def check_finite(terms: Mapping[str, Any], hint: str) -> None:
    """Raise :class:`tmodes.errors.SimulationError` naming the first state where one of the ``terms`` is not finite."""
    for name, values in terms.items():
        finite = np.isfinite(values).reshape(len(values), -1).all(axis=1)
        if not finite.all():
            at = f"states[{int(np.argmin(finite))}]"
            raise SimulationError(f"{at}: {name} is not finite there; the equations must hold at the state: {hint}")
