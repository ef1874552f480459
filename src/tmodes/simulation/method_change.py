"""A run whose method may change: when another one is tried, whether it is kept, and what each part of the run took."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from tmodes.integrate.choice import TRIAL, worth_keeping, worth_switching
from tmodes.integrate.settings import Integration

__all__ = ["COUNTED", "MethodChange"]

COUNTED = ("steps", "rejected", "evaluations")
"""What the loops count, by the names of their memory."""

_KEPT = ("t", "h", *COUNTED, "smallest")


class MethodChange:
    """An explicit method that turns out dear makes room for another; that one, if it is no cheaper, gives way again.

    ``kept`` (2, 6): time, step, counts and smallest step at the end of the first and second part; zeros: not yet.
    ``cell`` in what follows reads the memory of the loop by name.
    """

    def __init__(self, first: Integration, otherwise: Integration | None) -> None:
        self.first, self.otherwise, self.kept = first, otherwise, np.zeros((2, len(_KEPT)))

    @property
    def parts(self) -> int:
        """How many parts the run has so far."""
        return 1 + int(np.count_nonzero(self.kept[:, 0]))

    @property
    def settings(self) -> Integration:
        """Those of the present part."""
        return self.otherwise if self.otherwise is not None and self.parts == 2 else self.first

    @property
    def possible(self) -> bool:
        """Whether another method is at hand that was not tried yet."""
        return self.otherwise is not None and self.parts == 1

    def most(self, attempts: int, cell: Callable[[str], float]) -> int:
        """So many attempted steps, or what is left of a trial: it ends there, whatever the pieces of a run."""
        left = TRIAL - self._tried(cell) if self.parts == 2 else 0
        return min(attempts, left) if left > 0 else attempts

    def switched(self, cell: Callable[[str], float]) -> dict[str, float]:
        """What the memory must hold after the motion turned out stiff: nothing new where the method stays."""
        if not worth_switching(self.first.duration - cell("t"), cell("h")):
            return {}
        self._end_part(cell)
        return {"h": 0.0, **_AFRESH}

    def judged(self, cell: Callable[[str], float]) -> dict[str, float]:
        """The same at the end of a trial, where the first method comes back if the other one was no cheaper."""
        if self.parts != 2 or self._tried(cell) != TRIAL:
            return {}
        time, step = self.kept[0, :2]
        if worth_keeping(float(step), cell("t") - float(time)):
            return {}
        self._end_part(cell)
        return {"h": float(step), **_AFRESH}

    def words(self, stiff_time: float) -> str:
        """Where the motion turned out stiff [s] (0: it did not), and what was done."""
        name, limit = self.first.method, "the limit of stability"
        if self.otherwise is None or self.parts == 1:
            info = f"; the motion is stiff from t = {stiff_time:.6g} s on: its steps stood at {limit} of {name} there"
            return info if stiff_time > 0 else ""
        other, begin = self.otherwise.method, f"from t = {self.kept[0, 0]:.6g} s on"
        if self.parts == 2:
            return f"; {begin} by {other}: its steps stood at {limit} of {name} there"
        return (
            f"; {begin} {other} was tried, for its steps stood at {limit} of {name} there; "
            f"from t = {self.kept[1, 0]:.6g} s on by {name} again: the other one took no fewer passes for the same time"
        )

    def info(self, cell: Callable[[str], float]) -> dict[str, dict[str, Any]]:
        """Method, begin and counts of each part."""
        counts = np.array([*self.kept[: self.parts - 1, 2:5], [cell(name) for name in COUNTED]])
        begins = [0.0, *self.kept[: self.parts - 1, 0].tolist()]
        spent = np.diff(counts, axis=0, prepend=np.zeros((1, len(COUNTED))))
        methods = [self.otherwise if k == 1 and self.otherwise else self.first for k in range(self.parts)]
        return {
            str(k + 1): {"method": methods[k].method, "from_s": begins[k]}
            | {name: int(value) for name, value in zip(COUNTED, spent[k], strict=True)}
            for k in range(self.parts)
        }

    def smallest(self, cell: Callable[[str], float]) -> float | None:
        """The smallest step of all parts [s]."""
        return min((value for value in (*self.kept[:, -1].tolist(), cell("smallest")) if value > 0), default=None)

    def _tried(self, cell: Callable[[str], float]) -> int:
        return int(cell("steps") + cell("rejected") - self.kept[0, 2] - self.kept[0, 3])

    def _end_part(self, cell: Callable[[str], float]) -> None:
        self.kept[self.parts - 1] = [cell(name) for name in _KEPT]


_AFRESH = {"fresh": 1.0, "old_error": 1e-4, "smallest": 0.0, "stiff": 0.0, "calm": 0.0}
