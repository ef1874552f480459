"""One clamped beam as a chain, and its model: what closed forms are about."""

from __future__ import annotations

from typing import Any

import numpy as np

from tmodes.chain.chain import Chain, Joint, Node, Point
from tmodes.frame import Placement
from tmodes.kinds.drives.registry import drive_kind
from tmodes.kinds.joints.registry import joint_kind
from tmodes.kinds.links.strain import Beam, BeamPiece
from tmodes.model.model import Model

__all__ = ["EI", "LENGTH", "MASS", "beam", "clamped", "piece", "turning"]

LENGTH, EI, MASS = 0.8, 30.0, 0.7
DOWN = np.array([0.0, 0.0, -9.81])


def piece(end: float = 1.0, bending: float = EI, mass: float = MASS, taper: float = 1.0, **more: Any) -> BeamPiece:
    """A piece of equal stiffness both ways."""
    both, none = (bending, bending * taper), (0.0, 0.0)
    numbers: dict[str, Any] = {"torsion": (20.0, 20.0), "axial": (1e6, 1e6), "inertia": ((1e-3, 1e-3), none, none)}
    return BeamPiece(end, both, both, mass=(mass, mass * taper), **{**numbers, **more})


def beam(**more: Any) -> Beam:
    """The beam of this file, three functions in each direction of bending."""
    given: dict[str, Any] = {"bend_y": 3, "bend_z": 3, "pieces": (piece(),)}
    return Beam(LENGTH, **{**given, **more})


def clamped(link: Any = None, *, gravity: Any = DOWN, points: tuple[Point, ...] = ()) -> Model:
    """A beam that stands out of a wall along x."""
    node = Node("rod", -1, Joint("wall", joint_kind("fixed")), link or beam())
    return Model(Chain("clamped", (node,), np.asarray(gravity, dtype=float), points=points))


def turning(link: Any = None, *, gravity: Any = (0.0, 0.0, 0.0), drive: str = "prescribed") -> Model:
    """A beam on a hinge about z."""
    joint = Joint("hub", joint_kind("revolute"), Placement(), drive=drive_kind(drive))
    return Model(Chain("turning", (Node("rod", -1, joint, link or beam()),), np.asarray(gravity, dtype=float)))
