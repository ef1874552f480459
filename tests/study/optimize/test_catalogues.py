"""The lightest tubes of a catalogue: all tried, against an independent solution and against a search."""

from __future__ import annotations

import html
import itertools
from pathlib import Path

import numpy as np
import pytest

from study.optimize.tubes import EXAMPLES, catalogue, row_of_tubes
from tmodes import load
from tmodes.study.optimize import Optimum, optimize
from tmodes.study.page.figures import designs_data, write_designs
from tmodes.study.read import read_study

SAG, FREQUENCY = 1.5e-3, 14.0


@pytest.fixture(scope="module")
def pair() -> Optimum:
    """All pairs of tubes."""
    return optimize(read_study(EXAMPLES / "lightest_arm.yaml"))


def test_the_lightest_tube_is_that_of_the_closed_form() -> None:
    found = optimize(read_study(EXAMPLES / "tube.yaml"))
    assert found.exact
    assert (found.designs, found.feasible, found.failed) == (14, 3, 0)
    assert [one.choices["tube"] for one in found.ranked] == ["A50x2", "S40x1", "A60x2"]
    assert found.best is not None
    values = {name: low for name, (low, _) in found.best.quantities.items()}
    np.testing.assert_allclose(values["sag"], 0.8903455683971954, rtol=1e-4)
    np.testing.assert_allclose(values["f1"], 17.09247779447507, rtol=1e-4)
    masses = [one.objectives[0] for one in found.ranked]
    np.testing.assert_allclose(masses, [0.7328707342294283, 0.8656187318068643, 0.8855521371938917], rtol=1e-9)


def test_the_answer_is_a_sentence_against_the_start(tmp_path: Path) -> None:
    """Its numbers are those of the closed form; page, plain data and printed text have the same one."""
    asked = read_study(EXAMPLES / "tube.yaml")
    found = optimize(asked)
    assert found.start is not None
    own = max(
        np.linalg.norm(one["displacement_m"]) for one in load(EXAMPLES / "tube_arm.yaml").static().info()["points"]
    )
    assert found.start.quantities["sag"][0] == pytest.approx(1e3 * own, rel=1e-6)
    mass = {one.number: one.objectives[0] for one in (found.best, found.start)}  # type: ignore[union-attr]
    best, start = mass.values()
    assert (
        f"A50x2: mass of the tube 0.7329 kg (×{best / start:.3g} against the start's {start:.4g} kg)" in found.sentence
    )
    assert (
        "sag of the tip 0.8903 mm (at most 1.5 mm), first frequency 17.09 Hz (at least 14 Hz); 3 of 14 designs"
        in found.sentence
    )
    assert found.info()["sentence"] == next(iter(found.tables())) == found.sentence
    page = write_designs(found, asked, tmp_path / "designs.html").read_text(encoding="utf-8")
    assert html.escape(found.sentence) in page.replace("\u00a0", " ")


def test_a_page_has_every_design_with_the_limits_that_it_breaks(pair: Optimum) -> None:
    asked = read_study(EXAMPLES / "lightest_arm.yaml")
    rows, _, data = designs_data(pair, asked)
    tubes = catalogue(EXAMPLES / "tubes.csv")
    assert len(data["case"]) == len(tubes) ** 2 == pair.designs
    for k, two in enumerate(itertools.product(tubes, tubes)):
        mass, sag, frequency = row_of_tubes([*two], [0.5, 0.4], [1.2, 1.5])
        broken = [text for text, bad in (("sag ≤", sag > SAG), ("f1 ≥", frequency < FREQUENCY)) if bad]
        assert rows.quantities["mass"][k] == pytest.approx(mass, rel=1e-9)
        assert rows.good[k] == (not broken)
        reasons = filter(None, data["reasons"].get(str(k), "").split("; "))
        assert [part[: len(text)] for part, text in zip(reasons, broken, strict=True)] == broken
    best = data["designs"]["best"]
    assert rows.quantities["mass"][best] == rows.quantities["mass"][rows.good].min()
    assert {(one["column"], one["bound"], one["sign"]) for one in data["designs"]["limits"]} == {
        ("sag", 1.5, 1), ("f1", 14.0, -1),
    }  # fmt: skip


def test_the_lightest_pair_is_that_of_an_independent_solution(pair: Optimum) -> None:
    tubes = catalogue(EXAMPLES / "tubes.csv")
    known = []
    for two in itertools.product(tubes, tubes):
        mass, sag, frequency = row_of_tubes([*two], [0.5, 0.4], [1.2, 1.5])
        if sag <= SAG and frequency >= FREQUENCY:
            known.append((mass, (two[0].name, two[1].name)))
    known.sort()
    assert pair.exact
    assert pair.designs == 196
    assert pair.feasible == len(known)
    assert [(one.choices["upper"], one.choices["lower"]) for one in pair.ranked] == [names for _, names in known]


@pytest.mark.nightly
def test_a_search_finds_the_same_from_half_of_the_designs(pair: Optimum) -> None:
    pytest.importorskip("optuna")
    found = optimize(read_study(EXAMPLES / "lightest_arm.yaml"), "tpe", trials=96)
    assert found.designs <= 96
    assert not found.exact
    assert found.best is not None
    assert pair.best is not None
    assert found.best.choices == pair.best.choices
