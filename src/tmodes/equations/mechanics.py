"""The makers of equations, and which of them gives a chain's: its own choice, by name.

A maker gives three schedules of the dynamics alone (``forward``, ``inertia``, ``elastic``), and, for the closed loop,
the outward pass (``way``) and the accelerations under drives and loads (``dynamics``) in a schedule that is being
written. Both makers share :class:`tmodes.equations.recursion.coordinates.Coordinates` and
:class:`tmodes.equations.recursion.driven.Driven`.
"""

from __future__ import annotations

from tmodes.chain.chain import Chain
from tmodes.equations.lagrange.mechanics import LagrangeMechanics
from tmodes.equations.lagrange.motion import LagrangeDynamics, LagrangeWay
from tmodes.equations.lagrange.registry import system_named
from tmodes.equations.recursion.forward import Recursion
from tmodes.equations.recursion.mechanics import RecursiveMechanics
from tmodes.equations.recursion.parts import Parts
from tmodes.equations.recursion.passes import Passes
from tmodes.sheet.robot import RECURSION

__all__ = ["Dynamics", "Mechanics", "Way", "mechanics"]

Mechanics = RecursiveMechanics | LagrangeMechanics
Way = Passes | LagrangeWay
Dynamics = Recursion | LagrangeDynamics


def mechanics(chain: Chain) -> Mechanics:
    """The equations of a chain with its numbers.

    Raises :class:`tmodes.errors.InputError` where it names equations that are not registered.
    """
    if chain.equations == RECURSION:
        return RecursiveMechanics(Parts(chain))
    return LagrangeMechanics(system_named(chain.equations), Parts(chain))
