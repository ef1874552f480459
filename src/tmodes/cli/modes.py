"""``tmodes modes``: frequencies, damping, and the dominant element of each mode of vibration."""

from __future__ import annotations

import math
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
from tmodes.cli.static import PoseOption, pose_of
from tmodes.cli.statics_text import circumstances, print_links, which_robot
from tmodes.cli.terminal import print_json, print_table, warn, working
from tmodes.errors import InputError

if TYPE_CHECKING:
    from tmodes.analysis.modes.of_sheet import Vibrations
    from tmodes.sheet import Robot

__all__ = ["modes"]

_MOST_ANGLE = 1000.0

_UNITS = {
    "frequency_Hz": "Hz, natural: |pole|/2 pi; 0: it does not ring",
    "damped_frequency_Hz": "Hz, imaginary part of the pole over 2 pi; null: it does not ring",
    "undamped_frequency_Hz": "Hz, of mass and stiffness alone; null: second motion of an over-damped mode",
    "time_constant_s": "s, -1/pole of what decays without ringing, two of an over-damped mode; null: it rings",
    "damping_ratio": "1, -real part of the pole over its size",
    "pole": "1/s, real and imaginary part: the eigenvalue of mass, damping, stiffness and controllers",
    "share": "1",
    "growth_time_s": "s, in which an unstable mode grows by the factor e",
    "frequency_error": "1, undamped frequency over that with four more functions a direction, less 1; null: not known",
    "angle_rad": "rad",
    "poles": "1/s, real and imaginary part, of all eigenvalues under control",
    "missing_share": "1, of the energy of bending, in shapes that the link's functions do not have",
}

_MOTOR = {"locked": "motor locked", "free": "motor free (no current)", "controlled": "motor under control"}


def modes(
    robot: SheetArgument,
    reading: ReadingOption = None,
    settings: Settings = None,
    contact: Annotated[bool, typer.Option("--contact", help="With the tip on the environment.")] = False,
    angle: Annotated[
        float | None, typer.Option(help="Angle of the first drive's motor in rad; else the start of its move.")
    ] = None,
    at: PoseOption = None,
    max_frequency: Annotated[
        float, typer.Option("--max-frequency", help="Highest natural frequency that is shown [Hz].")
    ] = math.inf,
    root: Roots = None,
    trust_paths: TrustPaths = False,
    fix_inertia: FixInertia = False,
    as_json: AsJson = False,
) -> None:
    """Frequencies and damping about the sagged rest, for the actual robot and for the nominal one.

    Under its loads, its motors at their first command or `--at` a pose. Where drives or the base turn at
    constant speed, about that motion, with its centrifugal and gyroscopic forces. All numbers are of the pole p, an
    eigenvalue of mass, damping, stiffness and controllers: `natural` |p|/2 pi, `damped` Im p/2 pi, damping ratio
    -Re p/|p|. An over-damped mode has two real poles, and a line with its time constant -1/p for each. Modes marked !
    change with more functions.
    """
    from tmodes.analysis.modes.of_sheet import vibrations

    sheet = _asked(
        chosen_sheet(robot, settings, reading, roots=root, trust_paths=trust_paths, fix_inertia=fix_inertia),
        contact,
        angle,
    )
    if not max_frequency > 0:
        raise InputError("--max-frequency", repr(max_frequency), "a frequency > 0 Hz", "give it in Hz, or leave it out")
    pair, held = sheet.pair(), pose_of(at, sheet)
    robots = {"real": pair.real} | ({"nominal": pair.nominal} if sheet.real else {})
    with working("preparing") as tell:
        found = {
            kind: _up_to(vibrations(one, contact=contact, held=held, progress=tell), max_frequency)
            for kind, one in robots.items()
        }
    if as_json:
        states = {kind: one.states for kind, one in found.items()}
        links, warnings = ({kind: one[k] for kind, one in found.items()} for k in (1, 2))
        head = {"robot": sheet.name, "equations": sheet.equations, "contact": contact, "units": _UNITS}
        poles = {kind: one.poles for kind, one in found.items()}
        print_json({**head, **states, "poles": poles, "links": links, "warnings": warnings})
        return
    for kind, one in found.items():
        whose = ", actual robot" if kind == "real" and len(found) > 1 else which_robot(robots[kind])
        for state, lines in one.states.items():
            if lines:
                motor = _MOTOR[state] if one.motors else "no motor"
                _print(f"{sheet.name}{whose}, {motor}, {circumstances(robots[kind], contact=contact, at=at)}", lines)
        print_links(one.links)
    warn(dict.fromkeys(warning for one in found.values() for warning in one.warnings))


def _up_to(found: Vibrations, highest: float) -> Vibrations:
    """Without modes of a higher frequency [Hz]."""
    states = {state: [row for row in rows if row["frequency_Hz"] <= highest] for state, rows in found.states.items()}
    return found._replace(states=states)


def _asked(sheet: Robot, contact: bool, angle: float | None) -> Robot:
    """The robot in contact or not, its first motor at an angle [rad]."""
    if angle is not None:
        if not abs(angle) <= _MOST_ANGLE:
            expected = f"an angle between -{_MOST_ANGLE:g} and {_MOST_ANGLE:g} rad"
            raise InputError("--angle", repr(angle), expected, "give the motor's angle in radians, or leave it out")
        if len(sheet.drives) != 1:
            hint = "set the start of its drives: --set drives.0.signal.start=0.5"
            raise InputError("--angle", repr(angle), "left out where the robot has not exactly one drive", hint)
        held = {"joint": sheet.drives[0].joint, "command": "prescribed"}
        sheet = sheet.with_({"drives": [held | {"signal": {"type": "constant", "value": angle}}]})
    if contact and sheet.contact_off:
        sheet = sheet.with_({"contact": True})
    if contact and sheet.contact is None:
        raise InputError(
            "--contact", "a robot that touches nothing", "given for a robot with a contact", "leave --contact out"
        )
    return sheet


def _print(title: str, lines: list[dict[str, Any]]) -> None:
    columns = ["dominant element", "share of energy", "natural [Hz]", "damped [Hz]", "damping ratio", "converged"]
    print_table(title, columns, [_row(line) for line in lines])


def _row(line: dict[str, Any]) -> list[str]:
    growth, damped, error = line["growth_time_s"], line["damped_frequency_Hz"], line["frequency_error"]
    decay = line["time_constant_s"]
    checked = "-" if error is None else "yes" if line["converged"] else f"! {error:+.1%}"
    ringing = "-" if damped is None else f"{damped:.4g}"
    ratio = f"{round(line['damping_ratio'], 4) + 0.0:.4f}" if growth is None else f"grows by e in {growth:.3g} s"
    ratio = ratio if decay is None else f"no vibration, decays in {decay:.3g} s"
    natural = f"{line['frequency_Hz']:.4g}" if damped or (growth is None and decay is None) else "-"
    return [line["element"] + ("" if line["stable"] else " (UNSTABLE)"), f"{line['share']:.0%}", natural, ringing,
            ratio, checked]  # fmt: skip
