"""``tmodes pose``: joint and motor angles that hold the tip where it is wanted, the robot bent as it is."""

from __future__ import annotations

from typing import Annotated

import typer

from tmodes.cli.options import AsJson, FixInertia, Roots, Settings, SheetArgument, TrustPaths, chosen_sheet
from tmodes.cli.terminal import print_result, working

__all__ = ["pose"]


def pose(
    robot: SheetArgument,
    tip: Annotated[
        str,
        typer.Option(
            metavar="X,Y,Z[,ROLL,PITCH,YAW]",
            help="Where the point is wanted [m], `free` for an axis that does not matter, and how turned [rad].",
        ),
    ],
    load: Annotated[
        list[str] | None,
        typer.Option(metavar="KEY=VALUE,...", help="A load, such as point=tip,force=0,0,-10; may be given often."),
    ] = None,
    point: Annotated[str, typer.Option(help="The point that is wanted there.")] = "tip",
    near: Annotated[
        str | None,
        typer.Option(
            metavar="JOINT=VALUE,...",
            help="The pose from which motion counts, such as shoulder=0.4,elbow=-60deg; else the first commands.",
        ),
    ] = None,
    starts: Annotated[int, typer.Option(help="Poses from which it is sought.")] = 64,
    settings: Settings = None,
    root: Roots = None,
    trust_paths: TrustPaths = False,
    fix_inertia: FixInertia = False,
    as_json: AsJson = False,
) -> None:
    """Joint and motor angles that hold the tip where it is wanted, sag of gears and links included: all branches.

    Of the nominal robot, at rest under its weight and loads, in its contact. Branches within the limits come first,
    then stable ones, then those nearest to the first commands. A tip that can not be there: the nearest pose, and how
    far it is off.
    """
    from tmodes.interface.inverse import inverse

    sheet = chosen_sheet(robot, settings, roots=root, trust_paths=trust_paths, fix_inertia=fix_inertia)
    with working("preparing") as tell:
        found = inverse(sheet, tip=tip, load=load or (), point=point, near=near, starts=starts, progress=tell)
    print_result(found, as_json)
