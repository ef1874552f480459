"""Kinematics and inertia of a strain link: curvature is a coordinate, the line is its integral, the tip is its end.

The frame is integrated from point to point by the fourth-order Magnus step (exact where curvature keeps its plane), the
position by spectral integration of the tangents, and mass sits at Gauss points. Everything is in the axes of the
link's root. The geometric variable-strain approach: Boyer, Lebastard, Candelier, Renda, "Dynamics of continuum and soft
robots: a strain parameterization based approach", IEEE Trans. Robotics 37(3), 2021.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from math import factorial
from typing import Any

import casadi as ca

from tmodes.equations.arm import vectors as v
from tmodes.equations.arm.link_terms import LinkTerms, Section
from tmodes.equations.arm.spatial import Force
from tmodes.equations.arm.strain_shape import StrainShape, TableReader

__all__ = ["strain_link"]

_TERMS = 7
"""Terms of the series of the rotation: 1e-15 up to 0.6 radian between two points, 1e-12 up to 1.0, 1e-9 up to 1.6."""


@dataclass
class _State:
    """A section on the way from root to tip."""

    rotation: v.Matrix
    rate: v.Vector
    bias: v.Vector
    columns: list[v.Vector]


@dataclass
class _Line:
    """The sections at the Gauss points, and at the stations and the tip by name."""

    points: list[_State] = field(default_factory=list)
    others: dict[tuple[str, int], _State] = field(default_factory=dict)


def strain_link(shape: StrainShape, tables: Any, rate: Any, q: Any, qd: Any) -> tuple[list[Any], list[list[Any]]]:
    """Packed inertia terms, and packed sections: the tip first, then the stations.

    ``rate`` (3,) is the angular velocity of the root in its own axes; ``tables`` are those of
    :func:`tmodes.equations.arm.beam_tables.beam_tables`.
    """
    table = TableReader(shape, tables)
    line = _planar_line(shape, table, v.vec(rate), q, qd)
    if line is None:
        line = _spatial_line(shape, table, v.vec(rate), q, qd)
    return _Assembly(shape, table, line, q, qd).results()


def _planar_line(shape: StrainShape, table: TableReader, rate: v.Vector, q: Any, qd: Any) -> _Line | None:
    """One direction only: angles add up, so the rotation is exact."""
    if shape.planar is None:
        return None
    axis = v.unit(shape.planar)
    angle: Any = 0.0
    speed: Any = 0.0
    slopes: list[Any] = [0.0] * shape.turning
    line = _Line()
    for interval, place in enumerate(shape.breaks):
        alphas = [table("alpha", interval * shape.turning + j) for j in range(shape.turning)]
        slopes = [slope + alpha for slope, alpha in zip(slopes, alphas, strict=True)]
        angle = angle + v.total([alpha * q[j] for j, alpha in enumerate(alphas)])
        speed = speed + v.total([alpha * qd[j] for j, alpha in enumerate(alphas)])
        turned = v.scale(speed, axis)
        state = _State(
            _rotation(shape.planar, angle), v.add(rate, turned), v.cross(rate, turned), [v.scale(s, axis) for s in slopes]
        )
        _keep(line, place, state)
    return line


def _rotation(axis: int, angle: Any) -> v.Matrix:
    c, s = ca.cos(angle), ca.sin(angle)
    i, j = (axis + 1) % 3, (axis + 2) % 3
    matrix = v.identity()
    matrix[i][i], matrix[j][j], matrix[i][j], matrix[j][i] = c, c, -s, s
    return matrix


def _keep(line: _Line, place: tuple[str, int], state: _State) -> None:
    if place[0] == "point":
        line.points.append(state)
    else:
        line.others[place] = state


def _spatial_line(shape: StrainShape, table: TableReader, rate: v.Vector, q: Any, qd: Any) -> _Line:
    state = _State(v.identity(), rate, v.zero(), [v.zero() for _ in range(shape.turning)])
    line = _Line()
    for interval, place in enumerate(shape.breaks):
        state = _magnus_step(shape, table, interval, state, q, qd)
        _keep(line, place, state)
    return line


def _magnus_step(shape: StrainShape, table: TableReader, interval: int, old: _State, q: Any, qd: Any) -> _State:
    """From one section to the next: rotation, angular velocity, its bias acceleration, and its columns."""
    n = shape.turning
    alpha = [table("alpha", interval * n + j) for j in range(n)]
    beta = [table("beta", interval * n + j) for j in range(n)]
    a, b = _sums(shape, alpha, q), _sums(shape, beta, q)
    if shape.curved:
        a = v.add(a, [table("rest", interval * 3 + c) for c in range(3)])
    ad, bd = _sums(shape, alpha, qd), _sums(shape, beta, qd)
    turn = v.add(a, v.cross(a, b))
    turn_rate = v.add(ad, v.cross(ad, b), v.cross(a, bd))
    turn_bias = v.scale(2, v.cross(ad, bd))
    z = v.dot(turn, turn)
    f1, f2, f3 = _series(z, 1), _series(z, 2), _series(z, 3)
    once = [v.cross(row, turn) for row in old.rotation]
    twice = [v.cross(row, turn) for row in once]
    spread = _mix(old.rotation, (f2, once), (f3, twice))
    gained = v.matvec(spread, turn_rate)
    c1 = v.cross(turn, turn_rate)
    inner = v.add(
        v.scale(2 * v.dot(turn, turn_rate), v.add(v.scale(_slope(z, 2), c1), v.scale(_slope(z, 3), v.cross(turn, c1)))),
        v.scale(f3, v.cross(turn_rate, c1)),
    )
    bias = v.add(
        old.bias, v.cross(old.rate, gained), v.matvec(old.rotation, inner), v.matvec(spread, turn_bias)
    )
    columns = _columns(shape, spread, a, b, alpha, beta, old.columns)
    return _State(_mix(old.rotation, (f1, once), (f2, twice)), v.add(old.rate, gained), bias, columns)


def _sums(shape: StrainShape, weights: list[Any], q: Any) -> v.Vector:
    """Sum of weight times coordinate for each component of curvature."""
    sums = v.zero()
    for j, direction in enumerate(shape.directions):
        sums[direction] = sums[direction] + weights[j] * q[j]
    return sums


def _series(z: Any, first: int) -> Any:
    """Sum of (-z)^k/(2k + first)!: sin(x)/x for first = 1, (1 - cos x)/x^2 for 2, (x - sin x)/x^3 for 3; z = x^2."""
    value: Any = 0.0
    for k in reversed(range(_TERMS)):
        value = value * z + (-1) ** k / factorial(2 * k + first)
    return value


def _slope(z: Any, first: int) -> Any:
    """Derivative of the series by z."""
    value: Any = 0.0
    for k in reversed(range(1, _TERMS)):
        value = value * z + k * (-1) ** k / factorial(2 * k + first)
    return value


def _mix(base: v.Matrix, *terms: tuple[Any, v.Matrix]) -> v.Matrix:
    return [
        [v.total([base[i][j], *(factor * matrix[i][j] for factor, matrix in terms)]) for j in range(3)]
        for i in range(3)
    ]


def _columns(
    shape: StrainShape, spread: v.Matrix, a: v.Vector, b: v.Vector, alpha: list[Any], beta: list[Any], old: list[v.Vector]
) -> list[v.Vector]:
    """Angular velocity of the section per rate of each coordinate."""
    by_b = [v.sub(row, v.cross(row, b)) for row in spread]
    by_a = [v.cross(row, a) for row in spread]
    return [
        [old[j][i] + alpha[j] * by_b[i][c] + beta[j] * by_a[i][c] for i in range(3)]
        for j, c in enumerate(shape.directions)
    ]


class _Assembly:
    """Sums over the Gauss points; the bias acceleration is one more column."""

    def __init__(self, shape: StrainShape, table: TableReader, line: _Line, q: Any, qd: Any) -> None:
        self.shape, self.table, self.line = shape, table, line
        points = line.points
        g = shape.points
        stretch = [[table("stretch", m * shape.stretch + j) for j in range(shape.stretch)] for m in range(g)]
        tangents = [[row[0] for row in state.rotation] for state in points]
        self.lines: list[v.Vector] = []
        self.moved: list[list[v.Vector]] = []
        for m, state in enumerate(points):
            t, line_m, extra = tangents[m], tangents[m], v.zero()
            if shape.stretch:
                longer = 1 + v.total([p * q[shape.turning + j] for j, p in enumerate(stretch[m])])
                longer_rate = v.total([p * qd[shape.turning + j] for j, p in enumerate(stretch[m])])
                line_m, extra = v.scale(longer, t), v.scale(2 * longer_rate, v.cross(state.rate, t))
            columns = [v.cross(phi, line_m) for phi in state.columns] + [v.scale(p, t) for p in stretch[m]]
            spin = v.cross(state.rate, v.cross(state.rate, line_m))
            self.lines.append(line_m)
            self.moved.append([*columns, v.add(v.cross(state.bias, line_m), spin, extra)])
        self.n = shape.size

    def results(self) -> tuple[list[Any], list[list[Any]]]:
        terms = self._terms().packed()
        places = [("tip", 0), *(("station", k) for k in range(len(self.shape.stations)))]
        return terms, [self._section(place).packed() for place in places]

    def _section(self, place: tuple[str, int]) -> Section:
        state = self.line.others[place]
        start = place[1] * self.shape.points
        name = "to_tip" if place[0] == "tip" else "to_station"
        weights = [self.table(name, start + m) for m in range(self.shape.points)]
        turns = [*state.columns, *(v.zero() for _ in range(self.shape.stretch)), state.bias]
        moves = [self._weighted(weights, [moved[j] for moved in self.moved]) for j in range(self.n + 1)]
        columns = [Force(turn, move) for turn, move in zip(turns, moves, strict=True)]
        return Section(state.rotation, self._weighted(weights, self.lines), state.rate, columns[:-1], columns[-1])

    def _weighted(self, weights: list[Any], values: list[v.Vector]) -> v.Vector:
        return v.add(*(v.scale(w, value) for w, value in zip(weights, values, strict=True)))

    def _rooted(self, values: list[v.Vector]) -> list[v.Vector]:
        """Weighted by the root of the mass matrix of the positions, so that sums over masses become plain ones."""
        g, result, entry = self.shape.points, [], 0
        for k in range(g):
            weights = [self.table("root_mass", entry + m - k) for m in range(k, g)]
            entry += g - k
            result.append(self._weighted(weights, values[k:]))
        return result

    def _terms(self) -> LinkTerms:
        n, g = self.n, self.shape.points
        places = self._rooted(self.lines)
        moves = [self._rooted([moved[j] for moved in self.moved]) for j in range(n + 1)]
        first = [self.table("first_moment", m) for m in range(g)]
        linear = [self._weighted(first, [moved[j] for moved in self.moved]) for j in range(n + 1)]
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

    def _add_rotary(self, terms: LinkTerms, state: _State, axis: int, inertia: Any) -> None:
        """Inertia of the section about one of its own axes d: 1/2 I (d.W)^2."""
        d = [row[axis] for row in state.rotation]
        turns = [v.dot(d, phi) for phi in state.columns]
        weighted = [inertia * turn for turn in turns]
        bias = v.add(v.scale(inertia * v.dot(d, state.bias), d),
                     v.scale(inertia * v.dot(d, state.rate), v.cross(state.rate, d)))  # fmt: skip
        for i, turn in enumerate(turns):
            for j in range(i + 1):
                terms.mass[i][j] = terms.mass[i][j] + turn * weighted[j]
            terms.coupling[i] = Force(v.add(terms.coupling[i].angular, v.scale(weighted[i], d)), terms.coupling[i].linear)
            terms.bias_q[i] = terms.bias_q[i] + v.dot(state.columns[i], bias)
        square = v.outer(d, v.scale(inertia, d))
        terms.angular = [[terms.angular[i][j] + square[i][j] for j in range(3)] for i in range(3)]
        terms.bias = Force(v.add(terms.bias.angular, bias), terms.bias.linear)


def _second_moment(p: v.Vector) -> v.Matrix:
    """|p|^2 1 - p p^T."""
    xx, yy, zz = p[0] * p[0], p[1] * p[1], p[2] * p[2]
    xy, xz, yz = -(p[0] * p[1]), -(p[0] * p[2]), -(p[1] * p[2])
    return [[yy + zz, xy, xz], [xy, xx + zz, yz], [xz, yz, xx + yy]]
