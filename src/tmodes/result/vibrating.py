"""Which gear, link or controller a residual vibration is in: by the motion of the run itself, not by frequencies."""

from __future__ import annotations

from collections import ChainMap
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.modes.of_sheet import servos_of
from tmodes.analysis.quasistatic import loose_gears
from tmodes.analysis.statics.compliance import SpringStiffness, springs_of
from tmodes.analysis.vibration import Oscillation, Residual, fitted
from tmodes.simulation.motion_run import RunData

__all__ = ["LOADS", "mode_elements", "named_as_seen", "unrest"]

Array = NDArray[np.float64]

LOADS = "whole arm, in its weight and loads"
"""Where a vibration is of which no spring has a noticeable part."""

_NOTICEABLE = 1e-3
"""Energy of all springs over the kinetic one, below which none is named."""

_SAME = 0.03
"""Distance of two poles over their size up to which they are of one mode."""

_STEADY, _TURNS, _NOTHING = 0.05, 0.5, 1e-8
"""How near to its half a motion is in the middle of its time where its speed is steady; turn [rad] that is seen; travel
[rad, m] that is rounding."""

_INSTANTS = 200
"""Instants of a vibration at which its energies are taken."""


def unrest(run: RunData, times: Array, q: Array) -> tuple[str, bool]:
    """What keeps a motion from its rest, in words, empty where that is a vibration; and whether it is none at all.

    ``times`` (n,) [s], evenly spaced, and coordinates ``q`` (n, nq): in the second half of that time one moves on, or
    the teeth of a gear are apart for most of it.
    """
    late = q[len(q) // 2 - 1 :]
    first, travel = late[(len(late) - 1) // 2] - late[0], late[-1] - late[0]
    swing = np.abs(late - late[0] - np.linspace(0.0, 1.0, len(late))[:, None] * travel).max(axis=0, initial=0.0)
    share = np.divide(first, travel, out=np.zeros_like(travel), where=np.abs(travel) > np.maximum(2 * swing, _NOTHING))
    onward = np.where(np.abs(share - 0.5) < _STEADY, travel, 0.0)
    if onward.any():
        k = int(np.abs(onward).argmax())
        unit = run.chain.units(run.coordinates)[run.coordinates[k]]
        speed = np.abs(onward[k]) / (times[-1] - times[-len(late)])
        turns = unit == "rad" and bool(np.abs(onward[k]) > _TURNS)
        return f"{run.coordinates[k]} moves on at {speed:.3g} {unit}/s", turns
    loose = [loose_gears(run.model, place) for place in late[:: len(late) // _INSTANTS + 1]]
    for name, play in ChainMap(*loose).items():
        moved = float(np.ptp(late[:, run.coordinates.index(name)]))
        if moved > _STEADY * play and sum(name in one for one in loose) > len(loose) / 2:
            return f"{name} rattles in the play of its gear", True
    return "", False


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
    mass, ends = run.model.mass_matrix(place), np.cumsum([len(mode.poles) for mode in found.modes])[:-1]
    own = np.split(parts, ends)
    return [_element(mode, one, springs, mass) for mode, one in zip(found.modes, own, strict=True)]


def named_as_seen(modes: list[dict[str, Any]], seen: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Modes about a pose, with the element that the nearest one seen in a run has, where both poles are the same."""
    names = {}
    for one in (one for one in seen[::-1] if one.get("element") and one["damping_ratio"] ** 2 < 1):
        pole = 2 * np.pi * one["frequency_Hz"] * np.exp(1j * np.arccos(-one["damping_ratio"]))
        far = [abs(complex(*mode["pole"]) - pole) for mode in modes]
        names |= {int(np.argmin(far)): one["element"]} if min(far, default=np.inf) < _SAME * abs(pole) else {}
    return [mode | {"element": names.get(k, mode["element"])} for k, mode in enumerate(modes)]


def _element(mode: Oscillation, parts: NDArray[np.complex128], springs: dict[str, SpringStiffness], mass: Array) -> str:
    """Of the mode's part of the coordinates, over its first turns."""
    instants = np.linspace(0.0, 2.0 / mode.frequency_Hz, _INSTANTS)
    poles: Any = np.array(mode.poles)
    basis = np.exp(np.outer(instants, poles))
    moved, rates = (basis @ parts).real.T, (basis @ (parts * poles[:, None])).real.T
    kinetic = float(np.einsum("in,ij,jn->", rates, mass, rates))
    stored = {name: float(np.sum(np.abs(spring.energy(moved)))) for name, spring in springs.items()}
    home = max(stored, key=lambda name: stored[name], default=LOADS)
    return home if stored and stored[home] > 0 and sum(stored.values()) > _NOTICEABLE * kinetic else LOADS


def _controllers(run: RunData) -> dict[str, SpringStiffness]:
    """Controllers as the springs that they are to what they keep."""
    found, model = {}, run.model
    for name, servo in servos_of(run.robot, model).items():
        row = np.zeros((1, model.nq))
        row[0, model.coordinates.index(name)] = 1.0
        found[f"{name.removesuffix('.motor')}.controller"] = SpringStiffness(row, max(servo.stiffness, 0.0) * row)
    return found
