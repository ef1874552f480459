"""A peer that is not installed here is left out of the table with its reason; it never stops the benchmark."""

from __future__ import annotations

import sys
from contextlib import redirect_stdout
from importlib import import_module
from typing import Any

__all__ = ["PeerMissing", "needed"]


class PeerMissing(RuntimeError):
    """A peer cannot run on this machine; the message says what to install, or what it lacks."""


def needed(module: str, package: str) -> Any:
    """A module of another engine, which has no types and is often absent: then :class:`PeerMissing`."""
    try:
        with redirect_stdout(sys.stderr):  # some greet, where our own output belongs
            return import_module(module)
    except ImportError as error:
        raise PeerMissing(f"not installed (pip install {package})") from error
