"""Systems by name: what the field ``equations`` of a robot's data sheet may say besides ``recursion``."""

from __future__ import annotations

from difflib import get_close_matches

from tmodes.equations.lagrange.filipovic2010 import CONSISTENT, PRINTED
from tmodes.equations.lagrange.system import System, known_systems
from tmodes.errors import InputError
from tmodes.sheet.robot import RECURSION

__all__ = ["system_named"]

_PUBLISHED = {system.name: system for system in (PRINTED, CONSISTENT)}


def system_named(name: str) -> System:
    """The system of a name; raises :class:`tmodes.errors.InputError` for one that is not known in this process."""
    systems = {**_PUBLISHED, **known_systems()}
    if name not in systems:
        close = get_close_matches(name, [RECURSION, *systems], n=1)
        known = ", ".join([RECURSION, *sorted(systems)])
        hint = f"did you mean `{close[0]}`?" if close else "call `robot()` of the system first, as its script does"
        raise InputError("equations", f"`{name}`", f"one of {known}", hint)
    return systems[name]
