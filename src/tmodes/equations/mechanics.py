"""Which maker gives a chain's equations: its own choice, by name."""

from __future__ import annotations

from tmodes.chain.chain import Chain
from tmodes.equations.contract import Dynamics, Mechanics, Way
from tmodes.equations.lagrange.mechanics import LagrangeMechanics
from tmodes.equations.lagrange.registry import system_named
from tmodes.equations.recursion.mechanics import RecursiveMechanics
from tmodes.equations.recursion.parts import Parts
from tmodes.sheet.robot import RECURSION

__all__ = ["Dynamics", "Mechanics", "Way", "mechanics"]


def mechanics(chain: Chain) -> Mechanics:
    """The equations of a chain with its numbers.

    Raises :class:`tmodes.errors.InputError` where it names equations that are not registered.
    """
    if chain.equations == RECURSION:
        return RecursiveMechanics(Parts(chain))
    return LagrangeMechanics(system_named(chain.equations), Parts(chain))
