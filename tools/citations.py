"""Finds the citations of the paper in the docstrings of the package, and the names of all tests.

Two forms are read, each running from its first word to its closing brace, over lines if need be:

    Eq. (24) [stated]: Epel_xi = 1/2 Cxi xi^2. {test_elastic_energy_terms}
    Slip (44): lm and le are exchanged {test_slip_44_jacobian}

A range is written ``Eq. (29)-(33) [derived]: ...``; several tests are parted by commas. A slip in a formula that the
paper does not number stands under its page: ``Slip (p. 61): ...``.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

__all__ = ["Citation", "Home", "citations_in", "docstrings", "known_tests"]

_START = re.compile(r"(?=\bEq\. \(\d+\)(?:-\(\d+\))? ?\[|\bSlip \()")
_EQUATION = re.compile(
    r"Eq\. \((?P<first>\d+)\)(?:-\((?P<last>\d+)\))? \[(?P<kind>stated|derived|corrected)\]: "
    r"(?P<text>[^{}]+) \{(?P<tests>[^{}]+)\}"
)
_SLIP = re.compile(r"Slip (?P<place>\([^)]+\)(?:-\(\d+\))?): (?P<text>[^{}]+) \{(?P<tests>[^{}]+)\}")


@dataclass(frozen=True)
class Home:
    """Where a docstring stands: its file and the dotted name of what it describes."""

    file: Path
    name: str


@dataclass(frozen=True)
class Citation:
    """One citation. ``place`` is as printed, ``(29)-(33)``; ``kind`` is stated, derived, corrected or slip."""

    place: str
    numbers: range
    kind: str
    text: str
    tests: tuple[str, ...]
    home: Home


def docstrings(package: Path) -> Iterator[tuple[Home, str]]:
    """Every docstring of a package with its home, in the order of files and lines."""
    for file in sorted(package.rglob("*.py")):
        parts = file.relative_to(package.parent).with_suffix("").parts
        module = ".".join(part for part in parts if part != "__init__")
        yield from _within(ast.parse(file.read_text(encoding="utf-8")), file, module)


def _within(node: ast.Module | ast.ClassDef | ast.FunctionDef, file: Path, name: str) -> Iterator[tuple[Home, str]]:
    text = ast.get_docstring(node)
    if text:
        yield Home(file, name), text
    for child in node.body:
        if isinstance(child, (ast.ClassDef, ast.FunctionDef)):
            yield from _within(child, file, f"{name}.{child.name}")


def citations_in(text: str, home: Home) -> tuple[list[Citation], list[str]]:
    """The citations of one docstring, and a problem for each beginning of one that cannot be read."""
    found: list[Citation] = []
    problems: list[str] = []
    for piece in _START.split(" ".join(text.split())):
        if match := _EQUATION.match(piece):
            found.append(_equation(match, home))
        elif match := _SLIP.match(piece):
            found.append(Citation(match["place"], range(0), "slip", _words(match), _tests(match), home))
        elif _START.match(piece):
            problems.append(f"{home.name}: cannot read the citation that begins {piece[:60]!r}")
    return found, problems


def _equation(match: re.Match[str], home: Home) -> Citation:
    first, last = int(match["first"]), int(match["last"] or match["first"])
    place = f"({first})" if first == last else f"({first})-({last})"
    return Citation(place, range(first, last + 1), match["kind"], _words(match), _tests(match), home)


def _words(match: re.Match[str]) -> str:
    return match["text"].strip().rstrip(".")


def _tests(match: re.Match[str]) -> tuple[str, ...]:
    return tuple(name.strip() for name in match["tests"].split(","))


def known_tests(folder: Path) -> dict[str, Path]:
    """Name of every test function under a folder, with its file."""
    return {
        node.name: file
        for file in sorted(folder.rglob("test_*.py"))
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8")))
        if isinstance(node, ast.FunctionDef) and node.name.startswith("test_")
    }
