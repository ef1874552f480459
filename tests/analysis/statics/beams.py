"""Clamped beams as chains, and the loads of exact cases as those of the package."""

from __future__ import annotations

from typing import Any

import numpy as np

from analysis.statics.exact import Load as ExactLoad
from tmodes.analysis.statics.equilibrium import Load
from tmodes.chain.chain import Chain, Joint, Node
from tmodes.kinds.joints.registry import joint_kind
from tmodes.kinds.links.strain import Beam, BeamPiece
from tmodes.model.model import Model

__all__ = ["clamped", "loads_of"]


def clamped(
    stiffness: tuple[float, float, float] = (1.0, 1.0, 1.0),
    *,
    length: float = 1.0,
    mass: float = 1.0,
    axial: float = 0.0,
    gravity: tuple[float, float, float] = (0.0, 0.0, 0.0),
    **beam: Any,
) -> Model:
    """A beam clamped at the origin along x; ``stiffness`` GJ, EI_y, EI_z [N*m^2]; its points: the tip."""
    torsion, bend_y, bend_z = ((value, value) for value in stiffness)
    polar = (1e-4 * mass * length**2, 1e-4 * mass * length**2)
    piece = BeamPiece(1.0, bend_y, bend_z, torsion, (axial, axial), (mass, mass), (polar, (0.0, 0.0), (0.0, 0.0)))
    link = Beam(length, (piece,), **beam)
    return Model(Chain("clamped", (Node("beam", -1, Joint("clamp", joint_kind("fixed")), link),), np.array(gravity)))


def loads_of(load: ExactLoad) -> list[Load]:
    """Tip loads of an exact case; its weight is the model's gravity."""
    return [Load("tip", load.force, load.moment), Load("tip", load.follower, follows=True)]
