"""The moments of a run that its time bar marks: the largest error, the end of the move, contact, limits passed."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any

import numpy as np

from tmodes.errors import TmodesError
from tmodes.report.facts import Fact
from tmodes.result import Result

__all__ = ["events_of"]

_MOST = 12
_MARKED = ("tip_error.commanded", "deviation.max", "deflection.max", "gear.max")
"""The numbers whose moments are marked."""


def events_of(result: Result, facts: Iterable[Fact]) -> list[dict[str, Any]]:
    """Times [s] and words in their order, a dozen at most."""
    end = float(result.record["time"][-1])
    known = {fact.id: fact for fact in facts if fact.time is not None}
    found = [(known[name].time, f"largest: {known[name].name.lower()}") for name in _MARKED if name in known]
    if result.move_end is not None:
        found.append((result.move_end, "end of the move"))
    found += [*_contact(result.record), *_limits(result)]
    inside = sorted((float(time), words) for time, words in found if time is not None and 0 < time <= end)
    return [{"time": time, "label": words} for time, words in dict.fromkeys(inside)][:_MOST]


def _contact(data: Any) -> Iterator[tuple[float, str]]:
    if "contact_force_normal" in data:
        touching = data["contact_force_normal"].values.ravel() > 0
        for k in np.flatnonzero(np.diff(touching)):
            yield float(data["time"][k + 1]), "contact" if touching[k + 1] else "contact lost"


def _limits(result: Result) -> Iterator[tuple[float, str]]:
    data, time = result.record, result.record["time"].values
    try:
        joints = result.robot.joints
    except TmodesError:
        return
    for joint in joints:
        for name in joint.coordinates:
            for series, dim, words in (("v", "coordinate", "speed"), ("effort", "drive", "effort")):
                if (bound := getattr(joint.limits, words, None)) and dim in data.dims and name in data[dim].values:
                    past = np.flatnonzero(np.abs(data[series].sel(**{dim: name}).values) > bound)
                    if len(past):
                        yield float(time[past[0]]), f"{name} passes its limit of {words}"
