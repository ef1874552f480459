"""What a live report contains: the robot's own equations, and all numbers that they need."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from tmodes.integrate.settings import Integration
from tmodes.live.loads import evenly, load_places
from tmodes.live.map import LiveMap, live_map
from tmodes.live.mechanics import mechanics, why_not_mechanics
from tmodes.live.template import sheet_template
from tmodes.sheet import RobotPair

if TYPE_CHECKING:
    from tmodes.result import Result

__all__ = ["FRAMES_PER_SECOND", "live_bundle", "why_not_live"]

FRAMES_PER_SECOND = 60
"""Frames of the picture in a second of motion, about."""

_FEW_FRAMES = 200
"""Frames of a short run, so that its vibration can be seen slowed down."""

_MOST_FRAMES = 3000
_MOST_STATIONS = 21


def why_not_live(result: Result) -> str:
    """Why a page cannot repeat this run, in words; empty where it can."""
    if result.status != "finished":
        return f"the run did not reach its end: {result.message}"
    if "mean_step_s" not in result.statistics["real"]:
        return "its controller is a Python function"
    settings = result.robot.integration
    if settings.stop or settings.energy_stop or settings.stop_at_limits:
        return "it ends by a condition, which is detected natively"
    if json.loads(result.data.attrs["robot_real"])["real"]:
        return "its actual robot has factors of its own"
    return why_not_mechanics(result.robot)


def live_bundle(result: Result) -> dict[str, Any] | None:
    """The bundle of a run, for :func:`tmodes.report.pack.pack`; None where :func:`why_not_live` gives a reason."""
    if why_not_live(result):
        return None
    pair, method = result.robot.pair(), result.statistics["real"]["method"]  # of several, the last one
    settings = pair.real.integration
    places = load_places(settings.line_points)
    stations = tuple(places[evenly(len(places), _MOST_STATIONS)].tolist())
    compared, surfaces = "tip_reference" in result.data, _with_surfaces(result)
    own = mechanics(pair, stations, method, compared=compared, surfaces=surfaces)
    return {**_common(result, pair, live_map(pair, stations), method), **own, "stations": np.array(stations)}


def _with_surfaces(result: Result) -> list[str]:
    """The links whose surfaces the result keeps, in their order."""
    return list(dict.fromkeys(info["link"] for info in json.loads(result.data.attrs.get("meshes", "[]"))))


def _common(result: Result, pair: RobotPair, live: LiveMap, method: str) -> dict[str, Any]:
    settings = pair.real.integration
    times = np.asarray(result.data["time"].values, dtype=float)
    return {
        "sliders": [slider.info() for slider in live.sliders],
        "leftOut": [{"path": path, "reason": reason} for path, reason in live.left_out.items()],
        "map": live.info(),
        "settings": _settings(settings, method) | {"note": _note(result, method)},
        "times": times,
        "frames": _frames(times, settings.output_step),
        "sheet": sheet_template(pair.nominal, live),
    }


def _frames(times: NDArray[np.float64], step: float) -> NDArray[np.int32]:
    """Samples that are shown in space, first and last among them."""
    rate = max(FRAMES_PER_SECOND, _FEW_FRAMES / max(float(times[-1]), 1e-9))
    every = max(1, round(1 / (rate * step)), -(-len(times) // _MOST_FRAMES))
    return np.unique(np.append(np.arange(0, len(times), every), len(times) - 1)).astype(np.int32)


def _settings(given: Integration, method: str) -> dict[str, Any]:
    chosen = given.chosen(method)
    return {
        "method": method, "duration": chosen.duration, "step": chosen.step, "maxSteps": chosen.max_steps,
        "relativeTolerance": chosen.relative_tolerance, "absoluteTolerance": chosen.absolute_tolerance,
    }  # fmt: skip


def _note(result: Result, method: str) -> str:
    """How the page's run differs from the native one."""
    parts = result.statistics["real"].get("parts")
    if not parts:
        return ""
    taken = ", then ".join(part["method"] for part in parts.values())
    return f"the run took {taken}; here all of it is by {method}"
