"""Quantities that follow from stored ones: formulas, and series of kept motions."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from tmodes.study.quantities import Asked, Quantity
from tmodes.study.rows import GOOD, Rows
from tmodes.study.space import ordered

if TYPE_CHECKING:
    from tmodes.study.study import Study

__all__ = ["derivable", "derived", "is_formula"]


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
