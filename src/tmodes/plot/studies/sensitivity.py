"""Which parameter matters: Sobol' indices, Morris' elementary effects, a tornado; and designs with their limits."""

from __future__ import annotations

from typing import Any

import numpy as np

from tmodes.plot.studies.contract import (
    STUDY_FIGURES,
    Data,
    StudyFigure,
    axis_name,
    good_rows,
    of_quantity,
    padded_figure,
    ticks_of,
    titles_of,
)
from tmodes.plot.style import BLUE, INK, OCHRE, QUIET, RED
from tmodes.plot.units import pretty

__all__ = ["Designs", "ElementaryEffects", "SobolIndices", "Swings"]


@STUDY_FIGURES.register
class SobolIndices(StudyFigure):
    """Shares of the variance: of each parameter alone, and with all its interactions."""

    name = "sobol"
    title = "Shares of the variance"

    def missing(self, data: Data, quantity: Data) -> str:
        """Only a sensitivity has them."""
        return "" if of_quantity(data, "indices", quantity) else "it is no sensitivity: tmodes sensitivity"

    def draw(self, data: Data, quantity: Data) -> Any:
        """Upper bars first order, lower bars total, lines 95 % confidence."""
        found = of_quantity(data, "indices", quantity)
        assert found is not None  # noqa: S101
        titles = titles_of(data)
        order = sorted(range(len(found["names"])), key=lambda k: found["total"][k][0])
        figure = padded_figure(1.3 + 0.34 * len(order))
        axes = figure.subplots()
        for place, k in enumerate(order):
            for part, shift, colour in (("first", 0.19, BLUE), ("total", -0.19, OCHRE)):
                value, low, high = found[part][k]
                error = np.maximum([[value - low], [high - value]], 0.0)
                label = {"first": "first order", "total": "total"}[part] if not place else None
                axes.barh(place + shift, value, height=0.34, color=colour, linewidth=0, label=label, xerr=error,
                          error_kw={"ecolor": INK, "elinewidth": 0.9})  # fmt: skip
        axes.set_yticks(range(len(order)), [titles.get(found["names"][k], found["names"][k]) for k in order])
        axes.grid(visible=False, axis="y")
        axes.use_sticky_edges = False  # a line of confidence does not end at the edge
        axes.margins(x=0.05)
        axes.set(xlabel="share of the variance", title=f"{self.title}: {quantity['title'] or quantity['name']}")
        axes.legend(loc="lower right")
        return figure


@STUDY_FIGURES.register
class ElementaryEffects(StudyFigure):
    """Mean size of the effects of each parameter (mu*), and how much they vary (sigma)."""

    name = "morris"
    title = "Elementary effects"

    def missing(self, data: Data, quantity: Data) -> str:
        """Only a sensitivity by Morris has them."""
        return "" if of_quantity(data, "effects", quantity) else "it is none: tmodes sensitivity --method morris"

    def draw(self, data: Data, quantity: Data) -> Any:
        """A point for each parameter, lines 95 % confidence; beyond the dashed line it varies by more than its size."""
        found = of_quantity(data, "effects", quantity)
        assert found is not None  # noqa: S101
        titles, size = titles_of(data), np.array(found["size"])
        value, low, high = size.T
        figure = padded_figure(3.2)
        axes = figure.subplots()
        axes.errorbar(value, found["spread"], xerr=np.maximum([value - low, high - value], 0.0), fmt="o", color=BLUE,
                      ecolor=INK, elinewidth=0.9, markersize=5)  # fmt: skip
        for name, x, y in zip(found["names"], value, found["spread"], strict=True):
            axes.annotate(titles.get(name, name), (x, y), xytext=(5, 5), textcoords="offset points", fontsize=7)
        reach = 1.08 * max(float(np.max(found["spread"])), 1e-300)
        axes.plot([0, reach], [0, reach], "--", color=QUIET, linewidth=0.9, zorder=0)
        axes.annotate("σ = μ*", (reach, reach), ha="left", va="center", xytext=(4, 0), textcoords="offset points",
                      fontsize=7, color=QUIET)  # fmt: skip
        axes.margins(x=0.12, y=0.12)
        axes.set(xlim=(min(0.0, float(low.min())), None), ylim=(0.0, None))
        unit = "" if found["unit"] == "-" else f" [{pretty(found['unit'])}]"
        axes.set(xlabel=f"mean size of the effect, μ*{unit}", ylabel=f"how much it varies, σ{unit}",
                 title=f"{self.title}: {quantity['title'] or quantity['name']}")  # fmt: skip
        return figure


_MOST = 15


@STUDY_FIGURES.register
class Swings(StudyFigure):
    """How far a quantity goes with each parameter by itself, the strongest on top."""

    name = "tornado"
    title = "What matters"

    def missing(self, data: Data, quantity: Data) -> str:
        """It needs cases at both ends of the parameters."""
        return "" if of_quantity(data, "tornados", quantity) else "too few cases"

    def draw(self, data: Data, quantity: Data) -> Any:
        """Bars from the base to where a parameter is low (blue) and high (orange)."""
        found = of_quantity(data, "tornados", quantity)
        assert found is not None  # noqa: S101
        titles = titles_of(data)
        bars = sorted(found["bars"], key=lambda bar: abs(bar["high"] - bar["low"]))[-_MOST:]
        figure = padded_figure(1.2 + 0.26 * len(bars))
        axes = figure.subplots()
        for place, bar in enumerate(bars):
            for end, colour in (("low", BLUE), ("high", RED)):
                axes.barh(place, bar[end] - found["base"], left=found["base"], color=colour, height=0.6, linewidth=0)
        axes.axvline(found["base"], color=INK, linewidth=0.8)
        axes.set_yticks(range(len(bars)), [titles[bar["name"]] for bar in bars])
        axes.grid(visible=False, axis="y")
        axes.use_sticky_edges = False
        axes.margins(x=0.05)
        axes.set(xlabel=axis_name(quantity), title=f"{self.title} (blue: low, orange: high)")
        return figure


@STUDY_FIGURES.register
class Designs(StudyFigure):
    """All designs of an optimization, its limits, the best one, and of several objectives the front."""

    name = "pareto"
    title = "Designs"
    each = False

    def missing(self, data: Data, quantity: Data) -> str:  # noqa: ARG002
        """Only an optimization has them."""
        return "" if data["designs"] else "it is no optimization: tmodes optimize"

    def draw(self, data: Data, quantity: Data) -> Any:  # noqa: ARG002
        """An objective over another one, or over what the tightest limit limits; no line through names."""
        named = {column["name"]: column for column in (*data["parameters"], *data["quantities"])}
        designs = data["designs"]
        one, two = named[designs["x"]], named[designs["y"]]
        x, y, good = one["values"], two["values"], good_rows(data)
        front, best = np.array(designs["front"], dtype=int), designs["best"]
        front = front[np.argsort(x[front])]
        figure = padded_figure(3.0)
        axes = figure.subplots()
        if not good.all():
            axes.plot(x[~good], y[~good], "x", color=QUIET, alpha=0.35, markersize=3, markeredgewidth=0.6,
                      label="beyond a limit")  # fmt: skip
        axes.plot(x[good], y[good], ".", color=INK, alpha=0.5, markersize=4, label="designs")
        if len(front):
            mark = "o" if any(column["labels"] for column in data["parameters"]) else "o-"
            axes.plot(x[front], y[front], mark, color=RED, markersize=4, linewidth=1.0, label="front")
        if best is not None:
            axes.plot(x[best], y[best], "*", color=RED, markersize=10, label="best")
        for limit in designs["limits"]:
            for column, line in ((one, axes.axvline), (two, axes.axhline)):
                if limit["column"] == column["name"]:
                    line(limit["bound"], color=QUIET, linestyle="--", linewidth=0.9, label=limit["text"])
        for axis, column, set_range in ((axes.xaxis, one, axes.set_xlim), (axes.yaxis, two, axes.set_ylim)):
            bounds = [limit["bound"] for limit in designs["limits"] if limit["column"] == column["name"]]
            set_range(*_span(column["values"], good, bounds))
            ticks_of(axis, column)
        axes.set(xlabel=axis_name(one), ylabel=axis_name(two), title=self.title)
        axes.legend()
        return figure


def _span(values: Any, good: Any, bounds: list[float]) -> tuple[float, float]:
    """A range that shows all good values and bounds, and of the others those within twice of it."""
    known = np.concatenate([values[good & np.isfinite(values)], bounds])
    known = known if len(known) else values[np.isfinite(values)]
    low, high = float(known.min()), float(known.max())
    wide = high - low or abs(high) or 1.0
    near = values[(values > low - wide) & (values < high + wide)]
    return min(low, float(near.min())) - 0.03 * wide, max(high, float(near.max())) + 0.03 * wide
