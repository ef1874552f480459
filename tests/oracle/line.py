"""The elastic line of the 2010 robot by d'Alembert, as plain numpy: places, shapes, moments and shear of both modes."""

from __future__ import annotations

from typing import Any

import numpy as np

from .energies import Array, Numbers
from .oracle import STEP, gradient, second_along


def angles(phi: Array) -> tuple[Any, Any, Any, Any]:
    """Bending angles th11q, th12d, th11m, th12e [rad] of the coordinates; the same map takes rates to rates."""
    q, delta, gamma, vt, e, _ = phi
    return q - gamma, delta - (q - gamma) / 2, vt, e - vt / 2


def slopes(phi: Array) -> Array:
    """Azimuth and elevation of the line's tangent at the ends of both modes [rad], (2 ends, 2)."""
    th11q, th12d, th11m, th12e = angles(phi)
    first = np.array([phi[0] + th11q / 2, phi[3] + th11m / 2])
    return np.array([first, first + 1.5 * np.array([th12d, th12e])])


def point(mode: int, s: Any, phi: Array, p: Numbers) -> Array:
    """Place at s, 0 root to 1 end, of a mode (0 or 1) [m], (3,)."""
    th, turn = angles(phi), s * (3 - s) / 2
    root = (phi[2], 0.0) if mode == 0 else slopes(phi)[0]
    azimuth, elevation = root[0] + turn * th[mode], root[1] + turn * th[mode + 2]
    reach = p[f"l{mode + 1}"] * s
    arm = reach * np.array(
        [np.cos(elevation) * np.cos(azimuth), np.cos(elevation) * np.sin(azimuth), np.sin(elevation)]
    )
    return arm if mode == 0 else point(0, 1.0, phi, p) + arm


def line(phi: Array, phid: Array, phidd: Array, force: Array, p: Numbers, places: Array) -> dict[str, Array]:
    """Of each mode at ``places`` (S,): line (2, S, 3) [m]; deflection, slope, bending_moment, shear_force and
    flexibility_moment (2, S, 2), horizontal and vertical. ``force`` (3,) [N] is that of the tip on the environment.

    All that moves outboard loads a section: weight and inertia of the masses, their rotary inertia, the environment.
    """
    masses = p["mel1"], p["m"] + p["mel2"]
    inertias = p["Jel1"], p["Jzz"] + p["Jel2"]
    turning, weight = slopes(phidd), np.array([0.0, 0.0, -p["g"]])
    ends, loads = [], []
    for k in (0, 1):
        along = gradient(lambda x, k=k: point(k, 1.0, x, p), phi)
        gained = along @ phidd + second_along(lambda x, k=k: point(k, 1.0, x, p), phi, phid)
        ends.append(point(k, 1.0, phi, p))
        loads.append(masses[k] * (weight - gained) - (force if k == 1 else 0.0))
    flat = p["l1"] * np.cos(phi[3]), p["l2"] * np.cos(phi[3] + phi[4])
    found: dict[str, list[Any]] = {}
    for mode in (0, 1):
        length, azimuth = p[f"l{mode + 1}"], phi[: mode + 1].sum()
        axes = np.array([[0, 0, 1], [np.sin(azimuth), -np.cos(azimuth), 0]])
        bend, rate = (np.array(angles(x))[[mode, mode + 2]] for x in (phi, phid))
        levers = np.array([flat[mode], length])
        spring = (p[f"Cs{mode + 1}"] * bend + p[f"Bs{mode + 1}"] * rate) * levers**2
        for s in places:
            here, tangent = point(mode, s, phi, p), np.imag(point(mode, s + 1j * STEP, phi, p)) / STEP
            moment = sum(axes @ np.cross(ends[k] - here, loads[k]) - inertias[k] * turning[k] for k in range(mode, 2))
            row = {
                "line": here,
                "deflection": levers * bend * s**2 * (3 - s) / 2,
                "slope": bend * 3 * s * (2 - s) / 2,
                "bending_moment": moment,
                "shear_force": axes @ np.cross(tangent, sum(loads[mode:])) / length,
                "flexibility_moment": spring * (1 - s),
            }
            for name, value in row.items():
                found.setdefault(name, []).append(value)
    return {name: np.reshape(values, (2, len(places), -1)) for name, values in found.items()}
