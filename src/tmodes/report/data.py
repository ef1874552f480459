"""A page's data from results: what ``web/src/contract.ts`` calls a Page; modes as motions of the robot's lines."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import asdict
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.modes.modes import VibrationMode
from tmodes.analysis.spectrum import MotorState
from tmodes.errors import SimulationError, TmodesError
from tmodes.live.bundle import live_bundle, why_not_live
from tmodes.live.knobs import Ahead
from tmodes.live.map import Progress
from tmodes.plot.style import colours
from tmodes.report.charts import charts_of
from tmodes.report.differences import difference_tables, run_names
from tmodes.report.events import events_of
from tmodes.report.facts import Fact, run_facts
from tmodes.report.scene import frames_of, line_of, lines_at, scene_of
from tmodes.report.scene_parts import actual
from tmodes.result import Result
from tmodes.result.derived import Derives, sentences
from tmodes.result.early import LATER
from tmodes.result.verdict import PHRASES, unjudged

__all__ = ["early_facts", "facts_of", "live_page", "modes_of", "page_data", "robot_name", "sheet_of", "verdict_of"]


def page_data(
    results: Sequence[Result],
    names: Sequence[str] | None = None,
    live: dict[str, Any] | None = None,
    not_live: str = "",
    *,
    light: bool = False,
) -> dict[str, Any]:
    """The data of a page about one result, or several side by side.

    ``names`` tell the runs apart, None takes what differs, or the robots' names; ``live`` is the bundle of the first
    run's equations, from :func:`tmodes.live.bundle.live_bundle`, None where the page shall not simulate; ``not_live``
    says why, where it could be expected to. ``light``: without modes and sheet, for a picture that changes while
    somebody drags; of an early result (:func:`tmodes.result.early.early_result`) without the numbers it lacks.
    """
    names = names or run_names(results)
    made = [Derives() for _ in results]
    charts = charts_of(results, made)
    runs = [_run(*one, light=light) for one in zip(results, names, charts, made, strict=True)]
    own = {robot_name(result) for result in results}
    same = len(results) > 1 and len(own) == 1
    subtitle = _title(results[0]) if len(own) == 1 else f"{len(results)} runs"
    title = f"{min(own)}: {len(results)} runs compared" if same else ", ".join(names)
    own_words = {"phrases": PHRASES, "colours": colours()}
    info = {"title": title, "subtitle": subtitle, "live": live, "notLive": not_live} | own_words
    return {"format": 1, "runs": runs, "differences": difference_tables(results, runs), **info}


def live_page(
    result: Result,
    *,
    live: bool = True,
    ahead: Ahead | None = None,
    progress: Progress = lambda stage, share: None,
) -> dict[str, Any]:
    """The data of a page about one result, with its equations where they are wanted and the page can run them again.

    ``ahead``: numbers whose sliders come first.
    """
    if not live:
        return page_data([result], not_live="it was asked to hold no equations (--no-live)")
    bundle, reason = None, "its record does not tell how it was made"
    if "real" in result.statistics:
        try:
            reason = why_not_live(result)
            bundle = None if reason else live_bundle(result, ahead, progress)
        except (TmodesError, KeyError, ValueError) as error:  # a good run keeps its page
            reason = str(error)
    return page_data([result], live=bundle, not_live=reason)


def robot_name(result: Result) -> str:
    """The name of the robot that ran."""
    return str(json.loads(result.record.attrs["robot"]).get("name") or "robot")


def _title(result: Result) -> str:
    return str(json.loads(result.record.attrs["robot"]).get("title") or "")


def _run(result: Result, name: str, charts: list[dict[str, Any]], made: Derives, *, light: bool) -> dict[str, Any]:
    """One run; what ``made`` cannot compute is left out, and stands among the warnings."""
    data = result.record
    times, missing = np.asarray(data["time"].values, dtype=float), actual(result).missing
    unknown = [f"shown by what the result holds alone, because its robot cannot be rebuilt: {missing}"]
    unknown = unknown if missing and not any(missing in one for one in result.warnings) else []
    facts = early_facts(result, made) if light else facts_of(result, made)
    frames = frames_of(result)
    parts = {
        "verdict": verdict_of(result, made),
        "events": made.attempt("events", lambda: events_of(result, facts), lambda _: []),
        "line": made.attempt("elastic line", lambda: line_of(result, frames), lambda _: None),
        "modes": made.attempt("modes", lambda: [] if light else modes_of(result), lambda _: []),
        "sheet": "" if light else sheet_of(result),
    }
    return parts | {
        "name": name,
        "status": result.status,
        "success": result.success,
        "message": result.message,
        "warnings": [*result.warnings, *unknown, *sentences(made.failed)],
        "duration": float(times[-1]),
        "facts": [asdict(fact) for fact in facts],
        "charts": charts,
        "scene": scene_of(result, frames),
    }


def verdict_of(result: Result, made: Derives | None = None) -> dict[str, Any]:
    """What the run comes to; of an early result without what it does not know. ``made`` notes where that fails."""
    return (made or Derives()).attempt("verdict", lambda: result.verdict, lambda _: unjudged(result.message))


def facts_of(result: Result, made: Derives | None = None) -> list[Fact]:
    """The numbers that matter, most important first; ``made`` notes which could not be computed."""
    return run_facts(result, result.summary(), made)


def early_facts(result: Result, made: Derives | None = None) -> list[Fact]:
    """Those of an early result, without the numbers that it does not know."""
    return [fact for fact in facts_of(result, made) if not fact.id.startswith(LATER)]


def sheet_of(result: Result) -> str:
    """The data sheet of this very run as YAML; empty where it is no longer one that this version knows."""
    from tmodes.io.sheet_write import robot_to_yaml

    try:
        return robot_to_yaml(result.robot)
    except TmodesError:
        return ""


Array = NDArray[np.float64]
Lines = Callable[[Array], Array]
"""Coordinates (n, nq) to the lines of all links (n, L, S, 3) [m]."""

Shaped = tuple[VibrationMode, NDArray[np.complex128]]

_CASES = (MotorState.CONTROLLED, MotorState.LOCKED, MotorState.FREE)

_MOST = 8
"""Modes that are shown of each case, the lowest."""

_STATIONS = 21

_STEP = 1e-5
"""Change of the largest coordinate [rad] by which a line's motion is found: central differences, good to 1e-9."""


def modes_of(result: Result) -> list[dict[str, Any]]:
    """The lowest modes of the actual robot about its rest or steady motion, for each state of its motors; or none.

    Frequencies [Hz] and damping are those of ``result.frequencies``; motions without vibration are left out.
    Displacements (L, S, 3) are complex, the largest of size 1.
    """
    if actual(result).missing:
        return []
    try:
        return _modes(result)
    except SimulationError:
        return []


def _modes(result: Result) -> list[dict[str, Any]]:
    from tmodes.analysis.modes.closed_loop import feedback_of
    from tmodes.analysis.modes.modes import modes_about
    from tmodes.analysis.modes.of_sheet import servos_of
    from tmodes.analysis.statics.at_rest import robot_rest

    known = actual(result)
    robot = known.robot
    rest = robot_rest(robot, model=known.model, contact=robot.contact is not None, moving=True)
    servos, feedback = servos_of(robot, rest.model), feedback_of(robot, rest)
    stations, found = np.linspace(0, 1, _STATIONS), []
    for state in _CASES[0 if servos else 1 :]:
        modes = [(mode, mode.motion) for mode in modes_about(rest, state, servos, feedback) if mode.motion is not None]
        found += list(_lowest(str(state), modes, rest.q, lambda q: lines_at(rest.model, known.names, q, stations)[0]))
    return found


def _lowest(case: str, modes: Iterable[Shaped], rest: Array, lines: Lines) -> Iterator[dict[str, Any]]:
    """The lowest of ``modes`` that vibrate, as the page takes them."""
    vibrating = [(mode, motion) for mode, motion in modes if mode.frequency_Hz > 0]
    for mode, motion in vibrating[:_MOST]:
        moved = _displacement(lines, rest, motion)
        yield {
            "case": case,
            "frequency": mode.frequency_Hz,
            "damping": mode.damping_ratio,
            "element": mode.element,
            "rest": lines(rest[None])[0].astype(np.float32),
            "real": moved.real.astype(np.float32),
            "imaginary": moved.imag.astype(np.float32),
        }


def _displacement(lines: Lines, rest: Array, motion: NDArray[np.complex128]) -> NDArray[np.complex128]:
    """Displacement of the lines (L, S, 3) for a unit of the motion (nq,), the largest of size 1 and phase 0."""
    size = np.abs(motion).max()
    parts = np.stack([motion.real, motion.imag]) / size
    ends = lines(np.concatenate([rest + _STEP * parts, rest - _STEP * parts]))
    real, imaginary = (ends[:2] - ends[2:]) / (2 * _STEP)
    moved = real + 1j * imaginary
    lengths = np.linalg.norm(moved, axis=-1)
    largest = np.unravel_index(int(lengths.argmax()), lengths.shape) if lengths.size else ()
    if not lengths.size or lengths[largest] == 0:
        return moved
    lead = moved[largest][np.abs(moved[largest]).argmax()]
    return moved / lengths[largest] * (np.abs(lead) / lead)
