"""The linked charts of one or several runs."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from tmodes.report.charts import arm_charts
from tmodes.report.charts_paper import robot_charts
from tmodes.report.drafts import Draft, in_readable_units

if TYPE_CHECKING:
    from tmodes.result.record import RunRecord

__all__ = ["charts_of", "drafts_of"]


def charts_of(results: Sequence[RunRecord]) -> list[list[dict[str, Any]]]:
    """The charts of each run as ``Chart`` of ``web/src/contract.ts``; charts of one name have one unit in all runs."""
    return in_readable_units([drafts_of(result) for result in results])


def drafts_of(result: RunRecord) -> list[Draft]:
    """The charts of a run in SI units."""
    return list(arm_charts(result.data) if result.kind == "arm" else robot_charts(result.data))
