"""The link kind ``segments``: each segment is one mode of the 2010 paper as a link of its own."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.kinds.links.contract import Body, Link, LinkNumbers, QuadraticStructure
from tmodes.kinds.links.facts import ends
from tmodes.kinds.links.line import LineOfLink
from tmodes.kinds.links.segment_link import segment_link
from tmodes.kinds.links.segment_places import SegmentLine

__all__ = ["Segment", "SegmentStructure"]

Array = NDArray[np.float64]


@dataclass(frozen=True)
class SegmentStructure(QuadraticStructure):
    """A segment of the paper: it bends about y, about z, or both; its inertia sits at its tip, as a body."""

    bend_y: bool
    bend_z: bool

    @property
    def table_size(self) -> int:
        """The length."""
        return 1

    @property
    def size(self) -> int:
        """Number of coordinates."""
        return int(self.bend_y) + int(self.bend_z)

    @property
    def stiffness_sizes(self) -> tuple[int, ...]:
        """One coordinate per direction."""
        return (1,) * self.size

    @property
    def key(self) -> str:
        """The structure in words."""
        return f"segment {'y' * self.bend_y}{'z' * self.bend_z}"

    def sections(self, tables: Any, rate: Any, q: Any, qd: Any) -> tuple[list[Any], list[list[Any]]]:
        """No inertia terms of its own, and the section at the tip."""
        return [0.0], [segment_link(self.bend_y, self.bend_z, tables[0], rate, q, qd)]


@dataclass(frozen=True, eq=False)
class Segment(Link):
    """The paper's mode as a link: a chord of fixed length with the mass of Eq. (13) at its tip (LMA).

    The chord turns by th about z, then about y (``bend_y``, ``bend_z``: which are free), the tip's tangent by 3/2 th.
    ``stiffness`` Cs [N/m] and ``damping`` Bs [N*s/m] act on the tip's deflection; ``bodies`` in the tip frame.
    """

    kind: ClassVar[str] = "segments"

    length: float
    stiffness_y: float
    stiffness_z: float
    damping_y: float = 0.0
    damping_z: float = 0.0
    bend_y: bool = True
    bend_z: bool = True
    bodies: tuple[Body, ...] = ()

    @property
    def coordinates(self) -> tuple[str, ...]:
        """``bend_y`` and ``bend_z``, as far as they are free."""
        return tuple(name for name, free in (("bend_y", self.bend_y), ("bend_z", self.bend_z)) if free)

    @property
    def functions(self) -> Mapping[str, int]:
        """One in each direction that is free."""
        return {"twist": 0, "bend_y": int(self.bend_y), "bend_z": int(self.bend_z), "stretch": 0}

    def limiting_angles(self, q: Array, stations: tuple[float, ...] = ()) -> Array:  # noqa: ARG002
        """The angle of the chord."""
        return np.linalg.norm(q, axis=1)

    def stiffness_at(self, direction: str, s: ArrayLike) -> Array:
        """EI from the stiffness 3 EI/l^3 at its tip."""
        tip = getattr(self, f"stiffness_{direction[-1]}") if direction in ("bend_y", "bend_z") else np.inf
        return np.full(np.shape(s), tip * self.length**3 / 3)

    def described(self, row: Sequence[Any]) -> dict[str, Any]:
        """Segments in a row."""
        last = row[-1]
        return {
            "model": f"segments ({len(row)})",
            "length_m": sum(one.length for one in row),
            **{
                f"bending_stiffness_{axis}_Nm2": ends(
                    *(getattr(one, f"stiffness_{axis}") * one.length**3 / 3 for one in (self, last))
                )
                for axis in ("y", "z")
            },
        }

    def lines(self, stations: tuple[float, ...], s: NDArray[np.float64]) -> Sequence[LineOfLink]:
        """One cubic."""
        return [SegmentLine(self.length, stations, s, bend_y=self.bend_y, bend_z=self.bend_z)]

    def numbers(self, stations: tuple[float, ...]) -> LinkNumbers:  # noqa: ARG002
        """Length, and the springs and dampers against the angles."""
        square = self.length**2
        planes = ((self.bend_y, self.stiffness_y, self.damping_y), (self.bend_z, self.stiffness_z, self.damping_z))
        free = [plane for plane in planes if plane[0]]
        springs, dampers = (np.array([plane[k] * square for plane in free]) for k in (1, 2))
        return LinkNumbers(SegmentStructure(self.bend_y, self.bend_z), np.array([self.length]), springs, dampers)
