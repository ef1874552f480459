"""Axes of a figure: panels, letters, legends, time along x."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from tmodes.errors import InputError
from tmodes.plot.ranges import state_offset
from tmodes.plot.style import INK, QUIET, new_figure
from tmodes.plot.units import NEVER_LARGE, Unit, pretty, readable

if TYPE_CHECKING:
    from matplotlib.axes import Axes
else:
    Axes = Any  # matplotlib is loaded where a figure is drawn

__all__ = [
    "NEVER_LARGE", "Axes", "AxesLike", "Unit", "curves", "last_times", "letter", "pairs", "panels", "pretty",
    "readable", "shared_legend", "side_legend", "time_axis", "widest_legend", "zero_line",
]  # fmt: skip


ROUNDING = 1e-9
"""A change below this share of the value, and a value below this in its unit, is not worth an axis of its own."""

AxesLike = Any
"""One Axes, or a sequence or array of them; None draws a new figure."""


def panels(ax: AxesLike, layout: Sequence[Sequence[str]], height: float, **more: Any) -> list[Axes]:
    """The axes of ``layout`` (a mosaic of names) in the order of reading: those given, or those of a new figure.

    ``height`` of a new figure [in]. Raises :class:`tmodes.errors.InputError` when too few or too many are given.
    """
    names = list(dict.fromkeys(name for row in layout for name in row))
    if ax is None:
        axes = new_figure(height).subplot_mosaic([list(row) for row in layout], **more)
        chosen = [axes[name] for name in names]
        for panel in chosen:
            panel.tick_params(labelsize=7.5, labelcolor=INK, color=QUIET, width=0.6)
        return chosen
    given = list(np.atleast_1d(np.asarray(ax, dtype=object)).ravel())
    if len(given) != len(names):
        raise InputError("ax", f"{len(given)} axes", f"{len(names)} axes", "pass so many, or None for a new figure")
    return given


def pairs(rows: int) -> list[list[str]]:
    """A layout of so many rows of two panels."""
    return [[f"{k} left", f"{k} right"] for k in range(rows)]


_QUANTITIES = {
    "rad": "angle", "rad/s": "rate", "m": "displacement", "m/s": "speed", "N": "force", "N m": "torque", "V": "voltage",
    "A": "current",
}  # fmt: skip
"""What an axis shows where its figure gives no word, by unit."""


def curves(
    panel: Axes,
    x: Any,
    shown: Mapping[str, tuple[Any, dict[str, Any]]],
    si: str,
    what: str = "",
    unit: Unit | None = None,
) -> Unit:
    """Draw labelled values [``si``] with their looks over ``x``, in one readable unit that the axis names.

    ``what``: the quantity in a word; else that of the unit. ``unit``: that of panels to be compared; else its own.
    """
    unit = unit or readable(si, *(values for values, _ in shown.values()))
    for label, (values, look) in shown.items():
        panel.plot(x, unit.of(values), label=label or None, **look)
    panel.set_ylabel(f"{what or _QUANTITIES.get(si, '')} [{unit.name}]".lstrip())
    return unit


def zero_line(panel: Axes, width: float = 0.5) -> None:
    """A thin line at zero."""
    panel.axhline(0.0, color=QUIET, linewidth=width)


def letter(axes: Iterable[Axes], titles: Iterable[str], pad: float | None = None) -> None:
    """Titles with a), b), ... before them, so that a caption can name a panel; ``pad`` above the axes [points]."""
    for index, (panel, title) in enumerate(zip(axes, titles, strict=True)):
        panel.set_title(f"{chr(ord('a') + index)}) {title}", loc="left", pad=pad)
        _calm(panel)
        state_offset(panel)


def _calm(panel: Axes) -> None:
    """Give curves that are constant but for rounding a scale on which they look constant."""
    low, high = panel.dataLim.intervaly
    size = max(abs(low), abs(high))
    free = panel.get_autoscaley_on() and panel.get_aspect() == "auto" and np.isfinite(size)
    if not free or high - low > ROUNDING * size > ROUNDING**2:
        return
    middle, half = ((low + high) / 2, 0.05 * size) if size > ROUNDING else (0.0, 0.05)
    panel.set_ylim(middle - half, middle + half)


def time_axis(panel: Axes, times: Any, label: bool = True) -> None:
    """Time along x over the whole run, in a unit that reads well; also for a run of a single sample."""
    from matplotlib.ticker import FuncFormatter, MaxNLocator

    first, last = float(times[0]), float(times[-1])
    unit = readable("s", last)
    panel.set_xlim(first, last if last > first else first + 1e-3)
    panel.xaxis.set_major_locator(MaxNLocator(nbins=5, steps=[1, 2, 5, 10]))
    panel.xaxis.set_major_formatter(FuncFormatter(lambda time, _: f"{time * unit.factor:.6g}"))
    if label:
        panel.set_xlabel(f"time $t$ [{unit.name}]")


def last_times(axes: Sequence[Axes], times: Any, columns: int) -> None:
    """Time along x of all panels, labelled below those of the last row of ``columns``."""
    for k, panel in enumerate(axes):
        time_axis(panel, times, label=k >= len(axes) - columns)


def widest_legend(axes: Sequence[Axes]) -> None:
    """The legend of the panel with most curves, for all."""
    shared_legend(max(axes, key=lambda panel: len(panel.get_legend_handles_labels()[1])))


def side_legend(panel: Axes) -> None:
    """A legend of the panel's curves to the right of it, outside the data."""
    panel.legend(loc="upper left", bbox_to_anchor=(1.01, 1.0))


def shared_legend(*panels_: Axes, place: str = "upper left") -> None:
    """One legend for the curves of all ``panels_``, at the edge of the figure, outside the data."""
    entries = [entry for panel in panels_ for entry in zip(*panel.get_legend_handles_labels(), strict=True)]
    handles, labels = zip(*entries, strict=True)
    where: Any = f"outside {place}"
    panels_[0].figure.legend(handles, labels, loc=where, ncols=len(labels))
