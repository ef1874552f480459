"""The signals that tmodes brings; ``@SIGNALS.register`` adds more."""

from __future__ import annotations

from tmodes.kinds.signals import constant, expression, noise, quintic, sine, step, table, total, trapezoid
from tmodes.kinds.signals.contract import SIGNALS, Signal
from tmodes.kinds.signals.schedule import Clock, Jolts, MergedSchedule, merge

__all__ = [
    "BUILT_IN",
    "SIGNALS",
    "Clock",
    "Jolts",
    "MergedSchedule",
    "Signal",
    "constant_signal",
    "merge",
    "quintic_move",
]

BUILT_IN = (constant, step, trapezoid, quintic, sine, table, expression, noise, total)
"""The modules whose members are registered."""


def constant_signal(value: float) -> Signal:
    """A signal that keeps one value."""
    return constant.Constant(type="constant", value=value)


def quintic_move(start: float, end: float, duration: float) -> Signal:
    """A smooth move from rest to rest in ``duration`` [s] from time 0 on."""
    return quintic.Quintic(type="quintic", start=start, end=end, duration=duration)
