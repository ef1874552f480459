"""``tmodes static``: where an arm comes to rest under its weight and loads, and how stiff it is there."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Any

import typer

from tmodes.cli.options import AsJson, Settings
from tmodes.errors import InputError

if TYPE_CHECKING:
    from tmodes.analysis.equilibrium import Equilibrium
    from tmodes.analysis.equilibrium_loads import Load
    from tmodes.arm import Arm

__all__ = ["ArmArgument", "chosen_arm", "static"]

ArmArgument = Annotated[
    str,
    typer.Argument(metavar="ARM|FILE", help="A published arm (see: tmodes robots), or a data sheet with kind: arm."),
]

UNITS = {
    "coordinates": "rad, m along prismatic joints and stretch",
    "residual": "1, of the largest force",
    "lowest_frequency_Hz": "Hz, 0 where not stable",
    "lost_stability_at": "1, factor on weight and loads",
    "shares": "1, of the compliance in that direction",
    "angle_rad": "rad",
}


def static(
    robot: ArmArgument,
    load: Annotated[
        list[str] | None,
        typer.Option(help="A load: point=tip,force=0,0,-10,moment=0,0,1,frame=world (or section: it turns along)."),
    ] = None,
    force: Annotated[str | None, typer.Option(metavar="X,Y,Z", help="Dead force on the point [N].")] = None,
    moment: Annotated[str | None, typer.Option(metavar="X,Y,Z", help="Dead moment on the point [N*m].")] = None,
    point: Annotated[str, typer.Option(help="The point that is loaded and told of.")] = "tip",
    hold: Annotated[
        list[str] | None, typer.Option(metavar="COORDINATE=VALUE", help="Hold a motor or joint there [rad, m].")
    ] = None,
    settings: Settings = None,
    as_json: AsJson = False,
) -> None:
    """Rest under weight and loads: pose, sag, stability, stiffness at the point, and which element gives how much.

    The loads are those of the data sheet and those given here; motors stand at their first command.
    """
    from tmodes.analysis.equilibrium_arm import arm_rest
    from tmodes.analysis.equilibrium_loads import Load, point_index
    from tmodes.arm_model import ArmModel
    from tmodes.cli.interrupt import heard
    from tmodes.cli.progress import Stages

    arm = chosen_arm(robot, settings)
    loads = [_parsed(text) for text in load or []]
    if force or moment:
        loads.append(Load(point, _three("--force", force or "0,0,0"), _three("--moment", moment or "0,0,0")))
    model = ArmModel(arm.chain())
    index = point_index(model, point)
    held = dict(_assignment(text) for text in hold or [])
    with heard() as wish, Stages(wish) as tell:
        rest = arm_rest(arm, loads, model=model, held=held, progress=tell)
    _tell(arm, rest, index, as_json)


def chosen_arm(robot: str, settings: list[str] | None) -> Arm:
    """The arm that a command line names, with its changes; raises an InputError for a sheet of another kind."""
    from tmodes.arm import Arm
    from tmodes.io.paths import parse_assignment
    from tmodes.robots.load import load_sheet

    sheet = load_sheet(robot, dict(parse_assignment(text) for text in settings or []))
    if not isinstance(sheet, Arm):
        mend = "take tmodes modes and tmodes run, which know it, or write a sheet with `kind: arm`"
        raise InputError("robot", f"`{sheet.name}`, the robot of the 2010 paper", "a data sheet of an arm", mend)
    return sheet


def _parsed(text: str) -> Load:
    """A load from ``point=tip,force=0,0,-10``."""
    from tmodes.analysis.equilibrium_loads import Load

    parts: dict[str, list[str]] = {}
    key = ""
    for piece in text.split(","):
        name, equals, value = piece.partition("=")
        if equals:
            key = name.strip()
            parts.setdefault(key, []).append(value)
        else:
            parts.setdefault(key, []).append(piece)
    unknown = [name for name in parts if name not in {"point", "force", "moment", "frame"}]
    frame = ",".join(parts.get("frame", ["world"])).strip()
    if unknown or frame not in {"world", "section"}:
        expected = "point=NAME,force=X,Y,Z,moment=X,Y,Z,frame=world or section"
        raise InputError("--load", repr(text), expected, "write it like point=tip,force=0,0,-10")
    three = (_three(f"--load {name}", ",".join(parts.get(name, ["0,0,0"]))) for name in ("force", "moment"))
    return Load(",".join(parts.get("point", ["tip"])).strip(), *three, follows=frame == "section")


def _three(which: str, text: str) -> list[float]:
    values = [_number(which, piece, text) for piece in text.split(",")]
    if len(values) != 3:
        raise InputError(which, repr(text), "three numbers", "write x, y and z, like 0,0,-10")
    return values


def _number(which: str, text: str, whole: str) -> float:
    try:
        return float(text)
    except ValueError:
        raise InputError(which, repr(whole), "numbers", "write plain SI numbers, like 0,0,-10") from None


def _assignment(text: str) -> tuple[str, float]:
    name, equals, value = text.partition("=")
    if not equals:
        raise InputError("--hold", repr(text), "COORDINATE=VALUE", "write it like shoulder=0.5")
    return name.strip(), _number("--hold", value, text)


def _tell(arm: Arm, rest: Equilibrium, index: int, as_json: bool) -> None:
    from tmodes.analysis.describe import statics_told
    from tmodes.cli.output import notice, print_json

    told = statics_told(arm, rest, index)
    if as_json:
        print_json({"arm": arm.name, "units": UNITS, **told})
        return
    _print(arm, told)
    for warning in told["warnings"]:
        notice(f"warning: {warning}")


def _print(arm: Arm, told: dict[str, Any]) -> None:
    from tmodes.cli.output import print_table

    lowest = told["lowest_frequency_Hz"]
    stable = "stable" if told["stable"] else "NOT STABLE"
    print(f"{arm.name} at rest: {stable}" + (f", lowest frequency {lowest:.4g} Hz" if lowest else ""))
    coordinates = [[name, f"{value:.6g}"] for name, value in told["coordinates"].items()]
    print_table("Pose", ["coordinate", "value [rad, m]"], coordinates)
    sags = [[one["point"], *_numbers(one["position_m"], 1.0), *_numbers(one["displacement_m"], 1e3),
             f"{one['rotation_rad']:.4g}"] for one in told["points"]]  # fmt: skip
    print_table("Points", ["point", "x [m]", "y [m]", "z [m]", "dx [mm]", "dy [mm]", "dz [mm]", "turn [rad]"], sags)
    if told["links"]:
        rows = [[link["link"], link["model"], f"{link['deflection_over_length']:.3%}", f"{link['slope_rad']:.4g}",
                 link["verdict"]] for link in told["links"]]  # fmt: skip
        print_table("Flexible links", ["link", "model", "deflection / length", "slope [rad]", "model holds"], rows)
    print_stiffness(told["stiffness"])


def _numbers(values: list[float], factor: float) -> list[str]:
    return [f"{factor * value:.6g}" for value in values]


def print_stiffness(told: dict[str, Any] | None) -> None:
    """Print a table of stiffness by direction and the elements that give most."""
    from tmodes.cli.output import print_table

    if told is None:
        return
    rows = []
    for one in told["directions"]:
        stiffness = "rigid" if one["stiffness"] is None else f"{one['stiffness']:.5g}"
        largest = sorted(one["shares"].items(), key=lambda item: -abs(item[1]))[:4]
        shares = ", ".join(f"{name} {share:.1%}" for name, share in largest if abs(share) >= 5e-4)
        rows.append([one["direction"], stiffness, one["unit"], shares])
    print_table(f"Stiffness at {told['point']}", ["direction", "stiffness", "unit", "what gives way"], rows)
