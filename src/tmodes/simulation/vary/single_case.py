"""A single case, run as by :func:`tmodes.run`: where conditions end runs, and for outputs that no lane gives."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.energy import energy_lost
from tmodes.analysis.error_parts import straight
from tmodes.equations.loop.outputs import COMMANDED, DEVIATION, OWN, Outputs
from tmodes.errors import SimulationError
from tmodes.sheet import Robot
from tmodes.simulation.case_results import CaseResults
from tmodes.simulation.motion_run import RunData
from tmodes.simulation.reductions import Reduction, of_samples
from tmodes.simulation.simulate import simulate_motion
from tmodes.simulation.stops import STOPPED
from tmodes.simulation.vary.tables import setpoints

__all__ = ["series_of_run", "single_case"]

Array = NDArray[np.float64]


def single_case(
    sheet: Robot, changes: Mapping[str, Any], reductions: Sequence[Reduction], own: Array | None
) -> CaseResults:
    """Run one case; ``own`` (n, 3): the tip of the sheet's own run. One that cannot start has the status ``failed``."""
    found = CaseResults.of_all(1)
    for one in reductions:
        found.value(one)
    try:
        run = simulate_motion(sheet.with_(changes))
    except SimulationError as error:
        found.put({0: str(error)}, "failed")
        return found
    status, message, count = _ending(run)
    found.end(0, replace(run, status=status, message=message))
    if status in ("finished", STOPPED):
        series, times = series_of_run(run, count, {one.series for one in reductions}, own), run.times[:count]
        for one in reductions:
            if one.series in series:
                found.values[one][:] = of_samples(one, series[one.series][None, :], times)
    return found


def _ending(run: RunData) -> tuple[str, str, int]:
    """Status, message and samples; where the sheet asks for it, the run ends where its energy balance is lost."""
    settings = run.robot.integration
    if settings.energy_stop:
        lost = energy_lost(run.energy_balance, run.energy_moved, run.energy_there, settings.energy_tolerance)
        if lost is not None:
            return "stopped", f"the energy balance was lost at t = {run.times[lost]:.4g} s", max(lost, 1)
    return run.status, run.message, len(run.times)


def series_of_run(run: RunData, count: int, names: set[str], own: Array | None) -> dict[str, Array]:
    """The series (count,) of a run that it has, by their names."""
    heads = {name.partition(".")[0] for name in names}
    places = {OWN: own, COMMANDED: _commanded(run, count) if COMMANDED in heads else None}
    places[DEVIATION] = run.reference.points.position[:, 0] if run.reference else None
    given = {
        name: place[:count]
        for name, place in places.items()
        if name in heads and place is not None and len(place) >= count
    }
    known, times = Outputs(run.setup.model.loop, tuple(given)), run.times[:count]
    wanted = {name: known[name] for name in names if name in known}
    table = np.concatenate([np.zeros((count, 0)), *given.values()], axis=1)
    rows = run.planned.schedule.rows_at(times)
    found = run.setup.model.seen([*wanted.values()], times, run.states[:count], rows, table)
    return dict(zip(wanted, found.T, strict=True))


def _commanded(run: RunData, count: int) -> Array | None:
    """The tip (n, 3) [m] of the undeformed nominal robot at the setpoints; None where there are none."""
    planned = run.reference or run
    known = setpoints(run.setup)
    if known is None:
        return None
    shape, signals = planned.q[:count].copy(), run.planned.signals.at(run.times[:count])
    for coordinate, signal in known.items():
        shape[:, planned.coordinates.index(run.coordinates[coordinate])] = signals[:, signal]
    moved = straight(planned.model, shape)
    return planned.model.points(moved, base=planned.base[:count]).position[:, 0]
