"""The inner forces of a beam that does not bend: those of its root, and what its part up to a place needs to move."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.equations.line.schedule import MOVING, RIGID
from tmodes.kinds.links.line import SAME
from tmodes.model.model import Model

__all__ = ["inner_forces"]

Array = NDArray[np.float64]


def inner_forces(
    model: Model, index: int, s: Array, rows: Array, roots: Array, wrenches: Array | None
) -> tuple[Array, Array, Array, Array]:
    """Of a node's rigid beam at the places ``s`` (S,), for n samples.

    ``rows`` (n, 27): what the schedule gives of the node; ``roots`` (n, 6 nodes): loads of all roots; ``wrenches``
    (n, points, 6) on the points. Returns position (n, S, 3) and rotation (n, S, 3, 3) in the world, and the load of the
    outboard part on the inboard one in section axes: moment (n, S, 3) and force (n, S, 3), tension positive.

    The part from the root to s moves as one rigid body: it needs m a + alpha x c + omega x (omega x c), with m, c and J
    about the link's frame. What its root gives and it does not need is the load at s. Joints hang on the tip.
    """
    beam: Any = model.chain.nodes[index].link.mass_line
    axes, start = rows[:, RIGID["rotation"]].reshape(-1, 3, 3), rows[:, RIGID["position"]]
    place, rate, turning, acceleration = (rows[:, part] for part in MOVING.values())
    arm = start - place
    own = acceleration + np.cross(turning, arm) + np.cross(rate, np.cross(rate, arm))
    loads = roots.reshape(len(rows), -1, 6)
    others = _pushed(model, index, wrenches, axes, len(rows))
    found: list[list[Array]] = [[], [], [], []]
    for place_s, beyond in zip(s.tolist(), _beyond(s), strict=True):
        mass, first, inertia = beam.inboard(place_s, beyond=beyond)
        lever, tensor = axes @ first, axes @ inertia @ axes.swapaxes(1, 2)
        spun = (tensor @ rate[..., None])[..., 0]
        force = mass * own + np.cross(turning, lever) + np.cross(rate, np.cross(rate, lever))
        moment = np.cross(lever, own) + (tensor @ turning[..., None])[..., 0] + np.cross(rate, spun)
        force, moment = loads[:, index, :3] + force, loads[:, index, 3:] + moment
        for station, pull, turn in others:
            if station < place_s - SAME or (beyond and station <= place_s + SAME):
                force, moment = force - pull, moment - turn
        section = beam.place(place_s)
        reach = axes @ section.position
        about, rotation = moment - np.cross(reach, force), axes @ section.rotation
        found[0].append(start + reach)
        found[1].append(rotation)
        for values, vector in zip(found[2:], (about, force), strict=True):
            values.append((rotation.swapaxes(1, 2) @ vector[..., None])[..., 0])
    position, rotation, moment, force = (np.stack(values, axis=1) for values in found)
    return position, rotation, moment, force


def _beyond(s: Array) -> list[bool]:
    """Whether a place bears what is fixed at itself already: the root, and the second of two that are the same."""
    return [bool(here <= SAME or again) for here, again in zip(s, np.diff(s, prepend=-1.0) < SAME, strict=True)]


def _station(beam: Any, position: Array) -> float:
    """The place along the beam that is nearest to one in the link's frame."""
    grid = np.linspace(0.0, 1.0, 1001)
    chord = beam.place(1.0).position - beam.root.position
    if not any(beam.beam.rest_curvature):
        return float(np.clip((position - beam.root.position) @ chord / (chord @ chord), 0.0, 1.0))
    return float(grid[np.argmin([np.linalg.norm(beam.place(each).position - position) for each in grid])])


Load = tuple[float, Array, Array]
"""Station, force (n, 3) [N] and moment (n, 3) about the link's frame [N*m], in the world."""


def _pushed(model: Model, index: int, wrenches: Array | None, axes: Array, count: int) -> list[Load]:
    """Loads on the points of the link, each at the place of the beam that is nearest."""
    if wrenches is None:
        return []
    beam, found = model.chain.nodes[index].link.mass_line, []
    forces = np.broadcast_to(wrenches, (count, *wrenches.shape[-2:]))
    for number, point in enumerate(model.parts.points):
        if point.node == index:
            position = point.offset.position
            force, moment = forces[:, number, :3], forces[:, number, 3:]
            found.append((_station(beam, position), force, moment + np.cross(axes @ position, force)))
    return found
