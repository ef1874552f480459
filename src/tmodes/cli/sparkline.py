"""A course in one line of text: blocks where the terminal has them, plain letters where it has not."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

__all__ = ["ASCII", "BLOCKS", "sparkline", "steps_for"]

BLOCKS = "▁▂▃▄▅▆▇█"
ASCII = "_.-~=+*#"
"""Eight heights, from low to high."""


def sparkline(values: ArrayLike, width: int, steps: str = BLOCKS) -> str:
    """``values`` (n,) as at most ``width`` heights from their least to their largest; a constant is a flat line.

    Each height is of the value of its part that is farthest from the middle of the range, so that no peak is lost.
    """
    course = np.asarray(values, dtype=float)
    low, high = float(course.min()), float(course.max())
    middle = (low + high) / 2
    parts = np.array_split(course, min(width, len(course)))
    extremes = np.array([part[np.argmax(np.abs(part - middle))] for part in parts])
    if not high > low:
        return steps[0] * len(extremes)
    heights = np.rint((extremes - low) / (high - low) * (len(steps) - 1)).astype(int)
    return "".join(steps[height] for height in heights)


def steps_for(encoding: str | None) -> str:
    """The heights that text of an encoding can hold."""
    try:
        BLOCKS.encode(encoding or "ascii")
    except (LookupError, UnicodeEncodeError):
        return ASCII
    return BLOCKS
