"""Boxes, cylinders and spheres as triangles, centred as URDF means them."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from tmodes.io.mesh_file import Triangles

__all__ = ["box", "cylinder", "sphere"]

_AROUND = 32
_DOWN = 16


def box(sizes: ArrayLike) -> Triangles:
    """A box of the sizes (3,) along x, y and z."""
    corners = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]) * np.asarray(sizes) / 2
    sides = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return Triangles(corners, np.array([face for a, b, c, d in sides for face in ((a, b, c), (a, c, d))]))


def cylinder(radius: float, length: float) -> Triangles:
    """A cylinder along z."""
    return _turned(np.array([0, radius, radius, 0.0]), np.array([-1, -1, 1, 1]) * length / 2)


def sphere(radius: float) -> Triangles:
    """A sphere."""
    down = np.linspace(np.pi, 0, _DOWN + 1)
    return _turned(radius * np.sin(down), radius * np.cos(down))


def _turned(radii: np.ndarray, heights: np.ndarray) -> Triangles:
    """The surface of a profile that turns about z, from below to above."""
    angle = 2 * np.pi * np.arange(_AROUND) / _AROUND
    rings = [np.column_stack([r * np.cos(angle), r * np.sin(angle), np.full(_AROUND, z)]) for r, z in
             zip(radii, heights, strict=True)]  # fmt: skip
    here = np.arange(_AROUND)
    after = np.roll(here, -1)
    faces = []
    for k in range(len(radii) - 1):
        low, high = k * _AROUND, (k + 1) * _AROUND
        faces += [np.column_stack([low + here, low + after, high + here]),
                  np.column_stack([low + after, high + after, high + here])]  # fmt: skip
    return Triangles(np.concatenate(rings), np.concatenate(faces))
