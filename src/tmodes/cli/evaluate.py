"""``tmodes eval``: all terms of the equations at given states: the door for a comparison with another program."""

from __future__ import annotations

from typing import Annotated, Any

import typer

from tmodes.cli.options import AsJson, ReadingOption, RobotArgument, Settings, chosen_robot

__all__ = ["evaluate"]


def evaluate(
    robot: RobotArgument,
    states: Annotated[str, typer.Option(help="JSON file: a list of records with phi (6), phid (6) and u.")],
    reading: ReadingOption = None,
    contact: Annotated[bool, typer.Option("--contact", help="With the tip on the environment.")] = False,
    nominal: Annotated[bool, typer.Option("--nominal", help="The robot as known, not the real one.")] = False,
    settings: Settings = None,
    as_json: AsJson = False,
) -> None:
    """Mass matrix, bias, forces, accelerations, tip, Jacobian and energies at given states.

    Of H phidd + h + f_el + f_di + J^T F = Q: SI units, coordinates q, delta, gamma, vt, e, theta; the real robot; u is
    the motor's voltage; h holds gravity; H is without the environment's mass (phidd has it); F acts by the tip.
    """
    from tmodes.analysis.evaluate import evaluate_states
    from tmodes.cli.output import print_json_list
    from tmodes.io.states import read_states

    pair = chosen_robot(robot, settings, reading, contact).pair()
    records = read_states(states)
    answers = evaluate_states(pair.nominal if nominal else pair.real, records)
    if as_json:
        print_json_list(answers)
    else:
        _print(list(answers))


def _print(answers: list[dict[str, Any]]) -> None:
    from tmodes.cli.output import print_table
    from tmodes.equations.layout import COORDINATES

    accelerations = [[str(k), *(f"{x:.6g}" for x in one["phidd"])] for k, one in enumerate(answers)]
    print_table("Accelerations [rad/s^2]", ["state", *COORDINATES], accelerations)
    names = ("kinetic", "potential_gravity", "potential_elastic", "rayleigh", "energy")
    energies = [[str(k), *(f"{one[name]:.6g}" for name in names)] for k, one in enumerate(answers)]
    print_table("Energies [J], Rayleigh function [W]", ["state", *names], energies)
    print("All terms (H, h, f_el, f_di, Q, J, tip, forces): add --json")
