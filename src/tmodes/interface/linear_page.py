"""The page of a linear model: poles and zeros, Bode and Nyquist diagrams, steps, singular values, all tables."""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from math import pi
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.errors import InputError
from tmodes.io.atomic import check_writable
from tmodes.io.printed import Table, pretty
from tmodes.report.plots import Axis, Curve, Page, Plot, write_plots

__all__ = ["chart_of", "write_page"]

_SPREAD = 30.0
"""Largest over smallest pole beyond which the map of poles is logarithmic."""
_CHORD, _HALVED = 0.02, 6
"""Longest part of a Nyquist diagram between two frequencies, over its size, and how often steps are halved for it."""
_MOST_PAIRS = 12
"""Inputs times outputs of which a page shows the responses; of more the first ones."""


def chart_of(found: Any, chart: str, ax: Any) -> list[Any]:
    """A chart of this model; raises :class:`tmodes.errors.InputError` for an unknown name."""
    from tmodes.plot import commands

    if chart == "bode":
        family = found.family_response() if found.family else None
        return commands.bode(found.frequency_response(), family=family, title=found.name, ax=ax)
    if chart == "nyquist":
        return commands.nyquist(found.frequency_response(_turning(found)), title=found.name, ax=ax)
    if chart != "step":
        hint = "tmodes linear FILE --chart nyquist"
        raise InputError("chart", f"`{chart}`", "bode, nyquist or step", hint)
    steps, units = found.step_response(), found.system.units
    lines = {f"{source} to {name} [{units.get(name, '')}]": (steps.time, steps.sel(input=source, output=name))
             for source in found.inputs for name in found.outputs}  # fmt: skip
    return commands.points(lines, "time [s]", "after a step of 1", title=found.name, ax=ax, line="-", marks=False)


def _turning(found: Any) -> NDArray[np.float64]:
    """Frequencies [Hz] (n,) at which a Nyquist diagram has no corners: more where it goes far from one to the next."""
    from tmodes.plot.commands import nyquist_reach

    at = found.frequencies()
    for _ in range(_HALVED):
        values = found.frequency_response(at).values.reshape(len(at), -1)
        reach, _ = nyquist_reach(float(np.abs(values).max(initial=0.0)))
        far, seen = np.abs(np.diff(values, axis=0)) > _CHORD * reach, np.abs(values) < 2 * reach
        at = np.sort(np.append(at, np.sqrt(at[1:] * at[:-1])[(far & (seen[1:] | seen[:-1])).any(axis=1)]))
    return at


def write_page(found: Any, path: Path) -> Path:
    """The page of this model."""
    check_writable(path.parent, 0)
    heading, *parts = found.tables()
    states = [[name, f"{value:.5g}"] for name, value in zip(found.states, found.system.x0, strict=True)]
    about = [["robot", found.name], ["loop", "under its controllers" if found.closed else "open"],
             ["about", found.where], ["sampled", f"every {found.period:g} s" if found.period else "no"],
             ["uncertain robots", str(len(found.family))]]  # fmt: skip
    return write_plots(Page(
        f"{found.name}: linear model", str(heading).partition(": ")[2], found.sentence, [*_plots(found)],
        [*parts, Table("states", ["name", "value there"], states)],
        "neutral" if found.is_stable or not found.closed else "warning", found.warnings, found.notices, {},
        {f"{found.name}.json": json.dumps(found.info())}, about,
    ), path)  # fmt: skip


def _fewer(count: int) -> str:
    """That of so many pairs of an input and an output not all are shown."""
    return f"The first {_MOST_PAIRS} of {count} pairs; --inputs and --outputs choose." if count > _MOST_PAIRS else ""


def _looks(count: int) -> list[dict[str, Any]]:
    from tmodes.plot.style import CYCLE, SERIES

    return [{"colour": CYCLE[k % len(CYCLE)], "dash": SERIES[k % len(SERIES)]} for k in range(count)]


def _plots(found: Any) -> Iterator[Plot]:
    from tmodes.plot.commands import bode_curves

    yield _map(found)
    shown = found.frequency_response()
    rates = Axis("frequency [Hz]", "log", range=(float(shown.frequency[0]), float(shown.frequency[-1])))
    at, pairs = shown.frequency.values, list(bode_curves(shown, found.family_response() if found.family else None))
    looks, fewer = _looks(len(pairs)), _fewer(len(pairs))
    shaded = f"Shaded: the range of {len(found.family)} uncertain robots." if found.family else ""
    for k, (title, label) in enumerate((("Gain", "gain [dB]"), ("Phase", "phase [deg]"))):
        bands, curves = [], []
        for (name, _, own, ranges), look in zip(pairs[:_MOST_PAIRS], looks, strict=False):
            if ranges:
                low, high = ranges[k]
                area = np.append(at, at[::-1]), np.append(low, high[::-1])
                bands.append(Curve(name, *area, "band", look["colour"]))
            curves.append(Curve(name, at, own[k], **look))
        yield Plot(title, rates, Axis(label), [*bands, *curves], " ".join(filter(None, (fewer, shaded))))
    yield _nyquist(found, found.frequency_response(_turning(found)), [pair[0] for pair in pairs], looks)
    steps, units = found.step_response(), found.system.units
    every = [(f"{source} to {name} [{pretty(units.get(name, ''))}]", steps.sel(input=source, output=name).values)
             for source in found.inputs for name in found.outputs]  # fmt: skip
    lines = [Curve(name, steps.time.values, values, **look) for (name, values), look in zip(every, looks, strict=True)]
    yield Plot("Step", Axis("time [s]"), Axis("after a step of 1"), lines[:_MOST_PAIRS],
               f"The change of each output after a step of 1 of an input, in SI units. {fewer}".strip())  # fmt: skip
    values = found.singular_values()
    with np.errstate(divide="ignore"):
        sizes = 20 * np.log10(values.values)
    lines = [Curve(f"number {k + 1}", at, one, **look)
             for k, (one, look) in enumerate(zip(sizes.T, _looks(sizes.shape[1]), strict=True))]  # fmt: skip
    yield Plot("Singular values", rates, Axis("singular value [dB]"), lines,
               "Largest and least gain over all directions of the inputs, in SI units.")  # fmt: skip


def _map(found: Any) -> Plot:
    """Poles of it and of its family, zeros of each pair, with the line (or circle) beyond which they are unstable."""
    members = [np.linalg.eigvals(one.A) for one in found.family]
    curves = [Curve("poles of uncertain robots", one.real, one.imag, "dots", "sky") for one in members]
    pairs = [(source, output) for source in found.inputs for output in found.outputs][:_MOST_PAIRS]
    for (source, output), look in zip(pairs, _looks(len(pairs)), strict=True):
        zeros = found.zeros(output, source)
        if len(zeros):
            curves.append(Curve(f"zeros, {source} to {output}", zeros.real, zeros.imag, "ring", look["colour"]))
    curves.append(Curve("poles", found.poles.real, found.poles.imag, "cross", "ink"))
    if found.period:
        turn = np.linspace(0.0, 2 * pi, 181)
        circle = Curve("stable inside", np.cos(turn), np.sin(turn), "line", "quiet", (4, 3))
        return Plot("Poles and zeros", Axis("real part, z plane"), Axis("imaginary part"), [circle, *curves], "", 380,
                    equal=True)  # fmt: skip
    every = np.concatenate([np.hypot(one.x, one.y) for one in curves])
    sizes = every[every > 1e-6 * every.max(initial=0.0)]  # others are zero
    bend = float(sizes.min()) if len(sizes) and sizes.max() > _SPREAD * sizes.min() else 0.0
    scale = "asinh" if bend else "linear"
    top = max((float(np.abs(np.asarray(one.y)).max(initial=0.0)) for one in curves), default=1.0) or 1.0
    line = Curve("stable to the left", [0.0, 0.0], [-top, top], "line", "quiet", (4, 3))
    note = f"Even within {bend:.2g} 1/s, beyond it logarithmic to all sides." if bend else ""
    return Plot("Poles and zeros", Axis("real part [1/s]", scale, bend or 1.0),
                Axis("imaginary part [1/s]", scale, bend or 1.0), [line, *curves], note, 380)  # fmt: skip


def _nyquist(found: Any, shown: Any, names: Sequence[str], looks: Sequence[dict[str, Any]]) -> Plot:
    from tmodes.plot.commands import nyquist_reach

    values = [shown.sel(input=source, output=name).values for source in found.inputs for name in found.outputs]
    largest = float(np.abs(np.array(values)).max(initial=0.0))
    reach, loops = nyquist_reach(largest)
    curves = [Curve(name, one.real, one.imag, **look) for name, one, look in zip(names, values, looks, strict=True)]
    ends, point = (-reach, reach), [Curve("-1", [-1.0], [0.0], "cross", "ink")]
    return Plot("Nyquist", Axis("real part", range=ends), Axis("imaginary part", range=ends),
                [*curves[:_MOST_PAIRS], *(point if loops else [])],
                "For growing frequency, in SI units." + (" Larger values are cut." if largest > reach else ""), 380,
                equal=True)  # fmt: skip
