"""``tmodes motion``: torques after which a robot stands still."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from tmodes.cli.options import AsJson, FixInertia, Roots, Settings, SheetArgument, TrustPaths, chosen_sheet
from tmodes.cli.terminal import print_result, working

__all__ = ["motion"]

_PAIRS = "JOINT=VALUE,..."


def motion(
    robot: SheetArgument,
    goal: Annotated[str | None, typer.Option(metavar=_PAIRS, help="Where joints go, such as shoulder=40deg.")] = None,
    start: Annotated[str | None, typer.Option(metavar=_PAIRS, help="From where, at rest.")] = None,
    duration: Annotated[float | None, typer.Option(help="Time of the motion [s].")] = None,
    least_time: Annotated[bool, typer.Option("--least-time", help="The shortest motion within the limits.")] = False,
    method: Annotated[
        str, typer.Option(help="gradients, or collocation: least mean square of the torques, or the least time.")
    ] = "gradients",
    torque: Annotated[str | None, typer.Option(metavar=_PAIRS, help="Limits of the torques [N*m, N].")] = None,
    speed: Annotated[str | None, typer.Option(metavar=_PAIRS, help="Limits of the speeds [rad/s, m/s].")] = None,
    modes: Annotated[int, typer.Option(help="Number of modes whose harmonics the torques contain.")] = 5,
    tolerance: Annotated[float | None, typer.Option(help="Residual vibration of the tip that is accepted [m].")] = None,
    settings: Settings = None,
    root: Roots = None,
    trust_paths: TrustPaths = False,
    fix_inertia: FixInertia = False,
    out: Annotated[
        Path | None, typer.Option(metavar="FILE", help="Write the robot with these torques as a data sheet.")
    ] = None,
    overwrite: Annotated[bool, typer.Option("--overwrite", help="Replace a file that is there.")] = False,
    as_json: AsJson = False,
) -> None:
    """Torques from rest to rest without residual vibration: found by exact derivatives, checked in open loop.

    Of joints behind elastic gears the motors are moved. Start, goal and duration that are left out are those of the
    sheet's drives, limits those of its joints.

    For example:  tmodes motion two_link_arm --duration 0.5 --out still.yaml    then  tmodes run still.yaml
    """
    from tmodes.interface.motions import motion as found_of

    sheet = chosen_sheet(robot, settings, roots=root, trust_paths=trust_paths, fix_inertia=fix_inertia)
    with working("preparing") as tell:
        found = found_of(
            sheet, goal=goal, start=start, duration=duration, least_time=least_time, method=method, torque=torque,
            speed=speed, modes=modes, tolerance=tolerance, out=out, overwrite=overwrite, progress=tell,
        )  # fmt: skip
    print_result(found, as_json)
