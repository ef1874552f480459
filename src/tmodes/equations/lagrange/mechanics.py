"""Lagrange's equations of a system as a maker of equations, with the numbers of one chain."""

from __future__ import annotations

from typing import Any

from tmodes.equations.lagrange.chained import ChainedSystem
from tmodes.equations.lagrange.motion import LagrangeDynamics, LagrangeWay
from tmodes.equations.lagrange.schedules import elastic_schedule, forward_schedule, inertia_schedule
from tmodes.equations.lagrange.system import System
from tmodes.equations.recursion.driven import Drives
from tmodes.equations.recursion.parts import Parts
from tmodes.equations.recursion.passes import Blocks
from tmodes.kinds.kernel.schedule import Schedule, Slot

__all__ = ["LagrangeMechanics"]

_SCHEDULES = {"forward": forward_schedule, "inertia": inertia_schedule}


class LagrangeMechanics:
    """Schedules of a system with the numbers of one chain."""

    base_moves = False

    def __init__(self, system: System, parts: Parts) -> None:
        """Raises :class:`tmodes.errors.InputError` where chain and system do not belong together."""
        self.parts, self.chained = parts, ChainedSystem(system, parts)

    @property
    def on_links(self) -> bool:
        """Whether the system is another statement of the chain's links, from which its numbers come."""
        return self.chained.system.numbers is not None

    @property
    def zeros(self) -> tuple[Slot, ...]:
        """Parameters that are zero whatever the robot's numbers."""
        return self.chained.zeros

    def schedule(self, name: str, *, loaded: bool = False) -> Schedule:
        """``forward``, ``inertia`` or ``elastic``; ``loaded``: forces act on the points."""
        return elastic_schedule(self.chained) if name == "elastic" else _SCHEDULES[name](self.chained, loaded=loaded)

    def drawn(self, blocks: Blocks) -> dict[str, Slot]:
        """The system's own lines, between its points."""
        way, kernels = LagrangeWay(self.chained, blocks), self.chained.kernels
        pairs = self.chained.system.segments
        return {f"{a}-{b}": way.call(kernels.segment(a, b), *way.state)[0] for a, b in pairs}

    def way(self, blocks: Blocks, *, posed: bool) -> LagrangeWay:
        """Where the points are, found when asked."""
        del posed
        return LagrangeWay(self.chained, blocks)

    def dynamics(self, way: Any, drives: Drives) -> LagrangeDynamics:
        """The system's rows, to be solved."""
        return LagrangeDynamics(way, drives)
