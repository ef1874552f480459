"""How a robot gives way at a point: its compliance and stiffness, and which gear or link gives how much of it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.line.line import elastic_line
from tmodes.analysis.statics.equilibrium import Equilibrium
from tmodes.errors import SimulationError
from tmodes.model.model import Model

__all__ = [
    "DIRECTIONS",
    "LOADS",
    "PointCompliance",
    "SpringRows",
    "SpringStiffness",
    "missing_functions",
    "point_compliance",
    "spring_rows",
    "springs_of",
]  # fmt: skip

Array = NDArray[np.float64]

DIRECTIONS = ("x", "y", "z", "about x", "about y", "about z")
"""Of forces [N] and moments [N*m] in world axes."""

LOADS = "weight and loads"
"""The share of the loads themselves, which turn with the robot or pull at it as it turns: geometric stiffness."""

NOTHING = 1e-14
"""Compliance over the largest of its kind below which a direction does not give."""


@dataclass(frozen=True, eq=False)
class PointCompliance:
    """Travel and turn of a point per force and moment on it, in world axes, the driven coordinates held.

    ``compliance`` (6, 6) [m/N, rad/N, m/(N*m), rad/(N*m)]; ``by_element``: the same for each element, (6, 6), sums to
    the compliance; ``stiffness`` (6,): force per travel, or moment per turn, in each direction alone, infinite where
    nothing gives; ``stiffness_matrix`` (6, 6), None where some direction does not give.
    """

    point: str
    compliance: Array
    by_element: dict[str, Array]

    @property
    def stiffness(self) -> Array:
        """Force per travel [N/m] or moment per turn [N*m/rad] in each of the six directions alone."""
        own = np.diagonal(self.compliance)
        return np.array([1 / c if moves else np.inf for c, moves in zip(own, self._moves(), strict=True)])

    @property
    def stiffness_matrix(self) -> Array | None:
        """The inverse of the compliance; None where it has none."""
        scale = np.sqrt(np.abs(np.diagonal(self.compliance)))
        if not scale.all() or np.linalg.cond(self.compliance / np.outer(scale, scale)) > 1e12:
            return None
        return np.asarray(np.linalg.inv(self.compliance), dtype=float)

    def shares(self, direction: int) -> dict[str, float]:
        """Share of each element in the compliance of one direction; they sum to 1, none where nothing gives."""
        whole = self.compliance[direction, direction]
        if not self._moves()[direction]:
            return {}
        return {name: float(part[direction, direction] / whole) for name, part in self.by_element.items()}

    def _moves(self) -> list[bool]:
        own = np.abs(np.diagonal(self.compliance))
        largest = np.repeat([own[:3].max(), own[3:].max()], 3)
        return [bool(c > NOTHING * most) for c, most in zip(own, largest, strict=True)]


class SpringStiffness(NamedTuple):
    """One spring of a robot: its stiffness matrix (nq, nq) is left^T right, both (rows, nq) of few rows."""

    left: Array
    right: Array

    @property
    def matrix(self) -> Array:
        """The stiffness matrix (nq, nq)."""
        return self.left.T @ self.right

    def energy(self, shapes: Array) -> Array:
        """x^T K x of each column of shapes (nq, n), shape (n,)."""
        return np.asarray(np.einsum("rn,rn->n", self.left @ shapes, self.right @ shapes), dtype=float)


def springs_of(model: Model, q: Array) -> dict[str, SpringStiffness]:
    """Each spring of a robot about a pose: ``joint.gear``, ``joint.spring``, ``link.bend_y``, ``link.twist``, ...

    Together they are the slope of the elastic forces; the weight has no part in it.
    """
    elastic = model.stiffness(q, base=model.at_rest(gravity=0.0))
    found: dict[str, SpringStiffness] = {}
    rows = spring_rows(model)
    for name, (angle, number) in rows.parallel.items():
        left, stiffness = np.zeros((1, model.nq)), float(model.parameters[number])
        left[0, angle] = 1.0
        elastic[angle, angle] -= stiffness  # what is left is the gear's
        found[name] = SpringStiffness(left, stiffness * left)
    for name, angle in rows.gears.items():
        row = elastic[[angle]]
        own = row[0, angle]
        found[name] = SpringStiffness(row / own if own else np.zeros_like(row), row)
    for name, own in rows.links.items():
        left = np.zeros((len(own), model.nq))
        left[np.arange(len(own)), own] = 1.0
        found[name] = SpringStiffness(left, elastic[own])
    return found


class SpringRows(NamedTuple):
    """By the springs' names: the joint of each elastic gear, the coordinates of each kind of bending of a link.

    ``parallel``: of each parallel spring its joint, and the place of its stiffness in the model's parameters.
    """

    gears: dict[str, int]
    links: dict[str, list[int]]
    parallel: dict[str, tuple[int, int]]


def spring_rows(model: Model) -> SpringRows:
    """Where the springs of a robot act."""
    gears = {f"{axis.axis.name}.gear": axis.angle for axis in model.parts.axes if axis.drive and axis.drive.ranges}
    parallel = {
        f"{axis.axis.name}.spring": (axis.angle, axis.drive_numbers.start + axis.drive.spring_start)
        for axis in model.parts.axes
        if axis.drive and axis.drive_numbers and axis.drive.spring
    }
    links: dict[str, list[int]] = {}
    for k in model.deformations:
        links.setdefault(model.coordinates[k].rstrip("0123456789"), []).append(int(k))
    return SpringRows(gears, links, parallel)


def point_compliance(rest: Equilibrium, point: int = 0) -> PointCompliance:
    """Compliance of a point (its index) of a robot at rest, by its tangent, and each element's part of it.

    With u = K^-1 J^T, C = J u = u^T K u, and K is the sum of the elements' stiffness and that of the loads: the parts
    u^T K_e u are, without loads, J_e K_e^-1 J_e^T of springs in a row. Raises :class:`SimulationError` where a free
    coordinate has no stiffness.
    """
    model, free = rest.model, rest.free
    tangent = rest.matrices[2][np.ix_(free, free)]
    jacobian = model.jacobian(rest.q)[point][:, free]
    try:
        flow = np.linalg.solve(tangent, jacobian.T)
    except np.linalg.LinAlgError:
        raise SimulationError(
            "compliance: the robot moves without force; hold the loose joint, or lower the load that buckles it"
        ) from None
    springs = springs_of(model, rest.q)
    parts = {name: (one.left[:, free] @ flow).T @ (one.right[:, free] @ flow) for name, one in springs.items()}
    compliance = flow.T @ tangent @ flow
    parts[LOADS] = compliance - np.sum([*parts.values()], axis=0) if parts else compliance
    return PointCompliance(model.parts.points[point].name, compliance, parts)


FIRST_ORDER = 1e-10
"""Compliance of the unloaded robot, over the largest of its kind, below which nothing gives to first order."""

BENT = (1e-2, 0.5)
"""Share of the largest compliance of travels, and of turns, from which a bent robot's own is reported all the same.

The stretch that is left out is some 1e-4 of bending or less; the twist that is left out is as large as bending.
"""

ACROSS = 1e-6
"""Travel per turn or stretch, over the largest, that is rounding."""


def missing_functions(rest: Equilibrium, found: PointCompliance, point: int = 0) -> list[str]:
    """For each of the six directions the kinds of functions (``stretch, twist``) that its stiffness would need.

    Empty where the robot gives to first order, where it is bent so far that what it gives counts, and where no link has
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


def _unbent(rest: Equilibrium) -> Array:
    """The pose (nq,) without weight and loads, no link bent."""
    q = rest.unloaded.copy()
    q[rest.model.deformations] = 0.0
    return q


def _unloaded(rest: Equilibrium, point: int) -> Array:
    """The six compliances of the robot as it is without weight and loads, its gears and links unbent."""
    model, free = rest.model, rest.free
    q = _unbent(rest)
    if not len(free):
        return np.zeros(6)
    stiffness = model.stiffness(q, base=model.at_rest(gravity=0.0))[np.ix_(free, free)]
    jacobian = model.jacobian(q)[point][:, free]
    flow = np.linalg.lstsq(stiffness, jacobian.T, rcond=None)[0]
    return np.abs(np.einsum("dn,nd->d", jacobian, flow))


def _kinds(rest: Equilibrium, point: int) -> list[list[str]]:
    """For each direction the kinds of functions that some link lacks and that would let the point give that way."""
    model = rest.model
    q = _unbent(rest)
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
