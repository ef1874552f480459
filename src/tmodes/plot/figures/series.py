"""Figures that lay out the charts of a run: the tip, joints and motors, deformations, contact, energy."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Sequence
from dataclasses import replace
from typing import Any, ClassVar

import numpy as np

from tmodes.plot.charts import Chart, merged, only, singled
from tmodes.plot.contents import figure_charts
from tmodes.plot.facts import largest
from tmodes.plot.figure import Figure, register
from tmodes.plot.panels import MOST_ROWS, Axes, AxesLike, draw_charts
from tmodes.plot.ranges import seen
from tmodes.plot.units import Unit, largest_value

__all__ = [
    "ContactForce", "ControllerStates", "Deformations", "EnergiesFigure", "GearDeflections", "JointEfforts",
    "JointTracking", "LinkCoordinates", "TipErrors", "TipTracking",
]  # fmt: skip

Charts = dict[str, Chart]
Rows = Sequence[Sequence[Chart]]


class ChartFigure(Figure):
    """A figure of charts of one ``group``, in rows. ``ax``: one axes for each chart as one reads, or None."""

    group: ClassVar[str]

    @abstractmethod
    def rows(self, charts: Charts) -> Rows:
        """The charts in rows, from those of the group by their names."""

    def draw(self, result: Any, ax: AxesLike = None) -> list[Axes]:
        """One panel for each chart."""
        return draw_charts(ax, self.rows(figure_charts(result, self.group)))


def _of(charts: Charts, *names: str) -> Charts:
    """A chart for each label of those with these names, whatever their units."""
    return singled(chart for name, chart in charts.items() if name.rpartition("_")[0] in names)


def _most(charts: Charts, most: int) -> list[str]:
    """Names of the charts whose first curves vary most, in their order, without those that stay still."""
    sizes = [float(np.ptp(chart.lines[0].values)) for chart in charts.values()]
    sizes = [size or largest_value(chart.lines[0].values) for size, chart in zip(sizes, charts.values(), strict=True)]
    kept = [name for name, size in zip(charts, sizes, strict=True) if seen(size, max(sizes))]
    return [name for name in largest([*charts], sizes, most) if name in kept or not kept]


def _titled(chart: Chart, title: str, among: Charts, most: int = 33) -> Chart:
    """The chart with this title after its own, or alone where that is too long of any."""
    fits = all(len(f"{one.title}, {title}") <= most for one in among.values())
    return replace(chart, title=f"{chart.title}, {title}" if fits else title)


@register
class TipTracking(ChartFigure):
    """Tip x, y, z [m]; commanded and nominal too, and the error from the nominal path [m]: distance, components.

    A coordinate that is zero throughout is left out. ``ax``: an axes for each other one and, with a nominal run, one
    for the error, or None.
    """

    name = "tip_tracking"
    title = "Tip position"
    caption = (
        "Position of the tip: actual, nominal (the elasticity as known), and commanded (no elasticity, the setpoints); "
        "with a nominal run, the last panel shows by how much and in which direction the actual tip leaves its path."
    )
    group = "tip"

    def rows(self, charts: Charts) -> Rows:
        """The coordinates side by side, below them the error."""
        paths = [chart for name, chart in charts.items() if name != "tip_deviation"]
        return [paths, *([charts["tip_deviation"]] for _ in range("tip_deviation" in charts))]


@register
class TipErrors(ChartFigure):
    """Distance of the actual tip from the commanded and from the nominal path [m], and its parts along that error.

    ``ax``: an axes for each path that there is, or None.
    """

    name = "tip_errors"
    title = "Error of the tip, by cause"
    caption = (
        "Distance of the actual tip from the commanded path (the undeformed robot at its setpoints) and from the "
        "nominal one (elastic as known): areas are the components of its parts along it, which add up to it; a part "
        "below zero lessens the error, so that another can be larger than the whole."
    )
    needs: ClassVar = {"tip_error": "no drive has a setpoint, or an earlier version wrote the result"}
    group = "error"

    def rows(self, charts: Charts) -> Rows:
        """One for each path."""
        return [[chart] for chart in charts.values()]


@register
class Deformations(ChartFigure):
    """Elastic coordinates of links and gears [rad, m], actual and nominal: the ten that change most.

    ``ax``: one axes for each, or None.
    """

    name = "deformations"
    title = "Elastic deformations"
    caption = "Actual and nominal deformation of links and gears; note the scales, and the sag at the start."
    needs: ClassVar = {"deformation_nominal": "there is no nominal run, or nothing of this robot is elastic"}
    group = "deformations"

    def rows(self, charts: Charts) -> Rows:
        """One panel for each coordinate, two in a row."""
        own = {name: only(chart, "real", "reference") for name, chart in _coordinates(charts).items()}
        shown = [own[name] for name in _most(own, 10)]
        return [shown[k : k + 2] for k in range(0, len(shown), 2)]


def _coordinates(charts: Charts, cause: str = "") -> Charts:
    """A chart for each elastic coordinate of gears, or of links; or of both."""
    wanted = [chart for chart in charts.values() if cause in ("", chart.lines[0].cause)]
    return {
        (name := chart.title if label in chart.title.lower() else f"{chart.title}, {label}"): replace(one, title=name)
        for chart in wanted
        for label, one in singled([chart]).items()
    }


SMALL = 1e-3
"""A dynamic part below this share of the coordinate has no panel; the title says how large it is."""


class _Decomposition(ChartFigure):
    cause: ClassVar[str]
    """What the coordinates are of: gears or links."""

    most: ClassVar[int]
    group = "deformations"

    def missing(self, data: Any) -> str:
        """A robot that is elastic elsewhere alone has no such figure."""
        names = data["deformation_kind"].values if "deformation_kind" in data.dims else []
        known = [name for name in names if (name in data["coordinate"].values) == (self.cause == "link")]
        return super().missing(data) or ("" if known else self.needs["deformation_stationary"])

    def rows(self, charts: Charts) -> Rows:
        """The total with its static part; the dynamic part, if it can be seen."""
        own = _coordinates(charts, self.cause)
        return [self._row(own[name], own) for name in _most(own, self.most)]

    def _row(self, chart: Chart, among: Charts) -> list[Chart]:
        total, part = only(chart, "real", "stationary", "reference"), only(chart, "oscillatory")
        share = largest_value(part.values) / (largest_value(total.values) or 1.0)
        if 0 < share < SMALL:
            return [replace(total, title=f"{chart.title} (dynamic part at most {100 * share:.1g} %)")]
        return [total, _titled(part, "dynamic part", among)]


@register
class GearDeflections(_Decomposition):
    """Gear output − input [rad]: total with its static part (left), dynamic part (right).

    Of more than eight gears, those that deflect most. ``ax``: two axes for each that oscillates, else one, or
    None.
    """

    name = "gear_deflections"
    title = "Deflection of the gears"
    caption = (
        "Left, with what the present forces would hold statically; right, on its own scale, the oscillation about it."
    )
    needs: ClassVar = {"deformation_stationary": "no gear of this robot is elastic"}
    cause, most = "gear", 8


@register
class LinkCoordinates(_Decomposition):
    """The six largest elastic coordinates of the links [rad, m], decomposed as the deflections of the gears are.

    ``ax``: two axes for each that oscillates, else one, or None.
    """

    name = "link_coordinates"
    title = "Elastic coordinates of the links"
    caption = (
        "The largest coordinates of bending, torsion and stretch: left with what the present forces would hold "
        "statically, right the oscillation about it."
    )
    needs: ClassVar = {"deformation_stationary": "no link of this robot is elastic"}
    cause, most = "link", 6


@register
class JointTracking(ChartFigure):
    """Left, each joint with its motor and its setpoint [rad, m]; right, their tracking errors.

    Of a joint without a position setpoint, its rate is on the right. Of more than eight joints, those that move most.
    ``ax``: two axes for each joint, or None.
    """

    name = "joint_tracking"
    title = "Joints"
    caption = "Left, the position of each joint and of its motor; right, on its own scale, its error from the setpoint."
    needs: ClassVar = {"drive": "no joint of this robot can be driven"}
    group = "joints"

    def rows(self, charts: Charts) -> Rows:
        """Two panels for each joint."""
        places, rates = _of(charts, "joint"), _of(charts, "rate")
        right = {name: (one, "error from setpoint") for name, one in _of(charts, "joint_error").items()}
        right |= {name: (one, "rate") for name, one in rates.items()}
        return [[places[name], _titled(*right[name], places)] for name in _most(places, MOST_ROWS)]


@register
class JointEfforts(ChartFigure):
    """Effort of each motor and torque of its gear [N m, N]; voltage [V] and current [A] of electric motors.

    Of more than eight joints, those with the largest efforts. ``ax``: one axes for each joint, three for one with an
    electric motor, or None.
    """

    name = "joint_efforts"
    title = "Motors and gears"
    caption = "The effort that the motion demands of each motor, and the torque that its gear transmits."
    needs: ClassVar = {"drive": "no joint of this robot can be driven"}
    group = "joints"

    def rows(self, charts: Charts) -> Rows:
        """One row for each joint."""
        efforts, gears, *electric = (_of(charts, name) for name in ("effort", "gear_torque", "voltage", "current"))
        shown = {name: merged({"motor": efforts[name], "gear": gears.get(name)}) for name in efforts}
        chosen = largest([*shown], [largest_value(efforts[name].values) for name in shown], MOST_ROWS)
        words = [*zip(("voltage", "current"), electric, strict=True)]
        parts = {name: [_titled(own[name], word, own, 20) for word, own in words if name in own] for name in chosen}
        return [[shown[name], *parts[name]] for name in chosen]


@register
class ControllerStates(ChartFigure):
    """The first eight own states of the controllers, each in its unit. ``ax``: one axes for each."""

    name = "controller_states"
    title = "States of the controllers"
    caption = "What the controllers keep: integrals, estimates, and the commands that sampled controllers hold."
    needs: ClassVar = {"controller_states": "no controller of this robot has states of its own"}
    group = "controllers"

    def rows(self, charts: Charts) -> Rows:
        """One row for each state."""
        return [[chart] for chart in [*singled(charts.values()).values()][:MOST_ROWS]]


NEARLY_CONSTANT = 0.05
"""A force that varies by less than this share of its largest value is noted to be nearly constant."""


@register
class ContactForce(ChartFigure):
    """Normal force [N], actual and nominal; its components [N]; penetration [m].

    Of a force that hardly varies, a close-up too. ``ax``: three axes, four with a close-up, or None.
    """

    name = "contact_force"
    title = "Contact force"
    caption = (
        "The normal force on an axis from zero and, where it varies little, in close-up: the first shows how large its "
        "changes are, the second their course. A negative penetration is a gap."
    )
    needs: ClassVar = {"contact_force": "the robot moved in free space: there is no contact force"}
    group = "contact"

    def rows(self, charts: Charts) -> Rows:
        """Normal force twice, its components, the penetration."""
        normal, *others = charts.values()
        force = normal.lines[0].values
        share = float(np.ptp(force)) / (largest_value(force) or 1.0)
        first = [replace(normal, zero=True)]
        if share < NEARLY_CONSTANT:
            words = _constancy(normal.unit.of(force), share, normal.unit)
            far = replace(normal, title="Normal force, from zero", zero=True, note=words)
            first = [far, replace(normal, title="Normal force, close-up")]
        return [first, *([one] for one in others)]


def _constancy(force: Any, share: float, unit: Unit) -> str:
    """The range in words, so that no one takes the close-up for a large change."""
    low, high = float(np.min(force)), float(np.max(force))
    digits = int(np.clip(2 - np.floor(np.log10(max(high - low, 1e-9))), 2, 6))
    return f"actual: nearly constant,\nwithin {100 * share:.2g} %:\n{low:.{digits}f} to {high:.{digits}f} {unit.name}"


@register
class EnergiesFigure(ChartFigure):
    """Energy by kind [J], that of springs on its own axis too, work since the start, residual of the balance [J].

    Kinds that are zero throughout are left out. ``ax``: four axes, without elastic energy three, or None.
    """

    name = "energies"
    title = "Energy balance"
    caption = (
        "The residual (last, on a logarithmic axis) should stay many orders of magnitude below the energies and works; "
        "that of springs has its own axis too. Work of motors, loads, and the base is supplied, that of others "
        "dissipated."
    )
    group = "energies"

    def rows(self, charts: Charts) -> Rows:
        """Energies, works, residual."""
        return [[chart] for chart in charts.values()]
