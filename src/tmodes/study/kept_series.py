"""Quantities from motions that were kept: series of states and of the tip, reduced without simulating again."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from tmodes.io.units import number
from tmodes.simulation.outputs import robot_outputs
from tmodes.simulation.reductions import Reduction, of_samples
from tmodes.study.quantities import Asked
from tmodes.study.rows import Kept, Rows

if TYPE_CHECKING:
    from tmodes.study.study import Study

__all__ = ["from_motions", "in_motions", "series_of"]

Array = NDArray[np.float64]

_TIP = ("tip.x", "tip.y", "tip.z")


def series_of(motion: Kept) -> dict[str, Array]:
    """The series (n,) that a motion holds, by the names of :class:`tmodes.equations.loop.outputs.Outputs`."""
    found: dict[str, Array] = dict(zip(_TIP, motion.tip.T, strict=True))
    for k, name in enumerate(motion.names):
        found |= {f"{name}.position": motion.states[:, k], f"{name}.velocity": motion.states[:, len(motion.names) + k]}
    return found


def in_motions(study: Study, missing: Collection[str], motion: Kept) -> list[str]:
    """Those of the missing quantities that follow from motions such as this one alone."""
    known, found = series_of(motion), []
    for name in missing:
        needs = study.sheet.quantities[name].needs()
        other = needs.static or needs.result or needs.names
        if needs.reductions and not other and all(series in known for series, _ in needs.reductions):
            found.append(name)
    return found


def from_motions(study: Study, rows: Rows, motions: Mapping[int, Kept], names: Collection[str]) -> Rows:
    """Rows of these quantities, from the motions of all cases that ended well. Nothing is simulated."""
    assert study.robot is not None  # noqa: S101
    outputs = robot_outputs(study.robot)
    found: dict[str, Array] = {}
    units: dict[str, str] = {}
    for name in names:
        own = study.sheet.quantities[name]
        pairs = {pair: Reduction(*pair) for pair in own.needs().reductions}
        numbers = {pair: np.full(len(rows), np.nan) for pair in pairs}
        for k in np.flatnonzero(rows.good).tolist():
            motion = motions[int(rows.case[k])]
            series = series_of(motion)
            for pair, one in pairs.items():
                numbers[pair][k] = of_samples(one, series[one.series][None, :], motion.times)[0]
        asked = Asked(
            reductions=numbers, units={pair: one.unit_of(outputs[one.series].unit) for pair, one in pairs.items()}
        )
        given = own.own_unit(asked)
        units[name] = own.unit or given
        factor = 1.0 if units[name] == given else number(f"1 {given}", units[name])
        found[name] = own.values(asked)[0] * factor
    nothing = np.zeros(len(rows))
    return Rows(rows.case, rows.parameters, found, units, rows.status, rows.reason, [""] * len(rows), nothing)
