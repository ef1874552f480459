"""The estimated errors of the numbers of a run's summary: each is computed again from disturbed states."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmodes.result.series import Variables, load_series, motion_series
from tmodes.simulation.motion_run import RunData, gathered
from tmodes.simulation.parts import Trajectory

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
    estimates = [one.error for one in runs if one.error]
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
    return gathered(run.setup, Trajectory(times, states, run.status, run.message))


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


_PATTERNS = 8

"""Patterns of signs with which the sizes of errors are added."""


class Figure(NamedTuple):
    """A headline figure: its path in the summary, the samples it comes from, and how it follows from all series.

    ``value`` gives (rows,) or (rows, components), whose distance counts.
    """

    name: str
    samples: tuple[int, ...]
    value: Callable[[Variables], Array]


def at_worst(name: str, series: str, values: Array, *place: int) -> Figure:
    """The largest size of one series (n, ...) at a place of it, at the sample where it is reached."""
    worst = int(np.argmax(np.abs(values[(slice(None), *place)])))
    return Figure(name, (worst,), lambda found: found[series][1][(slice(None), *place)])


def rows_each(estimates: Sequence[Any]) -> int:
    """Rows of a sample: as it is, and disturbed once by what is signed, or by eight patterns of signs.

    ``estimates``: each a :class:`tmodes.simulation.parts.ErrorEstimate`.
    """
    return 2 if all(estimate.signed for estimate in estimates) else 1 + _PATTERNS


def even_samples(count: int, rows: int) -> tuple[int, ...]:
    """Samples from the first to the last: eleven, or 101 where each takes few rows."""
    parts = 10 if rows > 2 else 100
    return tuple(sorted({round(part * (count - 1) / parts) for part in range(parts + 1)}))


def disturbed_rows(states: Array, estimate: Any, samples: Sequence[int], rows: int, turn: int) -> Array:
    """For each sample its state, then disturbed ones: ``rows`` of it, (samples rows, size).

    What is signed is added as it is; sizes are added with patterns of signs (Walsh functions of the components, begun
    at ``turn``), of which the worst will count.
    """
    kept = np.asarray(samples, dtype=int)
    info = np.repeat(states[kept], rows, axis=0).reshape(len(kept), rows, -1)
    signs = np.ones((1, 1)) if estimate.signed else _signs(states.shape[1], turn)
    info[:, 1:] += signs * estimate.values[kept][:, None]
    return info.reshape(len(kept) * rows, -1)


def _signs(size: int, turn: int) -> Array:
    patterns = range(1, _PATTERNS + 1)
    return np.array([[1.0 - 2 * ((row & (k + turn)).bit_count() % 2) for k in range(size)] for row in patterns])


def figure_errors(
    figures: Sequence[Figure], samples: Sequence[int], rows: int, variables: Variables
) -> dict[str, float]:
    """The error of each figure by its name, where it is a number.

    ``variables`` of the rows of :func:`disturbed_rows` at these samples.
    """
    info = {}
    for figure in figures:
        values = figure.value(variables).reshape(len(samples), rows, -1)
        apart = np.linalg.norm(values[:, 1:] - values[:, :1], axis=2).max(axis=1)
        info[figure.name] = float(max(apart[samples.index(k)] for k in figure.samples))
    return {name: error for name, error in info.items() if math.isfinite(error)}
