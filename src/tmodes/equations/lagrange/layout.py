"""Names and lengths of the vectors that pass between equations, native code and results."""

from __future__ import annotations

__all__ = ["COORDINATES", "DEFORMATIONS", "ENERGIES", "EVALUATED", "LINE", "OBSERVED", "STATE_SIZE", "WORKS"]

COORDINATES = ("q", "delta", "gamma", "vt", "e", "theta")
"""Names of the generalized coordinates, in the paper's order."""

DEFORMATIONS = ("th11q", "th12d", "th11m", "th12e", "xi")
"""Names of the elastic angles: bending of modes 1, 2 horizontally, then vertically, and the gear."""

WORKS = ("motor", "motor_friction", "gear_damping", "link_damping", "contact")
"""Names of the works done since the start: the motor's comes in, the others go out."""

ENERGIES = ("kinetic", "gravity", "elastic_gear", "elastic_link")
"""Kinds of energy that are observed, by their names in :class:`tmodes.equations.lagrange.energy.Energies`."""

STATE_SIZE = 12 + len(WORKS)
"""A state: coordinates, rates, and the works done since the start."""

OBSERVED = {
    "acceleration": 6, "wanted": 1, "voltage": 1, "current": 1, "tip": 3, "tip_velocity": 3, "contact_force": 3,
    "radial_force": 1, "contact_fold": 1, "gear_torque": 1, "energy": len(ENERGIES),
}  # fmt: skip
"""What is observed at a sample, with its length, in order."""

LINE = {"line": 3, "deflection": 2, "slope": 2, "bending_moment": 2, "flexibility_moment": 2, "shear_force": 2}
"""What is known of a point of the elastic line, with its length; pairs are (horizontal, vertical)."""

EVALUATED = {
    "phidd": (6,), "H": (6, 6), "h": (6,), "f_el": (6,), "f_di": (6,), "Q": (6,), "tip": (3,), "J": (3, 6),
    "kinetic": (), "potential_gravity": (), "potential_elastic": (), "rayleigh": (), "energy": (),
    "F_tip_on_environment": (3,),
}  # fmt: skip
"""Terms of the equations at a state, with their shapes."""
