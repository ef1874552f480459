"""ArmResult: the record of an arm's run as labelled series with units, from the arrays of numbers that the run gave.

    ArmRun  --assemble_arm-->  ArmResult  ->  file, figures, report

Dimensions: ``time``, ``coordinate``, ``deformation_kind`` (``joint.gear`` and the links' coordinates), ``drive``,
``point``, ``axis`` (x, y, z), ``link`` (all that are drawn), ``bending_link``, ``stressed_link``, ``plane`` and
``moment_kind`` (in section axes), ``s`` (0 root, 1 tip), ``energy_kind``, ``work_kind``.
"""

from __future__ import annotations

import json
import os
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np

from tmodes.analysis.quasistatic import elastic_names
from tmodes.result.errors import arm_figure_errors
from tmodes.result.lines import line_series
from tmodes.result.provenance import ending, info_of, move_end, provenance
from tmodes.result.record import PaperResult, RunRecord, kind_of, read_record
from tmodes.result.series import coordinates_of, motion_series
from tmodes.simulation.motion_run import RunData

if TYPE_CHECKING:
    from xarray import Dataset

    from tmodes.sheet import Robot

__all__ = ["Result", "assemble_result", "load_result"]

Progress = Callable[[str, float], None]


@dataclass(frozen=True, eq=False)
class Result(RunRecord):
    """What a run of an arm gave: ``result.data["tip"].sel(axis="z")``, ``result.data["q"].sel(coordinate="elbow")``."""

    kind: ClassVar[str] = "arm"
    series: ClassVar[tuple[str, ...]] = (*RunRecord.series, "a", "position")

    @property
    def arm(self) -> Robot:
        """The arm that ran, as it is known, rebuilt from its data sheet and checked again."""
        from tmodes.io.sheet_check import sheet_from_data

        return sheet_from_data(self._json("robot"))

    @property
    def move_end(self) -> float | None:
        """When the last drive's signal stops changing [s]; None where it never does."""
        return self._json("move_end")

    def summary(self, band: float = 0.05) -> dict[str, Any]:
        """The numbers a reader asks first; see :func:`tmodes.result.summary.summarise_result`.

        Raises :class:`tmodes.errors.InputError` for a ``band`` that is not between 0 and 1.
        """
        from tmodes.result.summary import summarise_result

        return summarise_result(self.data, band)


def load_result(path: str | os.PathLike[str]) -> PaperResult | Result:
    """Read a result of either kind back, whole and checked.

    Raises :class:`tmodes.errors.ResultFileError` as :meth:`tmodes.result.record.RunRecord.load`.
    """
    data = read_record(path)
    return (Result if kind_of(data) == "arm" else PaperResult).of(data, path)


def assemble_result(
    run: RunData, known: Robot | None = None, *, progress: Progress = lambda stage, share: None
) -> Result:
    """Gather all that a result shows.

    ``known``: the arm as it is known, by whose sheet the run was planned; None: the one of the run. The time axis is
    the real arm's, as far as its reference came too. Raises :class:`tmodes.errors.SimulationError` for elastic lines
    that memory does not hold: sample more coarsely, or take fewer ``integration.line_points``.
    """
    import xarray as xr

    known = known or run.arm
    count = len(run.times) if run.reference is None else min(len(run.times), len(run.reference.times))
    stations = np.linspace(0.0, 1.0, run.arm.integration.line_points)
    progress("gathering", 0.0)
    lines, names, notices = line_series(run, stations, count)
    progress("gathering", 0.6)
    variables = motion_series(run, count) | lines
    data = xr.Dataset(
        {
            name: (dims, values, {"units": unit, "long_name": text})
            for name, (dims, values, unit, text) in variables.items()
        },
        coords=coordinates_of(run, count, names, stations),
    )
    info = info_of(run, known)
    labels = names | {"deformation_kind": list(elastic_names(run.model)), "drive": list(run.drives)}
    info["errors"] = arm_figure_errors(run, stations, variables, labels)
    info["warnings"] = [*run.warnings, *info["warnings"], *notices]
    status, message = ending(run)
    data, status, message = _stopped_by_energy(run, data, status, message)
    data.attrs = provenance(run, known) | {
        "status": status,
        "message": message,
        "move_end": json.dumps(move_end(run.planned)),
    }
    data.attrs |= {name: json.dumps(value) for name, value in info.items()}
    progress("gathering", 1.0)
    timing = {"real": run.seconds} | ({"reference": run.reference.seconds} if run.reference else {})
    return Result(data, timing)


def _stopped_by_energy(run: RunData, data: Dataset, status: str, message: str) -> tuple[Dataset, str, str]:
    """What is left of a run whose sheet asks to end it where its energy balance is lost."""
    from tmodes.analysis.validity import first_energy_error

    settings = run.arm.integration
    bad = first_energy_error(data, settings.energy_tolerance) if settings.energy_stop else None
    if bad is None:
        return data, status, message
    message = f"the energy balance was lost at t = {float(data['time'][bad]):.4g} s"
    return data.isel(time=slice(0, max(bad, 1))), "stopped", message
