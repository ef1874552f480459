"""A problem: cases of one structure as the native loops read them, how they are integrated, and what is saved."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.errors import InputError
from tmodes.integrate.choice import otherwise as later_settings
from tmodes.integrate.registry import AUTO
from tmodes.integrate.settings import Integration
from tmodes.kinds.signals.schedule import SignalPieces
from tmodes.simulation.loop import LoopModel
from tmodes.simulation.parts import sample_times

if TYPE_CHECKING:
    from tmodes.simulation.output_request import OutputRequest

__all__ = ["Problem", "problem_of"]

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Problem:
    """k cases of one structure: ``parameters`` (k, size), the ``starts`` (k, nx), ``schedules``: one for all, or k.

    ``states`` (all, samples, nx): where the samples of all runs are written; ``places`` (k,): which are these lanes'.
    ``wanted``: outputs in place of the samples; ``states`` is then (all, 0, nx). ``otherwise``: the settings with which
    a run by itself continues where the motion turns out stiff.
    """

    model: LoopModel
    settings: Integration
    parameters: Array
    starts: Array
    schedules: tuple[SignalPieces, ...]
    times: Array
    states: Array
    places: NDArray[np.int64]
    wanted: OutputRequest | None = None
    otherwise: Integration | None = None

    @property
    def size(self) -> int:
        """Number of lanes."""
        return len(self.starts)

    @property
    def time(self) -> float:
        """Time of all lanes together [s]."""
        return self.size * self.settings.duration

    def schedule(self, lane: int) -> SignalPieces:
        """What moves a lane."""
        return self.schedules[lane if len(self.schedules) > 1 else 0]


def problem_of(
    model: LoopModel, parameters: ArrayLike, schedules: SignalPieces | Sequence[SignalPieces], states: ArrayLike,
    settings: Integration, room: Array | None = None, places: NDArray[np.int64] | None = None,
    wanted: OutputRequest | None = None, otherwise: Integration | None = None,
) -> Problem:  # fmt: skip
    """The lanes of a batch; what is given once is the same for all. Schedules are cut, or held, at the duration.

    Where no method is named, dormand_prince begins. ``room``, ``places``: where samples go, by default lane after lane
    into an array of their own. Raises
    :class:`tmodes.errors.InputError` where shapes do not agree.
    """
    if settings.method == AUTO:
        otherwise = otherwise or later_settings(settings, "dormand_prince")
        settings = settings.chosen("dormand_prince")
    # One schedule for all lanes, or one for each: a question of number, not of the kind of signal.
    info = (schedules,) if isinstance(schedules, SignalPieces) else tuple(schedules)
    given = {"parameters": _rows(parameters, "parameters"), "states": _rows(states, "states")}
    found = {name: {rows.shape[1]} for name, rows in given.items()}
    found["schedules"] = {schedule.coefficients.shape[1] + 1 for schedule in info}
    widths = model.batch_widths
    if wanted:
        widths["parameters"] += len(model.series(wanted.shown, wanted.given).further)
    for name, width in widths.items():
        if found[name] != {width}:
            got, hint = f"rows of {sorted(found[name])} numbers", f"give the {name} of this model's structure"
            raise InputError(f"simulate_batch: {name}", got, f"rows of {width} numbers", hint)
    lanes = _lanes({name: len(rows) for name, rows in given.items()} | {"schedules": len(info)})
    full = {name: np.ascontiguousarray(np.broadcast_to(rows, (lanes, rows.shape[1]))) for name, rows in given.items()}
    ends = {id(schedule): schedule.until(settings.duration) for schedule in info}
    kept = tuple(ends[id(schedule)] for schedule in (info[:1] if len(ends) == 1 else info))
    times = sample_times(settings)
    if room is None:
        room = np.full((lanes, len(times), full["states"].shape[1]), np.nan)
    places = np.arange(lanes) if places is None else places
    return Problem(model, settings, full["parameters"], full["states"], kept, times, room, places, wanted, otherwise)


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
