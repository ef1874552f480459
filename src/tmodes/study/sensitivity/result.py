"""Sensitivity: which parameters make a quantity vary, and how sure that is."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from tmodes.io.printed import CommandResult, Table
from tmodes.study.answers import SURE, amount, between, joined_answers
from tmodes.study.plain import plain
from tmodes.study.statistics import Interval

if TYPE_CHECKING:
    from xarray import Dataset

__all__ = ["Sensitivity"]

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False, repr=False)
class Sensitivity(CommandResult):
    """Indices of q quantities by d parameters, not-a-number where a quantity has none.

    ``method`` ``sobol``: ``first`` (q, d), the share of the variance that a parameter makes by itself; ``total``
    (q, d), with all that it makes together with others; ``second`` (q, d, d) or None, what pairs make beyond their own
    shares.
    ``method`` ``morris``: ``effect`` (q, d) mean, ``size`` (q, d) mean of the sizes (mu*) and ``spread`` (q, d)
    standard deviation (sigma) of the change of the quantity over a parameter's whole range, in the quantity's unit.

    ``intervals``: least and largest value (..., 2) of each by its name, between which the exact one lies in 95 of 100
    repetitions. ``mean`` and ``deviation`` (q,) of the quantities; ``samples``: as they were asked for; ``cases``;
    ``failed`` (q,): cases without a value, which are left out, and ``shift`` (q,): by how much at most an index changes
    if they had the least or the largest value of the others. ``notes``: why a quantity has no indices, by its name.
    """

    method: str
    names: tuple[str, ...]
    quantities: tuple[str, ...]
    units: Mapping[str, str]
    samples: int
    cases: int
    failed: NDArray[np.int64]
    shift: Array
    mean: Array
    deviation: Array
    indices: Mapping[str, Array]
    intervals: Mapping[str, Array]
    notes: Mapping[str, str] = field(default_factory=dict)

    @property
    def first(self) -> Array:
        """Sobol' indices of first order, (q, d)."""
        return self.indices["first"]

    @property
    def total(self) -> Array:
        """Total Sobol' indices, (q, d)."""
        return self.indices["total"]

    @property
    def second(self) -> Array | None:
        """Sobol' indices of pairs, (q, d, d), or None."""
        return self.indices.get("second")

    @property
    def leading(self) -> str:
        """The index by which parameters are ranked."""
        return "total" if self.method == "sobol" else "size"

    def ranked(self, quantity: str) -> tuple[str, ...]:
        """Parameters, the most important one first."""
        values = np.nan_to_num(self.indices[self.leading][self.quantities.index(quantity)])
        return tuple(self.names[i] for i in np.argsort(-values, kind="stable"))

    @property
    def answers(self) -> dict[str, str]:
        """Which parameters decide each quantity, in words, by its name."""
        return {name: _what_matters(self, name) for name in self.quantities}

    @property
    def sentence(self) -> str:
        """The same of the first quantities."""
        return joined_answers([*self.answers.values()])

    def info(self) -> dict[str, Any]:
        """All as plain data; None for what is not a number."""
        info = {
            "method": self.method, "names": list(self.names), "samples": self.samples, "cases": self.cases,
            "confidence": 0.95, "sentence": self.sentence,
            "quantities": {name: self._info(k, name) for k, name in enumerate(self.quantities)},
        }  # fmt: skip
        return plain(info)

    def _info(self, k: int, name: str) -> dict[str, Any]:
        one = {
            "unit": self.units.get(name, "-"), "mean": self.mean[k], "deviation": self.deviation[k],
            "failed": int(self.failed[k]), "shift": self.shift[k], "note": self.notes.get(name, ""),
            "ranked": list(self.ranked(name)), "sentence": self.answers[name],
        }  # fmt: skip
        bare = {index: values[k] for index, values in self.indices.items()}
        return one | bare | {f"{index}_interval": ends[k] for index, ends in self.intervals.items()}

    @property
    def data(self) -> Dataset:
        """Each index (quantity, parameter), and ``NAME_interval`` (quantity, parameter, end) with both of its ends."""
        from xarray import Dataset

        pair = ("quantity", "parameter", "other")
        series = {name: (pair[: values.ndim], values) for name, values in self.indices.items()}
        series |= {
            f"{name}_interval": ((*pair[: values.ndim - 1], "end"), values) for name, values in self.intervals.items()
        }
        names = list(self.names)
        coords = {"quantity": list(self.quantities), "parameter": names, "other": names, "end": ["low", "high"]}
        used = {dim for dims, _ in series.values() for dim in dims}
        return Dataset(series, {dim: values for dim, values in coords.items() if dim in used})

    def plot(self, ax: Any = None, quantity: str | None = None) -> list[Any]:
        """The indices of a quantity, the first one if none is named, as bars."""
        from tmodes.plot.commands import bars

        name = self.quantities[0] if quantity is None else quantity
        k = self.quantities.index(name)
        shown = {index: self.indices[index][k] for index in self._shown if index != "spread"}
        return bars(shown, self.names, "index" if self.method == "sobol" else "effect", title=name, ax=ax)

    @property
    def notices(self) -> list[str]:
        """Quantities without indices, and why."""
        return [f"{name} has no indices: {note}" for name, note in self.notes.items() if note]

    def tables(self) -> Iterator[str | Table]:
        """What decides the quantities, and a table for each, the most important parameter first."""
        yield self.sentence
        for k, name in enumerate(self.quantities):
            if not self.notes.get(name):
                yield from self._table(k, name)

    def _table(self, k: int, name: str) -> Iterator[str | Table]:
        unit = self.units.get(name, "-")
        unit_text = "" if unit == "-" else f" {unit}"
        spread = f"standard deviation {self.deviation[k]:.3g}{unit_text} ({self.cases:,} cases)"
        yield f"{name}: mean {self.mean[k]:.4g}{unit_text}, {spread}"
        order = [self.names.index(one) for one in self.ranked(name)]
        columns = ["parameter", *(_HEADINGS[index].format(unit=unit) for index in self._shown)]
        rows = [[self.names[i], *(_cell(self, index, (k, i)) for index in self._shown)] for i in order]
        yield Table("", columns, rows)
        if self.second is not None:
            yield from self._pairs(self.second[k], k)
        if self.failed[k]:
            left_out = f"{self.failed[k]:,} cases have no value and are left out"
            yield f"{left_out}: this may change an index by up to {self.shift[k]:.2g}.\n"

    def _pairs(self, second: Array, k: int) -> Iterator[str | Table]:
        """The pairs with the largest indices."""
        pairs = sorted(
            ((i, j) for i in range(len(self.names)) for j in range(i)), key=lambda pair: -abs(float(second[pair]))
        )
        rows = [[f"{self.names[j]}, {self.names[i]}", _cell(self, "second", (k, i, j))]
                for i, j in pairs[:_MOST_PAIRS]]  # fmt: skip
        if rows:
            yield "Pairs: what two parameters make together, beyond each by itself"
            yield Table("", ["pair", "second"], rows)

    @property
    def _shown(self) -> tuple[str, ...]:
        return ("total", "first") if self.method == "sobol" else ("size", "effect", "spread")


_MOST_PAIRS = 20

_HEADINGS = {
    "first": "first", "total": "total", "size": "size of the effect [{unit}]", "effect": "mean effect [{unit}]",
    "spread": "spread [{unit}]",
}  # fmt: skip


def _cell(found: Sensitivity, index: str, place: tuple[int, ...]) -> str:
    """A number and half of its interval."""
    value = found.indices[index][place]
    if index not in found.intervals:
        return f"{value:.3g}"
    low, high = found.intervals[index][place]
    half = (high - low) / 2
    if found.method == "morris":
        return f"{value:.3g} ± {half:.2g}"
    places = int(np.clip(1 - np.floor(np.log10(half)), 2, 6)) if half > 0 else 6
    return f"{value:.{places}f} ± {half:.{places}f}"


_LITTLE, _TOGETHER, _MOST_NAMED = 0.005, 0.1, 3
"""Share that is left out, and that of interactions of which something is said; parameters after the first."""


def _what_matters(found: Sensitivity, quantity: str) -> str:
    """Which parameters decide a quantity, by their total indices or by the size of their effects; with confidence."""
    k = found.quantities.index(quantity)
    if note := found.notes.get(quantity):
        return f"{quantity} has no indices: {note}."
    shares, unit = found.method == "sobol", found.units.get(quantity, "-")
    size, ends = np.maximum(found.indices[found.leading][k], 0.0), found.intervals[found.leading][k]
    order = [found.names.index(name) for name in found.ranked(quantity)]
    first, others = order[0], order[1:]
    texts = [_percent(one) if shares else amount(one, unit) for one in size.tolist()]
    sure = not others or ends[first][0] > ends[others[0]][1]
    interval = Interval(float(size[first]), max(0.0, float(ends[first][0])), float(ends[first][1]))
    wide = f"{100 * interval.low:.0f} to {100 * min(1.0, interval.high):.0f} %" if shares else between(interval, unit)
    lead = _lead(found.names[first], quantity, decides=shares and found.first[k][first] > 0.5, sure=sure)
    what = "of the variance" if shares else "over its range"
    named = [j for j in others if size[j] > _LITTLE * (1.0 if shares else size[first])]
    rest = [f"{found.names[j]} {texts[j]}" for j in named[:_MOST_NAMED]]
    rest += [f"each other at most {texts[named[_MOST_NAMED]]}"] if len(named) > _MOST_NAMED else []
    joint = 1.0 - float(found.first[k].sum()) if shares and others else 0.0
    more = f"; {_percent(joint)} come from interactions, which these shares count more than once"
    return (
        f"{lead}: {texts[first]} {what} ({wide} at {SURE}){', ' if rest else ''}{', '.join(rest)}"
        f"{more if joint > _TOGETHER else ''}."
    )


def _percent(share: float) -> str:
    return f"{100 * share:.0f} %"


def _lead(name: str, quantity: str, *, decides: bool, sure: bool) -> str:
    if not sure:
        return f"{name} seems to matter most for {quantity}, though its interval overlaps the next one's"
    return f"{name} decides {quantity}" if decides else f"{name} matters most for {quantity}"
