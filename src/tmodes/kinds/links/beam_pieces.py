"""What a beam is described by: what may be chosen of it, and the numbers of its section from root to tip."""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import StrEnum
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmodes.kinds.links.contract import Body
from tmodes.kinds.links.material import Material
from tmodes.kinds.links.section import Section, SectionNumbers, between
from tmodes.kinds.noted.functions import by_size, highest, isfinite, kept, number

__all__ = [
    "Basis", "BeamModel", "BeamNumbers", "BeamPiece", "Piece", "RotaryInertia", "tapered_pieces", "uniform_piece",
]  # fmt: skip


class BeamModel(StrEnum):
    """The ladder of models of one link."""

    STRAIN = "strain"
    SEGMENTS = "segments"
    RIGID = "rigid"


class Basis(StrEnum):
    """The bending functions of a strain link; ``auto`` is ``legendre``.

    ``tip_weighted``: for a free end on which forces act, but no moment.
    """

    AUTO = "auto"
    LEGENDRE = "legendre"
    TIP_WEIGHTED = "tip_weighted"


class RotaryInertia(StrEnum):
    """Which rotary inertia of the sections counts: none, about the line (``twist``), or about all axes (Rayleigh).

    ``auto``: about all axes of a link with functions of shear (Timoshenko), about the line of any other.
    """

    AUTO = "auto"
    NONE = "none"
    TWIST = "twist"
    FULL = "full"


Array = NDArray[np.float64]


@dataclass(frozen=True)
class BeamPiece:
    """A piece of a beam that ends at s = ``end``; each quantity is (at its start, at its end), linear between.

    Bending stiffness about y and z [N*m^2], torsional GJ [N*m^2], axial EA [N], mass per length [kg/m], inertia per
    length about x, y and z [kg*m], shear stiffness kGA along y and z [N], and the largest
    shear stress over a shear force along y and z [1/m^2].
    """

    end: float
    bend_y: tuple[float, float]
    bend_z: tuple[float, float]
    torsion: tuple[float, float]
    axial: tuple[float, float]
    mass: tuple[float, float]
    inertia: tuple[tuple[float, float], tuple[float, float], tuple[float, float]] = ((0.0, 0.0), (0.0, 0.0), (0.0, 0.0))
    shear_y: tuple[float, float] = (np.inf, np.inf)
    shear_z: tuple[float, float] = (np.inf, np.inf)
    across_y: tuple[float, float] = (0.0, 0.0)
    across_z: tuple[float, float] = (0.0, 0.0)


@dataclass(frozen=True, eq=False)
class BeamNumbers:
    """A ``strain`` link: its moments and forces are polynomials, its strains follow, the line is their integral.

    ``twist``, ``bend_y``, ``bend_z``, ``stretch``, ``shear_y``, ``shear_z``: numbers of functions. ``basis`` of
    bending: ``legendre`` (P_j) or ``tip_weighted`` ((1 - s) P_j, for a free end on which no moment acts).
    ``points``: Gauss points between jumps of the section, 0 for the default. ``damping_time`` [s] Kelvin-Voigt.
    ``rest_curvature`` (3,) [1/m]: twist, y, z of the unloaded line. ``bodies``: (s, body) in section axes at s in
    0..1. ``outer`` (2,): distance of the
    outer fibre along y and z [m], for stress; ``young`` and ``shear`` modulus [Pa], 0 where not known. ``softened``:
    what the last functions of each direction does counts as in :func:`tmodes.kinds.links.beam_functions.softened`.
    """

    length: float
    pieces: tuple[BeamPiece, ...]
    twist: int = 0
    bend_y: int = 0
    bend_z: int = 0
    stretch: int = 0
    shear_y: int = 0
    shear_z: int = 0
    basis: str = "legendre"
    points: int = 0
    damping_time: float = 0.0
    rest_curvature: Array = field(default_factory=lambda: np.zeros(3))
    bodies: tuple[tuple[float, Body], ...] = ()
    outer: tuple[float, float] = (0.0, 0.0)
    young: float = 0.0
    shear: float = 0.0
    softened: bool = False


MOST_TAPER_PIECES = 16
GOOD_ENOUGH = 0.01
"""Local error of a straight line in place of a taper's stiffness [-]; its integrals over the piece are exact."""

FOLLOWED = 6
"""Numbers of a section that decide: stiffnesses, mass and polar inertia, the first of :class:`SectionNumbers`."""

_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(8)


class Piece(NamedTuple):
    """A piece of a beam that ends at the share ``end`` of its length; numbers at its ``start`` and ``stop``."""

    end: float
    start: SectionNumbers
    stop: SectionNumbers

    def at(self, name: str, share: Any) -> Any:
        """A number of its sections at ``share`` (0..1) of the piece."""
        first, last = getattr(self.start, name), getattr(self.stop, name)
        return first if first == last else first + share * (last - first)


def uniform_piece(end: float, numbers: SectionNumbers) -> Piece:
    """A piece of one section."""
    return Piece(end, numbers, numbers)


@kept
def tapered_pieces(root: Section, tip: Section, material: Material | None) -> tuple[Piece, ...]:
    """The fewest equal pieces that follow a beam whose dimensions are linear from root to tip.

    In each, a number is the line with the same mean and the same first moment (least squares).
    """
    count = 1
    fitted = [_fitted(root, tip, material, 0.0, 1.0)]
    while any(x > GOOD_ENOUGH for x in by_size([error for _, error in fitted])) and count < MOST_TAPER_PIECES:
        count += 1
        fitted = [_fitted(root, tip, material, k / count, (k + 1) / count) for k in range(count)]
    return tuple(piece for piece, _ in fitted)


def _fitted(root: Section, tip: Section, material: Material | None, start: float, end: float) -> tuple[Piece, float]:
    """The piece between two shares of the length, and its largest relative error at the points of quadrature."""
    shares = start + (end - start) * (1 + _NODES) / 2
    table = np.array([_numbers(root, tip, material, share) for share in shares])
    exact = np.array([_numbers(root, tip, material, share) for share in (start, end)])
    with np.errstate(invalid="ignore", divide="ignore"):  # of infinite stiffnesses, which are distinguished below
        mean, slope = _WEIGHTS @ table / 2, 1.5 * (_WEIGHTS * _NODES) @ table
        ends = np.array([mean - slope, mean + slope])
        usable = isfinite(table).all(axis=0) & (ends > 0).all(axis=0)
        ends = np.where(usable, ends, exact)
        error = np.abs((ends[0] + np.outer(1 + _NODES, ends[1] - ends[0]) / 2) / table - 1)
    error = np.where(isfinite(table) & (table > 0), error, 0.0)
    first, last = (SectionNumbers(*map(number, row)) for row in ends)
    return Piece(end, first, last), number(highest(error[:, :FOLLOWED]))


def _numbers(root: Section, tip: Section, material: Material | None, share: float) -> SectionNumbers:
    section = between(root, tip, share)
    return section.properties(material)  # pyright: ignore[reportArgumentType]  # a drawn section has its material here
