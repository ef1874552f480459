"""How thick a scene shows its links: by the sections of the data sheet, or by their stiffness and mass."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.kinds.links.section_given import SectionNumbers
from tmodes.kinds.links.sheet import BendingSheet
from tmodes.sheet import Robot

__all__ = ["section_of", "solid_bar"]

Array = NDArray[np.float64]

_METAL = 3.8e-8
"""Density over Young's modulus [kg/(m^3 Pa)] of steel (3.7e-8) and of aluminium (3.9e-8)."""


def solid_bar(about_y: float, about_z: float, mass: float, stations: int) -> dict[str, Any] | None:
    """The solid metal bar with these bending stiffnesses [N*m^2] and mass per length [kg/m], as a guess.

    Of a round bar EI/w = E/rho r^2/4, of a rectangle E/rho h^2/12. None where a stiffness is infinite.
    """
    if not (mass > 0 and all(math.isfinite(one) and one > 0 for one in (about_y, about_z))):
        return None
    if about_y == about_z:
        return _section("round", np.full((stations, 2), 2 * math.sqrt(about_y / mass * _METAL)), guessed=True)
    half = [math.sqrt(3 * stiffness / mass * _METAL) for stiffness in (about_z, about_y)]
    return _section("box", np.tile(half, (stations, 1)), guessed=True)


def section_of(arm: Robot, node: str, stations: Array) -> dict[str, Any] | None:
    """The section of the link that a node of the chain is of, at ``stations`` (S,) of the node; None if unknown."""
    name, _, number = node.rpartition(".")
    beams = {link.name: link.beam for link in arm.links}
    beam = beams.get(node)
    if beam is None and number.isdigit() and (beam := beams.get(name)) is not None:
        stations = beam.element_stations(int(number) - 1, stations)
    return _drawn(beam, stations) if beam else None


def _drawn(beam: BendingSheet, stations: Array) -> dict[str, Any] | None:
    if not beam.section_pieces():
        return None
    numbers = [_numbers_at(beam, float(place)) for place in stations]
    sizes = np.array([[one.outer_y, one.outer_z] for one in numbers])
    if sizes.min() > 0:
        return _section("round" if beam.is_round else "box", sizes, guessed=False)
    middle = numbers[len(numbers) // 2]
    return solid_bar(middle.bend_y, middle.bend_z, middle.mass, len(stations))


def _numbers_at(beam: BendingSheet, place: float) -> SectionNumbers:
    start = 0.0
    pieces = beam.section_pieces()
    for piece in pieces:
        if place <= piece.end or piece is pieces[-1]:
            share = (place - start) / (piece.end - start)
            mixed = (a if a == b else a + share * (b - a) for a, b in zip(piece.start, piece.stop, strict=True))
            return SectionNumbers(*mixed)
        start = piece.end
    raise AssertionError("a beam has pieces")


def _section(shape: str, sizes: Array, *, guessed: bool) -> dict[str, Any]:
    return {"shape": shape, "sizes": sizes.astype(np.float32), "guessed": guessed}
