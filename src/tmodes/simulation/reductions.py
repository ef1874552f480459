"""Reductions: one number of each run from an output over time, by a rule; stated once for loops, samples and slopes."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmodes.compile.lanes.series import SUMS
from tmodes.errors import InputError
from tmodes.io.words import nearest

__all__ = [
    "RULES", "SAMPLED", "SMOOTH", "Reduction", "folded", "of_samples", "of_sums", "refuse_unknown_rules",
    "time_weights", "with_slope",
]  # fmt: skip

Array = NDArray[np.float64]


class Rule(NamedTuple):
    """A rule on the sums of a series that loops keep (:data:`tmodes.compile.lanes.series.SUMS`), as (...) by name.

    ``slope``: whether its number has a derivative by the samples everywhere.
    """

    of: Callable[[Any], Any]
    slope: bool = False
    is_time: bool = False


RULES = {
    "max": Rule(lambda s: s["largest"]),
    "min": Rule(lambda s: s["least"]),
    "max_abs": Rule(lambda s: np.maximum(np.abs(s["largest"]), np.abs(s["least"]))),
    "mean": Rule(lambda s: s["sum"], slope=True),
    "rms": Rule(lambda s: np.sqrt(s["squares"]), slope=True),
    "end": Rule(lambda s: s["end"], slope=True),
    "range": Rule(lambda s: s["largest"] - s["least"]),
    "time_of_max": Rule(lambda s: s["time"], is_time=True),
}
"""Rules by name, which run in the loops too."""


SMOOTH = tuple(name for name, rule in RULES.items() if rule.slope)
"""Those that have a derivative by the samples everywhere."""


def _settling(values: Array, times: Array, band: float) -> Array:
    outside = np.abs(values - values[:, -1:]) > band
    last = len(times) - 1 - outside[:, ::-1].argmax(axis=1)
    return np.where(outside.any(axis=1), times[np.minimum(last + 1, len(times) - 1)], times[0])


class SampledRule(NamedTuple):
    """A rule on samples (k, n) at times (n,) with an argument, which lies between bounds; ``stands``: what it is."""

    of: Callable[[Array, Array, float], Array]
    stands: str
    bounds: tuple[float, float]
    usual: str
    is_time: bool = False


SAMPLED = {
    "percentile": SampledRule(
        lambda values, times, share: np.asarray(np.percentile(values, share, axis=1), dtype=float),
        "P with P from 0 to 100", (0.0, 100.0), "95",
    ),
    "settling": SampledRule(_settling, "B with B the half width of the band", (0.0, np.inf), "0.001", is_time=True),
}  # fmt: skip
"""Rules ``NAME:ARGUMENT`` that need the samples of a series, which loops write for them."""


@dataclass(frozen=True)
class Reduction:
    """One number of each run: a ``series``, an output by its name, and ``how`` it is reduced.

    ``max``, ``min``, ``max_abs`` (the largest size), ``mean`` and ``rms`` (over time, by the trapezoidal rule), ``end``
    (the last sample), ``range`` (``max`` less ``min``), ``time_of_max`` [s] (the first), ``percentile:P`` of the
    samples (linear between two of them), or ``settling:B`` [s]: the first sample from which on the series stays within
    B, in its own unit, of its last value.
    """

    series: str
    how: str

    @property
    def sampled(self) -> tuple[SampledRule, float] | None:
        """The rule on samples and its argument; None where the sums are enough."""
        word, colon, argument = self.how.partition(":")
        return (SAMPLED[word], float(argument)) if colon else None

    def unit_of(self, unit: str) -> str:
        """The unit of the number, from that of the series."""
        sampled = self.sampled
        return "s" if (sampled[0] if sampled else RULES[self.how]).is_time else unit

    def __str__(self) -> str:
        return f"{self.how} of {self.series}"


def refuse_unknown_rules(reductions: Sequence[Reduction]) -> None:
    """Raise :class:`tmodes.errors.InputError` for a rule that is none, and for no reduction at all."""
    if not reductions:
        raise InputError("reductions", "none", "at least one", 'write Reduction("tip.speed", "max")')
    for one in reductions:
        word, colon, argument = one.how.partition(":")
        if one.how in RULES or (colon and word in SAMPLED and _fits(argument, SAMPLED[word].bounds)):
            continue
        sampled = [f"{name}:{rule.stands}" for name, rule in SAMPLED.items()]
        close = nearest(word, [*RULES, *SAMPLED])
        if close in SAMPLED:
            rule = SAMPLED[close]
            close = f"{close}:{argument if _fits(argument, rule.bounds) else rule.usual}"
        expected = f"one of {', '.join([*RULES, *sampled])}"
        hint = f"did you mean `{close}`?" if close else ""
        raise InputError(f"reduction of {one.series}", f"the rule {one.how!r}", expected, hint)


def _fits(text: str, bounds: tuple[float, float]) -> bool:
    """Whether a text is a number between bounds."""
    try:
        return bounds[0] <= float(text) <= bounds[1]
    except ValueError:
        return False


def time_weights(times: Array) -> Array:
    """Weights (n,) of samples in a mean over time, by the trapezoidal rule; the last may follow a shorter step."""
    if len(times) < 2:
        return np.ones(len(times))
    steps = np.diff(times) / (times[-1] - times[0])
    return (np.append(steps, 0.0) + np.insert(steps, 0, 0.0)) / 2


def folded(series: Array, times: Array, weights: Array) -> Array:
    """The sums of series (n, m), (m, 6), in the order of :data:`tmodes.compile.lanes.series.SUMS`.

    ``weights`` (n,): of the samples in a mean over time.
    """
    if not len(series):
        return np.full((series.shape[1], len(SUMS)), np.nan)
    sums = series.max(axis=0), series.min(axis=0), weights @ series, weights @ series**2, series[-1]
    return np.column_stack([*sums, times[series.argmax(axis=0)]])


def of_sums(one: Reduction, sums: Array) -> Array:
    """The numbers (...) of a rule from ``sums`` (..., 6) of a series."""
    return RULES[one.how].of({name: sums[..., k] for k, name in enumerate(SUMS)})


def of_samples(one: Reduction, values: Array, times: Array) -> Array:
    """The numbers (k,) of a rule, from ``values`` (k, n) of a series at ``times`` (n,) [s]."""
    if sampled := one.sampled:
        return sampled[0].of(values, times, sampled[1])
    return of_sums(one, folded(values.T, times, time_weights(times)))


def with_slope(one: Reduction, values: Array, times: Array) -> tuple[float, Array]:
    """The number of a rule with a ``slope`` and its derivatives (n,) by the samples ``values`` (n,) at ``times``."""
    weights, last = time_weights(times), np.zeros_like(times)
    last[-1] = 1.0
    sums = folded(values[:, None], times, weights)[0]
    by = {"sum": weights, "squares": 2 * weights * values, "end": last}
    tiny = np.spacing(1.0) ** 2 * 1j
    moved = {name: of_sums(one, sums + tiny * (np.array(SUMS) == name)).imag / tiny.imag for name in by}
    return float(of_sums(one, sums)), np.sum([moved[name] * shares for name, shares in by.items()], axis=0)
