"""``tmodes outputs``: every number of an instant of a robot's run that has a name, with its unit and meaning."""

from __future__ import annotations

from tmodes.cli.options import AsJson, FixInertia, Roots, Settings, SheetArgument, TrustPaths, chosen_sheet
from tmodes.cli.terminal import print_json, print_table

__all__ = ["outputs"]


def outputs(
    robot: SheetArgument,
    settings: Settings = None,
    root: Roots = None,
    trust_paths: TrustPaths = False,
    fix_inertia: FixInertia = False,
    as_json: AsJson = False,
) -> None:
    """Names, units and meaning of all outputs: for stop conditions, studies, gradients, and result.output(NAME).

    Names that end on @S are of any station S along a link, from 0, its root, to 1, its tip: forearm.moment.y@0.5.
    """
    from tmodes.simulation.outputs import robot_outputs

    sheet = chosen_sheet(robot, settings, roots=root, trust_paths=trust_paths, fix_inertia=fix_inertia)
    rows = robot_outputs(sheet).rows
    if as_json:
        print_json([dict(zip(("name", "unit", "meaning"), row, strict=True)) for row in rows])
        return
    print_table(f"Outputs of {sheet.name}", ["name", "unit", "meaning"], rows)
