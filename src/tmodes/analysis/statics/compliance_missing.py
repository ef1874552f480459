"""Directions in which an arm gives way only because its sheet leaves out how it would: they have no honest stiffness.

A link without functions of stretch gives along its line only as far as its sag has bent that line: an effect of second
order, far below the stretch that was left out. So has a link without functions of twist, against turning about it.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.line.line import elastic_line
from tmodes.analysis.statics.compliance import NOTHING, PointCompliance
from tmodes.analysis.statics.equilibrium import Equilibrium

__all__ = ["missing_functions"]

Array = NDArray[np.float64]

FIRST_ORDER = 1e-10
"""Compliance of the unloaded arm, over the largest of its kind, below which nothing gives to first order."""

BENT = (1e-2, 0.5)
"""Share of the largest compliance of travels, and of turns, from which a bent arm's own is reported all the same.

The stretch that is left out is some 1e-4 of bending or less; the twist that is left out is as large as bending.
"""

ACROSS = 1e-6
"""Travel per turn or stretch, over the largest, that is rounding."""


def missing_functions(rest: Equilibrium, found: PointCompliance, point: int = 0) -> list[str]:
    """For each of the six directions the kinds of functions (``stretch, twist``) that its stiffness would need.

    Empty where the arm gives to first order, where it is bent so far that what it gives counts, and where no link has
    left anything out.
    """
    first, now = _unloaded(rest, point), np.abs(np.diagonal(found.compliance))
    kinds = _kinds(rest, point)
    info = []
    for k in range(6):
        group = slice(0, 3) if k < 3 else slice(3, 6)
        gives = first[k] > FIRST_ORDER * first[group].max()
        counts = now[k] > max(BENT[k // 3] * now[group].max(), NOTHING)
        info.append("" if gives or counts else ", ".join(kinds[k]))
    return info


def _unloaded(rest: Equilibrium, point: int) -> Array:
    """The six compliances of the arm as it is without weight and loads, its gears and links unbent."""
    model, free = rest.model, rest.free
    q = rest.unloaded.copy()
    q[model.deformations] = 0.0
    if not len(free):
        return np.zeros(6)
    stiffness = model.stiffness(q, base=model.at_rest(gravity=0.0))[np.ix_(free, free)]
    jacobian = model.jacobian(q)[point][:, free]
    flow = np.linalg.lstsq(stiffness, jacobian.T, rcond=None)[0]
    return np.abs(np.einsum("dn,nd->d", jacobian, flow))


def _kinds(rest: Equilibrium, point: int) -> list[list[str]]:
    """For each direction the kinds of functions that some link lacks and that would let the point give that way."""
    model = rest.model
    q = rest.unloaded.copy()
    q[model.deformations] = 0.0
    place = model.pose(q)[0][point]
    found: list[set[str]] = [set() for _ in range(6)]
    outboard = _between(rest, point)
    for line in elastic_line(model, q, stations=[0.0, 1.0]).links.values():
        link = model.chain.nodes[line.node].link
        if line.node not in outboard or not link.bends:
            continue
        axes, arm = line.rotation[0, 0], place - line.position[0, 0]
        for name, axis in (("twist", 0), ("bend_y", 1), ("bend_z", 2)):
            if not link.functions[name]:
                _note(found, name, np.concatenate([np.cross(axes[:, axis], arm), line.length * axes[:, axis]]))
        if not link.functions["stretch"]:
            _note(found, "stretch", np.concatenate([line.length * axes[:, 0], np.zeros(3)]))
    order = ("stretch", "twist", "bend_y", "bend_z")
    return [[name for name in order if name in names] for names in found]


def _between(rest: Equilibrium, point: int) -> set[int]:
    """Nodes from the base to the point."""
    nodes, index = set(), rest.model.parts.points[point].node
    while index >= 0:
        nodes.add(index)
        index = rest.model.chain.nodes[index].parent
    return nodes


def _note(found: list[set[str]], name: str, moved: Array) -> None:
    for k in np.flatnonzero(np.abs(moved) > ACROSS * np.abs(moved).max()):
        found[int(k)].add(name)
