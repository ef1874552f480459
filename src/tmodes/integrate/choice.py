"""Which integrator suits a robot: explicit steps are held back by its fastest motion, implicit ones are not.

A run starts with the one that its stiffness at the start suggests; where it turns out dear, another is tried.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from tmodes.integrate.implicit import MOST_STATES
from tmodes.integrate.registry import AUTO, integrator
from tmodes.integrate.settings import Integration

__all__ = [
    "COUNTED", "EXPLICIT", "STIFF", "TRIAL", "MethodChange", "chosen_method", "explained", "explicit_steps",
    "implicit_method", "otherwise", "worth_keeping", "worth_switching",
]  # fmt: skip

STIFF = 20_000
"""Explicit steps over a whole run beyond which the implicit method is the cheaper one."""

TRIAL = 40
"""Attempted steps after which an implicit method is judged."""

_DEARER = 1.65
"""Cost of a step of it over an explicit one: nine passes, of four lanes (1.1), over six."""

EXPLICIT, _IMPLICIT, _WHOLE = "dormand_prince", "extrapolation", "rosenbrock"
"""Those between which the stiffness chooses; the last where it may be of what the one before takes explicitly."""


def implicit_method(numbers: int, *, apart: bool) -> str | None:
    """The implicit method for a state of so many numbers that rates depend on; None: there is none.

    ``apart``: something that may be stiff is explicit in extrapolation.
    """
    if not apart:
        return _IMPLICIT
    return _WHOLE if numbers <= MOST_STATES else None


def chosen_method(given: Integration, highest: float, implicit: str | None = _IMPLICIT) -> tuple[str, str]:
    """The method of a run and why, in words (empty where it was given); ``highest``: largest |eigenvalue| [1/s]."""
    if given.method != AUTO:
        return given.method, ""
    steps = explicit_steps(given, highest)
    info = f"chosen: fastest eigenvalue {_about(highest)} 1/s"
    if steps <= STIFF or implicit is None:
        return EXPLICIT, f"{EXPLICIT} {info}"
    info += f", about {_about(steps)} explicit steps"
    if _too_exact(given, implicit):
        return EXPLICIT, f"{EXPLICIT} {info}; {implicit} would round above the tolerance"
    return implicit, f"{implicit} {info}"


def explicit_steps(given: Integration, highest: float) -> float:
    """About how many explicit steps a run takes at least; ``highest``: largest |eigenvalue| [1/s]."""
    return highest * given.duration / (integrator(EXPLICIT).reach or 1.0)


def _about(value: float) -> str:
    """A number in two digits, without a power of ten where that is the easier to read."""
    return f"{float(f'{value:.2g}'):,.0f}" if 1 <= value < 1e7 else f"{value:.2g}"


def explained(message: str, why: str) -> str:
    """How a run ended, with why its method was chosen (empty: it was given)."""
    if not why:
        return message
    ending, semicolon, later_on = message.partition("; ")
    return f"{ending} ({why}){semicolon}{later_on}"


def otherwise(given: Integration, method: str, implicit: str | None = _IMPLICIT) -> Integration | None:
    """The settings to continue with where a motion turns out stiff; None where there are none.

    ``given``: the settings of the sheet; ``method``: the one that was chosen by them. A method that was named stays;
    so does one that is implicit, or whose tolerance is below that of its rounding.
    """
    if given.method != AUTO or method != EXPLICIT or implicit is None or _too_exact(given, implicit):
        return None
    return given.chosen(implicit)


def _too_exact(given: Integration, implicit: str) -> bool:
    return given.chosen(implicit).relative_tolerance < integrator(implicit).least_tolerance


def worth_switching(left: float, step: float) -> bool:
    """Whether a run that turned out stiff is better ended by the implicit method, by the measure of ``STIFF``.

    ``left``: what is left of it [s]; ``step``: of the explicit method now [s].
    """
    return left > STIFF * step


def worth_keeping(step: float, gained: float) -> bool:
    """Whether a trial of the implicit method, which advanced by ``gained`` [s], was cheaper than explicit steps.

    ``step``: of the explicit method before [s].
    """
    return gained > _DEARER * TRIAL * step


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
