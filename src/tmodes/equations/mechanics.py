"""The makers of equations, and which of them gives a chain's: its own choice, by name.

A maker gives three schedules of the dynamics alone (``forward``, ``inertia``, ``elastic``), and, for the closed loop,
the outward pass (``way``) and the accelerations under drives and loads (``dynamics``) in a schedule that is being
written. Both makers share :class:`tmodes.equations.recursion.driven.Coordinates` and
:class:`tmodes.equations.recursion.driven.Driven`.
"""

from __future__ import annotations

from typing import Any

from tmodes.chain.chain import Chain
from tmodes.equations.lagrange import motion as lagrange
from tmodes.equations.lagrange.motion import ChainedSystem, LagrangeDynamics, LagrangeWay
from tmodes.equations.lagrange.registry import SYSTEMS
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
        made = {"forward": forward_dynamics, "reactions": joint_reactions}
        return made[name](self.parts, loaded=loaded) if name in made else _forces_of(self, name, loaded=loaded)

    def blocks(self) -> Blocks:
        """Inputs of a new schedule."""
        return Blocks.as_inputs(self.parts)

    def passes(self, blocks: Blocks, *, posed: bool) -> Passes:
        """What the dynamics alone start from in a schedule; ``posed``: poses are needed."""
        return Passes(self.parts, posed=posed, loaded=False, blocks=blocks)

    def inertia(self, way: Any, a: Slot) -> dict[str, list[Slot]]:
        """See :func:`tmodes.equations.recursion.forces.inertia_forces`."""
        return inertia_forces(way, a)

    def elastic(self, way: Any) -> dict[str, list[Slot]]:
        """See :func:`tmodes.equations.recursion.forces.elastic_forces`."""
        return elastic_forces(way)

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
        if name == "forward":
            return lagrange.forward_schedule(self.chained, loaded=loaded)
        return _forces_of(self, name, loaded=loaded)

    def blocks(self) -> Blocks:
        """Inputs of a new schedule."""
        return self.chained.blocks()

    def passes(self, blocks: Blocks, *, posed: bool) -> LagrangeWay:
        """Where the points are, found when asked."""
        return self.way(blocks, posed=posed)

    def inertia(self, way: Any, a: Slot) -> dict[str, list[Slot]]:
        """See :func:`tmodes.equations.lagrange.motion.inertia_forces`."""
        return lagrange.inertia_forces(way, a)

    def elastic(self, way: Any) -> dict[str, list[Slot]]:
        """See :func:`tmodes.equations.lagrange.motion.elastic_forces`."""
        return lagrange.elastic_forces(way)

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


def _forces_of(mechanics: Mechanics, name: str, *, loaded: bool) -> Schedule:
    """(q, v, base, wrenches, a) -> outputs of ``inertia``; (q, v, base) -> those of ``elastic``."""
    way = mechanics.passes(mechanics.blocks(), posed=name == "inertia")
    if name == "elastic":
        found = mechanics.elastic(way)
    else:
        way.take_wrenches(loaded=loaded)
        found = mechanics.inertia(way, way.schedule.input("a", mechanics.parts.size))
    for output, slots in found.items():
        way.schedule.output(output, *slots)
    return way.schedule


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
