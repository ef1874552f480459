"""The line of a strain link: the model's own steps from section to section, and the balance of all that is outboard.

What a section carries is the balance of everything outboard of it. The beam's own inertia is that of the model at its
Gauss points, carried between them by the polynomials through them; so the balance at the root is exactly the model's
own, and along the line it is smooth. The moment that bends it, EI kappa, is its projection on the link's functions.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from tmodes.kinds.kernel.schedule import Slot
from tmodes.kinds.links.beam_numbers import BeamNumbers
from tmodes.kinds.links.beam_tables import BeamTables, beam_tables, section_edges
from tmodes.kinds.links.line import LineOfLink, Moved
from tmodes.kinds.links.strain_place_kernels import BeamKernels
from tmodes.kinds.links.strain_place_numbers import is_ring, place_tables, stress_numbers

__all__ = ["BeamLine"]

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False, kw_only=True)
class BeamLine(LineOfLink):
    """Of one beam."""

    beam: BeamNumbers

    @property
    def stressed(self) -> bool:
        """Whether section and material are known."""
        return stress_numbers(self.beam, self.s[:1]).size > 0

    @cached_property
    def _tables(self) -> BeamTables:
        return beam_tables(self.beam, self.stations)

    @cached_property
    def _kernels(self) -> BeamKernels:
        fibre = ("ring" if is_ring(self.beam) else "corner") if self.stressed else ""
        return BeamKernels(self._tables.shape, fibre)

    def places(self, moved: Moved) -> list[Slot]:
        """Sections of the model from root to tip, what its points push, then each place from the section before."""
        own, shape, kernels = self._tables, self._tables.shape, self._kernels
        edges = section_edges(shape, own.points, self.stations)
        before = np.maximum(np.searchsorted(edges, self.s, side="left") - 1, 0)
        rotations, states = self._sections(moved)
        pushes = moved.one(kernels.points(), *self._point_blocks(moved, states))
        tables = place_tables(self.beam, own, edges, before, self.s)
        rows = np.concatenate([tables[name] for name, size in kernels.row.items() if size], axis=1)
        link = moved.numbers.block([self.beam.damping_time, *self.beam.rest_curvature])
        place, found = kernels.place(), []
        for row, section, first in zip(rows, before, self.borne(), strict=True):
            blocks = (moved.numbers.block(row), link, rotations[section], moved.q, moved.v, pushes, moved.pose)
            found.append(moved.one(place, *blocks, moved.outer[first]))
        return found

    def _sections(self, moved: Moved) -> tuple[list[Slot], list[Slot]]:
        """Axes of the root and of all sections, and the sections at the Gauss points."""
        shape, kernels = self._tables.shape, self._kernels
        section = (moved.numbers.block(np.eye(3)), moved.rate, moved.acceleration.part(0, 3))
        motion = tuple(block.part(0, shape.turning) for block in (moved.q, moved.v, moved.a)) if shape.turning else ()
        rotations, points = [section[0]], []
        for k, (kind, _) in enumerate(shape.breaks):
            steps = [moved.tables.part(shape.table_starts[name] + k * size, size)
                     for name, size in kernels.interval.items() if size]  # fmt: skip
            state = moved.one(kernels.step(), *steps, *section, *motion)
            section = (state.part(0, 9), state.part(9, 3), state.part(12, 3))
            rotations.append(section[0])
            points += [state] * (kind == "point")
        return rotations, points

    def _point_blocks(self, moved: Moved, states: list[Slot]) -> list[Slot]:
        own, shape = self._tables, self._tables.shape
        to_points = moved.numbers.block(self.beam.length * own.rule.integrals(own.points))
        stretch = moved.tables.part(shape.table_starts["stretch"], shape.tables["stretch"])
        blocks = [to_points, stretch, *states, moved.q, moved.v, moved.a, moved.acceleration]
        return [block for block in blocks if block.size]
