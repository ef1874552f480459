"""What a finished run says of its integration: its steps, its time of computing, and the error of its figures."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

__all__ = ["error_of", "integration_lines"]


def error_of(summary: dict[str, Any], path: str, factor: float, unit: str) -> str:
    """The estimated error of a figure in its unit, ``< `` before a bound; empty where it is not known."""
    told = summary["error"]
    if not told or path not in told["figures"]:
        return ""
    error = told["figures"][path] * factor
    bound = "< " if "sum" in told["how"] and error else ""
    return f"{bound}{error:.1e} {unit}".rstrip() if error else f"0 {unit}".rstrip()


def integration_lines(result: Any, summary: dict[str, Any]) -> Iterator[str]:
    """Lines on the run, and on how its error is known."""
    told = result.statistics.get("real", {})
    if "method" in told:
        yield f"steps   {_steps(told)}{_seconds(result.timing)}"
    for part in told.get("parts", {}).values():
        yield f"        from t = {part['from_s']:.4g} s on by {part['method']}: {part['steps']:,} steps"
    if summary["error"] is None:
        yield "error   not estimated"
    elif "sum" in summary["error"]["how"]:
        yield "error   at most about the sum of the local errors, mostly far less; --check-error tells it sharply"
    else:
        yield f"error   by a {summary['error']['how']}"


def _steps(told: dict[str, Any]) -> str:
    text = f"{told['steps']:,} of {told['method']} ({told['rejected']:,} rejected), {told['evaluations']:,} evaluations"
    if told.get("passes"):
        text += f" in {told['passes']:,} passes of four lanes"
    if told.get("mean_step_s"):
        text += f"; smallest {told['smallest_step_s']:.2g} s, mean {told['mean_step_s']:.2g} s"
    return text


def _seconds(timing: dict[str, float]) -> str:
    return f"; {timing['real']:.2g} s of computing for each simulated second" if "real" in timing else ""
