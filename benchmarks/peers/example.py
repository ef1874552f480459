"""The numbers of the example run, for peers that share no code with the package. SI units, radians.

Every value is the real robot's: the gear has 0.2 and the modes 0.99 of the known stiffness and damping.
"""

from __future__ import annotations

import math

DURATION = 2.0  # [s]
STEPS = 37_500
STEP = DURATION / STEPS  # [s]; both ramp ends fall on a step: 7,500 and 30,000
FREQUENCIES = (4.9957, 7.3152, 20.2590, 32.6164, 179.863)  # [Hz], motor locked, about the sagged rest


def _rod(number: str, length: float, diameter: float, elasticity: float, density: float) -> dict[str, float]:
    """Equivalent mass, inertia and tip stiffness of one round rod, Eq. (13); real: 0.99 of the known stiffness."""
    bending = elasticity * math.pi * diameter**4 / 64.0
    mass = 33.0 / 140.0 * density * math.pi * diameter**2 / 4.0 * length
    stiffness = 0.99 * 3.0 * bending / length**3
    values = {"l": length, "mel": mass, "Jel": mass * (length / 2.0) ** 2, "Cs": stiffness, "Bs": 2e-4 * stiffness}
    return {name + number: value for name, value in values.items()}


def parameters() -> dict[str, float]:
    """All parameters of the real robot, by the letters of the paper."""
    link = _rod("1", 0.6, 0.018, 210e9, 7850.0) | _rod("2", 0.3, 0.006, 210e9, 7850.0)
    gear = {"Cxi": 0.2 * 4700.0, "Bxi": 0.2 * 2.0}
    motor = {"R": 0.299, "CE": 3.02, "CM": 3.02, "I": 0.175, "Bm": 0.5, "Klp": 2000.0, "Klv": 20.0}
    environment = {"me": 0.1, "be": 20.0, "Fc0": 5.0, "ka1": 1000.0, "mu": 0.1, "veps": 1e-3}
    return {**link, **gear, **motor, **environment, "m": 0.5, "Jzz": 2.5e-4, "g": 9.81}


def reference() -> tuple[list[float], list[list[float]]]:
    """Knots [s] and rows of the motor's reference, 0 to pi/4 with ramps of 0.4 s.

    A row is ``[t_start, c0, c1, c2]``: theta_o = c0 + c1 tau + c2 tau^2 with tau = t - t_start.
    """
    ramp, end = 0.4, math.pi / 4.0
    speed = end / (DURATION - ramp)
    half, bend = speed * ramp / 2.0, speed / ramp / 2.0
    first, second = ramp, DURATION - ramp
    rows = [[0.0, 0.0, 0.0, bend], [first, half, speed, 0.0], [second, end - half, speed, -bend]]
    return [0.0, first, second, DURATION], rows
