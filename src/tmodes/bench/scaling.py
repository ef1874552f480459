"""How cost grows with the robot: the exponent of a power law through the figures of several sizes."""

from __future__ import annotations

from typing import Any

import numpy as np

__all__ = ["exponents"]


def exponents(sizes: list[dict[str, Any]]) -> dict[str, float]:
    """Slope of log cost over log joints by least squares, by what it is the cost of; empty below three sizes.

    Memory is what the process needed beyond what it had before the chain.
    """
    if len(sizes) < 3:
        return {}
    joints = [size["n"] for size in sizes]
    found = {one["name"]: _contender(sizes, one["name"]) for one in sizes[0]["contenders"]}
    costs = {name: values for name, values in found.items() if len(values) == len(sizes)}
    starts = [size["start"] for size in sizes]
    costs["compile"] = [one["equations"] + one["compile"] for one in starts]
    costs["memory"] = [one["memory"] - one["memory_before"] for one in starts]
    return {name: _slope(joints, values) for name, values in costs.items() if min(values) > 0}


def _contender(sizes: list[dict[str, Any]], name: str) -> list[float]:
    known = [{one["name"]: one["seconds"]["median"] for one in size["contenders"]} for size in sizes]
    return [one[name] for one in known if name in one]


def _slope(joints: list[int], costs: list[float]) -> float:
    return float(np.polyfit(np.log(joints), np.log(costs), 1)[0])
