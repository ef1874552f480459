"""Ranges in which there is something to see: units that panels share, stated offsets, short peaks, equal curves."""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.plot.units import PREFIXES, Unit, largest_value, readable, with_prefix

__all__ = ["all_equal", "common_unit", "fill_from_zero", "largest_shown", "limit_peaks", "seen", "state_offset"]

SMALLEST, LARGEST = 0.01, 1e4
"""Panels share the unit in which the largest value of each reads as a number between these."""

NARROW = 0.02
"""An axis without zero whose range is below this share of its values has its offset stated in the label."""

NOTHING = 1e-6
"""A curve that stays below this share of the others is zero as far as a figure can show."""

EQUAL = 0.01
"""Curves that differ by less than this share of the largest value are drawn as one."""

RARE, FAR = 0.005, 3.0
"""The share of samples that may be a short peak, and how many times as far as the others they then reach."""

Array = NDArray[Any]


def common_unit(si: str, *panels: ArrayLike) -> Unit:
    """One unit for the values [``si``] of several panels, so that they can be compared; zeros have no say.

    That of the largest value where the smallest panel still reads well in it, else one with a smaller prefix.
    """
    sizes = [size for size in map(largest_value, panels) if size > 0]
    unit = readable(si, max(sizes, default=0.0))
    for _, factor, prefix in PREFIXES:
        if not sizes or min(sizes) * unit.factor >= SMALLEST or max(sizes) * factor >= LARGEST:
            break
        if factor > unit.factor:
            unit = with_prefix(prefix, si, factor)
    return unit


def seen(values: ArrayLike, size: float) -> bool:
    """Whether values differ visibly from zero in a panel of this size."""
    return largest_value(values) > NOTHING * size


def largest_shown(panels: Iterable[ArrayLike]) -> float:
    """The largest value of several panels."""
    return max(map(largest_value, panels), default=0.0)


def all_equal(lines: Array) -> float | None:
    """The largest difference of curves (curve, sample), as a share of the largest value; None where it can be seen."""
    size = largest_value(lines)
    differ = float(np.ptp(lines, axis=0).max())
    return differ / size if len(lines) > 1 and size > 0 and differ <= EQUAL * size else None


def fill_from_zero(panel: Any) -> None:
    """Limits from zero, or up to it, with room on the other side."""
    low, high = min(0.0, panel.dataLim.y0), max(0.0, panel.dataLim.y1)
    room = 0.1 * (high - low) or 1.0
    panel.set_ylim(low - room if low < 0 else 0.0, high + room if high > 0 or low == 0 else 0.0)


def limit_peaks(panel: Any, times: Array, values: Array, unit: Unit) -> None:
    """Where few samples of curves (curve, sample), SI, reach far beyond the others: the range of these, and a note."""
    low, high = np.quantile(values, (RARE, 1 - RARE))
    low, high = min(low, 0.0), max(high, 0.0)
    if np.ptp(values) <= FAR * (high - low) or high == low:
        return
    room = high - low
    panel.set_ylim(unit.factor * (low - 0.2 * room), unit.factor * (high + 0.6 * room))
    curve, sample = np.unravel_index(int(np.argmax(np.abs(values))), values.shape)
    peak = f"{unit.factor * values[curve, sample]:.3g}".replace("-", "−")
    note = f"beyond the axis: {peak} {unit.name} at {times[sample]:.3g} s"
    panel.text(0.98, 0.97, note, ha="right", va="top", fontsize=7, transform=panel.transAxes)


def state_offset(panel: Any) -> None:
    """Of an axis without zero and with a narrow range, the label says what is subtracted: ``force − 4.98 N [N]``."""
    from matplotlib.ticker import FuncFormatter

    low, high = panel.get_ylim()
    label = re.fullmatch(r"(.*) \[(.*)\]", panel.get_ylabel())
    wide = high - low >= NARROW * max(abs(low), abs(high))
    if wide or low * high <= 0 or not label or panel.get_aspect() != "auto" or panel.get_yscale() != "linear":
        return
    step = 10.0 ** np.floor(np.log10(high - low))
    digits = max(0, -int(np.floor(np.log10(step))))
    offset = float(np.trunc((low if low > 0 else high) / step) * step)
    panel.yaxis.set_major_formatter(FuncFormatter(lambda y, _: _written(y - offset, digits + 1)))
    sign = "−" if offset > 0 else "+"
    panel.set_ylabel(f"{label[1]} {sign} {abs(offset):.{digits}f} {label[2]}\n[{label[2]}]", fontsize=7)


def _written(value: float, digits: int) -> str:
    text = f"{round(value, digits) + 0.0:.{digits}f}".rstrip("0").rstrip(".")
    return text.replace("-", "−")
