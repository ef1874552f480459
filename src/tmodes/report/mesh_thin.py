"""Surfaces with fewer triangles: all vertices of a cell of a grid become one (Rossignac and Borrel 1993)."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tmodes.io.mesh_file import Triangles

__all__ = ["thinned"]

_FIRST, _STEP, _ROUNDS = 200, 0.8, 24
"""Cells along the longest side at first, and by which factor they get fewer until there are few enough triangles."""


def thinned(surface: Triangles, most: int) -> Triangles:
    """A surface of at most ``most`` triangles, or the coarsest of a few tries; triangles without area are dropped."""
    surface = _clustered(surface, 1e9)
    cells = float(_FIRST)
    found = surface
    for _ in range(_ROUNDS):
        if len(found.faces) <= most:
            return found
        found = _clustered(surface, cells)
        cells *= _STEP
    return found


def _clustered(surface: Triangles, cells: float) -> Triangles:
    low, size = surface.vertices.min(axis=0), np.ptp(surface.vertices, axis=0).max()
    if size == 0:
        return Triangles(surface.vertices[:1], np.zeros((0, 3), dtype=np.intp))
    keys = np.floor((surface.vertices - low) / size * cells).astype(np.int64)
    cell = _ranks(keys)
    count = np.bincount(cell)
    means = np.column_stack([np.bincount(cell, surface.vertices[:, k]) for k in range(3)]) / count[:, None]
    faces = cell[surface.faces]
    a, b, c = faces.T
    faces = faces[(a != b) & (b != c) & (c != a)]
    least = np.argmin(faces, axis=1)
    turned = faces[np.arange(len(faces))[:, None], (least[:, None] + np.arange(3)) % 3]
    faces = turned[np.unique(_ranks(turned), return_index=True)[1]]
    used, places = np.unique(faces, return_inverse=True)
    return Triangles(means[used], places.reshape(-1, 3))


def _ranks(rows: NDArray[np.intp]) -> NDArray[np.intp]:
    """The place of each row among the different ones in their order; equal rows have the same.

    As the inverse of ``np.unique(rows, axis=0)``, which compares whole rows and takes many times as long.
    """
    rank = np.zeros(len(rows), dtype=np.int64)
    for column in rows.T:
        values, own = np.unique(column, return_inverse=True)
        rank = np.unique(rank * len(values) + own, return_inverse=True)[1]
    return rank
