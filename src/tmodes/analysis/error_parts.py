"""What the error of a tip is made of: controller, gears and links, by exact substitution of coordinates.

Four shapes of one robot: where its drives should be and straight; where its motors are and straight; joints where they
are behind their gears, links straight; as it is. Each part of the error is the step of the tip from one shape to the
next, so that the parts add up to the whole, however large they are.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.analysis.quasistatic import deflections, gear_inputs, sprung
from tmodes.model.model import Model

__all__ = [
    "FREE",
    "PARTS",
    "element_places",
    "element_steps",
    "straight",
    "substitutions",
    "tips",
    "without_elasticity",
]

Array = NDArray[np.float64]

PARTS = ("controller", "gears", "links")
"""The parts: drives off their setpoints; deflection of the gears, and joints that are free; bending of the links."""

FREE = "free joints"
"""Joints with neither a drive nor a gear nor a spring, whose motion is with that of the gears."""


def without_elasticity(model: Model, q: Array) -> Array:
    """Coordinates (n, nq) of the robot at ``q`` without any elasticity, its motors where they are."""
    joints, away = sprung(model), deflections(model, q)
    straight = np.array(q, dtype=away.dtype)
    straight[:, joints] -= away[:, : len(joints)]
    straight[:, model.deformations] = 0.0
    return straight


def straight(model: Model, q: ArrayLike) -> Array:
    """Coordinates (n, nq) with joints where their gears' inputs are, and links that are not bent."""
    shape = np.array(np.atleast_2d(np.asarray(q, dtype=float)))
    shape[:, sprung(model)] = gear_inputs(model, shape, rest=True)
    shape[:, model.deformations] = 0.0
    return shape


def substitutions(model: Model, q: ArrayLike, commanded: ArrayLike, driven: Sequence[int]) -> list[Array]:
    """The four shapes (n, nq), from the commanded one to ``q``.

    ``commanded`` (n, nq): its coordinates ``driven`` are setpoints; those of joints without a drive are where they
    should be; those of gears and links are not looked at.
    """
    actual = np.atleast_2d(np.asarray(q, dtype=float))
    wanted = np.atleast_2d(np.asarray(commanded, dtype=float))
    moved = wanted.copy()
    moved[:, list(driven)] = actual[:, list(driven)]
    joints = actual.copy()
    joints[:, model.deformations] = 0.0
    return [straight(model, wanted), straight(model, moved), joints, actual]


def element_places(model: Model) -> list[tuple[str, str, list[int]]]:
    """Part (``gears``, ``free joints``, ``links``), name and coordinates of each joint, then link, by the chain."""
    places = [
        ("gears" if axis.axis.element else FREE, axis.axis.name, [axis.angle])
        for axis in model.parts.axes if not (axis.axis.drive.is_driven and axis.input == axis.angle)
    ]  # fmt: skip
    links = [(one.node.name, [*range(model.nq)[one.link.own]]) for one in model.parts.nodes if one.link]
    return places + [("links", name, own) for name, own in links if own]


def element_steps(model: Model, straightened: Array, actual: Array) -> tuple[list[tuple[str, str]], list[Array]]:
    """The steps from the second shape of :func:`substitutions` to the last, one joint, then one link at a time.

    Part and name of each as of :func:`element_places`, and the shapes (n, nq) that they lead to.
    """
    names, shapes, shape = [], [], straightened
    for part, name, own in element_places(model):
        shape = shape.copy()
        shape[:, own] = actual[:, own]
        names.append((part, name))
        shapes.append(shape)
    return names, shapes


def tips(model: Model, shapes: Sequence[Array], base: Array | None = None) -> Array:
    """The tip (the first named point) in each shape, (shapes, n, 3) [m]; ``base`` (n, 24) as of the model."""
    return np.stack([model.points(shape, base=base).position[:, 0] for shape in shapes])
