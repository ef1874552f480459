"""Small vibrations about rest: frequencies, damping, and the element in which each mode lives."""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass
from enum import StrEnum
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.equations.coordinates import deformations, free_columns
from tmodes.equations.layout import COORDINATES
from tmodes.mechanism import Drive, Mechanism, Parameters
from tmodes.model import Model
from tmodes.robot import Robot

__all__ = ["ELEMENTS", "MotorState", "VibrationMode", "all_modes", "closed_loop_spectrum", "vibration_modes"]

ELEMENTS = {
    "th11q": "mode 1, horizontal",
    "th12d": "mode 2, horizontal",
    "th11m": "mode 1, vertical",
    "th12e": "mode 2, vertical",
    "xi": "gear",
}
"""Where a deformation sits, in words."""

Matrices = tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]


class MotorState(StrEnum):
    """What the motor does while the arm rings: it stands still, turns without current, or is controlled."""

    LOCKED = "locked"
    FREE = "free"
    CONTROLLED = "controlled"


@dataclass(frozen=True)
class VibrationMode:
    """One mode of vibration.

    ``frequency_Hz``: natural, from mass and stiffness alone; ``damped_frequency_Hz``: as it rings, None when it does
    not (over-damped); ``damping_ratio``: -Re/|lambda|, 1 when over-damped; ``element``: where most of its elastic
    energy is, and the ``share`` of it.
    """

    frequency_Hz: float
    damped_frequency_Hz: float | None
    damping_ratio: float
    element: str
    share: float


def all_modes(robot: Robot, *, contact: bool = False, theta: float | None = None) -> dict[str, list[dict[str, Any]]]:
    """Modes for each state of the motor, about the robot's sagged rest, as plain data."""
    return {
        state.value: [asdict(mode) for mode in vibration_modes(robot, state, contact=contact, theta=theta)]
        for state in MotorState
    }


def vibration_modes(
    robot: Robot, state: MotorState, *, contact: bool = False, theta: float | None = None
) -> list[VibrationMode]:
    """Modes by rising frequency; ``theta`` [rad] is the motor's angle, the start of the reference if not given."""
    mechanism, parameters = robot.split(Drive.VOLTAGE, contact=contact)
    phi = Model(mechanism).rest(robot.reference.start if theta is None else theta, parameters)[:6]
    mass, damping, stiffness = _matrices(robot, mechanism, parameters, phi, state)
    if not len(mass):
        return []
    eigen = np.linalg.eig(np.linalg.solve(mass, stiffness))
    squares, undamped_shapes = np.real(eigen.eigenvalues), eigen.eigenvectors
    order = np.argsort(squares)
    undamped = np.sqrt(np.maximum(squares[order], 0)) / (2 * np.pi)
    eigenvalues, shapes = _eigen(mass, damping, stiffness)
    columns = free_columns(mechanism.rigid, state is MotorState.LOCKED)
    match = _partners(undamped_shapes[:, order], shapes, eigenvalues)
    return [
        _mode(robot, frequency, None if partner is None else eigenvalues[partner], columns @ shape)
        for frequency, partner, shape in zip(undamped, match, undamped_shapes[:, order].T, strict=True)
    ]


def _partners(
    undamped: NDArray[Any], damped: NDArray[np.complex128], eigenvalues: NDArray[np.complex128]
) -> list[int | None]:
    """For each undamped shape the ringing eigenvalue of the most similar damped shape, each taken once; or None."""
    ringing = [int(k) for k in np.flatnonzero(eigenvalues.imag > 1e-9 * np.abs(eigenvalues))]
    norms = np.outer(np.linalg.norm(undamped, axis=0), np.linalg.norm(damped, axis=0))
    alike = np.abs(undamped.conj().T @ damped) / norms
    partners: list[int | None] = [None] * undamped.shape[1]
    while ringing and None in partners:
        pairs = [(alike[i, k], i, k) for i, partner in enumerate(partners) if partner is None for k in ringing]
        _, i, k = max(pairs)
        partners[i] = k
        ringing.remove(k)
    return partners


def closed_loop_spectrum(robot: Robot, *, drive: Drive) -> tuple[NDArray[np.complex128], str]:
    """Eigenvalues [1/s] about rest at the start, and the coordinate in which the largest lives.

    ``drive``: the motor controlled, or following its reference exactly.
    """
    mechanism, parameters = robot.split(drive)
    phi = Model(mechanism).rest(robot.reference.start, parameters)[:6]
    state = MotorState.LOCKED if drive is Drive.PRESCRIBED else MotorState.CONTROLLED
    matrices = _matrices(robot, mechanism, parameters, phi, state)
    if not len(matrices[0]):
        return np.zeros(0, dtype=complex), COORDINATES[-1]
    eigenvalues, shapes = _eigen(*matrices)
    shape = free_columns(mechanism.rigid, state is MotorState.LOCKED) @ shapes[:, np.argmax(np.abs(eigenvalues))]
    return eigenvalues, COORDINATES[int(np.argmax(np.abs(shape)))]


def _matrices(
    robot: Robot, mechanism: Mechanism, parameters: Parameters, phi: NDArray[np.float64], state: MotorState
) -> Matrices:
    """M, D, K in the free directions; the controller's gains act on the motor as a spring and a damper."""
    mass, damping, stiffness = Model(mechanism).linearised(phi, parameters)
    motor = robot.motor
    if state is MotorState.CONTROLLED:
        gain = motor.torque_constant / motor.resistance
        stiffness[5, 5] += gain * robot.controller.position_gain
        damping[5, 5] += gain * (robot.controller.velocity_gain + motor.back_emf_constant)
    directions = free_columns(mechanism.rigid, state is MotorState.LOCKED)
    mass, damping, stiffness = (directions.T @ matrix @ directions for matrix in (mass, damping, stiffness))
    return mass, damping, stiffness


def _eigen(
    mass: NDArray[np.float64], damping: NDArray[np.float64], stiffness: NDArray[np.float64]
) -> tuple[NDArray[np.complex128], NDArray[np.complex128]]:
    """Eigenvalues [1/s] and the coordinates' part of the eigenvectors of the first-order system."""
    size = len(mass)
    dynamics = np.block(
        [
            [np.zeros((size, size)), np.eye(size)],
            [-np.linalg.solve(mass, stiffness), -np.linalg.solve(mass, damping)],
        ]
    )
    eigenvalues, vectors = np.linalg.eig(dynamics)
    return eigenvalues, vectors[:size]


def _mode(robot: Robot, undamped: float, eigenvalue: complex | None, shape: NDArray[Any]) -> VibrationMode:
    """One mode; below a thousandth of a hertz it is the rigid turn of a motor that runs free."""
    if undamped < 1e-3:
        return VibrationMode(0.0, 0.0, 0.0, "whole arm, turning freely", 1.0)
    element, share = _home(robot, shape)
    if eigenvalue is None:
        return VibrationMode(float(undamped), None, 1.0, element, share)
    damped, ratio = float(eigenvalue.imag) / (2 * np.pi), float(-eigenvalue.real / abs(eigenvalue))
    return VibrationMode(float(undamped), damped, ratio, element, share)


def _home(robot: Robot, shape: NDArray[Any]) -> tuple[str, float]:
    """The element that stores most of the mode's elastic energy, and its share."""
    first, second = (mode.tip_stiffness * mode.length**2 for mode in robot.link.modes)
    stiffness = {"th11q": first, "th12d": second, "th11m": first, "th12e": second, "xi": robot.gear.stiffness}
    angles = deformations(shape)._asdict()
    stored = {name: k * abs(angles[name]) ** 2 for name, k in stiffness.items() if math.isfinite(k)}
    total = sum(stored.values())
    if total == 0:
        return "controller, whole arm", 1.0
    name = max(stored, key=lambda key: stored[key])
    return ELEMENTS[name], float(stored[name] / total)
