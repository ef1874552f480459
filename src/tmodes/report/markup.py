"""HTML that cannot be broken by its content, numbers with units as a person reads them."""

from __future__ import annotations

import html
from collections.abc import Iterable, Mapping, Sequence

from tmodes.io.printed import bound, power_of_ten, written

__all__ = ["Markup", "Rows", "grouped_table", "power_of_ten", "table", "tag", "together", "written"]


EMPTY = frozenset({"br", "img", "meta"})
VERBATIM = frozenset({"code", "pre", "script", "style"})
"""Elements whose text is taken to the letter: no space of it is changed."""


class Markup(str):
    """Text that is HTML already; only :func:`tag` and :func:`together` make it."""

    __slots__ = ()


def tag(name: str, /, *content: str | None, **attributes: str | bool | None) -> Markup:
    """One element. Plain text in ``content`` and in ``attributes`` is escaped, ``Markup`` is kept; None is left out.

    Numbers in ``content`` stay with their units at the end of a line, but in ``VERBATIM``.

    An attribute's trailing underscore is dropped, others become hyphens: ``class_``, ``aria_label``.
    """
    written = "".join(_attribute(key, value) for key, value in attributes.items())
    if name in EMPTY:
        return Markup(f"<{name}{written}>")
    if name not in VERBATIM:
        content = tuple(part if part is None or isinstance(part, Markup) else bound(part) for part in content)
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


Rows = Sequence[Sequence[str]]


def table(caption: str, head: Sequence[str], rows: Rows, numeric: Sequence[int] = ()) -> Markup:
    """A table; the columns in ``numeric`` are set to the right."""
    return grouped_table(caption, head, {"": rows}, numeric)


def grouped_table(caption: str, head: Sequence[str], groups: Mapping[str, Rows], numeric: Sequence[int] = ()) -> Markup:
    """A table of several groups of rows, each under a line with its name."""
    classes = ["number" if column in numeric else None for column in range(len(head))]
    header = (tag("th", word, scope="col", class_=kind) for word, kind in zip(head, classes, strict=True))
    bodies = (_body(name, rows, classes) for name, rows in groups.items())
    content = tag("table", tag("caption", caption), tag("thead", tag("tr", *header)), *bodies)
    return tag("div", content, class_="scroll", role="region", tabindex="0", aria_label=caption)


def _body(name: str, rows: Rows, classes: Sequence[str | None]) -> Markup:
    title = tag("tr", tag("th", name, scope="rowgroup", colspan=str(len(classes)), class_="group")) if name else None
    return tag("tbody", title, *(_row(row, classes) for row in rows))


def _row(row: Sequence[str], classes: Sequence[str | None]) -> Markup:
    cells = (tag("td", word, class_=kind) for word, kind in zip(row[1:], classes[1:], strict=True))
    return tag("tr", tag("th", row[0], scope="row", class_=classes[0]), *cells)
