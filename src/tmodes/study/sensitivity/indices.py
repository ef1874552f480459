"""Sobol' indices with confidence intervals and elementary effects, from the rows of a study."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmodes.errors import SimulationError
from tmodes.study.plans import Design
from tmodes.study.rows import Rows
from tmodes.study.sensitivity.result import Sensitivity

__all__ = ["Indices", "analysed", "elementary_effects", "sobol_indices"]

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


_LEAST = 4


def elementary_effects(values: Array, order: NDArray[np.intp], steps: Array) -> Indices | None:
    """Mean, mean size and standard deviation of the effects of one quantity; None where too few cases have a value.

    ``values`` (trajectories, d + 1); ``order`` (trajectories, d): which parameter changes from one case to the next;
    ``steps`` (trajectories, d): by which share of its distribution. Sizes: F. Campolongo et al., An effective screening
    design for sensitivity analysis of large models, Environ. Model. Softw. 22 (2007). The intervals are Student's:
    trajectories are independent.
    """
    from scipy.stats import t as student

    effects = np.empty(order.shape)
    np.put_along_axis(effects, order, np.diff(values, axis=1), axis=1)
    effects = (effects / steps)[np.isfinite(values).all(axis=1)]
    count = len(effects)
    if count < _LEAST:
        return None
    found = {"effect": effects.mean(axis=0), "size": np.abs(effects).mean(axis=0), "spread": effects.std(0, ddof=1)}
    factor = float(student.ppf((1 + _CONFIDENCE) / 2, count - 1)) / np.sqrt(count)
    half = {"effect": factor * found["spread"], "size": factor * np.abs(effects).std(axis=0, ddof=1)}
    ends = {name: np.stack([found[name] - part, found[name] + part], axis=-1) for name, part in half.items()}
    return Indices(found, ends)


MOST_FAILED = 0.05
"""Share of cases without a value, above which a quantity has no indices: those that are left decide what they are."""


class _QuantityValues(NamedTuple):
    """What is known of one quantity; ``shift``: by how much failed cases may change its indices."""

    indices: Indices | None
    failed: int
    shift: float
    note: str


def analysed(method: str, rows: Rows, design: Design) -> Sensitivity:
    """The indices of all quantities of all cases of a design, by ``sobol`` or ``morris``.

    Raises :class:`tmodes.errors.SimulationError` where more than 5 % of the cases of every quantity failed.
    """
    samples = int(design.info["samples"])
    of, shapes = _METHODS[method](design.info, len(rows.parameters))
    names, quantities = tuple(rows.parameters), tuple(rows.quantities)
    found = {name: _one(values, of, samples, rows) for name, values in rows.quantities.items()}
    if all(one.failed > MOST_FAILED * len(rows) for one in found.values()):
        worst = min(found.values(), key=lambda one: one.failed)
        raise SimulationError(f"sensitivity: {worst.note}")

    def stacked(part: str) -> dict[str, Array]:
        ends = (2,) if part == "intervals" else ()
        return {
            index: np.stack([_or_nan(one.indices, part, index, (*shape, *ends)) for one in found.values()])
            for index, shape in shapes.items()
            if not (ends and index == "spread")
        }

    with np.errstate(invalid="ignore"):
        finite = [values[np.isfinite(values)] for values in rows.quantities.values()]
    return Sensitivity(
        method, names, quantities, dict(rows.units), samples, len(rows),
        failed=np.array([one.failed for one in found.values()]),
        shift=np.array([one.shift for one in found.values()]),
        mean=np.array([values.mean() if len(values) else np.nan for values in finite]),
        deviation=np.array([values.std(ddof=1) if len(values) > 1 else np.nan for values in finite]),
        indices=stacked("values"), intervals=stacked("intervals"),
        notes={name: one.note for name, one in found.items() if one.note},
    )  # fmt: skip


def _or_nan(found: Indices | None, part: str, index: str, shape: tuple[int, ...]) -> Array:
    return np.full(shape, np.nan) if found is None else getattr(found, part)[index]


def _one(values: Array, of: Callable[[Array], Indices | None], samples: int, rows: Rows) -> _QuantityValues:
    """The indices of one quantity, or why it has none."""
    lost = ~np.isfinite(values)
    failed = int(lost.sum())
    if failed > MOST_FAILED * len(values):
        share, most = failed / len(values), f"{MOST_FAILED:.0%}"
        note = (
            f"{failed:,} of {len(values):,} cases ({share:.1%}) have no value, more than {most}: "
            f"indices of the others would mislead; {_why(rows, lost)}"
        )
        return _QuantityValues(None, failed, np.nan, note)
    found = of(values.reshape(samples, -1))
    if found is None:
        return _QuantityValues(None, failed, np.nan, "it does not vary")
    return _QuantityValues(found, failed, _shift(values, lost, found, of, samples), "")


def _why(rows: Rows, lost: NDArray[np.bool_]) -> str:
    """The most frequent reason."""
    reasons = Counter(rows.reason[k] or rows.status[k] for k in np.flatnonzero(lost).tolist())
    reason, count = reasons.most_common(1)[0]
    return f"{count:,} of them: {reason}; narrow the distributions, or choose a quantity that every case has"


def _shift(values: Array, lost: Any, found: Indices, of: Callable[[Array], Indices | None], samples: int) -> float:
    """Largest change of an index where failed cases get the least, or the largest, of the other values."""
    if not lost.any():
        return 0.0
    rest = values[~lost]
    largest = 0.0
    for extreme in (rest.min(), rest.max()):
        other = of(np.where(lost, extreme, values).reshape(samples, -1))
        if other:
            apart = [np.abs(other.values[index] - known) for index, known in found.values.items()]
            largest = max(largest, *(float(np.nanmax(one)) for one in apart))
    return largest


Shapes = dict[str, tuple[int, ...]]


def _sobol(info: Mapping[str, Any], d: int) -> tuple[Callable[[Array], Indices | None], Shapes]:
    pairs = bool(info["second_order"])
    shapes: Shapes = {"first": (d,), "total": (d,)} | ({"second": (d, d)} if pairs else {})
    return lambda values: sobol_indices(values, int(info["replicates"]), second_order=pairs), shapes


def _morris(info: Mapping[str, Any], d: int) -> tuple[Callable[[Array], Indices | None], Shapes]:
    shapes: Shapes = dict.fromkeys(("effect", "size", "spread"), (d,))
    return lambda values: elementary_effects(values, np.array(info["order"]), np.array(info["steps"])), shapes


_METHODS = {"sobol": _sobol, "morris": _morris}
