"""What a finished run has shown, in tables: the numbers that a reader asks first, its events, steps and errors."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import asdict
from textwrap import fill
from typing import TYPE_CHECKING, Any

from tmodes.io.printed import Table, plain
from tmodes.io.words import element_words

if TYPE_CHECKING:
    from tmodes.report.facts import Fact
    from tmodes.result import Result

__all__ = [
    "error_of",
    "events_table",
    "integration_lines",
    "model_error_of",
    "result_record",
    "run_tables",
    "summary_rows",
]


COLUMNS = 80
"""Columns of the first lines on a run, at most."""


def result_record(result: Result, band: str | float | None = None) -> dict[str, Any]:
    """What a result says, for machines."""
    return {
        "status": result.status, "message": result.message, "warnings": list(result.warnings),
        "summary": result.summary(band), "frequencies": result.frequencies, "statistics": result.statistics,
        "events": [asdict(event) for event in result.events],
    }  # fmt: skip


def events_table(result: Result) -> str | Table:
    """What happened at instants."""
    rows = [
        (f"{event.time:.9g}", event.kind, plain(event.place), f"{event.direction:+d}" if event.direction else "",
         f"{event.speed:.6g}" if event.unit else "-", event.unit)
        for event in result.events
    ]  # fmt: skip
    if not rows:
        return f"{plain(result.name)}: no events"
    columns = ["time [s]", "event", "where", "direction", "speed", "unit"]
    return Table(f"{plain(result.name)}: {len(rows):,} events", columns, rows)


def run_tables(
    result: Result, band: str | float | None = None, *, everything: bool = False, more: str = "", columns: int = COLUMNS
) -> Iterator[str | Table]:
    """What a run comes to in words, its numbers, at most a dozen, and its events.

    ``everything``: all numbers with their errors, how the run ended, its steps; ``band``: within which the tip counts
    as settled; ``more``: where the rest is; ``columns``: in which the words are broken, at most ``COLUMNS``.
    """
    from tmodes.result.events import counted
    from tmodes.result.verdict import culprit_words

    summary, columns = result.summary(band), min(columns, COLUMNS)
    found = summary["verdict"]
    yield fill(plain(found["sentence"]), columns)
    if words := culprit_words(found):
        yield fill(plain(f"Causes: {words}."), columns)
    yield _every_number(result, summary) if everything else _first_numbers(result, summary)
    if everything:
        yield f"end     {plain(result.message)}"
    if events := result.events:
        yield f"events  {len(events):,}: {counted(events)} (tmodes show --events)"
    if everything:
        yield from integration_lines(result, summary)
    elif more:
        yield f"more    {more}"


def _every_number(result: Result, summary: dict[str, Any]) -> Table:
    columns = ["quantity", "value", "error", "model error", "where"]
    rows = list(summary_rows(summary))
    if not (summary["model_error"] or {}).get("figures"):
        columns, rows = [name for name in columns if name != "model error"], [(*row[:3], row[4]) for row in rows]
    return Table(f"{result.name}: {result.status}", columns, rows)


def _first_numbers(result: Result, summary: dict[str, Any]) -> Table:
    """The facts of a report that matter most, in their order."""
    from tmodes.report.facts import run_facts, value_words

    facts = {fact.id.removeprefix("point."): fact for fact in run_facts(result, summary)}
    own, rows = _short_notes(summary), []
    for name in (name for name in _FIRST if name in facts):
        fact = facts[name]
        note = own.get(name) or fact.note.partition("; not looked at")[0].removesuffix(" of the run")
        words = fact.name, _uncertain(summary, fact, value_words(fact)), note
        rows.append([plain(text) for text in words])
    return Table(f"{result.name}: {result.status}", ["quantity", "value", "where"], rows)


_FIRST = (
    "tip_error.commanded", "deviation.max", "settling", "vibration.residual", "deflection.max", "stress.max",
    "stress.share", "gear.max", "gear_torque.max", "limits.share", "contact.mean", "energy.residual",
)  # fmt: skip
"""Facts by their stable names."""


def _short_notes(summary: dict[str, Any]) -> dict[str, str]:
    """Of what says more in a report."""
    from tmodes.io.printed import written
    from tmodes.result.verdict import damping_words

    settling, residual, energy = summary["settling"], summary["verdict"]["residual"], summary["energy"]
    notes = {"settling": "not seen to settle"} if settling["time_s"] is None else {}
    if settling["time_s"] is not None and not settling["reason"]:
        notes["settling"] = f"within {written(settling['limit_m'], 'm', 3)} of its rest"
    if residual:
        notes["vibration.residual"] = f"{residual['frequency_Hz']:.3g} Hz, {damping_words(residual['damping'])} damping"
    if energy and energy["worst_residual_over_moved"] is not None:
        notes["energy.residual"] = f"of {written(energy['moved_J'], 'J')} moved"
    return notes


def _uncertain(summary: dict[str, Any], fact: Fact, words: str) -> str:
    """A number with its error, by integration and link models, in one unit, where it shows in its first figures.

    Of a number that is less than its error what it is below.
    """
    from tmodes.io.printed import written

    path, value, unit = _PATHS.get(fact.id), abs(fact.value or 0.0), words.rpartition(" ")[2]
    found = max((summary[kind] or {}).get("figures", {}).get(path, 0.0) for kind in ("error", "model_error"))
    if found > value:
        return f"below {written(value + found, 'm', 2)}"
    return f"{words} ± {_METRES[unit] * found:.2g} {unit}" if found > _SHOWS * value else words


_PATHS = {"tip_error.commanded": "tip_error.commanded.max_m", "deviation.max": "deviation.max_m"}
"""Where the errors of facts are."""

_METRES = {"m": 1.0, "mm": 1e3, "µm": 1e6, "nm": 1e9}
"""Units of what has an error, in a metre."""

_SHOWS = 1e-3
"""Share of a number from which on its error is said with it."""


def error_of(summary: dict[str, Any], path: str, factor: float, unit: str) -> str:
    """The error of a figure in its unit, ``< `` before a bound, ``≈ `` before an estimate; empty where not known."""
    info = summary["error"]
    if not info or path not in info["figures"]:
        return ""
    error = info["figures"][path] * factor
    sign = "≈" if path in info["approximate"] else "<"
    return f"{sign} {error:.1e} {unit}".rstrip() if error else f"0 {unit}".rstrip()


def integration_lines(result: Any, summary: dict[str, Any]) -> Iterator[str]:
    """Lines on the run, and on how its error is known."""
    info = result.statistics.get("real", {})
    if "method" in info:
        yield f"steps   {_steps(info)}{_seconds(result.timing)}"
    for part in info.get("parts", {}).values():
        yield f"        from t = {part['from_s']:.4g} s on by {part['method']}: {part['steps']:,} steps"
    if summary["error"] is None:
        yield "error   not estimated"
    elif not summary["error"]["how"]:
        yield f"error   of the integration not estimated: {summary['error']['why']}"
    else:
        yield f"error   of the integration, by {summary['error']['how']}: < holds in 99 % of runs, ≈ is an estimate"
    if model := summary["model_error"]:
        how = f"of the link models, by a {model['how']}" if model["how"] else f"not estimated: {model['why']}"
        yield f"model error   {how}"


def _steps(info: dict[str, Any]) -> str:
    alone = not info.get("parts")  # else the parts say by which method their steps are
    by = f" of {info['method']}" if alone else ""
    text = f"{info['steps']:,}{by} ({info['rejected']:,} rejected), {info['evaluations']:,} evaluations"
    if alone and info.get("passes"):
        text += f" in {info['passes']:,} passes of four lanes"
    if info.get("mean_step_s"):
        text += f"; smallest {info['smallest_step_s']:.2g} s, mean {info['mean_step_s']:.2g} s"
    return text


def _seconds(timing: dict[str, float]) -> str:
    return f"; {timing['real']:.2g} s of computing for each simulated second" if "real" in timing else ""


_MOST_JOINTS = 8
_MOST_DEFORMATIONS = 8


Row = tuple[str, str, str, str, str]
"""Quantity, value, error of the integration, error of the link models, where and when."""


def _row(
    summary: dict[str, Any], path: str, name: str, value: float, unit: str, where: str = "", factor: float = 1.0
) -> Row:
    """The row of a figure (SI) in a unit that is ``factor`` to one of SI; ``path``: where its error is."""
    return name, f"{value * factor:.4g} {unit}", *_errors(summary, path, factor, unit), where


def _errors(summary: dict[str, Any], path: str, factor: float, unit: str) -> tuple[str, str]:
    return error_of(summary, path, factor, unit), model_error_of(summary, path, factor, unit)


def model_error_of(summary: dict[str, Any], path: str, factor: float, unit: str) -> str:
    """The bound of the error of the link models in a figure, in its unit; empty where it is not known."""
    info = summary["model_error"]
    return f"< {info['figures'][path] * factor:.1e} {unit}".rstrip() if info and path in info["figures"] else ""


def summary_rows(summary: dict[str, Any]) -> Iterator[Row]:
    """Rows of quantity, value, error, where and when; of many joints and deformations the largest ones."""
    yield from _tip(summary)
    yield from _deformations(summary)
    for name, link in summary["links"].items():
        yield from _link(name, link, summary)
    yield from _efforts(summary)
    if force := summary["contact_force"]:
        value = f"{force['min_N']:.3f} ... {force['max_N']:.3f} N"
        errors = _errors(summary, "contact_force.max_N", 1.0, "N")
        yield "contact force", value, *errors, f"mean {force['mean_N']:.3f} N"
    if energy := summary["energy"]:
        still = energy["worst_residual_over_moved"] is None
        moved = "rounding: nothing moves" if still else f"of {energy['moved_J']:.3g} J moved"
        yield "energy balance", f"{energy['worst_residual_J']:.1e} J", "", "", moved


def _tip(summary: dict[str, Any]) -> Iterator[Row]:
    from tmodes.result.summary import settling_words, vibration_words

    def in_mm(length: float) -> str:
        return f"{length * 1e3:.3g} mm"

    point, settling = summary["point"], summary["settling"]
    if point["reason"]:
        yield "errors measured at", "-", "", "", point["name"] or point["reason"]
    errors = summary["tip_error"] or ({"nominal": summary["deviation"]} if summary["deviation"] else {})
    for which, one in errors.items():
        yield from _tip_error(summary, which, one)
    time = "-" if settling["time_s"] is None else f"{settling['time_s']:.3f} s"
    yield "settling after the move", time, "", "", settling_words(settling, in_mm)
    for which, one in summary["vibration"].items():
        value = "-" if one["amplitude_m"] is None else f"{one['amplitude_m'] * 1e3:.4g} mm"
        yield f"residual vibration, {which}", value, "", "", vibration_words(one, in_mm)


_ERRORS = {"commanded": "tip_error.commanded", "nominal": "deviation"}
"""Paths from which the tip's error is measured, and where the uncertainty of the largest one is."""


def _tip_error(summary: dict[str, Any], which: str, one: dict[str, Any]) -> Iterator[Row]:
    """The largest error, by causes along it; the last one; what of gears and links is by the contact force."""
    from tmodes.result.verdict import culprit_words, culprits

    when, name = f"t = {one['time_of_max_s']:.3f} s", f"error from {which} path"
    words = "; ".join(filter(None, [culprit_words({"culprits": [*culprits(one)]}), when]))
    yield _row(summary, f"{_ERRORS[which]}.max_m", name, one["max_m"], "mm", words, 1e3)
    yield _row(summary, f"{_ERRORS[which]}.end_m", f"{name} at the end", one["end_m"], "mm", "", 1e3)
    if environment := one.get("environment_m"):
        words = ", ".join(f"{value * 1e3:.3g} mm of {part}" for part, value in environment.items())
        yield "  of it by the contact", "", "", "", f"{words} (statics with and without it)"


def _largest(info: dict[str, Any], key: str, most: int) -> list[tuple[str, dict[str, Any]]]:
    """At most so many entries, those with the largest sizes of ``key``, in their order."""
    chosen = sorted(info, key=lambda name: -abs(info[name][key]))[:most]
    return [(name, one) for name, one in info.items() if name in chosen]


def _deformations(summary: dict[str, Any]) -> Iterator[Row]:
    for name, one in _largest(summary["deformations"], "max", _MOST_DEFORMATIONS):
        unit, factor = ("", 1.0) if one["unit"] == "1" else (f"m{one['unit']}", 1e3)  # of stretch and shear none
        parts = [f"t = {one['time_of_max_s']:.3f} s"]
        if "max_stationary" in one:
            sizes = {"static": one["max_stationary"], "dynamic": one["max_oscillatory"]}
            parts += [f"largest {part} part {size * factor:.4g} {unit}".rstrip() for part, size in sizes.items()]
        own = f"deflection of {element_words(name)}"
        yield _row(summary, f"deformations.{name}.max", own, one["max"], unit, ", ".join(parts), factor)


def _link(name: str, link: dict[str, Any], summary: dict[str, Any]) -> Iterator[Row]:
    bent, own = link["deflection"], f"links.{name}"
    when = f"t = {bent['time_s']:.3f} s"
    yield _row(summary, f"{own}.deflection.max_m", f"deflection of {name}", bent["max_m"], "mm", when, 1e3)
    loads = (("bending_moment", "max_Nm", "N m", 1.0), ("stress", "max_Pa", "MPa", 1e-6))
    for load, key, unit, factor in loads:
        if one := link[load]:
            place, words = f"s = {one['s']:.2f}, t = {one['time_s']:.3f} s", load.replace("_", " ")
            yield _row(summary, f"{own}.{load}.{key}", f"{words} of {name}", one[key], unit, place, factor)


def _efforts(summary: dict[str, Any]) -> Iterator[Row]:
    for name, one in _largest(summary["joints"], "largest_effort", _MOST_JOINTS):
        when, unit = f"t = {one['time_of_largest_effort_s']:.3f} s", "N" if one["unit"] == "m" else "N m"
        yield _row(summary, f"joints.{name}.largest_effort", f"effort of {name}", one["largest_effort"], unit, when)
