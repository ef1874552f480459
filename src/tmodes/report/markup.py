"""HTML that cannot be broken by its content: every text is escaped unless it is markup that was made here."""

from __future__ import annotations

import html
from collections.abc import Iterable

__all__ = ["Markup", "tag", "together"]

EMPTY = frozenset({"br", "img", "meta"})


class Markup(str):
    """Text that is HTML already; only :func:`tag`, :func:`together` and the figures make it."""

    __slots__ = ()


def tag(name: str, /, *content: str | None, **attributes: str | bool | None) -> Markup:
    """One element. Plain text in ``content`` and in ``attributes`` is escaped, ``Markup`` is kept; None is left out.

    An attribute's trailing underscore is dropped, others become hyphens: ``class_``, ``aria_label``.
    """
    written = "".join(_attribute(key, value) for key, value in attributes.items())
    if name in EMPTY:
        return Markup(f"<{name}{written}>")
    return Markup(f"<{name}{written}>{together(content)}</{name}>")


def together(parts: Iterable[str | None]) -> Markup:
    """Parts one after the other, escaped as in :func:`tag`."""
    return Markup("".join(part if isinstance(part, Markup) else html.escape(part) for part in parts if part))


def _attribute(key: str, value: str | bool | None) -> str:
    name = key.rstrip("_").replace("_", "-")
    match value:
        case None | False:
            return ""
        case True:
            return f" {name}"
    return f' {name}="{html.escape(value)}"'
