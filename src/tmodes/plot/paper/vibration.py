"""Vibration within vibration: the amplitude spectrum of the horizontal angles and of the root's acceleration."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from tmodes.errors import InputError
from tmodes.plot.frequency_marks import mark_frequencies
from tmodes.plot.panels import AxesLike, letter, panels, shared_legend
from tmodes.plot.paper.facts import move_duration, steady_part
from tmodes.plot.style import COMPONENTS, house_style
from tmodes.plot.units import readable

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from tmodes.result.record import PaperResult

__all__ = ["amplitude_spectrum", "no_spectrum", "spectrum"]

LEAST_SAMPLES = 32
DECADES = 5
"""What lies further below the highest line is left out of the picture."""

Array = NDArray[Any]


def amplitude_spectrum(values: Array, step: float, padding: int = 8) -> tuple[Array, Array]:
    """Frequencies [Hz] and amplitudes [unit of ``values``] of evenly sampled ``values``, ``step`` [s] apart.

    The straight line of least squares is taken off, then a Hann window; a sine of amplitude A between two lines of
    the grid shows a peak of A. ``padding`` makes the grid finer (it does not sharpen the lines).
    """
    count = len(values)
    line = np.polynomial.Polynomial.fit(np.arange(count), values, 1)(np.arange(count))
    window = np.hanning(count + 1)[:-1]
    amplitude = 2 * np.abs(np.fft.rfft((values - line) * window, padding * count)) / window.sum()
    return np.fft.rfftfreq(padding * count, step), amplitude


def no_spectrum(data: Any, bounds: tuple[float, float] | None = None) -> str:
    """Why there is no spectrum; empty when there is."""
    bounds = bounds or steady_part(data)
    count = len(_plateau(data, bounds)["time"])
    if count >= LEAST_SAMPLES:
        return ""
    share = f"{100 * bounds[0]:g} % and {100 * bounds[1]:g} % of the move"
    return f"a spectrum needs {LEAST_SAMPLES} samples between {share}; this run has {count}"


@house_style()
def spectrum(
    result: PaperResult, ax: AxesLike = None, *, bounds: tuple[float, float] | None = None, highest: float = 60.0
) -> list[Axes]:
    """Amplitudes of the horizontal bending angles [rad] and of q'' [rad/s^2] over the frequency [Hz], log scale.

    ``bounds``: the part of the move that is looked at, as shares of its duration, None for where the reference keeps
    its speed; ``highest``: end of the frequency
    axis [Hz], at most the Nyquist frequency. The controlled robot's own frequencies are marked. ``ax``: two axes.
    Raises :class:`tmodes.errors.InputError` when the part holds too few samples.
    """
    if reason := no_spectrum(result.data, bounds):
        raise InputError("spectrum", reason, "a longer run", "simulate further, or widen `bounds`")
    axes = panels(ax, [["angles"], ["acceleration"]], 5.0)
    part = _plateau(result.data, bounds or steady_part(result.data))
    step = float(part["time"][1] - part["time"][0])
    highest = min(highest, 0.5 / step)
    angles = {name: part["deformation"].sel(deformation_kind=name).values for name in ("th11q", "th12d")}
    acceleration = np.gradient(part["v"].sel(coordinate="q").values, step)
    labels = {"th11q": r"$\vartheta_{1,1q}$, mode 1", "th12d": r"$\vartheta_{1,2\delta}$, mode 2"}
    _lines(axes[0], {labels[name]: values for name, values in angles.items()}, step, highest, "rad")
    _lines(axes[1], {r"$\ddot q$": acceleration}, step, highest, "rad/s^2")
    shared_legend(axes[0])
    span = f"{float(part['time'][0]):g} to {float(part['time'][-1]):g} s"
    axes[1].set_xlabel("frequency [Hz]")
    modes = json.loads(result.data.attrs["frequencies"]).get("controlled", [])
    pad = max(mark_frequencies(panel, modes, highest) for panel in axes)
    letter(axes, (f"Horizontal bending angles, {span}", f"Acceleration of mode 1's azimuth, {span}"), pad=pad)
    return axes


def _plateau(data: Any, bounds: tuple[float, float]) -> Any:
    duration, time = move_duration(data), data["time"].values
    slack = 1e-9 * duration
    inside = (time >= bounds[0] * duration - slack) & (time <= bounds[1] * duration + slack)
    return data.isel(time=np.flatnonzero(inside))


def _lines(panel: Axes, curves: dict[str, Array], step: float, highest: float, unit_name: str) -> None:
    spectra = {label: amplitude_spectrum(values, step) for label, values in curves.items()}
    peak = max(float(amplitude.max()) for _, amplitude in spectra.values())
    unit = readable(unit_name, peak)
    for (label, (frequency, amplitude)), look in zip(spectra.items(), COMPONENTS, strict=False):
        shown = (frequency <= highest) & (amplitude > 0)
        panel.plot(frequency[shown], unit.of(amplitude[shown]), label=label, **look)
    panel.set_xlim(0, highest)
    if peak > 0:
        panel.set_yscale("log")
        panel.set_ylim(unit.factor * peak * 10**-DECADES, unit.factor * peak * 3)
    of_one = f" of {next(iter(spectra))}" if len(spectra) == 1 else ""
    panel.set_ylabel(f"amplitude{of_one} [{unit.name}]")
