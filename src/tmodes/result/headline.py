"""A run as it is seen from another point than its tip, and the errors of that point."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from tmodes.chain.chain import Point
from tmodes.model.model import Model
from tmodes.result.paths import part_names
from tmodes.result.series import error_series, record_of
from tmodes.result.summary import largest_deviation, tip_errors
from tmodes.simulation.motion_run import RunData

__all__ = ["point_errors", "seen_from"]


def seen_from(run: RunData, point: Point) -> RunData:
    """The same run whose only named point is this one; its reference too. Of accelerations this is not so."""
    setup = replace(run.setup, mechanics=Model(replace(run.chain, points=(point,)), trials=True))
    reference = run.reference and seen_from(run.reference, point)
    return replace(run, setup=setup, points=setup.mechanics.points(run.q, run.v, base=run.base), reference=reference)


def point_errors(runs: Mapping[str, RunData], count: int) -> dict[str, Any]:
    """What :func:`tmodes.result.summary.tip_errors` and the deviation are of the point of the ``actual`` run."""
    run = runs["actual"]
    names, series = part_names(run), error_series(run, count)
    labels = {"time": ("time", run.times[:count], {}), "error_part": ("error_part", names, {})} if names else {}
    deviation = None
    if run.reference:
        apart = run.points.position[:count, 0] - run.reference.points.position[:count, 0]
        deviation = largest_deviation(np.linalg.norm(apart, axis=1), run.times[:count])
    return {"tip_error": tip_errors(record_of(series, labels)), "deviation": deviation}
