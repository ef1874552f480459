"""The vibration of a robot: amplitude spectra of its tip and of the elastic coordinates that oscillate most."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.plot.facts import deformation_unit, largest, plain, spectral_part
from tmodes.plot.figure import Figure
from tmodes.plot.frequency_marks import amplitude_spectrum, mark_frequencies
from tmodes.plot.panels import Axes, AxesLike, letter, panels, readable
from tmodes.plot.style import COMPONENTS

__all__ = ["Spectrum"]

LEAST_SAMPLES = 32
DECADES = 4
"""What lies further below the highest line is left out of the picture."""

_MOST_COORDINATES = 3
_ROUNDING = 1e-12
"""Amplitudes below this [m, rad] are rounding."""

_NOTHING = 1e-6
"""A coordinate of the tip that oscillates less than this share of the others is not drawn."""

Array = NDArray[Any]
Curves = dict[str, tuple[Array, Array]]


class Spectrum(Figure):
    """Amplitudes of the tip [m] (minus its reference, where there is one) and of elastic coordinates [rad], log scale.

    Of the time after the move where the run continues long enough; else of the part with constant setpoint rates; else
    of the whole run. The robot's own frequencies (under control, else with locked motors) are marked. ``ax``: two axes
    (one for a rigid robot), or None.
    """

    name = "spectrum"
    title = "Vibration spectrum"
    caption = "Peaks appear at the natural frequencies (dotted), those under control where the robot is controlled."

    def missing(self, data: Any) -> str:
        """Too few samples, or no oscillation."""
        part = spectral_part(data, LEAST_SAMPLES)
        if len(part["time"]) < LEAST_SAMPLES:
            return f"a spectrum needs {LEAST_SAMPLES} samples, evenly spaced; this run has {len(data['time'])}"
        if not any(np.ptp(values, axis=0).max() > _ROUNDING for values in _signals(part)[0].values()):
            return "nothing oscillates"
        return ""

    def draw(self, result: Any, ax: AxesLike = None) -> list[Axes]:
        """The tip, and the elastic coordinates."""
        data = result.data
        part = spectral_part(data, LEAST_SAMPLES)
        tip, inner = _signals(part)
        time = part["time"].values
        step = float(time[1] - time[0])
        groups = [tip, *([inner] if inner else [])]
        spectra = [{name: amplitude_spectrum(values, step) for name, values in group.items()} for group in groups]
        axes = panels(ax, [[str(k)] for k in range(len(groups))], 1.0 + 2.1 * len(groups))
        units = ["m", deformation_unit(data, next(iter(inner)))] if inner else ["m"]
        marked, pads = _marked(result), []
        for panel, curves, unit in zip(axes, spectra, units, strict=True):
            highest = _highest(curves, 0.5 / step)
            _draw(panel, curves, unit, highest)
            panel.set_xlabel("frequency [Hz]")
            pads.append(mark_frequencies(panel, marked, highest))
        span = f"{time[0]:.3g} to {time[-1]:.3g} s"
        what = "Tip − reference" if "tip_reference" in data else "Tip"
        letter(axes, (f"{what}, {span}", f"Elastic coordinates, {span}")[: len(axes)], pad=max(pads))
        return axes


def _signals(part: Any) -> tuple[dict[str, Array], dict[str, Array]]:
    """The tip's coordinates, and the elastic coordinates that oscillate most."""
    tip = part["tip"] - part["tip_reference"] if "tip_reference" in part else part["tip"]
    letters = "Δ" if "tip_reference" in part else ""
    first = {f"{letters}{axis}": tip.sel(axis=axis).values for axis in "xyz"}
    most = max(float(np.ptp(values)) for values in first.values())
    first = {name: values for name, values in first.items() if np.ptp(values) >= _NOTHING * most}
    if "deformation_oscillatory" not in part:
        return first, {}
    names = [str(name) for name in part["deformation_kind"].values]
    turning = [name for name in names if deformation_unit(part, name) == "rad"] or names
    swings = part["deformation"].sel(deformation_kind=turning).transpose("time", "deformation_kind").values
    chosen = largest(turning, np.std(swings, axis=0), _MOST_COORDINATES)
    return first, {name: part["deformation"].sel(deformation_kind=name).values for name in chosen}


def _marked(result: Any) -> list[dict[str, Any]]:
    """The natural frequencies to mark, with names that may be wrapped at their dots."""
    modes = result.frequencies
    marked = modes.get("controlled") or modes.get("locked") or []
    return [mode | {"element": plain(mode["element"]).replace(".", ". ")} for mode in marked]


def _highest(curves: Curves, nyquist: float) -> float:
    """The end of the frequency axis [Hz]: what is above stays a thousand times below the highest peak."""
    peak, end = max(float(amplitude.max()) for _, amplitude in curves.values()), 1.0
    for frequency, amplitude in curves.values():
        seen = frequency[amplitude > 1e-3 * peak]
        end = max(end, float(seen[-1]) if len(seen) else 0.0)
    return min(1.25 * end, nyquist)


def _draw(panel: Axes, curves: Curves, si: str, highest: float) -> None:
    peak = max(float(amplitude.max()) for _, amplitude in curves.values())
    unit = readable(si, peak)
    for (name, (frequency, amplitude)), look in zip(curves.items(), COMPONENTS, strict=False):
        shown = (frequency <= highest) & (amplitude > 0)
        panel.plot(frequency[shown], unit.of(amplitude[shown]), label=plain(name), **look)
    panel.set_xlim(0, highest)
    if peak > 0:
        panel.set_yscale("log")
        panel.set_ylim(unit.factor * peak * 10**-DECADES, unit.factor * peak * 3)
    panel.set_ylabel(f"amplitude [{unit.name}]")
    panel.legend(loc="upper right", frameon=True, facecolor="white", edgecolor="none", framealpha=0.9)  # over the marks
