"""What a page must know of the loads along a robot's links: at which places, and what they are compared with."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.validity import yield_strength
from tmodes.chain.chain import Chain
from tmodes.equations.line.schedule import ROOTS, Lines
from tmodes.equations.loop.plan import LoopPlan
from tmodes.equations.recursion.parts import Parts
from tmodes.kinds.joints.joint import Limits
from tmodes.kinds.links.line import layout
from tmodes.sheet import Robot

__all__ = ["evenly", "joint_limits", "line_lengths", "line_names", "lines_info", "load_places", "yield_strengths"]

Array = NDArray[np.float64]

_MOST_PLACES = 101
"""Places along each link at which a page looks for the largest loads; of more a part is taken."""

_ROUNDING = 1e-15


def evenly(count: int, most: int) -> NDArray[np.intp]:
    """At most so many of ``count`` places in a row, the first and the last among them."""
    return np.unique(np.linspace(0, count - 1, min(count, most)).round().astype(np.intp))


def load_places(line_points: int) -> Array:
    """Places along each link (0 root, 1 tip) at which loads are shown: those of the result, or a part of them."""
    return np.linspace(0.0, 1.0, line_points)[evenly(line_points, _MOST_PLACES)]


def line_names(lines: Lines) -> list[str]:
    """Names of the lines of all links, those of rigid links among them."""
    return [name for name in lines.schedule.outputs if name != ROOTS]


def line_lengths(lines: Lines) -> Array:
    """Lengths [m] of the lines of the links that bend."""
    return np.array([line.length for link in lines.links for line in link])


def lines_info(lines: Lines, chain: Chain) -> list[dict[str, Any]]:
    """Each line of a link that bends: its name, how many numbers a place has, and where each quantity stands."""
    found = []
    for node, link in zip(chain.nodes, lines.links, strict=True):
        for line in link:
            at = {name: [part.start, part.stop] for name, part in layout(stressed=line.stressed).items()}
            width = max(stop for _, stop in at.values())
            found.append({"name": node.name + line.suffix, "width": width, "at": at})
    return found


def yield_strengths(arm: Robot, lines: Iterable[str]) -> dict[str, float]:
    """Yield strength [Pa] of the lines of bending links, by name, where it is known."""
    found = {name: yield_strength(arm, name) for name in lines}
    return {name: strength for name, strength in found.items() if strength is not None}


def joint_limits(arm: Robot, plan: LoopPlan, parts: Parts) -> list[dict[str, Any]]:
    """Limits of the joints, of which :func:`tmodes.report.run_facts.run_facts` gives the largest share.

    Where in coordinates and drives (-1: none) each joint is, with its units; what is not limited is None.
    """
    drives = [drive.joint for drive in plan.drives]
    sliding = plan.chain.sliding
    return [
        {
            "joint": name, "coordinate": parts.names.index(name),
            "drive": drives.index(name) if name in drives else -1,
            "unit": "m" if name in sliding else "rad", "effortUnit": "N" if name in sliding else "N m",
            "speed": joint.limits.speed, "effort": joint.limits.effort, "range": _range(joint.limits),
        }
        for joint in arm.joints
        for name in joint.coordinates
        if joint.limits and name in parts.names
    ]  # fmt: skip


def _range(limits: Limits) -> list[float] | None:
    """Middle and half width of a range; None where there is none."""
    if limits.lower is None or limits.upper is None or limits.upper <= limits.lower + _ROUNDING:
        return None
    return [(limits.upper + limits.lower) / 2, (limits.upper - limits.lower) / 2]
