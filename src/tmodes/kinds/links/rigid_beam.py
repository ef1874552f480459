"""A beam taken as rigid: mass, center and inertia of its unloaded line, as a whole and from its root to a place."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tmodes.frame import Placement
from tmodes.kinds.links.beam_data import BeamData
from tmodes.kinds.links.contract import Body
from tmodes.kinds.links.line import SAME
from tmodes.kinds.links.sheet import moved_body
from tmodes.kinds.noted.functions import maximum, minimum, number
from tmodes.kinds.schema.axes import bent_line

__all__ = ["RigidBeam", "rigid_body"]

Array = NDArray[np.float64]


def rigid_body(beam: BeamData, until: float = 1.0) -> Body:
    """The beam from its root to ``until`` (1: its tip) as one rigid body, in its root frame.

    The rotary inertia of its sections counts as the sheet says. Quadrature by 16 Gauss points in each of 4 parts of
    each piece: exact for a straight beam of any taper.
    """
    nodes, weights = np.polynomial.legendre.leggauss(16)
    masses, positions, inertia, start = [], [], np.zeros((3, 3)), 0.0
    for piece in beam.section_pieces():
        span = piece.end - start
        inside = minimum(maximum((until - start) / span, 0.0), 1.0)
        for part in range(4) if inside else ():
            share = (part + (1 + nodes) / 2) / 4 * inside
            for x, weight in zip(share, weights * span * beam.length / 8 * inside, strict=True):
                rotation, position = bent_line(beam.rest_curvature, (start + x * span) * beam.length)
                counted = beam.turning_axes
                own = np.diag([piece.at(f"inertia_{axis}", x) if axis in counted else 0.0 for axis in "xyz"])
                inertia = inertia + weight * rotation @ own @ rotation.T
                masses.append(weight * piece.at("mass", x))
                positions.append(position)
        start = piece.end
    if not masses:
        return Body(0.0, np.zeros(3), inertia)
    mass, places = np.array(masses), np.array(positions)
    center = mass @ places / mass.sum()
    off = places - center
    spread = np.einsum("i,ij,ik->jk", mass, off, off)
    return Body(number(mass.sum()), center, inertia + np.trace(spread) * np.eye(3) - spread)


@dataclass(frozen=True, eq=False)
class RigidBeam:
    """Where along a rigid link its mass is: ``root`` of the beam in the link's frame, bodies there by their station."""

    beam: BeamData
    root: Placement
    stations: tuple[tuple[float, Body], ...] = ()

    def seen_from(self, frame: Placement) -> RigidBeam:
        """The same where the link's frame stands at ``frame``."""
        stations = tuple((s, moved_body(body, frame)) for s, body in self.stations)
        return RigidBeam(self.beam, frame @ self.root, stations)

    def place(self, s: float) -> Placement:
        """The section at s."""
        return self.root @ Placement(*bent_line(self.beam.rest_curvature, s * self.beam.length))

    def inboard(self, s: float, *, beyond: bool) -> tuple[float, Array, Array]:
        """Mass, first moment (3,) and inertia (3, 3) about the link's frame of what is from the root to s.

        ``beyond``: with the bodies at s itself.
        """
        bodies = [moved_body(rigid_body(self.beam, s), self.root)]
        bodies += [body for at, body in self.stations if at < s - SAME or (beyond and at <= s + SAME)]
        first = sum((body.mass * body.center for body in bodies), np.zeros(3))
        inertia = np.zeros((3, 3))
        for body in bodies:
            inertia = (
                inertia
                + body.inertia
                + body.mass * (body.center @ body.center * np.eye(3) - np.outer(body.center, body.center))
            )
        return sum(body.mass for body in bodies), first, inertia
