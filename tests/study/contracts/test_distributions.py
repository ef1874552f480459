"""What every distribution keeps, those of a user's script among them: a logistic one is defined here."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, Literal

import numpy as np
import pytest
import scipy.stats
from pydantic import Field

from study.core.studies import study
from tmodes.study.distributions import DISTRIBUTIONS, Distribution
from tmodes.study.distributions.contract import Array, level, share_of, size
from tmodes.study.study import Study


class Logistic(Distribution):
    """A logistic distribution."""

    type: Literal["logistic"] = Field(description="kind of distribution")
    mean: float = level("mu", "mean")
    scale: float = size("s", "scale")

    def at(self, share: Array) -> Array:
        """The logit of the share."""
        return self.mean + self.scale * np.log(share / (1 - share))


@pytest.fixture(autouse=True, scope="module")
def logistic() -> Iterator[None]:
    """It is registered where it is defined."""
    DISTRIBUTIONS.register(Logistic)
    yield
    DISTRIBUTIONS.unregister("logistic")


NORMAL = {"type": "normal", "mean": 2.0, "deviation": 0.5}
MEASURED = [0.3, 0.9, 0.1, 0.1, 0.5]

EXAMPLES: dict[str, tuple[dict[str, Any], Any]] = {
    "uniform": ({"low": -1.0, "high": 3.0}, scipy.stats.uniform(-1, 4)),
    "loguniform": ({"low": 0.1, "high": 100.0}, scipy.stats.loguniform(0.1, 100)),
    "normal": ({"mean": 2.0, "deviation": 0.5}, scipy.stats.norm(2, 0.5)),
    "lognormal": ({"median": 2.0, "sigma_log": 0.4}, scipy.stats.lognorm(0.4, scale=2)),
    "triangular": ({"low": 1.0, "mode": 1.5, "high": 4.0}, scipy.stats.triang(1 / 6, 1, 3)),
    "truncated": ({"distribution": NORMAL, "low": 1.0, "high": 2.2}, scipy.stats.truncnorm(-2, 0.4, 2, 0.5)),
    "empirical": ({"values": MEASURED}, scipy.stats.ecdf(MEASURED).cdf),
    "discrete": ({"values": [1.0, 2.0, 5.0], "weights": [1.0, 2.0, 1.0]},
                 scipy.stats.rv_discrete(values=([1, 2, 5], [0.25, 0.5, 0.25]))),
    "logistic": ({"mean": 1.0, "scale": 0.2}, scipy.stats.logistic(1, 0.2)),
}  # fmt: skip
"""One of each distribution, with an independent one; one without an entry fails."""


def made(name: str) -> Any:
    """The distribution of an example."""
    return Distribution.of({"type": name, **EXAMPLES[name][0]})


NAMES = sorted({*DISTRIBUTIONS, "logistic"})


@pytest.mark.parametrize("name", NAMES)
def test_its_quantile_function_rises_within_its_ends(name):
    one = made(name)
    shares = np.linspace(0.0014, 0.9986, 2001)
    values = np.asarray(one.at(shares))
    assert values.shape == shares.shape
    assert np.isfinite(values).all()
    assert (np.diff(values) >= 0).all()
    low, high = one.ends
    assert low < high
    assert (values >= low).all()
    assert (values <= high).all()
    assert low <= one.middle <= high


@pytest.mark.parametrize("name", NAMES)
def test_draws_follow_an_independent_distribution(name):
    """The largest distance of both distribution functions is that of chance (Kolmogorov-Smirnov, 1 in 10,000)."""
    drawn = np.sort(made(name).at(np.random.default_rng(1).random(4000)))
    known = EXAMPLES[name][1]
    share_of_known = known.cdf if hasattr(known, "cdf") else known.evaluate
    values = np.unique(drawn)
    below = np.searchsorted(drawn, values, side="right") / len(drawn)
    distance = np.abs(below - share_of_known(values)).max()
    assert distance < scipy.stats.kstwo.ppf(1 - 1e-4, len(drawn))


@pytest.mark.parametrize("name", NAMES)
def test_it_survives_a_round_trip_through_data(name):
    given = {"type": name, **EXAMPLES[name][0]}
    first = study({"x": {"distribution": given}})
    again = Study.from_data(first.data)
    assert again.sheet == first.sheet
    assert again.design().values.tobytes() == first.design().values.tobytes()


@pytest.mark.parametrize("name", NAMES)
def test_the_share_below_a_value_is_that_of_its_quantile(name):
    one = made(name)
    if not one.listed and name != "empirical":
        assert share_of(one, float(one.at(np.array([0.3]))[0])) == pytest.approx(0.3, abs=1e-9)


def test_both_ways_to_write_a_lognormal():
    """Mean and deviation are those of the number: a lognormal of mean 3, deviation 1.2 has these moments."""
    given = Distribution.of({"type": "lognormal", "mean": 3.0, "deviation": 1.2})
    variance = np.log(1 + 0.16)
    same = scipy.stats.lognorm(np.sqrt(variance), scale=3.0 / np.sqrt(1.16))
    assert (same.mean(), same.std()) == (pytest.approx(3.0), pytest.approx(1.2))
    shares = np.array([0.01, 0.3, 0.99])
    np.testing.assert_allclose(given.at(shares), same.ppf(shares), rtol=1e-12)


def test_a_grid_of_a_normal_goes_to_three_deviations():
    low, high = Distribution.of({"type": "normal", "mean": 1.0, "deviation": 2.0}).ends
    assert (low, high) == (pytest.approx(-5.0), pytest.approx(7.0))
