"""What is computed at a place of a bending link, and the expressions that all kinds of links have in common."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import accumulate
from typing import Any

from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.kernel.functions import fabs, fmin, if_else, sqrt

__all__ = ["PLACE", "STRESS", "STRESS_NUMBERS", "Shape", "Stressed", "in_section", "layout", "packed_place"]

PLACE = {
    "position": 3, "rotation": 9, "deflection": 2, "slope": 2, "moment": 3, "shear": 2, "axial": 1, "curvature": 2,
    "twist": 1, "stretch": 1, "elastic_moment": 3, "elastic_force": 1,
}  # fmt: skip
"""Quantities of a place with their numbers, in the order in which they are computed.

Position and rotation are in the world, deflection and slope in the axes of the root, the others in section axes.
"""

STRESS = {"strain": 1, "mises_stress": 1, "normal_stress": 1, "shear_stress": 1}
"""Quantities of a place where section and material are known, after those of all places."""

STRESS_NUMBERS = 8
"""Numbers of a section that its stresses depend on."""


def layout(*, stressed: bool) -> dict[str, slice]:
    """Where each quantity of a place stands."""
    sizes = PLACE | (STRESS if stressed else {})
    ends = list(accumulate(sizes.values()))
    return {name: slice(end - size, end) for (name, size), end in zip(sizes.items(), ends, strict=True)}


@dataclass
class Shape:
    """Curvature about y and z, twist and stretch of a section, with the moment and force of the material against them.

    ``slope``: angle of the tangent against that of the root, in the x-y and the x-z plane of the root.
    """

    slope: list[Any]
    curvature: list[Any]
    twist: Any
    stretch: Any
    elastic_moment: v.Vector
    elastic_force: Any
    deflection: list[Any] | None = None
    """Where it is not the place off the root's x axis."""


@dataclass
class Stressed:
    """Stress of a section by its ``numbers``: Young's and shear modulus, distances of the outer fibre along y and z,
    stiffnesses GJ, EI_y, EI_z, EA (0 where not given or infinite). ``ring``: the outer fibre is a circle, on which both
    bending moments add up.

    sigma = |N| E/EA + |M| E r/EI; tau = G r M_x/GJ of a circle, else with r of a bound: Saint-Venant's shear is at most
    that of a strip of the section's thickness, and that of its corner's distance.
    """  # noqa: D205

    numbers: Any
    ring: bool

    def packed(self, moment: v.Vector, axial: Any) -> list[Any]:
        """Strain, von Mises stress, normal and shear stress."""
        young, shear, outer_y, outer_z, *stiffness = (self.numbers[k] for k in range(STRESS_NUMBERS))
        per_torsion, per_y, per_z, per_force = (if_else(k > 0, 1 / k, 0.0) for k in stiffness)
        about_y, about_z = fabs(moment[1]) * outer_z * per_y, fabs(moment[2]) * outer_y * per_z
        bending = sqrt(about_y * about_y + about_z * about_z) if self.ring else about_y + about_z
        strain = bending + fabs(axial) * per_force
        corner = fmin(2 * fmin(outer_y, outer_z), sqrt(outer_y * outer_y + outer_z * outer_z))
        lever = outer_y if self.ring else corner
        normal, across = young * strain, shear * lever * fabs(moment[0]) * per_torsion
        return [strain, sqrt(normal * normal + 3 * across * across), normal, across]


def in_section(rotation: v.Matrix, moment: v.Vector, force: v.Vector) -> tuple[v.Vector, v.Vector]:
    """Moment and force in the axes that are the columns of ``rotation``."""
    axes = v.transpose(rotation)
    return v.matvec(axes, moment), v.matvec(axes, force)


def packed_place(
    pose: Any, rotation: v.Matrix, position: v.Vector, moment: v.Vector, force: v.Vector, shape: Shape,
    stressed: Stressed | None = None,
) -> list[Any]:  # fmt: skip
    """All quantities of a place.

    ``pose`` of the root in the world; ``rotation`` and ``position`` of the section in the axes of the root; ``moment``
    and ``force`` by the outboard part on the inboard one, in section axes.
    """
    world = v.tri(pose)
    place = v.add(v.vec(pose, 9), v.matvec(world, position))
    stress = stressed.packed(moment, force[0]) if stressed else []
    return v.flat(
        place, v.matmul(world, rotation), shape.deflection or position[1:], shape.slope, moment, force[1:], force[0],
        shape.curvature, shape.twist, shape.stretch, shape.elastic_moment, shape.elastic_force, stress,
    )  # fmt: skip
