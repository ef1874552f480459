"""Systems by name: what the field ``equations`` of a robot's data sheet may say besides ``recursion``."""

from __future__ import annotations

from tmodes.equations.lagrange.filipovic2010 import CONSISTENT, PRINTED
from tmodes.equations.lagrange.system import SYSTEMS, System

__all__ = ["system_named"]

for _system in (PRINTED, CONSISTENT):
    SYSTEMS.register(_system)


def system_named(name: str) -> System:
    """The system of a name; raises :class:`tmodes.kinds.registry.UnknownKindError`."""
    return SYSTEMS[name]
