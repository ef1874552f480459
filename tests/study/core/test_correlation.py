"""Parameters that vary together: by a Gaussian copula, whose matrix must be one."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
import scipy.stats

from study.core.studies import study
from tmodes.errors import InputErrors
from tmodes.study.space import nearest_correlation

PARAMETERS = {
    "a": {"distribution": {"type": "normal", "mean": 1.0, "deviation": 2.0}},
    "b": {"distribution": {"type": "uniform", "low": 0.0, "high": 1.0}},
    "c": {"distribution": {"type": "lognormal", "median": 1.0, "sigma_log": 0.5}},
}


def correlated(*pairs, **more):
    """A study of 20,000 cases with correlations."""
    known = [{"between": [one, other], "value": value} for one, other, value in pairs]
    return study({**PARAMETERS, **more}, correlations=known, plan={"type": "monte_carlo", "runs": 20_000})


def test_ranks_are_correlated_as_those_of_the_normals():
    """Spearman's correlation is 6/pi asin(rho/2); each parameter alone keeps its distribution."""
    values = correlated(("a", "b", 0.7), ("c", "b", -0.4)).design().values
    found: Any = scipy.stats.spearmanr(values)
    ranks = found.statistic
    for (i, j), rho in {(0, 1): 0.7, (1, 2): -0.4, (0, 2): 0.0}.items():
        assert ranks[i, j] == pytest.approx(6 / np.pi * np.arcsin(rho / 2), abs=0.03)
    assert np.corrcoef(values[:, 0], scipy.stats.norm.ppf(values[:, 1]))[0, 1] == pytest.approx(0.7, abs=0.02)
    assert scipy.stats.kstest(values[:, 0], "norm", (1, 2)).pvalue > 1e-4
    assert scipy.stats.kstest(values[:, 1], "uniform").pvalue > 1e-4
    assert scipy.stats.kstest(values[:, 2], "lognorm", (0.5,)).pvalue > 1e-4


def test_a_pair_that_is_added_leaves_the_first_parameter_alone():
    assert np.array_equal(correlated(("a", "b", 0.7)).design().values[:, 0], correlated().design().values[:, 0])


def test_correlations_that_exclude_each_other_name_the_nearest_that_do_not():
    with pytest.raises(InputErrors) as caught:
        correlated(("a", "b", 0.9), ("b", "c", 0.9), ("a", "c", -0.9))
    text = str(caught.value)
    assert "their matrix has the eigenvalue -0.8" in text  # 1 - 2*0.9
    assert "a and b 0.4" in text
    near = nearest_correlation(np.array([[1, 0.9, -0.9], [0.9, 1, 0.9], [-0.9, 0.9, 1]]), 1e-3)
    assert np.linalg.eigvalsh(near)[0] > 5e-4
    assert np.diag(near).tolist() == [1.0] * 3


@pytest.mark.parametrize(
    ("pairs", "message"),
    [
        ([("a", "d", 0.3)], "correlations.0.between.1 must be a parameter with values, got 'd', a choice"),
        ([("a", "z", 0.3)], "unknown name 'z'"),
        ([("a", "a", 0.3)], "a and a, the same parameter"),
        ([("a", "b", 0.3), ("b", "a", 0.2)], "b and a, given twice"),
        ([("a", "b", 1.0)], "a number between -1 and 1"),
        ([("a", "b", -1.0)], "greater than -1"),
        ([("a", "b", float("nan"))], "not a number"),
    ],
)
def test_pairs_that_cannot_be(pairs, message):
    with pytest.raises(InputErrors) as caught:
        correlated(*pairs, d={"choices": [{"name": "x", "set": {}}]})
    assert message in str(caught.value)
