"""The shapers that tmodes brings; ``@SHAPERS.register`` adds more."""

from __future__ import annotations

from tmodes.kinds.shapers.contract import SHAPERS, Impulses, Shaper, residual

__all__ = ["SHAPERS", "Impulses", "Shaper", "residual"]

SHAPERS.bring(
    "tmodes.kinds.shapers",
    {"zv": "zero_vibration", "zvd": "zero_vibration", "zvdd": "zero_vibration", "ei": "insensitive"},
)
