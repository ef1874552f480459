"""``tmodes eval``: all terms of the equations at given states, to compare with another program."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Annotated, Any

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
from tmodes.cli.terminal import print_json, print_json_list, print_table, working
from tmodes.errors import InputError

if TYPE_CHECKING:
    from tmodes.io.states import ChainStates
    from tmodes.model.model import Model
    from tmodes.sheet import Robot

__all__ = ["UNITS", "evaluate", "evaluate_states", "terms_at"]


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
    fix_inertia: FixInertia = False,
    as_json: AsJson = False,
) -> None:
    """Mass matrix, bias, forces, accelerations, points, Jacobians and energies at given states.

    M a + h + f_el = effort, free of contact and loads, with gravity g, points, Jacobians, energies, losses; SI units.

    Of a sheet of the 2010 robot, with records of phi, phid and u: H phidd + h + f_el + f_di + J^T F = Q in its
    coordinates q, delta, gamma, vt, e, theta; u is the motor's voltage; h holds gravity; H is without the
    environment's mass (phidd has it); F acts by the tip.
    """
    from tmodes.io.states import holds_phi, read_phi_states

    sheet = chosen_sheet(robot, settings, reading, roots=root, trust_paths=trust_paths, fix_inertia=fix_inertia)
    if sheet.imported and holds_phi(states):
        from tmodes.cli.evaluate_phi import evaluate_phi

        with working("evaluating", at_once=True):
            pair = sheet.with_({"contact": contact}).pair()
            answers = evaluate_phi(pair.nominal if nominal else pair.real, read_phi_states(states))
        print_json_list(iter(answers)) if as_json else _print(answers)
        return
    if contact:
        expected = "left out: its terms are those in free space"
        hint = "evaluate a sheet of the 2010 robot, or leave it out"
        raise InputError("--contact", f"the robot {sheet.name}", expected, hint)
    pair = sheet.pair()
    evaluate_states(pair.nominal if nominal else pair.real, states, as_json=as_json)


def _print(answers: list[dict[str, Any]]) -> None:
    from tmodes.cli.evaluate_phi import COORDINATES

    accelerations = [[str(k), *(f"{x:.6g}" for x in one["phidd"])] for k, one in enumerate(answers)]
    print_table("Accelerations [rad/s^2]", ["state", *COORDINATES], accelerations)
    names = ("kinetic", "potential_gravity", "potential_elastic", "rayleigh", "energy")
    energies = [[str(k), *(f"{one[name]:.6g}" for name in names)] for k, one in enumerate(answers)]
    print_table("Energies [J], Rayleigh function [W]", ["state", *names], energies)
    print("All terms (H, h, f_el, f_di, Q, J, tip, forces): add --json")


UNITS = {
    "q": "rad, m along prismatic joints, 1 of stretch",
    "v": "of q, per s",
    "a": "of q, per s^2",
    "effort": "N*m, N along prismatic joints",
    "M": "kg*m^2, kg*m, kg",
    "h": "N*m, N: Coriolis, centrifugal and gravity",
    "g": "N*m, N: gravity alone",
    "f_el": "N*m, N: springs, dampers and friction",
    "position": "m",
    "rotation": "1",
    "velocity": "m/s",
    "J": "m/rad, then rad/rad: velocity of the point, then angular velocity, per rate",
    "energies": "J",
    "losses": "W",
}
"""What each answer is given in; M a + h + f_el = effort of the motors and joints."""

_MOST_NUMBERS = 20_000_000
"""Numbers of all answers together beyond which they are refused."""


def evaluate_states(robot: Robot, path: str, *, as_json: bool) -> None:
    """Read states, evaluate, and print."""
    from tmodes.io.states import read_states
    from tmodes.model.model import Model

    with working("evaluating", at_once=True):
        model = Model(robot.model_copy(update={"drives": ()}).chain())  # every joint with its motor, none prescribed
        states = read_states(path, model.coordinates, model.efforts)
        answers = list(terms_at(model, states))
    if as_json:
        names = {"coordinates": list(model.coordinates), "efforts": list(model.efforts)}
        print_json({"arm": robot.name, **names, "units": UNITS, "states": answers})
    else:
        _print_terms(model, answers)


def terms_at(model: Model, states: ChainStates) -> Iterator[dict[str, Any]]:
    """The terms at each state, free of contact and loads.

    Raises :class:`tmodes.errors.InputError` for more than memory should hold, and
    :class:`tmodes.errors.SimulationError` naming the state where a term is not finite.
    """
    from tmodes.cli.evaluate_phi import check_finite

    points = [point.name for point in model.parts.points]
    numbers = len(states.q) * model.nq * (model.nq + 6 * len(points) + 8)
    if numbers > _MOST_NUMBERS:
        got = f"{len(states.q)} states of {model.nq} coordinates"
        raise InputError("--states", got, f"at most {_MOST_NUMBERS} numbers in all answers", "split the file")
    q, v = states.q, states.v
    terms = {
        "a": model.forward_dynamics(q, v, states.effort),
        "M": model.mass_matrix(q),
        "h": model.bias(q, v),
        "g": model.gravity_forces(q),
        "f_el": model.elastic_forces(q, v),
    }
    check_finite(terms, "keep q and v within what a robot can do, and give what moves a mass")
    motion, jacobian = model.points(q, v), model.jacobian(q)
    energies, losses = model.energies(q, v), model.losses(q, v)
    for k in range(len(q)):
        yield {
            "q": q[k].tolist(), "v": v[k].tolist(), "effort": states.effort[k].tolist(),
            **{name: values[k].tolist() for name, values in terms.items()},
            "points": {
                name: {"position": motion.position[k, i].tolist(), "rotation": motion.rotation[k, i].tolist(),
                       "velocity": motion.velocity[k, i].tolist(), "J": jacobian[k, i].tolist()}
                for i, name in enumerate(points)
            },
            "energies": {name: float(values[k]) for name, values in energies.items()},
            "losses": {name: float(values[k]) for name, values in losses.items()},
        }  # fmt: skip


def _print_terms(model: Model, answers: list[dict[str, Any]]) -> None:
    rows = [[name, *(f"{one['a'][i]:.6g}" for one in answers[:6])] for i, name in enumerate(model.coordinates)]
    columns = ["coordinate", *(f"state {k}" for k in range(len(answers[:6])))]
    print_table("Accelerations [rad/s^2, m/s^2]", columns, rows)
    names = [*answers[0]["energies"], *answers[0]["losses"]]
    energies = [[str(k), *(f"{value:.6g}" for value in (*one["energies"].values(), *one["losses"].values()))]
                for k, one in enumerate(answers)]  # fmt: skip
    print_table("Energies [J], losses [W]", ["state", *names], energies)
    print("All terms (M, h, g, f_el, points, J): add --json")
