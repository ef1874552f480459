"""What a finished run says of its integration: its steps, its time of computing, and the error of its figures."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

__all__ = ["error_of", "integration_lines"]


def error_of(summary: dict[str, Any], path: str, factor: float, unit: str) -> str:
    """The estimated error of a figure in its unit, ``< `` before a bound; empty where it is not known."""
    info = summary["error"]
    if not info or path not in info["figures"]:
        return ""
    error = info["figures"][path] * factor
    bound = "< " if "sum" in info["how"] and error else ""
    return f"{bound}{error:.1e} {unit}".rstrip() if error else f"0 {unit}".rstrip()


def integration_lines(result: Any, summary: dict[str, Any]) -> Iterator[str]:
    """Lines on the run, and on how its error is known."""
    info = result.statistics.get("real", {})
    if "method" in info:
        yield f"steps   {_steps(info)}{_seconds(result.timing)}"
    for part in info.get("parts", {}).values():
        yield f"        from t = {part['from_s']:.4g} s on by {part['method']}: {part['steps']:,} steps"
    if summary["error"] is None:
        yield "error   not estimated"
    elif "sum" in summary["error"]["how"]:
        yield "error   at most about the sum of the local errors, mostly far less; --check-error gives a sharp one"
    else:
        yield f"error   by a {summary['error']['how']}"


def _steps(info: dict[str, Any]) -> str:
    text = f"{info['steps']:,} of {info['method']} ({info['rejected']:,} rejected), {info['evaluations']:,} evaluations"
    if info.get("passes"):
        text += f" in {info['passes']:,} passes of four lanes"
    if info.get("mean_step_s"):
        text += f"; smallest {info['smallest_step_s']:.2g} s, mean {info['mean_step_s']:.2g} s"
    return text


def _seconds(timing: dict[str, float]) -> str:
    return f"; {timing['real']:.2g} s of computing for each simulated second" if "real" in timing else ""
