"""The estimated errors of the numbers of a run's summary: each is computed again from disturbed states."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
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

_PATTERNS = 8
"""Patterns of signs with which the sizes of errors are added."""

_WINDOW, _WINDOW_SAMPLES = 0.03, 8
"""The window about an instant, to each side: as a share of the run, and samples in it."""


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
    figures = [figure.widened(len(run.times), rows) for figure in _figures(variables, names, rows)]
    samples = sorted({k for figure in figures for k in figure.samples})
    disturbed = [_disturbed(one, samples, rows, turn) for turn, one in zip((0, 5), runs, strict=False)]
    both = replace(disturbed[0], reference=disturbed[1] if len(disturbed) > 1 else None)
    found = motion_series(both, len(both.times)) | load_series(both, stations, len(both.times))
    return {"how": estimates[0].how, "figures": figure_errors(figures, samples, rows, found)}


def _disturbed(run: RunData, samples: list[int], rows: int, turn: int) -> RunData:
    states = disturbed_rows(run.states, run.error, samples, rows, turn)
    times = run.times[np.repeat(samples, rows)]
    return gathered(run.setup, Trajectory(times, states, run.status, run.message))


class Figure(NamedTuple):
    """A number of the summary: its path there, the samples that it comes from, its series and the place in it.

    The place leaves (rows,) or (rows, components) of the series, whose distance counts.
    """

    name: str
    samples: tuple[int, ...]
    series: str
    place: tuple[Any, ...] = ()

    def value(self, found: Variables) -> Array:
        """What it follows from, in other series."""
        return found[self.series][1][(slice(None), *self.place)]

    def widened(self, count: int, rows: int) -> Figure:
        """The same of a window of time about its sample of ``count``: an error that oscillates is zero at instants.

        Where each sample takes many rows, sizes were summed up, which do not oscillate.
        """
        if len(self.samples) != 1 or rows > 2:
            return self
        near = range(-_WINDOW_SAMPLES, _WINDOW_SAMPLES + 1)
        apart = {self.samples[0] + round(k * _WINDOW * count / _WINDOW_SAMPLES) for k in near}
        return self._replace(samples=tuple(sorted(k for k in apart if 0 <= k < count)))


def _figures(variables: Variables, names: dict[str, Any], rows: int) -> list[Figure]:
    values = {name: info[1] for name, info in variables.items()}
    count = len(values["tip"])
    figures = [Figure("tip_m", even_samples(count, rows), "tip")]
    if "deviation" in values:
        figures.append(at_worst("deviation.max_m", "deviation", values["deviation"]))
        figures.append(Figure("deviation.end_m", (count - 1,), "deviation"))
    if "tip_error" in values:  # the commanded tip is exact
        worst = int(np.linalg.norm(values["tip_error"].sum(axis=1), axis=1).argmax())
        figures.append(Figure("tip_error.commanded.max_m", (worst,), "tip"))
    if "deformation" in values:
        size = np.abs(values["deformation"]).max(axis=0)
        for k in map(int, np.argsort(-size, kind="stable")[:_MOST]):
            name = f"deformations.{names['deformation_kind'][k]}.max"
            figures.append(at_worst(name, "deformation", values["deformation"], k))
    for k, joint in enumerate(names.get("drive", ())):
        for key, series in (("largest_effort", "effort"), ("largest_gear_torque", "gear_torque")):
            figures.append(at_worst(f"joints.{joint}.{key}", series, values[series], k))
    return [*figures, *_links(values, names), *_contact(values, rows)]


def _links(values: dict[str, Array], names: dict[str, Any]) -> Iterator[Figure]:
    for k, name in enumerate(names["bending_link"]):
        tip = np.linalg.norm(values["deflection"][:, k, -1], axis=-1)
        yield Figure(f"links.{name}.deflection.max_m", (int(tip.argmax()),), "deflection", (k, -1))
        sample, s = _largest(np.linalg.norm(values["moment"][:, k, :, 1:], axis=-1))
        yield Figure(f"links.{name}.bending_moment.max_Nm", (sample,), "moment", (k, s, slice(1, None)))
    for k, name in enumerate(names["stressed_link"]):
        sample, s = _largest(values["stress"][:, k])
        yield Figure(f"links.{name}.stress.max_Pa", (sample,), "stress", (k, s))


def _largest(values: Array) -> tuple[int, int]:
    """Sample and place of the largest of values (n, S)."""
    sample, place = np.unravel_index(int(values.argmax()), values.shape)
    return int(sample), int(place)


def _contact(values: dict[str, Array], rows: int) -> Iterator[Figure]:
    series = "contact_force_normal"
    if series in values:
        force = values[series]
        yield Figure("contact_force.min_N", (int(force.argmin()),), series)
        yield Figure("contact_force.max_N", (int(force.argmax()),), series)
        yield Figure("contact_force.mean_N", even_samples(len(force), rows), series)


def at_worst(name: str, series: str, values: Array, *place: int) -> Figure:
    """The largest size of one series (n, ...) at a place of it, at the sample where it is reached."""
    return Figure(name, (int(np.argmax(np.abs(values[(slice(None), *place)]))),), series, place)


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
