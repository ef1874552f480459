"""The signals that tmodes brings; ``@SIGNALS.register`` adds more."""

from __future__ import annotations

from typing import Any

from tmodes.kinds.signals.contract import SIGNALS, Signal
from tmodes.kinds.signals.schedule import Clock, Jolts, MergedSchedule, merge

__all__ = [
    "SIGNALS",
    "Clock",
    "Jolts",
    "MergedSchedule",
    "Signal",
    "constant_signal",
    "merge",
    "quintic_move",
    "sampled_noise",
]

SIGNALS.bring(
    "tmodes.kinds.signals",
    {
        "brake": "brake",
        "constant": "constant", "expression": "expression", "noise": "noise", "polynomial": "polynomial",
        "quintic": "quintic", "s_curve": "s_curve", "septic": "septic", "shaped": "shaped", "sine": "sine",
        "sine_squared": "sine_squared", "step": "step", "sum": "total", "table": "table",
        "trajectory": "trajectory", "trapezoid": "trapezoid",
    },
)  # fmt: skip


def constant_signal(value: float) -> Signal:
    """A signal that keeps one value."""
    return SIGNALS["constant"].model_construct(type="constant", value=value)


def quintic_move(start: float, end: float, duration: float) -> Signal:
    """A smooth move from rest to rest in ``duration`` [s] from time 0 on."""
    return SIGNALS["quintic"](type="quintic", start=start, end=end, duration=duration)


def sampled_noise(period: float, output_step: float, deviation: float, seed: int) -> Any:
    """A random value of a standard ``deviation`` every ``period`` [s], held in between."""
    from tmodes.kinds.signals.noise import SampledNoise

    return SampledNoise(period, output_step, deviation, seed)
