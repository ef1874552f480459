"""The link kind ``strain``: a beam whose curvature is a sum of functions, exact in large deflection."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from tmodes.kinds.links.beam_functions import MODULI
from tmodes.kinds.links.beam_numbers import BeamNumbers, BeamPiece
from tmodes.kinds.links.beam_tables import beam_tables
from tmodes.kinds.links.contract import Body, Link, LinkNumbers, QuadraticStructure
from tmodes.kinds.links.line import LineOfLink
from tmodes.kinds.links.strain_link import strain_link
from tmodes.kinds.links.strain_places import BeamLine
from tmodes.kinds.links.strain_shape import StrainShape

__all__ = ["Beam", "BeamPiece", "StrainStructure"]


@dataclass(frozen=True)
class StrainStructure(QuadraticStructure):
    """A beam of the shape given."""

    shape: StrainShape

    long: ClassVar[bool] = True

    @property
    def own_terms(self) -> bool:
        """Its mass is spread along its line."""
        return True

    @property
    def key(self) -> str:
        """The structure in words."""
        return self.shape.key

    @property
    def size(self) -> int:
        """Number of coordinates."""
        return self.shape.size

    @property
    def table_size(self) -> int:
        """Numbers in all tables."""
        return self.shape.table_size

    @property
    def stations(self) -> tuple[int, ...]:
        """For each station, the number of Gauss points before it."""
        return self.shape.stations

    @property
    def full(self) -> bool:
        """Whether stiffness matrices are not diagonal."""
        return self.shape.full

    @property
    def stiffness_sizes(self) -> tuple[int, ...]:
        """Functions of each direction."""
        return self.shape.stiffness_sizes

    def sections(self, tables: Any, rate: Any, q: Any, qd: Any) -> tuple[list[Any], list[list[Any]]]:
        """Inertia terms, and the sections at the tip and the stations."""
        return strain_link(self.shape, tables, rate, q, qd)


@dataclass(frozen=True, eq=False)
class Beam(BeamNumbers, Link):
    """A ``strain`` link: see :class:`tmodes.kinds.links.beam_numbers.BeamNumbers` for its fields."""

    kind: ClassVar[str] = "strain"

    @property
    def coordinates(self) -> tuple[str, ...]:
        """Directions with the number of each function: ``bend_y1``, ``bend_y2``, ..."""
        return tuple(f"{name}{k + 1}" for name in MODULI for k in range(getattr(self, name)))

    @property
    def body_places(self) -> tuple[float, ...]:
        """Places s < 1 that carry bodies."""
        return tuple(sorted({s for s, _ in self.bodies if s < 1.0}))

    def bodies_at(self, s: float) -> tuple[Body, ...]:
        """Bodies on the section at s."""
        return tuple(body for at, body in self.bodies if (at >= 1.0 if s >= 1.0 else at == s))

    def unbent_bodies(self) -> tuple[Body, ...]:
        """The bodies on it, and the beam as a straight rod of its mean mass per length."""
        mass = self.length * float(np.mean([number for piece in self.pieces for number in piece.mass]))
        polar = self.length * float(np.mean([number for piece in self.pieces for number in piece.inertia[0]]))
        across = mass * self.length**2 / 12
        rod = Body(mass, np.array([self.length / 2, 0.0, 0.0]), np.diag([polar, across, across]))
        return (rod, *super().unbent_bodies())

    def lines(self, stations: tuple[float, ...], s: NDArray[np.float64]) -> Sequence[LineOfLink]:
        """One line, section by section as the model has it."""
        return [BeamLine(self.length, stations, s, beam=self)]

    def numbers(self, stations: tuple[float, ...]) -> LinkNumbers:
        """Quadrature, integrals of the functions, stiffness."""
        tables = beam_tables(self, stations)
        return LinkNumbers(StrainStructure(tables.shape), tables.packed, tables.stiffness, tables.damping)
