"""Confidence intervals hold: of 100 repetitions 90 to 99 contain the exact index."""

from __future__ import annotations

import numpy as np
import pytest

from study.sensitivity.cases import CASES
from study.sensitivity.cases import study as study_of
from tmodes.study.sensitivity import sensitivity

REPETITIONS = 100
SAMPLES = 256


@pytest.mark.nightly("_other", "lognormals", "sag")
@pytest.mark.parametrize("name", CASES)
def test_intervals_contain_the_exact_index_in_about_95_of_100_repetitions(name: str) -> None:
    known = CASES[name]
    asked = study_of(known.formula, known.inputs)
    exact = {"first": known.first, "total": known.total}
    held = {index: np.zeros(len(known.inputs)) for index in exact}
    for seed in range(REPETITIONS):
        found = sensitivity(asked, samples=SAMPLES, seed=seed)
        for index, values in exact.items():
            low, high = found.intervals[index][0].T
            held[index] += (low <= values) & (values <= high)
    for index, counts in held.items():
        assert ((counts >= 88) & (counts <= 100)).all(), (index, counts)
        assert 90 <= counts.mean() <= 99, (index, counts)


def test_intervals_of_pairs_contain_the_exact_index() -> None:
    known = CASES["ishigami"]
    asked = study_of(known.formula, known.inputs)
    held = dict.fromkeys(known.second, 0)
    for seed in range(REPETITIONS):
        found = sensitivity(asked, samples=SAMPLES, seed=seed, second_order=True)
        ends = found.intervals["second"][0]
        for pair, value in known.second.items():
            held[pair] += bool(ends[pair][0] <= value <= ends[pair][1])
    assert all(88 <= count <= 100 for count in held.values()), held
    assert 90 <= np.mean(list(held.values())) <= 99, held


@pytest.mark.parametrize("name", CASES)
def test_indices_are_near_the_exact_ones(name: str) -> None:
    known = CASES[name]
    found = sensitivity(study_of(known.formula, known.inputs), samples=4096)
    np.testing.assert_allclose(found.first[0], known.first, atol=0.03)
    np.testing.assert_allclose(found.total[0], known.total, atol=0.03)
    half = (found.intervals["total"][0][:, 1] - found.intervals["total"][0][:, 0]) / 2
    assert (half < 0.05).all()
