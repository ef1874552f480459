"""The page of figures says what the figures say, and an aim that is not reached is not called reached."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

import performance_doc
from performance_aims import Aim, aims

ROOT = Path(__file__).resolve().parents[2]
FIGURES = json.loads((ROOT / "docs" / "performance.json").read_text(encoding="utf-8"))


def one(name: str, seconds: float, cores: int = 1) -> dict[str, Any]:
    return {"name": name, "seconds": {"median": seconds}, "cores": cores}


def figures(**others: float) -> dict[str, Any]:
    """One size of 36 joints: ours takes 2 s, a lane 0.5 s, on two cores 0.3 s."""
    ours = [one("tmodes, 1 lane", 2.0), one("tmodes, 4 lanes", 0.5), one("tmodes, 4 lanes on 2 cores", 0.3, 2)]
    start = {"equations": 0.5, "compile": 0.6, "reload": 9e-3}
    size = {"n": 36, "contenders": [*ours, *(one(name, seconds) for name, seconds in others.items())], "start": start}
    return {"sizes": [size], "scaling": {"compile": 1.2, "Pinocchio": 9.0}}


def test_page_is_made_from_the_figures() -> None:
    assert (ROOT / "docs" / "performance.md").read_text(encoding="utf-8") == performance_doc.page(FIGURES)


def test_page_names_machine_and_date() -> None:
    page = performance_doc.page(FIGURES)
    assert FIGURES["machine"]["date"] in page
    assert FIGURES["machine"]["processor"] in page


def test_figures_are_those_of_the_command() -> None:
    """Every time has an error that is small, or the contender did not compute the same robot."""
    errors = [one["error"] for size in FIGURES["sizes"] for one in size["contenders"]]
    assert errors
    assert max(errors) < 1e-10


def test_each_aim_is_judged_by_its_own_ratio() -> None:
    found = {aim.words: (aim.got, aim.reached) for aim in aims(figures(Pinocchio=8.0, MuJoCo=7.9))}
    assert found == {
        "36 joints: faster than Pinocchio": (4.0, True),
        "36 joints: faster than MuJoCo": (3.95, False),
        "36 joints: a lane of many cheaper than one": (4.0, True),
        "36 joints: two cores over one": (pytest.approx(5 / 3), False),
        "36 joints: compile, equations included": (1.1, False),
        "36 joints: code from the cache": (9.0, True),
        "growth of compile with the joints, as a power": (1.2, False),
    }


def test_bounds_count_as_reached() -> None:
    assert Aim("", 4.0, 4.0, at_least=True).reached
    assert Aim("", 4.0, 4.0, at_least=False).reached


def test_words_are_of_the_figures() -> None:
    info = figures(Pinocchio=8.0, MuJoCo=1.0)
    info["sizes"][0]["limit"] = {"throughput": 1.5}
    page = " ".join(performance_doc._words(info))
    assert "With 36 joints one evaluation takes 2e+06 µs" in page
    assert "4.0 times less than Pinocchio, 2.0 times more than MuJoCo" in page
    assert "at best 1.5e+06 µs, 75 % of what is taken" in page


def test_what_is_not_reached_is_said() -> None:
    page = "\n".join(performance_doc._aims(figures(Pinocchio=4.0)))
    assert "2 of 6 aims are reached" in page
    assert "| 36 joints: faster than Pinocchio | 2 times | at least 4 times | **no** |" in page
