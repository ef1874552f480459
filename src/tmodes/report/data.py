"""A page's data from results: what ``web/src/contract.ts`` calls a Page, ready for :func:`tmodes.report.pack.pack`."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import asdict
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from tmodes.report.arm_facts import arm_facts
from tmodes.report.charts import charts_of
from tmodes.report.facts import Fact
from tmodes.report.robot_facts import robot_facts
from tmodes.report.scene import line_of, scene_of
from tmodes.report.mode_shapes import modes_of
from tmodes.report.thin import scene_frames

if TYPE_CHECKING:
    from tmodes.arm_result import ArmResult
    from tmodes.result import Result, RunRecord

__all__ = ["facts_of", "page_data", "sheet_of"]


def page_data(
    results: Sequence[RunRecord], names: Sequence[str] | None = None, live: dict[str, Any] | None = None
) -> dict[str, Any]:
    """The data of a page about one result, or several side by side.

    ``names`` tell the runs apart, None takes those of the robots; ``live`` is the bundle of the first run's equations,
    from :func:`tmodes.live.bundle.live_bundle`, None where the page shall not simulate.
    """
    names = names or [_name(result) for result in results]
    charts = charts_of(results)
    runs = [_run(*one) for one in zip(results, names, charts, strict=True)]
    subtitle = _title(results[0]) if len(results) == 1 else f"{len(results)} runs side by side"
    return {"format": 1, "title": ", ".join(names), "subtitle": subtitle, "runs": runs, "live": live}


def _name(result: RunRecord) -> str:
    return str(json.loads(result.data.attrs["robot"]).get("name") or "robot")


def _title(result: RunRecord) -> str:
    return str(json.loads(result.data.attrs["robot"]).get("title") or "")


def _run(result: RunRecord, name: str, charts: list[dict[str, Any]]) -> dict[str, Any]:
    data = result.data
    times = np.asarray(data["time"].values, dtype=float)
    frames = scene_frames(times, int(np.prod(data["line"].shape[1:])) if "line" in data else 0)
    return {
        "name": name,
        "status": result.status,
        "success": result.success,
        "message": result.message,
        "warnings": list(result.warnings),
        "duration": float(times[-1]),
        "facts": [asdict(fact) for fact in facts_of(result)],
        "charts": charts,
        "scene": scene_of(result, frames),
        "line": line_of(result, frames),
        "modes": modes_of(result),
        "sheet": sheet_of(result),
    }


def facts_of(result: RunRecord) -> list[Fact]:
    """The numbers that matter, most important first."""
    if result.kind == "arm":
        arm = cast("ArmResult", result)
        return list(arm_facts(arm, arm.summary()))
    robot = cast("Result", result)
    return list(robot_facts(robot.data, robot.summary()))


def sheet_of(result: RunRecord) -> str:
    """The data sheet of this very run as YAML; empty where it is no longer one that this version knows."""
    from tmodes.errors import TmodesError
    from tmodes.io.arm_write import arm_to_yaml
    from tmodes.io.write import robot_to_yaml

    try:
        if result.kind == "arm":
            return arm_to_yaml(cast("ArmResult", result).arm)
        return robot_to_yaml(cast("Result", result).robot)
    except TmodesError:
        return ""
