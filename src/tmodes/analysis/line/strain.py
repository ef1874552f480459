"""Motion of a strain link's sections for many samples: the steps of the model, in its root's axes, in NumPy."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.line.tables import Interval, LineTables
from tmodes.analysis.line.vectors import across, applied, cross
from tmodes.kinds.kernel.vectors import series, slope_of_series

__all__ = ["PLANAR_TERMS", "TERMS", "Sections", "StrainMotion", "strain_motion"]

Array = NDArray[np.float64]

TERMS = 8
"""Terms of the series of the rotation in space: those of the compiled model."""

PLANAR_TERMS = 24
"""Terms where the line stays in a plane, where the model turns exactly."""


@dataclass(frozen=True, eq=False)
class Sections:
    """Sections in the axes of the link's root, (n, S, ...): rotation, position [m], rate, and accelerations.

    ``turning`` [rad/s^2] and ``acceleration`` [m/s^2] are all there is, less gravity.
    """

    rotation: Array
    position: Array
    rate: Array
    turning: Array
    acceleration: Array


@dataclass(frozen=True, eq=False)
class StrainMotion:
    """Sections at the Gauss points and at the told places."""

    points: Sections
    places: Sections


@dataclass(frozen=True, eq=False)
class _Turned:
    rotation: Array
    rate: Array
    turning: Array


def strain_motion(tables: LineTables, root: tuple[Array, Array, Array], q: Array, v: Array, a: Array) -> StrainMotion:
    """Sections of a strain link; ``root``: rate, angular acceleration and acceleration of its root, in its axes.

    ``q``, ``v``, ``a`` (n, size) are the link's coordinates with their rates and accelerations.
    """
    rate, turning, acceleration = root
    turns = tables.own.shape.turning
    states = [_Turned(np.broadcast_to(np.eye(3), (len(q), 3, 3)), rate, turning)]
    coordinates = (q[:, :turns], v[:, :turns], a[:, :turns])
    for k in range(len(tables.edges) - 1):
        states.append(_step(tables, _one(tables.march, k), states[-1], coordinates))
    here = _many(tables, states, coordinates)
    at_points = [states[k + 1] for k, (kind, _) in enumerate(tables.own.shape.breaks) if kind == "point"]
    points = _Turned(*(np.stack([getattr(state, name) for state in at_points], axis=1) for name in _NAMES))
    line, moved = _tangents(tables, points, q, v, a)
    return StrainMotion(
        _placed(points, tables.to_points, line, moved, acceleration),
        _placed(here, tables.to_places, line, moved, acceleration),
    )


_NAMES = ("rotation", "rate", "turning")


def _one(steps: Interval, k: int) -> Interval:
    return Interval(steps.alpha[k], steps.beta[k], steps.rest[k])


def _many(tables: LineTables, states: list[_Turned], coordinates: tuple[Array, Array, Array]) -> _Turned:
    """The told places, each by a step from the section of the model before it."""
    before = _Turned(*(np.stack([getattr(states[k], name) for k in tables.before], axis=1) for name in _NAMES))
    return _step(tables, tables.reach, before, tuple(part[:, None] for part in coordinates))


def _step(tables: LineTables, steps: Interval, old: _Turned, coordinates: tuple[Array, ...]) -> _Turned:
    """The fourth-order Magnus step with its first and second derivative by time."""
    sums = [steps.alpha[..., None] * tables.directions, steps.beta[..., None] * tables.directions]
    (a, b), (ad, bd), (add, bdd) = (
        tuple((part[..., None] * weights).sum(axis=-2) for weights in sums) for part in coordinates
    )
    a = a + steps.rest
    turn = a + cross(a, b)
    speed = ad + cross(ad, b) + cross(a, bd)
    gain = add + cross(add, b) + cross(a, bdd) + 2 * cross(ad, bd)
    terms = TERMS if tables.own.shape.planar is None else PLANAR_TERMS
    z = (turn * turn).sum(axis=-1)
    f1, f2, f3 = (series(z, first, terms)[..., None, None] for first in (1, 2, 3))
    once = across(old.rotation, turn)
    twice = across(once, turn)
    spread = old.rotation + f2 * once + f3 * twice
    gained = applied(spread, speed)
    twisted = cross(turn, speed)
    g2, g3 = (slope_of_series(z, first, terms)[..., None] for first in (2, 3))
    along = 2 * (turn * speed).sum(axis=-1)[..., None]
    inner = along * (g2 * twisted + g3 * cross(turn, twisted)) + f3[..., 0] * cross(speed, twisted)
    turning = old.turning + cross(old.rate, gained) + applied(old.rotation, inner) + applied(spread, gain)
    return _Turned(old.rotation + f1 * once + f2 * twice, old.rate + gained, turning)


def _tangents(tables: LineTables, points: _Turned, q: Array, v: Array, a: Array) -> tuple[Array, Array]:
    """Derivative of the position by x at the Gauss points, and its second derivative by time, (n, g, 3)."""
    tangent, turns = points.rotation[..., 0], tables.own.shape.turning
    longer, speed, gain = (part[:, turns:] @ tables.stretch.T for part in (q, v, a))
    line = (1 + longer)[..., None] * tangent
    spin = cross(points.rate, cross(points.rate, line))
    stretched = 2 * speed[..., None] * cross(points.rate, tangent) + gain[..., None] * tangent
    return line, cross(points.turning, line) + spin + stretched


def _placed(turned: _Turned, weights: Array, line: Array, moved: Array, acceleration: Array) -> Sections:
    return Sections(
        turned.rotation, weights @ line, turned.rate, turned.turning, acceleration[:, None] + weights @ moved
    )
