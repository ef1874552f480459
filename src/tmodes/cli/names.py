"""``tmodes outputs`` and ``tmodes parameters``: what of a robot has a name, to be asked for or to be varied."""

from __future__ import annotations

import math

from tmodes.cli.options import AsJson, FixInertia, Roots, Settings, SheetArgument, TrustPaths, chosen_sheet
from tmodes.cli.terminal import print_json, print_table

__all__ = ["outputs", "parameters"]


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


def parameters(
    robot: SheetArgument,
    settings: Settings = None,
    root: Roots = None,
    trust_paths: TrustPaths = False,
    fix_inertia: FixInertia = False,
    as_json: AsJson = False,
) -> None:
    """Every number of a data sheet: path, value, unit, bounds, and the numbers of a run that it enters.

    Parameters marked as structure (a count, a rigid stiffness, a sample time) change the compiled code: cases of a
    batch that differ in them are compiled apart. All others vary in one batch, study or gradient, alone or together.
    """
    from tmodes.simulation.vary.parameters import parameters_of

    sheet = chosen_sheet(robot, settings, roots=root, trust_paths=trust_paths, fix_inertia=fix_inertia)
    found = parameters_of(sheet)
    if as_json:
        print_json(
            [one._asdict() | {key: _plain(getattr(one, key)) for key in ("value", "low", "high")} for one in found]
        )
        return
    table = found.table()
    print_table(f"Parameters of {sheet.name}", table.columns, table.rows)


def _plain(value: float) -> float | None:
    """As JSON has it: a number, or none for a bound that is not there and a value without end."""
    return value if math.isfinite(value) else None
