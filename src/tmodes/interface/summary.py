"""What a finished run has shown, in tables: the numbers that a reader asks first, its events, steps and errors."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import asdict
from typing import TYPE_CHECKING, Any

from tmodes.io.printed import Table, plain

if TYPE_CHECKING:
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


def run_tables(result: Result, band: str | float | None = None, *, ended: bool = True) -> Iterator[str | Table]:
    """What a run has shown: its numbers, how it ended (``ended``), its events, its steps and its errors.

    ``band``: within which the tip counts as settled.
    """
    from tmodes.result.events import counted

    summary = result.summary(band)
    columns = ["quantity", "value", "error", "model error", "where"]
    rows = list(summary_rows(summary))
    if not (summary["model_error"] or {}).get("figures"):
        columns, rows = [name for name in columns if name != "model error"], [(*row[:3], row[4]) for row in rows]
    yield Table(f"{result.name}: {result.status}", columns, rows)
    if ended:
        yield f"end     {plain(result.message)}"
    if events := result.events:
        yield f"events  {len(events):,}: {counted(events)} (tmodes show --events)"
    yield from integration_lines(result, summary)


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

    subject, point = _subject(summary), summary["point"]
    if point["reason"]:
        yield "errors measured at", "-", "", "", point["name"] or point["reason"]
    errors, settling = summary["tip_error"], summary["settling"]
    for which, path in _ERRORS.items():
        if which in errors:
            yield _tip_error(summary, which, path)
            yield from _elements(which, errors[which])
    if errors:
        ends = [f"{one['end_m'] * 1e3:.4g} mm to {which}" for which, one in errors.items()]
        yield (
            f"{subject} at the end",
            ends[0].partition(" to ")[0],
            "",
            "",
            "to commanded" + "".join(f"; {e}" for e in ends[1:]),
        )
    elif deviation := summary["deviation"]:
        when = f"t = {deviation['time_of_max_s']:.3f} s"
        yield _row(summary, "deviation.max_m", f"{subject} to nominal", deviation["max_m"], "mm", when, 1e3)
        yield _row(summary, "deviation.end_m", f"{subject} at the end", deviation["end_m"], "mm", "to nominal", 1e3)
    time = "-" if settling["time_s"] is None else f"{settling['time_s']:.3f} s"
    yield "settling after the move", time, "", "", settling_words(settling, in_mm)
    for which, one in summary["vibration"].items():
        value = "-" if one["amplitude_m"] is None else f"{one['amplitude_m'] * 1e3:.4g} mm"
        yield f"residual vibration, {which}", value, "", "", vibration_words(one, in_mm)


_ERRORS = {"commanded": "tip_error.commanded.max_m", "nominal": "deviation.max_m"}
"""Paths from which the tip's error is measured, and where the uncertainty of the largest one is."""


def _subject(summary: dict[str, Any]) -> str:
    """Whose error it is."""
    return "tip error" if not summary["point"]["reason"] else "error"


def _tip_error(summary: dict[str, Any], which: str, path: str) -> Row:
    """The largest error, with its parts along it."""
    one = summary["tip_error"][which]
    parts = ", ".join(f"{value * 1e3:.3g} {name}" for name, value in one["parts_m"].items() if value)
    where = f"t = {one['time_of_max_s']:.3f} s"
    if parts:
        where = f"{parts}; {where}"
    return _row(summary, path, f"{_subject(summary)} to {which}", one["max_m"], "mm", where, 1e3)


def _elements(which: str, one: dict[str, Any]) -> Iterator[Row]:
    """The gears and links with the largest parts, where there are several; what of them is by the contact force."""
    from tmodes.result.summary import largest_elements

    elements = largest_elements(one)
    if len(elements) > 1:
        words = ", ".join(f"{value * 1e3:.3g} mm {name}" for name, value in elements)
        yield f"  by element, to {which}", "", "", "", words
    if environment := one.get("environment_m"):
        words = ", ".join(f"{value * 1e3:.3g} mm of {name}" for name, value in environment.items())
        yield f"  by the contact, to {which}", "", "", "", f"{words} (statics with and without it)"


def _largest(info: dict[str, Any], key: str, most: int) -> list[tuple[str, dict[str, Any]]]:
    """At most so many entries, those with the largest sizes of ``key``, in their order."""
    chosen = sorted(info, key=lambda name: -abs(info[name][key]))[:most]
    return [(name, one) for name, one in info.items() if name in chosen]


def _deformations(summary: dict[str, Any]) -> Iterator[Row]:
    for name, one in _largest(summary["deformations"], "max", _MOST_DEFORMATIONS):
        unit, factor = ("", 1.0) if one["unit"] == "1" else (f"m{one['unit']}", 1e3)  # of stretch and shear none
        parts = f"t = {one['time_of_max_s']:.3f} s"
        if "max_stationary" in one:
            parts = f"T_st {one['max_stationary'] * factor:.4g}, T_to {one['max_oscillatory'] * factor:.4g}"
        yield _row(summary, f"deformations.{name}.max", f"largest {name}", one["max"], unit, parts, factor)


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
