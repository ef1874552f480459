"""The estimated errors of the numbers of a run's summary."""

from __future__ import annotations

from dataclasses import replace
from typing import Any, cast

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.figure_errors import Figure, at_worst, disturbed_rows, even_samples, figure_errors, rows_each
from tmodes.result.lines import load_series
from tmodes.result.series import Variables, motion_series
from tmodes.simulation.motion_run import RunData, gathered
from tmodes.simulation.parts import Trajectory
from tmodes.simulation.start import RunSetup

__all__ = ["summary_errors"]

Array = NDArray[np.float64]

_MOST = 40
"""Deformations whose error is estimated, the largest ones."""


def summary_errors(run: RunData, stations: Array, variables: Variables, names: dict[str, Any]) -> dict[str, Any]:
    """``how`` errors are estimated, and ``figures``: the error of each number by its path in the summary.

    ``tip_m`` is that of the tip's position [m], the largest of some samples over the run. The error of the reference
    counts too. ``names``: the labels along the dimensions of ``variables``. Empty where no error is known.
    """
    runs = [one for one in (run, run.reference) if one is not None]
    estimates = [one.error for one in runs if one.error and one.setup]
    if len(estimates) < len(runs):
        return {}
    rows = rows_each(estimates)
    figures = _figures(variables, names, rows)
    samples = sorted({k for figure in figures for k in figure.samples})
    disturbed = [_disturbed(one, samples, rows, turn) for turn, one in zip((0, 5), runs, strict=False)]
    both = replace(disturbed[0], reference=disturbed[1] if len(disturbed) > 1 else None)
    found = motion_series(both, len(both.times)) | load_series(both, stations, len(both.times))
    return {"how": estimates[0].how, "figures": figure_errors(figures, samples, rows, found)}


def _disturbed(run: RunData, samples: list[int], rows: int, turn: int) -> RunData:
    states = disturbed_rows(run.states, run.error, samples, rows, turn)
    times = run.times[np.repeat(samples, rows)]
    return gathered(cast("RunSetup", run.setup), Trajectory(times, states, run.status, run.message))


def _figures(variables: Variables, names: dict[str, Any], rows: int) -> list[Figure]:
    values = {name: info[1] for name, info in variables.items()}
    count = len(values["tip"])
    figures = [Figure("tip_m", even_samples(count, rows), lambda found: found["tip"][1])]
    if "deviation" in values:
        figures.append(at_worst("deviation.max_m", "deviation", values["deviation"]))
        figures.append(Figure("deviation.end_m", (count - 1,), lambda found: found["deviation"][1]))
    return [
        *figures,
        *_deformations(values, names),
        *_joints(values, names),
        *_links(values, names),
        *_contact(values, rows),
    ]


def _deformations(values: dict[str, Array], names: dict[str, Any]) -> list[Figure]:
    if "deformation" not in values:
        return []
    largest = np.argsort(-np.abs(values["deformation"]).max(axis=0), kind="stable")[:_MOST]
    info = names["deformation_kind"]
    return [at_worst(f"deformations.{info[k]}.max", "deformation", values["deformation"], int(k)) for k in largest]


def _joints(values: dict[str, Array], names: dict[str, Any]) -> list[Figure]:
    kinds = (("largest_effort", "effort"), ("largest_gear_torque", "gear_torque"))
    return [
        at_worst(f"joints.{joint}.{key}", series, values[series], k)
        for k, joint in enumerate(names.get("drive", ()))
        for key, series in kinds
    ]


def _links(values: dict[str, Array], names: dict[str, Any]) -> list[Figure]:
    figures = []
    for k, name in enumerate(names["bending_link"]):
        tip = np.linalg.norm(values["deflection"][:, k, -1], axis=-1)
        figures.append(Figure(f"links.{name}.deflection.max_m", (int(tip.argmax()),), _end_of(k)))
        bending = np.linalg.norm(values["moment"][:, k, :, 1:], axis=-1)
        sample, place = map(int, np.unravel_index(int(bending.argmax()), bending.shape))
        figures.append(Figure(f"links.{name}.bending_moment.max_Nm", (sample,), _moment_at(k, place)))
    for k, name in enumerate(names["stressed_link"]):
        stress = values["stress"][:, k]
        sample, place = map(int, np.unravel_index(int(stress.argmax()), stress.shape))
        figures.append(Figure(f"links.{name}.stress.max_Pa", (sample,), _stress_at(k, place)))
    return figures


def _end_of(link: int) -> Any:
    return lambda found: found["deflection"][1][:, link, -1]


def _moment_at(link: int, place: int) -> Any:
    return lambda found: found["moment"][1][:, link, place, 1:]


def _stress_at(link: int, place: int) -> Any:
    return lambda found: found["stress"][1][:, link, place]


def _contact(values: dict[str, Array], rows: int) -> list[Figure]:
    if "contact_force_normal" not in values:
        return []
    force = values["contact_force_normal"]
    samples = {
        "min_N": (int(force.argmin()),),
        "max_N": (int(force.argmax()),),
        "mean_N": even_samples(len(force), rows),
    }
    return [
        Figure(f"contact_force.{name}", where, lambda found: found["contact_force_normal"][1])
        for name, where in samples.items()
    ]
