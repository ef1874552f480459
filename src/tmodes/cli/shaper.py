"""``tmodes shaper``: copies of a motion, so that the robot does not ring after it."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

import typer

from tmodes.cli.options import AsJson, FixInertia, Roots, Settings, SheetArgument, TrustPaths, chosen_sheet
from tmodes.cli.terminal import print_result, working

__all__ = ["shaper"]


def shaper(
    robot: SheetArgument,
    kind: Annotated[str, typer.Option(help="zv, zvd, zvdd, ei, or one of --use.")] = "zv",
    modes: Annotated[
        list[int] | None, typer.Option(help="Number of a mode, from 1 on by rising frequency; may be given often. [1]")
    ] = None,
    where: Annotated[
        str, typer.Option(help="Modes at the start of the motion, at its end, or path: all along.")
    ] = "start",
    frequency: Annotated[
        list[str] | None, typer.Option(metavar="HZ", help="Natural frequency in place of a mode; may be given often.")
    ] = None,
    damping: Annotated[list[str] | None, typer.Option(help="Damping ratio of each --frequency.")] = None,
    tolerated: Annotated[float | None, typer.Option(help="Vibration that `ei` leaves at its frequency. [0.05]")] = None,
    out: Annotated[
        Path | None, typer.Option(help="A file for the data sheet of the robot with its moves shaped.")
    ] = None,
    figure: Annotated[
        Path | None, typer.Option(help="A file for the residual over detuning: .svg, .png or .pdf.")
    ] = None,
    overwrite: Annotated[bool, typer.Option("--overwrite", help="Replace these files.")] = False,
    settings: Settings = None,
    root: Roots = None,
    trust_paths: TrustPaths = False,
    fix_inertia: FixInertia = False,
    as_json: AsJson = False,
) -> None:
    """Input shaping of the data sheet's motion: residual vibration, and robustness to errors of the frequency.

    The motion of each drive becomes the sum of copies of it, so that the modes that it is made for are at rest after
    the last one; it takes longer by the delay. Modes are those of the nominal robot, under its controllers, or with
    motors locked where it has none, in the pose where the motion starts, ends, or all along it (then for the middle
    between the lowest and the highest frequency).

    Example, robust to an error of the stiffness, and a run with it: tmodes shaper two_link_arm --kind zvd
    --out shaped.yaml; tmodes run shaped.yaml
    """
    from tmodes.interface.shaping import shaper as found_of

    sheet = chosen_sheet(robot, settings, roots=root, trust_paths=trust_paths, fix_inertia=fix_inertia)
    chosen: Any = where
    with working("preparing") as tell:
        found = found_of(
            sheet, kind=kind, modes=modes or (1,), where=chosen, frequency=frequency or (), damping=damping or (),
            tolerated=tolerated, out=out, figure=figure, overwrite=overwrite, progress=tell,
        )  # fmt: skip
    print_result(found, as_json)
