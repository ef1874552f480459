"""Arguments and options that several commands share, and how they become a robot."""

from __future__ import annotations

from typing import Annotated

import typer

from tmodes.mechanism import Reading
from tmodes.robot import Robot

__all__ = ["AsJson", "Contact", "ReadingOption", "RobotArgument", "Settings", "chosen_robot"]

RobotArgument = Annotated[
    str, typer.Argument(metavar="ROBOT|FILE", help="A published robot (see: tmodes robots), or a data sheet (.yaml).")
]
Settings = Annotated[
    list[str] | None,
    typer.Option(
        "--set",
        metavar="PATH=VALUE",
        help="Change a number of the robot; may be given often: --set payload.mass=0.8  --set real.gear.stiffness=0.5",
    ),
]
ReadingOption = Annotated[
    Reading | None, typer.Option(help="Which reading of the paper's equations; else the data sheet's.")
]
Contact = Annotated[
    bool | None,
    typer.Option("--contact/--no-contact", help="Tip on the environment, or in free space; else the data sheet's."),
]
AsJson = Annotated[bool, typer.Option("--json", help="Print JSON for machines.")]


def chosen_robot(
    robot: str, settings: list[str] | None, reading: Reading | None = None, contact: bool | None = None
) -> Robot:
    """The robot that a command line names, with its changes; raises an InputError for any wrong part."""
    from tmodes.io.paths import parse_assignment
    from tmodes.robots import load_robot

    changes = dict(parse_assignment(text) for text in settings or [])
    if reading is not None:
        changes["reading"] = reading.value
    if contact is not None:
        changes["contact"] = contact
    return load_robot(robot, changes)
