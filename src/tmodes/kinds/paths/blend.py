"""Straight lines through points, with corners that are rounded so that the curvature is continuous."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.errors import InputError
from tmodes.kinds.paths.contract import Course, Way

__all__ = ["lines"]

Array = NDArray[np.float64]

_NODES = 24
"""Nodes of Gauss in each half of a corner: its length to 1e-12 of itself."""

_SHARP = np.deg2rad(179.0)
"""A corner that turns by more goes back on itself."""


def lines(places: Sequence[Any], blend: float, **more: Any) -> Course:
    """The course through ``places`` (k, d), whose corners begin and end ``blend`` before and after them.

    A corner is a polynomial of degree 5 whose curvature is zero at both ends (Bezier's control points: three on each
    line); of neighbouring corners each has at most half of the line between them.

    Raises :class:`tmodes.errors.InputError` for two points at one place, and corners that go back.
    """
    points = [np.asarray(place, dtype=np.float64) for place in places]
    ways = [b - a for a, b in pairwise(points)]
    lengths = [float(np.linalg.norm(way)) for way in ways]
    if not all(length > 0 for length in lengths):
        at = next(k for k, length in enumerate(lengths) if not length > 0)
        raise InputError("path", f"point {at + 1} where the one before it is", "another place", "leave it out")
    units = [way / length for way, length in zip(ways, lengths, strict=True)]
    pieces: list[tuple[float, Any]] = []
    begin = 0.0
    for k, (unit, length) in enumerate(zip(units, lengths, strict=True)):
        last = k == len(units) - 1
        cut = 0.0 if last or blend <= 0 else min(blend, length / 2, lengths[k + 1] / 2)
        if not last and cut and np.dot(unit, units[k + 1]) < np.cos(_SHARP):
            hint = "leave out `blend`, or give a point next to it"
            raise InputError("path", f"a corner at point {k + 1} that goes back", "corners of less than 179 deg", hint)
        straight = length - begin - cut
        if straight > 1e-12 * length:
            pieces.append((straight, partial(_straight, points[k] + begin * unit, unit)))
        if cut:
            control = [points[k + 1] + (share - 1) * cut * unit for share in (0.0, 0.5, 0.9)]
            control += [points[k + 1] + (1 - share) * cut * units[k + 1] for share in (0.9, 0.5, 0.0)]
            corner = _Corner(np.array(control))
            pieces.append((corner.length, corner.at))
        begin = cut
    ends = np.cumsum([length for length, _ in pieces])
    knots = tuple(ends[:-1].tolist())
    return Course(float(ends[-1]), partial(_on, [way for _, way in pieces], ends), knots=knots, **more)


def _straight(start: Array, unit: Array, way: float) -> Way:
    return Way(start + way * unit, unit, np.zeros(len(unit)))


def _on(ways: Sequence[Any], ends: Array, way: float) -> Way:
    k = min(int(np.searchsorted(ends, way, side="right")), len(ways) - 1)
    return ways[k](way - (ends[k - 1] if k else 0.0))


class _Corner:
    """A polynomial of degree 5 by its control points (6, d), as a course of its length."""

    def __init__(self, control: Array) -> None:
        from scipy.interpolate import BPoly

        self.curve = BPoly(control[:, None, :], [0.0, 1.0])
        self.slopes = [self.curve.derivative(order) for order in (1, 2)]
        nodes, self.weights = np.polynomial.legendre.leggauss(_NODES)
        self.nodes = (nodes + 1) / 2
        self.half = self._length(0.5)
        self.length = self.half + self._length(1.0, 0.5)

    def _length(self, end: float, start: float = 0.0) -> float:
        speeds = np.linalg.norm(self.slopes[0](start + (end - start) * self.nodes), axis=1)
        return float(self.weights @ speeds) * (end - start) / 2

    def at(self, way: float) -> Way:
        """By Newton's method on the length."""
        place = min(max(way / self.length, 0.0), 1.0)
        for _ in range(50):
            known = self._length(place) if place <= 0.5 else self.half + self._length(place, 0.5)
            speed = float(np.linalg.norm(self.slopes[0](place)))
            step = (known - way) / speed
            place = min(max(place - step, 0.0), 1.0)
            if abs(step) < 1e-15:
                break
        first, second = (slope(place) for slope in self.slopes)
        speed = np.linalg.norm(first)
        slope = first / speed
        return Way(self.curve(place), slope, (second - slope * np.dot(slope, second)) / speed**2)
