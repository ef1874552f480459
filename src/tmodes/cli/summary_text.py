"""What a finished run says on the terminal: the numbers that a reader asks first, its steps, and where to look."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from tmodes.cli.terminal import print_table

if TYPE_CHECKING:
    from tmodes.report.folder import RunFolder
    from tmodes.result import Result

__all__ = ["error_of", "integration_lines", "print_run", "print_summary", "summary_rows"]


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


_MOST_JOINTS = 8
_MOST_DEFORMATIONS = 8


def print_run(result: Result, folder: RunFolder) -> None:
    """Print the summary of a run as a table, and the files to open."""
    summary = print_summary(result)
    if result.status == "finished":  # any other ending is reported with the errors
        print(f"end     {result.message}")
    for line in integration_lines(result, summary):
        print(line)
    print(f"open    {folder.report_file}" if folder.report_file.exists() else "no report was written")
    print(f"data    {folder.result_file}")


def print_summary(result: Result) -> dict[str, Any]:
    """Print the summary of a result as a table, and give it back."""
    summary = result.summary()
    columns = ["quantity", "value", "error", "where"]
    print_table(f"{result.name}: {result.status}", columns, list(summary_rows(summary)))
    return summary


def summary_rows(summary: dict[str, Any]) -> Iterator[tuple[str, str, str, str]]:
    """Rows of quantity, value, error, where and when; of many joints and deformations the largest ones."""
    yield from _tip(summary)
    yield from _deformations(summary)
    for name, link in summary["links"].items():
        yield from _link(name, link, summary)
    yield from _efforts(summary)
    force = summary["contact_force"]
    if force:
        error = error_of(summary, "contact_force.max_N", 1.0, "N")
        value = f"{force['min_N']:.3f} ... {force['max_N']:.3f} N"
        yield "contact force", value, error, f"mean {force['mean_N']:.3f} N"
    energy = summary["energy"]
    yield "energy balance", f"{energy['worst_residual_J']:.1e} J", "", f"of {energy['moved_J']:.3g} J moved"


def _tip(summary: dict[str, Any]) -> Iterator[tuple[str, str, str, str]]:
    deviation, settling = summary["deviation"], summary["settling"]
    if deviation is None:
        return
    errors = [error_of(summary, f"deviation.{key}", 1e3, "mm") for key in ("max_m", "end_m")]
    when = f"t = {deviation['time_of_max_s']:.3f} s"
    yield "largest tip deviation", f"{deviation['max_m'] * 1e3:.4g} mm", errors[0], when
    yield "tip deviation at the end", f"{deviation['end_m'] * 1e3:.4g} mm", errors[1], ""
    if settling["time_s"] is not None:
        limit = f"within {settling['limit_m'] * 1e3:.3g} mm"
        yield "settling after the move", f"{settling['time_s']:.3f} s", "", limit


def _deformations(summary: dict[str, Any]) -> Iterator[tuple[str, str, str, str]]:
    info = summary["deformations"]
    largest = sorted(info, key=lambda name: -info[name]["max"])[:_MOST_DEFORMATIONS]
    for name in (name for name in info if name in largest):
        one = info[name]
        unit = "1e-3" if one["unit"] == "1" else f"m{one['unit']}"
        parts = f"T_st {one['max_stationary'] * 1e3:.4g}, T_to {one['max_oscillatory'] * 1e3:.4g}"
        error = error_of(summary, f"deformations.{name}.max", 1e3, unit)
        yield f"largest {name}", f"{one['max'] * 1e3:.4g} {unit}", error, parts


def _link(name: str, link: dict[str, Any], summary: dict[str, Any]) -> Iterator[tuple[str, str, str, str]]:
    bent, moment, stress = link["deflection"], link["bending_moment"], link["stress"]
    error = error_of(summary, f"links.{name}.deflection.max_m", 1e3, "mm")
    yield f"deflection of {name}", f"{bent['max_m'] * 1e3:.4g} mm", error, f"t = {bent['time_s']:.3f} s"
    place = f"s = {moment['s']:.2f}, t = {moment['time_s']:.3f} s"
    error = error_of(summary, f"links.{name}.bending_moment.max_Nm", 1.0, "N m")
    yield f"bending moment of {name}", f"{moment['max_Nm']:.4g} N m", error, place
    if stress:
        place = f"s = {stress['s']:.2f}, t = {stress['time_s']:.3f} s"
        error = error_of(summary, f"links.{name}.stress.max_Pa", 1e-6, "MPa")
        yield f"stress of {name}", f"{stress['max_Pa'] / 1e6:.4g} MPa", error, place


def _efforts(summary: dict[str, Any]) -> Iterator[tuple[str, str, str, str]]:
    info = summary["joints"]
    largest = sorted(info, key=lambda name: -abs(info[name]["largest_effort"]))[:_MOST_JOINTS]
    for name in (name for name in info if name in largest):
        one = info[name]
        unit = "N" if one["unit"] == "m" else "N m"
        error = error_of(summary, f"joints.{name}.largest_effort", 1.0, unit)
        yield (
            f"effort of {name}",
            f"{one['largest_effort']:.4g} {unit}",
            error,
            f"t = {one['time_of_largest_effort_s']:.3f} s",
        )
