"""A beam taken as rigid: mass, center and inertia of its unloaded line."""

from __future__ import annotations

import numpy as np

from tmodes.kinds.links.beam_data import BeamData
from tmodes.kinds.links.contract import Body
from tmodes.kinds.schema.axes import bent_line

__all__ = ["rigid_body"]


def rigid_body(beam: BeamData) -> Body:
    """The beam as one rigid body, in its root frame; the rotary inertia of its sections counts as the sheet says.

    Quadrature by 16 Gauss points in each of 4 parts of each piece: exact for a straight beam of any taper.
    """
    nodes, weights = np.polynomial.legendre.leggauss(16)
    masses, positions, inertia, start = [], [], np.zeros((3, 3)), 0.0
    for piece in beam.section_pieces():
        for part in range(4):
            share = (part + (1 + nodes) / 2) / 4
            for x, weight in zip(share, weights * (piece.end - start) * beam.length / 8, strict=True):
                rotation, position = bent_line(beam.rest_curvature, (start + x * (piece.end - start)) * beam.length)
                counted = beam.turning_axes
                own = np.diag([piece.at(f"inertia_{axis}", x) if axis in counted else 0.0 for axis in "xyz"])
                inertia += weight * rotation @ own @ rotation.T
                masses.append(weight * piece.at("mass", x))
                positions.append(position)
        start = piece.end
    mass, places = np.array(masses), np.array(positions)
    center = mass @ places / mass.sum()
    off = places - center
    spread = np.einsum("i,ij,ik->jk", mass, off, off)
    return Body(float(mass.sum()), center, inertia + np.trace(spread) * np.eye(3) - spread)
