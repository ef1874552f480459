"""What a run shows, from its trajectories: each part is computed once, when first asked for, and may fail alone."""

from __future__ import annotations

import json
import platform
from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import cached_property, partial
from importlib.metadata import version
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.energy import energy_lost
from tmodes.analysis.headline_point import HeadlinePoint, headline_point
from tmodes.analysis.line.line import line_places
from tmodes.analysis.modes.of_sheet import frequencies_about, sheet_frequencies
from tmodes.analysis.quasistatic import elastic_names
from tmodes.analysis.statics.equilibrium import steady_rates
from tmodes.errors import SimulationError
from tmodes.integrate.conditions import Band
from tmodes.io.labelled import Record
from tmodes.io.sheet_plausible import implausible_numbers, reading_notices
from tmodes.result.derived import INTERRUPTED, NOT_YET, Derives, derived
from tmodes.result.elements import element_errors
from tmodes.result.end_modes import end_modes
from tmodes.result.errors import summary_errors
from tmodes.result.events import event_labels, event_series
from tmodes.result.headline import point_errors, seen_from
from tmodes.result.lines import carried_series, line_series
from tmodes.result.model_errors import model_errors
from tmodes.result.paths import part_names
from tmodes.result.record import RESULT_FORMAT, STATUSES
from tmodes.result.series import Variables, coordinates_of, error_series, motion_series, record_of
from tmodes.result.settling import (
    AfterMove,
    after_move,
    move_end,
    not_settled,
    plain_vibration,
    unknown_vibration,
)
from tmodes.result.vibrating import mode_elements, named_as_seen, unrest
from tmodes.sheet import Robot
from tmodes.simulation.event import Event
from tmodes.simulation.events import cut_short, events_of
from tmodes.simulation.motion_run import RunData

__all__ = ["ResultAssembly"]

Progress = Callable[[str, float], None]


def _no_progress(stage: str, share: float) -> None:
    del stage, share


class ResultAssembly(Derives):
    """A run of a robot whose sheet as known is ``known``, and all that a result shows of it.

    The time axis is that of the actual robot, as far as its reference came too. ``progress`` receives stages and shares
    of what takes long.
    """

    progress: Progress = staticmethod(_no_progress)
    _keep = False

    def __init__(self, run: RunData, known: Robot) -> None:
        self.run, self.known = run, known
        self._afters: dict[str, AfterMove] = {}

    @cached_property
    def _whole(self) -> int:
        """Samples that run and reference both have."""
        reference = self.run.reference
        return len(self.run.times) if reference is None else min(len(self.run.times), len(reference.times))

    @cached_property
    def _lost(self) -> int | None:
        """The sample at which the energy balance is lost, of a run whose sheet asks to end there."""
        run, settings, count = self.run, self.run.robot.integration, self._whole
        if not settings.energy_stop:
            return None
        return energy_lost(run.energy_balance[:count], run.energy_moved, run.energy_there, settings.energy_tolerance)

    @property
    def count(self) -> int:
        """Samples of the result."""
        return self._whole if self._lost is None else max(self._lost, 1)

    @cached_property
    def ending(self) -> tuple[str, str]:
        """Status and message."""
        if self._lost is None:
            return ending(self.run)
        return "stopped", f"the energy balance was lost at t = {self.run.times[self._lost]:.4g} s"

    @cached_property
    def stations(self) -> NDArray[np.float64]:
        """Places along each link at which its line is kept [-]."""
        return line_places(self.run.chain, self.run.robot.integration.line_points)

    @cached_property
    def _bare(self) -> Variables:
        return motion_series(self.run, self.count)

    @derived("paths", lambda self, reason: ({}, []))
    def _paths(self) -> tuple[Variables, list[str]]:
        """The tip's error by cause, and the names of the causes."""
        return _finite(error_series(self.run, self.count)), part_names(self.run)

    @property
    def _motion(self) -> Variables:
        return self._bare | self._paths[0]

    @derived("lines", lambda self, reason: ({}, {"link": [], "bending_link": [], "stressed_link": []}, []))
    def _lines(self) -> tuple[Variables, dict[str, list[str]], list[str]]:
        lines, names, notices = line_series(self.run, self.stations, self.count)
        return _finite(lines), names, notices

    def _record(
        self, variables: Variables, names: dict[str, list[str]], further: Mapping[str, Any] | None = None
    ) -> Record:
        labels = names | ({"error_part": self._paths[1]} if "tip_error" in variables else {})
        return record_of(variables, coordinates_of(self.run, self.count, labels, self.stations) | dict(further or {}))

    @cached_property
    def moving(self) -> tuple[Record, list[str]]:
        """What a picture that changes needs of the series, and the warnings but those of lines and frequencies."""
        carried, names, notices = carried_series(self.run, self.stations, self.count)
        return self._record(self._motion | carried, names), [*self._noticed, *notices]

    @cached_property
    def motion(self) -> Record:
        """Motion, drives, points, contact and energies, without the elastic lines."""
        return self._record(self._motion, {})

    @derived("move_end", lambda self, reason: None)
    def move_end(self) -> float | None:
        """When the last signal stops changing [s]; None where one never does."""
        return move_end(self.run.planned)

    @derived("frequencies", lambda self, reason: ({}, []))
    def _frequencies(self) -> tuple[dict[str, list[dict[str, Any]]], list[str]]:
        setup = self.run.setup
        try:
            if setup.rest is None or steady_rates(self.run.robot, setup.mechanics):
                return sheet_frequencies(self.run.robot), []
            return frequencies_about(self.run.robot, setup.rest), []
        except SimulationError as error:
            return {}, [f"no frequencies are computed: {error}"]

    @property
    def frequencies(self) -> dict[str, list[dict[str, Any]]]:
        """Natural frequencies about the rest or the steady motion, by the state of the motors."""
        return self._frequencies[0]

    @derived("end_frequencies", lambda self, reason: {})
    def end_frequencies(self) -> dict[str, list[dict[str, Any]]]:
        """Modes about the pose at the end: of the ``actual`` robot as it runs, of the ``nominal`` with locked motors.

        The motors of the nominal one are at their setpoints in its run. What is seen of them after the move has the
        same element there.
        """
        found = {"actual": end_modes(self.run, "controlled", "locked")}
        found |= {"nominal": end_modes(self.run.reference, "locked")} if self.run.reference else {}
        return {which: named_as_seen(modes, self.vibration[which]["modes"]) for which, modes in found.items()}

    @property
    def _ran(self) -> dict[str, RunData]:
        """The actual run, and the nominal one where there is one."""
        return {"actual": self.run} | ({"nominal": self.run.reference} if self.run.reference else {})

    @derived("headline", lambda self, reason: None)
    def headline(self) -> HeadlinePoint | None:
        """What stands for a tip that cannot show the motion; None where the tip can."""
        return headline_point(self.known, self.run.chain)

    @cached_property
    def _shown(self) -> dict[str, RunData]:
        """The runs as seen from the headline's point in the place of the tip."""
        point = self.headline and self.headline.point
        return {which: seen_from(run, point) if point else run for which, run in self._ran.items()}

    @derived("headline", lambda self, reason: None)
    def headline_errors(self) -> dict[str, Any] | None:
        """The headline's point in words, and its errors; None where it is the tip."""
        if not self.headline:
            return None
        errors = point_errors(self._shown, self.count) if self.headline.point else {"tip_error": {}, "deviation": None}
        return {"name": self.headline.name, "reason": self.headline.reason} | errors

    def _after(self, which: str) -> AfterMove:
        """One of the runs after the move, continued until its tip is at rest, as far as it may take."""
        if self.headline and not self.headline.point:
            raise SimulationError(self.headline.reason)
        if which not in self._afters:
            after = after_move(self._shown[which], self.move_end, partial(self.progress, "settling"))
            after = replace(after, whose=self.headline.name if self.headline else "the tip")
            if after.end is not None and after.end < after.times[-1] and after.settling()["time_s"] is None:
                after = replace(after, unrest=unrest(self._ran[which], *after.later()))
            self._afters[which] = after
        return self._afters[which]

    @derived("settling", lambda self, reason: not_settled(reason))
    def settling(self) -> dict[str, Any]:
        """When the actual tip has settled to its own rest, by continuing the run."""
        return self.settled(Band.parsed(self.run.robot.integration.settling_band))

    def settled(self, band: Band) -> dict[str, Any]:
        """The same with another band."""
        return self._after("actual").settling(band)

    @cached_property
    def vibration(self) -> dict[str, Any]:
        """The vibration of the ``actual`` and the ``nominal`` tip after the move, by mode."""
        return {which: self.attempt(_VIBRATIONS[which], partial(self._vibration, which), unknown_vibration)
                for which in self._ran}  # fmt: skip

    def _vibration(self, which: str) -> dict[str, Any]:
        after, run = self._after(which), self._ran[which]
        found = after.vibration()
        elements = self.attempt(_ELEMENTS[which], lambda: mode_elements(run, *after.later(), found), lambda _: [])
        return plain_vibration(found, elements, after.beyond)

    @derived("elements", lambda self, reason: {})
    def elements(self) -> dict[str, Any]:
        """What each gear and link has of the largest error of the tip."""
        return element_errors(self.run, self.count)

    @property
    def series(self) -> tuple[dict[str, NDArray[np.float64]], dict[str, list[str]]]:
        """All series by name, and the labels along their dimensions that numbers of the summary are named by.

        ``apart`` and ``off`` (n, 3) are what the tip is away from the nominal and from the commanded one [m].
        """
        lines, names, _ = self._lines
        labels = names | {"deformation_kind": list(elastic_names(self.run.model)), "drive": list(self.run.drives)}
        found = {name: info[1] for name, info in (self._motion | lines).items()}
        if "tip_nominal" in found:
            found["apart"] = found["tip"] - found["tip_nominal"]
        if "tip_commanded" in found:
            found["off"] = found["tip"] - found["tip_commanded"]
        return found, labels

    @derived("errors", lambda self, reason: {"how": "", "figures": {}, "approximate": [], "why": reason})
    def errors(self) -> dict[str, Any]:
        """The estimated errors of the numbers of the summary."""
        return summary_errors(self.run, self.stations, *self.series, partial(self.progress, "integration error"))

    @derived("model_errors", lambda self, reason: {"how": "", "figures": {}, "why": reason})
    def model_errors(self) -> dict[str, Any]:
        """The estimated errors of the link models in the same numbers."""
        series = self.series
        if why := self.failed.get("lines"):
            raise SimulationError(f"it takes the elastic lines of the links, which are not computed: {why}")
        return model_errors(self.run, self.stations, *series, partial(self.progress, "model error"))

    @cached_property
    def warnings(self) -> list[str]:
        """What a reader must know: of the run, of the sheet, and of what its models are good for."""
        short = cut_short(self.run)
        return [*self._noticed, *self._frequencies[1], *self._lines[2], *([short] if short else [])]

    @derived("checks", lambda self, reason: [*self.run.warnings])
    def _noticed(self) -> list[str]:
        own = [*self.run.warnings, *implausible_numbers(self.known), *reading_notices(self.known)]
        return [*own, *([self.headline.reason] if self.headline else [])]

    def attributes(self, progress: Progress) -> dict[str, Any]:
        """Where the record comes from, and what was computed of it, as plain data and JSON."""
        computed = {name: self._told(name, stage, progress) for name, stage in _KEPT.items()}
        return self._described(computed)

    def _described(self, computed: dict[str, Any]) -> dict[str, Any]:
        status, message = self.ending
        info = provenance(self.run, self.known) | {"status": status, "message": message}
        info |= {_STORED_AS.get(name, name): json.dumps(value) for name, value in computed.items()}
        return info | ({"not_computed": json.dumps(self.failed)} if self.failed else {})

    def _told(self, name: str, stage: str, progress: Progress) -> Any:
        """A number, after its stage was reported; where a run is kept Ctrl-C ends the computing of all further ones."""
        try:
            progress(stage, 0.0)
            return getattr(self, name)
        except KeyboardInterrupt:
            if not self._keep:
                raise
            self.stopped = INTERRUPTED
            return getattr(self, name)

    def whole(self, progress: Progress = _no_progress, *, keep: bool = False) -> Record:
        """The whole record; ``progress`` receives the stages. What cannot be computed stands in ``failed``.

        ``keep``: Ctrl-C leaves out what is not computed by then; else it raises KeyboardInterrupt.
        """
        self.progress, self._keep = progress, keep
        try:
            return self._told("all_series", "lines", progress).assign_attrs(self.attributes(progress))
        finally:
            self.progress = _no_progress

    @property
    def begun(self) -> Record:
        """The series of the motion, of which nothing is computed yet: what is stored before anything can fail."""
        empty = ResultAssembly(self.run, self.known)
        empty.stopped = NOT_YET
        computed = {name: getattr(empty, name) for name in _KEPT}
        return empty._record(self._bare, {}).assign_attrs(empty._described(computed))

    @cached_property
    def all_series(self) -> Record:
        """The whole record without its attributes."""
        lines, names, _ = self._lines
        return self._record(self._motion | lines | event_series(self.events), names, event_labels(self.events))

    @derived("events", lambda self, reason: ())
    def events(self) -> tuple[Event, ...]:
        """What happened at instants, as far as the result goes."""
        last = self.run.times[self.count - 1]
        return tuple(event for event in events_of(self.run) if event.time <= last)


_KEPT = {
    "frequencies": "modes", "end_frequencies": "modes", "settling": "settling", "vibration": "settling",
    "warnings": "checks", "errors": "integration error", "model_errors": "model error", "move_end": "checks",
    "elements": "tip error", "headline_errors": "tip error",
}  # fmt: skip
"""What is computed of a run and kept with it, and the stage that computes it."""

_VIBRATIONS = {"actual": "vibration", "nominal": "vibration.nominal"}
_ELEMENTS = {"actual": "vibration.elements", "nominal": "vibration.nominal.elements"}

_STORED_AS = {"elements": "tip_error_elements", "headline_errors": "headline"}


def _finite(variables: Variables) -> Variables:
    """The same; raises :class:`tmodes.errors.SimulationError` for numbers that are not finite."""
    for name, (_, values, _, _) in variables.items():
        if not np.isfinite(values).all():
            raise SimulationError(f"the series {name} has a number that is not finite")
    return variables


def ending(run: RunData) -> tuple[str, str]:
    """Status and sentence of the whole run: its own, or that of the nominal run where that ended first."""
    planned_run = run.reference
    if planned_run is None or planned_run.status == "finished":
        first = False
    else:  # the actual run does not begin where the nominal one was interrupted
        first = (
            run.status == "finished" or planned_run.times[-1] <= run.times[-1] or planned_run.status == "interrupted"
        )
    if planned_run is not None and first:
        return planned_run.status, f"nominal run: {planned_run.message}"
    return run.status, run.message if run.status in STATUSES[:2] else f"actual robot: {run.message}"


def provenance(run: RunData, known: Robot) -> dict[str, Any]:
    """Where the numbers come from: sheets, versions, what the integration took."""
    from tmodes.io.sheet_check import sheet_data

    packages = ("tmodes", "numpy", "llvmlite", "xarray")
    counts = {"real": run.statistics} | ({"reference": run.reference.statistics} if run.reference else {})
    return {
        "tmodes_format": RESULT_FORMAT,
        "kind": "arm",
        "title": known.title or known.name,
        "robot": json.dumps(sheet_data(known)),
        "robot_real": json.dumps(sheet_data(run.robot)),
        "method": str(run.robot.integration.method),
        "versions": json.dumps({name: version(name) for name in packages} | {"python": platform.python_version()}),
        "statistics": json.dumps(counts),
    }
