"""Writes docs/notation.md, symbol - word - unit: ``python tools/notation_doc.py [--check]``.

The data sheet's own fields and the variables of a (very short) run describe themselves; the rest is in notation_words.
"""

from __future__ import annotations

import sys
from collections.abc import Iterable, Iterator
from typing import Any, get_args

import generated
import tmodes
from notation_words import COORDINATES, DERIVED, Row
from tmodes.io.forms import F2010
from tmodes.kinds.schema.quantity import DataSheet

__all__ = ["page", "quantities", "variables"]


def quantities(sheet: type[DataSheet], path: str = "") -> Iterator[Row]:
    """Path, symbol, unit and meaning of every physical quantity of a data sheet; ``N`` is a place in a list."""
    for name, field in sheet.model_fields.items():
        extra = field.json_schema_extra
        if isinstance(extra, dict) and "unit" in extra:
            yield path + name, str(extra["symbol"]), str(extra["unit"]), _meaning(field.description or "", extra)
        for inner, index in _sheets(field.annotation):
            yield from quantities(inner, f"{path}{name}{index}.")


def _sheets(annotation: Any) -> Iterator[tuple[type[DataSheet], str]]:
    if isinstance(annotation, type) and issubclass(annotation, DataSheet):
        yield annotation, ""
    for item in dict.fromkeys(get_args(annotation)):
        yield from ((sheet, ".N") for sheet, _ in _sheets(item))


def _meaning(description: str, extra: dict[str, Any]) -> str:
    words = description.removesuffix(f" [{extra['unit']}]")
    return f"{words}; `.inf` makes it rigid" if extra.get("rigid_when_infinite") else words


def variables() -> Iterator[Row]:
    """Name, dimensions, unit and meaning of every variable of a result."""
    robots = tmodes.load("filipovic2010", {"integration.duration": 0.01}), tmodes.Robot.from_data(_FALLING)
    found = {str(name): variable for robot in robots for name, variable in tmodes.run(robot).data.data_vars.items()}
    for name, variable in found.items():
        yield name, ", ".join(map(str, variable.dims)), variable.attrs["units"], variable.attrs["long_name"]


_FALLING: dict[str, Any] = {
    "format": 1, "kind": "arm", "name": "falling", "gravity": 9.81,
    "joints": [{"name": "z", "type": "prismatic", "child": "block", "axis": [0, 0, 1], "state": "free"}],
    "links": [{"name": "block", "bodies": [{"name": "body", "mass": 1.0}]}],
    "contact": {"law": "unilateral", "stiffness": 4000.0, "damping": 0.0, "mass": 0.5,
                "shape": {"type": "plane", "position": [0, 0, 0], "normal": [0, 0, 1]}},
    "initial": {"state": "zero", "coordinates": {"z": 1e-4}}, "integration": {"duration": 0.01},
}  # fmt: skip
"""A robot whose result has what the other has not: a surface with mass."""


def page() -> str:
    """The page as Markdown."""
    return "\n".join(
        [
            "# Notation",
            "",
            "Words outside, letters inside: files, functions and results use the words, formulas the symbols of",
            "Filipovic & Djuric (2010). SI units and radians throughout; a name that ends in `_deg` is in degrees.",
            "A prime is a time derivative; superscript o (suffix `_o`) marks a characteristic as known.",
            "",
            "This page is written by `python tools/notation_doc.py`.",
            "",
            "## The data sheet",
            "",
            "The key is also the path that `--set` and `Robot.with_` take; N is 0 for the mode at the root.",
            "",
            *_table(("key", "symbol", "unit", "meaning"), quantities(F2010.root)),
            "",
            "## Coordinates and elastic angles",
            "",
            *_table(("name", "symbol", "unit", "meaning"), COORDINATES),
            "",
            "## What follows from them",
            "",
            *_table(("name", "symbol", "unit", "meaning"), DERIVED),
            "",
            "## The result",
            "",
            "Each variable carries its unit and its meaning in the file itself (`units`, `long_name`).",
            "",
            *_table(("variable", "dimensions", "unit", "meaning"), variables()),
            "",
        ]
    )


def _table(head: Row, rows: Iterable[Row]) -> Iterator[str]:
    yield f"| {' | '.join(head)} |"
    yield "|---" * len(head) + "|"
    for name, *cells in rows:
        names = ", ".join(f"`{part}`" for part in name.split(", "))
        yield f"| {names} | {' | '.join(cell.replace('*', '·') for cell in cells)} |"


if __name__ == "__main__":
    sys.exit(generated.main(generated.ROOT / "docs" / "notation.md", page(), "notation_doc"))
