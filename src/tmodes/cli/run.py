"""``tmodes run``: the main job. A robot in, a result file, figures and one self-contained report out."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from tmodes.cli.options import AsJson, Contact, ReadingOption, RobotArgument, Settings, chosen_robot

__all__ = ["run"]


def run(
    robot: RobotArgument,
    reading: ReadingOption = None,
    contact: Contact = None,
    settings: Settings = None,
    out: Annotated[Path | None, typer.Option(help="Folder for the output; else results/NAME.")] = None,
    overwrite: Annotated[bool, typer.Option("--overwrite", help="Replace a result that is there.")] = False,
    figures: Annotated[
        bool, typer.Option("--figures/--no-figures", help="Figures and report, or the data only.")
    ] = True,
    as_json: AsJson = False,
) -> None:
    """Plan with the robot as known, run the real one under control, and show how it bends.

    Writes result.nc (NetCDF, all series with units), report.html (open it first) and figures/*.svg, *.png. A run that
    was killed goes on where it was when the same command is given again.
    """
    from tmodes.cli.interrupt import heard
    from tmodes.cli.output import notice, print_json
    from tmodes.cli.progress import Stages
    from tmodes.cli.told import told
    from tmodes.errors import SimulationError
    from tmodes.io.plausible import implausible
    from tmodes.runs import RunFolder

    sheet = chosen_robot(robot, settings, reading, contact)
    folder = RunFolder(out or Path("results") / _folder_name(sheet.name), sheet, overwrite)
    with heard() as wish, folder, Stages(wish) as progress:
        if folder.continues:
            notice(f"continuing what was begun in {folder.path}")
        try:
            result = folder.simulate(progress)
        except SimulationError:
            for doubt in implausible(sheet):  # a wrong unit is the likely cause
                notice(f"warning: {doubt}")
            raise
        if figures and result.status != "interrupted":
            folder.illustrate(result, progress)
    print_json(folder.summary(result)) if as_json else told(result, folder)
    for warning in result.warnings:
        notice(f"warning: {warning}")
    if not result.success:
        notice(f"tmodes: {result.message}")
        raise typer.Exit(130 if result.status == "interrupted" else 3)


def _folder_name(name: str) -> str:
    """A name that is safe as a folder, whatever the robot is called."""
    safe = "".join(letter if letter.isalnum() or letter in "-_." else "_" for letter in name).strip(".")
    return safe[:80] or "robot"
