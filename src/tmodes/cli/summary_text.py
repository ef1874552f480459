"""What a finished run says on the terminal: the numbers that a reader asks first, and where to look."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from tmodes.report.folder import RunFolder
    from tmodes.result import Result
    from tmodes.result.record import PaperResult

__all__ = ["info", "info_summary"]


def info(result: PaperResult | Result, folder: RunFolder) -> None:
    """Print the summary of a run as a table, and the files to open."""
    from tmodes.cli.integration_text import integration_lines

    summary = info_summary(result)
    if result.status == "finished":  # any other ending is told apart, where errors are
        print(f"end     {result.message}")
    for line in integration_lines(result, summary):
        print(line)
    print(f"open    {folder.report_file}" if folder.report_file.exists() else "no report was written")
    print(f"data    {folder.result_file}")


def info_summary(result: PaperResult | Result) -> dict[str, Any]:
    """Print the summary of a result as a table, and give it back."""
    from tmodes.cli.output import print_table
    from tmodes.cli.summary_motion import arm_rows
    from tmodes.result import Result

    summary = result.summary()
    if isinstance(result, Result):
        title, rows = f"{result.arm.name}: {result.status}", arm_rows(summary)
    else:
        title, rows = f"{result.robot.name}: {result.status} ({result.data.attrs['reading']} reading)", _rows(summary)
    print_table(title, ["quantity", "value", "error", "where"], list(rows))
    return summary


def _rows(summary: dict[str, Any]) -> Any:
    from tmodes.cli.integration_text import error_of

    deviation, moment, energy = summary["deviation"], summary["largest_bending_moment"], summary["energy"]
    errors = [error_of(summary, f"deviation.{key}", 1e3, "mm") for key in ("max_m", "end_m")]
    when = f"t = {deviation['time_of_max_s']:.3f} s"
    yield "largest tip deviation", f"{deviation['max_m'] * 1e3:.3f} mm", errors[0], when
    yield "tip deviation at the end", f"{deviation['end_m'] * 1e3:.3f} mm", errors[1], ""
    for name, angle in summary["deformations"].items():
        value, error = (
            f"{angle['max_rad'] * 1e3:.3f} mrad",
            error_of(summary, f"deformations.{name}.max_rad", 1e3, "mrad"),
        )
        yield f"largest {name}", value, error, f"reference {angle['max_reference_rad'] * 1e3:.3f} mrad"
    place = f"{moment['mode']}, {moment['plane']}, s = {moment['s']:.2f}, t = {moment['time_s']:.3f} s"
    error = error_of(summary, "largest_bending_moment.value_Nm", 1.0, "N m")
    yield "largest bending moment", f"{moment['value_Nm']:.3f} N m", error, place
    force = summary["contact_force_radial"]
    if force:
        error = error_of(summary, "contact_force_radial.max_N", 1.0, "N")
        value = f"{force['min_N']:.3f} ... {force['max_N']:.3f} N"
        yield "radial contact force", value, error, f"mean {force['mean_N']:.3f} N"
    yield "energy balance", f"{energy['worst_residual_J']:.1e} J", "", f"of {energy['moved_J']:.3g} J moved"
