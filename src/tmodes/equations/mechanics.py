"""The makers of equations, and which of them gives a chain's: its own choice, by name.

A maker gives three schedules of the dynamics alone (``forward``, ``inertia``, ``elastic``), and, for the closed loop,
the outward pass (``way``) and the accelerations under drives and loads (``dynamics``) in a schedule that is being
written. Both makers share :class:`tmodes.equations.recursion.driven.Coordinates` and
:class:`tmodes.equations.recursion.driven.Driven`.
"""

from __future__ import annotations

from typing import Any

from tmodes.chain.chain import Chain
from tmodes.equations.lagrange.motion import ChainedSystem, LagrangeDynamics, LagrangeWay
from tmodes.equations.lagrange.registry import SYSTEMS
from tmodes.equations.lagrange.schedules import elastic_schedule, forward_schedule, inertia_schedule
from tmodes.equations.lagrange.system import System
from tmodes.equations.recursion.driven import Drives
from tmodes.equations.recursion.forces import elastic_forces, inertia_forces, joint_reactions
from tmodes.equations.recursion.forward import Recursion, forward_dynamics
from tmodes.equations.recursion.parts import Parts
from tmodes.equations.recursion.passes import Blocks, Passes
from tmodes.kinds.kernel.schedule import Schedule, Slot
from tmodes.sheet.robot import RECURSION

__all__ = ["Dynamics", "LagrangeMechanics", "Mechanics", "RecursiveMechanics", "Way", "mechanics"]


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
        """``forward``, ``inertia``, ``reactions`` or ``elastic``; ``loaded``: forces act on the points."""
        if name == "elastic":
            return elastic_forces(self.parts)
        made = {"forward": forward_dynamics, "inertia": inertia_forces, "reactions": joint_reactions}
        return made[name](self.parts, loaded=loaded)

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
        if name == "elastic":
            return elastic_schedule(self.chained)
        return {"forward": forward_schedule, "inertia": inertia_schedule}[name](self.chained, loaded=loaded)

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


Mechanics = RecursiveMechanics | LagrangeMechanics
Way = Passes | LagrangeWay
Dynamics = Recursion | LagrangeDynamics


def mechanics(chain: Chain) -> Mechanics:
    """The equations of a chain with its numbers.

    Raises :class:`tmodes.errors.InputError` where it names equations that are not registered.
    """
    if chain.equations == RECURSION:
        return RecursiveMechanics(Parts(chain))
    return LagrangeMechanics(SYSTEMS[chain.equations], Parts(chain))
