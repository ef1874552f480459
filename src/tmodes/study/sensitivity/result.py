"""Sensitivity: which parameters make a quantity vary, and how sure that is."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.study.plain import plain

__all__ = ["Sensitivity"]

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Sensitivity:
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

    def info(self) -> dict[str, Any]:
        """All as plain data; None for what is not a number."""
        info = {
            "method": self.method, "names": list(self.names), "samples": self.samples, "cases": self.cases,
            "confidence": 0.95, "quantities": {name: self._info(k, name) for k, name in enumerate(self.quantities)},
        }  # fmt: skip
        return plain(info)

    def _info(self, k: int, name: str) -> dict[str, Any]:
        one = {
            "unit": self.units.get(name, "-"), "mean": self.mean[k], "deviation": self.deviation[k],
            "failed": int(self.failed[k]), "shift": self.shift[k], "note": self.notes.get(name, ""),
            "ranked": list(self.ranked(name)),
        }  # fmt: skip
        bare = {index: values[k] for index, values in self.indices.items()}
        return one | bare | {f"{index}_interval": ends[k] for index, ends in self.intervals.items()}
