"""Usual ranges of numbers, and units that people write by mistake."""

from __future__ import annotations

import math
from collections.abc import Sequence

__all__ = ["DENSITY_OVER_MODULUS", "FIRST_FREQUENCY", "oddity"]

SLIPS = {
    "m": {1e-3: "mm", 1e-2: "cm"},
    "kg": {1e-3: "g", 1e3: "t"},
    "kg/m": {1e-3: "g/m", 1e3: "kg/mm"},
    "kg*m^2": {1e-7: "g*cm^2", 1e-6: "kg*mm^2", 1e-4: "kg*cm^2"},
    "N*m^2": {1e-6: "N*mm^2", 1e9: "GPa for Pa in E", 1e6: "MPa for Pa in E"},
    "N*m/rad": {180 / math.pi: "N*m/deg", 1e-3: "N*mm/rad"},
    "rad": {math.pi / 180: "deg"},
    "s": {1e-3: "ms"},
    "m/s": {1e-3: "mm/s"},
    "m/s^2": {1e-2: "cm/s^2"},
    "Pa": {1e9: "GPa", 1e6: "MPa"},
    "kg/m^3": {1e3: "g/cm^3"},
    "ohm": {1e-3: "mohm"},
}
"""Factor from a unit that people write by mistake to the unit of the sheet."""

FIRST_FREQUENCY = (0.05, 5e3)
"""Range of the bending frequency of a mode that carries everything beyond it [Hz]."""

DENSITY_OVER_MODULUS = (3e-8, 3.0)
"""Range of rho^2/E of a round rod [kg^2/(N*m^4)]: steel 3e-4, nylon 5e-4, rubber 0.3; as if round: carbon tube 1e-6."""


def oddity(value: float, unit: str, plausible: Sequence[float] | None) -> str | None:
    """What is odd about a number outside the plausible range of its field, with the likely factor; None inside.

    A negative damping is given in words of its own: it is allowed, as in a model of chatter or flutter.
    """
    low, high = plausible or (-math.inf, math.inf)
    if low <= value <= high or math.isinf(value):
        return None
    if value < 0.0 == low:
        return f"= {value:g} {unit} is negative: it feeds energy into the motion; was a damping meant?"
    slips = SLIPS.get(unit, {})
    likely = next((f"{name} (factor {k:.4g})" for k, name in slips.items() if low <= k * value <= high), None)
    guess = f"; was it meant in {likely}?" if likely else "; is the unit right?"
    return f"= {value:g} {unit} is outside the usual {low:g} to {high:g}{guess}"
