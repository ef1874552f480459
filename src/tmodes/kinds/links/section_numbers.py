"""What a cross-section is to a beam: stiffnesses, mass and rotary inertia per length, and its outer fibres."""

from __future__ import annotations

from typing import NamedTuple

from tmodes.kinds.links.material import Material

__all__ = ["Geometry", "SectionNumbers"]


class SectionNumbers(NamedTuple):
    """The numbers of a section; the beam runs along x, y and z are principal axes through the centroid.

    ``bend_y`` = integral E z^2 dA and ``bend_z`` = integral E y^2 dA [N*m^2], ``torsion`` GJ [N*m^2], ``axial`` EA [N],
    ``mass`` per length [kg/m], ``inertia_x/y/z`` rotary inertia per length about each axis [kg*m], ``outer_y`` and
    ``outer_z`` distance of the outer fibre along y and z [m], ``young`` and ``shear`` modulus [Pa]; the last four are
    0 where only stiffnesses are known.
    """

    bend_y: float
    bend_z: float
    torsion: float
    axial: float
    mass: float
    inertia_x: float
    inertia_y: float
    inertia_z: float
    outer_y: float
    outer_z: float
    young: float
    shear: float


class Geometry(NamedTuple):
    """A section without its material.

    ``area`` [m^2]; ``about_y`` = integral z^2 dA, ``about_z`` = integral y^2 dA and Saint-Venant's torsion constant
    ``torsion`` J [m^4]; outer fibre distances ``outer_y``, ``outer_z`` [m].
    """

    area: float
    about_y: float
    about_z: float
    torsion: float
    outer_y: float
    outer_z: float

    def made_of(self, material: Material) -> SectionNumbers:
        """The numbers of this section in one material; rho Ip = rho (Iy + Iz) about x."""
        young, shear, density = material.young, material.shear, material.density
        return SectionNumbers(
            bend_y=young * self.about_y,
            bend_z=young * self.about_z,
            torsion=shear * self.torsion,
            axial=young * self.area,
            mass=density * self.area,
            inertia_x=density * (self.about_y + self.about_z),
            inertia_y=density * self.about_y,
            inertia_z=density * self.about_z,
            outer_y=self.outer_y,
            outer_z=self.outer_z,
            young=young,
            shear=shear,
        )
