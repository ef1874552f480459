"""The estimated integration error of each number of a run's summary, from a second run with finer steps."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.quasistatic import deflections
from tmodes.analysis.worst import worst_place
from tmodes.integrate.registry import integrator
from tmodes.result.lines import load_series
from tmodes.result.paths import error_parts
from tmodes.simulation.initial_state import RunSetup
from tmodes.simulation.motion_run import RunData, gathered
from tmodes.simulation.parts import Trajectory
from tmodes.simulation.step_refinement import refined_run

__all__ = ["SummaryNumber", "distances", "even_samples", "sampled", "summary_errors", "summary_figures"]

Array = NDArray[np.float64]

_MOST = 40
"""Deformations whose error is estimated, the largest ones."""

_WINDOW, _WINDOW_SAMPLES = 0.03, 8
"""The window about an instant, to each side: as a share of the run, and samples in it."""

_EVEN = 400
"""Parts into which samples divide a whole run."""

_EVENTS = ("contact_changes", "switches")
"""What statistics count of a run where its equations change."""

_OF_LINES = {"deflection", "moment", "stress"}
"""Series that follow from elastic lines."""

SAFETY = 5.0
"""Factor on the estimate with which it is a bound: calibrated in docs/errors.md, by tools/errors_doc.py."""

_CLEAR = 0.01
"""Share of a number's size beyond which its bound is none: the error no longer adds up as small ones do."""

_ROUNDING = 1e-11
"""Share of the size of a number, or of those whose difference it is, that rounding alone may make of its error.

Of a stiff arm that hardly moves 7e-12 were seen after 3,000 steps.
"""

_DIFFERENCE_OF = {"apart": "tip", "off": "tip"}

_DENSE = 10
"""Changes of contact or friction beyond which some may be missed by both runs."""


class SummaryNumber(NamedTuple):
    """A number of the summary: its path there, the sample that it comes from, its series and the place in it.

    The place leaves (n,) or (n, components) of the series, whose size counts. ``sample`` None: it is of the whole run,
    a mean where ``mean``, else a largest value.
    """

    name: str
    sample: int | None
    series: str
    place: tuple[Any, ...] = ()
    mean: bool = False

    def values(self, found: Mapping[str, Array]) -> Array:
        """What it follows from, (n, components)."""
        values = found[self.series][(slice(None), *self.place)]
        return values.reshape(len(values), -1)

    def size(self, found: Mapping[str, Array]) -> float:
        """The largest of it over the run."""
        return float(np.linalg.norm(self.values(found), axis=1).max())

    def samples(self, count: int) -> list[int]:
        """Samples of ``count`` at which its error is looked at: an error that oscillates is zero at instants."""
        if self.sample is None:
            return even_samples(count)
        near = range(-_WINDOW_SAMPLES, _WINDOW_SAMPLES + 1)
        apart = {self.sample + round(k * _WINDOW * count / _WINDOW_SAMPLES) for k in near}
        return sorted(k for k in apart if 0 <= k < count)


def summary_errors(
    run: RunData, stations: Array, first: Mapping[str, Array], names: Mapping[str, list[str]],
    progress: Callable[[float], None] = lambda share: None,
) -> dict[str, Any]:  # fmt: skip
    """``how`` errors are estimated, and ``figures``: the error of each number by its path in the summary.

    ``approximate``: which of them are estimates, where the others are bounds. ``tip_m`` is that of the tip's position
    [m], the largest of some samples over the run. The error of the nominal run counts too. ``first``: the series of the
    run, whose dimensions have labels ``names``. Empty where it is not known. ``progress`` is given the share of each
    run that is done. Raises KeyboardInterrupt where it is interrupted.
    """
    if not run.robot.integration.error_estimate:
        return {}
    runs = [one for one in (run, run.reference) if one is not None]
    again = [refined_run(one.setup, one, progress) for one in runs]
    seconds = [one for one in again if one is not None]
    if len(seconds) < len(runs):
        return {}
    share = run.setup.robot.integration.refined()[1]
    figures = [*summary_figures(first, names)]
    pairs = [*zip(runs, seconds, strict=True)]
    sizes = {
        one.name: near
        for one, near, _ in distances(
            figures, first, lambda at: [sampled(one.setup, two, at) for one, two in pairs], stations
        )
    }
    found = {one.name: share * float(sizes[one.name].mean() if one.mean else sizes[one.name].max()) for one in figures}
    clear = all(_alike(*pair) for pair in pairs)
    info: dict[str, Any] = {"how": "a second run with finer steps", "figures": {}, "approximate": []}
    for figure in figures:
        error, size = found[figure.name], figure.size(first)
        whole = figure._replace(series=_DIFFERENCE_OF.get(figure.series, figure.series)).size(first)
        bound = max(SAFETY * error, _ROUNDING * whole) if error else 0.0
        if not math.isfinite(error):
            continue
        if not clear or bound > _CLEAR * size:
            info["approximate"].append(figure.name)
            bound = error
        info["figures"][figure.name] = bound
    return info


def sampled(setup: RunSetup, trajectory: Trajectory, samples: Sequence[int]) -> RunData:
    """All that a trajectory shows at some samples."""
    kept = list(samples)
    return gathered(setup, replace(trajectory, times=trajectory.times[kept], states=trajectory.states[kept]))


def _alike(run: RunData, second: Trajectory) -> bool:
    """Whether both runs have the same changes of contact and friction, and few; at fixed step, whether there are none.

    The error of a fixed step in which something changes goes with where in the step it does, not with a power of it.
    Where control reads rounded sensors, both runs may take a step of their values that an exact one does not take.
    """
    if run.setup.robot.control and any(one.resolution for one in run.setup.robot.sensors):
        return False
    first, other = ([one.statistics.get(name, 0) for name in _EVENTS] for one in (run, second))
    adaptive = integrator(run.setup.robot.integration.method).adaptive
    touching = np.zeros(1) if run.contact_normal is None else np.sign(run.contact_normal)
    return first == other and (sum(first) <= _DENSE if adaptive else not (any(first) or np.ptp(touching)))


def _series(runs: list[RunData], stations: Array, *, lines: bool) -> dict[str, Array]:
    """The series of figures, those that follow from ``lines`` or the others; ``runs``: actual, and nominal if any."""
    run = runs[0]
    if lines:
        return {name: info[1] for name, info in load_series(run, stations, len(run.times)).items()}
    tips = [one.points.position[:, 0] for one in runs]
    parts = error_parts(replace(run, reference=runs[1] if len(runs) > 1 else None), len(run.times))
    found: dict[str, Array | None] = {
        "tip": tips[0], "apart": tips[0] - tips[-1], "off": parts and parts.to_commanded.sum(axis=1),
        "effort": run.effort,
        "deformation": deflections(run.model, run.q), "gear_torque": run.gear_torque,
        "contact_force_normal": run.contact_normal,
    }  # fmt: skip
    return {name: values for name, values in found.items() if values is not None}


def distances(
    figures: Sequence[SummaryNumber],
    first: Mapping[str, Array],
    second: Callable[[list[int]], list[RunData]],
    stations: Array,
    ever: Sequence[int] = (),
) -> Iterator[tuple[SummaryNumber, Array, Array]]:
    """How far two runs are apart in each figure, at the samples that it is looked at, and at those of ``ever``.

    ``first``: the series of one, whole; ``second`` gives the other one at some samples, with its nominal run if any.
    """
    for lines in (False, True):
        group = [figure for figure in figures if (figure.series in _OF_LINES) == lines]
        places = [figure.samples(len(first["tip"])) for figure in group]
        samples = sorted({*ever, *(k for place in places for k in place)} if group else ())
        found = _series(second(samples), stations, lines=lines) if group else {}
        for figure, place in zip(group, places, strict=True):
            both = (
                figure.values(first)[k] - figure.values(found)[np.searchsorted(samples, k)] for k in (place, [*ever])
            )
            near, other = (np.linalg.norm(difference, axis=1) for difference in both)
            yield figure, near, other


def even_samples(count: int, parts: int = _EVEN) -> list[int]:
    """Samples of ``count`` that divide a run into equal parts."""
    return sorted({round(part * (count - 1) / parts) for part in range(parts + 1)})


def summary_figures(values: Mapping[str, Array], names: Mapping[str, list[str]]) -> Iterator[SummaryNumber]:
    """The numbers of the summary whose error is estimated, from the series of a run."""
    yield SummaryNumber("tip_m", None, "tip")
    if "apart" in values:
        yield SummaryNumber("deviation.max_m", worst_place(np.linalg.norm(values["apart"], axis=1))[0], "apart")
        yield SummaryNumber("deviation.end_m", len(values["apart"]) - 1, "apart")
    if "off" in values:  # joints without a setpoint are in the commanded tip as they move
        yield SummaryNumber("tip_error.commanded.max_m", worst_place(np.linalg.norm(values["off"], axis=1))[0], "off")
    if "deformation" in values:
        size = np.abs(values["deformation"]).max(axis=0)
        for k in map(int, np.argsort(-size, kind="stable")[:_MOST]):
            name = f"deformations.{names['deformation_kind'][k]}.max"
            yield _at_worst(name, "deformation", values["deformation"], k)
    for k, joint in enumerate(names.get("drive", ())):
        for key, series in (("largest_effort", "effort"), ("largest_gear_torque", "gear_torque")):
            yield _at_worst(f"joints.{joint}.{key}", series, values[series], k)
    yield from _links(values, names)
    if (series := "contact_force_normal") in values:
        yield SummaryNumber("contact_force.min_N", int(values[series].argmin()), series)
        yield SummaryNumber("contact_force.max_N", int(values[series].argmax()), series)
        yield SummaryNumber("contact_force.mean_N", None, series, mean=True)


def _links(values: Mapping[str, Array], names: Mapping[str, list[str]]) -> Iterator[SummaryNumber]:
    for k, name in enumerate(names["bending_link"]):
        tip = np.linalg.norm(values["deflection"][:, k, -1], axis=-1)
        yield SummaryNumber(f"links.{name}.deflection.max_m", worst_place(tip)[0], "deflection", (k, -1))
        sample, s = worst_place(np.linalg.norm(values["moment"][:, k, :, 1:], axis=-1))
        yield SummaryNumber(f"links.{name}.bending_moment.max_Nm", sample, "moment", (k, s, slice(1, None)))
    for k, name in enumerate(names["stressed_link"]):
        sample, s = worst_place(values["stress"][:, k])
        yield SummaryNumber(f"links.{name}.stress.max_Pa", sample, "stress", (k, s))


def _at_worst(name: str, series: str, values: Array, *place: int) -> SummaryNumber:
    """The largest size of one series (n, ...) at a place of it, at the sample where it is reached."""
    return SummaryNumber(name, worst_place(values[(slice(None), *place)])[0], series, place)
