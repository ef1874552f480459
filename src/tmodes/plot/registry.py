"""The figures that are known by name: those of tmodes, and those that a user registers."""

from __future__ import annotations

from tmodes.errors import InputError
from tmodes.kinds.registry import Registry
from tmodes.plot.contract import Figure

__all__ = ["FIGURES", "register"]


def _has_words(figure: Figure) -> None:
    if not figure.name.isidentifier():
        raise InputError("figure name", repr(figure.name), "an identifier such as 'joint_power'", "set another `name`")
    if not (figure.title and figure.caption):
        hint = "set the class's `title` and `caption`"
        raise InputError(f"figure {figure.name}", "a class without title or caption", "a class with both", hint)


FIGURES: Registry[Figure] = Registry("figure", Figure, check=_has_words)
"""Every figure, in the order of the report."""

register = FIGURES.register
