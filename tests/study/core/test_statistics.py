"""Statistics of columns: intervals that hold as often as they say, by distributions whose numbers are known."""

from __future__ import annotations

import numpy as np
import pytest
import scipy.stats

from study.core.studies import study
from tmodes.errors import InputError
from tmodes.study.answers import quantity_answers
from tmodes.study.statistics import correlations, exact_share, percentile, share_beyond, statistics, tolerance_stack


def test_a_column_with_failed_cases():
    found = statistics([1.0, 2.0, np.nan, 4.0, np.inf])
    assert (found.count, found.failed) == (3, 2)
    assert found.mean == pytest.approx(7 / 3)
    assert found.deviation == pytest.approx(np.std([1, 2, 4], ddof=1))
    assert (found.least, found.largest) == (1.0, 4.0)
    assert found.percentiles[50.0].value == 2.0
    assert found.percentiles[99.0].high == np.inf


def test_a_column_without_values():
    found = statistics([np.nan, np.nan])
    assert (found.count, found.failed) == (0, 2)
    assert np.isnan(found.mean)
    assert share_beyond([np.nan], 0.0).low == 0.0


@pytest.mark.parametrize("percent", [5.0, 50.0, 95.0])
def test_intervals_of_percentiles_hold(percent):
    """In 95 % of repetitions or more, and not always: their width is that of chance."""
    draws = np.random.default_rng(3).exponential(size=(400, 300))
    true = scipy.stats.expon.ppf(percent / 100)
    held = [one.low <= true <= one.high for one in (percentile(row, percent) for row in draws)]
    assert 0.93 <= np.mean(held) <= 0.995


def test_the_order_statistics_of_a_known_case():
    """Of 100 values the median lies between the 40th and the 61st (David, Nagaraja, table of the binomial)."""
    found = percentile(np.arange(1.0, 101.0), 50.0)
    assert (found.low, found.high) == (40.0, 61.0)


def test_wilsons_interval():
    """Against the one of scipy."""
    values = np.r_[np.zeros(37), np.ones(3)]
    found = share_beyond(values, 0.5)
    known = scipy.stats.binomtest(3, 40).proportion_ci(method="wilson")
    assert found.value == 3 / 40
    assert (found.low, found.high) == (pytest.approx(known.low), pytest.approx(known.high))
    assert share_beyond(values, 0.5, above=False).value == 37 / 40


@pytest.mark.parametrize(("count", "cases"), [(3, 40), (0, 200), (200, 200), (1, 1)])
def test_the_interval_of_clopper_and_pearson(count, cases):
    """Against the one of scipy; without a count the rule of three, 3.7/n at 97.5 %."""
    found = exact_share(count, cases)
    known = scipy.stats.binomtest(count, cases).proportion_ci(method="exact")
    assert (found.value, found.low, found.high) == pytest.approx((count / cases, known.low, known.high), abs=1e-12)
    assert (exact_share(0, 0).low, exact_share(0, 0).high) == (0.0, 1.0)


def test_correlations_of_parameters_with_quantities():
    parameters = {name: {"distribution": {"type": "uniform", "low": -1.0, "high": 1.0}} for name in ("x", "y")}
    quantities = {"a": {"expression": "3*x + 1"}, "b": {"expression": "exp(5*y)"}, "c": {"expression": "1 + 0*x"}}
    one = study(parameters, quantities, plan={"type": "sobol", "runs": 1024})
    found = correlations(one.evaluate(0, one.design().values))
    assert found["a"]["x"].linear == pytest.approx(1.0)
    assert found["b"]["y"].rank == pytest.approx(1.0)
    assert found["b"]["y"].linear < 0.9
    assert abs(found["a"]["y"].rank) < 0.02
    assert np.isnan(found["c"]["x"].linear)


def test_the_stack_up_of_a_linear_quantity_is_exact():
    parameters = {
        name: {"distribution": {"type": "uniform", "low": 1.0 - half, "high": 1.0 + half}}
        for name, half in {"a": 0.1, "b": 0.2, "c": 0.3}.items()
    }
    one = study(parameters, {"y": {"expression": "a - 2*b + 3*c"}}, plan={"type": "tolerance"})
    design = one.design()
    found = tolerance_stack(one.evaluate(0, design.values).quantities["y"], design.info)
    assert found.nominal == pytest.approx(2.0)
    assert found.parts["b"] == (pytest.approx(0.4), pytest.approx(-0.4))
    assert found.worst == (pytest.approx(2 - 1.4), pytest.approx(2 + 1.4))
    assert found.corners == (pytest.approx(2 - 1.4), pytest.approx(2 + 1.4))
    assert found.rss[1] - 2 == pytest.approx(np.sqrt(0.1**2 + 0.4**2 + 0.9**2))
    with pytest.raises(InputError, match="the plan `tolerance`"):
        tolerance_stack([1.0], {})


def test_a_percentile_out_of_range():
    with pytest.raises(InputError, match="from 0 to 100"):
        percentile([1.0], 120.0)


def test_of_few_cases_the_ends_are_said_and_no_percentiles() -> None:
    few, many = ({"type": "monte_carlo", "runs": count} for count in (6, 60))
    found = [study(plan=plan) for plan in (few, many)]
    columns = [np.linspace(0.0, 1.0, count)[:, None] for count in (6, 60)]
    said = [quantity_answers(one, one.evaluate(0, own))["y"] for one, own in zip(found, columns, strict=True)]
    assert said[0].endswith("in 6 cases, too few for percentiles.")
    assert "95 % of cases stay below" in said[1]
