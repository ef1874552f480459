"""How far a quantity swings with each parameter by itself: the bars of a tornado."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.study.rows import Rows

__all__ = ["Labels", "swings"]

Array = NDArray[np.float64]
Labels = Mapping[int, str]
"""How a case came about, by its index: ``nominal``, ``gear low``, ``gear high``."""

_FEWEST = 20
"""Good cases without which no tenth has two of them."""

_TENTHS = "Median over the cases in the lowest (blue) and the highest (orange) tenth of each parameter"
_CHOICES = "; of what is chosen from a list: the choice with the least and that with the largest median"
_ENDS = "Each parameter alone at its lowest (blue) and its highest (orange) value, all others nominal"


def swings(rows: Rows, labels: Labels, chosen: Mapping[str, bool]) -> list[dict[str, Any]]:
    """One tornado for each quantity that has one; ``chosen``: parameters that are chosen from a list."""
    found = []
    for quantity, values in rows.quantities.items():
        info = _of_ends(rows, labels, values) or _of_tenths(rows, values, chosen)
        if info:
            found.append({"quantity": quantity, "unit": rows.units.get(quantity, "-"), **info})
    return found


def _of_ends(rows: Rows, labels: Labels, values: Array) -> dict[str, Any] | None:
    """From cases that say so: the nominal one, and each parameter at both ends by itself."""
    place = {label: index for index, label in labels.items()}
    pairs = {name: [place.get(f"{name} {end}") for end in ("low", "high")] for name in rows.parameters}
    bars = [
        {"name": name, "low": float(values[low]), "high": float(values[high])}
        for name, (low, high) in pairs.items()
        if low is not None and high is not None and np.isfinite(values[[low, high]]).all()
    ]
    nominal = place.get("nominal")
    if not bars or nominal is None or not np.isfinite(values[nominal]):
        return None
    return {"how": _ENDS, "base": float(values[nominal]), "bars": bars}


def _of_tenths(rows: Rows, values: Array, chosen: Mapping[str, bool]) -> dict[str, Any] | None:
    good = rows.good & np.isfinite(values)
    if good.sum() < _FEWEST:
        return None
    bars = []
    for name, given in rows.parameters.items():
        own = given[good]
        if own.min() == own.max():
            continue
        if chosen.get(name):
            middles = [float(np.median(values[good][own == one])) for one in np.unique(own)]
            low, high = min(middles), max(middles)
        else:
            ends = np.percentile(own, [10, 90])
            low, high = (float(np.median(values[good][part])) for part in (own <= ends[0], own >= ends[1]))
        bars.append({"name": name, "low": low, "high": high})
    how = _TENTHS + (_CHOICES if any(chosen.get(bar["name"]) for bar in bars) else "")
    return {"how": how, "base": float(np.median(values[good])), "bars": bars} if bars else None
