"""``tmodes static``: the rest position under weight and loads, and the stiffness there."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Annotated

import typer

from tmodes.cli.options import AsJson, FixInertia, Roots, Settings, SheetArgument, TrustPaths, chosen_sheet
from tmodes.cli.statics_text import circumstances, print_statics
from tmodes.cli.terminal import print_json, warn, working
from tmodes.errors import InputError
from tmodes.io.units import finite_number
from tmodes.io.words import meant, shown

if TYPE_CHECKING:
    from tmodes.analysis.statics.loads import Load
    from tmodes.sheet import Robot

__all__ = ["PoseOption", "held_of", "load_of", "pose_of", "static", "three_of"]

UNITS = {
    "coordinates": "rad, m along prismatic joints and stretch",
    "moving": "rad/s, m/s: coordinates and `base` that move at constant speed",
    "efforts": "N*m, N: of drives that command no position, on coordinates that are free",
    "residual": "1, of the largest force",
    "lowest_frequency_Hz": "Hz, 0 where not stable",
    "lost_stability_at": "1, factor on weight and loads",
    "shares": "1, of the compliance in that direction",
    "angle_rad": "rad",
    "missing_share": "1, of the energy of bending, in shapes that the link's functions do not have",
}


PoseOption = Annotated[
    str | None,
    typer.Option(
        "--at", metavar="JOINT=VALUE,...",
        help="The pose: joints held there, such as shoulder=0.4,elbow=-60deg; others at their first command.",
    ),
]  # fmt: skip


def static(
    robot: SheetArgument,
    load: Annotated[
        list[str] | None,
        typer.Option(
            metavar="KEY=VALUE,...",
            help="A load, such as point=tip,force=0,0,-10 with the keys point, force, moment and frame: world, or "
            "section, with which it turns along; may be given often.",
        ),
    ] = None,
    force: Annotated[str | None, typer.Option(metavar="X,Y,Z", help="Dead force on the point [N].")] = None,
    moment: Annotated[str | None, typer.Option(metavar="X,Y,Z", help="Dead moment on the point [N*m].")] = None,
    point: Annotated[str, typer.Option(help="The point that is loaded and reported.")] = "tip",
    hold: Annotated[
        list[str] | None,
        typer.Option(
            metavar="COORDINATE=VALUE",
            help="Hold a motor or joint there [rad, m, or 45deg]; a joint behind an elastic gear by its motor.",
        ),
    ] = None,
    at: PoseOption = None,
    settings: Settings = None,
    root: Roots = None,
    trust_paths: TrustPaths = False,
    fix_inertia: FixInertia = False,
    as_json: AsJson = False,
) -> None:
    """Rest under weight and loads: pose, sag, stability, stiffness at the point, and which element gives how much.

    The loads are those of the data sheet and those given here; motors stand at their first command. A joint whose drive
    commands an effort, torque or voltage is free, under its first value, unless --hold or --at names it. Of the nominal
    robot where the sheet has an actual one too. Where drives or the base turn at constant speed, about that motion,
    with its centrifugal forces.
    """
    from tmodes.analysis.describe.describe import statics_info
    from tmodes.analysis.statics.at_rest import robot_rest
    from tmodes.analysis.statics.loads import Load, point_index
    from tmodes.model.model import Model

    sheet = chosen_sheet(robot, settings, roots=root, trust_paths=trust_paths, fix_inertia=fix_inertia)
    loads = [load_of(text) for text in load or []]
    if force or moment:
        info = three_of("--force", force or "0,0,0", "N"), three_of("--moment", moment or "0,0,0", "N*m")
        loads.append(Load(point, *info))
    chain = sheet.chain()
    model = Model(chain)
    index = point_index(model, point)
    held = pose_of(at, sheet) | dict(held_of(text, sheet) for text in hold or [])
    with working("preparing") as tell:
        rest = robot_rest(sheet, loads, model=model, held=held, moving=True, efforts=True, progress=tell)
        info = statics_info(sheet, rest, index)
    if as_json:
        print_json({"robot": sheet.name, "of": "nominal robot" if sheet.real else "robot", "units": UNITS, **info})
        return
    given = ",".join([*([at] if at else []), *(hold or [])]) or None
    print_statics(sheet, info, chain.sliding, circumstances(sheet, contact=True, at=given, efforts=info["efforts"]))
    warn(info["warnings"])


KEYS = ("point", "force", "moment", "frame")
FRAMES = ("world", "section")
EXAMPLE = "write it like point=tip,force=0,0,-10"
LARGEST = 1e12


def load_of(text: str) -> Load:
    """A load from ``point=tip,force=0,0,-10``; raises an InputError that names the part that is wrong."""
    from tmodes.analysis.statics.loads import Load

    parts = _parts(text)
    if "force" not in parts and "moment" not in parts:
        raise InputError("--load", repr(text), "a force, a moment or both", EXAMPLE)
    frame = parts.get("frame", "world")
    if frame not in FRAMES:
        raise _unknown("--load frame", frame, FRAMES)
    force, moment = (
        three_of(f"--load {name}", parts.get(name, "0,0,0"), unit) for name, unit in (("force", "N"), ("moment", "N*m"))
    )
    return Load(parts.get("point", "tip"), force, moment, follows=frame == "section")


def _parts(text: str) -> dict[str, str]:
    """The value of each key; a comma divides numbers of one value, and values where a key and = follow it."""
    parts: dict[str, str] = {}
    key = ""
    for piece in text.split(","):
        name, equals, value = (part.strip() for part in piece.partition("="))
        if equals and name not in KEYS:
            raise _unknown("--load", name, KEYS)
        if equals and name in parts:
            raise InputError(
                "--load", f"`{name}` a second time", "given each key once", "give another --load for each load"
            )
        if not equals and not key:
            raise InputError("--load", repr(text), "KEY=VALUE,... with the keys " + ", ".join(KEYS), EXAMPLE)
        key = name if equals else key
        parts[key] = value if equals else f"{parts[key]},{name}"
    return parts


def _unknown(which: str, name: str, known: Sequence[str]) -> InputError:
    hint = meant(name, known, EXAMPLE)
    return InputError(which, f"the unknown word {shown(name)}", f"one of {', '.join(known)}", hint)


def three_of(which: str, text: str, unit: str) -> list[float]:
    """Three numbers with commas between them, each perhaps with its unit."""
    words = text.split(",")
    if len(words) != 3:
        raise InputError(which, repr(text), "three numbers", "write x, y and z, like 0,0,-10")
    return [finite_number(which, word, unit, "three finite numbers", most=LARGEST) for word in words]


def pose_of(text: str | None, sheet: Robot) -> dict[str, float]:
    """Coordinates and values of ``shoulder=0.4,elbow=-1``: of a joint behind an elastic gear, its motor's."""
    held = {}
    for part in text.split(",") if text else ():
        name, value = held_of(part, sheet, "--at")
        known = {coordinate: joint for joint in sheet.joints for coordinate in joint.coordinates}
        joint = known.get(name.removesuffix(".motor"))
        if joint is None or joint.is_locked:
            raise InputError(
                "--at", shown(name), f"joints that move: {', '.join(k for k, j in known.items() if not j.is_locked)}",
                meant(name, [*known], "correct the name"),
            )  # fmt: skip
        held[f"{name}.motor" if joint.is_active and joint.is_elastic and name in known else name] = value
    return held


def held_of(text: str, sheet: Robot, which: str = "--hold") -> tuple[str, float]:
    """Coordinate and value [rad; m of a prismatic joint] of ``shoulder=45deg``."""
    name, equals, value = (part.strip() for part in text.partition("="))
    if not (name and equals and value):
        raise InputError(which, repr(text), "COORDINATE=VALUE", "write it like shoulder=0.5 or shoulder=45deg")
    slides = any(joint.name == name.removesuffix(".motor") and joint.type == "prismatic" for joint in sheet.joints)
    return name, finite_number(f"{which} {name}", value, "m" if slides else "rad", most=LARGEST)
