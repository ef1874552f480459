"""The tables of ``tmodes static``: pose, points, links, reactions, stiffness."""

from __future__ import annotations

import math
from collections.abc import Container
from typing import TYPE_CHECKING, Any

from tmodes.cli.terminal import print_table

if TYPE_CHECKING:
    from tmodes.sheet import Robot

__all__ = ["circumstances", "numbers", "print_links", "print_statics", "print_stiffness", "which_robot"]


def which_robot(sheet: Robot) -> str:
    """What stands behind the name of a robot whose sheet has an actual one, too."""
    return ", nominal robot" if sheet.real else ""


def circumstances(
    sheet: Robot, *, contact: bool, loads: bool = True, at: str | None = None, efforts: Container[str] = ()
) -> str:
    """What a table about a rest is of: free space or contact, weight, loads, pose.

    ``at``: the pose as it was given; ``efforts``: coordinates that are free under a drive's effort; others are held.
    """
    gravity = math.hypot(*sheet.chain().gravity)
    closed = sheet.contact is not None and not sheet.contact.unilateral
    left_out = "its bilateral contact left out (loop open)" if closed else "free space"
    drives = ["drives at their first command"] if any(drive.command.is_motion for drive in sheet.drives) else []
    pushed = [drive.joint for drive in sheet.drives if not drive.command.is_motion]
    free = [name for name in pushed if name in efforts or f"{name}.motor" in efforts]
    held = [name for name in pushed if name not in free]
    return ", ".join([
        "in contact" if contact and sheet.contact else left_out,
        f"gravity {gravity:.4g} m/s^2" if gravity else "no gravity",
        *(["under its loads" if loads else "without its loads"] if sheet.loads else ()),
        *([f"at {at}"] if at else drives),
        *([f"{' and '.join(free)} free under the first effort of the drive"] if free else ()),
        *([f"{' and '.join(held)} held without the effort of the drive"] if held else ()),
    ])  # fmt: skip


def print_statics(sheet: Robot, info: dict[str, Any], sliding: Container[str], where: str) -> None:
    """Print the rest, the points, the links, the reactions and the stiffness.

    ``sliding``: the coordinates in m; ``where``: the :func:`circumstances`.
    """
    lowest = info["lowest_frequency_Hz"]
    stable = "stable" if info["stable"] else "NOT STABLE"
    stable = f"neutral, nothing holds {' and '.join(info['neutral'])}" if info["neutral"] else stable
    rates = ", ".join(f"{name} {rate:.4g}" for name, rate in info["moving"].items())
    how = f"in motion at constant speed ({rates} rad/s, m/s)" if rates else "at rest"
    print(
        f"{sheet.name}{which_robot(sheet)} {how}: {stable}"
        + (f", lowest undamped frequency {lowest:.4g} Hz" if lowest else "")
    )
    print(where)
    if not info["coordinates"]:
        print("It has no coordinates: nothing in it moves or bends.")
    coordinates = [[name, *numbers([value], 1.0, 1.0), _unit(name, sheet, sliding)]
                   for name, value in info["coordinates"].items()]  # fmt: skip
    if coordinates:
        print_table("Pose", ["coordinate", "value", "unit"], coordinates)
    size = _largest(info["points"], "position_m")
    sags = [[one["point"], *numbers(one["position_m"], 1.0, size), *numbers(one["displacement_m"], 1e3, size),
             *numbers([one["rotation_rad"]], 1.0, 1.0)] for one in info["points"]]  # fmt: skip
    columns = ["point", *(f"{axis} [m]" for axis in "xyz"), *(f"d{axis} [mm]" for axis in "xyz"), "rotation [rad]"]
    print_table("Points at rest, and how far they are displaced and rotated", columns, sags)
    print_links(info["links"])
    if info["reactions"]:
        force, moment = (_largest(info["reactions"], name) for name in ("force_N", "moment_Nm"))
        rows = [[one["at"], *numbers(one["force_N"], 1.0, force), *numbers(one["moment_Nm"], 1.0, moment)]
                for one in info["reactions"]]  # fmt: skip
        columns = ["at", *(f"F{axis} [N]" for axis in "xyz"), *(f"M{axis} [N*m]" for axis in "xyz")]
        print_table("Reactions of the base and of each joint on what it carries, world axes", columns, rows)
    print_stiffness(info["stiffness"])


def print_links(links: list[dict[str, Any]]) -> None:
    """Print how far the flexible links bend, and whether the model of each holds."""
    if links:
        rows = [[link["link"], link["model"], f"{link['deflection_over_length']:.3%}", f"{link['slope_rad']:.4g}",
                 _share(link["missing_share"]), link["verdict"]] for link in links]  # fmt: skip
        print_table(
            "Flexible links",
            ["link", "model", "deflection / length", "slope [rad]", "missing shapes", "model holds"],
            rows,
        )


def _share(share: float | None) -> str:
    return "-" if share is None else f"{share:.1%}"


ROUNDING = 1e-12
"""A value below this share of the largest is zero but for rounding, and printed as 0."""


def numbers(values: list[float], factor: float, largest: float) -> list[str]:
    """SI values times a factor; 0 for what is rounding next to the largest SI value."""
    return [f"{factor * value + 0.0:.6g}" if abs(value) > ROUNDING * largest else "0" for value in values]


def _largest(rows: list[dict[str, Any]], name: str) -> float:
    return max((abs(value) for one in rows for value in one[name]), default=0.0)


def _unit(name: str, sheet: Robot, sliding: Container[str]) -> str:
    """The unit of a coordinate: m along prismatic joints, none for stretch and shear, else rad."""
    joints = {coordinate for joint in sheet.joints for coordinate in joint.coordinates}
    if name.removesuffix(".motor") in joints:
        return "m" if name in sliding else "rad"
    return "-" if name.rpartition(".")[2].startswith(("stretch", "shear")) else "rad"


def print_stiffness(info: dict[str, Any] | None) -> None:
    """Print a table of stiffness by direction and the elements that give most."""
    if info is None:
        return
    rows = []
    for one in info["directions"]:
        stiffness = "-" if one["why"] else "rigid" if one["stiffness"] is None else f"{one['stiffness']:.5g}"
        largest = sorted(one["shares"].items(), key=lambda item: -abs(item[1]))[:4]
        shares = ", ".join(f"{name} {share:.1%}" for name, share in largest if abs(share) >= 5e-4)
        rows.append([one["direction"], stiffness, one["unit"], one["why"] or shares])
    print_table(f"Stiffness at {info['point']}", ["direction", "stiffness", "unit", "share of the compliance"], rows)
