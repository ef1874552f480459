"""Small vibrations about rest: frequencies, damping, and the element in which each mode lives."""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.spectrum import GROWING, RINGS, MotorState, Spectrum, damped_motions
from tmodes.equations.lagrange.coordinates import basis, deformations, free_columns
from tmodes.equations.lagrange.layout import COORDINATES
from tmodes.paper.mechanism import Drive, Mechanism, Parameters
from tmodes.paper.model import PaperModel
from tmodes.paper.sheet import PaperRobot

__all__ = [
    "ELEMENTS",
    "GROWING",
    "MotorState",
    "Spectrum",
    "VibrationMode",
    "all_modes",
    "closed_loop_spectrum",
    "damped_motions",
    "shaped_modes",
    "vibration_modes",
]

ELEMENTS = {
    "th11q": "mode 1, horizontal",
    "th12d": "mode 2, horizontal",
    "th11m": "mode 1, vertical",
    "th12e": "mode 2, vertical",
    "xi": "gear",
}
"""Where a deformation sits, in words."""

Matrices = tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]


@dataclass(frozen=True)
class VibrationMode:
    """One mode of vibration.

    ``frequency_Hz``: natural, from mass and stiffness alone; ``damped_frequency_Hz``: as it rings, None when it does
    not (over-damped); ``damping_ratio``: -Re/|lambda|, 1 when over-damped; ``element``: where most of its elastic
    energy is, and the ``share`` of it; ``stable`` is False where it grows: then the ratio is negative, and a frequency
    of zero means that the arm buckles.
    """

    frequency_Hz: float
    damped_frequency_Hz: float | None
    damping_ratio: float
    element: str
    share: float
    stable: bool = True


def all_modes(
    robot: PaperRobot, *, contact: bool = False, theta: float | None = None
) -> dict[str, list[dict[str, Any]]]:
    """Modes for each state of the motor, about the robot's sagged rest, as plain data."""
    return {
        state.value: [asdict(mode) for mode in vibration_modes(robot, state, contact=contact, theta=theta)]
        for state in MotorState
    }


def vibration_modes(
    robot: PaperRobot, state: MotorState, *, contact: bool = False, theta: float | None = None
) -> list[VibrationMode]:
    """Modes by rising frequency; ``theta`` [rad] is the motor's angle, the start of the reference if not given."""
    return [mode for mode, _ in shaped_modes(robot, state, contact=contact, theta=theta)[1]]


def shaped_modes(
    robot: PaperRobot, state: MotorState, *, contact: bool = False, theta: float | None = None
) -> tuple[NDArray[np.float64], list[tuple[VibrationMode, NDArray[np.complex128]]]]:
    """The rest phi (6,) [rad], and about it the modes of :func:`vibration_modes`, each with its motion (6,).

    The motion is complex, as the damped arm moves: where its parts do not swing in phase, the angles tell it.
    """
    mechanism, parameters = robot.split(Drive.VOLTAGE, contact=contact)
    phi = PaperModel(mechanism).rest(robot.reference.start if theta is None else theta, parameters)[:6]
    mass, damping, stiffness = _matrices(robot, mechanism, parameters, phi, state)
    if not len(mass):
        return phi, []
    eigen = np.linalg.eig(np.linalg.solve(mass, stiffness))
    squares, undamped_shapes = np.real(eigen.eigenvalues), eigen.eigenvectors
    order = np.argsort(squares)
    undamped = np.sqrt(np.maximum(squares[order], 0)) / (2 * np.pi)
    eigenvalues, shapes = damped_motions(mass, damping, stiffness)
    columns = free_columns(mechanism.rigid, state is MotorState.LOCKED)
    shapes_now = undamped_shapes[:, order]
    match = _partners(shapes_now, shapes, eigenvalues)
    turning = _rigid_turn(columns, shapes_now) if state is MotorState.FREE else None
    modes = [
        VibrationMode(0.0, 0.0, 0.0, "whole arm, turning freely", 1.0)
        if k == turning
        else _mode(robot, undamped[k], eigenvalues[match[k]], columns @ shapes_now[:, k])
        for k in range(len(undamped))
    ]
    return phi, [(mode, columns @ shapes[:, match[k]]) for k, mode in enumerate(modes)]


def _rigid_turn(columns: NDArray[np.float64], shapes: NDArray[Any]) -> int:
    """Index of the mode in which a free motor carries the undeformed arm: gravity and contact do not mind it."""
    turn = basis()[:, 0]
    moved = columns @ shapes
    return int(np.argmax(np.abs(turn @ moved) / np.linalg.norm(moved, axis=0)))


def _partners(undamped: NDArray[Any], damped: NDArray[np.complex128], eigenvalues: NDArray[np.complex128]) -> list[int]:
    """For each undamped shape the eigenvalue of the most similar damped shape, each taken once, ringing ones first.

    Of the pair of real eigenvalues of a mode that does not ring, the one that decays more slowly, or grows.
    """
    norms = np.outer(np.linalg.norm(undamped, axis=0), np.linalg.norm(damped, axis=0))
    alike = np.abs(undamped.conj().T @ damped) / norms
    rings = eigenvalues.imag > RINGS * np.abs(eigenvalues)
    still = np.abs(eigenvalues.imag) <= RINGS * np.abs(eigenvalues)
    partners = [-1] * undamped.shape[1]

    def open_modes() -> list[int]:
        return [i for i, partner in enumerate(partners) if partner < 0]

    ringing = {int(k) for k in np.flatnonzero(rings)}
    while ringing and open_modes():
        _, i, k = max((alike[i, k], i, k) for i in open_modes() for k in ringing)
        partners[i] = k
        ringing.remove(k)
    slowest_first = sorted((int(k) for k in np.flatnonzero(still)), key=lambda k: -eigenvalues[k].real)
    for k in slowest_first[: len(open_modes())]:
        partners[max(open_modes(), key=lambda i: alike[i, k])] = k
    return partners


def closed_loop_spectrum(robot: PaperRobot, *, drive: Drive) -> Spectrum:
    """Eigenvalues about rest at the start, the motor controlled or following its reference exactly (``drive``)."""
    mechanism, parameters = robot.split(drive)
    phi = PaperModel(mechanism).rest(robot.reference.start, parameters)[:6]
    state = MotorState.LOCKED if drive is Drive.PRESCRIBED else MotorState.CONTROLLED
    matrices = _matrices(robot, mechanism, parameters, phi, state)
    if not len(matrices[0]):
        return Spectrum(np.zeros(0, dtype=complex), ())
    eigenvalues, shapes = damped_motions(*matrices)
    moved = np.abs(free_columns(mechanism.rigid, state is MotorState.LOCKED) @ shapes)
    return Spectrum(eigenvalues, tuple(COORDINATES[k] for k in moved.argmax(axis=0)))


def _matrices(
    robot: PaperRobot, mechanism: Mechanism, parameters: Parameters, phi: NDArray[np.float64], state: MotorState
) -> Matrices:
    """M, D, K in the free directions; the controller's gains act on the motor as a spring and a damper."""
    model = PaperModel(mechanism)
    model.check_mass_matrix(phi, parameters)
    mass, damping, stiffness = model.linearised(phi, parameters)
    motor = robot.motor
    if state is MotorState.CONTROLLED:
        gain = motor.torque_constant / motor.resistance
        stiffness[5, 5] += gain * robot.controller.position_gain
        damping[5, 5] += gain * (robot.controller.velocity_gain + motor.back_emf_constant)
    directions = free_columns(mechanism.rigid, state is MotorState.LOCKED)
    mass, damping, stiffness = (directions.T @ matrix @ directions for matrix in (mass, damping, stiffness))
    return mass, damping, stiffness


def _mode(robot: PaperRobot, undamped: float, eigenvalue: complex, shape: NDArray[Any]) -> VibrationMode:
    element, share = _home(robot, shape)
    size = abs(eigenvalue)
    rings = eigenvalue.imag > RINGS * size
    ratio = float(-eigenvalue.real / size) if size else 0.0
    damped = float(eigenvalue.imag) / (2 * np.pi) if rings else None
    return VibrationMode(float(undamped), damped, ratio, element, share, bool(eigenvalue.real <= GROWING * size))


def _home(robot: PaperRobot, shape: NDArray[Any]) -> tuple[str, float]:
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
