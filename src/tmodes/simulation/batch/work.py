"""What a batch works on: the numbers of all lanes, as the native loops read them, and where their samples go."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.errors import InputError
from tmodes.integrate.settings import Integration
from tmodes.kinds.signals.schedule import SignalPieces
from tmodes.simulation.batch.wanted import Wanted
from tmodes.simulation.loop import LoopModel

__all__ = ["Inputs", "Work", "inputs"]

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Inputs:
    """Numbers (k, size) of k robots, the states (k, nx) from which they start, and what moves them.

    ``schedules``: one for all, or k.
    """

    parameters: Array
    starts: Array
    schedules: tuple[SignalPieces, ...]

    @property
    def size(self) -> int:
        """Number of lanes."""
        return len(self.starts)

    def schedule(self, lane: int) -> SignalPieces:
        """What moves a lane."""
        return self.schedules[lane if len(self.schedules) > 1 else 0]


@dataclass(frozen=True, eq=False)
class Work:
    """Runs of one structure before they go.

    ``states`` (all, samples, nx): where the samples of all runs are written; ``places`` (k,): which are these lanes'.
    ``wanted``: series in place of the samples; ``states`` is then (all, 0, nx).
    """

    model: LoopModel
    inputs: Inputs
    settings: Integration
    times: Array
    states: Array
    places: NDArray[np.int64]
    wanted: Wanted | None = None


def inputs(
    parameters: ArrayLike,
    schedules: SignalPieces | Sequence[SignalPieces],
    states: ArrayLike,
    duration: float,
    widths: Mapping[str, int],
) -> Inputs:
    """The lanes of a batch; what is given once is the same for all. Schedules are cut, or held, at ``duration`` [s].

    ``widths``: how many numbers compiled code reads of ``parameters``, ``states`` and a row of ``schedules``. Raises
    :class:`tmodes.errors.InputError` where shapes do not agree.
    """
    # One schedule for all lanes, or one for each: a question of number, not of the kind of signal.
    info = (schedules,) if isinstance(schedules, SignalPieces) else tuple(schedules)
    given = {"parameters": _rows(parameters, "parameters"), "states": _rows(states, "states")}
    found = {name: {rows.shape[1]} for name, rows in given.items()}
    found["schedules"] = {schedule.coefficients.shape[1] + 1 for schedule in info}
    for name, width in widths.items():
        if found[name] != {width}:
            got, hint = f"rows of {sorted(found[name])} numbers", f"give the {name} of this model's structure"
            raise InputError(f"simulate_batch: {name}", got, f"rows of {width} numbers", hint)
    lanes = _lanes({name: len(rows) for name, rows in given.items()} | {"schedules": len(info)})
    full = {name: np.ascontiguousarray(np.broadcast_to(rows, (lanes, rows.shape[1]))) for name, rows in given.items()}
    ends = {id(schedule): schedule.until(duration) for schedule in info}
    kept = info[:1] if len(ends) == 1 else info
    return Inputs(full["parameters"], full["states"], tuple(ends[id(schedule)] for schedule in kept))


def _lanes(counts: dict[str, int]) -> int:
    lanes = max(counts.values())
    for name, count in counts.items():
        if count not in (1, lanes) or not count:
            got = f"{count}, next to " + ", ".join(f"{other} {n}" for n, other in counts.items() if n != name)
            raise InputError(f"simulate_batch: {name}", got, f"1 or {lanes}", "give one for all, or one for each lane")
    return lanes


def _rows(values: ArrayLike, name: str) -> Array:
    array = np.atleast_2d(np.asarray(values, dtype=float))
    if array.ndim != 2:
        expected, hint = "(size,) or (lanes, size)", "give one row for each lane"
        raise InputError(f"simulate_batch: {name}", f"an array of shape {array.shape}", expected, hint)
    return array
