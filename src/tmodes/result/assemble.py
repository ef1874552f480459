"""What a run shows, from its trajectories: each part is computed once, when it is first asked for."""

from __future__ import annotations

import json
import platform
from collections.abc import Callable
from functools import cached_property
from importlib.metadata import version
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.energy import energy_lost
from tmodes.analysis.line.line import line_places
from tmodes.analysis.modes.of_sheet import frequencies_about, sheet_frequencies
from tmodes.analysis.quasistatic import elastic_names
from tmodes.analysis.statics.steady import steady_rates
from tmodes.errors import SimulationError
from tmodes.io.labelled import Record
from tmodes.io.sheet_plausible import implausible_numbers, reading_notices
from tmodes.result.elements import element_errors
from tmodes.result.end_modes import end_modes, with_elements
from tmodes.result.errors import summary_errors
from tmodes.result.lines import carried_series, line_series
from tmodes.result.model_errors import model_errors
from tmodes.result.record import RESULT_FORMAT, STATUSES
from tmodes.result.series import Variables, coordinates_of, motion_series, record_of
from tmodes.result.settling import BAND, AfterMove, after_move, move_end, plain_vibration
from tmodes.sheet import Robot
from tmodes.simulation.motion_run import RunData

__all__ = ["Assembly"]

Progress = Callable[[str, float], None]


class Assembly:
    """A run of a robot whose sheet as known is ``known``, and all that a result shows of it.

    The time axis is that of the actual robot, as far as its reference came too.
    """

    def __init__(self, run: RunData, known: Robot) -> None:
        self.run, self.known = run, known

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
        return energy_lost(run.energy_balance[:count], run.energy_moved, settings.energy_tolerance)

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
    def _motion(self) -> Variables:
        return motion_series(self.run, self.count)

    @cached_property
    def _lines(self) -> tuple[Variables, dict[str, list[str]], list[str]]:
        return line_series(self.run, self.stations, self.count)

    @cached_property
    def moving(self) -> tuple[Record, list[str]]:
        """What a picture that changes needs of the series, and the warnings but those of lines and frequencies."""
        carried, names, notices = carried_series(self.run, self.stations, self.count)
        labels = coordinates_of(self.run, self.count, names, self.stations)
        return record_of(self._motion | carried, labels), [*self._noticed, *notices]

    @cached_property
    def motion(self) -> Record:
        """Motion, drives, points, contact and energies, without the elastic lines."""
        return record_of(self._motion, coordinates_of(self.run, self.count, {}, self.stations))

    @cached_property
    def move_end(self) -> float | None:
        """When the last signal stops changing [s]; None where one never does."""
        return move_end(self.run.planned)

    @cached_property
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

    @cached_property
    def end_frequencies(self) -> dict[str, list[dict[str, Any]]]:
        """Modes about the pose at the end: of the ``actual`` robot as it runs, of the ``nominal`` with locked motors.

        The motors of the nominal one are at their setpoints in its run.
        """
        found = {"actual": end_modes(self.run, "controlled", "locked")}
        return found | ({"nominal": end_modes(self.run.reference, "locked")} if self.run.reference else {})

    @cached_property
    def _after(self) -> dict[str, AfterMove]:
        """The actual and the nominal run after the move, continued until their tips are at rest."""
        runs = {"actual": self.run, "nominal": self.run.reference}
        return {name: after_move(run, self.move_end) for name, run in runs.items() if run}

    @cached_property
    def settling(self) -> dict[str, Any]:
        """When the actual tip has settled to its own rest, by continuing the run."""
        return self.settled(BAND)

    def settled(self, band: float) -> dict[str, Any]:
        """The same with another band."""
        return self._after["actual"].settling(band)

    @cached_property
    def vibration(self) -> dict[str, Any]:
        """The vibration of the ``actual`` and the ``nominal`` tip after the move, by mode."""
        found = {name: plain_vibration(after.vibration()) for name, after in self._after.items()}
        return {name: with_elements(one, self.end_frequencies[name]) for name, one in found.items()}

    @cached_property
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

    @cached_property
    def errors(self) -> dict[str, Any]:
        """The estimated errors of the numbers of the summary."""
        return summary_errors(self.run, self.stations, *self.series)

    @cached_property
    def model_errors(self) -> dict[str, Any]:
        """The estimated errors of the link models in the same numbers."""
        return model_errors(self.run, self.stations, *self.series)

    @cached_property
    def warnings(self) -> list[str]:
        """What a reader must know: of the run, of the sheet, and of what its models are good for."""
        return [*self._noticed, *self._frequencies[1], *self._lines[2]]

    @cached_property
    def _noticed(self) -> list[str]:
        return [*self.run.warnings, *implausible_numbers(self.known), *reading_notices(self.known)]

    def attributes(self, progress: Progress) -> dict[str, Any]:
        """Where the record comes from, and what was computed of it, as plain data and JSON."""
        status, message = self.ending
        info = provenance(self.run, self.known) | {"status": status, "message": message}
        for name, stage in _KEPT.items():
            progress(stage, 0.0)
            info[_STORED_AS.get(name, name)] = json.dumps(getattr(self, name))
        return info

    def whole(self, progress: Progress = lambda stage, share: None) -> Record:
        """The whole record; ``progress`` receives the stages.

        Raises :class:`tmodes.errors.SimulationError` for lines that memory does not hold.
        """
        progress("lines", 0.0)
        return self.all_series.assign_attrs(self.attributes(progress))

    @cached_property
    def all_series(self) -> Record:
        """The whole record without its attributes."""
        lines, names, _ = self._lines
        return record_of(self._motion | lines, coordinates_of(self.run, self.count, names, self.stations))


_KEPT = {
    "frequencies": "modes", "end_frequencies": "modes", "settling": "settling", "vibration": "settling",
    "warnings": "checks", "errors": "integration error", "model_errors": "model error", "move_end": "checks",
    "elements": "tip error",
}  # fmt: skip
"""What is computed of a run and kept with it, and the stage that computes it."""

_STORED_AS = {"elements": "tip_error_elements"}


def ending(run: RunData) -> tuple[str, str]:
    """Status and sentence of the whole run: its own, or that of the nominal run where that ended early."""
    planned_run = run.reference
    if planned_run is not None and planned_run.status != "finished":
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
