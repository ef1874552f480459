"""``tmodes modes``: frequencies, damping, and the element in which each mode of vibration lives."""

from __future__ import annotations

from typing import Annotated, Any

import typer

from tmodes.cli.options import AsJson, ReadingOption, RobotArgument, Settings, chosen_robot
from tmodes.errors import InputError

__all__ = ["modes"]

_MOST_ANGLE = 1000.0

_MOTOR = {
    "locked": "motor locked",
    "free": "motor free (no current)",
    "controlled": "motor under control",
}


def modes(
    robot: RobotArgument,
    reading: ReadingOption = None,
    settings: Settings = None,
    contact: Annotated[bool, typer.Option("--contact", help="With the tip on the environment.")] = False,
    angle: Annotated[float | None, typer.Option(help="Motor angle in rad; else the start of the move.")] = None,
    as_json: AsJson = False,
) -> None:
    """Frequencies and damping about the sagged rest, for the real robot and for the robot as it is known.

    `natural` is the undamped frequency, `damped` the one at which it rings (- where it is over-damped).
    """
    from tmodes.analysis.modes import all_modes
    from tmodes.cli.output import print_json

    if angle is not None and not abs(angle) <= _MOST_ANGLE:
        expected = f"an angle between -{_MOST_ANGLE:g} and {_MOST_ANGLE:g} rad"
        raise InputError("--angle", repr(angle), expected, "give the motor's angle in radians, or leave it out")
    pair = chosen_robot(robot, settings, reading).pair()
    found = {"real": all_modes(pair.real, contact=contact, theta=angle)}
    if pair.real is not pair.nominal:
        found["nominal"] = all_modes(pair.nominal, contact=contact, theta=angle)
    if as_json:
        units = {"frequency_Hz": "Hz, natural", "damped_frequency_Hz": "Hz", "damping_ratio": "1", "share": "1"}
        print_json(
            {"robot": pair.nominal.name, "reading": pair.nominal.reading, "contact": contact, "units": units, **found}
        )
        return
    for kind, states in found.items():
        whose = "real robot" if kind == "real" else "robot as known"
        for state, lines in states.items():
            _print(f"{pair.nominal.name}, {whose}, {_MOTOR[state]}{', in contact' if contact else ''}", lines)


def _print(title: str, lines: list[dict[str, Any]]) -> None:
    from tmodes.cli.output import print_table

    columns = ["lives in", "share of energy", "natural [Hz]", "damped [Hz]", "damping ratio"]
    print_table(title, columns, [_row(line) for line in lines])


def _row(line: dict[str, Any]) -> list[str]:
    damped = line["damped_frequency_Hz"]
    ringing = "-" if damped is None else f"{damped:.4f}"
    home = line["element"] + ("" if line["stable"] else " (UNSTABLE)")
    return [
        home,
        f"{line['share']:.0%}",
        f"{line['frequency_Hz']:.4f}",
        ringing,
        f"{line['damping_ratio']:.4f}",
    ]
