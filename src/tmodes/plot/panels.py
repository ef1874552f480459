"""Axes of a figure: panels, letters, legends, time along x."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from tmodes.errors import InputError
from tmodes.plot.charts import Chart, Line, looks, word_of
from tmodes.plot.ranges import fill_from_zero, limit_peaks, state_offset
from tmodes.plot.style import BAND, BLUE, INK, QUIET, colour, new_figure
from tmodes.plot.units import NEVER_LARGE, Unit, pretty, readable

if TYPE_CHECKING:
    from matplotlib.axes import Axes
else:
    Axes = Any  # matplotlib is loaded where a figure is drawn

__all__ = [
    "MOST_ROWS", "NEVER_LARGE", "Axes", "AxesLike", "Unit", "across", "draw_chart", "draw_charts", "letter",
    "panels", "plain", "pretty", "readable", "rows_height", "shared_legend", "side_legend", "time_axis",
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


def draw_charts(ax: AxesLike, rows: Sequence[Sequence[Chart]], height: float = 0.0) -> list[Axes]:
    """Rows of charts with letters and legends, on given axes or in a new figure; ``height`` [in], 0: by the rows."""
    charts, width = [chart for row in rows for chart in row], math.lcm(*map(len, rows))
    layout = [[f"{k} {j}" for j in range(len(row)) for _ in range(width // len(row))] for k, row in enumerate(rows)]
    linked = {chart.abscissa for chart in charts} in ({"time"}, {"along"})
    axes = panels(ax, layout, height or rows_height(len(rows)), sharex=ax is None and linked)
    for k, (panel, chart) in enumerate(zip(axes, charts, strict=True)):
        draw_chart(panel, chart)
        across(panel, chart, label=not linked or k >= len(charts) - len(rows[-1]))
    _legends(axes, charts, [len(row) == 1 and not chart.stacked for row in rows for chart in row])
    room = [_ROOM // len(row) for row in rows for _ in row]
    letter(axes, [plain(chart.title, most) for chart, most in zip(charts, room, strict=True)])
    return axes


_ROOM = 84
"""Letters of the titles that stand in a row."""


def plain(text: str, most: int = 60) -> str:
    """A text of a figure: no formula, not too long, and shown also where it begins with an underscore."""
    text = (text if len(text) <= most else f"{text[: most - 3]}...").replace("$", r"\$")
    return f" {text}" if text.startswith("_") else text


def draw_chart(panel: Axes, chart: Chart) -> None:
    """The curves of a chart, in its unit and the colours that it has on the page."""
    unit, values = chart.unit, chart.unit.of(chart.values)
    if chart.band:
        low, high = map(unit.of, chart.band)
        panel.fill_between(chart.at, low, high, facecolor=BAND, edgecolor=BLUE, linewidth=0.6, label=_RANGE)
    _draw_lines(panel, chart, values)
    panel.set_ylabel(chart.ordinate)
    if not values.any():
        panel.text(0.5, 0.6, "zero throughout", ha="center", transform=panel.transAxes)
    elif chart.log == "first":
        _decades(panel, np.abs(values[values != 0]), _DECADES.get(chart.group, 6))
    elif values.min() <= 0 <= values.max():
        panel.axhline(0.0, color=QUIET, linewidth=0.5)
    if chart.zero:
        fill_from_zero(panel)
    if chart.group == "deformations" and chart.abscissa == "time":
        limit_peaks(panel, chart.at, chart.values, unit)
    if chart.note:
        _note(panel, chart)


_RANGE = "range over the run"


def _draw_lines(panel: Axes, chart: Chart, values: Any) -> None:
    """The lines, of a stacked chart the areas and their sum."""
    sizes = np.where(values, np.abs(values), np.nan) if chart.log == "first" else values
    shown = [*zip(chart.lines, looks(chart), sizes, strict=True)]
    if chart.stacked:
        _stack(panel, chart, [(line, colour(look.colour), own) for line, look, own in shown[:-1]])
        shown = shown[-1:]
    for line, look, own in shown:
        dashes = (0, tuple(0.75 * part for part in look.dash)) if look.dash else "-"
        style = {"color": colour(look.colour), "linestyle": dashes, "linewidth": 1.2}
        panel.plot(chart.at, own, **{"label": plain(word_of(chart, line)) or None, **(line.look or style)})


_MOST_CORNERS = 800
"""Of the outline of an area, along the width of a figure: matplotlib simplifies lines alone."""

_DECADES = {"spectrum": 4}
"""Decades below the largest value that a logarithmic axis shows, by the group of its chart; else 6."""


def _decades(panel: Axes, sizes: Any, most: int) -> None:
    panel.set_yscale("log")
    panel.set_ylim(max(sizes.max() * 10.0**-most, sizes.min() / 2), sizes.max() * 3)


def _stack(panel: Axes, chart: Chart, parts: Sequence[tuple[Line, str, Any]]) -> None:
    """Areas on each other, what is above zero upwards, what is below it downwards."""
    kept = np.unique(np.linspace(0, len(chart.at) - 1, _MOST_CORNERS).astype(int))
    at, ends = np.asarray(chart.at)[kept], np.zeros((2, len(kept)))
    for line, own, values in parts:
        for k, part in enumerate((np.maximum(values[kept], 0), np.minimum(values[kept], 0))):
            label = None if k else plain(word_of(chart, line))
            panel.fill_between(at, ends[k], ends[k] + part, color=own, linewidth=0, label=label)
            ends[k] += part


def _note(panel: Axes, chart: Chart) -> None:
    """The words of a chart above its areas, or where there are fewest curves."""
    from matplotlib.legend import Legend

    if chart.stacked:
        panel.set_title(chart.note, loc="right", fontsize=6.5, fontweight="normal", color=QUIET)
    else:
        panel.add_artist(Legend(panel, [], [], loc="best", title=chart.note, title_fontsize=7, frameon=False))


def across(panel: Axes, chart: Chart, *, label: bool = True) -> None:
    """The abscissa: time, the place along a link, or frequency."""
    if chart.abscissa == "time":
        time_axis(panel, chart.at, label)
        return
    panel.set_xlim(0, float(chart.at[-1]))
    if label:
        panel.set_xlabel({"along": "along the link $s$ [–]", "frequency": "frequency [Hz]"}[chart.abscissa])


def _legends(axes: Sequence[Axes], charts: Sequence[Chart], alone: Sequence[bool]) -> None:
    """One legend above for areas and for curves that several panels have; next to each panel where rows differ."""
    words = {panel: tuple(panel.get_legend_handles_labels()[1]) for panel in axes}
    words = {
        panel: () if len(own) == 1 and own[0] in chart.title.lower() else own
        for (panel, own), chart in zip(words.items(), charts, strict=True)
    }
    families: dict[tuple[str, ...], list[Axes]] = {}
    for panel in sorted(filter(words.get, axes), key=lambda panel: -len(words[panel])):
        home = next((known for known in families if {*words[panel]} <= {*known}), words[panel])
        families.setdefault(home, []).append(panel)
    rows = dict(zip(axes, alone, strict=True))
    single = [own for own in families.values() if all(rows[panel] for panel in own)]
    outside = single if len(single) > 1 or any(len(own) == 1 for own in single) else []
    for panel in (panel for own in outside for panel in own if words[panel]):
        side_legend(panel)
    if above := [own[0] for own in families.values() if own not in outside]:
        shared_legend(*above)


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


def side_legend(panel: Axes) -> None:
    """A legend of the panel's curves to the right of it, outside the data."""
    panel.legend(loc="upper left", bbox_to_anchor=(1.01, 1.0))


def shared_legend(*panels_: Axes) -> None:
    """One legend for the curves of all ``panels_``, at the top of the figure, outside the data."""
    entries = {
        label: handle for panel in panels_ for handle, label in zip(*panel.get_legend_handles_labels(), strict=True)
    }
    rows = 1 + sum(len(label) + _KEY for label in entries) // _LETTERS
    where: Any = "outside upper left"
    panels_[0].figure.legend(entries.values(), entries, loc=where, ncols=-(-len(entries) // rows))


_LETTERS, _KEY = 108, 8
"""Letters that a line of a legend across the figure has room for, and those that a sample of a curve takes."""


MOST_ROWS = 8
"""Rows of a figure; of more joints or coordinates those are shown that do most."""


def rows_height(rows: int) -> float:
    """Height of a figure of so many rows [in]: few rows are higher."""
    return 0.8 + max(1.1, 1.7 - 0.2 * rows) * rows
