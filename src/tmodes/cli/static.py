"""``tmodes static``: the rest position under weight and loads, and the stiffness there."""

from __future__ import annotations

from typing import Annotated

import typer

from tmodes.cli.options import AsJson, FixInertia, Roots, Settings, SheetArgument, TrustPaths, chosen_sheet
from tmodes.cli.terminal import print_result, working

__all__ = ["PoseOption", "static"]


PoseOption = Annotated[
    str | None,
    typer.Option(
        "--at", metavar="JOINT=VALUE,...",
        help="The pose: joints held there, such as shoulder=0.4,elbow=-60deg; others at their first command.",
    ),
]  # fmt: skip


def static(
    robot: SheetArgument,
    load: Annotated[
        list[str] | None,
        typer.Option(
            metavar="KEY=VALUE,...",
            help="A load, such as point=tip,force=0,0,-10 with the keys point, force, moment and frame: world, or "
            "section, with which it turns along; may be given often.",
        ),
    ] = None,
    force: Annotated[str | None, typer.Option(metavar="X,Y,Z", help="Dead force on the point [N].")] = None,
    moment: Annotated[str | None, typer.Option(metavar="X,Y,Z", help="Dead moment on the point [N*m].")] = None,
    point: Annotated[str, typer.Option(help="The point that is loaded and reported.")] = "tip",
    hold: Annotated[
        list[str] | None,
        typer.Option(
            metavar="COORDINATE=VALUE",
            help="Hold a motor or joint there [rad, m, or 45deg]; a joint behind an elastic gear by its motor.",
        ),
    ] = None,
    at: PoseOption = None,
    settings: Settings = None,
    root: Roots = None,
    trust_paths: TrustPaths = False,
    fix_inertia: FixInertia = False,
    as_json: AsJson = False,
) -> None:
    """Static equilibrium under weight and loads: pose, sag, stability, stiffness at a point, compliance by element.

    The loads are those of the data sheet and those given here; motors stand at their first command. A joint whose drive
    commands an effort, torque or voltage is free, under its first value, unless --hold or --at names it. Of the nominal
    robot where the sheet has an actual one too. Where drives or the base turn at constant speed, about that motion,
    with its centrifugal forces.
    """
    from tmodes.interface.statics import static as found_of

    sheet = chosen_sheet(robot, settings, roots=root, trust_paths=trust_paths, fix_inertia=fix_inertia)
    with working("preparing") as tell:
        found = found_of(
            sheet, load=load or (), force=force, moment=moment, point=point, hold=hold, at=at, progress=tell
        )
    print_result(found, as_json)
