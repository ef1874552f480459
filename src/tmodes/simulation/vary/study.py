"""What a varied sheet shows: how far the tips of the lanes part from that of the sheet's own run."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.simulation.batch.result import BatchRun

__all__ = ["Spread", "drawn", "grid", "spread"]

Array = NDArray[np.float64]


def grid(ranges: Mapping[str, tuple[float, float, int]]) -> dict[str, Array]:
    """All combinations of evenly spaced numbers: of each path the lowest, the highest, and how many."""
    axes = [np.linspace(low, high, count) for low, high, count in ranges.values()]
    mesh = np.meshgrid(*axes, indexing="ij")
    return {path: values.ravel() for path, values in zip(ranges, mesh, strict=True)}


def drawn(ranges: Mapping[str, tuple[float, float]], count: int, seed: int) -> dict[str, Array]:
    """``count`` numbers of each path, uniform between its two; the same for the same seed, whatever the other paths.

    The first lanes of a longer draw are those of a shorter one.
    """
    return {path: _uniform(path, count, seed, *limits) for path, limits in ranges.items()}


def _uniform(path: str, count: int, seed: int, low: float, high: float) -> Array:
    generator = np.random.Generator(np.random.PCG64([seed, *path.encode()]))
    return low + (high - low) * generator.random(count)


@dataclass(frozen=True, eq=False)
class Spread:
    """Distance of each lane's tip from that of the sheet's own run [m], (k,): the largest, and that at the end.

    Not-a-number where a lane did not finish, or the sheet itself did not.
    """

    largest: Array
    at_end: Array

    @property
    def worst(self) -> int | None:
        """The lane that parts farthest; None where there is none."""
        return int(np.nanargmax(self.largest)) if np.isfinite(self.largest).any() else None

    def info(self, batch: BatchRun) -> dict[str, Any]:
        """As plain data: least, median and largest of both, and the worst lane with its numbers; None for nothing."""
        figures = {"tip_difference_m": self.largest, "tip_difference_at_end_m": self.at_end}
        return {
            "lanes": batch.size,
            "finished": int(batch.finished.sum()),
            **{name: _least_median_most(values) for name, values in figures.items()},
            "worst": None if self.worst is None else {
                "lane": self.worst,
                "tip_difference_m": float(self.largest[self.worst]),
                "values": {path: float(values[self.worst]) for path, values in batch.values.items()},
            },
        }  # fmt: skip


def _least_median_most(values: Array) -> dict[str, float] | None:
    known = values[np.isfinite(values)]
    if not len(known):
        return None
    return {"min": float(known.min()), "median": float(np.median(known)), "max": float(known.max())}


def spread(batch: BatchRun, own: BatchRun) -> Spread:
    """The spread of a batch about ``own``, the run of the unchanged sheet; both with tips."""
    assert batch.tips is not None  # noqa: S101
    assert own.tips is not None  # noqa: S101
    far = np.linalg.norm(batch.tips - own.tips[0], axis=2)
    far[~batch.finished] = np.nan
    return Spread(far.max(axis=1), far[:, -1])
