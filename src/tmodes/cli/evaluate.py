"""``tmodes eval``: all terms of the equations at given states, to compare with another program."""

from __future__ import annotations

from typing import Annotated

import typer

from tmodes.cli.options import (
    AsJson,
    FixInertia,
    ReadingOption,
    Roots,
    Settings,
    SheetArgument,
    TrustPaths,
    chosen_sheet,
)
from tmodes.cli.terminal import print_json_list, print_result, working

__all__ = ["evaluate"]


def evaluate(
    robot: SheetArgument,
    states: Annotated[
        str,
        typer.Option(
            help="JSON file: a list of records with q, v and effort, lists or numbers by name; or a .csv with columns "
            "NAME, NAME.rate, effort.JOINT; of a sheet of the 2010 robot also phi (6), phid (6) and u."
        ),
    ],
    reading: ReadingOption = None,
    contact: Annotated[bool, typer.Option("--contact", help="With the tip on the environment.")] = False,
    nominal: Annotated[bool, typer.Option("--nominal", help="The nominal robot, not the actual one.")] = False,
    settings: Settings = None,
    root: Roots = None,
    trust_paths: TrustPaths = False,
    fix_inertia: FixInertia = False,
    as_json: AsJson = False,
) -> None:
    """Mass matrix, bias, forces, accelerations, points, Jacobians and energies at given states.

    M a + h + f_el = effort, free of contact and loads, with gravity g, points, Jacobians, energies, losses; SI units.

    Of a sheet of the 2010 robot, with records of phi, phid and u: H phidd + h + f_el + f_di + J^T F = Q in its
    coordinates q, delta, gamma, vt, e, theta; u is the motor's voltage; h holds gravity; H is without the
    environment's mass (phidd has it); F acts by the tip.
    """
    from tmodes.interface.checks import evaluate as found_of

    sheet = chosen_sheet(robot, settings, reading, roots=root, trust_paths=trust_paths, fix_inertia=fix_inertia)
    with working("evaluating", at_once=True):
        found = found_of(sheet, states, contact=contact, nominal=nominal)
    if found.of_paper and as_json:
        print_json_list(found.answers)
    else:
        print_result(found, as_json)
