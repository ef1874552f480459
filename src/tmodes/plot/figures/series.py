"""Figures that lay out the charts of a run: the tip, joints and motors, deformations, contact, energy."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np

from tmodes.plot.charts import Chart, merged, only, singled
from tmodes.plot.contents import figure_charts
from tmodes.plot.facts import largest
from tmodes.plot.figure import ChartFigure, Rows, register
from tmodes.plot.panels import MOST_ROWS
from tmodes.plot.ranges import seen
from tmodes.plot.units import Unit, largest_value
from tmodes.result.result import Result

Charts = dict[str, Chart]


def _laid(group: str, rows: Callable[[Charts], Rows]) -> Callable[[Result], Rows]:
    """Rows of the charts of one group."""
    return lambda result: rows(figure_charts(result, group))


def _below(charts: Charts) -> Rows:
    """Every chart in a row of its own."""
    return [[chart] for chart in charts.values()]


def _of(charts: Charts, name: str) -> Charts:
    """A chart for each label of those with this name, whatever their units."""
    return singled(chart for own, chart in charts.items() if own.rpartition("_")[0] == name)


def _most(charts: Charts, most: int, size: Callable[[Any], float] = largest_value) -> list[str]:
    """Names of the charts whose first curves are largest, in their order, without those that cannot be seen."""
    sizes = [float(size(chart.lines[0].values)) for chart in charts.values()]
    kept = [name for name, own in zip(charts, sizes, strict=True) if seen(own, max(sizes))] or [*charts]
    return [name for name in largest([*charts], sizes, most) if name in kept]


def _titled(chart: Chart, title: str, among: Charts, most: int = 33) -> Chart:
    """The chart with this title after its own, or alone where that is too long of any."""
    fits = all(len(f"{one.title}, {title}") <= most for one in among.values())
    return replace(chart, title=f"{chart.title}, {title}" if fits else title)


def _tracking(charts: Charts) -> Rows:
    """The coordinates side by side, below them the error."""
    error = charts.pop("tip_deviation", None)
    return [[*charts.values()], *([[error]] if error else [])]


register(ChartFigure(
    "tip_tracking", "Tip position",
    "Position of the tip: actual, nominal (the elasticity as known), and commanded (no elasticity, the setpoints); "
    "with a nominal run, the last panel shows by how much and in which direction the actual tip leaves its path.",
    _laid("tip", _tracking),
    "Tip x, y, z [m]; commanded and nominal too, and the error from the nominal path [m]: distance, components.\n\n"
    "A coordinate that is zero throughout is left out. ``ax``: an axes for each other one and, with a nominal run, one "
    "for the error, or None.",
))  # fmt: skip

register(ChartFigure(
    "tip_errors", "Error of the tip, by cause",
    "Distance of the actual tip from the commanded path (the undeformed robot at its setpoints) and from the "
    "nominal one (elastic as known): areas are the components of its parts along it, which add up to it; a part "
    "below zero lessens the error, so that another can be larger than the whole.",
    _laid("error", _below),
    "Distance of the actual tip from the commanded and from the nominal path [m], and its parts along that error.\n\n"
    "``ax``: an axes for each path that there is, or None.",
    {"tip_error": "no drive has a setpoint, or an earlier version wrote the result"},
))  # fmt: skip


def _coordinates(charts: Charts, cause: str = "") -> Charts:
    """A chart for each elastic coordinate of gears, or of links; or of both."""
    return {
        (name := chart.title if label in chart.title.lower() else f"{chart.title}, {label}"): replace(one, title=name)
        for chart in charts.values()
        if cause in ("", chart.lines[0].cause)
        for label, one in singled([chart]).items()
    }


def _pairs(charts: Charts) -> Rows:
    """One panel for each coordinate, two in a row."""
    own = {name: only(chart, "real", "reference") for name, chart in _coordinates(charts).items()}
    shown = [own[name] for name in _most(own, 10)]
    return [shown[k : k + 2] for k in range(0, len(shown), 2)]


register(ChartFigure(
    "deformations", "Elastic deformations",
    "Actual and nominal deformation of links and gears; note the scales, and the sag at the start.",
    _laid("deformations", _pairs),
    "Elastic coordinates of links and gears [rad, m], actual and nominal: the ten largest.\n\n"
    "``ax``: one axes for each, or None.",
    {"deformation_nominal": "there is no nominal run, or nothing of this robot is elastic"},
))  # fmt: skip

SMALL = 1e-3
"""A dynamic part below this share of the coordinate has no panel; the title says how large it is."""


def _decomposed(cause: str, most: int) -> Callable[[Result], Rows]:
    """For the largest coordinates the total with its static part; the dynamic part, if it can be seen."""

    def rows(charts: Charts) -> Rows:
        own = _coordinates(charts, cause)
        return [_parts(own[name], own) for name in _most(own, most)]

    return _laid("deformations", rows)


def _parts(chart: Chart, among: Charts) -> list[Chart]:
    total, part = only(chart, "real", "stationary", "reference"), only(chart, "oscillatory")
    share = largest_value(part.values) / (largest_value(total.values) or 1.0)
    if 0 < share < SMALL:
        return [replace(total, title=f"{chart.title} (dynamic part at most {100 * share:.1g} %)")]
    return [total, _titled(part, "dynamic part", among)]


register(ChartFigure(
    "gear_deflections", "Deflection of the gears",
    "Left, with what the present forces would hold statically; right, on its own scale, the oscillation about it.",
    _decomposed("gear", 8),
    "Gear output − input [rad]: total with its static part (left), dynamic part (right).\n\n"
    "Of more than eight gears, those that deflect most. ``ax``: two axes for each that oscillates, else one, or None.",
    {"deformation_stationary": "no gear of this robot is elastic"}, "gear",
))  # fmt: skip

register(ChartFigure(
    "link_coordinates", "Elastic coordinates of the links",
    "The largest coordinates of bending, torsion and stretch: left with what the present forces would hold "
    "statically, right the oscillation about it.",
    _decomposed("link", 6),
    "The six largest elastic coordinates of the links [rad, m], decomposed as the deflections of the gears are.\n\n"
    "``ax``: two axes for each that oscillates, else one, or None.",
    {"deformation_stationary": "no link of this robot is elastic"}, "link",
))  # fmt: skip


def _joints(charts: Charts) -> Rows:
    """Two panels for each joint."""
    places, errors, rates = (_of(charts, name) for name in ("joint", "joint_error", "rate"))
    right = {name: _titled(one, "error from setpoint", places) for name, one in errors.items()}
    right |= {name: _titled(one, "rate", places) for name, one in rates.items()}
    return [[places[name], right[name]] for name in _most(places, MOST_ROWS, np.ptp)]


register(ChartFigure(
    "joint_tracking", "Joints",
    "Left, the position of each joint and of its motor; right, on its own scale, its error from the setpoint.",
    _laid("joints", _joints),
    "Left, each joint with its motor and its setpoint [rad, m]; right, their errors.\n\n"
    "Of a joint without a position setpoint, its rate is on the right. Of more than eight joints, those that move "
    "most. ``ax``: two axes for each joint, or None.",
    {"drive": "no joint of this robot can be driven"},
))  # fmt: skip


def _efforts(charts: Charts) -> Rows:
    """One row for each joint."""
    efforts, gears, *electric = (_of(charts, name) for name in ("effort", "gear_torque", "voltage", "current"))
    words = [*zip(("voltage", "current"), electric, strict=True)]
    chosen = _most(efforts, MOST_ROWS)
    parts = {name: [_titled(own[name], word, own, 20) for word, own in words if name in own] for name in chosen}
    return [[merged({"motor": efforts[name], "gear": gears.get(name)}), *parts[name]] for name in chosen]


register(ChartFigure(
    "joint_efforts", "Motors and gears",
    "The effort that the motion demands of each motor, and the torque that its gear transmits.",
    _laid("joints", _efforts),
    "Effort of each motor and torque of its gear [N m, N]; voltage [V] and current [A] of electric motors.\n\n"
    "Of more than eight joints, those with the largest efforts. ``ax``: one axes for each joint, three for one with an "
    "electric motor, or None.",
    {"drive": "no joint of this robot can be driven"},
))  # fmt: skip

register(ChartFigure(
    "controller_states", "States of the controllers",
    "What the controllers keep: integrals, estimates, and the commands that sampled controllers hold.",
    _laid("controllers", lambda charts: _below(singled(charts.values()))[:MOST_ROWS]),
    "The first eight own states of the controllers, each in its unit. ``ax``: one axes for each.",
    {"controller_states": "no controller of this robot has states of its own"},
))  # fmt: skip

NEARLY_CONSTANT = 0.05
"""A force that varies by less than this share of its largest value is noted to be nearly constant."""


def _forces(charts: Charts) -> Rows:
    """Normal force twice, its components, the penetration."""
    normal, *others = charts.values()
    force, first = normal.lines[0].values, [replace(normal, zero=True)]
    share = float(np.ptp(force)) / (largest_value(force) or 1.0)
    if share < NEARLY_CONSTANT:
        words = _constancy(normal.unit.of(force), share, normal.unit)
        first = [replace(normal, title="Normal force, from zero", zero=True, note=words)]
        first += [replace(normal, title="Normal force, close-up")]
    return [first, *([one] for one in others)]


def _constancy(force: Any, share: float, unit: Unit) -> str:
    """The range in words, so that no one takes the close-up for a large change."""
    low, high = float(np.min(force)), float(np.max(force))
    digits = int(np.clip(2 - np.floor(np.log10(max(high - low, 1e-9))), 2, 6))
    return f"actual: nearly constant,\nwithin {100 * share:.2g} %:\n{low:.{digits}f} to {high:.{digits}f} {unit.name}"


register(ChartFigure(
    "contact_force", "Contact force",
    "The normal force on an axis from zero and, where it varies little, in close-up: the first shows how large its "
    "changes are, the second their course. A negative penetration is a gap.",
    _laid("contact", _forces),
    "Normal force [N], actual and nominal; its components [N]; penetration [m].\n\n"
    "Of a force that hardly varies, a close-up too. ``ax``: three axes, four with a close-up, or None.",
    {"contact_force": "the robot moved in free space: there is no contact force"},
))  # fmt: skip

register(ChartFigure(
    "energies", "Energy balance",
    "The residual (last, on a logarithmic axis) should stay many orders of magnitude below the energies and works; "
    "that of springs has its own axis too. Work of motors, loads, and the base is supplied, that of others dissipated.",
    _laid("energies", _below),
    "Energy by kind [J], that of springs on its own axis too, work since the start, residual of the balance [J].\n\n"
    "Kinds that are zero throughout are left out. ``ax``: four axes, without elastic energy three, or None.",
))  # fmt: skip
