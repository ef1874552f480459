"""The mechanics in a live bundle: the compiled module, and the structure of its numbers."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.line.line import elastic_line
from tmodes.analysis.quasistatic import deflections, elastic_names
from tmodes.live.functions import ModelFunctions, live_module
from tmodes.live.loads import joint_limits, lines_info, load_places, yield_strengths
from tmodes.live.numbers import follow_of
from tmodes.live.vibrations import vibrations_info
from tmodes.model.model import Model
from tmodes.result.lines import without_elasticity
from tmodes.sheet import Robot, RobotPair
from tmodes.simulation.loop import LoopModel
from tmodes.simulation.plan import Follow, planned, starts_at_rest
from tmodes.simulation.start import RunSetup, run_setup

__all__ = ["mechanics", "why_not_mechanics"]

Array = NDArray[np.float64]


def why_not_mechanics(arm: Robot) -> str:
    """Why a page cannot run this robot, in words; empty where it can."""
    return "" if arm.base_motion is None else "its base moves"


def mechanics(
    pair: RobotPair, stations: tuple[float, ...], method: str, *, compared: bool, surfaces: Sequence[str] = ()
) -> dict[str, Any]:
    """All of it. Arrays are in SI units, coordinates in their order.

    ``compared``: whether there is a reference run; ``surfaces``: links that have one, shown though they be a point.
    """
    functions = ModelFunctions(pair, stations, tuple(load_places(pair.real.integration.line_points)))
    module = live_module(functions, [method], slopes=False)
    runs = {"real": run_setup(pair.real)}
    if compared:
        runs = {"reference": run_setup(pair.nominal, follow_of(pair.nominal, "reference"))} | runs
    real = runs["real"]
    model = Model(real.planned.chain)
    return {
        "module": np.frombuffer(module.wasm, dtype=np.uint8),
        "layout": module.layout,
        "runs": {name: _run(regime) for name, regime in runs.items()},
        "restSize": LoopModel(planned(pair.real, Follow.HELD).plan).layout.size,
        "atRest": starts_at_rest(pair.real),
        "base": model.at_rest(gravity=0.0),
        "gravity": np.asarray(model.chain.gravity, dtype=float),
        "deflections": _affine(lambda q: deflections(model, q), model.nq),
        "deformations": list(elastic_names(model)),
        "turning": [axis.name for axis in model.chain.axes if not axis.coordinate.slides],
        "straight": _affine(lambda q: without_elasticity(model, q), model.nq),
        "links": _links(model, surfaces),
        "carried": _carried(pair, real, functions),
        "surface": pair.real.contact and pair.real.contact.shape.drawing(),
        "contactPoint": -1 if real.planned.plan.touch is None else real.planned.plan.touch.point,
        "electric": any(n.joint.motor and n.joint.motor.resistance is not None for n in model.chain.nodes),
        "setpoints": [k for k, drive in enumerate(real.planned.plan.drives) if drive.joint in _positioned(pair)],
        **vibrations_info(pair.real, real.planned.plan, model),
    }


def _positioned(pair: RobotPair) -> set[str]:
    """The joints whose drives have a position as their signal."""
    return {drive.joint for drive in pair.real.drives if drive.command in ("position", "prescribed")}


def _run(regime: RunSetup) -> dict[str, Any]:
    """Where its state holds what, how it starts, what its sheet says of that, and drives that follow exactly."""
    layout, names = regime.model.layout, regime.model.coordinates
    info, plan = regime.arm.initial, regime.planned.plan
    return {
        "state": {name: [part.start, part.stop] for name, part in layout._asdict().items()},
        "start": regime.start,
        "info": [names.index(name) for name in info.coordinates],
        "exact": [
            [driver.coordinate, driver.plan.signal] for driver in regime.model.loop.drivers if driver.plan.servo is None
        ],
        "signals": len(regime.planned.each),
        "moving": [k for k in range(len(regime.planned.each)) if k not in plan.aside],
    }


def _affine(function: Any, size: int) -> dict[str, Array]:
    """Matrix and constant of an affine function of coordinates."""
    info = function(np.concatenate([np.zeros((1, size)), np.eye(size)]))
    return {"matrix": np.ascontiguousarray((info[1:] - info[0]).T), "constant": info[0].copy()}


def _carried(pair: RobotPair, real: RunSetup, functions: ModelFunctions) -> dict[str, Any]:
    """Where loads along the links are found; which of their places are shown; what they are compared with."""
    plan, parts, places = real.planned.plan, real.model.loop.parts, np.array(functions.places)
    assert functions.lines is not None  # noqa: S101
    lines = lines_info(functions.lines, plan.chain)
    return {
        "places": places,
        "kept": pair.real.integration.line_points,
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
