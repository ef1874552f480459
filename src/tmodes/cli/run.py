"""``tmodes run``: the main job. A robot in; a result file and one self-contained report out."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from tmodes.cli import options
from tmodes.cli.options import chosen_robot
from tmodes.cli.terminal import TIMES, notice, print_json, print_parts, print_table, terminal_columns, warn, working
from tmodes.errors import SimulationError

if TYPE_CHECKING:
    from tmodes.io.urdf import UrdfRobot
    from tmodes.report.folder import RunFolder
    from tmodes.sheet import Robot

__all__ = ["folder_name", "run"]


def run(
    robot: options.SheetArgument,
    reading: options.ReadingOption = None,
    contact: options.Contact = None,
    settings: options.Settings = None,
    integrator: options.IntegratorOption = None,
    rtol: options.Tolerance = None,
    atol: options.AbsoluteTolerance = None,
    check_error: options.CheckError = False,
    error_estimate: options.ErrorEstimate = True,
    model_error: options.ModelError = True,
    duration: options.Duration = None,
    stop: options.Stop = None,
    stop_at_limits: options.StopAtLimits = False,
    settling_band: options.SettlingBand = None,
    root: options.Roots = None,
    trust_paths: options.TrustPaths = False,
    fix_inertia: options.FixInertia = False,
    out: Annotated[Path | None, typer.Option(help="Folder for the output; else results/NAME.")] = None,
    overwrite: Annotated[bool, typer.Option("--overwrite", help="Replace a result that is there.")] = False,
    report: Annotated[bool, typer.Option("--report/--no-report", help="Write report.html, or the data only.")] = True,
    figures: Annotated[
        bool, typer.Option("--figures", help="Also draw the figures for print; later: tmodes figures RESULT.")
    ] = False,
    live: Annotated[
        bool,
        typer.Option("--live/--no-live", help="Let the report simulate again; compiling takes some seconds, once."),
    ] = True,
    open_page: Annotated[bool, typer.Option("--open", help="Open the report in the browser.")] = False,
    everything: Annotated[bool, typer.Option("--all", help="All numbers, with their errors and model errors.")] = False,
    timing: Annotated[bool, typer.Option("--timing", help="Say where the time went, here and in the report.")] = False,
    as_json: options.AsJson = False,
) -> None:
    """Plan with the nominal robot, run the actual one under control, and show how it bends.

    Writes result.nc (NetCDF, all series with units) and report.html (open it first); with --figures also figures/*.svg
    and *.png. An interrupted run resumes when the same command is given again. A robot needs `drives`, or an `initial`
    state from which it moves freely.

    Example, a high-accuracy run with an error estimate: tmodes run spong1987 --integrator dop853 --rtol 1e-11
    --atol 1e-14 --check-error
    """
    from tmodes.interface.integration import run_changes
    from tmodes.io.sheet_plausible import notices_about

    changes = run_changes(
        integrator=integrator, rtol=rtol, atol=atol, check_error=check_error, error_estimate=error_estimate,
        model_error=model_error, duration=duration, stop=stop, stop_at_limits=stop_at_limits,
        settling_band=settling_band,
    )  # fmt: skip
    with working() as progress:
        progress("reading", 0.0)
        sheet, urdf = chosen_robot(
            robot, settings, reading, contact, roots=root, trust_paths=trust_paths, fix_inertia=fix_inertia,
            changes=changes,
        )  # fmt: skip
        sheet = sheet.commanded(progress)
        place = out or Path("results") / folder_name(sheet.name)
        folder = _folder(place, sheet, overwrite, urdf, live=live, spent=progress.spent if timing else None)
        with folder:
            if folder.continues:
                notice(f"continuing what was begun in {folder.path}")
            try:
                result = folder.simulate(progress)
            except SimulationError:
                warn(notices_about(sheet))  # a wrong unit is the likely cause
                raise
            fault = folder.products(result, progress, report=report, figures=figures)
    _say(result, folder, as_json, progress.spent if timing else {}, everything=everything)
    if fault:
        raise fault
    if open_page and folder.report_file.exists():
        from tmodes.cli.show import opened

        opened(folder.report_file)
    if folder.is_unfinished(result):
        raise typer.Exit(130)
    if not result.success:
        raise typer.Exit(3)


def _folder(
    path: Path,
    sheet: Robot,
    overwrite: bool,
    urdf: UrdfRobot | None,
    *,
    live: bool,
    spent: Mapping[str, list[float]] | None,
) -> RunFolder:
    from tmodes.report.folder import RunFolder
    from tmodes.report.meshes import shapes_of

    shapes, notices = shapes_of(urdf)
    for text in notices:
        notice(f"notice: {text}")
    return RunFolder(path, sheet, overwrite, shapes, live=live, spent=spent)


def _say(result: Any, folder: RunFolder, as_json: bool, spent: Mapping[str, list[float]], *, everything: bool) -> None:
    from tmodes.interface.summary import COLUMNS, result_record, run_tables

    if as_json:
        timing = {"files": folder.written(), "seconds_per_simulated_second": result.timing}
        if spent:
            timing["stages_s"] = {stage: dict(zip(TIMES, times, strict=True)) for stage, times in spent.items()}
        print_json(result_record(result) | timing)
    else:
        more = f"tmodes show {folder.path} --all"
        parts = run_tables(result, everything=everything, more=more, columns=terminal_columns() or COLUMNS)
        print_parts(parts, None if everything else COLUMNS)
        print(f"open    {folder.report_file}" if folder.report_file.exists() else "no report was written")
        print(f"data    {folder.result_file}")
        if spent:
            rows = [[stage, *(f"{time:.2f}" for time in times)] for stage, times in spent.items()]
            print_table("where the time went", ["stage", *(f"{name} [s]" for name in TIMES)], rows)
    warn(result.warnings)
    if result.status != "finished":
        from tmodes.result.verdict import end_words

        notice(f"tmodes: {end_words(result.message)}")


def folder_name(name: str) -> str:
    """A name that is safe as a folder, whatever the robot is called."""
    safe = "".join(letter if letter.isalnum() or letter in "-_." else "_" for letter in name).strip(".")
    return safe[:80] or "robot"
