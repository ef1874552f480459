"""A page's data from results: what ``web/src/contract.ts`` calls a Page, ready for :func:`tmodes.report.pack.pack`."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import asdict
from typing import TYPE_CHECKING, Any

import numpy as np

from tmodes.errors import InputError, InputErrors, TmodesError
from tmodes.live.bundle import live_bundle, why_not_live
from tmodes.report.actual import actual
from tmodes.report.charts import charts_of
from tmodes.report.facts import Fact
from tmodes.report.mode_shapes import modes_of
from tmodes.report.run_facts import run_facts
from tmodes.report.scene import line_of, scene_of
from tmodes.report.thin import scene_frames

if TYPE_CHECKING:
    from tmodes.result import Result

__all__ = ["facts_of", "live_page", "page_data", "robot_name", "sheet_of"]


def page_data(
    results: Sequence[Result],
    names: Sequence[str] | None = None,
    live: dict[str, Any] | None = None,
    not_live: str = "",
    *,
    light: bool = False,
) -> dict[str, Any]:
    """The data of a page about one result, or several side by side.

    ``names`` tell the runs apart, None takes those of the robots; ``live`` is the bundle of the first run's equations,
    from :func:`tmodes.live.bundle.live_bundle`, None where the page shall not simulate; ``not_live`` says why, where
    it could be expected to. ``light``: without modes and sheet, for a picture that changes while somebody drags.
    """
    names = names or [robot_name(result) for result in results]
    charts = charts_of(results)
    runs = [_run(*one, light=light) for one in zip(results, names, charts, strict=True)]
    subtitle = _title(results[0]) if len(results) == 1 else f"{len(results)} runs side by side"
    info = {"title": ", ".join(names), "subtitle": subtitle, "live": live, "notLive": not_live}
    return {"format": 1, "runs": runs, **info}


def live_page(result: Result, *, live: bool = True) -> dict[str, Any]:
    """The data of a page about one result, with its equations where they are wanted and the page can run them again."""
    if not live:
        return page_data([result], not_live="it was asked to hold no equations (--no-live)")
    bundle, reason = None, "its record does not tell how it was made"
    if "real" in result.statistics:
        try:
            reason = why_not_live(result)
            bundle = None if reason else live_bundle(result)
        except (TmodesError, KeyError, ValueError) as error:  # a good run keeps its page
            reason = str(error)
    return page_data([result], live=bundle, not_live=reason)


def robot_name(result: Result) -> str:
    """The name of the robot that ran."""
    return str(json.loads(result.data.attrs["robot"]).get("name") or "robot")


def _title(result: Result) -> str:
    return str(json.loads(result.data.attrs["robot"]).get("title") or "")


def _run(result: Result, name: str, charts: list[dict[str, Any]], *, light: bool) -> dict[str, Any]:
    data = result.data
    times, missing = np.asarray(data["time"].values, dtype=float), actual(result).missing
    unknown = [f"shown by what the result holds alone, because its robot cannot be rebuilt: {missing}"]
    unknown = unknown if missing and not any(missing in one for one in result.warnings) else []
    frames = scene_frames(times, int(np.prod(data["line"].shape[1:])) if "line" in data else 0)
    return {
        "name": name,
        "status": result.status,
        "success": result.success,
        "message": result.message,
        "warnings": [*result.warnings, *unknown],
        "duration": float(times[-1]),
        "facts": [asdict(fact) for fact in facts_of(result)],
        "charts": charts,
        "scene": scene_of(result, frames),
        "line": line_of(result, frames),
        "modes": [] if light else modes_of(result),
        "sheet": "" if light else sheet_of(result),
    }


def facts_of(result: Result) -> list[Fact]:
    """The numbers that matter, most important first; none of a robot with kinds that are not known here."""
    try:
        return list(run_facts(result, result.summary()))
    except (InputError, InputErrors):
        return []


def sheet_of(result: Result) -> str:
    """The data sheet of this very run as YAML; empty where it is no longer one that this version knows."""
    from tmodes.io.sheet_write import robot_to_yaml

    try:
        return robot_to_yaml(result.robot)
    except TmodesError:
        return ""
