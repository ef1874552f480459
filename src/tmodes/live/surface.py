"""The surface that an arm touches: what a page draws of it, and how far its sliders go."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.sheet import Robot
from tmodes.sheet.contact import Ball, Plane, Wall

__all__ = ["steepest", "stretched_length", "surface_info", "surface_numbers"]


def surface_info(shape: Plane | Ball | Wall) -> dict[str, Any]:
    """As ``SceneContact.surface`` of ``web/src/contract.ts``; a wall is a plane."""
    match shape:
        case Plane():
            return {"kind": "plane", "position": list(shape.position), "normal": list(shape.normal)}
        case Ball():
            return {"kind": "ball", "center": list(shape.center), "radius": shape.radius, "inside": shape.inside}
    ahead = [float(np.cos(shape.heading)), float(np.sin(shape.heading)), 0.0]
    return {"kind": "plane", "position": [shape.distance * x for x in ahead], "normal": [-x for x in ahead]}


def surface_numbers(shape: Plane | Ball | Wall) -> NDArray[np.float64]:
    """What moves of it (4,) [m]: position or center, and the radius (a plane: 0)."""
    match shape:
        case Plane():
            place, radius = shape.position, 0.0
        case Ball():
            place, radius = shape.center, shape.radius
        case Wall():
            place, radius = surface_info(shape)["position"], 0.0
    return np.array([*place, radius], dtype=float)


def steepest(arm: Robot) -> int:
    """The axis of the world along which the normal of the plane that it touches is longest; -1: it touches none."""
    shape = arm.contact.shape if arm.contact else None
    return int(np.argmax(np.abs(shape.normal))) if isinstance(shape, Plane) else -1


def stretched_length(arm: Robot) -> float:
    """Length of all links and of what is between them [m]."""
    nodes = arm.chain().nodes
    between = sum(float(np.linalg.norm(node.joint.placement.position)) for node in nodes)
    return between + sum(getattr(node.link, "length", 0.0) for node in nodes)
