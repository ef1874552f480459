"""Rows: what some cases of a study gave, column by column; the one type that is stored, joined and shown."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from tmodes.simulation.case_results import Kept

__all__ = ["GOOD", "OWN_COLUMNS", "STATUS", "Kept", "Rows", "joined"]

Array = NDArray[np.float64]

STATUS = (
    "finished", "stopped_by_condition", "stopped", "diverged", "chattering", "failed", "refused", "interrupted",
    "step_too_small", "not_converged",
)  # fmt: skip
"""How a case may end; ``failed``: it could not start, or a quantity of it; ``refused``: the sheet has no such robot."""

GOOD = ("finished", "stopped_by_condition")

OWN_COLUMNS = ("case", "label", "status", "reason", "method", "seconds", "errors")
"""Columns of the table next to those of the parameters and quantities."""


@dataclass(frozen=True, eq=False)
class Rows:
    """m cases: their numbers in the study ``case`` (m,), ``parameters`` and ``quantities`` (m,) each, by name.

    Quantities are in the units of ``units``, not-a-number where a case has none. ``status`` and ``reason`` (m,) words;
    ``method``: integrator, empty where nothing was simulated; ``seconds`` (m,): of computing, a share of those of the
    cases that ran at once. ``kept``: whole motions, by the number of the case. ``errors`` (m,): sums of the estimated
    errors of the steps [-], not-a-number where there is no estimate.
    """

    case: NDArray[np.int64]
    parameters: Mapping[str, Array]
    quantities: Mapping[str, Array]
    units: Mapping[str, str]
    status: Sequence[str]
    reason: Sequence[str]
    method: Sequence[str]
    seconds: Array
    kept: Mapping[int, Kept] = field(default_factory=dict)
    errors: Array = field(default_factory=lambda: np.zeros(0))

    def __post_init__(self) -> None:
        if not len(self.errors):
            object.__setattr__(self, "errors", np.full(len(self.case), np.nan))

    def __len__(self) -> int:
        return len(self.case)

    @cached_property
    def good(self) -> NDArray[np.bool_]:
        """Which cases reached their end, (m,)."""
        return np.array([status in GOOD for status in self.status], dtype=bool)


def joined(parts: Sequence[Rows]) -> Rows:
    """All rows of some parts, which have the same columns, in their order."""
    first = parts[0]

    def stacked(of: str) -> dict[str, Array]:
        return {name: np.concatenate([getattr(part, of)[name] for part in parts]) for name in getattr(first, of)}

    words = {of: [one for part in parts for one in getattr(part, of)] for of in ("status", "reason", "method")}
    kept = {case: one for part in parts for case, one in part.kept.items()}
    return Rows(
        np.concatenate([part.case for part in parts]), stacked("parameters"), stacked("quantities"), first.units,
        **words, seconds=np.concatenate([part.seconds for part in parts]), kept=kept,
        errors=np.concatenate([part.errors for part in parts]),
    )  # fmt: skip
