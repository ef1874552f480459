"""Where bodies inside a beam break its moments and forces, and the functions that have such breaks.

A body takes a force and a moment out of the beam: force and torque jump at its place, and the moment of bending has a
kink, and a jump too where the body resists turning. No polynomial follows: with polynomials alone frequencies converge
like n^-1, with one function of each break like those of a beam without the body.
"""

from __future__ import annotations

from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.kinds.links.beam_pieces import BeamNumbers, BeamPiece
from tmodes.kinds.links.facts import DIRECTIONS
from tmodes.kinds.noted.functions import array, by_size

__all__ = ["TURNING", "BreakFunction", "break_places", "breaks_of", "broken_pieces"]

Array = NDArray[np.float64]

TURNING = ("twist", "bend_y", "bend_z")
"""Directions that turn sections; the others only shift them."""

APART = 1e-3
"""Distance over the length from the ends, and from another body, below which a body has no functions of its own."""

MOST_BROKEN = 15
"""Functions that bodies inside a beam add at most, the heaviest first: the compiled code grows like their square."""


class BreakFunction(NamedTuple):
    """(1 - s/place)^degree inboard of ``place``, 0 outboard of it; the value at the place is the inner one."""

    place: float
    degree: int

    def values(self, s: ArrayLike) -> Array:
        """Its values, shape of s."""
        s = array(s)
        return np.where(s <= self.place, (1 - s / self.place) ** self.degree, 0.0)


class Break(NamedTuple):
    """A place inside that carries bodies of a ``mass``; whether any of them resists turning (``turns``)."""

    place: Any
    turns: bool
    mass: Any


@lru_cache(maxsize=64)
def break_places(beam: BeamNumbers) -> tuple[Break, ...]:
    """Places inside that carry bodies, from root to tip.

    Of many the heaviest, as far as :data:`MOST_BROKEN` allows.
    """
    found: list[Break] = []
    for s, body in sorted(beam.bodies, key=lambda one: one[0]):
        if not APART < s < 1 - APART:
            continue
        last = found.pop() if found and s - found[-1].place <= APART else Break(s, False, 0.0)
        turns = any(by_size(body.center)) or any(by_size(body.inertia)) or last.place != s
        found.append(Break(last.place, last.turns or turns, last.mass + body.mass))
    each = sum(2 if "bend" in name else 1 for name in DIRECTIONS if getattr(beam, name))
    most = MOST_BROKEN // max(each, 1)
    if len(found) <= most:
        return tuple(found)
    heaviest = sorted(range(len(found)), key=lambda k: found[k].mass, reverse=True)[:most]
    return tuple(found[k] for k in sorted(heaviest))


@lru_cache(maxsize=64)
def broken_pieces(beam: BeamNumbers) -> tuple[BeamPiece, ...]:
    """The pieces of a beam, cut where bodies inside break its moment: quadrature goes piece by piece."""
    found, start = [], 0.0
    for piece in beam.pieces:
        cuts = [each.place for each in break_places(beam) if start < each.place < piece.end]
        shares = [(place - start) / (piece.end - start) for place in (*cuts, piece.end)]
        found += [_part(piece, *part) for part in zip([0.0, *shares], shares, [*cuts, piece.end], strict=False)]
        start = piece.end
    return tuple(found) if break_places(beam) else beam.pieces


def _part(piece: BeamPiece, start: float, stop: float, end: float) -> BeamPiece:
    """What is between two shares of a piece."""

    def between(ends: tuple[float, float]) -> tuple[float, float]:
        first, last = ends
        return ends if first == last else (first + start * (last - first), first + stop * (last - first))

    changed: dict[str, Any] = {
        name: tuple(map(between, value)) if name == "inertia" else between(value)
        for name, value in vars(piece).items() if name != "end"
    }  # fmt: skip
    return BeamPiece(end=end, **changed)


def breaks_of(beam: BeamNumbers, direction: str) -> list[BreakFunction]:
    """Functions that bodies inside ask for in a direction; none where it has no others."""
    if not getattr(beam, direction):
        return []
    found = []
    for place, turns, _ in break_places(beam):
        if direction not in TURNING or "bend" not in direction:
            found += [BreakFunction(place, 0)] if turns or direction not in TURNING else []
        else:
            found += [BreakFunction(place, degree) for degree in ((1, 0) if turns else (1,))]
    return found
