"""Systems by name: what the field ``equations`` of a robot's data sheet may say besides ``recursion``."""

from __future__ import annotations

from difflib import get_close_matches

from tmodes.equations.lagrange.filipovic2010 import CONSISTENT, PRINTED
from tmodes.equations.lagrange.system import System
from tmodes.errors import InputError
from tmodes.sheet.robot import RECURSION

__all__ = ["register_system", "system_named"]

_SYSTEMS: dict[str, System] = {system.name: system for system in (PRINTED, CONSISTENT)}


def register_system(system: System) -> System:
    """Make a system known by its name in this process; a later one of the same name takes its place."""
    if system.name == RECURSION:
        raise InputError("name", f"`{RECURSION}`", "another name", "choose a name of your own")
    _SYSTEMS[system.name] = system
    return system


def system_named(name: str) -> System:
    """The system of a name; raises :class:`tmodes.errors.InputError` for one that is not registered."""
    if name not in _SYSTEMS:
        close = get_close_matches(name, [RECURSION, *_SYSTEMS], n=1)
        known = ", ".join([RECURSION, *sorted(_SYSTEMS)])
        hint = f"did you mean `{close[0]}`?" if close else "run the script that defines the system first"
        raise InputError("equations", f"`{name}`", f"one of {known}", hint)
    return _SYSTEMS[name]
