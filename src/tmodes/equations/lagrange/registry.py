"""Systems by name: what the field ``equations`` of a robot's data sheet may say besides ``recursion``."""

from __future__ import annotations

from tmodes.equations.lagrange.filipovic2010 import CONSISTENT, PRINTED
from tmodes.equations.lagrange.moberg2009 import MOBERG
from tmodes.equations.lagrange.system import SYSTEMS

__all__ = ["SYSTEMS"]

for _system in (PRINTED, CONSISTENT, MOBERG):
    SYSTEMS.register(_system)
