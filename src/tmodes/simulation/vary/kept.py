"""Motions of some cases, kept whole."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmodes.sheet import Robot
from tmodes.simulation.vary.simulate import prepared, run_prepared

__all__ = ["Kept", "kept_cases"]

Array = NDArray[np.float64]


class Kept(NamedTuple):
    """A motion: ``times`` (n,) [s], ``states`` (n, nx) whose first columns are ``coordinates``, ``tips`` (n, 3) [m]."""

    times: Array
    states: Array
    tips: Array
    coordinates: tuple[str, ...]


def kept_cases(
    sheet: Robot,
    values: Mapping[str, Array],
    indices: Collection[int],
    status: Sequence[str],
    *,
    threads: int,
    progress: Callable[[str, float], None],
) -> dict[int, Kept]:
    """The motions of some of the cases that have any, run again with all their samples."""
    chosen = [index for index in sorted({*indices}) if status[index] not in ("refused", "failed", "interrupted")]
    if not chosen:
        return {}
    some = {path: numbers[chosen] for path, numbers in values.items()}
    batch = run_prepared(prepared(sheet, some), tips=True, threads=threads, progress=lambda _, x: progress("kept", x))
    assert batch.tips is not None  # noqa: S101
    found: dict[int, Kept] = {}
    for k, index in enumerate(chosen):
        count = int(batch.counts[k])
        found[index] = Kept(batch.times[:count], batch.states[k, :count], batch.tips[k, :count], batch.coordinates)
    return found
