"""A case by itself, as :func:`tmodes.run` runs it: where conditions end runs, and for outputs that no lane gives."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.energy import energy_lost
from tmodes.analysis.error_parts import straight
from tmodes.equations.loop.outputs import COMMANDED, DEVIATION, OWN, Outputs
from tmodes.errors import SimulationError
from tmodes.sheet import Robot
from tmodes.simulation.batch.result import COUNTS
from tmodes.simulation.motion_run import RunData
from tmodes.simulation.reductions import Reduction, of_samples
from tmodes.simulation.simulate import simulate_motion
from tmodes.simulation.stops import STOPPED
from tmodes.simulation.vary.tables import setpoints

__all__ = ["Alone", "run_alone", "series_of_run"]

Array = NDArray[np.float64]


class Alone(NamedTuple):
    """What came of a case; ``values`` by reduction, not-a-number where there is none."""

    values: dict[Reduction, float]
    status: str
    message: str
    counts: dict[str, int]
    method: str


def run_alone(sheet: Robot, changes: Mapping[str, Any], reductions: Sequence[Reduction], own: Array | None) -> Alone:
    """Run one case; ``own`` (n, 3): the tip of the sheet's own run. One that cannot start has the status ``failed``."""
    nothing = dict.fromkeys(reductions, np.nan)
    try:
        run = simulate_motion(sheet.with_(changes))
    except SimulationError as error:
        return Alone(nothing, "failed", str(error), dict.fromkeys(COUNTS, 0), "")
    status, message, count = _ending(run)
    info = {name: int(run.statistics[name]) for name in COUNTS}
    if status not in ("finished", STOPPED):
        return Alone(nothing, status, message, info, str(run.statistics["method"]))
    series = series_of_run(run, count, {one.series for one in reductions}, own)
    values = {
        one: float(of_samples(one, series[one.series][None, :], run.times[:count])[0])
        if one.series in series else np.nan
        for one in reductions
    }  # fmt: skip
    return Alone(values, status, message, info, str(run.statistics["method"]))


def _ending(run: RunData) -> tuple[str, str, int]:
    """Status, message and samples; where the sheet asks for it, the run ends where its energy balance is lost."""
    settings = run.robot.integration
    if settings.energy_stop:
        lost = energy_lost(run.energy_balance, run.energy_moved, settings.energy_tolerance)
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
