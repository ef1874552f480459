"""A link of any number of modes on one joint about z, by its energies: plain numpy, differentiated by complex steps.

Coordinates: the joint, azimuths, elevations of the modes that bend (``free``, booleans). Arrays of modes from root to
tip: lengths l [m], masses m [kg] and rotary inertias J [kg m^2] at their ends, springs c and dampers b [N m/rad,
N m s/rad] of the chord's angle; ``g`` [m/s^2]. Angles add up: a chord turns by th, the tangent at its end by 3/2 th.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

Array = np.ndarray
Numbers = Mapping[str, Any]
STEP = 1e-30


def _angles(q: Array, free: Array) -> Array:
    """Angles of all modes (2, n), azimuths then elevations; rigid ones are zero."""
    found = np.zeros((2, len(free)), dtype=q.dtype)
    found[:, free] = q[1:].reshape(2, -1)
    return found


def _directions(q: Array, free: Array) -> tuple[Array, Array]:
    """Azimuth and elevation of chords and of tangents at the modes' ends, each (2, n); of rates their rates."""
    th = _angles(q, free)
    start = np.array([[q[0]], [0.0]]) + 1.5 * (np.cumsum(th, axis=1) - th)
    return start + th, start + 1.5 * th


def heights(q: Array, p: Numbers) -> Array:
    """Heights of the ends of the modes [m], (n,)."""
    return np.cumsum(p["l"] * np.sin(_directions(q, p["free"])[0][1]))


def kinetic(q: Array, v: Array, p: Numbers) -> Any:
    """Translation of the masses, rotation of the ends by the rates of azimuth and elevation of the tangents [J]."""
    (a, e), (da, de) = _directions(q, p["free"])[0], _directions(v, p["free"])[0]
    arms = [-np.sin(e) * np.cos(a) * de - np.cos(e) * np.sin(a) * da,
            -np.sin(e) * np.sin(a) * de + np.cos(e) * np.cos(a) * da, np.cos(e) * de]  # fmt: skip
    moved, turned = np.cumsum(p["l"] * np.array(arms), axis=1), _directions(v, p["free"])[1]
    return (p["m"] @ (moved**2).sum(axis=0) + p["J"] @ (turned**2).sum(axis=0)) / 2


def _springs(q: Array, x: Array, constants: Array, p: Numbers) -> Any:
    """1/2 sum c ((cos(elevation of the chord) x_azimuth)^2 + x_elevation^2)."""
    across, up = _angles(x, p["free"])
    level = np.cos(_directions(q, p["free"])[0][1])
    return constants @ ((level * across) ** 2 + up**2) / 2


def _gradient(function: Callable[[Array], Any], at: Array) -> Array:
    return np.array([np.imag(function(at + 1j * STEP * unit)) / STEP for unit in np.eye(len(at))])


def _mass(q: Array, p: Numbers) -> Array:
    units = np.eye(len(q))
    energy = [[kinetic(q, one + other, p) for one in units] for other in units]
    single = np.array([kinetic(q, unit, p) for unit in units])
    return np.array(energy) - single[:, None] - single[None, :]


def rows(q: Array, v: Array, p: Numbers) -> dict[str, Array]:
    """H, h (Coriolis, centrifugal and weight), f_el and f_di of H q'' + h + f_el + f_di = Q."""
    moving = np.imag(_mass(q + 1j * STEP * v, p)) / STEP @ v
    weight = _gradient(lambda x: p["g"] * p["m"] @ heights(x, p), q)
    return {
        "H": _mass(q, p),
        "h": moving - _gradient(lambda x: kinetic(x, v, p), q) + weight,
        "f_el": _gradient(lambda x: _springs(x, x, p["c"], p), q),
        "f_di": _gradient(lambda x: _springs(q, x, p["b"], p), v),
    }
