"""How far a robot reaches, and so how far the sliders of what it touches go."""

from __future__ import annotations

import numpy as np

from tmodes.sheet import Robot

__all__ = ["stretched_length"]


def stretched_length(arm: Robot) -> float:
    """Length of all links and of what is between them [m]."""
    nodes = arm.chain().nodes
    between = sum(float(np.linalg.norm(node.joint.placement.position)) for node in nodes)
    return between + sum(getattr(node.link, "length", 0.0) for node in nodes)
