"""Reductions: one number of each run, from a series by a rule; and how it follows from sums or from samples."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tmodes.compile.lanes.series import SUMS
from tmodes.errors import InputError
from tmodes.io.words import nearest
from tmodes.simulation.batch.wanted import time_weights

__all__ = ["HOWS", "Reduction", "of_samples", "of_sums", "refuse_unknown_rules"]

Array = NDArray[np.float64]

HOWS = ("max", "min", "max_abs", "mean", "rms", "end", "range", "time_of_max")
"""Rules by name; ``percentile:P`` is one more, with P from 0 to 100."""

_PERCENTILE = "percentile:"


@dataclass(frozen=True)
class Reduction:
    """One number of each run: a ``series`` by its name, and ``how`` it is reduced.

    ``max``, ``min``, ``max_abs`` (the largest size), ``mean`` and ``rms`` (over time, by the trapezoidal rule), ``end``
    (the last sample), ``range`` (``max`` less ``min``), ``time_of_max`` [s] (the first), or ``percentile:P`` of the
    samples (linear between two of them).
    """

    series: str
    how: str

    @property
    def percentile(self) -> float | None:
        """P of a percentile, None of all others."""
        return float(self.how.removeprefix(_PERCENTILE)) if self.how.startswith(_PERCENTILE) else None

    def unit_of(self, unit: str) -> str:
        """The unit of the number, from that of the series."""
        return "s" if self.how == "time_of_max" else unit

    def __str__(self) -> str:
        return f"{self.how} of {self.series}"


def refuse_unknown_rules(reductions: Sequence[Reduction]) -> None:
    """Raise :class:`tmodes.errors.InputError` for a rule that is none, and for no reduction at all."""
    if not reductions:
        raise InputError("reductions", "none", "at least one", 'write Reduction("tip.speed", "max")')
    for one in reductions:
        if one.how in HOWS:
            continue
        expected = f"one of {', '.join(HOWS)}, or {_PERCENTILE}P with P from 0 to 100"
        wrong = f"the rule {one.how!r}"
        word, _, percent = one.how.partition(":")
        if not (one.how.startswith(_PERCENTILE) and _is_share(percent)):
            close = nearest(word, (*HOWS, "percentile"))
            close = f"percentile:{percent if _is_share(percent) else 95}" if close == "percentile" else close
            raise InputError(f"reduction of {one.series}", wrong, expected, f"did you mean `{close}`?" if close else "")


def _is_share(text: str) -> bool:
    """Whether a text is a number of percent."""
    try:
        return 0 <= float(text) <= 100
    except ValueError:
        return False


def of_sums(one: Reduction, sums: Array) -> Array:
    """The numbers (...) of a rule but percentiles, from ``sums`` (..., 6) of a series."""
    largest, least, mean, squares, end, time = (sums[..., k] for k in range(len(SUMS)))
    found = {
        "max": lambda: largest, "min": lambda: least, "mean": lambda: mean, "end": lambda: end,
        "max_abs": lambda: np.maximum(np.abs(largest), np.abs(least)), "rms": lambda: np.sqrt(squares),
        "range": lambda: largest - least, "time_of_max": lambda: time,
    }  # fmt: skip
    return found[one.how]()


def of_samples(one: Reduction, values: Array, times: Array) -> Array:
    """The numbers (k,) of a rule, from ``values`` (k, n) of a series at ``times`` (n,) [s]."""
    if one.percentile is not None:
        return np.asarray(np.percentile(values, one.percentile, axis=1), dtype=float)
    weights = time_weights(times)
    found = {
        "max": lambda: values.max(axis=1), "min": lambda: values.min(axis=1), "mean": lambda: values @ weights,
        "end": lambda: values[:, -1], "max_abs": lambda: np.abs(values).max(axis=1),
        "rms": lambda: np.sqrt(values**2 @ weights), "range": lambda: values.max(axis=1) - values.min(axis=1),
        "time_of_max": lambda: times[values.argmax(axis=1)],
    }  # fmt: skip
    return np.asarray(found[one.how](), dtype=float)
