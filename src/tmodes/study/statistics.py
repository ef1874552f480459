"""Statistics of the columns of a study: percentiles and shares with confidence intervals, correlations, stack-up.

Cases that have no value are counted apart and left out of all else.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.errors import InputError
from tmodes.study.rows import Rows

__all__ = [
    "CONFIDENCE", "PERCENTILES", "CorrelationEstimate", "Interval", "Stack", "Statistics", "correlations",
    "exact_share", "percentile", "share_beyond", "statistics", "tolerance_stack",
]  # fmt: skip

Array = NDArray[np.float64]

PERCENTILES = (1.0, 5.0, 25.0, 50.0, 75.0, 95.0, 99.0)

CONFIDENCE = 0.95


@dataclass(frozen=True)
class Interval:
    """An estimated ``value`` and the ends of its confidence interval; infinite where there are too few cases."""

    value: float
    low: float
    high: float


@dataclass(frozen=True)
class Statistics:
    """Of a column in its unit: how many cases have a value and how many ``failed``, and what these values are.

    ``deviation``: of the sample, by count - 1. ``percentiles``: with intervals by order statistics, by percent.
    """

    count: int
    failed: int
    mean: float
    deviation: float
    least: float
    largest: float
    percentiles: Mapping[float, Interval]


def statistics(
    values: ArrayLike, percents: Sequence[float] = PERCENTILES, confidence: float = CONFIDENCE
) -> Statistics:
    """The statistics of a column (m,), of which not-a-number are cases without a value; no cases give not-a-number."""
    whole = np.asarray(values, dtype=float)
    known = np.sort(whole[np.isfinite(whole)])
    count = len(known)
    return Statistics(
        count,
        len(whole) - count,
        float(known.mean()) if count else np.nan,
        float(known.std(ddof=1)) if count > 1 else np.nan,
        float(known[0]) if count else np.nan,
        float(known[-1]) if count else np.nan,
        {percent: _percentile(known, percent, confidence) for percent in percents},
    )


def percentile(values: ArrayLike, percent: float, confidence: float = CONFIDENCE) -> Interval:
    """A percentile of a column (m,), linear between two values, with an interval that needs no distribution.

    The true percentile lies between two order statistics with at least this confidence, by the binomial distribution
    of the number of values below it (David, Nagaraja, Order Statistics, 2003, ch. 7.1).
    """
    whole = np.asarray(values, dtype=float)
    return _percentile(np.sort(whole[np.isfinite(whole)]), percent, confidence)


def _percentile(known: Array, percent: float, confidence: float) -> Interval:
    if not 0 <= percent <= 100:
        raise InputError("percent", repr(percent), "a number from 0 to 100", "write 95 for the 95th percentile")
    count, share = len(known), percent / 100
    if not count:
        return Interval(np.nan, -np.inf, np.inf)
    low = _binomial((1 - confidence) / 2, count, share)
    high = _binomial((1 + confidence) / 2, count, share) + 1
    return Interval(
        float(np.percentile(known, percent)),
        float(known[low - 1]) if low >= 1 else -np.inf,
        float(known[high - 1]) if high <= count else np.inf,
    )


def _binomial(probability: float, count: int, share: float) -> int:
    """The least number of successes that is not exceeded with at least this probability.

    As ``scipy.stats.binom.ppf``, without the time that loading its package takes.
    """
    from scipy.special import bdtr, bdtrik

    if share in (0.0, 1.0):
        return int(count * share)
    found = int(np.ceil(bdtrik(probability, count, share)))
    return found - 1 if found > 0 and bdtr(found - 1, count, share) >= probability - 1e-12 else found


def share_beyond(values: ArrayLike, limit: float, *, above: bool = True, confidence: float = CONFIDENCE) -> Interval:
    """Share [-] of the cases with a value beyond a limit, with the interval of Wilson.

    E. B. Wilson, Journal of the American Statistical Association 22, 1927. No cases give not-a-number, from 0 to 1.
    """
    from scipy.special import ndtri

    whole = np.asarray(values, dtype=float)
    known = whole[np.isfinite(whole)]
    count = len(known)
    if not count:
        return Interval(np.nan, 0.0, 1.0)
    share = float((known > limit).mean() if above else (known < limit).mean())
    square = float(ndtri((1 + confidence) / 2)) ** 2
    middle = (share + square / (2 * count)) / (1 + square / count)
    half = np.sqrt(square * (share * (1 - share) / count + square / (4 * count**2))) / (1 + square / count)
    return Interval(share, max(0.0, float(middle - half)), min(1.0, float(middle + half)))


def exact_share(count: int, cases: int, confidence: float = CONFIDENCE) -> Interval:
    """Share [-] of ``count`` among independent ``cases``, with an interval that covers it at least so often.

    C. J. Clopper, E. S. Pearson, Biometrika 26, 1934: quantiles of the beta distribution. No cases give not-a-number.
    """
    from scipy.special import betaincinv

    if not cases:
        return Interval(np.nan, 0.0, 1.0)
    half, others = (1 - confidence) / 2, cases - count
    low = float(betaincinv(count, others + 1, half)) if count else 0.0
    high = float(betaincinv(count + 1, others, 1 - half)) if others else 1.0
    return Interval(count / cases, low, high)


@dataclass(frozen=True)
class CorrelationEstimate:
    """Of a parameter with a quantity: Pearson's, and Spearman's of the ranks; not-a-number where one is constant."""

    linear: float
    rank: float


def correlations(rows: Rows) -> dict[str, dict[str, CorrelationEstimate]]:
    """Correlations of each parameter with each quantity, by name of the quantity, then of the parameter.

    Of cases that have a value; a choice is taken by the number of its entry, which says little.
    """
    from scipy.stats import rankdata

    found: dict[str, dict[str, CorrelationEstimate]] = {}
    for name, values in rows.quantities.items():
        known = np.isfinite(values)
        y, ranks = values[known], rankdata(values[known])
        found[name] = {
            parameter: CorrelationEstimate(_pearson(x[known], y), _pearson(rankdata(x[known]), ranks))
            for parameter, x in rows.parameters.items()
        }
    return found


def _pearson(one: Array, other: Array) -> float:
    if len(one) < 2:
        return float("nan")
    x, y = one - one.mean(), other - other.mean()
    size = np.sqrt((x @ x) * (y @ y))
    return float(x @ y / size) if size > 0 else float("nan")


@dataclass(frozen=True)
class Stack:
    """A tolerance stack-up of one quantity, in its unit.

    ``parts``: by parameter how far its ``low`` and its ``high`` move the quantity from ``nominal``. ``worst``: least
    and largest where all parts act the same way, ``rss`` by the root of the sum of squares of the parts each way, and
    ``corners`` of the cases with all parameters at ends, None where they were not run. Where a part is not a number,
    what follows from it is none.
    """

    nominal: float
    parts: Mapping[str, tuple[float, float]]
    worst: tuple[float, float]
    rss: tuple[float, float]
    corners: tuple[float, float] | None


def tolerance_stack(values: ArrayLike, info: Mapping[str, Any]) -> Stack:
    """The stack-up of a column (m,) of the cases of the plan ``tolerance``; ``info`` of its design.

    Raises :class:`tmodes.errors.InputError` for the cases of another plan.
    """
    whole = np.asarray(values, dtype=float)
    if not {"nominal", "low", "high", "corners"} <= info.keys():
        raise InputError(
            "info", "that of another plan", "that of the plan `tolerance`", "write `plan: {type: tolerance}`"
        )
    nominal = float(whole[info["nominal"]])
    parts = {
        name: (float(whole[info["low"][name]]) - nominal, float(whole[info["high"][name]]) - nominal)
        for name in info["low"]
    }
    both = np.array([*parts.values()]).reshape(-1, 2)
    down, up = np.minimum(both.min(axis=1), 0), np.maximum(both.max(axis=1), 0)
    first, last = info["corners"]
    ends = whole[first:last]
    return Stack(
        nominal,
        parts,
        (nominal + float(down.sum()), nominal + float(up.sum())),
        (nominal - float(np.sqrt(down @ down)), nominal + float(np.sqrt(up @ up))),
        (float(ends.min()), float(ends.max())) if last > first else None,
    )
