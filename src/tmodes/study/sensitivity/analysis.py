"""From the rows of a study to its sensitivity."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmodes.errors import SimulationError
from tmodes.study.plans import Design
from tmodes.study.rows import Rows
from tmodes.study.sensitivity.morris import elementary_effects
from tmodes.study.sensitivity.result import Sensitivity
from tmodes.study.sensitivity.sobol import Indices, sobol_indices

__all__ = ["analysed"]

Array = NDArray[np.float64]

MOST_FAILED = 0.05
"""Share of cases without a value, above which a quantity has no indices: those that are left decide what they are."""


class _One(NamedTuple):
    """What is known of one quantity; ``shift``: by how much failed cases may change its indices."""

    indices: Indices | None
    failed: int
    shift: float
    note: str


def analysed(method: str, rows: Rows, design: Design) -> Sensitivity:
    """The indices of all quantities of all cases of a design, by ``sobol`` or ``morris``.

    Raises :class:`tmodes.errors.SimulationError` where more than 5 % of the cases of every quantity failed.
    """
    samples = int(design.info["samples"])
    of, shapes = _METHODS[method](design.info, len(rows.parameters))
    names, quantities = tuple(rows.parameters), tuple(rows.quantities)
    found = {name: _one(values, of, samples, rows) for name, values in rows.quantities.items()}
    if all(one.failed > MOST_FAILED * len(rows) for one in found.values()):
        worst = min(found.values(), key=lambda one: one.failed)
        raise SimulationError(f"sensitivity: {worst.note}")

    def stacked(part: str) -> dict[str, Array]:
        ends = (2,) if part == "intervals" else ()
        return {
            index: np.stack([_or_nan(one.indices, part, index, (*shape, *ends)) for one in found.values()])
            for index, shape in shapes.items()
            if not (ends and index == "spread")
        }

    with np.errstate(invalid="ignore"):
        finite = [values[np.isfinite(values)] for values in rows.quantities.values()]
    return Sensitivity(
        method, names, quantities, dict(rows.units), samples, len(rows),
        failed=np.array([one.failed for one in found.values()]),
        shift=np.array([one.shift for one in found.values()]),
        mean=np.array([values.mean() if len(values) else np.nan for values in finite]),
        deviation=np.array([values.std(ddof=1) if len(values) > 1 else np.nan for values in finite]),
        indices=stacked("values"), intervals=stacked("intervals"),
        notes={name: one.note for name, one in found.items() if one.note},
    )  # fmt: skip


def _or_nan(found: Indices | None, part: str, index: str, shape: tuple[int, ...]) -> Array:
    return np.full(shape, np.nan) if found is None else getattr(found, part)[index]


def _one(values: Array, of: Callable[[Array], Indices | None], samples: int, rows: Rows) -> _One:
    """The indices of one quantity, or why it has none."""
    lost = ~np.isfinite(values)
    failed = int(lost.sum())
    if failed > MOST_FAILED * len(values):
        share, most = failed / len(values), f"{MOST_FAILED:.0%}"
        note = (
            f"{failed:,} of {len(values):,} cases ({share:.1%}) have no value, more than {most}: "
            f"indices of the others would mislead; {_why(rows, lost)}"
        )
        return _One(None, failed, np.nan, note)
    found = of(values.reshape(samples, -1))
    if found is None:
        return _One(None, failed, np.nan, "it does not vary")
    return _One(found, failed, _shift(values, lost, found, of, samples), "")


def _why(rows: Rows, lost: NDArray[np.bool_]) -> str:
    """The most frequent reason."""
    reasons = Counter(rows.reason[k] or rows.status[k] for k in np.flatnonzero(lost).tolist())
    reason, count = reasons.most_common(1)[0]
    return f"{count:,} of them: {reason}; narrow the distributions, or choose a quantity that every case has"


def _shift(values: Array, lost: Any, found: Indices, of: Callable[[Array], Indices | None], samples: int) -> float:
    """Largest change of an index where failed cases get the least, or the largest, of the other values."""
    if not lost.any():
        return 0.0
    rest = values[~lost]
    largest = 0.0
    for extreme in (rest.min(), rest.max()):
        other = of(np.where(lost, extreme, values).reshape(samples, -1))
        if other:
            apart = [np.abs(other.values[index] - known) for index, known in found.values.items()]
            largest = max(largest, *(float(np.nanmax(one)) for one in apart))
    return largest


Shapes = dict[str, tuple[int, ...]]


def _sobol(info: Mapping[str, Any], d: int) -> tuple[Callable[[Array], Indices | None], Shapes]:
    pairs = bool(info["second_order"])
    shapes: Shapes = {"first": (d,), "total": (d,)} | ({"second": (d, d)} if pairs else {})
    return lambda values: sobol_indices(values, int(info["replicates"]), second_order=pairs), shapes


def _morris(info: Mapping[str, Any], d: int) -> tuple[Callable[[Array], Indices | None], Shapes]:
    shapes: Shapes = dict.fromkeys(("effect", "size", "spread"), (d,))
    return lambda values: elementary_effects(values, np.array(info["order"]), np.array(info["steps"])), shapes


_METHODS = {"sobol": _sobol, "morris": _morris}
