"""The surfaces of an arm's rigid links in a scene, and the links that are nothing but such a surface."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.chain.chain import Chain, line_before
from tmodes.report.meshes import Kept, kept_meshes
from tmodes.sheet.topology import BASE

__all__ = ["carriers", "meshes_in", "nearest_drawn"]

Array = NDArray[np.float64]


def carriers(data: Any, chain: Chain, drawn: list[str]) -> list[str]:
    """Rigid links without length, which no line draws, but that have a surface."""
    rigid = {node.name for node in chain.nodes if not node.link.bends}
    return [name for name in dict.fromkeys(mesh.link for mesh in kept_meshes(data)) if name in rigid - set(drawn)]


def nearest_drawn(chain: Chain, name: str, drawn: list[str]) -> int:
    """Index of the drawn link on which a link stands; -1 for the base."""
    parent = line_before(chain, name, drawn)
    return -1 if parent is None else drawn.index(parent)


def meshes_in(data: Any, chain: Chain, shown: list[str]) -> list[dict[str, Any]]:
    """The surfaces of rigid links among ``shown`` and of a base that stands; a link that bends is swept instead."""
    rigid = [node.name for node in chain.nodes if not node.link.bends]
    found = []
    for mesh in kept_meshes(data):
        if mesh.link in shown and mesh.link in rigid:
            found.append(_info(mesh, shown.index(mesh.link), mesh.vertices))
        elif mesh.link == BASE:
            found.append(_info(mesh, -1, mesh.vertices @ chain.base.rotation.T + chain.base.position))
    return found


def _info(mesh: Kept, link: int, vertices: NDArray[Any]) -> dict[str, Any]:
    return {"link": link, "colour": mesh.colour, "vertices": vertices.astype(np.float32), "faces": mesh.faces}
