"""Kinematics of a strain link: curvature is a coordinate, the line is its integral, the tip is its end.

The frame is integrated from section to section by the fourth-order Magnus step (exact where curvature keeps its plane).
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, NamedTuple

from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.kernel.functions import cos, sin
from tmodes.kinds.links.strain_shape import StrainShape, TableReader

__all__ = [
    "SectionState",
    "StrainLine",
    "Turned",
    "curvature_sums",
    "magnus_turn",
    "shifted",
    "shifted_line",
    "strain_line",
]

_TERMS = 7
"""Terms of the series of the rotation: 1e-15 up to 0.6 radian between two points, 1e-12 up to 1.0, 1e-9 up to 1.6."""


@dataclass
class SectionState:
    """A section on the way from root to tip."""

    rotation: v.Matrix
    rate: v.Vector
    bias: v.Vector
    columns: list[v.Vector]


@dataclass
class StrainLine:
    """The sections at the Gauss points, and at the stations and the tip by name."""

    points: list[SectionState] = field(default_factory=list)
    others: dict[tuple[str, int], SectionState] = field(default_factory=dict)


def strain_line(shape: StrainShape, table: TableReader, rate: v.Vector, q: Any, qd: Any) -> StrainLine:
    """All sections of a link whose root turns at ``rate`` (in its own axes)."""
    return _planar_line(shape, table, rate, q, qd) or _spatial_line(shape, table, rate, q, qd)


def _planar_line(shape: StrainShape, table: TableReader, rate: v.Vector, q: Any, qd: Any) -> StrainLine | None:
    """One direction only: angles add up, so the rotation is exact."""
    if shape.planar is None:
        return None
    axis = v.unit(shape.planar)
    angle: Any = 0.0
    speed: Any = 0.0
    slopes: list[Any] = [0.0] * shape.turning
    line = StrainLine()
    for interval, place in enumerate(shape.breaks):
        alphas = [table("alpha", interval * shape.turning + j) for j in range(shape.turning)]
        slopes = [slope + alpha for slope, alpha in zip(slopes, alphas, strict=True)]
        angle = angle + v.total([alpha * q[j] for j, alpha in enumerate(alphas)])
        speed = speed + v.total([alpha * qd[j] for j, alpha in enumerate(alphas)])
        turned = v.scale(speed, axis)
        state = SectionState(
            v.about(shape.planar, cos(angle), sin(angle)),
            v.add(rate, turned),
            v.cross(rate, turned),
            [v.scale(s, axis) for s in slopes],
        )
        _keep(line, place, state)
    return line


def _keep(line: StrainLine, place: tuple[str, int], state: SectionState) -> None:
    if place[0] == "point":
        line.points.append(state)
    else:
        line.others[place] = state


def _spatial_line(shape: StrainShape, table: TableReader, rate: v.Vector, q: Any, qd: Any) -> StrainLine:
    state = SectionState(v.identity(), rate, v.zero(), [v.zero() for _ in range(shape.turning)])
    line = StrainLine()
    for interval, place in enumerate(shape.breaks):
        state = _magnus_step(shape, table, interval, state, q, qd)
        _keep(line, place, state)
    return line


def _magnus_step(
    shape: StrainShape, table: TableReader, interval: int, old: SectionState, q: Any, qd: Any
) -> SectionState:
    """From one section to the next: rotation, angular velocity, its bias acceleration, and its columns."""
    n = shape.turning
    alpha = [table("alpha", interval * n + j) for j in range(n)]
    beta = [table("beta", interval * n + j) for j in range(n)]
    a, b = curvature_sums(shape, alpha, q), curvature_sums(shape, beta, q)
    if shape.curved:
        a = v.add(a, [table("rest", interval * 3 + c) for c in range(3)])
    ad, bd = curvature_sums(shape, alpha, qd), curvature_sums(shape, beta, qd)
    turn = v.add(a, v.cross(a, b))
    turn_rate = v.add(ad, v.cross(ad, b), v.cross(a, bd))
    turn_bias = v.scale(2, v.cross(ad, bd))
    turned = magnus_turn(old.rotation, old.rate, old.bias, turn, turn_rate, turn_bias)
    columns = _columns(shape, turned.spread, a, b, alpha, beta, old.columns)
    return SectionState(turned.rotation, turned.rate, turned.bias, columns)


class Turned(NamedTuple):
    """A section after a step; ``spread``: its angular velocity per rate of the rotation vector of the step."""

    rotation: v.Matrix
    rate: v.Vector
    bias: v.Vector
    spread: v.Matrix


def magnus_turn(
    rotation: v.Matrix, rate: v.Vector, bias: v.Vector, turn: v.Vector, turn_rate: v.Vector, turn_bias: v.Vector
) -> Turned:
    """Turn a section by the rotation vector ``turn`` in its own axes, with the first and second derivatives of it.

    ``bias``: its angular acceleration, without the part that ``turn_bias`` leaves out of the second derivative.
    """
    z = v.dot(turn, turn)
    f1, f2, f3 = (v.series(z, first, _TERMS) for first in (1, 2, 3))
    g2, g3 = (v.slope_of_series(z, first, _TERMS) for first in (2, 3))
    once = [v.cross(row, turn) for row in rotation]
    twice = [v.cross(row, turn) for row in once]
    spread = _mix(rotation, (f2, once), (f3, twice))
    gained = v.matvec(spread, turn_rate)
    c1 = v.cross(turn, turn_rate)
    inner = v.add(
        v.scale(2 * v.dot(turn, turn_rate), v.add(v.scale(g2, c1), v.scale(g3, v.cross(turn, c1)))),
        v.scale(f3, v.cross(turn_rate, c1)),
    )
    bias = v.add(bias, v.cross(rate, gained), v.matvec(rotation, inner), v.matvec(spread, turn_bias))
    return Turned(_mix(rotation, (f1, once), (f2, twice)), v.add(rate, gained), bias, spread)


def curvature_sums(shape: StrainShape, weights: list[Any], q: Any) -> v.Vector:
    """Sum of weight times coordinate for each component of curvature."""
    sums = v.zero()
    for j, direction in enumerate(shape.directions):
        sums[direction] = sums[direction] + weights[j] * q[j]
    return sums


def shifted(shape: StrainShape, weights: Any, rotation: v.Matrix, q: Any) -> list[tuple[Any, v.Vector]]:
    """Stretch and both shears, as far as the link has them: sum of weight times coordinate, and the section's axis.

    ``weights``: values of the functions that shift sections, at one place; ``q``: all coordinates of the link.
    """
    axes, found = v.transpose(rotation), []
    for axis in dict.fromkeys(shape.shifts):
        terms = [weights[j] * q[shape.turning + j] for j, own in enumerate(shape.shifts) if own == axis]
        found.append((v.total(terms), axes[axis]))
    return found


def shifted_line(shape: StrainShape, weights: Any, rotation: v.Matrix, q: Any) -> v.Vector:
    """Derivative of the line's position by x: the normal of the section, longer by the stretch, and both shears.

    r' = (1 + eps) t + gamma_y n_y + gamma_z n_z (E. Reissner, J. Appl. Math. Phys. 23, 1972; J. C. Simo, L. Vu-Quoc,
    Comput. Methods Appl. Mech. Eng. 58, 1986).
    """
    tangent = [row[0] for row in rotation]
    found = shifted(shape, weights, rotation, q)
    if not found:
        return tangent
    if shape.stretch:
        (longer, _), *found = found
        tangent = v.scale(1 + longer, tangent)
    return v.add(tangent, *(v.scale(shear, axis) for shear, axis in found)) if found else tangent


def _mix(base: v.Matrix, *terms: tuple[Any, v.Matrix]) -> v.Matrix:
    return [
        [v.total([base[i][j], *(factor * matrix[i][j] for factor, matrix in terms)]) for j in range(3)]
        for i in range(3)
    ]


def _columns(
    shape: StrainShape,
    spread: v.Matrix,
    a: v.Vector,
    b: v.Vector,
    alpha: list[Any],
    beta: list[Any],
    old: list[v.Vector],
) -> list[v.Vector]:
    """Angular velocity of the section per rate of each coordinate."""
    by_b = [v.sub(row, v.cross(row, b)) for row in spread]
    by_a = [v.cross(row, a) for row in spread]
    return [
        [old[j][i] + alpha[j] * by_b[i][c] + beta[j] * by_a[i][c] for i in range(3)]
        for j, c in enumerate(shape.directions)
    ]
