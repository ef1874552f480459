"""The kinds of bending links, by what the recursion asks of them: sizes, and sections with their inertia."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from tmodes.equations.line.beam import BeamLine
from tmodes.equations.line.link import LineOfLink
from tmodes.equations.line.segment import SegmentLine
from tmodes.equations.recursion.segment_link import segment_link
from tmodes.equations.recursion.strain_link import strain_link
from tmodes.equations.recursion.strain_shape import StrainShape

__all__ = ["SegmentKind", "StrainKind"]


@dataclass(frozen=True)
class SegmentKind:
    """A segment of the paper: it bends about y, about z, or both; its inertia sits at its tip, as a body."""

    bend_y: bool
    bend_z: bool

    own_terms = False
    full = False
    table_size = 1
    stations: tuple[int, ...] = ()
    terms_size = 1

    @property
    def size(self) -> int:
        """Number of coordinates."""
        return int(self.bend_y) + int(self.bend_z)

    @property
    def stiffness_sizes(self) -> tuple[int, ...]:
        """One coordinate per direction."""
        return (1,) * self.size

    stiffness_size = size

    @property
    def key(self) -> str:
        """The structure in words."""
        return f"segment {'y' * self.bend_y}{'z' * self.bend_z}"

    def sections(self, tables: Any, rate: Any, q: Any, qd: Any) -> tuple[list[Any], list[list[Any]]]:
        """No inertia terms of its own, and the section at the tip."""
        return [0.0], [segment_link(self.bend_y, self.bend_z, tables[0], rate, q, qd)]

    def line(self, link: Any, stations: tuple[float, ...], s: Any) -> LineOfLink:  # noqa: ARG002
        """The elastic line of such a link of a chain at the places ``s``."""
        return SegmentLine(link, s)


@dataclass(frozen=True)
class StrainKind:
    """A beam of the shape given."""

    shape: StrainShape

    own_terms = True

    def __getattr__(self, name: str) -> Any:
        return getattr(object.__getattribute__(self, "shape"), name)

    def sections(self, tables: Any, rate: Any, q: Any, qd: Any) -> tuple[list[Any], list[list[Any]]]:
        """Inertia terms, and the sections at the tip and the stations."""
        return strain_link(self.shape, tables, rate, q, qd)

    def line(self, link: Any, stations: tuple[float, ...], s: Any) -> LineOfLink:
        """The elastic line of such a link of a chain at the places ``s``; ``stations``: those of the model."""
        return BeamLine(link, stations, s)
