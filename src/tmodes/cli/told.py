"""What a finished run says on the terminal: the numbers that a reader asks first, and where to look."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from tmodes.arm_result import ArmResult
    from tmodes.result import Result
    from tmodes.runs import RunFolder

__all__ = ["told"]


def told(result: Result | ArmResult, folder: RunFolder) -> None:
    """Print the summary of a run as a table, and the files to open."""
    from tmodes.arm_result import ArmResult
    from tmodes.cli.arm_told import arm_rows
    from tmodes.cli.output import print_table

    summary = result.summary()
    if isinstance(result, ArmResult):
        title, rows = f"{result.arm.name}: {result.status}", arm_rows(summary)
    else:
        title, rows = f"{result.robot.name}: {result.status} ({result.data.attrs['reading']} reading)", _rows(summary)
    print_table(title, ["quantity", "value", "where"], list(rows))
    print(f"open    {folder.report_file}" if folder.report_file.exists() else "no report was written")
    print(f"data    {folder.result_file}")


def _rows(summary: dict[str, Any]) -> Any:
    deviation, moment, energy = summary["deviation"], summary["largest_bending_moment"], summary["energy"]
    yield "largest tip deviation", f"{deviation['max_m'] * 1e3:.3f} mm", f"t = {deviation['time_of_max_s']:.3f} s"
    yield "tip deviation at the end", f"{deviation['end_m'] * 1e3:.3f} mm", ""
    for name, angle in summary["deformations"].items():
        value = f"{angle['max_rad'] * 1e3:.3f} mrad"
        yield f"largest {name}", value, f"reference {angle['max_reference_rad'] * 1e3:.3f} mrad"
    place = f"{moment['mode']}, {moment['plane']}, s = {moment['s']:.2f}, t = {moment['time_s']:.3f} s"
    yield "largest bending moment", f"{moment['value_Nm']:.3f} N m", place
    force = summary["contact_force_radial"]
    if force:
        yield (
            "radial contact force",
            f"{force['min_N']:.3f} ... {force['max_N']:.3f} N",
            f"mean {force['mean_N']:.3f} N",
        )
    yield "energy balance", f"{energy['worst_residual_J']:.1e} J", f"of {energy['moved_J']:.3g} J moved"
