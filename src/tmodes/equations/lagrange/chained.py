"""A system on a chain: names of coordinates and points brought together, and the numbers that the kernels read."""

from __future__ import annotations

from typing import Any

import numpy as np

from tmodes.equations.lagrange.kernels import SystemKernels
from tmodes.equations.lagrange.system import System
from tmodes.equations.recursion.hinge import PLACEMENT
from tmodes.equations.recursion.parts import Parts
from tmodes.equations.recursion.passes import Blocks
from tmodes.errors import InputError
from tmodes.kinds.kernel.schedule import Divisible, Slot

__all__ = ["ChainedSystem"]


class ChainedSystem:
    """A system on a chain: which coordinate is which, which point is which, and its parameters."""

    def __init__(self, system: System, parts: Parts) -> None:
        """Raises :class:`tmodes.errors.InputError` where chain and system do not belong together."""
        self.system, self.parts = system, parts
        self.kernels = SystemKernels(system, _columns(system, parts))
        self.held = tuple(index - parts.joints.start for index in parts.held)
        gravity = np.asarray(parts.chain.gravity, dtype=float)
        square = float(gravity @ gravity)
        block = parts.numbers.block
        self.parameters = block(system.values(parts.chain))
        self.unit = block(gravity / square if square else gravity)
        self.straight = block([*np.eye(3).ravel(), *np.zeros(PLACEMENT - 9)])
        self.none = block(np.zeros(self.kernels.own))
        self.points = _points(system, parts)
        placed = parts.chain.base
        if not (np.allclose(placed.rotation, np.eye(3)) and np.allclose(placed.position, 0)):
            expected = f"left out: the system `{system.name}` stands in the world's axes"
            raise InputError("base", "a placed base", expected, "remove `base`")

    @property
    def zeros(self) -> tuple[Slot, ...]:
        """Parameters that are zero whatever the robot's numbers."""
        return *self.parts.none.values(), self.none, self.straight.part(9, PLACEMENT - 9)

    def bodies(self, block: Divisible) -> Slot:
        """The joints' and links' part of a block of all coordinates."""
        return block.part(self.parts.joints.start, self.kernels.bodies)

    def blocks(self) -> Blocks:
        """Inputs of a new schedule."""
        blocks = Blocks.as_inputs(self.parts)
        blocks.schedule.zeros = self.zeros
        return blocks


def _columns(system: System, parts: Parts) -> Any:
    """The constant map from the bodies' coordinates to those of the energies; missing coordinates stand at zero."""
    names = parts.names[parts.joints.start :]
    matched = list(system.matches(names) if system.matches else system.coordinates)
    if missing := [name for name in names if name not in matched]:
        got = f"the coordinate `{missing[0]}`, which the system `{system.name}` has not"
        expected = f"those of coordinates among {', '.join(system.coordinates)}"
        raise InputError("equations", got, expected, "name joints as the system's coordinates, or take its robot()")
    selected = np.zeros((len(matched), len(names)))
    for row, name in enumerate(matched):
        if name in names:
            selected[row, names.index(name)] = 1.0
    return system.basis() @ selected


def _points(system: System, parts: Parts) -> list[str | None]:
    """The name in the system of each of the chain's points; the first is the tip, None stands at the origin."""
    names = list(system.expressions.points)
    found: list[str | None] = []
    for k, point in enumerate(parts.points):
        if point.name in names:
            found.append(point.name)
        elif k == 0:
            found.append(names[0] if names else None)
        else:
            expected = f"one of {', '.join(names)}" if names else "no further points"
            got = f"the point `{point.name}`, which the system `{system.name}` has not"
            raise InputError("points", got, expected, "add it to the system's points, or remove it")
    return found
