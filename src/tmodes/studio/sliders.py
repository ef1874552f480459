"""The sliders of the studio: those of the live report, with the places in the sheet's plain data that they move."""

from __future__ import annotations

from typing import Any

from tmodes.io.sheet_paths import steps_of
from tmodes.live.sliders import Knob, Slider, knobs_of, sliders_of
from tmodes.sheet import Robot

__all__ = ["info_sliders"]


def info_sliders(sheet: Robot, data: dict[str, Any]) -> list[dict[str, Any]]:
    """The numbers of a sheet that are dragged most, the most useful first; ``data`` is its plain data.

    A slider stands at its number, or, where it moves several ``together``, at the factor on their bases.
    """
    knobs = knobs_of(sheet)
    return [_info(slider, knobs[slider.knob], data) for slider in sliders_of(sheet, knobs)]


def _info(slider: Slider, knob: Knob, data: dict[str, Any]) -> dict[str, Any]:
    if slider.real:
        targets = [{"steps": ["real", path], "base": 1.0} for path in knob.reals]
    else:
        targets = [{"steps": list(steps_of(path, data)), "base": base} for path, base in knob.targets]
    names = ("label", "symbol", "unit", "group", "log")
    info: dict[str, Any] = {name: getattr(slider, name) for name in names}
    together = knob.together and not slider.real
    return info | {"min": slider.low, "max": slider.high, "together": together, "targets": targets}
