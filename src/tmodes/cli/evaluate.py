"""``tmodes eval``: all terms of the equations at given states, to compare with another program."""

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
            help="JSON file: a list of records with q, v and effort, lists or numbers by name; or a .csv with columns "
            "NAME, NAME.rate, effort.JOINT; of a sheet of the 2010 robot also phi (6), phid (6) and u."
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
    """Mass matrix, bias, forces, accelerations, points, Jacobians and energies at given states.

    M a + h + f_el = effort, free of contact and loads, with gravity g, points, Jacobians, energies, losses; SI units.

    Of a sheet of the 2010 robot, with records of phi, phid and u: H phidd + h + f_el + f_di + J^T F = Q in its
    coordinates q, delta, gamma, vt, e, theta; u is the motor's voltage; h holds gravity; H is without the
    environment's mass (phidd has it); F acts by the tip.
    """
    from tmodes.cli.evaluate_chain import evaluate_arm
    from tmodes.cli.output import print_json_list
    from tmodes.errors import InputError
    from tmodes.io.states import holds_phi, read_states

    sheet = chosen_sheet(robot, settings, reading, roots=root, trust_paths=trust_paths)
    if sheet.imported and holds_phi(states):
        from tmodes.cli.evaluate_phi import evaluate_phi

        pair = sheet.with_({"contact": contact}).pair()
        answers = evaluate_phi(pair.nominal if nominal else pair.real, read_states(states))
        print_json_list(iter(answers)) if as_json else _print(answers)
        return
    if contact:
        expected, hint = (
            "left out: its terms are those in free space",
            "evaluate a sheet of the 2010 robot, or leave it out",
        )
        raise InputError("--contact", f"the robot {sheet.name}", expected, hint)
    pair = sheet.pair()
    evaluate_arm(pair.nominal if nominal else pair.real, states, as_json=as_json)


def _print(answers: list[dict[str, Any]]) -> None:
    from tmodes.cli.evaluate_phi import COORDINATES
    from tmodes.cli.output import print_table

    accelerations = [[str(k), *(f"{x:.6g}" for x in one["phidd"])] for k, one in enumerate(answers)]
    print_table("Accelerations [rad/s^2]", ["state", *COORDINATES], accelerations)
    names = ("kinetic", "potential_gravity", "potential_elastic", "rayleigh", "energy")
    energies = [[str(k), *(f"{one[name]:.6g}" for name in names)] for k, one in enumerate(answers)]
    print_table("Energies [J], Rayleigh function [W]", ["state", *names], energies)
    print("All terms (H, h, f_el, f_di, Q, J, tip, forces): add --json")
