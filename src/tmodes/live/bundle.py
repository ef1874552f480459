"""What a live report is shipped with: the robot's own equations, and all numbers that they need."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from tmodes.integrate.settings import Integration
from tmodes.live.bundle_motion import arm_bundle, why_not_arm
from tmodes.live.loads import evenly, load_places
from tmodes.live.map import LiveMap, live_map
from tmodes.live.template import sheet_template
from tmodes.paper.sheet import PaperPair
from tmodes.plot.paper.facts import steady_part
from tmodes.sheet import RobotPair

if TYPE_CHECKING:
    from tmodes.result import Result
    from tmodes.result.record import PaperResult

__all__ = ["FRAMES_PER_SECOND", "live_bundle", "why_not_live"]

FRAMES_PER_SECOND = 60
"""Frames of the picture in a second of motion, about."""

_FEW_FRAMES = 200
"""Frames of a short run, so that its vibration can be seen slowed down."""

_MOST_FRAMES = 3000
_MOST_STATIONS = 21


def why_not_live(result: PaperResult | Result) -> str:
    """Why a page cannot make this run again, in words; empty where it can."""
    if result.status != "finished":
        return f"the run did not reach its end: {result.message}"
    if "mean_step_s" not in result.statistics["real"]:
        return "its controller is a Python function"
    settings = _sheet(result).integration
    if settings.stop or settings.energy_stop or getattr(settings, "stop_at_limits", False):
        return "it ends by a condition, which is looked for natively"
    if json.loads(result.data.attrs["robot_real"])["real"]:
        return "its real robot has factors of its own"
    return why_not_arm(_sheet(result)) if result.kind == "arm" else ""


def live_bundle(result: PaperResult | Result) -> dict[str, Any] | None:
    """The bundle of a run, for :func:`tmodes.report.pack.pack`; None where :func:`why_not_live` says why."""
    if why_not_live(result):
        return None
    pair, method = _sheet(result).pair(), _method(result)
    if isinstance(pair, PaperPair):
        return {
            **_common(result, pair, live_map(pair)),
            **_of_robot(pair, method),
            "steady": list(steady_part(result.data)),
        }
    settings = pair.real.integration
    places = load_places(settings.line_points)
    stations = tuple(places[evenly(len(places), _MOST_STATIONS)].tolist())
    compared, surfaces = "tip_reference" in result.data, _with_surfaces(result)
    own = arm_bundle(pair, stations, method, compared=compared, surfaces=surfaces)
    return {**_common(result, pair, live_map(pair, stations)), **own, "stations": np.array(stations)}


def _with_surfaces(result: PaperResult | Result) -> list[str]:
    """The links whose surfaces the result keeps, in their order."""
    return list(dict.fromkeys(info["link"] for info in json.loads(result.data.attrs.get("meshes", "[]"))))


def _sheet(result: Any) -> Any:
    return result.arm if result.kind == "arm" else result.robot


def _method(result: PaperResult | Result) -> str:
    """The one that the run took; of several, one after the other, the last one."""
    return result.statistics["real"]["method"]


def _common(result: PaperResult | Result, pair: PaperPair | RobotPair, live: LiveMap) -> dict[str, Any]:
    settings = pair.real.integration
    times = np.asarray(result.data["time"].values, dtype=float)
    return {
        "kind": result.kind,
        "sliders": [slider.info() for slider in live.sliders],
        "leftOut": [{"path": path, "reason": reason} for path, reason in live.left_out.items()],
        "map": live.info(),
        "settings": _settings(settings, _method(result)) | {"note": _note(result)},
        "times": times,
        "frames": _frames(times, settings.output_step),
        "stations": np.linspace(0.0, 1.0, settings.line_points),
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


def _note(result: PaperResult | Result) -> str:
    """What is different from the native run."""
    parts = result.statistics["real"].get("parts")
    if not parts:
        return ""
    taken = ", then ".join(part["method"] for part in parts.values())
    return f"the run took {taken}; here all of it is by {_method(result)}"


def _of_robot(pair: PaperPair, method: str) -> dict[str, Any]:
    from tmodes.equations.lagrange.coordinates import deformation_basis, free_deformations
    from tmodes.live.modes_paper import robot_modes
    from tmodes.live.wasm_paper import robot_module

    module = robot_module(pair, [method])
    return {
        "module": np.frombuffer(module.wasm, dtype=np.uint8),
        "layout": module.layout,
        "contact": pair.real.contact,
        "free": free_deformations(pair.real.rigid_elements()),
        "basis": deformation_basis(),
        "lengths": [mode.length for mode in pair.real.link.modes],
        "modes": robot_modes(pair.real),
    }
