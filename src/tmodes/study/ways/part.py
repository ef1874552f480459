"""What one way of computing gave of some cases."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.study.rows import Kept

__all__ = ["Part", "worst"]

Array = NDArray[np.float64]


@dataclass(eq=False)
class Part:
    """Of m cases: how each ended, the ``numbers`` (m,) that were asked for and their ``units``, by what was asked.

    ``reasons`` of single numbers, by what was asked and the index of the case; ``kept``: motions, by index. ``errors``
    (m,): sums of the estimated errors of steps [-], not-a-number where there is none.
    """

    status: list[str]
    reason: list[str]
    method: list[str]
    seconds: Array
    numbers: dict[Any, Array] = field(default_factory=dict)
    units: dict[Any, str] = field(default_factory=dict)
    reasons: dict[Any, dict[int, str]] = field(default_factory=dict)
    kept: dict[int, Kept] = field(default_factory=dict)
    errors: Array = field(default_factory=lambda: np.zeros(0))

    def __post_init__(self) -> None:
        if not len(self.errors):
            self.errors = np.full(len(self.status), np.nan)

    @classmethod
    def of_all(cls, size: int, status: str, reason: str = "") -> Part:
        """Cases that all ended so, without numbers."""
        return cls([status] * size, [reason] * size, [""] * size, np.zeros(size))

    def take(self, places: NDArray[np.intp], other: Part, asked: Mapping[Any, str]) -> None:
        """Put the cases of another part at places; ``asked``: all numbers that there are, with their units so far."""
        for k, place in enumerate(places.tolist()):
            self.status[place], self.reason[place] = other.status[k], other.reason[k]
            self.method[place] = other.method[k]
        self.seconds[places], self.errors[places] = other.seconds, other.errors
        for key in asked:
            column = self.numbers.setdefault(key, np.full(len(self.status), np.nan))
            column[places] = other.numbers.get(key, np.nan)
        self.units |= other.units
        for key, reasons in other.reasons.items():
            self.reasons.setdefault(key, {}).update({int(places[k]): why for k, why in reasons.items()})
        self.kept |= {int(places[k]): motion for k, motion in other.kept.items()}


_ORDER = ("finished", "stopped_by_condition", "stopped", "chattering", "diverged", "interrupted", "failed", "refused")


def worst(one: Part, other: Part) -> Part:
    """Both ways of the same cases: all numbers, of each case the worse status, and the seconds of both."""
    found = Part.of_all(len(one.status), "finished")
    for k in range(len(one.status)):
        later = _ORDER.index(other.status[k]) > _ORDER.index(one.status[k])
        chosen = other if later else one
        found.status[k], found.reason[k] = chosen.status[k], chosen.reason[k]
        found.method[k] = one.method[k] or other.method[k]
    found.seconds = one.seconds + other.seconds
    found.errors = np.fmax(one.errors, other.errors)
    found.numbers, found.units = {**one.numbers, **other.numbers}, {**one.units, **other.units}
    found.reasons, found.kept = {**one.reasons, **other.reasons}, {**one.kept, **other.kept}
    return found
