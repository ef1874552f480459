"""CaseResults: how cases ended and the numbers that are known of them, column by column."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.simulation.parts import Trajectory

__all__ = ["COUNTS", "CaseResults", "Kept"]

Array = NDArray[np.float64]
Words = NDArray[np.object_]

COUNTS = ("steps", "rejected", "evaluations")
"""Statistics of each case."""

_COLUMNS = ("status", "message", "method", "seconds", "errors", "samples")

_ORDER = (
    "finished", "stopped_by_condition", "stopped", "chattering", "not_converged", "step_too_small", "diverged",
    "interrupted", "failed", "refused",
)  # fmt: skip
"""From good to bad."""


@dataclass(frozen=True, eq=False)
class Kept:
    """The whole motion of one case: ``times`` (n,) [s], ``states`` (n, nx), ``tip`` (n, 3) [m]; ``names`` of states."""

    times: Array
    states: Array
    tip: Array
    names: tuple[str, ...]


@dataclass(eq=False)
class CaseResults:
    """m cases, each column (m,): ``status``, ``message`` and ``method`` are words, ``seconds`` of the processor.

    ``status``: finished, stopped_by_condition, diverged, stopped (a limit of the settings), interrupted, failed (it
    could not start), refused (the sheet takes no such number). ``samples``: how many there are of each; ``statistics``:
    steps, rejected, evaluations. ``errors``: sum of the estimated errors of all steps, as a share of the size of what
    is integrated (at least absolute over relative tolerance), not-a-number where there is no estimate. ``values``:
    numbers by what was asked for, not-a-number where a case has none, their ``units``, and ``reasons`` of single
    numbers by the index of the case. ``kept``: motions of some cases, by index.
    """

    status: Words
    message: Words
    method: Words
    seconds: Array
    errors: Array
    samples: NDArray[np.int64]
    statistics: dict[str, NDArray[np.int64]]
    values: dict[Any, Array] = field(default_factory=dict)
    units: dict[Any, str] = field(default_factory=dict)
    reasons: dict[Any, dict[int, str]] = field(default_factory=dict)
    kept: dict[int, Kept] = field(default_factory=dict)

    @classmethod
    def of_all(cls, size: int, status: str = "", message: str = "") -> CaseResults:
        """Cases that all ended so, without numbers; an empty status: they have not begun."""
        words = [np.full(size, word, dtype=object) for word in (status, message, "")]
        counts = {name: np.zeros(size, dtype=np.int64) for name in COUNTS}
        seconds, errors, samples = np.zeros(size), np.full(size, np.nan), np.zeros(size, dtype=np.int64)
        return cls(words[0], words[1], words[2], seconds, errors, samples, counts)

    def __len__(self) -> int:
        return len(self.status)

    def ended(self, *status: str) -> NDArray[np.int64]:
        """The cases that ended in one of these ways."""
        return np.flatnonzero(np.isin(self.status, status))

    def end(self, case: int, run: Trajectory) -> None:
        """How one case ended."""
        self.status[case], self.message[case], self.samples[case] = run.status, run.message, len(run.times)
        self.method[case] = run.statistics.get("method", self.method[case])
        self.errors[case] = run.statistics.get("errors", np.nan)
        for name in COUNTS:
            self.statistics[name][case] = run.statistics[name]

    def put(self, cases: Mapping[int, str], status: str) -> None:
        """These cases ended so, each with its message."""
        for case, why in cases.items():
            self.status[case], self.message[case] = status, why

    def value(self, key: Any) -> Array:
        """The column of a number, not-a-number at first."""
        return self.values.setdefault(key, np.full(len(self), np.nan))

    def take(self, places: ArrayLike, other: CaseResults) -> None:
        """Put the cases of other results at places (k,)."""
        where = np.asarray(places, dtype=np.int64)
        for name in _COLUMNS:
            getattr(self, name)[where] = getattr(other, name)
        for name, counts in other.statistics.items():
            self.statistics[name][where] = counts
        for key, values in other.values.items():
            self.value(key)[where] = values
        self.units |= other.units
        for key, reasons in other.reasons.items():
            self.reasons.setdefault(key, {}).update({int(where[k]): why for k, why in reasons.items()})
        self.kept |= {int(where[k]): motion for k, motion in other.kept.items()}

    def part(self, which: ArrayLike) -> CaseResults:
        """Some cases, those that are there several times included, in this order."""
        chosen = np.asarray(which, dtype=np.int64)
        found = CaseResults.of_all(len(chosen))
        for name in _COLUMNS:
            setattr(found, name, getattr(self, name)[chosen])
        for name in ("statistics", "values"):
            setattr(found, name, {key: column[chosen] for key, column in getattr(self, name).items()})
        found.reasons = {key: _chosen(own, chosen) for key, own in self.reasons.items()}
        found.units, found.kept = dict(self.units), _chosen(self.kept, chosen)
        return found

    def add(self, other: CaseResults) -> None:
        """Further numbers of the same cases: of each the worse status, and the seconds of both."""
        order = {word: k for k, word in enumerate(_ORDER)}
        mine, its = (np.array([order.get(word, len(order)) for word in one.status]) for one in (self, other))
        worse = mine < its
        for name in ("status", "message"):
            getattr(self, name)[worse] = getattr(other, name)[worse]
        unknown = self.method == ""
        self.method[unknown] = other.method[unknown]
        self.seconds, self.errors = self.seconds + other.seconds, np.fmax(self.errors, other.errors)
        for name in ("values", "units", "reasons", "kept"):
            getattr(self, name).update(getattr(other, name))


def _chosen(of: Mapping[int, Any], which: Iterable[Any]) -> dict[int, Any]:
    """What belongs to some cases, by their new places."""
    return {place: of[int(case)] for place, case in enumerate(which) if int(case) in of}
