"""Which gear, link or controller a residual vibration is in: by the motion of the run itself, not by frequencies."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.modes.of_sheet import servos_of
from tmodes.analysis.statics.compliance import Spring, springs_of
from tmodes.analysis.vibration import Mode, Residual, fitted
from tmodes.simulation.motion_run import RunData

__all__ = ["LOADS", "mode_elements"]

Array = NDArray[np.float64]

LOADS = "whole arm, in its weight and loads"
"""Where a vibration is of which no spring has a noticeable part."""

_NOTICEABLE = 1e-3
"""Energy of all springs over the kinetic one, below which none is named."""

_INSTANTS = 200
"""Instants of a vibration at which its energies are taken."""


def mode_elements(run: RunData, times: Array, q: Array, found: Residual) -> list[str]:
    """The element of each mode of a vibration found of a point: where most of its elastic energy is in this run.

    ``times`` (n,) [s] after the start of the vibration, coordinates ``q`` (n, nq) of the same motion.
    """
    if not found.modes:
        return []
    kept = np.unique(np.linspace(0, int((times <= found.span * (1 + 1e-9)).sum()) - 1, 3 * _INSTANTS).astype(int))
    turning = np.array([pole for mode in found.modes for pole in mode.poles])
    poles = np.concatenate([turning, turning.conj(), found.slow])
    parts = fitted(times[kept], q[kept] - q[kept].mean(axis=0), poles)[: len(turning)]
    place, springs = q[kept[-1]], springs_of(run.model, q[kept[-1]])
    springs |= _controllers(run)
    mass, names, first = run.model.mass_matrix(place), [], 0
    for mode in found.modes:
        own = parts[first : first + len(mode.poles)]
        first += len(own)
        names.append(_element(mode, own, springs, mass))
    return names


def _element(mode: Mode, parts: NDArray[np.complex128], springs: dict[str, Spring], mass: Array) -> str:
    """Of the mode's part of the coordinates, over its first turns."""
    instants = np.linspace(0.0, 2.0 / mode.frequency_Hz, _INSTANTS)
    poles: Any = np.array(mode.poles)
    basis = np.exp(np.outer(instants, poles))
    moved, rates = (basis @ parts).real.T, (basis @ (parts * poles[:, None])).real.T
    kinetic = float(np.einsum("in,ij,jn->", rates, mass, rates))
    stored = {name: float(np.sum(np.abs(spring.energy(moved)))) for name, spring in springs.items()}
    home = max(stored, key=lambda name: stored[name], default=LOADS)
    return home if stored and stored[home] > 0 and sum(stored.values()) > _NOTICEABLE * kinetic else LOADS


def _controllers(run: RunData) -> dict[str, Spring]:
    """Controllers as the springs that they are to what they keep."""
    found, model = {}, run.model
    for name, servo in servos_of(run.robot, model).items():
        row = np.zeros((1, model.nq))
        row[0, model.coordinates.index(name)] = 1.0
        found[f"{name.removesuffix('.motor')}.controller"] = Spring(row, max(servo.stiffness, 0.0) * row)
    return found
