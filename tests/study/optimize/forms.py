"""Optimizations of expressions."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from tmodes.study.read import study_from_data
from tmodes.study.study import Study

__all__ = ["design_study"]


def design_study(
    quantities: Mapping[str, Any], ranges: Mapping[str, Any], objectives: Sequence[Any], limits: Sequence[str] = (),
    **more: Any,
) -> Study:  # fmt: skip
    """A study of expressions: ``ranges`` (low, high), or names of choices, by parameter."""

    def parameter(given: Any) -> dict[str, Any]:
        if isinstance(given, tuple):
            return {"distribution": {"type": "uniform", "low": given[0], "high": given[1]}}
        return given if isinstance(given, dict) else {"choices": [{"name": name, "set": {}} for name in given]}

    return study_from_data({
        "format": 1, "kind": "study", "name": "design", "plan": {"type": "monte_carlo", "runs": 1},
        "parameters": {name: parameter(given) for name, given in ranges.items()},
        "quantities": {name: {"expression": one} if isinstance(one, str) else one for name, one in quantities.items()},
        "optimize": {"objectives": [*objectives], "limits": [*limits], **more},
    })  # fmt: skip
