"""Tables of the page: the first column names the rows, and a wide table scrolls in its own box."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from tmodes.report.markup import Markup, tag

__all__ = ["Rows", "grouped_table", "table"]

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
