"""A case by itself, as :func:`tmodes.run` runs it: where conditions end runs, and for series that no loop gives."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.energy import energy_lost
from tmodes.analysis.error_parts import straight
from tmodes.analysis.quasistatic import deflections, elastic_names
from tmodes.errors import SimulationError
from tmodes.sheet import Robot
from tmodes.simulation.batch.result import COUNTS
from tmodes.simulation.motion_run import RunData
from tmodes.simulation.quantities import run_quantities
from tmodes.simulation.simulate import simulate_motion
from tmodes.simulation.stops import STOPPED, Instants
from tmodes.simulation.vary.reductions import Reduction, of_samples
from tmodes.simulation.vary.series import COMMANDED, DEVIATION, OWN
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
    at = Instants(run.times[:count], run.states[:count], run.planned.schedule.rows_at(run.times[:count]))
    known, tip = run_quantities(run.setup), run.points.position[:count, 0]
    found = {name: known[name].of(at) for name in names if name in known}
    deformed = [name.removeprefix("deformation.") for name in names if name.startswith("deformation.")]
    kinds = elastic_names(run.model)
    if deformed:
        bent = deflections(run.model, run.q[:count])
        found |= {f"deformation.{name}": bent[:, kinds.index(name)] for name in deformed if name in kinds}
    places = {OWN: own, COMMANDED: _commanded(run, count) if COMMANDED in names else None}
    if DEVIATION in names and run.reference is not None:
        places[DEVIATION] = run.reference.points.position[:, 0]
    for name, place in places.items():
        if name in names and place is not None and len(place) >= count:
            found[name] = np.linalg.norm(tip - place[:count], axis=1)
    return found


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
