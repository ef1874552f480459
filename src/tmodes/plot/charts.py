"""A chart as data: what matplotlib and the page draw over time, frequency or the length of a link."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.plot.ranges import common_unit, seen
from tmodes.plot.style import CYCLE, DASHES, PARTS, SERIES
from tmodes.plot.units import Unit, largest_value

__all__ = [
    "SI", "Chart", "Line", "Look", "Place", "in_units", "line_of", "looks", "merged", "moving", "only", "shown_name",
    "singled", "values_at", "word_of",
]  # fmt: skip

Array = NDArray[Any]
Place = tuple[str, int]
"""A series of a result: its variable, and the column of its flattened trailing dimensions."""

_QUANTITIES = {
    "rad": "angle", "rad/s": "rate", "m": "displacement", "m/s": "speed", "N": "force", "N m": "torque", "V": "voltage",
    "A": "current",
}  # fmt: skip
"""What an ordinate shows where its chart has no word, by unit."""

_SMALLEST, _LONG = 1e-6, 10.0
"""Lengths between these [m] are in mm."""


SI = Unit("", 1.0)


@dataclass(frozen=True, eq=False)
class Line:
    """A curve: its values [SI of its chart], shape (n,), and what of the result they are.

    ``place`` less ``less``; None where they are no plain series, which the live model cannot draw. Of a spectrum they
    say of which series it is. ``along``: a part of vectors, along their sum; -1: its size. ``role``: a key of
    :data:`tmodes.plot.style.PARTS`; ``cause``: of :data:`tmodes.plot.style.CAUSES`, or nothing; ``look``: as
    matplotlib draws it, instead of what these give.
    """

    label: str
    role: str
    values: Array
    place: Place | None = None
    less: Place | None = None
    shown: bool = True
    along: bool = False
    cause: str = ""
    look: Mapping[str, Any] | None = None


@dataclass(frozen=True, eq=False)
class Chart:
    """A chart in SI units; ``at`` (n,) is time [s], frequency [Hz], or the place along a link; ``si`` that of lines.

    ``what``: the quantity in a word, nothing where its unit says it; ``unit``: in which it is drawn, see
    :func:`in_units`. ``span``: of a spectrum, first and last time [s] of the samples that it is of. ``marks``: places
    along ``at`` with their names. ``stacked``: all lines but the last one add up to it. ``band``: lowest and highest
    values (n,) of a range. ``note``: what must be known to read it. ``zero``: the ordinate begins at zero.
    ``overview``: one of those to look at first.
    """

    id: str
    title: str
    group: str
    si: str
    at: Array
    lines: tuple[Line, ...]
    what: str = ""
    log: str = "no"
    abscissa: str = "time"
    span: tuple[float, float] | None = None
    marks: tuple[tuple[float, str], ...] = ()
    stacked: bool = False
    band: tuple[Array, Array] | None = None
    note: str = ""
    zero: bool = False
    overview: bool = False
    unit: Unit = SI

    @property
    def ordinate(self) -> str:
        """What the ordinate shows, with its unit."""
        return f"{self.what or _QUANTITIES.get(self.si, '')} [{self.unit.name}]".lstrip()

    @property
    def labels(self) -> list[str]:
        """What has a curve, each once."""
        return list(dict.fromkeys(line.label for line in self.lines))

    @property
    def values(self) -> Array:
        """All curves, shape (lines, n)."""
        return np.stack([line.values for line in self.lines])


def values_at(data: Any, place: Place) -> Array:
    """The series of a result at a place, shape (n,)."""
    values = np.asarray(data[place[0]].transpose("time", ...).values, dtype=float)
    return values.reshape(len(values), -1)[:, place[1]]


def line_of(data: Any, place: Place, label: str, role: str = "real", *, less: Place | None = None, **more: Any) -> Line:
    """A curve that is a series of a result, or what one is less another; ``more`` of a :class:`Line`."""
    values = values_at(data, place)
    return Line(label, role, values if less is None else values - values_at(data, less), place, less, **more)


def shown_name(name: object) -> str:
    """The name of an element or a coordinate as text: ``joint_1.gear`` is *gear of joint 1*."""
    owner, _, own = str(name).rpartition(".")
    words = f"{own} of {owner}" if own == "gear" else f"{owner} {own}" if own.isdigit() else f"{owner}, {own}"
    return (words if owner else own).replace("_", " ").strip() or str(name)


def in_units(runs: Sequence[Sequence[Chart]]) -> list[list[Chart]]:
    """The charts of several runs in readable units: one for each quantity of a group, so that they can be compared."""
    sizes: dict[tuple[str, ...], list[float]] = {}
    for chart in (chart for charts in runs for chart in charts):
        sizes.setdefault(_quantity(chart), []).append(largest_value(chart.values))
    units = {key: _unit(key[1], own) for key, own in sizes.items()}
    return [
        [chart if chart.unit.name else replace(chart, unit=units[_quantity(chart)]) for chart in charts]
        for charts in runs
    ]


def _quantity(chart: Chart) -> tuple[str, ...]:
    return chart.group, chart.si, chart.what


def _unit(si: str, sizes: Sequence[float]) -> Unit:
    """Lengths in mm and stresses in MPa, as in the numbers of the page."""
    if si == "m" and _SMALLEST < max(sizes) < _LONG:
        return Unit("mm", 1e3)
    return Unit("MPa", 1e-6) if si == "Pa" else common_unit(si, *sizes)


@dataclass(frozen=True)
class Look:
    """A colour, by its name in :func:`tmodes.plot.style.colour`, and lengths of dashes and gaps [pixels]."""

    colour: str
    dash: tuple[float, ...]


def looks(chart: Chart) -> list[Look]:
    """Of each of its lines: a cause has its colour, a part its dash; what has neither takes the next of each."""
    lines = chart.lines
    labels, roles = (
        [*dict.fromkeys(names)] for names in zip(*((line.label, line.role) for line in lines), strict=True)
    )
    owners = {
        cause: {one.label for one in lines if one.cause == cause} for cause in {one.cause for one in lines} - {""}
    }
    free = [label for label in labels if not any(names == {label} for names in owners.values())]
    found = []
    for line in lines:
        place = labels.index(line.label)
        if line.label not in free and (len(labels) > 1 or line.role == "real"):
            own = next(cause for cause, names in owners.items() if names == {line.label})
            name = f"of-{own.replace(' ', '-')}"
        else:
            name = CYCLE[free.index(line.label) % len(CYCLE)] if len(labels) > 1 else PARTS[line.role][1]
        solid = chart.stacked or line.cause == "total" or len(lines) == 1
        dash = DASHES[line.role] if len(roles) > 1 else SERIES[place % len(SERIES)]
        found.append(Look(name, () if solid else dash))
    return found


def word_of(chart: Chart, line: Line) -> str:
    """What a legend calls a line: its label, its part, or both."""
    part = PARTS[line.role][0] if len({one.role for one in chart.lines}) > 1 else ""
    if len(chart.labels) == 1:
        return part or line.label
    return f"{line.label}, {part}" if part and line.role != "real" else line.label


def only(chart: Chart, *roles: str) -> Chart:
    """The chart with lines of these roles, in this order."""
    return replace(chart, lines=tuple(line for role in roles for line in chart.lines if line.role == role))


def singled(charts: Iterable[Chart]) -> dict[str, Chart]:
    """A chart for each label of some charts, with this as its title."""
    return {
        label: replace(
            chart, title=label, lines=tuple(replace(one, label="") for one in chart.lines if one.label == label)
        )
        for chart in charts
        for label in chart.labels
    }


def merged(parts: Mapping[str, Chart | None]) -> Chart:
    """One chart of several with single labels, whose lines take the names of these."""
    known = {name: chart for name, chart in parts.items() if chart}
    lines = (replace(line, label=name) for name, chart in known.items() for line in chart.lines)
    return replace(next(iter(known.values())), lines=tuple(lines))


def moving(lines: Mapping[str, Array]) -> list[str]:
    """The names of values that can be seen next to the others; all where none can."""
    most = max(map(largest_value, lines.values()), default=0.0)
    return [name for name, values in lines.items() if seen(values, most)] or list(lines)
