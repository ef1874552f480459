"""The lightest tubes of a catalogue: all tried, against an independent solution and against a search."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

from study.optimize.tubes import EXAMPLES, catalogue, row_of_tubes
from tmodes.study.optimize import Optimum, optimize
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


def test_a_search_finds_the_same_from_half_of_the_designs(pair: Optimum) -> None:
    pytest.importorskip("optuna")
    found = optimize(read_study(EXAMPLES / "lightest_arm.yaml"), "tpe", trials=96)
    assert found.designs <= 96
    assert not found.exact
    assert found.best is not None
    assert pair.best is not None
    assert found.best.choices == pair.best.choices
