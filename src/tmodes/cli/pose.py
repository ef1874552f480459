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
            help="Where the point is wanted [m], and how turned [rad]; `free` for any that does not matter.",
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
            help="Branches near this pose come first, such as shoulder=0.4,elbow=-60deg; else the first commands.",
        ),
    ] = None,
    starts: Annotated[int, typer.Option(help="Number of start poses of the search.")] = 64,
    settings: Settings = None,
    root: Roots = None,
    trust_paths: TrustPaths = False,
    fix_inertia: FixInertia = False,
    as_json: AsJson = False,
) -> None:
    """Inverse kinematics with the sag of gears and links: joint and motor angles of all branches.

    Of the nominal robot, at rest under its weight and loads, in its contact. Branches within the limits come first,
    then stable ones, then those nearest to the first commands. Of a family, as with the tip on the axis of a joint, one
    branch and the joints that continue along it. Of a tip out of reach: the nearest pose, and its distance. Exit
    code 3: it can not be held there, or only in poses that are not stable or beyond a limit.
    """
    from tmodes.interface.inverse import inverse

    sheet = chosen_sheet(robot, settings, roots=root, trust_paths=trust_paths, fix_inertia=fix_inertia)
    with working("preparing") as tell:
        found = inverse(sheet, tip=tip, load=load or (), point=point, near=near, starts=starts, progress=tell)
    print_result(found, as_json)
    if not found.held:
        raise typer.Exit(3)
