"""Parameters of the oracle: the equivalent masses and stiffnesses from the links' data, and random robots."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

LINK_DATA = ("l1", "l2", "EI1", "EI2", "w1", "w2", "eta1", "eta2")


def with_equivalents(data: Mapping[str, float]) -> dict[str, float]:
    """``data`` with mel [kg], Jel [kg m^2], Cs [N/m], Bs [N s/m] of both modes, from l, EI, w, eta, Eq. (13)."""
    p = dict(data)
    for j in "12":
        length = p[f"l{j}"]
        p[f"mel{j}"] = 33.0 / 140.0 * p[f"w{j}"] * length
        p[f"Jel{j}"] = p[f"mel{j}"] * (length / 2.0) ** 2
        p[f"Cs{j}"] = 3.0 * p[f"EI{j}"] / length**3
        p[f"Bs{j}"] = p[f"eta{j}"] * p[f"Cs{j}"]
    return p


def random_parameters(rng: np.random.Generator) -> dict[str, float]:
    """A robot with every number drawn again; the preload takes either sign, so Fc does too. SI units."""

    def draw(low: float, high: float) -> float:
        return float(rng.uniform(low, high))

    links = {"l1": draw(0.2, 1.2), "l2": draw(0.1, 0.8), "EI1": draw(50.0, 2000.0), "EI2": draw(5.0, 500.0)}
    links |= {"w1": draw(0.2, 4.0), "w2": draw(0.1, 2.0), "eta1": draw(1e-5, 1e-3), "eta2": draw(1e-5, 1e-3)}
    payload = {"m": draw(0.05, 2.0), "Jzz": draw(1e-5, 1e-2), "g": draw(1.0, 12.0)}
    gear = {"Cxi": draw(100.0, 9000.0), "Bxi": draw(0.05, 5.0)}
    motor = {
        "R": draw(0.1, 2.0),
        "CE": draw(0.5, 5.0),
        "CM": draw(0.5, 5.0),
        "I": draw(0.02, 1.0),
        "Bm": draw(0.0, 2.0),
    }
    force = {"me": draw(0.0, 0.5), "be": draw(0.0, 60.0), "Fc0": draw(-20.0, 20.0), "ka1": draw(0.0, 3000.0)}
    friction = {"mu": draw(0.0, 0.6), "veps": 10.0 ** draw(-4.0, -1.0)}
    return with_equivalents({**links, **payload, **gear, **motor, **force, **friction})


def random_state(rng: np.random.Generator) -> tuple[np.ndarray, np.ndarray, float]:
    """Coordinates phi [rad] and rates [rad/s], shape (6,) each, and voltage u [V]: deflections up to about 0.2 rad."""
    theta, rates = rng.uniform(-np.pi, np.pi), rng.uniform(-3.0, 3.0, 6)
    gamma = theta + rng.uniform(-0.1, 0.1)
    q = gamma + rng.uniform(-0.2, 0.2)
    delta, vt, e = rng.uniform(-0.6, 0.6, 3)
    return np.array([q, delta, gamma, vt, e, theta]), rates, float(rng.uniform(-24.0, 24.0))
