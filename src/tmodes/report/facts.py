"""Headline numbers: what one is, how they are shown without a program, and those of tracking, energy, frequencies."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from tmodes.report.markup import Markup, tag
from tmodes.report.quantity import written
from tmodes.result.summary import mean_over_time

__all__ = ["Fact", "energy_facts", "fact_list", "frequency_facts", "tracking_facts", "vibration_fact"]

_FEWEST = 8
"""Samples after the move without which no residual vibration is given."""


@dataclass(frozen=True)
class Fact:
    """One headline number: a stable name, words, the value [``unit``, SI] or None, and when, where, or why not."""

    id: str
    name: str
    value: float | None
    unit: str
    note: str = ""


def fact_list(facts: Iterable[Fact]) -> Markup:
    """Facts as the page shows them where no program runs."""
    entries = (
        tag("div", tag("dt", fact.name), tag("dd", tag("strong", _value(fact)), tag("span", fact.note)), class_="card")
        for fact in facts
    )
    return tag("dl", *entries, class_="cards")


def _value(fact: Fact) -> str:
    return "–" if fact.value is None else written(fact.value, fact.unit)


def tracking_facts(summary: dict[str, Any], data: Any, move_end: float | None) -> Iterator[Fact]:
    """How far the tip is from its reference, how long it takes to settle, and how it still swings after the move."""
    if deviation := summary["deviation"]:
        note = f"at {deviation['time_of_max_s']:.3g} s; {written(deviation['end_m'], 'm')} at the end of the run"
        yield Fact("deviation.max", "Largest deviation of the tip", deviation["max_m"], "m", note)
        square = mean_over_time(data["time"].values, data["deviation"].values ** 2)
        yield Fact("deviation.rms", "Deviation of the tip, rms", float(np.sqrt(square)), "m", "over the run")
        yield _settling(summary["settling"])
    yield vibration_fact(data, move_end)


def _settling(known: dict[str, Any]) -> Fact:
    name = "Settling after the move"
    if known["time_s"] is None:
        return Fact("settling", name, None, "s", f"not seen: {known['reason']}")
    within = f"until the tip stays within {written(known['limit_m'], 'm')}, {100 * known['band']:g} % of its largest"
    return Fact("settling", name, known["time_s"], "s", f"{within} deviation")


def vibration_fact(data: Any, move_end: float | None) -> Fact:
    """Largest distance of the tip, after the move, from its mean place (less the reference's) [m]."""
    own, name = "vibration.residual", "Residual vibration of the tip"
    if move_end is None:
        return Fact(own, name, None, "m", "what moves the robot changes up to the end of the run")
    time = data["time"].values
    after = np.flatnonzero(time > move_end * (1 + 1e-9))
    if len(after) < _FEWEST:
        return Fact(own, name, None, "m", "the run ends with the move")
    tip = data["tip"].transpose("time", "axis").values[after]
    if "tip_reference" in data:
        tip = tip - data["tip_reference"].transpose("time", "axis").values[after]
    largest = float(np.linalg.norm(tip - tip.mean(axis=0), axis=1).max())
    return Fact(own, name, largest, "m", f"about its mean place, from {time[after[0]]:.3g} s on")


def frequency_facts(known: dict[str, float | None]) -> Iterator[Fact]:
    """The lowest frequency that rings under control, where there is one."""
    if known["controlled"] is not None:
        locked = "" if known["locked"] is None else f"{known['locked']:.4g} Hz with the motors locked"
        yield Fact("frequency.first", "First frequency, controlled", known["controlled"], "Hz", locked)


def energy_facts(known: dict[str, Any]) -> Iterator[Fact]:
    """How well the energies add up: the worst residual of their balance over what was moved."""
    share = known["worst_residual_over_moved"]
    name, worst = "Energy balance", written(known["worst_residual_J"], "J")
    moved = f"worst residual, {worst}, over {written(known['moved_J'], 'J')} moved"
    note = "nothing moved" if share is None else moved
    yield Fact("energy.residual", name, share, "-", note)
