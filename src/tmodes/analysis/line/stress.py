"""Stress at the outer fibre of a beam, from what its sections carry."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.line.tables import pieces_at
from tmodes.chain.chain import Beam

__all__ = ["Stress", "stress_of"]

Array = NDArray[np.float64]

_ROUND = 1e-9
"""Relative difference of GJ/G and (EI_y + EI_z)/E below which a section is a circle or a ring: no other has it."""


@dataclass(frozen=True, eq=False)
class Stress:
    """Largest stresses of each section, (n, S), n samples, S places.

    ``strain`` [-] and ``normal_stress`` [Pa] of the outer fibre where axial force and bending add up; ``shear_stress``
    [Pa] of torsion (shear of the transverse force is small in slender beams and left out); ``mises_stress`` [Pa].
    Exact for round sections and the corners of boxes; for others not less than the true values.
    """

    strain: Array
    normal_stress: Array
    shear_stress: Array
    mises_stress: Array


def stress_of(beam: Beam, s: Array, moment: Array, axial: Array) -> Stress | None:
    """Stresses at the places ``s`` (S,) from moments (n, S, 3) [N*m] and axial forces (n, S) [N]; None if unknown.

    sigma = |N| E/EA + |M| E r/EI; tau = G r M_x/GJ of a circle, else with r of a bound: Saint-Venant's shear is at
    most that of a strip of the section's thickness, and that of its corner's distance.
    """
    if not (beam.young > 0 and min(beam.outer) > 0):
        return None
    torsion, bend_y, bend_z, area = (pieces_at(beam, name, s) for name in ("torsion", "bend_y", "bend_z", "axial"))
    outer_y, outer_z = beam.outer
    about_y, about_z = (np.abs(moment[..., k]) * r * _compliance(stiffness) for k, r, stiffness in (
        (1, outer_z, bend_y), (2, outer_y, bend_z)))  # fmt: skip
    ring = outer_y == outer_z and beam.shear > 0 and np.allclose(
        torsion / beam.shear, (bend_y + bend_z) / beam.young, rtol=_ROUND, atol=0)  # fmt: skip
    bending = np.hypot(about_y, about_z) if ring else about_y + about_z
    strain = bending + np.abs(axial) * _compliance(area)
    lever = outer_y if ring else min(2 * min(beam.outer), float(np.hypot(*beam.outer)))
    shear = beam.shear * lever * np.abs(moment[..., 0]) * _compliance(torsion)
    normal = beam.young * strain
    return Stress(strain, normal, shear, np.sqrt(normal**2 + 3 * shear**2))


def _compliance(stiffness: Array) -> Array:
    """1 over a stiffness; 0 where there is none told, or it is infinite."""
    info = (stiffness > 0) & np.isfinite(stiffness)
    return np.divide(1.0, stiffness, out=np.zeros_like(stiffness), where=info)
