"""HTML that cannot be broken by its content, numbers with units as a person reads them."""

from __future__ import annotations

import html
import math
from collections.abc import Iterable, Mapping, Sequence

from tmodes.plot.panels import NEVER_LARGE, pretty

__all__ = ["Markup", "Rows", "grouped_table", "power_of_ten", "table", "tag", "together", "written"]


EMPTY = frozenset({"br", "img", "meta"})


class Markup(str):
    """Text that is HTML already; only :func:`tag` and :func:`together` make it."""

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


_PREFIXES = (
    (1e10, 1e-9, "G"), (1e7, 1e-6, "M"), (1e4, 1e-3, "k"), (0.1, 1.0, ""), (1e-4, 1e3, "m"), (1e-7, 1e6, "µ"),
    (1e-11, 1e9, "n"),
)  # fmt: skip
_FIXED = {"m": (10.0, 1e3, "mm"), "rad": (1.0, 1e3, "mrad"), "s": (1.0, 1.0, "s")}
"""One unit for what is compared: below this size the factor on the SI value and its name."""

_PLAIN = ("Hz", "%", "rad/s")
"""Units that take no prefix."""

_SUPERSCRIPT = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def written(value: float, unit: str, digits: int = 4) -> str:
    """A value [``unit``, SI] with a readable unit, not to be parted at the end of a line: ``4.041 mm``."""
    name = "" if unit in ("", "-", "1") else pretty(unit)
    size = abs(value)
    if not math.isfinite(value):
        return f"{value:g}\u00a0{name}".rstrip()
    if (fixed := _FIXED.get(unit)) and 0.0 < size < fixed[0]:
        value, name = value * fixed[1], fixed[2]
    if not name or unit in _PLAIN or unit in _FIXED or size == 0.0:
        text = power_of_ten(value) if 0.0 < abs(value) < 1e-3 else _rounded(value, digits)
        return f"{text}\u00a0{name}".rstrip("\u00a0")
    for least, factor, prefix in _PREFIXES:
        if size >= least and (factor >= 1.0 or unit.split("/", maxsplit=1)[0] not in NEVER_LARGE):
            return f"{_rounded(value * factor, digits)}\u00a0{prefix}{name}"
    return f"{power_of_ten(value)}\u00a0{name}"


def _rounded(value: float, digits: int) -> str:
    """To so many digits that tell, never with an exponent: ``12340``."""
    return f"{float(f'{value:.{digits}g}'):.12g}"


def power_of_ten(value: float) -> str:
    """A number of any size with two digits: ``1.7 × 10⁻¹¹``."""
    if value == 0.0:
        return "0"
    digits, _, power = f"{value:.1e}".partition("e")
    return f"{digits}\u00a0×\u00a010{str(int(power)).translate(_SUPERSCRIPT)}"
