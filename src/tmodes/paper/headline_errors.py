"""The estimated error of the headline figures of a run of the 2010 robot."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.figure_errors import Figure, at_worst, disturbed_rows, even_samples, figure_errors, rows_each
from tmodes.paper.assemble import series_of
from tmodes.paper.regime import PaperRun
from tmodes.result.record import PaperResult

__all__ = ["with_headline_errors"]


def with_headline_errors(result: PaperResult, reference: PaperRun, real: PaperRun) -> PaperResult:
    """The result with the error of each headline figure, where both of its runs tell theirs.

    Kept as JSON: ``how`` the runs tell, and ``figures``, the error of each by its path in the summary; ``tip_m`` is
    that of the tip's position [m], the largest of some samples over the run. The error of the reference counts too.
    """
    estimates = [estimate for regime in (real, reference) if (estimate := regime.trajectory.error)]
    if len(estimates) < 2:
        return result
    rows = rows_each(estimates)
    figures = _figures(result, rows)
    samples = sorted({k for figure in figures for k in figure.samples})
    disturbed = [_disturbed(regime, samples, rows, turn) for turn, regime in ((0, real), (5, reference))]
    variables = series_of(disturbed[0], disturbed[1], len(samples) * rows)
    info = {"how": estimates[0].how, "figures": figure_errors(figures, samples, rows, variables)}
    result.data.attrs["errors"] = json.dumps(info)
    return result


def _figures(result: PaperResult, rows: int) -> list[Figure]:
    data = result.data
    values = {str(name): variable.values for name, variable in data.data_vars.items()}
    count = data.sizes["time"]
    moment = np.unravel_index(np.argmax(np.abs(values["bending_moment"])), values["bending_moment"].shape)
    figures = [
        at_worst("deviation.max_m", "deviation", values["deviation"]),
        Figure("deviation.end_m", (count - 1,), lambda found: found["deviation"][1]),
        Figure("tip_m", even_samples(count, rows), lambda found: found["tip"][1]),
        at_worst("largest_bending_moment.value_Nm", "bending_moment", values["bending_moment"], *map(int, moment[1:])),
        at_worst("gear_torque.max_Nm", "gear_torque", values["gear_torque"]),
    ]
    for place, name in enumerate(map(str, data["deformation_kind"].values)):
        figures.append(at_worst(f"deformations.{name}.max_rad", "deformation", values["deformation"], place))
    return figures + _contact(values, count, rows)


def _contact(values: dict[str, NDArray[np.float64]], count: int, rows: int) -> list[Figure]:
    if "contact_force_radial" not in values:
        return []
    force = values["contact_force_radial"]
    samples = {"min_N": (int(force.argmin()),), "max_N": (int(force.argmax()),), "mean_N": even_samples(count, rows)}
    return [
        Figure(f"contact_force_radial.{name}", where, lambda found: found["contact_force_radial"][1])
        for name, where in samples.items()
    ]


def _disturbed(regime: PaperRun, samples: list[int], rows: int, turn: int) -> PaperRun:
    run = regime.trajectory
    states, each = disturbed_rows(run.states, run.error, samples, rows, turn), np.repeat(np.array(samples), rows)
    return replace(regime, rows=regime.rows[each], trajectory=replace(run, times=run.times[each], states=states))
