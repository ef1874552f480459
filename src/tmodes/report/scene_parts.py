"""Parts of a scene: the robot rebuilt from its result, the surfaces of its rigid links, and how thick its links are."""

from __future__ import annotations

import math
from typing import Any
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from tmodes.chain.chain import Chain, line_before
from tmodes.errors import TmodesError
from tmodes.kinds.links.section_given import SectionNumbers
from tmodes.kinds.links.sheet import BendingSheet
from tmodes.model.model import Model
from tmodes.plot.facts import names_of
from tmodes.report.meshes import StoredMesh, kept_meshes
from tmodes.result import Result
from tmodes.sheet import Robot
from tmodes.sheet.topology import BASE

__all__ = ["Actual", "actual", "carriers", "meshes_in", "nearest_drawn", "section_of", "solid_bar"]


class Actual:
    """The robot that ran, from its stored data sheet, and its model.

    ``missing``: why it cannot be rebuilt in this process, such as a kind that is not registered; empty where it can.
    ``drawn``: the links of which the result has lines; ``names``: these, then links that are nothing but a surface.
    """

    def __init__(self, result: Result) -> None:
        self.missing, data = "", result.record
        self.drawn = names_of(data, "link")
        try:
            self.robot: Robot = result.actual
            self.model = Model(self.robot.chain())
            self.names = [*self.drawn, *carriers(data, self.model.chain, self.drawn)]
            _ = self.model.passes  # unknown equations are found here
        except TmodesError as error:
            self.missing, self.names = str(error), self.drawn


_KNOWN: WeakKeyDictionary[Result, Actual] = WeakKeyDictionary()


def actual(result: Result) -> Actual:
    """The same for the same result."""
    if result not in _KNOWN:
        _KNOWN[result] = Actual(result)
    return _KNOWN[result]


Array = NDArray[np.float64]


def carriers(data: Any, chain: Chain, drawn: list[str]) -> list[str]:
    """Rigid links without length, which no line draws, but that have a surface."""
    rigid = {node.name for node in chain.nodes if not node.link.bends}
    return [name for name in dict.fromkeys(mesh.link for mesh in kept_meshes(data)) if name in rigid - set(drawn)]


def nearest_drawn(chain: Chain, name: str, drawn: list[str]) -> int:
    """Index of the drawn link on which a link stands; -1 for the base."""
    parent = line_before(chain, name, drawn)
    return -1 if parent is None else drawn.index(parent)


def meshes_in(data: Any, robot: Robot, chain: Chain, shown: list[str]) -> list[dict[str, Any]]:
    """The surfaces of links among ``shown`` and of a base that stands.

    Of a link that bends in the frame of its root, ``along`` its line or those of its elements, which bend it; one that
    is curved at rest is swept instead.
    """
    rigid = [node.name for node in chain.nodes if not node.link.bends]
    found = []
    for mesh in kept_meshes(data):
        if mesh.link in shown and mesh.link in rigid:
            found.append(_surface(mesh, shown.index(mesh.link), mesh.vertices))
        elif along := [k for k, name in enumerate(shown) if name not in rigid and _is_of(name, mesh.link)]:
            if _is_curved(robot, mesh.link):
                continue
            found.append(_surface(mesh, along[0], _from_root(robot, mesh)) | {"along": along})
        elif mesh.link == BASE:
            found.append(_surface(mesh, -1, mesh.vertices @ chain.base.rotation.T + chain.base.position))
    return found


def _is_of(node: str, link: str) -> bool:
    """Whether a node of the chain is the link or one of its elements."""
    name, _, number = node.rpartition(".")
    return node == link or (name == link and number.isdigit())


def _is_curved(robot: Robot, name: str) -> bool:
    beams = [link.beam for link in robot.links if link.name == name]
    return any(np.any(getattr(beam, "rest_curvature", None) or 0.0) for beam in beams)


def _from_root(robot: Robot, mesh: StoredMesh) -> NDArray[Any]:
    """The vertices of a link's surface in the frame of its beam's root."""
    mounts = [getattr(link.beam, "root_mount", None) for link in robot.links if link.name == mesh.link]
    if not mounts or mounts[0] is None:
        return mesh.vertices
    return (mesh.vertices - np.asarray(mounts[0].position)) @ mounts[0].rotation()


def _surface(mesh: StoredMesh, link: int, vertices: NDArray[Any]) -> dict[str, Any]:
    return {"link": link, "colour": mesh.colour, "vertices": vertices.astype(np.float32), "faces": mesh.faces}


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


def section_of(robot: Robot, node: str, stations: Array) -> dict[str, Any] | None:
    """The section of the link that a node of the chain is of, at ``stations`` (S,) of the node; None if unknown."""
    name, _, number = node.rpartition(".")
    beams = {link.name: link.beam for link in robot.links}
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
