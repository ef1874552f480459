"""What commands answer: sentences and tables, as terminals, ``repr`` and notebooks show them, and plain data."""

from __future__ import annotations

import html
from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

if TYPE_CHECKING:
    from xarray import Dataset

__all__ = ["CommandResult", "Table", "known_columns", "plain", "public_names", "shortened", "table_html"]

MOST_LINES, WIDEST = 10, 120
"""Lines of a ``repr``, and characters of each."""


class Table(NamedTuple):
    """A title, the names of the columns, and rows of texts."""

    title: str
    columns: Sequence[str]
    rows: Sequence[Sequence[str]]


def known_columns(title: str, columns: Sequence[str], rows: Sequence[Sequence[str]]) -> Table:
    """A table without the columns that have nothing but ``-``."""
    kept = [k for k in range(len(columns)) if any(row[k] != "-" for row in rows)]
    return Table(title, [columns[k] for k in kept], [[row[k] for k in kept] for row in rows])


def public_names(thing: object) -> list[str]:
    """The names of an object that are meant for users."""
    return sorted(name for name in object.__dir__(thing) if not name.startswith("_"))


class CommandResult:
    """What a command gives: it prints itself, has named arrays (``data``) and a figure (``plot``)."""

    def tables(self) -> Iterator[str | Table]:
        """Sentences and tables, in the order in which the command prints them."""
        raise NotImplementedError

    def info(self) -> dict[str, Any]:
        """Plain data, as the command prints with ``--json``; units stand in the names or under ``units``."""
        raise NotImplementedError

    @property
    def notices(self) -> Sequence[str]:
        """What is to be said next to the tables."""
        return ()

    @property
    def warnings(self) -> Sequence[str]:
        """What is to be known about the numbers."""
        return ()

    @property
    def data(self) -> Dataset:
        """The numbers as named arrays, an xarray.Dataset with units."""
        raise NotImplementedError

    def plot(self, ax: Any = None) -> list[Any]:
        """Draw into matplotlib axes, or into a new figure; returns the axes."""
        raise NotImplementedError

    def __repr__(self) -> str:
        return shortened(self.tables(), "print them with .tables()")

    def _repr_html_(self) -> str:
        return "".join(map(table_html, self.tables()))

    def __dir__(self) -> list[str]:
        return public_names(self)


def shortened(parts: Iterable[str | Table], hint: str) -> str:
    """Sentences and tables as text of at most ten lines; of more the last one counts the rest, with a hint."""
    lines = [line for part in parts for line in _lines(part)]
    found = [line if len(line) <= WIDEST else f"{line[: WIDEST - 1]}…" for line in lines]
    if len(found) > MOST_LINES:
        found = [*found[: MOST_LINES - 1], f"… {len(found) - MOST_LINES + 1} more lines: {hint}"]
    return "\n".join(found)


def _lines(part: str | Table) -> Iterator[str]:
    if isinstance(part, str):
        yield from part.splitlines()
        return
    if part.title:
        yield part.title
    cells = [part.columns, *part.rows]
    widths = [max(map(len, column)) for column in zip(*cells, strict=True)]
    for row in cells:
        yield "  " + "  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)).rstrip()


def table_html(part: str | Table) -> str:
    """A sentence or a table as HTML."""
    if isinstance(part, str):
        return f"<p>{html.escape(part)}</p>"
    head = "".join(f"<th>{html.escape(column)}</th>" for column in part.columns)
    rows = ("".join(f"<td>{html.escape(cell)}</td>" for cell in row) for row in part.rows)
    body = "".join(f"<tr>{row}</tr>" for row in rows)
    caption = f"<caption>{html.escape(part.title)}</caption>" if part.title else ""
    return f"<table>{caption}<thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"


def plain(text: str) -> str:
    """Text of a file that may be anybody's, without what steers a terminal."""
    return "".join(letter if letter.isprintable() else "?" for letter in text)
