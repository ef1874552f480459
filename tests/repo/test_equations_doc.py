"""Every equation of the paper has a home in the code and a test; the tool that says so can say no."""

from __future__ import annotations

from pathlib import Path

import pytest

from citations import Citation, Home, citations_in, known_tests
from equations_doc import EQUATIONS, SLIPS, collect, page, problems

ROOT = Path(__file__).resolve().parents[2]
HOME = Home(ROOT / "src" / "tmodes" / "part.py", "tmodes.part")


def one(text: str) -> Citation:
    (citation,), problems = citations_in(text, HOME)
    assert not problems
    return citation


def complete() -> list[Citation]:
    """A citation for each equation and each slip, all of one test."""
    texts = [f"Eq. ({n}) [stated]: a = b. {{test_x}}" for n in EQUATIONS]
    texts += [f"Slip {slip.places[0]}: so {slip.word.split('|')[0].rstrip('?')} {{test_x}}" for slip in SLIPS]
    return [one(text) for text in texts]


def test_every_equation_has_a_home() -> None:
    citations, unread = collect(ROOT / "src" / "tmodes")
    assert unread + problems(citations, known_tests(ROOT / "tests")) == []


def test_page_of_equations_is_up_to_date() -> None:
    citations, _ = collect(ROOT / "src" / "tmodes")
    written = (ROOT / "docs" / "equations.md").read_text(encoding="utf-8")
    assert written == page(citations, known_tests(ROOT / "tests"), ROOT), "run: python tools/equations_doc.py"


def test_citation_over_lines_and_two_tests() -> None:
    found = one("Words.\n\nEq. (24) [stated]: E = 1/2\n   C xi^2. {test_a, test_b}\n")
    assert (found.place, found.kind, found.text) == ("(24)", "stated", "E = 1/2 C xi^2")
    assert found.tests == ("test_a", "test_b")


def test_range_covers_its_numbers() -> None:
    found = one("Eq. (29)-(33) [derived]: the lines. {test_a}")
    assert (found.place, list(found.numbers)) == ("(29)-(33)", [29, 30, 31, 32, 33])


def test_citations_that_follow_one_another_are_parted() -> None:
    found, problems = citations_in("Eq. (1) [stated]: a. {test_a}\nSlip (p. 61): b {test_b}", HOME)
    assert [(c.place, c.kind, c.text) for c in found] == [("(1)", "stated", "a"), ("(p. 61)", "slip", "b")]
    assert not problems


@pytest.mark.parametrize(
    "text",
    [
        "Eq. (24) [guessed]: a. {test_a}",
        "Eq. (24) [stated]: a, and no test.",
        "Eq. (24) [stated] a. {test_a}",
        "Slip (44): no test.",
        "Eq. (1) [stated]: a forgotten brace. Eq. (2) [stated]: b. {test_b}",
    ],
)
def test_unreadable_citation_is_reported(text: str) -> None:
    _, problems = citations_in(text, HOME)
    assert len(problems) == 1
    assert problems[0].startswith("tmodes.part: cannot read")


def test_plain_mention_is_no_citation() -> None:
    assert citations_in("Je, Eq. (13), and (40); Eq. (39).", HOME) == ([], [])


def test_complete_citations_have_no_problem() -> None:
    assert problems(complete(), {"test_x"}) == []


@pytest.mark.parametrize("missing", range(len(EQUATIONS) + len(SLIPS)))
def test_each_missing_home_is_reported(missing: int) -> None:
    citations = complete()
    gone = citations.pop(missing)
    (found,) = problems(citations, {"test_x"})
    assert f"{gone.place} has no home" in found if gone.kind != "slip" else found.startswith("slip S")


def test_missing_test_unknown_equation_unknown_slip_are_reported() -> None:
    citations = [
        *complete(),
        one("Eq. (45) [stated]: none. {test_x}"),
        one("Slip (7): none {test_x}"),
        one("Eq. (3) [stated]: a. {test_gone}"),
    ]
    found = problems(citations, {"test_x"})
    assert len(found) == 3
    assert "no equation (45)" in found[0]
    assert "slip (7) is not in the list" in found[1]
    assert "test_gone is no test; it is named by the citations of (3)" in found[2]


def test_page_links_to_home_and_test() -> None:
    text = page([one("Eq. (24) [stated]: F = a*b*c. {test_x}")], {"test_x": ROOT / "tests" / "test_part.py"}, ROOT)
    assert (
        r"| (24) | F = a\*b\*c | [`tmodes.part`](../src/tmodes/part.py) | stated | [`test_x`](../tests/test_part.py) |"
        in text
    )


def test_known_tests_are_found_in_classes_too(tmp_path: Path) -> None:
    (tmp_path / "test_one.py").write_text(
        "class TestA:\n    def test_in(self): ...\ndef test_out(): ...\ndef helper(): ...\n"
    )
    assert known_tests(tmp_path) == dict.fromkeys(("test_in", "test_out"), tmp_path / "test_one.py")
