"""The figures that are known by name: those of tmodes, and those that a user registers."""

from __future__ import annotations

from typing import TypeVar

from tmodes.errors import InputError
from tmodes.plot.contract import Figure

__all__ = ["FIGURES", "register"]

FIGURES: dict[str, Figure] = {}
"""Every figure by its name, in the order of the report."""

F = TypeVar("F", bound=Figure)


def register(figure: F) -> F:
    """Add a figure to :data:`FIGURES`, after those that are there; returns it.

    Raises :class:`tmodes.errors.InputError` for a name that is taken or is no identifier, and for missing words.
    """
    name = getattr(figure, "name", "")
    if not (isinstance(name, str) and name.isidentifier()):
        raise InputError("figure name", repr(name), "an identifier such as 'joint_power'", "set the class's `name`")
    if name in FIGURES:
        raise InputError("figure name", repr(name), "a name that no figure has", "choose another name")
    if not (getattr(figure, "title", "") and getattr(figure, "caption", "")):
        raise InputError(
            f"figure {name}",
            "a class without title or caption",
            "a class with both",
            "set the class's `title` and `caption`",
        )
    FIGURES[name] = figure
    return figure
