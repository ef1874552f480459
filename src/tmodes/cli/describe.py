"""``tmodes describe`` and ``tmodes hierarchy``: a robot in numbers, and the hierarchy of models of its links."""

from __future__ import annotations

from functools import wraps
from typing import Annotated, Any

import typer

from tmodes.cli.options import AsJson, FixInertia, Roots, Settings, SheetArgument, TrustPaths, chosen_sheet
from tmodes.cli.static import PoseOption
from tmodes.cli.terminal import notice, print_result, working

__all__ = ["describe", "hierarchy", "ladder"]


def describe(
    robot: SheetArgument,
    at: PoseOption = None,
    settings: Settings = None,
    root: Roots = None,
    trust_paths: TrustPaths = False,
    fix_inertia: FixInertia = False,
    as_json: AsJson = False,
) -> None:
    """Masses, lengths, stiffnesses, frequencies of each link by itself, sag under weight, stiffness at the tip."""
    from tmodes.interface.description import describe as found_of

    sheet = chosen_sheet(robot, settings, roots=root, trust_paths=trust_paths, fix_inertia=fix_inertia)
    with working("preparing") as tell:
        found = found_of(sheet, at=at, progress=tell)
    print_result(found, as_json)


def hierarchy(
    robot: SheetArgument,
    tolerance: Annotated[float, typer.Option(help="Share of the tip's deflection that a model may be off.")] = 1e-3,
    finest: Annotated[int, typer.Option(min=1, max=12, help="Functions of the finest model, in each direction.")] = 6,
    settings: Settings = None,
    root: Roots = None,
    trust_paths: TrustPaths = False,
    fix_inertia: FixInertia = False,
    as_json: AsJson = False,
) -> None:
    """The hierarchy of link models: rigid, segments, modes, strain with more and more functions, against the finest.

    All of them make the sheet's own motion under its own loads: motors at their setpoints where the drives command
    positions, else as efforts, voltages and controllers move them. A robot that nothing in its sheet moves makes a
    short move of all joints.
    """
    from tmodes.interface.hierarchy import hierarchy as found_of

    sheet = chosen_sheet(robot, settings, roots=root, trust_paths=trust_paths, fix_inertia=fix_inertia)
    with working("preparing") as tell:
        found = found_of(sheet, tolerance=tolerance, finest=finest, progress=tell)
    print_result(found, as_json)


@wraps(hierarchy)
def ladder(**options: Any) -> None:
    """The name that `hierarchy` had."""
    notice("`tmodes ladder` is now called `tmodes hierarchy`")
    hierarchy(**options)
