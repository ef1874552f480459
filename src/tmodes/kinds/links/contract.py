"""What a link kind has to state: its numbers and places, and the structure of its equations.

A kind consists of a sheet (what a person writes, see :mod:`tmodes.kinds.links.sheet`), a :class:`Link` (final numbers)
and, where it bends, a :class:`LinkStructure` (the equations without numbers). Nothing asks which kind it is.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, ClassVar, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.links.facts import LinkFacts
from tmodes.kinds.links.line import CubicLine, LineOfLink
from tmodes.kinds.noted.functions import distinct
from tmodes.kinds.registry import source_digest

__all__ = ["Body", "ElasticForces", "Link", "LinkNumbers", "LinkStructure", "QuadraticStructure", "Row"]

Array = NDArray[np.float64]

Row = list[tuple[int, Any]]
"""Entries (column, value) of a row of a sparse matrix."""


@dataclass(frozen=True, eq=False)
class Body:
    """A rigid body in its frame's axes; ``inertia`` (3, 3) [kg*m^2] is about its center of mass."""

    mass: float
    center: Array = field(default_factory=lambda: np.zeros(3))
    inertia: Array = field(default_factory=lambda: np.zeros((3, 3)))


class ElasticForces(NamedTuple):
    """Spring and damper forces along the coordinates, stored energy [J] and power lost [W], as expressions."""

    spring: list[Any]
    damper: list[Any]
    energy: Any
    loss: Any


class LinkStructure(ABC):
    """The equations of a bending link without a number: same structure, same compiled code.

    Frozen and hashable. All expressions use only ``+ - * /`` and :mod:`tmodes.kinds.kernel.functions`.
    """

    long: ClassVar[bool] = False
    """Its line takes thousands of operations: compiled once and called, not written out at each call."""

    @property
    def work(self) -> int:
        """How long its line's code is, in proportion: 2,000 are compiled in about a second."""
        return 0

    @property
    def own_terms(self) -> bool:
        """The link has inertia terms of its own; else all its mass is in bodies at its tip."""
        return False

    @property
    def stations(self) -> tuple[int, ...]:
        """One entry for each station between root and tip."""
        return ()

    @property
    @abstractmethod
    def key(self) -> str:
        """The structure in words, unique among all kinds."""

    @property
    def fingerprint(self) -> str:
        """The key for compiled code; of a kind from outside of tmodes with a digest of its source."""
        return f"{self.key} {source_digest(type(self))}".rstrip()

    @property
    @abstractmethod
    def size(self) -> int:
        """Number of coordinates."""

    @property
    @abstractmethod
    def table_size(self) -> int:
        """Number of geometric and inertial constants."""

    @property
    @abstractmethod
    def stiffness_size(self) -> int:
        """Number of constants of the springs."""

    @property
    def damping_size(self) -> int:
        """Number of constants of the dampers."""
        return self.stiffness_size

    @property
    def terms_size(self) -> int:
        """Numbers of the packed inertia terms: M_qq, M_qb, M_bb (10), p_q, p_b; 1 where there are none."""
        n = self.size
        return n * (n + 1) // 2 + 6 * n + 10 + n + 6 if self.own_terms else 1

    @abstractmethod
    def sections(self, tables: Any, rate: Any, q: Any, qd: Any) -> tuple[list[Any], list[list[Any]]]:
        """Packed inertia terms ([0.0] where there are none) and packed sections: the tip first, then the stations.

        ``rate`` (3,): angular velocity of the root in its own axes; see :class:`tmodes.kinds.links.terms.LinkTerms` and
        :class:`tmodes.kinds.links.terms.Section`.
        """

    @abstractmethod
    def elastic(self, stiffness: Any, damping: Any, q: Any, qd: Any) -> ElasticForces:
        """Forces that springs and dampers put up against ``q`` and ``qd``."""

    @abstractmethod
    def tangents(self, stiffness: Any, damping: Any, q: Any, qd: Any) -> tuple[list[Row], list[Row]]:
        """Derivatives of the spring forces by q and of the damper forces by qd, row by row, symmetric.

        Implicit steps solve with them; an approximation lowers the order of a step, never its consistency.
        """


class QuadraticStructure(LinkStructure):
    """Springs and dampers with constant coefficients: blocks of K and D, diagonal or full, by direction."""

    @property
    def full(self) -> bool:
        """Whether the blocks are full matrices."""
        return False

    @property
    @abstractmethod
    def stiffness_sizes(self) -> tuple[int, ...]:
        """Number of coordinates of each block."""

    @property
    def stiffness_size(self) -> int:
        """Numbers of the packed matrix: diagonals, or lower triangles by block."""
        return sum(n * (n + 1) // 2 if self.full else n for n in self.stiffness_sizes)

    def elastic(self, stiffness: Any, damping: Any, q: Any, qd: Any) -> ElasticForces:
        """K q and D qd."""
        here, rates = [q[j] for j in range(self.size)], [qd[j] for j in range(self.size)]
        spring, damper = _product(self.rows(stiffness), here), _product(self.rows(damping), rates)
        energy = v.total([s * x for s, x in zip(spring, here, strict=True)]) / 2
        return ElasticForces(spring, damper, energy, v.total([d * x for d, x in zip(damper, rates, strict=True)]))

    def tangents(self, stiffness: Any, damping: Any, q: Any, qd: Any) -> tuple[list[Row], list[Row]]:  # noqa: ARG002
        """K and D themselves."""
        return self.rows(stiffness), self.rows(damping)

    def rows(self, packed: Any) -> list[Row]:
        """Rows of a packed matrix, each with the columns that it has."""
        rows: list[Row] = []
        first = entry = 0
        for n in self.stiffness_sizes:
            if not self.full:
                rows += [[(first + i, packed[entry + i])] for i in range(n)]
                entry += n
            else:
                place = {}
                for i in range(n):
                    for j in range(i + 1):
                        place[i, j] = place[j, i] = packed[entry]
                        entry += 1
                rows += [[(first + j, place[i, j]) for j in range(n)] for i in range(n)]
            first += n
        return rows


def _product(rows: list[Row], x: Sequence[Any]) -> list[Any]:
    return [v.total([k * x[j] for j, k in row]) for row in rows]


@dataclass(frozen=True, eq=False)
class LinkNumbers:
    """A bending link for the recursion: its structure and the constants of its kernels."""

    structure: LinkStructure
    tables: Array
    stiffness: Array
    damping: Array


class Link(LinkFacts):
    """An element of a chain with final numbers in SI units.

    A rigid link has its tip frame in its link frame; a bending one runs along x of its link frame from s = 0 to its
    tip at s = 1.
    """

    kind: ClassVar[str]
    """The word of its kind, for reports; not for decisions."""

    length: float
    """Length [m]; 0 for a rigid link, whose frames coincide."""

    @property
    @abstractmethod
    def coordinates(self) -> tuple[str, ...]:
        """Names of its coordinates, to be put after the link's name and a dot."""

    def embedding(self, finer: Link) -> Array:
        """(coordinates of ``finer``, own): what each of its coordinates is to the same link with more of them."""
        return np.array([[float(name == own) for own in self.coordinates] for name in finer.coordinates])

    def bodies_at(self, s: float) -> tuple[Body, ...]:
        """Bodies fixed to the section at s, in the section's axes; by default its ``bodies``, all at the tip."""
        return getattr(self, "bodies", ()) if s >= 1.0 else ()

    @property
    def all_bodies(self) -> tuple[Body, ...]:
        """All bodies on it, each in its section's axes."""
        return tuple(body for s in (*self.body_places, 1.0) for body in self.bodies_at(s))

    def unbent_bodies(self) -> tuple[Body, ...]:
        """Bodies with all its mass in its link frame, unbent: roughly right, to find what has no mass at all."""
        places = [(s, body) for s in (*self.body_places, 1.0) for body in self.bodies_at(s)]
        return tuple(Body(b.mass, b.center + np.array([s * self.length, 0.0, 0.0]), b.inertia) for s, b in places)

    @property
    def body_places(self) -> tuple[float, ...]:
        """Places s < 1 that carry bodies, in rising order."""
        return ()

    def stations(self, asked: Sequence[float] = ()) -> tuple[float, ...]:  # noqa: ARG002
        """Places s < 1 with sections besides the tip, rising; default: none. Sections anywhere: :meth:`along`."""
        return ()

    def along(self, asked: Sequence[float]) -> tuple[float, ...]:
        """Places s < 1 of bodies and of what is asked for, in rising order."""
        return tuple(distinct([*self.body_places, *(s for s in asked if s < 1.0)]))

    @property
    def mass_line(self) -> Any:
        """Where a rigid link's mass is along it (:class:`tmodes.kinds.links.rigid_beam.RigidBeam`); None: not known."""
        return None

    @property
    def has_stations(self) -> bool:
        """Whether bodies and points can be anywhere along it."""
        return bool(self.stations((0.5,)))

    def lines(self, stations: tuple[float, ...], s: Array) -> Sequence[LineOfLink]:
        """Its elastic lines, one after the other from root to tip, at the places ``s`` of each."""
        return [CubicLine(self.length, stations, s)]

    def described(self, row: Sequence[Any]) -> dict[str, Any]:
        """Its kind and length."""
        return {"model": self.kind, "length_m": float(sum(one.length for one in row))}

    @abstractmethod
    def numbers(self, stations: tuple[float, ...]) -> LinkNumbers:
        """The link for the recursion, with sections at ``stations``."""
