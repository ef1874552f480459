"""Libraries that only some studies need: a missing one is named before anything runs."""

from __future__ import annotations

from importlib import import_module
from types import ModuleType

from tmodes.errors import InputError

__all__ = ["needed"]


def needed(library: str, extra: str) -> ModuleType:
    """A library of one of our extras; raises :class:`tmodes.errors.InputError` with the command that installs it."""
    try:
        return import_module(library)
    except ImportError as error:
        hint = f"pip install 'tmodes[{extra}]'"
        raise InputError(f"library {library}", f"“{error}”", "installed", hint) from error
