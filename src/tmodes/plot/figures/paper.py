"""Figures 6, 7 and 8 of Filipovic & Djuric (2010), of a result of the sheet of their robot, in their symbols."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Sequence
from typing import Any, ClassVar

from tmodes.plot.charts import Chart, Line, values_at
from tmodes.plot.facts import names_of
from tmodes.plot.figure import PAPER_FIGURES, Figure
from tmodes.plot.panels import Axes, AxesLike, draw_charts
from tmodes.plot.style import REAL, REFERENCE
from tmodes.plot.units import readable

__all__ = ["ElasticAngles", "EnvironmentForce", "TipCoordinates"]

ANGLES = {
    "link.elevation1": (r"\vartheta_{1,1m}", "a) vertical plane, lower part"),
    "link.elevation2": (r"\vartheta_{1,2e}", "a) vertical plane, upper part"),
    "link.azimuth1": (r"\vartheta_{1,1q}", "b) horizontal plane, lower part"),
    "link.azimuth2": (r"\vartheta_{1,2\delta}", "b) horizontal plane, upper part"),
    "joint.gear": (r"\xi", "c) gear"),
}
"""The elastic angles of the robot: symbol and panel of each."""

_LOOKS = {"real": {"label": "real", **REAL}, "reference": {"label": "reference (superscript $o$)", **REFERENCE}}


def _chart(data: Any, title: str, symbol: str, si: str, values: dict[str, Any]) -> Chart:
    """A quantity over time, by role; ``symbol`` is what its axis says."""
    lines = tuple(Line(role, role, own, look=_LOOKS[role]) for role, own in values.items())
    unit = readable(si, *values.values())
    return Chart(title, title, "paper", si, data["time"].values, lines, symbol, unit=unit)


class PaperFigure(Figure):
    """A figure of the paper: its own caption as ``title``, what is drawn in each panel as ``caption``.

    ``ax``: one axes for each panel, or None.
    """

    source = "The paper prints no values of the robot's parameters: those of the run that is drawn are assumed."
    serif = True

    @abstractmethod
    def rows(self, data: Any) -> Sequence[Sequence[Chart]]:
        """Its panels, in rows; titles begin with the letter of the panel."""

    def missing(self, data: Any) -> str:
        """Why it cannot be drawn: of a robot of another sheet, which quantity there is not."""
        bending = [name for name in ANGLES if name.startswith("link.")]
        if "deformation_kind" in data.coords and {*bending} & {*names_of(data, "deformation_kind")}:
            return super().missing(data)
        return f"a result without bending angles: {', '.join(bending)}"

    def draw(self, result: Any, ax: AxesLike = None) -> list[Axes]:
        """One panel for each quantity."""
        rows = self.rows(result.data)
        axes = draw_charts(ax, rows)
        for panel, chart in zip(axes, (chart for row in rows for chart in row), strict=True):
            panel.set_title(chart.title, loc="left")
        return axes


@PAPER_FIGURES.register
class TipCoordinates(PaperFigure):
    """Figure 6: the tip's x, y, z [m] of the real and of the reference regime, and their distance [m]."""

    name = "figure_6"
    title = "The tip coordinates and the position deviation from the reference level"
    caption = (
        "a), b), c) coordinates x, y, z of the tip, real and reference; d) distance of both at the same time."
    )  # fmt: skip

    def rows(self, data: Any) -> Sequence[Sequence[Chart]]:
        """The coordinates and the deviation."""
        known = {"real": "tip", "reference": "tip_nominal"}
        paths = [
            _chart(data, f"{letter}) coordinate {axis}", f"${axis}$", "m",
                   {role: values_at(data, (name, k)) for role, name in known.items()})
            for k, (axis, letter) in enumerate(zip("xyz", "abc", strict=True))
        ]  # fmt: skip
        apart = _chart(data, "d) deviation", "deviation", "m", {"real": values_at(data, ("deviation", 0))})
        return [paths[:2], [paths[2], apart]]


@PAPER_FIGURES.register
class EnvironmentForce(PaperFigure):
    """Figure 7: the radial force on the environment [N], real and reference, and by how much both differ."""

    name = "figure_7"
    title = "The environment force dynamics"
    caption = "a) radial force Fc of the tip on the environment, real and reference; b) real less reference."
    needs: ClassVar = {"contact_force_normal_nominal": "the result has no environment force: contact is off"}

    def rows(self, data: Any) -> Sequence[Sequence[Chart]]:
        """The force and its deviation."""
        known = {"real": "contact_force_normal", "reference": "contact_force_normal_nominal"}
        force = {role: values_at(data, (name, 0)) for role, name in known.items()}
        less = {"real": force["real"] - force["reference"]}
        return [
            [_chart(data, "a) radial force", "$F_c$", "N", force)],
            [_chart(data, "b) deviation from the reference", "$F_c - F_c^o$", "N", less)],
        ]


@PAPER_FIGURES.register
class ElasticAngles(PaperFigure):
    """Figure 8: bending angles in both planes and the deflection of the gear [rad], real and reference."""

    name = "figure_8"
    title = "The elastic deformations"
    caption = (
        "a) bending angles in the vertical plane, of the lower part of the link (the first mode) and of the upper part "
        "(the second mode); b) the same in the horizontal plane; c) deflection angle of the gear, and by how much both "
        "differ; real and reference."
    )

    def rows(self, data: Any) -> Sequence[Sequence[Chart]]:
        """A row for each plane, and one for the gear; what is rigid is left out."""
        kinds, found = names_of(data, "deformation_kind"), dict[str, list[Chart]]()
        known = {"real": "deformation", "reference": "deformation_nominal"}
        for name, (symbol, title) in ANGLES.items():
            if name in kinds:
                values = {role: values_at(data, (series, kinds.index(name))) for role, series in known.items()}
                found.setdefault(title[0], []).append(_chart(data, title, f"${symbol}$", "rad", values))
                if name == "joint.gear":
                    less, words = (
                        {"real": values["real"] - values["reference"]},
                        "c) gear, deviation from the reference",
                    )
                    found["c"].append(_chart(data, words, rf"${symbol} - {symbol}^o$", "rad", less))
        return [*found.values()]
