"""Arguments and options that several commands share, and how they become a robot."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from tmodes.cli.terminal import working
from tmodes.io.filipovic2010.reading import Reading
from tmodes.robots.load import load_with_urdf

if TYPE_CHECKING:
    from tmodes.io.urdf import UrdfRobot
    from tmodes.result import Result
    from tmodes.sheet import Robot

__all__ = [
    "AbsoluteTolerance",
    "AsJson",
    "CheckError",
    "Contact",
    "Duration",
    "FixInertia",
    "IntegratorOption",
    "ModelError",
    "ReadingOption",
    "Roots",
    "Settings",
    "SettlingBand",
    "SheetArgument",
    "Stop",
    "StopAtLimits",
    "Tolerance",
    "TrustPaths",
    "chosen_robot",
    "chosen_sheet",
    "stored_result",
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
        help="Change a number of the robot; may be given often: --set payload.mass=0.8  --set real.gear.stiffness=0.5. "
        "A group or list as in YAML: --set 'drives.0.signal={type: constant, value: 0.4}'. As the sliders of a page: a "
        "path with * multiplies all that it names, --set 'joints.*.gear.stiffness=1.2' (with a unit, or inf, it sets "
        "them); real:PATH=0.5 sets actual / nominal.",
    ),
]
ReadingOption = Annotated[
    Reading | None,
    typer.Option(
        help="Of a sheet of the 2010 robot: which reading of its equations; else the sheet's. Of any robot, "
        "--set equations=NAME takes `recursion` or a system that is registered."
    ),
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
FixInertia = Annotated[
    bool,
    typer.Option(
        "--fix-inertia", help="Raise the moments that no joint uses where an inertia of a URDF is impossible."
    ),
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
        help="Errors by a second run with a hundredth of the tolerances (fixed step: a quarter), not a tenth (half).",
    ),
]
ErrorEstimate = Annotated[
    bool,
    typer.Option(
        "--error-estimate/--no-error-estimate",
        help="Estimate the error of the integration, by a second run with finer steps.",
    ),
]
ModelError = Annotated[
    bool,
    typer.Option(
        "--model-error/--no-model-error",
        help="Estimate the error of the flexible links' models, by a second run with other stiffnesses.",
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
SettlingBand = Annotated[
    str | None,
    typer.Option(
        metavar="BAND",
        help='How near to its rest the tip counts as settled: a share of its move ("2 %") or a length ("0.1mm").',
    ),
]
StopAtLimits = Annotated[
    bool, typer.Option("--stop-at-limits", help="integration.stop_at_limits: end the run where a joint passes a limit.")
]


def chosen_sheet(
    robot: str,
    settings: list[str] | None,
    reading: Reading | None = None,
    contact: bool | None = None,
    **how: Any,
) -> Robot:
    """The robot that a command line names, with its changes; arguments and errors of :func:`chosen_robot`."""
    with working("reading", at_once=True):
        return chosen_robot(robot, settings, reading, contact, **how)[0]


def chosen_robot(
    robot: str,
    settings: list[str] | None,
    reading: Reading | None = None,
    contact: bool | None = None,
    *,
    roots: list[Path] | None = None,
    trust_paths: bool = False,
    fix_inertia: bool = False,
    changes: dict[str, Any] | None = None,
) -> tuple[Robot, UrdfRobot | None]:
    """The robot that a command line names, with its changes, and the URDF on which it stands.

    Raises an InputError for any wrong part.
    """
    from tmodes.interface.integration import prepared
    from tmodes.io.assignment import parse_assignment

    info = dict(parse_assignment(text) for text in settings or []) | (changes or {})
    sheet, urdf = load_with_urdf(robot, info, roots=roots or (), trust_paths=trust_paths, fix_inertia=fix_inertia)
    at_limits = "integration.stop_at_limits" in info
    return prepared(sheet, reading.value if reading else None, contact, stop_at_limits=at_limits), urdf


def stored_result(path: Path) -> Result:
    """The result that a path means; the errors are those of reading it."""
    from tmodes.interface.show import result_file
    from tmodes.result import Result

    with working("reading", at_once=True):
        return Result.load(result_file(path))
