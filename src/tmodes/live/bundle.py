"""What a live report contains: the robot's own equations, and all numbers that they need."""

from __future__ import annotations

import json
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.error_parts import element_places
from tmodes.analysis.line.line import elastic_line, line_places
from tmodes.analysis.quasistatic import elastic_names
from tmodes.integrate.choice import EXPLICIT, STIFF, otherwise
from tmodes.integrate.implicit import EXTRAPOLATION
from tmodes.integrate.registry import AUTO, integrator
from tmodes.live.functions import ModelFunctions, engine_settings, live_module
from tmodes.live.knobs import Ahead
from tmodes.live.map import LiveMap, Progress, live_map, origin
from tmodes.live.numbers import follow_of
from tmodes.live.places import (
    after_rules,
    evenly,
    joint_limits,
    lines_info,
    load_places,
    vibrations_info,
    yield_strengths,
)
from tmodes.live.template import sheet_template
from tmodes.model.model import Model
from tmodes.result import Result
from tmodes.result.end_modes import held_at
from tmodes.result.settling import continuing
from tmodes.result.verdict import PHRASES
from tmodes.sheet import Robot, RobotPair
from tmodes.simulation.balance import frozen
from tmodes.simulation.closed_start import uncontrolled
from tmodes.simulation.initial_state import RunSetup, closed_balance, first_state, run_setup
from tmodes.simulation.loop import LoopModel
from tmodes.simulation.plan import Follow, planned, starts_at_rest

__all__ = ["live_bundle", "why_not_live"]

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
    if json.loads(result.record.attrs["robot_real"])["real"]:
        return "its actual robot has factors of its own"
    return why_not_mechanics(result.robot)


def live_bundle(
    result: Result, ahead: Ahead | None = None, progress: Progress = lambda stage, share: None
) -> dict[str, Any] | None:
    """The bundle of a run, for :func:`tmodes.report.pack.pack`; None where :func:`why_not_live` gives a reason.

    ``ahead``: numbers whose sliders come first.
    """
    if why_not_live(result):
        return None
    pair, method = result.robot.pair(), result.statistics["real"]["method"]  # of several, the last one
    settings = pair.real.integration
    places = load_places(pair.real.chain(), settings.line_points)
    stations = tuple(places[evenly(len(places), _MOST_STATIONS)].tolist())
    compared, surfaces = "tip_nominal" in result.record, _with_surfaces(result)
    place = dict(zip(map(str, result.record["coordinate"].values), result.record["q"].values[-1].tolist(), strict=True))
    ended = held_at(pair.real, float(result.record["time"].values[-1]), place)
    own = mechanics(pair, ended, stations, method, compared=compared, surfaces=surfaces)
    live = live_map(pair, stations, ahead, progress)
    task, by_tip = pair.nominal.task, json.loads(result.record.attrs.get("headline", "null")) is None
    own["judged"] = {
        "phrases": PHRASES["sentence" if by_tip else "elsewhere"], "tolerance": task and task.tolerance,
        "energy": settings.energy_tolerance, "warned": bool(result.warnings),
    }  # fmt: skip
    own["after"] = after_rules(pair.real, method) if by_tip else None
    own["errorParts"] = [*map(str, result.record["error_part"].values)] if "tip_error" in result.record else None
    return {**_common(result, pair, live, method), **own, "stations": np.array(stations)}


def _with_surfaces(result: Result) -> list[str]:
    """The links whose surfaces the result keeps, in their order."""
    return list(dict.fromkeys(info["link"] for info in json.loads(result.record.attrs.get("meshes", "[]"))))


def _common(result: Result, pair: RobotPair, live: LiveMap, method: str) -> dict[str, Any]:
    settings = pair.real.integration
    times = np.asarray(result.record["time"].values, dtype=float)
    return {
        "sliders": [slider.info() for slider in live.sliders],
        "leftOut": _left_out(live),
        "map": live.info(),
        "settings": engine_settings(settings.chosen(method)) | {"method": method, "note": _note(result, method)},
        "times": times,
        "origin": origin(result.robot.name),
        "frames": _frames(times, settings.output_step),
        "sheet": sheet_template(pair.nominal, live),
    }


def _left_out(live: LiveMap) -> list[dict[str, str]]:
    """Paths without a slider by reason: what is structure, what changes nothing."""
    reasons: dict[str, list[str]] = {}
    for path, reason in live.left_out.items():
        reasons.setdefault(reason, []).append(path)
    return [{"path": ", ".join(paths), "reason": reason} for reason, paths in reasons.items()]


def _frames(times: NDArray[np.float64], step: float) -> NDArray[np.int32]:
    """Samples that are shown in space, first and last among them."""
    rate = max(FRAMES_PER_SECOND, _FEW_FRAMES / max(float(times[-1]), 1e-9))
    every = max(1, round(1 / (rate * step)), -(-len(times) // _MOST_FRAMES))
    return np.unique(np.append(np.arange(0, len(times), every), len(times) - 1)).astype(np.int32)


def _note(result: Result, method: str) -> str:
    """How the page's run differs from the native one."""
    parts = result.statistics["real"].get("parts")
    if not parts:
        return ""
    taken = ", then ".join(part["method"] for part in parts.values())
    return f"the run took {taken}; here all of it is by {method}"


Array = NDArray[np.float64]


def why_not_mechanics(robot: Robot) -> str:
    """Why a page cannot run this robot, in words; empty where it can."""
    return "" if robot.base_motion is None else "its base moves"


def mechanics(
    pair: RobotPair,
    ended: Robot,
    stations: tuple[float, ...],
    method: str,
    *,
    compared: bool,
    surfaces: Sequence[str] = (),
) -> dict[str, Any]:
    """All of it. Arrays are in SI units, coordinates in their order.

    ``ended``: the actual robot held where its run ends; ``compared``: whether there is a nominal run;
    ``surfaces``: links that have one, shown though they be a point.
    """
    functions = ModelFunctions(pair, stations, tuple(load_places(pair.real.chain(), pair.real.integration.line_points)))
    module = live_module(functions, sorted({method, continuing(method)}), slopes=False)
    runs = {"real": run_setup(pair.real)}
    if compared:
        runs = {"reference": run_setup(pair.nominal, follow_of(pair.nominal, "reference"))} | runs
    real = runs["real"]
    model = Model(real.planned.chain)
    return {
        "module": np.frombuffer(module.wasm, dtype=np.uint8),
        "layout": module.layout,
        "runs": {name: _run(setup) for name, setup in runs.items()},
        "restSize": LoopModel(planned(pair.real, Follow.HELD).plan).layout.size,
        "atRest": starts_at_rest(pair.real),
        "deformations": list(elastic_names(model)),
        "turning": [axis.name for axis in model.chain.axes if not axis.coordinate.slides],
        "bends": model.deformations.tolist(),
        "elements": [{"cause": part, "name": name, "own": own} for part, name, own in element_places(model)],
        "links": _links(model, surfaces),
        "carried": _carried(pair, real, functions),
        "surface": pair.real.contact and pair.real.contact.shape.drawing(),
        "contactPoint": -1 if real.planned.plan.touch is None else real.planned.plan.touch.point,
        "choice": _choice(real),
        "electric": any(n.joint.motor and n.joint.motor.resistance is not None for n in model.chain.nodes),
        "setpoints": [k for k, drive in enumerate(real.planned.plan.drives) if drive.joint in _positioned(pair)],
        **vibrations_info(pair.real, ended, real.planned.plan, model),
    }


def _choice(real: RunSetup) -> dict[str, Any]:
    """How a native run of the robot chooses its method, for a page that has one alone."""
    given = real.robot.integration
    later = otherwise(given, EXPLICIT, real.implicit)
    return {
        "auto": given.method == AUTO, "explicit": EXPLICIT, "implicit": later and later.method, "most": STIFF,
        "reach": integrator(EXPLICIT).reach, "noisy": [EXTRAPOLATION.name],
    }  # fmt: skip


def _positioned(pair: RobotPair) -> set[str]:
    """The joints whose drives have a position as their signal."""
    return {drive.joint for drive in pair.real.drives if drive.command in ("position", "prescribed")}


def _run(setup: RunSetup) -> dict[str, Any]:
    """Where its state holds what, how it starts, what its sheet says of that, and drives that follow exactly."""
    layout, names, drivers = setup.model.layout, setup.model.coordinates, setup.model.loop.drivers
    motion = {drive.joint for drive in setup.robot.drives if drive.command.is_motion}
    info, plan = setup.robot.initial, setup.planned.plan
    return {
        "state": {name: [part.start, part.stop] for name, part in layout._asdict().items()},
        "start": first_state(setup.robot, setup.planned, setup.model, setup.rest),
        "info": [names.index(name) for name in info.coordinates],
        "exact": [[one.coordinate, one.plan.signal] for one in drivers if one.plan.servo is None],
        "commanded": [[one.coordinate, one.plan.wanted] for one in drivers if one.plan.joint in motion],
        "driven": [one.coordinate for one in drivers],
        "commands": [[one.plan.joint, one.plan.signal] for one in drivers if one.plan.joint in motion],
        "signals": len(setup.planned.each),
        "balance": _balance(setup),
        "held": [layout.controls.start + k for k, held in enumerate(plan.held_controls) if held],
        "sampledCommands": setup.model.loop.held_commands,
        "samples": plan.first_samples if plan.first_samples > 1 else 0,
        "late": [late for _, late in plan.clocks if late >= 0],
        "moving": [k for k in range(len(setup.planned.each)) if k not in plan.aside],
        "noise": setup.planned.noises,
        "clocks": [[k, one.period, one.after] for k, one in setup.planned.clocks],
        "slipping": len(setup.model.loop.slipping),
    }  # fmt: skip


def _balance(setup: RunSetup) -> dict[str, Any] | None:
    """By which function of a run, and of which numbers of the state, its start in balance is found; None for no other.

    ``places``: pairs of where the states of that function and those of the run hold the same.
    """
    balance = closed_balance(setup)
    if balance is None or (setup.off and uncontrolled(setup.model)):
        return None
    row = frozen(setup.model, setup.first_row[None])
    tangent = balance.tangent(balance.at_rest(setup.start[None]), row, balance.loop.numbers)
    counts = tangent.counts
    return {
        "function": "rate" if balance.loop is setup.model else "settles",
        "size": balance.loop.layout.size,
        "places": np.stack(balance.places, axis=1).tolist(),
        "unknown": balance.unknown[counts].tolist(),
        "equations": balance.equations[counts].tolist(),
        "weighs": tangent.weighs[counts],
        "noise": setup.planned.noises,
    }


def _carried(pair: RobotPair, real: RunSetup, functions: ModelFunctions) -> dict[str, Any]:
    """Where loads along the links are found; which of their places are shown; what they are compared with."""
    plan, parts, places = real.planned.plan, real.model.loop.parts, np.array(functions.places)
    assert functions.lines is not None  # noqa: S101
    lines = lines_info(functions.lines, plan.chain)
    return {
        "places": places,
        "kept": len(line_places(plan.chain, pair.real.integration.line_points)),
        "shown": np.searchsorted(places, np.array(functions.stations) - 1e-12).astype(np.int32),
        "lines": lines,
        "strengths": yield_strengths(pair.nominal, (line["name"] for line in lines)),
        "limits": joint_limits(pair.nominal, plan, parts),
    }


def _links(model: Model, surfaces: Sequence[str]) -> list[dict[str, Any]]:
    """Lines that are drawn, by name, and whether they bend.

    After them the rigid links without length that have a surface, in the order of ``surfaces``, as the page's own scene
    has them.
    """
    lines = elastic_line(model, np.zeros(model.nq), stations=[0.0, 1.0]).links
    drawn = [{"name": name, "bends": line.shape is not None} for name, line in lines.items() if not line.is_point]
    carriers = {name for name, line in lines.items() if line.is_point and line.shape is None}
    return drawn + [{"name": name, "bends": False} for name in surfaces if name in carriers]
