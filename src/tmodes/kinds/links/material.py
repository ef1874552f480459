"""Materials of links: moduli, density and yield strength, given as numbers or taken by name from a small library.

A link made of layers bends and twists with effective moduli; those of the library are classical lamination theory on
the printed constants of one ply. Every entry says its source, and whether it is assumed, that is, not compared with the
print; values scatter from melt to melt by a few per cent.
"""

from __future__ import annotations

from collections.abc import Mapping
from difflib import get_close_matches
from types import MappingProxyType

from pydantic import Field

from tmodes.errors import InputError
from tmodes.kinds.schema.quantity import DataSheet, positive

__all__ = ["LIBRARY", "Material", "find_material"]


class Material(DataSheet):
    """A homogeneous, elastic material, or the effective one of a laminate."""

    young: float = positive("Pa", "E", "Young's modulus along the link", plausible=(1e5, 1e12))
    shear: float = positive("Pa", "G", "shear modulus of torsion", plausible=(1e4, 5e11))
    density: float = positive("kg/m^3", "rho", "density", plausible=(100.0, 25000.0))
    yield_strength: float | None = positive(
        "Pa", "sigma_y", "stress where it yields, or the first ply fails", default=None, plausible=(1e6, 5e9)
    )
    source: str = Field(default="", max_length=500, description="where its numbers are printed")


def _of(young: float, shear: float, density: float, yield_strength: float, source: str) -> Material:
    """Not checked here, for what checks it takes longer to build than all else in this file."""
    return Material.model_construct(
        young=young, shear=shear, density=density, yield_strength=yield_strength, source=source
    )


_ALUMINIUM = "ASM Handbook, vol. 2, Nonferrous Alloys and Special-Purpose Materials, 1990, typical values"
_TITANIUM = "ASM Materials Properties Handbook: Titanium Alloys, 1994, typical values"
_LAMINATE = (
    "effective moduli by classical lamination theory, strength by the strain at which the first ply fails in tension; "
    "ply: P. D. Soden et al., Composites Science and Technology 58 (1998) 1011; density assumed"
)

LIBRARY: Mapping[str, Material] = MappingProxyType(
    {
        "steel": _of(210e9, 81e9, 7850.0, 235e6, "structural steel S235: EN 1993-1-1:2005, 3.2.6 and Table 3.1"),
        "stainless_steel": _of(
            200e9, 76.9e9, 7900.0, 210e6, "1.4301: EN 10088-1, EN 1993-1-4:2006; G from nu = 0.3; assumed"
        ),
        "spring_steel": _of(206e9, 81.5e9, 7850.0, 1200e6, "51CrV4+QT: EN 13906-1:2013, EN 10089:2002; assumed"),
        "aluminium_6061": _of(68.9e9, 26e9, 2700.0, 276e6, f"6061-T6: {_ALUMINIUM}"),
        "aluminium_7075": _of(71.7e9, 26.9e9, 2810.0, 503e6, f"7075-T6: {_ALUMINIUM}"),
        "titanium": _of(113.8e9, 44e9, 4430.0, 880e6, f"Ti-6Al-4V, annealed: {_TITANIUM}"),
        "carbon_epoxy": _of(51.1e9, 19.8e9, 1580.0, 223e6, f"AS4/3501-6, [0/45/-45/90]: {_LAMINATE}"),
        "carbon_epoxy_axial": _of(92.3e9, 15.4e9, 1580.0, 712e6, f"AS4/3501-6, [0_4/45/-45]: {_LAMINATE}"),
        "glass_epoxy": _of(25.3e9, 9.70e9, 2000.0, 62.5e6, f"E-glass/MY750, [0/45/-45/90]: {_LAMINATE}"),
        "pla": _of(3.64e9, 1.34e9, 1240.0, 35.9e6, "SD3D, data sheet MaterialTDS-PLA_01, 2017; G from nu = 0.36"),
    }
)
"""Materials by name."""


def find_material(name: str) -> Material:
    """The material of the library with this name.

    Raises :class:`tmodes.errors.InputError` with the nearest name when there is none.
    """
    if name in LIBRARY:
        return LIBRARY[name]
    close = get_close_matches(str(name).lower(), LIBRARY, n=1)
    hint = f"did you mean `{close[0]}`?" if close else "write its young, shear and density"
    raise InputError("material", repr(name)[:60], f"one of {', '.join(LIBRARY)}", hint)
