"""Arguments and options that several commands share, and how they become a robot or an arm."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from tmodes.errors import InputError
from tmodes.paper.mechanism import Reading
from tmodes.paper.sheet import PaperRobot

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
        help="A published robot or arm (see: tmodes robots), a data sheet or elasticity file or Denavit-Hartenberg "
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
        help="integration.stop: end the run where this sets in, located exactly; may be given often: "
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
) -> PaperRobot | Robot:
    """The robot or arm that a command line names, with its changes; raises an InputError for any wrong part."""
    from tmodes.io.paths import parse_assignment
    from tmodes.robots.load import load_sheet

    info = dict(parse_assignment(text) for text in settings or []) | (changes or {})
    own = {"reading": reading and reading.value, "contact": contact}
    own = {name: value for name, value in own.items() if value is not None}
    if "integration.stop_at_limits" in info and _is_paper_robot(robot):
        got, hint = f"the robot {robot}, which has none", "leave it out; --stop ends a run at a value of your choice"
        raise InputError("--stop-at-limits", got, "an arm whose joints have limits", hint)
    if own and not _is_arm(robot):
        return load_sheet(robot, info | own)
    sheet = load_sheet(robot, info, roots=roots or (), trust_paths=trust_paths)
    return sheet if isinstance(sheet, PaperRobot) or not own else _as_wished(sheet, own)


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


def _is_paper_robot(robot: str) -> bool:
    from tmodes.robots.load import sheet_names

    return (robot in sheet_names() or Path(robot).is_file()) and not _is_arm(robot)


def _is_arm(robot: str) -> bool:
    """Whether a name or file is that of an arm; False too for what cannot be read, which is told by who reads it."""
    from tmodes.io.yaml_file import read_yaml
    from tmodes.robots import names
    from tmodes.robots.load import FOREIGN, sheet_names

    if robot in sheet_names():
        return robot not in names()
    path = Path(robot)
    if path.suffix.lower() in FOREIGN:
        return True
    data = read_yaml(path)[0] if path.is_file() else {}
    return "kind" in data or "urdf" in data


def _as_wished(arm: Robot, own: dict[str, Any]) -> Robot:
    """An arm in contact or not, as the command line says."""
    from tmodes.io.sheet_check import sheet_data

    if "reading" in own:
        hint = "leave --reading out"
        raise InputError("--reading", own["reading"], "no reading: it is of the robot of the 2010 paper", hint)
    if own["contact"] == (arm.contact is not None):
        return arm
    if own["contact"]:
        raise InputError("--contact", "an arm that touches nothing", "a sheet with `contact`", "add it to the sheet")
    data = {key: value for key, value in sheet_data(arm).items() if key != "contact"}
    data["real"] = {path: factor for path, factor in arm.real.items() if not path.startswith("contact.")}
    return type(arm).from_data(data)
