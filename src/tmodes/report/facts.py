"""The headline numbers of a run: tracking, loads, margins to limits, frequencies, energy."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from tmodes.analysis.worst import worst_place
from tmodes.plot.facts import effort_unit, names_of
from tmodes.report.markup import Markup, tag, written
from tmodes.result import Result
from tmodes.result.derived import Derives
from tmodes.result.summary import largest_elements, mean_over_time, settling_words, vibration_words

__all__ = [
    "Fact",
    "energy_facts",
    "fact_list",
    "frequency_facts",
    "run_facts",
    "tracking_facts",
    "value_words",
    "vibration_fact",
]


@dataclass(frozen=True)
class Fact:
    """One headline number: a stable name, words, the value [``unit``, SI] or None, and when, where, or why not.

    ``time`` [s]: at which it is so; ``more``: what a reader may ask next.
    """

    id: str
    name: str
    value: float | None
    unit: str
    note: str = ""
    time: float | None = None
    more: str = ""


def fact_list(facts: Iterable[Fact]) -> Markup:
    """Facts as the page shows them where no program runs."""
    entries = (
        tag(
            "div",
            tag("dt", fact.name),
            tag("dd", tag("strong", value_words(fact)), tag("span", _said(fact))),
            class_="card",
        )
        for fact in facts
    )
    return tag("dl", *entries, class_="cards")


def _said(fact: Fact) -> str:
    return "; ".join(filter(None, [fact.note, fact.more]))


def value_words(fact: Fact) -> str:
    """Its value with a readable unit; a dash where there is none."""
    return "–" if fact.value is None else written(fact.value, fact.unit)


def tracking_facts(summary: dict[str, Any]) -> Iterator[Fact]:
    """How far the tip is from its commanded and nominal paths, and why; how it settles and rings."""
    errors, point = summary["tip_error"], summary["point"]
    other, whose = ("point.", f", {point['name']}") if point["reason"] else ("", "")  # the page has the tip's
    facts = []
    if one := errors.get("commanded"):
        facts.append(_error(one, f"{other}tip_error.commanded", f"Error from commanded path{whose}", one))
    if deviation := summary["deviation"]:
        nominal = errors.get("nominal", {})
        facts.append(_error(deviation, f"{other}deviation.max", f"Error from nominal path{whose}", nominal))
    yield from facts
    yield _settling(summary["settling"])
    for which, one in summary["vibration"].items():
        yield vibration_fact(which, one)


def _error(largest: dict[str, Any], own: str, name: str, causes: dict[str, Any]) -> Fact:
    """The largest error of the tip; by its causes, gears and links, and the contact where they are known."""
    time, end = largest["time_of_max_s"], written(largest["end_m"], "m")
    parts = {"": causes.get("parts_m", {}).items(), "by element ": largest_elements(causes)}
    parts["by the contact, by statics, "] = (causes.get("environment_m") or {}).items()
    said = [
        words + ", ".join(f"{written(value, 'm')} {name}" for name, value in part if value)
        for words, part in parts.items() if len(part) > (words == "by element ")
    ]  # fmt: skip
    note = f"at {time:.3g} s; {end} at the end of the run"
    return Fact(own, name, largest["max_m"], "m", note, time, "; ".join(said))


def _settling(known: dict[str, Any]) -> Fact:
    note = settling_words(known, lambda length: written(length, "m"))
    return Fact("settling", "Settling after the move", known["time_s"], "s", note)


def vibration_fact(which: str, known: dict[str, Any]) -> Fact:
    """Amplitude of the ``actual`` or ``nominal`` tip after the move, about its slowly moving mean [m]."""
    own = "vibration.residual" if which == "actual" else f"vibration.{which}"
    name = f"Residual vibration, {which}"
    return Fact(own, name, known["amplitude_m"], "m", vibration_words(known, lambda length: written(length, "m")))


def frequency_facts(known: dict[str, float | None]) -> Iterator[Fact]:
    """The natural frequency of the lowest mode that rings under control, where there is one."""
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


def run_facts(result: Result, summary: dict[str, Any], made: Derives | None = None) -> list[Fact]:
    """From a result and its summary; what there is not is left out, and what cannot be computed, noted by ``made``."""
    made = made or Derives()
    data, links, limits = result.record, summary["links"], summary["verdict"]["limits"]
    # A page computes the loads of links that bend; of those alone, where there are any, so that all say the same.
    bent = {name: link for name, link in links.items() if (link["deflection"] or {}).get("max_m")} or links
    groups: dict[str, Callable[[], Iterator[Fact]]] = {
        "tip": lambda: tracking_facts(summary),
        "deflections": lambda: _worst(links, "deflection", "max_m", "m", "Largest deflection of a link"),
        "moments": lambda: _worst(bent, "bending_moment", "max_Nm", "N m", "Largest bending moment", "moment.max"),
        "stresses": lambda: _stress(links, limits),
        "gears": lambda: _gear(summary["deformations"]),
        "drives": lambda: _drives(data),
        "limits": lambda: _limits(limits),
        "contact": lambda: _contact(summary["contact_force"]),
        "frequencies": lambda: frequency_facts(summary["first_frequency_Hz"]),
        "energy": lambda: energy_facts(summary["energy"]) if summary["energy"] else iter(()),
        "deviation": lambda: _square(data),
    }
    return [
        fact for name, facts in groups.items()
        for fact in made.attempt(f"numbers of the {name}", lambda of=facts: [*of()], lambda _: [])
    ]  # fmt: skip


def _square(data: Any) -> Iterator[Fact]:
    if "deviation" in data:
        square = mean_over_time(data["time"].values, data["deviation"].values ** 2)
        yield Fact("deviation.rms", "Error from nominal path, rms", float(np.sqrt(square)), "m", "over the run")


def _worst(links: dict[str, Any], quantity: str, key: str, unit: str, title: str, own: str = "") -> Iterator[Fact]:
    known = {name: link[quantity] for name, link in links.items() if link[quantity]}
    if known:
        name = max(known, key=lambda name: known[name][key])
        one = known[name]
        place = "" if quantity == "deflection" else f" at s = {one['s']:.2g}"
        note = f"{name}{place}, at {one['time_s']:.3g} s"
        yield Fact(own or f"{quantity}.max", title, one[key], unit, note, one["time_s"])


def _stress(links: dict[str, Any], limits: list[dict[str, Any]]) -> Iterator[Fact]:
    """The largest stress, and the largest share of a material's yield strength."""
    yield from _worst(links, "stress", "max_Pa", "Pa", "Largest stress (von Mises)")
    for one in [one for one in limits if one["quantity"] == "stress"][:1]:
        note = f"of {written(one['limit'], 'Pa')}, {one['element']}; margin {100 * (1 - one['share']):.3g} %"
        yield Fact("stress.share", "Share of the yield strength", 100 * one["share"], "%", note)


def _gear(deformations: dict[str, dict[str, Any]]) -> Iterator[Fact]:
    """The largest deflection of a gear; where some turn and others slide, of those that turn."""
    every = {name: one for name, one in deformations.items() if name.endswith(".gear")}
    gears = {name: one for name, one in every.items() if one["unit"] == "rad"} or every
    if gears:
        name = max(gears, key=lambda name: gears[name]["max"])
        one = gears[name]
        others = " (of the gears that turn)" if len(gears) < len(every) else ""
        note = f"{name.removesuffix('.gear')}, at {one['time_of_max_s']:.3g} s{others}"
        yield Fact("gear.max", "Largest deflection of a gear", one["max"], one["unit"], note, one["time_of_max_s"])


def _drives(data: Any) -> Iterator[Fact]:
    """The largest gear torque, of the joints that turn where some do, and the largest motor voltage."""
    if "drive" not in data.dims:
        return
    drives = names_of(data, "drive")
    turning = [name for name in drives if effort_unit(data, name) == "N m"] or drives
    unit = effort_unit(data, turning[0])
    yield from _largest(data, "gear_torque", turning, Fact("gear_torque.max", "Largest gear torque", None, unit))
    if "voltage" in data:
        yield from _largest(data, "voltage", drives, Fact("voltage.max", "Largest motor voltage", None, "V"))


def _largest(data: Any, series: str, drives: list[str], fact: Fact) -> Iterator[Fact]:
    """The fact with the largest size of a series of these drives; none where all are zero."""
    sizes = np.abs(data[series].sel(drive=drives).transpose("time", "drive").values)
    sample, drive = worst_place(sizes)
    if sizes[sample, drive] > 0:
        time = float(data["time"][sample])
        yield replace(fact, value=float(sizes[sample, drive]), note=f"{drives[drive]}, at {time:.3g} s", time=time)


def _limits(limits: list[dict[str, Any]]) -> Iterator[Fact]:
    """The largest share of a limit of a joint: of its speed, its effort, its range (from its middle)."""
    for one in [one for one in limits if one["quantity"] != "stress"][:1]:
        value, limit = (written(one[name], one["unit"]) for name in ("value", "limit"))
        of = ", from its middle" if one["quantity"] == "range" else f": {value} of {limit}"
        note = f"{one['quantity']} of {one['element']}{of}"
        yield Fact("limits.share", "Share of a joint's limit", 100 * one["share"], "%", note)


def _contact(known: dict[str, float] | None) -> Iterator[Fact]:
    if known is not None:
        note = f"from {known['min_N']:.4g} to {known['max_N']:.4g} N"
        yield Fact("contact.mean", "Contact force, mean", known["mean_N"], "N", note)
