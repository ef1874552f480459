"""How the tip moves over the cases of a study: percentiles over time, of some cases that are run once more."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.errors import TmodesError
from tmodes.simulation.vary.families import Spans
from tmodes.simulation.vary.simulate import prepared, run_prepared
from tmodes.study.mapping import Group, groups_of
from tmodes.study.rows import Rows
from tmodes.study.study import Study

__all__ = ["SHARES", "tip_bands"]

Array = NDArray[np.float64]

SHARES = (5, 25, 50, 75, 95)
"""Percentiles that are drawn."""

_CASES, _MOST_TIMES, _MOST_NUMBERS = 240, 400, 25_000_000
"""Cases that are run again, instants that are drawn, numbers of their samples at most."""

_SECONDS, _PART, _ROUGH = 20.0, 0.1, 60
"""Processor time [s] that they may take, or this part of that of the study; cases that are run anyway."""

_FEWEST, _LITTLE = 20, 0.2
"""Cases without which there are no percentiles; spread over the largest below which an axis is left out."""


def tip_bands(study: Study, rows: Rows, progress: Callable[[str, float], None]) -> list[dict[str, Any]]:
    """The coordinates of the tip less those of the sheet's own run [mm], where they differ most.

    None of a study that simulates nothing, or whose cases cannot be run side by side.
    """
    needs = study.needs
    if study.robot is None or not (needs.reductions or needs.result) or rows.good.sum() < _FEWEST:
        return []
    try:
        group = _largest(study, rows)
        return [] if group is None else _bands(group, study.spans.get(group.kind), progress)
    except TmodesError:  # a batch takes no stop conditions, and all of it must fit into memory
        return []


def _largest(study: Study, rows: Rows) -> Group | None:
    """Some good cases, evenly taken, of the robot that most of them share."""
    good = np.flatnonzero(rows.good)
    spent = rows.seconds[good]
    affordable = max(_ROUGH, int(max(_SECONDS, _PART * spent.sum()) / max(float(spent.mean()), 1e-9)))
    chosen = good[np.linspace(0, len(good) - 1, min(_CASES, affordable, len(good))).astype(int)]
    values = np.column_stack([given[chosen] for given in rows.parameters.values()])
    assert study.robot is not None  # noqa: S101
    groups = [one for one in groups_of(study.robot, study.names, study.targets, study.choices, values) if one.vary]
    found = max(groups, key=lambda one: len(one.places), default=None)
    return found if found is not None and len(found.places) >= _FEWEST else None


def _bands(group: Group, spans: Spans | None, progress: Callable[[str, float], None]) -> list[dict[str, Any]]:
    robot = group.robot
    assert robot is not None  # noqa: S101
    samples = robot.integration.duration / robot.integration.output_step
    count = max(_FEWEST, min(len(group.places), int(_MOST_NUMBERS / (samples * 40))))
    own = run_prepared(prepared(robot, None), tips=True, threads=1)

    def tell(stage: str, share: float) -> None:
        progress("motions", share if stage == "running" else 1.0)

    vary = {path: values[:count] for path, values in group.vary.items()}
    some = run_prepared(prepared(robot, vary, spans=spans), tips=True, progress=tell)
    if some.tips is None or own.tips is None or some.finished.sum() < _FEWEST or not own.finished.all():
        return []
    kept = np.unique(np.linspace(0, len(some.times) - 1, _MOST_TIMES).astype(int))
    apart = 1e3 * (some.tips[some.finished][:, kept] - own.tips[:, kept])
    percentiles = np.percentile(apart, SHARES, axis=0)
    spread = np.ptp(percentiles, axis=0).max(axis=0)
    return [
        {
            "title": f"Tip {'xyz'[axis]} less that of the sheet's own run",
            "label": f"Δ{'xyz'[axis]} of the tip",
            "unit": "mm",
            "times": some.times[kept],
            "shares": list(SHARES),
            "values": np.ascontiguousarray(percentiles[..., axis]).astype(np.float32),
            "nominal": None,
            "cases": int(some.finished.sum()),
        }
        for axis in np.argsort(-spread).tolist()
        if spread[axis] > _LITTLE * spread.max()
    ]
