"""A section of which only stiffnesses and masses per length are known: measured, or printed in a paper."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from typing import Annotated, Any, Literal, NamedTuple

from pydantic import Field, field_validator

from tmodes.kinds.links.material import Material
from tmodes.kinds.noted.functions import isinf, maximum, minimum, number
from tmodes.kinds.schema.frames import list_of_numbers
from tmodes.kinds.schema.quantity import LARGEST, SMALLEST, DataSheet, Issue, not_negative, positive

__all__ = ["Geometry", "GivenSection", "SectionNumbers"]

_Stiffness = Annotated[float, Field(gt=0.0, allow_inf_nan=True)]


class GivenSection(DataSheet):
    """Stiffnesses instead of a drawing; one that is left out is infinite: the link does not twist, does not stretch."""

    shape: Literal["given"] = Field(default="given", description="which shape")
    bending_stiffness: tuple[_Stiffness, _Stiffness] = list_of_numbers(
        "N*m^2", "EI", "bending stiffness about y and about z; one number: both",
        rigid_when_infinite=True, plausible=[1e-6, 1e10], smallest=SMALLEST,
    )  # fmt: skip
    torsional_stiffness: float = positive(
        "N*m^2", "GJ", "torsional stiffness", default=math.inf, rigid=True, plausible=(1e-6, 1e10)
    )
    axial_stiffness: float = positive("N", "EA", "axial stiffness", default=math.inf, rigid=True, plausible=(1.0, 1e12))
    shear_stiffness: tuple[_Stiffness, _Stiffness] = list_of_numbers(
        "N", "kGA", "shear stiffness along y and along z; one number: both", default=(math.inf, math.inf),
        rigid_when_infinite=True, plausible=[1.0, 1e12], smallest=SMALLEST,
    )  # fmt: skip
    mass_per_length: float = positive("kg/m", "w", "mass per length", plausible=(1e-5, 1e4))
    polar_inertia_per_length: float = not_negative(
        "kg*m", "rho_Ip", "rotary inertia per length about the link's line", default=0.0, plausible=(0.0, 1e3)
    )

    @field_validator("bending_stiffness", "shear_stiffness", mode="before")
    @classmethod
    def _one_number_is_both(cls, value: Any) -> Any:
        return (value, value) if isinstance(value, (int, float)) else value

    def _issues(self) -> Iterator[Issue]:
        for name, unit in (("bending_stiffness", "N*m^2"), ("shear_stiffness", "N")):
            expected = f"a magnitude from {SMALLEST:g} to {LARGEST:g} [{unit}], or .inf for rigid"
            for value in getattr(self, name):
                if not (SMALLEST <= value <= LARGEST or isinf(value)):
                    yield Issue(name, f"{value:g}", expected, "correct the exponent or the unit")

    def properties(self, material: Material | None = None) -> SectionNumbers:
        """The numbers as given; of a material only the moduli are kept, for stresses.

        The rotary inertias about y and z part the polar one as the stiffnesses: exact for one material.
        """
        bend_y, bend_z = self.bending_stiffness
        share_y = _share(bend_y, bend_z)
        return SectionNumbers(
            bend_y=bend_y,
            bend_z=bend_z,
            torsion=self.torsional_stiffness,
            axial=self.axial_stiffness,
            mass=self.mass_per_length,
            inertia_x=self.polar_inertia_per_length,
            inertia_y=share_y * self.polar_inertia_per_length,
            inertia_z=(1 - share_y) * self.polar_inertia_per_length,
            outer_y=0.0,
            outer_z=0.0,
            young=material.young if material else 0.0,
            shear=material.shear if material else 0.0,
            shear_y=self.shear_stiffness[0],
            shear_z=self.shear_stiffness[1],
            across_y=0.0,
            across_z=0.0,
        )


def _share(bend_y: float, bend_z: float) -> float:
    """bend_y/(bend_y + bend_z), also where one is rigid; half where both are."""
    if isinf(bend_y) and isinf(bend_z):
        return 0.5
    return 1.0 if isinf(bend_y) else bend_y / (bend_y + bend_z)


class SectionNumbers(NamedTuple):
    """The numbers of a section; the beam runs along x, y and z are principal axes through the centroid.

    ``bend_y`` = integral E z^2 dA and ``bend_z`` = integral E y^2 dA [N*m^2], ``torsion`` GJ [N*m^2], ``axial`` EA [N],
    ``mass`` per length [kg/m], ``inertia_x/y/z`` rotary inertia per length about each axis [kg*m], ``outer_y`` and
    ``outer_z`` distance of the outer fibre along y and z [m], ``young`` and ``shear`` modulus [Pa]; these four are 0
    where only stiffnesses are known. ``shear_y``, ``shear_z``: shear stiffness kGA along y and z [N];
    ``across_y``, ``across_z``: largest shear stress over the shear force along y and z [1/m^2], 0 where not known.
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
    shear_y: float
    shear_z: float
    across_y: float
    across_z: float


class Geometry(NamedTuple):
    """A section without its material.

    ``area`` [m^2]; ``about_y`` = integral z^2 dA, ``about_z`` = integral y^2 dA and Saint-Venant's torsion constant
    ``torsion`` J [m^4]; outer fibre distances ``outer_y``, ``outer_z`` [m]; ``shear_peaks``: largest stress
    over a shear force along y and z [1/m^2]; ``shear_coefficients``: from the Poisson ratio, along y and z; see
    :mod:`tmodes.kinds.links.section_shapes`.
    """

    area: float
    about_y: float
    about_z: float
    torsion: float
    outer_y: float
    outer_z: float
    shear_peaks: tuple[float, float]
    shear_coefficients: Callable[[float], tuple[float, float]]

    def made_of(self, material: Material) -> SectionNumbers:
        """The numbers of this section in one material; rho Ip = rho (Iy + Iz) about x."""
        young, shear, density = material.young, material.shear, material.density
        poisson = number(minimum(maximum(young / (2 * shear) - 1, -1.0), 0.5))
        along_y, along_z = self.shear_coefficients(poisson)
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
            shear_y=along_y * shear * self.area,
            shear_z=along_z * shear * self.area,
            across_y=self.shear_peaks[0],
            across_z=self.shear_peaks[1],
        )
