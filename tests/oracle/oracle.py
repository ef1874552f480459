"""An independent numeric oracle of the seed's robot: forces and accelerations straight from the energies.

No symbolic algebra and no code of the package. First derivatives are complex steps (exact to rounding), the second
derivative of the tip along the motion is a Cauchy integral on a circle in the complex plane (spectrally exact), and H
is the polarisation of the kinetic energy, which is quadratic in the rates.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Literal

import numpy as np

from . import energies
from .energies import Array, Numbers

Reading = Literal["printed", "consistent"]
Friction = Literal["signed", "magnitude"]

STEP = 1e-30  # of the complex step: no subtraction is made, so it may be as small as wished
UNIT = np.eye(6)


def gradient(function: Callable[[Array], Any], at: Array) -> Array:
    """Derivative of ``function`` (scalar or vector) by each of its 6 arguments; last axis is the argument's."""
    columns = [np.imag(function(at + 1j * STEP * unit)) / STEP for unit in UNIT]
    return np.stack(columns, axis=-1)


def second_along(function: Callable[[Array], Array], at: Array, rates: Array, points: int = 32) -> Array:
    """Second derivative of ``function(at + rates t)`` by t at t = 0: twice its Taylor coefficient of t^2."""
    radius = 1.0 / max(1.0, float(np.max(np.abs(rates))))
    circle = np.exp(2j * np.pi * np.arange(points) / points)
    samples = [function(at + rates * radius * w) * w**-2 for w in circle]
    return 2.0 * np.real(np.mean(samples, axis=0)) / radius**2


def mass_matrix(phi: Array, p: Numbers, consistent: bool) -> Array:
    """H [kg m^2], shape (6, 6), by polarisation of the kinetic energy; complex if phi is."""

    def energy(v: Array) -> Any:
        return energies.kinetic(phi, v, p, consistent)

    return np.array([[energy(a + b) - energy(a) - energy(b) for b in UNIT] for a in UNIT])


def bias(phi: Array, v: Array, p: Numbers, consistent: bool) -> Array:
    """h [N m], shape (6,): d/dt(dT/dv) - dT/dphi + dVg/dphi without the accelerations."""
    rate_of_mass = np.imag(mass_matrix(phi + 1j * STEP * v, p, consistent)) / STEP
    kinetic = gradient(lambda x: energies.kinetic(x, v, p, consistent), phi)
    return rate_of_mass @ v - kinetic + gradient(lambda x: energies.gravity(x, p), phi)


def contact_map(phi: Array, p: Numbers, consistent: bool) -> Array:
    """Matrix A, shape (6, 3), with A F the generalised force of the tip force F, as it stands left of Q."""
    jacobian = gradient(lambda x: energies.tip(x, p), phi)
    if consistent:
        return jacobian.T
    planar, (x, y, _) = gradient(lambda x: energies.planar_tip(x, p), phi), energies.tip(phi, p)
    in_plane = np.array([[x, y, 0.0], [0.0, 0.0, np.hypot(x, y)]]) / np.hypot(x, y)
    matrix = np.zeros((6, 3))
    matrix[:2, :2] = jacobian[:2, :2].T
    matrix[3:5] = planar[:, 3:5].T @ in_plane
    return matrix


def _contact(phi: Array, v: Array, p: Numbers, friction_sign: float) -> tuple[Array, float, Array]:
    """Row a and number b of the radial force Fc = a phidd + b [N], and the direction d of F = Fc d, shape (3,)."""
    point = energies.tip(phi, p)
    jacobian = gradient(lambda x: energies.tip(x, p), phi)
    kappa = float(np.linalg.norm(point))
    normal, velocity = point / kappa, jacobian @ v
    rate = float(normal @ velocity)
    drift = normal @ second_along(lambda x: energies.tip(x, p), phi, v) + (velocity @ velocity - rate**2) / kappa
    static = p["be"] * rate + p["Fc0"] + p["ka1"] * (kappa - p["l1"] - p["l2"])
    sliding = velocity / np.sqrt(velocity @ velocity + p["veps"] ** 2)
    return p["me"] * normal @ jacobian, float(p["me"] * drift + static), normal + friction_sign * p["mu"] * sliding


def _accelerate(h: Array, right: Array, left: Array, touch: tuple[Array, float, Array]) -> tuple[Array, Array]:
    """Accelerations [rad/s^2] and tip force on the environment [N] of (H + A d a) phidd = right - A d b."""
    row, constant, direction = touch
    push = left @ direction
    phidd = np.linalg.solve(h + np.outer(push, row), right - push * constant)
    return phidd, direction * (row @ phidd + constant)


def _touching(
    h: Array, right: Array, phi: Array, v: Array, p: Numbers, reading: Reading, friction: Friction
) -> tuple[Array, Array]:
    """Accelerations and tip force in contact; ``magnitude`` takes the one sign of Fc that agrees with itself."""
    left = contact_map(phi, p, reading == "consistent")
    if friction == "signed":
        return _accelerate(h, right, left, _contact(phi, v, p, 1.0))
    for sign in (1.0, -1.0):
        touch = _contact(phi, v, p, sign)
        phidd, force = _accelerate(h, right, left, touch)
        if sign * (touch[0] @ phidd + touch[1]) >= 0.0:
            return phidd, force
    raise ArithmeticError("no sign of Fc agrees with itself: friction is so large that the state jams")


def oracle(
    phi: Array,
    phid: Array,
    u: float,
    parameters: Numbers,
    reading: Reading,
    contact: bool,
    friction: Friction = "signed",
) -> dict[str, Any]:
    """Everything about one state; the names, units and conventions of the reference states.

    Takes coordinates [rad] and rates [rad/s], shape (6,), voltage u [V] and flat SI parameters (``with_equivalents``
    gives the derived ones). Returns H [kg m^2] without the environment's mass, h, f_el, f_di, Q [N m], tip [m],
    J (3, 6), energies [J], rayleigh [W], phidd [rad/s^2] and, in contact, F_tip_on_environment [N].
    """
    phi, v, p, full = np.asarray(phi, float), np.asarray(phid, float), parameters, reading == "consistent"
    result: dict[str, Any] = {
        "H": mass_matrix(phi, p, full),
        "h": bias(phi, v, p, full),
        "f_el": gradient(lambda x: energies.elastic(x, p, full), phi),
        "f_di": gradient(lambda x: energies.rayleigh(phi, x, p, full), v),
        "Q": UNIT[5] * (p["CM"] * (u - p["CE"] * v[5]) / p["R"] - p["Bm"] * v[5]),
        "tip": energies.tip(phi, p),
        "J": gradient(lambda x: energies.tip(x, p), phi),
        "kinetic": energies.kinetic(phi, v, p, full),
        "potential_gravity": energies.gravity(phi, p),
        "potential_elastic": energies.elastic(phi, p, full),
        "rayleigh": energies.rayleigh(phi, v, p, full),
    }
    result["energy"] = result["kinetic"] + result["potential_gravity"] + result["potential_elastic"]
    right = result["Q"] - result["h"] - result["f_el"] - result["f_di"]
    if contact:
        touching = _touching(result["H"], right, phi, v, p, reading, friction)
        result["phidd"], result["F_tip_on_environment"] = touching
    else:
        result["phidd"] = np.linalg.solve(result["H"], right)
    return result
