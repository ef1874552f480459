"""The payload: a body at the tip of the last mode."""

from __future__ import annotations

from tmodes.kinds.schema.quantity import DataSheet, not_negative

__all__ = ["Payload"]


class Payload(DataSheet):
    """Mass and rotary inertia at the tip; zero is a bare tip."""

    mass: float = not_negative("kg", "m", "mass at the tip", plausible=(0.0, 1e4))
    inertia: float = not_negative("kg*m^2", "Jzz", "rotary inertia at the tip, both planes", plausible=(0.0, 1e3))
