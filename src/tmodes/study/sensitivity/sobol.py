"""Sobol' indices with confidence intervals, from the values at the cases of :class:`tmodes.study.plans.saltelli`."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

__all__ = ["Indices", "sobol_indices"]

Array = NDArray[np.float64]

_CONFIDENCE = 0.95
_LEAST_REPLICATES = 4
_ROUNDING = 1e-12


class Indices(NamedTuple):
    """Indices by their names, and their intervals (..., 2)."""

    values: Mapping[str, Array]
    intervals: Mapping[str, Array]


def sobol_indices(values: Array, replicates: int, *, second_order: bool = False) -> Indices | None:
    """Indices of one quantity, values (samples, cases of each); None where it does not vary.

    First order by A. Saltelli et al., Comput. Phys. Commun. 181 (2010), table 2 (b), total by M. J. W. Jansen (1999),
    pairs by Saltelli (2002). Samples of which a value is not a number are left out.

    The intervals are Student's of the jackknife over the independent randomizations of the sequence, sample i being of
    randomization i modulo ``replicates``: a bootstrap over samples, which takes the points of a sequence for
    independent ones, gives intervals several times too wide (P. L'Ecuyer et al., Confidence intervals for randomized
    quasi-Monte Carlo estimators, Winter Simulation Conf. 2023).
    """
    group = np.arange(len(values)) % replicates
    whole = np.isfinite(values).all(axis=1)
    values, group = values[whole], group[whole]
    present = np.unique(group)
    if len(present) < _LEAST_REPLICATES:
        return None
    centre = values[:, [0, -1]].mean()
    spread = np.abs(values - centre).max()
    if spread <= _ROUNDING * abs(centre) or spread == 0:
        return None
    terms = _terms((values - centre) / spread, second_order=second_order)
    sums = {name: np.stack([part[group == one].sum(axis=0) for one in present]) for name, part in terms.items()}
    return _jackknifed(sums)


def _terms(y: Array, *, second_order: bool) -> dict[str, Array]:
    """What is averaged over the samples: each (samples, ...), of values (samples, cases) about 0."""
    dimension = (y.shape[1] - 2) // (1 + second_order)
    a, b, ab = y[:, :1], y[:, -1:], y[:, 1 : dimension + 1]
    terms = {"one": np.ones_like(a[:, 0]), "a": a[:, 0], "b": b[:, 0], "aa": a[:, 0] ** 2, "bb": b[:, 0] ** 2}
    if not second_order:
        return terms | {"shared": b * (ab - a), "bare": ab - a, "apart": (ab - a) ** 2 / 2}
    ba = y[:, dimension + 1 : -1]
    shared, bare = (b * (ab - a) + a * (ba - b)) / 2, (ab - a + ba - b) / 2
    pairs = ba[:, :, None] * ab[:, None, :]
    pairs = (pairs + pairs.swapaxes(1, 2)) / 2 - (a * b)[:, :, None]
    return terms | {
        "shared": shared, "bare": bare, "apart": ((ab - a) ** 2 + (ba - b) ** 2) / 4, "pairs": pairs,
        "moved": (ab + ba - a - b) / 2,
    }  # fmt: skip


def _estimates(sums: Mapping[str, Array]) -> dict[str, Array]:
    """Indices from sums (..., of each term), the first axes kept."""
    mean = {name: part / _wide(sums["one"], part.ndim) for name, part in sums.items()}
    centre = (mean["a"] + mean["b"]) / 2
    variance = (mean["aa"] + mean["bb"]) / 2 - centre**2
    wide = variance[..., None]
    found = {"first": (mean["shared"] - centre[..., None] * mean["bare"]) / wide, "total": mean["apart"] / wide}
    if "pairs" in mean:
        # cov(BA_i, AB_j) about the common centre, less both indices of first order.
        moved = mean["moved"][..., :, None] + mean["moved"][..., None, :]
        closed = (mean["pairs"] - centre[..., None, None] * moved) / wide[..., None]
        second = closed - found["first"][..., :, None] - found["first"][..., None, :]
        own = np.eye(second.shape[-1], dtype=bool)
        found["second"] = np.where(own, np.nan, second)
    return found


def _wide(count: Array, dimensions: int) -> Array:
    return count.reshape(count.shape + (1,) * (dimensions - count.ndim))


def _jackknifed(sums: Mapping[str, Array]) -> Indices:
    """Estimates of all samples, and Student's intervals from the estimates without each replicate."""
    from scipy.stats import t as student

    count = len(sums["one"])
    found = _estimates({name: part.sum(axis=0) for name, part in sums.items()})
    without = _estimates({name: part.sum(axis=0) - part for name, part in sums.items()})
    factor = float(student.ppf((1 + _CONFIDENCE) / 2, count - 1)) * np.sqrt((count - 1) ** 2 / count)
    half = {name: factor * part.std(axis=0, ddof=1) for name, part in without.items()}
    ends = {name: np.stack([found[name] - half[name], found[name] + half[name]], axis=-1) for name in found}
    return Indices(found, ends)
