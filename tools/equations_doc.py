"""Writes docs/equations.md from the citations in the code: ``python tools/equations_doc.py [--check]``.

``--check`` writes nothing and fails when the page is old, when an equation or a slip of the paper has no home in the
code, and when a citation names a test that does not exist.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import generated
from citations import Citation, citations_in, docstrings, known_tests

__all__ = ["EQUATIONS", "SLIPS", "ExpectedSlip", "collect", "page", "problems"]

EQUATIONS = range(1, 45)
"""The paper's equations are numbered (1) to (44)."""


@dataclass(frozen=True)
class ExpectedSlip:
    """A slip of the print: known by the place where it may be cited and by a word of the citation."""

    number: str
    places: tuple[str, ...]
    word: str

    def is_reported_by(self, citation: Citation) -> bool:
        """Whether this citation describes this slip."""
        return citation.place in self.places and re.search(self.word, citation.text, re.IGNORECASE) is not None


SLIPS = (
    ExpectedSlip("S1", ("(13)",), "33/140|gravity"),
    ExpectedSlip("S2", ("(18)-(19)",), "geometric"),
    ExpectedSlip("S3", ("(20)-(23)",), "dots?"),
    ExpectedSlip("S4", ("(34)",), "repeat"),
    ExpectedSlip("S5", ("(34)-(38)",), "column"),
    ExpectedSlip("S6", ("(39)", "(40)"), "volts"),
    ExpectedSlip("S7", ("(40)",), "both planes"),
    ExpectedSlip("S8", ("(40)", "(p. 61)"), "friction"),
    ExpectedSlip("S9", ("(43)",), "singular"),
    ExpectedSlip("S10", ("(44)",), "lm and le"),
    ExpectedSlip("S11", ("(p. 61)",), "negative stiffness"),
    ExpectedSlip("S12", ("(p. 70)",), "integer|whole number"),
)


def collect(package: Path) -> tuple[list[Citation], list[str]]:
    """All citations of a package, and what could not be read."""
    pairs = [citations_in(text, home) for home, text in docstrings(package)]
    return [c for found, _ in pairs for c in found], [c for _, problems in pairs for c in problems]


def problems(citations: Sequence[Citation], tests: Iterable[str]) -> list[str]:
    """What is missing: homes of equations and slips, tests that are named."""
    equations, slips = _sorted_out(citations)
    homed = {number for citation in equations for number in citation.numbers}
    return [
        *(f"equation ({n}) has no home in the code" for n in EQUATIONS if n not in homed),
        *(f"{c.home.name}: the paper has no equation {c.place}" for c in equations if set(c.numbers) - set(EQUATIONS)),
        *(
            f"slip {slip.number}, at {' or '.join(slip.places)} with {slip.word!r} in its text, has no home in the code"
            for slip in SLIPS
            if not any(slip.is_reported_by(citation) for citation in slips)
        ),
        *(f"{c.home.name}: slip {c.place} is not in the list of slips" for c in slips if not _number(c)),
        *_without_test(citations, set(tests)),
    ]


def _without_test(citations: Sequence[Citation], tests: set[str]) -> Iterator[str]:
    cited: dict[str, list[str]] = {}
    for citation in citations:
        for name in citation.tests:
            cited.setdefault(name, []).append(citation.place)
    for name in sorted(cited.keys() - tests):
        yield f"{name} is no test; it is named by the citations of {', '.join(cited[name])}"


def page(citations: Sequence[Citation], tests: Mapping[str, Path], root: Path) -> str:
    """The page as Markdown; links are relative to docs/."""
    equations, slips = _sorted_out(citations)
    by_number = sorted(equations, key=lambda c: (c.numbers.start, c.numbers.stop))
    by_slip = sorted(
        slips, key=lambda c: [s.is_reported_by(c) for s in SLIPS].index(True) if _number(c) else len(SLIPS)
    )
    return "\n".join(
        [
            "# Equations",
            "",
            "Every numbered equation of Filipovic & Djuric (2010), where it stands in the code, and the test of",
            "it. *stated*: written down as printed. *derived*: follows, by differentiation, from what is stated.",
            "*corrected*: the print has a slip there (second table) or says less than holds; the code has it right.",
            "",
            "This page is written by `python tools/equations_doc.py` from the docstrings: change it there.",
            "",
            "| equation | what it says | home | how | test |",
            "|---|---|---|---|---|",
            *(_row(c.place, c, tests, root, c.kind) for c in by_number),
            "",
            "## Slips in the print",
            "",
            "What the print gets wrong, each with its place in the code (fixed there, or kept and noted) and its test.",
            "",
            "| slip | at | what is wrong in the print | home | test |",
            "|---|---|---|---|---|",
            *(_row(f"{_number(c)} | {c.place}", c, tests, root) for c in by_slip),
            "",
        ]
    )


def _sorted_out(citations: Sequence[Citation]) -> tuple[list[Citation], list[Citation]]:
    return [c for c in citations if c.kind != "slip"], [c for c in citations if c.kind == "slip"]


def _number(citation: Citation) -> str:
    return next((slip.number for slip in SLIPS if slip.is_reported_by(citation)), "")


def _row(head: str, citation: Citation, tests: Mapping[str, Path], root: Path, *kind: str) -> str:
    home = f"[`{citation.home.name}`](../{citation.home.file.relative_to(root).as_posix()})"
    cells = [head, re.sub(r"([|*_<])", r"\\\1", citation.text), home, *kind, ", ".join(_links(citation, tests, root))]
    return f"| {' | '.join(cells)} |"


def _links(citation: Citation, tests: Mapping[str, Path], root: Path) -> Iterator[str]:
    for name in citation.tests:
        file = tests.get(name)
        yield f"[`{name}`](../{file.relative_to(root).as_posix()})" if file else f"`{name}` (missing)"


def _main() -> int:
    root = generated.ROOT
    citations, unread = collect(root / "src" / "tmodes")
    tests = known_tests(root / "tests")
    text = page(citations, tests, root)
    return generated.main(root / "docs" / "equations.md", text, "equations_doc", unread + problems(citations, tests))


if __name__ == "__main__":
    sys.exit(_main())
