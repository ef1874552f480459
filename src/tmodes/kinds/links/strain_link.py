"""Inertia of a strain link: positions by spectral integration of the tangents, mass at Gauss points.

Everything is in the axes of the link's root. The geometric variable-strain approach: Boyer, Lebastard, Candelier,
Renda, "Dynamics of continuum and soft robots: a strain parameterization based approach", IEEE Trans. Robotics 37(3),
2021.
"""

from __future__ import annotations

from typing import Any

from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.kernel.spatial import Force
from tmodes.kinds.links.strain_line import SectionState, StrainLine, shifted, shifted_line, strain_line
from tmodes.kinds.links.strain_shape import StrainShape, TableReader
from tmodes.kinds.links.terms import LinkTerms, Section

__all__ = ["strain_link"]


def strain_link(shape: StrainShape, tables: Any, rate: Any, q: Any, qd: Any) -> tuple[list[Any], list[list[Any]]]:
    """Packed inertia terms, and packed sections: the tip first, then the stations.

    ``rate`` (3,) is the angular velocity of the root in its own axes; ``tables`` are those of
    :func:`tmodes.kinds.links.beam_tables.beam_tables`.
    """
    table = TableReader(shape, tables)
    line = strain_line(shape, table, v.vec(rate), q, qd)
    return _Assembly(shape, table, line, q, qd).results()


class _Assembly:
    """Sums over the Gauss points; the bias acceleration is one more column."""

    def __init__(self, shape: StrainShape, table: TableReader, line: StrainLine, q: Any, qd: Any) -> None:
        self.shape, self.table, self.line = shape, table, line
        points = line.points
        g = shape.points
        shifts = [[table("shifts", m * shape.shifting + j) for j in range(shape.shifting)] for m in range(g)]
        self.lines: list[v.Vector] = []
        self.moved: list[list[v.Vector]] = []
        for m, state in enumerate(points):
            line_m, extra = shifted_line(shape, shifts[m], state.rotation, q), v.zero()
            if shape.shifting:
                speed = shifted(shape, shifts[m], state.rotation, qd)
                extra = v.add(*(v.scale(2 * rate, v.cross(state.rate, axis)) for rate, axis in speed))
            axes = v.transpose(state.rotation)
            columns = [v.cross(phi, line_m) for phi in state.columns]
            columns += [v.scale(p, axes[axis]) for p, axis in zip(shifts[m], shape.shifts, strict=True)]
            spin = v.cross(state.rate, v.cross(state.rate, line_m))
            self.lines.append(line_m)
            self.moved.append([*columns, v.add(v.cross(state.bias, line_m), spin, extra)])
        self.n = shape.size
        columns = [[moved[j] for moved in self.moved] for j in range(self.n + 1)]
        self.values = [*columns, self.lines]
        self.starts = [self._starts(values) for values in self.values]

    def results(self) -> tuple[list[Any], list[list[Any]]]:
        terms = self._terms().packed()
        places = [("tip", 0), *(("station", k) for k in range(len(self.shape.stations)))]
        return terms, [self._section(place).packed() for place in places]

    def _section(self, place: tuple[str, int]) -> Section:
        state = self.line.others[place]
        turns = [*state.columns, *(v.zero() for _ in range(self.shape.shifting)), state.bias]
        *moves, line = self._places(place)
        columns = [Force(turn, move) for turn, move in zip(turns, moves, strict=True)]
        return Section(state.rotation, line, state.rate, columns[:-1], columns[-1])

    def _places(self, place: tuple[str, int]) -> list[v.Vector]:
        """What is integrated from the root to a section: whole spans, then those next to it."""
        name = "to_tip" if place[0] == "tip" else "to_station"
        before = self.shape.points if place[0] == "tip" else self.shape.stations[place[1]]
        near = [k for k, part in enumerate(self.shape.parts) if part.start <= before <= part.stop]
        own = range(self.shape.parts[near[0]].start, self.shape.parts[near[-1]].stop)
        weights = [self.table(name, place[1] * self.shape.points + m) for m in own]
        return [
            v.add(starts[near[0]], self._weighted(weights, values[own.start : own.stop]))
            for starts, values in zip(self.starts, self.values, strict=True)
        ]

    def _starts(self, values: list[v.Vector]) -> list[v.Vector]:
        """What is integrated from the root to the start of each span."""
        found = [v.zero()]
        for part in self.shape.parts[:-1]:
            weights = [self.table("to_tip", m) for m in part]
            found.append(v.add(found[-1], self._weighted(weights, values[part.start : part.stop])))
        return found

    def _weighted(self, weights: list[Any], values: list[v.Vector]) -> v.Vector:
        return v.add(*(v.scale(w, value) for w, value in zip(weights, values, strict=True)))

    def _rooted(self, values: list[v.Vector], starts: list[v.Vector]) -> list[v.Vector]:
        """Weighted by the root of the mass matrix of the positions, so that sums over masses become plain ones."""
        g, result, entry = self.shape.points, [], 0
        for k in range(g) if not self.shape.spans else ():
            weights = [self.table("root_mass", entry + m - k) for m in range(k, g)]
            entry += g - k
            result.append(self._weighted(weights, values[k:]))
        for part, start in zip(self.shape.parts, starts, strict=True) if self.shape.spans else ():
            for _ in part:
                weights = [self.table("root_mass", entry + m) for m in range(len(part) + 1)]
                entry += len(part) + 1
                result.append(self._weighted(weights, [start, *values[part.start : part.stop]]))
        return result

    def _terms(self) -> LinkTerms:
        n, g = self.n, self.shape.points
        *moves, places = (self._rooted(*each) for each in zip(self.values, self.starts, strict=True))
        first = [self.table("first_moment", m) for m in range(g)]
        linear = [self._weighted(first, values) for values in self.values[:-1]]
        products = [[v.total([v.dot(a, b) for a, b in zip(moves[i], moves[j], strict=True)]) for j in range(i + 1)]
                    for i in range(n + 1)]  # fmt: skip
        angular = [v.add(*(v.cross(p, u) for p, u in zip(places, moves[j], strict=True))) for j in range(n + 1)]
        columns = [Force(turn, move) for turn, move in zip(angular, linear, strict=True)]
        squares = [_second_moment(place) for place in places]
        second = [[v.total([square[i][j] for square in squares]) for j in range(3)] for i in range(3)]
        terms = LinkTerms(products[:n], columns[:n], second, self._weighted(first, self.lines), self.table("mass"),
                          products[n][:n], columns[n])  # fmt: skip
        for m, state in enumerate(self.line.points):
            for axis in range(self.shape.rotary):
                self._add_rotary(terms, state, axis, self.table("rotary", m * self.shape.rotary + axis))
        return terms

    def _add_rotary(self, terms: LinkTerms, state: SectionState, axis: int, inertia: Any) -> None:
        """Inertia of the section about one of its own axes d: 1/2 I (d.W)^2."""
        d = [row[axis] for row in state.rotation]
        turns = [v.dot(d, phi) for phi in state.columns]
        weighted = [inertia * turn for turn in turns]
        bias = v.add(v.scale(inertia * v.dot(d, state.bias), d),
                     v.scale(inertia * v.dot(d, state.rate), v.cross(state.rate, d)))  # fmt: skip
        for i, turn in enumerate(turns):
            for j in range(i + 1):
                terms.mass[i][j] = terms.mass[i][j] + turn * weighted[j]
            terms.coupling[i] = Force(
                v.add(terms.coupling[i].angular, v.scale(weighted[i], d)), terms.coupling[i].linear
            )
            terms.bias_q[i] = terms.bias_q[i] + v.dot(state.columns[i], bias)
        square = v.outer(d, v.scale(inertia, d))
        terms.angular = [[terms.angular[i][j] + square[i][j] for j in range(3)] for i in range(3)]
        terms.bias = Force(v.add(terms.bias.angular, bias), terms.bias.linear)


def _second_moment(p: v.Vector) -> v.Matrix:
    """|p|^2 1 - p p^T."""
    xx, yy, zz = p[0] * p[0], p[1] * p[1], p[2] * p[2]
    xy, xz, yz = -(p[0] * p[1]), -(p[0] * p[2]), -(p[1] * p[2])
    return [[yy + zz, xy, xz], [xy, xx + zz, yz], [xz, yz, xx + yy]]
