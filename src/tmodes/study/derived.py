"""Quantities that follow from stored ones: formulas, and series of kept motions."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from tmodes.io.units import number
from tmodes.simulation.outputs import robot_outputs
from tmodes.simulation.reductions import Reduction, of_samples
from tmodes.study.quantities import Asked, Quantity
from tmodes.study.rows import GOOD, Kept, Rows
from tmodes.study.space import ordered

if TYPE_CHECKING:
    from tmodes.study.study import Study

__all__ = ["derivable", "derived", "from_motions", "in_motions", "is_formula", "series_of"]


Array = NDArray[np.float64]


def is_formula(quantity: Quantity) -> bool:
    """Whether a quantity follows from parameters and other quantities alone."""
    needs = quantity.needs()
    return not (needs.reductions or needs.static or needs.result)


def derivable(study: Study, missing: Collection[str]) -> list[str]:
    """Those of the missing quantities that follow from what is stored, in the order in which they do."""
    quantities = study.sheet.quantities
    absent, found = set(missing), list[str]()
    for name in ordered({name: one.needs().names for name, one in quantities.items()}):
        if name in absent and is_formula(quantities[name]) and not absent.intersection(quantities[name].needs().names):
            found.append(name)
            absent.discard(name)
    return found


def derived(study: Study, rows: Rows, names: Collection[str]) -> Rows:
    """Rows of these formulas alone, from ``rows`` that hold all that they need; a case without one has its reason."""
    known: dict[str, Array] = {**rows.parameters, **rows.quantities}
    status, reason = list(rows.status), list(rows.reason)
    found: dict[str, Array] = {}
    units: dict[str, str] = {}
    for name in names:
        own = study.sheet.quantities[name]
        asked = Asked(values={each: known[each] for each in own.needs().names} or {"": np.full(len(rows), np.nan)})
        values, reasons = own.values(asked)
        found[name] = known[name] = np.where(rows.good, values, np.nan)
        units[name] = own.unit or own.own_unit(asked)
        _fail(status, reason, {k: f"{name}: {why}" for k, why in reasons.items()})
    return Rows(
        rows.case, rows.parameters, found, units, status, reason, [""] * len(rows), np.zeros(len(rows))
    )  # fmt: skip


def _fail(status: list[str], reason: list[str], why: Mapping[int, str]) -> None:
    """A case that ended well fails for this reason; the first stays."""
    for k, text in why.items():
        if status[k] in GOOD:
            status[k], reason[k] = "failed", text


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
