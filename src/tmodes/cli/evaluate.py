"""``tmodes eval``: all terms of the equations at given states: the door for a comparison with another program."""

from __future__ import annotations

from typing import Annotated, Any

import typer

from tmodes.cli.options import AsJson, ReadingOption, Roots, Settings, SheetArgument, TrustPaths, chosen_sheet

__all__ = ["evaluate"]


def evaluate(
    robot: SheetArgument,
    states: Annotated[
        str,
        typer.Option(
            help="JSON file: a list of records with phi (6), phid (6) and u; of an arm with q, v and effort, lists or "
            "numbers by name; or of an arm a .csv with columns NAME, NAME.rate, effort.JOINT."
        ),
    ],
    reading: ReadingOption = None,
    contact: Annotated[bool, typer.Option("--contact", help="With the tip on the environment.")] = False,
    nominal: Annotated[bool, typer.Option("--nominal", help="The robot as known, not the real one.")] = False,
    settings: Settings = None,
    root: Roots = None,
    trust_paths: TrustPaths = False,
    as_json: AsJson = False,
) -> None:
    """Mass matrix, bias, forces, accelerations, tip, Jacobian and energies at given states.

    Of H phidd + h + f_el + f_di + J^T F = Q: SI units, coordinates q, delta, gamma, vt, e, theta; the real robot; u is
    the motor's voltage; h holds gravity; H is without the environment's mass (phidd has it); F acts by the tip.

    Of an arm M a + h + f_el = effort, free of contact and loads, with gravity g, points, Jacobians, energies, losses.
    """
    from tmodes.cli.evaluate_chain import evaluate_arm
    from tmodes.cli.output import print_json_list
    from tmodes.errors import InputError
    from tmodes.io.states import read_states
    from tmodes.paper.evaluate import evaluate_states
    from tmodes.sheet import Robot

    sheet = chosen_sheet(robot, settings, reading, contact or None, roots=root, trust_paths=trust_paths)
    if isinstance(sheet, Robot):
        if contact:
            raise InputError("--contact", "an arm", "no contact: its terms are those in free space", "leave it out")
        pair = sheet.pair()
        evaluate_arm(pair.nominal if nominal else pair.real, states, as_json=as_json)
        return
    pair = (sheet if contact else sheet.with_({"contact": False})).pair()
    records = read_states(states)
    answers = evaluate_states(pair.nominal if nominal else pair.real, records)
    if as_json:
        print_json_list(answers)
    else:
        _print(list(answers))


def _print(answers: list[dict[str, Any]]) -> None:
    from tmodes.cli.output import print_table
    from tmodes.equations.lagrange.layout import COORDINATES

    accelerations = [[str(k), *(f"{x:.6g}" for x in one["phidd"])] for k, one in enumerate(answers)]
    print_table("Accelerations [rad/s^2]", ["state", *COORDINATES], accelerations)
    names = ("kinetic", "potential_gravity", "potential_elastic", "rayleigh", "energy")
    energies = [[str(k), *(f"{one[name]:.6g}" for name in names)] for k, one in enumerate(answers)]
    print_table("Energies [J], Rayleigh function [W]", ["state", *names], energies)
    print("All terms (H, h, f_el, f_di, Q, J, tip, forces): add --json")
