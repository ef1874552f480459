"""What commands answer: sentences and tables, as terminals, ``repr`` and notebooks show them, and plain data.

And numbers with units as a person reads them, in all of these and in pages.
"""

from __future__ import annotations

import html
import math
import re
from collections.abc import Iterable, Iterator, Sequence
from textwrap import wrap
from typing import TYPE_CHECKING, Any, NamedTuple

if TYPE_CHECKING:
    from xarray import Dataset

__all__ = [
    "NEVER_LARGE", "CommandResult", "Table", "bound", "changed_by", "known_columns", "plain", "power_of_ten", "pretty",
    "public_names", "shortened", "table_html", "written",
]  # fmt: skip

MOST_LINES, WIDEST = 10, 120
"""Lines of a ``repr``, and characters of each."""

_NARROWEST = 20
"""Least characters of a column that wraps."""


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


def shortened(parts: Iterable[str | Table], hint: str, most: int = MOST_LINES, widest: int = WIDEST) -> str:
    """Sentences and tables as text of at most so many lines; of more the last one counts the rest, with a hint."""
    lines = [line for part in parts for line in _lines(part, widest)]
    found = [line if len(line) <= widest else f"{line[: widest - 1]}…" for line in lines]
    if len(found) > most:
        found = [*found[: most - 1], f"… {len(found) - most + 1} more lines: {hint}"]
    return "\n".join(found)


def _lines(part: str | Table, widest: int) -> Iterator[str]:
    """The lines of a part; the last column of a table wraps where that is enough to fit."""
    if isinstance(part, str):
        yield from part.splitlines()
        return
    if part.title:
        yield part.title
    cells = [part.columns, *part.rows]
    widths = [max(map(len, column)) for column in zip(*cells, strict=True)]
    room = widest - sum(widths[:-1]) - 2 * len(widths)
    for row in cells:
        last = wrap(row[-1], room) if len(row[-1]) > room > _NARROWEST else [row[-1]]
        for k, text in enumerate(last):
            own = [*row[:-1], text] if k == 0 else [*[""] * (len(row) - 1), text]
            yield "  " + "  ".join(cell.ljust(width) for cell, width in zip(own, widths, strict=True)).rstrip()


def table_html(part: str | Table) -> str:
    """A sentence or a table as HTML."""
    if isinstance(part, str):
        return f"<p>{html.escape(bound(part))}</p>"
    head = "".join(f"<th>{html.escape(bound(column))}</th>" for column in part.columns)
    rows = ("".join(f"<td>{html.escape(bound(cell))}</td>" for cell in row) for row in part.rows)
    body = "".join(f"<tr>{row}</tr>" for row in rows)
    caption = f"<caption>{html.escape(bound(part.title))}</caption>" if part.title else ""
    return f"<table>{caption}<thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"


def plain(text: str) -> str:
    """Text of a file that may be anybody's, without what steers a terminal."""
    return "".join(letter if letter.isprintable() else "?" for letter in text)


NEVER_LARGE = ("m", "rad", "s", "-", "gain")
"""Units that take no prefix for a thousand."""

_PREFIXES = (
    (1e10, 1e-9, "G"), (1e7, 1e-6, "M"), (1e4, 1e-3, "k"), (0.1, 1.0, ""), (1e-4, 1e3, "m"), (1e-7, 1e6, "µ"),
    (1e-11, 1e9, "n"),
)  # fmt: skip
_FIXED = {"m": (10.0, 1e3, "mm"), "rad": (1.0, 1e3, "mrad"), "s": (1.0, 1.0, "s")}
"""One unit for what is compared, but for tiny sizes: below this size the factor on the SI value and its name."""

_LEAST, _LARGE = 1e-11, 1e7
"""Least size with a prefix, also of what has one unit, where it is below a thousandth of that; powers of ten from."""

_PLAIN = ("Hz", "%", "rad/s")
"""Units that take no prefix."""

_SUPERSCRIPT = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def pretty(unit: str) -> str:
    """``N*m`` and ``N m`` as ``N·m``, ``m/s^2`` as ``m/s²``, ``ohm`` as ``Ω``; no unit is ``–``."""
    written = unit.strip().replace("*", "·").replace(" ", "·").replace("^2", "²").replace("^3", "³")
    return "–" if written in ("", "-", "1") else written.replace("ohm", "Ω")


def written(value: float, unit: str, digits: int = 4) -> str:
    """A value [``unit``, SI] with a readable unit: ``4.041 mm``."""
    name = "" if unit in ("", "-", "1") else pretty(unit)
    size = abs(value)
    if not math.isfinite(value):
        return f"{value:g} {name}".rstrip()
    own = _FIXED.get(unit)
    tiny = own is not None and _LEAST <= size < 1e-3 / own[1]
    if own and size < own[0] and not tiny:
        value, name = value * own[1], own[2]
    if not name or unit in _PLAIN or (own and not tiny) or size == 0.0:
        text = power_of_ten(value) if size and not 1e-3 <= abs(value) < _LARGE else _rounded(value, digits)
        return f"{text} {name}".rstrip()
    for least, factor, prefix in _PREFIXES:
        if size >= least and (factor >= 1.0 or unit.split("/", maxsplit=1)[0] not in NEVER_LARGE):
            return f"{_rounded(value * factor, digits)} {prefix}{name}"
    return f"{power_of_ten(value)} {name}"


_BEFORE_UNIT = re.compile(
    r"(?<=[\d⁰¹²³⁴-⁹]) (?=(?:[nµmkMG]?(?:m|s|g|N|Pa|Hz|rad|V|A|J|W|Ω)|%|°|deg)(?![A-Za-z0-9_]))"
    r"|(?<=\d) (?=× 10)|(?<=\d ×) (?=10)"
)


def bound(text: str) -> str:
    """Text for a page, whose numbers no end of a line parts from their units: with no-break spaces between them.

    As ``bound`` of ``web/src/format.ts``.
    """
    return _BEFORE_UNIT.sub("\u00a0", text)


def changed_by(value: float, first: float) -> str:
    """A change as a person reads it: ``−34 %``, from twice the value on ``×143``; ``from 0``; nothing for no change.

    Nor is there a ratio of values of opposite signs.
    """
    if not value or not first:
        return "" if value == first else "to 0" if first else "from 0"
    ratio = value / first
    if ratio <= 0 or ratio == 1:
        return ""
    if max(ratio, 1 / ratio) > _NEARLY:
        return "from nearly 0" if ratio > 1 else "to nearly 0"
    if ratio >= 2 or ratio < _HUNDREDTH:
        return f"×{_rounded(ratio, 3)}" if ratio >= 2 else f"÷{_rounded(1 / ratio, 3)}"
    return f"{'+' if ratio > 1 else '−'}{_rounded(100 * abs(ratio - 1), 3)} %"


_HUNDREDTH, _NEARLY = 0.01, 1e5
"""Of the first value, below which it is said by which factor it is smaller; a ratio beyond which one is rounding."""


def _rounded(value: float, digits: int) -> str:
    """To so many digits that tell, never with an exponent: ``12340``."""
    return f"{float(f'{value:.{digits}g}'):.12g}"


def power_of_ten(value: float) -> str:
    """A number of any size with two digits: ``1.7 × 10⁻¹¹``."""
    if value == 0.0:
        return "0"
    digits, _, power = f"{value:.1e}".partition("e")
    return f"{digits} × 10{str(int(power)).translate(_SUPERSCRIPT)}"
