"""Figures of what commands give: bars of named numbers, points over numbers, shapes of a robot."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import product
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from tmodes.plot.panels import Axes, AxesLike, panels, side_legend
from tmodes.plot.style import COMPONENTS, GRID, INK, house_style

__all__ = ["bars", "bode", "bode_curves", "nyquist", "nyquist_reach", "points", "shape", "spans"]

_MARKERS = ("o", "s", "^")

_RING = 2.5
"""By how much a ring is wider than the next one [points]."""


def bars(
    shown: Mapping[str, ArrayLike], names: Sequence[str], what: str, *, title: str = "", ax: AxesLike = None,
    stacked: bool = False,
) -> list[Axes]:  # fmt: skip
    """Horizontal bars of the numbers (n,) of each of ``shown`` for n ``names``, next to each other or ``stacked``."""
    with house_style():
        (panel,) = panels(ax, [["a"]], 1.3 + 0.3 * max(len(names), 1))
        places, left = np.arange(len(names), dtype=float), np.zeros(len(names))
        height = 0.8 if stacked else 0.8 / max(len(shown), 1)
        for k, (label, values) in enumerate(shown.items()):
            numbers = np.nan_to_num(np.asarray(values, dtype=float))
            shift = 0.0 if stacked else height * (k - (len(shown) - 1) / 2)
            color = COMPONENTS[k % len(COMPONENTS)]["color"]
            panel.barh(places + shift, numbers, height, left, color=color, label=label or None, linewidth=0)
            left = left + numbers if stacked else left
        panel.set_yticks(places, names)
        panel.invert_yaxis()
        panel.set(xlabel=what, title=title)
        if len(shown) > 1:
            side_legend(panel)
        return [panel]


def points(
    shown: Mapping[str, tuple[ArrayLike, ArrayLike]], across: str, up: str, *, title: str = "", ax: AxesLike = None,
    line: str = "", log: bool = False, marks: bool = True,
) -> list[Axes]:  # fmt: skip
    """Points of each of ``shown``, x (n,) and y (n,), joined where ``line`` is a style; ``log``: up.

    ``marks``: each point is marked, as is right for a few.
    """
    with house_style():
        (panel,) = panels(ax, [["a"]], 3.0)
        for k, (label, (x, y)) in enumerate(shown.items()):
            turn, own = divmod(k, len(COMPONENTS))  # the same colour again has another marker
            look = {
                "marker": _MARKERS[turn % len(_MARKERS)] if marks else "None",
                "markersize": 3,
                "color": COMPONENTS[own]["color"],
            }
            if not line and k < len(shown) - 1:  # a ring around the points of those to come, which may be at its place
                look |= {"markersize": 3 + _RING * (len(shown) - 1 - k), "fillstyle": "none"}
            panel.plot(x, y, linestyle=line or "none", label=label or None, **look)
        panel.set(xlabel=across, ylabel=up, title=title)
        panel.margins(x=0.05)
        if log:
            panel.set_yscale("log")
        else:
            panel.axhline(0.0, color=INK, linewidth=0.4)
        if len(shown) > 1:
            _outer_legend(panel, ax)
        return [panel]


def spans(
    names: Sequence[str], marks: Mapping[str, ArrayLike], what: str, *,
    between: tuple[str, ArrayLike, ArrayLike] | None = None, limit: tuple[str, float] | None = None, title: str = "",
    ax: AxesLike = None,
) -> list[Axes]:  # fmt: skip
    """A row for each of n ``names``: its ``marks`` (n,), a bar ``between`` two ends (n,), and a ``limit`` for all."""
    with house_style():
        (panel,) = panels(ax, [["a"]], 1.3 + 0.3 * max(len(names), 1))
        places = np.arange(len(names), dtype=float)
        if between is not None:
            label, low, high = between
            panel.hlines(places, np.asarray(low), np.asarray(high), color=GRID, linewidth=7, label=label, zorder=1)
        every = [np.asarray(values, dtype=float) for values in marks.values()]
        for k, (label, values) in enumerate(zip(marks, every, strict=True)):
            look = {"marker": _MARKERS[k % len(_MARKERS)], "color": COMPONENTS[k % len(COMPONENTS)]["color"]}
            panel.plot(values, places, linestyle="none", markersize=5, label=label, zorder=3, **look)
        if limit is not None:
            panel.axvline(limit[1], color=INK, linewidth=0.9, linestyle="--", label=limit[0], zorder=2)
        panel.set_yticks(places, names)
        panel.set_ylim(len(names) - 0.5, -0.5)
        known = np.concatenate([one[np.isfinite(one) & (one > 0)] for one in every])
        if len(known) and known.max() > _DECADES * known.min():
            panel.set_xscale("log")
        elif len(known):
            panel.set_xlim(0.0, 1.05 * max(known.max(), limit[1] if limit else 0.0))
        panel.set(xlabel=what, title=title)
        _outer_legend(panel, ax)
        return [panel]


def _outer_legend(panel: Axes, ax: AxesLike) -> None:
    """A legend right of a panel, with room in a figure of its own: names are wider on paper than where measured."""
    side_legend(panel)
    engine: Any = panel.figure.get_layout_engine()
    if ax is None and engine:
        engine.set(w_pad=0.1)


_DECADES = 30.0
"""Largest over smallest number beyond which an axis is logarithmic."""


def shape(lines: Mapping[str, Sequence[ArrayLike]], *, title: str = "", ax: AxesLike = None) -> list[Axes]:
    """Lines (S, 3) [m] of robots, in the plane of the two world axes along which they extend most."""
    every = np.concatenate([np.asarray(one, dtype=float) for some in lines.values() for one in some])
    across, up = sorted(np.argsort(-np.ptp(every, axis=0), kind="stable")[:2].tolist())
    with house_style():
        (panel,) = panels(ax, [["a"]], 3.2)
        for k, (label, some) in enumerate(lines.items()):
            for number, one in enumerate(some):
                own = np.asarray(one, dtype=float)
                panel.plot(own[:, across], own[:, up], label=None if number else label, **COMPONENTS[-1 - k])
        panel.set(xlabel=f"{'xyz'[across]} [m]", ylabel=f"{'xyz'[up]} [m]", title=title)
        panel.set_aspect("equal", adjustable="datalim")
        panel.legend()
        return [panel]


def _pairs(response: Any) -> Iterator[tuple[str, Any, Any]]:
    """Each input and output in words, its values, and how it looks."""
    for k, (source, output) in enumerate(product(response.input.values, response.output.values)):
        values = response.sel(output=output, input=source).values
        yield f"{source} to {output}", values, COMPONENTS[k % len(COMPONENTS)]


def bode_curves(response: Any, family: Any = None) -> Iterator[tuple[str, Any, list[Any], list[list[Any]]]]:
    """Each input and output in words, its look, its gain [dB] and phase [deg], and the ranges of a ``family`` of both.

    The phase of each of the family is that of the response and the phase of their ratio, by at most half a turn:
    unwrapped along frequencies it would be off by whole turns behind a zero that is hardly damped.
    """
    every = [one for _, one, _ in _pairs(family)] if family is not None else []
    with np.errstate(divide="ignore", invalid="ignore"):
        for k, (label, values, look) in enumerate(_pairs(response)):
            own = [20 * np.log10(np.abs(values)), np.degrees(np.unwrap(np.angle(values)))]
            ranges = []
            if every:
                apart = np.degrees(np.angle(every[k] * np.conj(values)))
                each = (20 * np.log10(np.abs(every[k])), own[1] + apart)
                ranges = [[one.min(axis=0), one.max(axis=0)] for one in each]
            yield label, look, own, ranges


def bode(response: Any, *, family: Any = None, title: str = "", ax: AxesLike = None) -> list[Axes]:
    """Gain [dB] over phase [deg] of a complex ``response`` by frequency [Hz], output and input.

    ``family``: responses along ``case``, too, whose range is shaded.
    """
    with house_style():
        gain, phase = panels(ax, [["a"], ["b"]], 4.6)
        at = response.frequency.values
        for k, (label, look, own, ranges) in enumerate(bode_curves(response, family)):
            gain.plot(at, own[0], label=label, **look)
            phase.plot(at, own[1], **look)
            for panel, ends in zip((gain, phase), ranges, strict=False):
                panel.fill_between(at, *ends, color=look["color"], alpha=0.35, linewidth=0, zorder=1,
                                   label="" if k else "uncertain robots")  # fmt: skip
        for panel in (gain, phase):
            panel.set_xscale("log")
        gain.set(ylabel="gain [dB]", title=title)
        phase.set(xlabel="frequency [Hz]", ylabel="phase [deg]")
        _outer_legend(gain, ax)
        return [gain, phase]


_NEAR, _LOOP = 4.0, 0.3
"""Radius of a Nyquist diagram of a response that is larger, so that the point -1 is seen; from which on it is shown."""


def nyquist_reach(largest: float) -> tuple[float, bool]:
    """How far a Nyquist diagram reaches, and whether it shows the point -1."""
    loops = largest > _LOOP
    return 1.1 * min(max(largest, float(loops)) or 1.0, _NEAR), loops


def nyquist(response: Any, *, title: str = "", ax: AxesLike = None) -> list[Axes]:
    """The complex ``response`` as a curve for growing frequency, its mirror image thin, and the point -1 of loops."""
    with house_style():
        (panel,) = panels(ax, [["a"]], 4.0)
        largest = 0.0
        for k, (label, values, look) in enumerate(_pairs(response)):
            panel.plot(values.real, values.imag, label=label, **look)
            panel.plot(values.real, -values.imag, color=look["color"], linewidth=0.8, linestyle=":",
                       label="" if k else "negative frequencies")  # fmt: skip
            largest = max(largest, float(np.abs(values).max(initial=0.0)))
        reach, loops = nyquist_reach(largest)
        if loops:
            panel.plot(-1.0, 0.0, marker="+", color=INK, linestyle="none", label="-1")
        panel.axhline(0.0, color=GRID, linewidth=0.6, zorder=0)
        panel.axvline(0.0, color=GRID, linewidth=0.6, zorder=0)
        panel.set(xlabel="real part", ylabel="imaginary part", title=title, xlim=(-reach, reach), ylim=(-reach, reach))
        panel.set_aspect("equal")
        panel.legend(loc="upper center", bbox_to_anchor=(0.5, -0.13))
        return [panel]
