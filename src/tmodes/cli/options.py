"""Arguments and options that several commands share, and how they become a robot."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from tmodes.errors import InputError
from tmodes.io.filipovic2010.format import Reading

if TYPE_CHECKING:
    from tmodes.sheet import Robot

__all__ = [
    "AbsoluteTolerance",
    "AsJson",
    "CheckError",
    "Contact",
    "Duration",
    "IntegratorOption",
    "ReadingOption",
    "Roots",
    "Settings",
    "SheetArgument",
    "Stop",
    "StopAtLimits",
    "Tolerance",
    "TrustPaths",
    "chosen_sheet",
    "integration_changes",
]

SheetArgument = Annotated[
    str,
    typer.Argument(
        metavar="NAME|FILE",
        help="A published robot (see: tmodes robots), a data sheet or elasticity file or Denavit-Hartenberg "
        "table (.yaml), or a .urdf, .xacro or MJCF .xml.",
    ),
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
Roots = Annotated[
    list[Path] | None,
    typer.Option("--root", metavar="DIR", help="Folder of packages that a URDF may name; may be given often."),
]
TrustPaths = Annotated[
    bool, typer.Option("--trust-paths", help="Let a robot's file name other files anywhere on this machine.")
]
IntegratorOption = Annotated[
    str | None,
    typer.Option(
        "--integrator",
        metavar="METHOD",
        help="dormand_prince: explicit, order 5, for most motions. dop853: explicit, order 8, for rtol below 1e-8. "
        "rk4: fixed integration.step, to repeat the work of others. extrapolation: implicit, for stiff "
        "links and gears; midpoint: fixed step, keeps energy in long runs; rosenbrock: implicit with the exact "
        "Jacobian, to check others; auto (the default): the stiffness chooses, before and during the run.",
    ),
]
Tolerance = Annotated[
    float | None,
    typer.Option(
        "--rtol",
        metavar="SHARE",
        help="integration.relative_tolerance: error of a step over the size of each coordinate and rate.",
    ),
]
AbsoluteTolerance = Annotated[
    float | None,
    typer.Option(
        "--atol", metavar="RAD", help="integration.absolute_tolerance: for what is near zero, about rtol / 1000."
    ),
]
CheckError = Annotated[
    bool,
    typer.Option(
        "--check-error",
        help="Run again with a tenth of the tolerances (fixed step: half of it), for the error of every figure.",
    ),
]
Duration = Annotated[float | None, typer.Option(metavar="SECONDS", help="integration.duration, simulated time.")]

Stop = Annotated[
    list[str] | None,
    typer.Option(
        "--stop",
        metavar="CONDITION",
        help="integration.stop: end the run where this triggers, located exactly; may be given often: "
        '--stop "tip.z < 0"  --stop "abs(elbow.velocity) > 90 deg/s". A wrong name lists the right ones.',
    ),
]
StopAtLimits = Annotated[
    bool,
    typer.Option("--stop-at-limits", help="integration.stop_at_limits: end the run where a joint passes a limit."),
]


def chosen_sheet(
    robot: str,
    settings: list[str] | None,
    reading: Reading | None = None,
    contact: bool | None = None,
    *,
    roots: list[Path] | None = None,
    trust_paths: bool = False,
    changes: dict[str, Any] | None = None,
) -> Robot:
    """The robot that a command line names, with its changes; raises an InputError for any wrong part."""
    from tmodes.io.assignment import parse_assignment
    from tmodes.robots.load import load

    info = dict(parse_assignment(text) for text in settings or []) | (changes or {})
    sheet = load(robot, info, roots=roots or (), trust_paths=trust_paths)
    own: dict[str, Any] = {}
    if reading is not None:
        _refuse_without_reading(sheet, reading)
        own["reading"] = reading.value
    if contact is not None:
        _refuse_without_contact(sheet, contact)
        own["contact"] = contact
    if "integration.stop_at_limits" in info and not any(joint.limits for joint in sheet.joints):
        got, hint = f"the robot {robot}, which has none", "leave it out; --stop ends a run at a value of your choice"
        raise InputError("--stop-at-limits", got, "given for a robot whose joints have limits", hint)
    return sheet.with_(own) if own else sheet


def _refuse_without_reading(sheet: Robot, reading: Reading) -> None:
    if not sheet.imported:
        expected, hint = (
            "left out: only sheets of the 2010 robot have a reading",
            "remove it; `equations` chooses those of another robot",
        )
        raise InputError("--reading", reading.value, expected, hint)


def _refuse_without_contact(sheet: Robot, contact: bool) -> None:
    if contact and not (sheet.contact or sheet.contact_off):
        raise InputError(
            "--contact", "a robot that touches nothing", "given for a robot with a contact", "add it to the sheet"
        )


def integration_changes(
    integrator: str | None,
    rtol: float | None,
    atol: float | None,
    duration: float | None,
    check_error: bool,
    *,
    stop: list[str] | None = None,
    stop_at_limits: bool = False,
) -> dict[str, Any]:
    """The options of the command line as changes by path."""
    info = {"method": integrator, "relative_tolerance": rtol, "absolute_tolerance": atol, "duration": duration}
    info |= {"check_error": check_error or None, "stop": stop or None, "stop_at_limits": stop_at_limits or None}
    return {f"integration.{name}": value for name, value in info.items() if value is not None}
