"""``tmodes follow``: joint references of a line, an arc, points with rounded corners."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from tmodes.cli.options import AsJson, FixInertia, Roots, Settings, SheetArgument, TrustPaths, chosen_sheet
from tmodes.cli.terminal import print_result, working
from tmodes.interface.following import PROFILE
from tmodes.sheet.task import ReferenceKind

__all__ = ["follow"]

_PROFILE = f"{{{', '.join(f'{key}: {value}' for key, value in PROFILE.items())}}}"


def follow(
    robot: SheetArgument,
    path: Annotated[
        list[str] | None,
        typer.Option(
            metavar="GROUP", help="Such as '{type: line, to: [0.6, 0, 0.2]}' [m]; several follow one another."
        ),
    ] = None,
    profile: Annotated[
        str | None,
        typer.Option(
            metavar="GROUP",
            help="Speed profile along the path, a signal without start and end: s_curve, quintic, polynomial, ..., or "
            "a timing within the limits of the rigid robot's joints: '{type: jerk_limited, jerk: 100}', an S-curve, or "
            "'{type: toppra}', the least time. "
            f"By default {_PROFILE}, for `inverse` and `optimal` a polynomial as gentle.",
        ),
    ] = None,
    reference: Annotated[
        ReferenceKind | None,
        typer.Option(
            metavar="KIND",
            help="Setpoints of motors: rigid (joints of the rigid robot, the default), motors (with the "
            "efforts that this takes), sag (tip on the path at rest), quasi_static (tip on the path as weight and the "
            "inertia of the motion bend the robot), inverse (tip on the path as the robot bends and moves), optimal "
            "(no swing at the end, within the limits, near the path).",
        ),
    ] = None,
    least_time: Annotated[
        bool | None,
        typer.Option("--least-time/--own-time", help="As fast as limits of speed and effort allow, with this profile."),
    ] = None,
    shaper: Annotated[
        str | None,
        typer.Option(
            metavar="GROUP",
            help="Shape the way along the path: '{type: zvd}' for the first mode there, or with `frequencies` [Hz].",
        ),
    ] = None,
    fit: Annotated[
        float | None,
        typer.Option(metavar="LENGTH", help="Path error of the rigid robot's tip between rows [m, rad]; else 1e-7."),
    ] = None,
    out: Annotated[Path | None, typer.Option(help="A file for the data sheet of the robot that follows.")] = None,
    figure: Annotated[Path | None, typer.Option(help="A file for the references: .svg, .png or .pdf.")] = None,
    overwrite: Annotated[bool, typer.Option("--overwrite", help="Replace these files.")] = False,
    settings: Settings = None,
    root: Roots = None,
    trust_paths: TrustPaths = False,
    fix_inertia: FixInertia = False,
    as_json: AsJson = False,
) -> None:
    """References of motors for a path of the tip, by the rigid or the elastic robot, each with its error.

    The options from --path to --fit are keys of `task` in the sheet, and go before what it says:

    task: {path: {type: line, to: [0.7, 0, 0.2]}, profile: {type: s_curve, speed: 0.5, acceleration: 3, jerk: 60},
    reference: sag}

    With it `tmodes follow FILE` needs no option, and `tmodes run FILE` follows the same references. They start where
    the first commands of the drives put the robot; each path goes from rest to rest by the profile. Kinds of paths:
    line (to), arc (through, to), via (points, blend), turn (rpy), joints (points, blend); line, arc and via with rpy
    turn the tip on the shortest way.

    Example: tmodes follow two_link_arm --path '{type: line, to: [0.7, 0, 0.2]}' --out line.yaml; tmodes run line.yaml
    """
    from tmodes.interface.following import follow as found_of

    sheet = chosen_sheet(robot, settings, roots=root, trust_paths=trust_paths, fix_inertia=fix_inertia)
    with working("preparing") as tell:
        found = found_of(
            sheet, path, profile=profile, reference=reference, least_time=least_time, shaper=shaper, fit=fit, out=out,
            figure=figure, overwrite=overwrite, progress=tell,
        )  # fmt: skip
    print_result(found, as_json)
