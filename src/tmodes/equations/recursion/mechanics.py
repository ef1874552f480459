"""The articulated-body recursion as a maker of equations."""

from __future__ import annotations

from typing import Any

from tmodes.equations.recursion.driven import Drives
from tmodes.equations.recursion.elastic import elastic_forces
from tmodes.equations.recursion.forward import Recursion, forward_dynamics
from tmodes.equations.recursion.inertia import inertia_forces
from tmodes.equations.recursion.parts import Parts
from tmodes.equations.recursion.passes import Blocks, Passes
from tmodes.kinds.kernel.schedule import Schedule, Slot

__all__ = ["RecursiveMechanics"]


class RecursiveMechanics:
    """Schedules of the recursion with the numbers of one chain."""

    base_moves = True
    on_links = True

    def __init__(self, parts: Parts) -> None:
        self.parts = parts

    @property
    def zeros(self) -> tuple[Slot, ...]:
        """Parameters that are zero whatever the robot's numbers."""
        return tuple(self.parts.none.values())

    def schedule(self, name: str, *, loaded: bool = False) -> Schedule:
        """``forward``, ``inertia`` or ``elastic``; ``loaded``: forces act on the points."""
        if name == "elastic":
            return elastic_forces(self.parts)
        return {"forward": forward_dynamics, "inertia": inertia_forces}[name](self.parts, loaded=loaded)

    def drawn(self, blocks: Blocks) -> dict[str, Slot]:
        """Nothing but the links themselves."""
        del blocks
        return {}

    def way(self, blocks: Blocks, *, posed: bool) -> Passes:
        """The outward pass in a schedule; ``posed``: poses are needed."""
        way = Passes(self.parts, posed=posed, loaded=False, blocks=blocks, short=True)
        way.outwards()
        return way

    def dynamics(self, way: Any, drives: Drives) -> Recursion:
        """The recursion inwards and outwards again."""
        return Recursion(way, drives)
