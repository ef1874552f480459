"""Symbols that are no field of the data sheet: coordinates, elastic angles, and what follows from them."""

from __future__ import annotations

__all__ = ["COORDINATES", "DERIVED", "Row"]

Row = tuple[str, str, str, str]
"""Name in the code, symbol in the paper, unit, meaning."""

COORDINATES: tuple[Row, ...] = (
    ("q", "q", "rad", "azimuth of mode 1's chord; q = gamma + th11q"),
    ("delta", "δ", "rad", "azimuth of mode 2's chord against mode 1's; delta = th11q/2 + th12d"),
    ("gamma", "γ", "rad", "angle of the gear's output, where the link is clamped; gamma = theta + xi"),
    ("vt", "ϑ1,1m", "rad", "elevation of mode 1's chord; it is the bending angle th11m"),
    ("e", "e", "rad", "elevation of mode 2's chord against mode 1's; e = th11m/2 + th12e"),
    ("theta", "θ", "rad", "angle of the motor, after the reducer"),
    ("th11q", "ϑ1,1q", "rad", "bending angle of mode 1, horizontal: chord from root to tip against the root's tangent"),
    ("th12d", "ϑ1,2δ", "rad", "bending angle of mode 2, horizontal"),
    ("th11m", "ϑ1,1m", "rad", "bending angle of mode 1, vertical"),
    ("th12e", "ϑ1,2e", "rad", "bending angle of mode 2, vertical"),
    ("xi", "ξ", "rad", "deflection of the gear"),
)

DERIVED: tuple[Row, ...] = (
    ("phi, phid", "φ, φ'", "rad, rad/s", "the six coordinates [q, delta, gamma, vt, e, theta] and their rates"),
    ("omega", "ω", "rad", "angle of a mode's tip tangent against its chord; half of its bending angle"),
    ("lm, le", "lm, le", "m", "lengths of mode 1 and mode 2 seen from above: l1 cos vt, l2 cos(vt + e)"),
    ("r", "r", "m", "deflection of a mode's tip: its length times its bending angle"),
    ("tip_mass", "mel", "kg", "equivalent mass of a mode at its tip, 33/140 w l"),
    ("tip_inertia", "Jel", "kg*m^2", "equivalent rotary inertia of a mode at its tip, mel (l/2)^2"),
    ("tip_stiffness", "Cs", "N/m", "tip force over tip deflection, 3 EI/l^3"),
    ("tip_damping", "Bs", "N*s/m", "tip force over tip deflection rate, eta Cs"),
    ("mass_matrix", "H", "kg*m^2", "inertia matrix, 6 by 6"),
    ("bias", "h", "N*m", "centrifugal, Coriolis and gravity terms, 6"),
    ("elastic", "C φ", "N*m", "gradient of the elastic energy, 6"),
    ("damping", "B φ'", "N*m", "gradient of the Rayleigh function, 6"),
    ("tip_jacobian", "Je", "m", "derivative of the tip's position by the coordinates, 3 by 6"),
    ("gear_torque", "ς", "N*m", "torque in the gear, Cxi xi + Bxi xi'"),
    (
        "flexibility_moment",
        "ε",
        "N*m",
        "moment by which a mode resists: (Cs th + Bs th') l^2 at its root",
    ),
    ("bending_moment", "M", "N*m", "load moment along a mode, from the dynamics; M + ε = 0"),
    ("distance", "κ", "m", "distance of the tip from the base point"),
    ("radial_force", "Fc", "N", "force of the tip on the environment along the radius"),
    ("voltage, current", "u, i", "V, A", "of the motor"),
    ("shape_deflection", "X", "-", "static shape of a mode: deflection at s = x/l over the tip's"),
    ("stationary", "T_st", "rad", "bending angle that the forces of the instant would hold statically"),
    ("oscillatory", "T_to", "rad", "the rest of the bending angle"),
    ("nominal", "superscript o", "", "with the characteristics as known; the reference is planned with them"),
)
