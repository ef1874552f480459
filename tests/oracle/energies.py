"""The energies of the seed's robot, both readings, as plain numpy functions; nothing here is differentiated.

Coordinates phi = [q, delta, gamma, vt, e, theta] [rad], v = their rates [rad/s]; SI units. Everything is analytic in
phi and v, so every function also takes complex arrays (the oracle differentiates along the imaginary axis).

Legend: lm, le horizontal lengths of the two chords; th* bending angles; xi gear deflection; Cs, Cxi stiffnesses,
Bs, Bxi dampings; mel, Jel equivalent masses and inertias. Equation numbers are those of Filipovic & Djuric (2010).
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[Any]
Numbers = Mapping[str, float]


def tip(phi: Array, p: Numbers) -> Array:
    """Tip position x, y, z [m], shape (3,), Eq. (42)."""
    q, delta, _, vt, e, _ = phi
    lm, le = p["l1"] * np.cos(vt), p["l2"] * np.cos(vt + e)
    x = lm * np.cos(q) + le * np.cos(q + delta)
    y = lm * np.sin(q) + le * np.sin(q + delta)
    return np.array([x, y, p["l1"] * np.sin(vt) + p["l2"] * np.sin(vt + e)])


def planar_tip(phi: Array, p: Numbers) -> Array:
    """Tip in the vertical plane of the printed reading, x_v and z [m], shape (2,)."""
    _, _, _, vt, e, _ = phi
    x_v = p["l1"] * np.cos(vt) + p["l2"] * np.cos(vt + e)
    return np.array([x_v, p["l1"] * np.sin(vt) + p["l2"] * np.sin(vt + e)])


def _speeds_squared(phi: Array, v: Array, p: Numbers, consistent: bool) -> tuple[Any, Any]:
    """Squared speeds of the two point masses [m^2/s^2].

    The printed reading adds a horizontal motion with lm, le held and a vertical one in the plane x_v, z.
    """
    q, delta, _, vt, e, _ = phi
    qt, dt, _, vtt, et, _ = v
    lm, le = p["l1"] * np.cos(vt), p["l2"] * np.cos(vt + e)
    lmt, let = -p["l1"] * np.sin(vt) * vtt, -p["l2"] * np.sin(vt + e) * (vtt + et)
    z1t, z2t = lm * vtt, lm * vtt + le * (vtt + et)
    lmh, leh = (lmt, let) if consistent else (0.0, 0.0)
    x1t = lmh * np.cos(q) - lm * np.sin(q) * qt
    y1t = lmh * np.sin(q) + lm * np.cos(q) * qt
    x2t = x1t + leh * np.cos(q + delta) - le * np.sin(q + delta) * (qt + dt)
    y2t = y1t + leh * np.sin(q + delta) + le * np.cos(q + delta) * (qt + dt)
    first, second = x1t**2 + y1t**2 + z1t**2, x2t**2 + y2t**2 + z2t**2
    return (first, second) if consistent else (first + lmt**2, second + (lmt + let) ** 2)


def kinetic(phi: Array, v: Array, p: Numbers, consistent: bool) -> Any:
    """Kinetic energy [J], Eq. (14), with the rotary terms and the motor."""
    qt, dt, gt, vtt, et, tht = v
    first, second = _speeds_squared(phi, v, p, consistent)
    masses = p["mel1"] * first + (p["m"] + p["mel2"]) * second
    rotary1 = p["Jel1"] * ((1.5 * qt - 0.5 * gt) ** 2 + (1.5 * vtt) ** 2)
    rotary2 = (p["Jzz"] + p["Jel2"]) * ((0.75 * qt + 1.5 * dt + 0.25 * gt) ** 2 + (0.75 * vtt + 1.5 * et) ** 2)
    return 0.5 * (masses + rotary1 + rotary2 + p["I"] * tht**2)


def gravity(phi: Array, p: Numbers) -> Any:
    """Potential energy of gravity [J], zero at z = 0, Eq. (15)."""
    _, _, _, vt, e, _ = phi
    z1 = p["l1"] * np.sin(vt)
    return p["g"] * (p["mel1"] * z1 + (p["m"] + p["mel2"]) * (z1 + p["l2"] * np.sin(vt + e)))


def _form(angles: Array, phi: Array, p: Numbers, consistent: bool, letter: str) -> Any:
    """Half the squares of the deflections, weighted by C or B: Eqs. (16)-(19), (24) and (20)-(23), (25)."""
    q, delta, gamma, vt, e, theta = angles
    th11q, th11m, xi = q - gamma, vt, gamma - theta
    th12d, th12e = delta - 0.5 * th11q, e - 0.5 * th11m
    l1, l2 = p["l1"], p["l2"]
    lm, le = (l1 * np.cos(phi[3]), l2 * np.cos(phi[3] + phi[4])) if consistent else (l1, l2)
    mode1 = p[f"{letter}s1"] * ((l1 * th11m) ** 2 + (lm * th11q) ** 2)
    mode2 = p[f"{letter}s2"] * ((l2 * th12e) ** 2 + (le * th12d) ** 2)
    return 0.5 * (mode1 + mode2 + p[f"{letter}xi"] * xi**2)


def elastic(phi: Array, p: Numbers, consistent: bool) -> Any:
    """Elastic energy of both modes and the gear [J]."""
    return _form(phi, phi, p, consistent, "C")


def rayleigh(phi: Array, v: Array, p: Numbers, consistent: bool) -> Any:
    """Rayleigh function [W]: rates of the angles, lm and le as they stand; the motor's friction is not in it."""
    return _form(v, phi, p, consistent, "B")
