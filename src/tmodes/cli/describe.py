"""``tmodes describe`` and ``tmodes ladder``: a robot in numbers, and the hierarchy of models of its links."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Any

import typer

from tmodes.cli.options import AsJson, FixInertia, Roots, Settings, SheetArgument, TrustPaths, chosen_sheet
from tmodes.cli.static import PoseOption, pose_of
from tmodes.cli.statics_text import circumstances, numbers, print_stiffness, which_robot
from tmodes.cli.terminal import notice, print_json, print_known, print_table, warn, working

if TYPE_CHECKING:
    from tmodes.simulation.hierarchy.hierarchy import Ladder, Rung

__all__ = ["describe", "ladder"]


def describe(
    robot: SheetArgument,
    at: PoseOption = None,
    settings: Settings = None,
    root: Roots = None,
    trust_paths: TrustPaths = False,
    fix_inertia: FixInertia = False,
    as_json: AsJson = False,
) -> None:
    """Masses, lengths, stiffnesses, frequencies of each link by itself, sag under weight, stiffness at the tip."""
    from tmodes.analysis.describe.describe import describe as described

    sheet = chosen_sheet(robot, settings, roots=root, trust_paths=trust_paths, fix_inertia=fix_inertia)
    with working("preparing") as tell:
        info = described(sheet, pose_of(at, sheet), progress=tell)
    if as_json:
        print_json(info)
        return
    _print(info, circumstances(sheet, contact=False, loads=False, at=at), which_robot(sheet))
    warn(info["warnings"])


def _print(info: dict[str, Any], where: str, whose: str) -> None:
    print(f"{info['name']}: {info['title'] or 'a robot'}")
    count = len(info["coordinates"])
    moves = "coordinate" if count == 1 else "coordinates" if count else "coordinates (nothing in it moves or bends)"
    print(f"{count or 'no'} {moves}, {info['total_mass_kg']:.4g} kg")
    for note in info["notes"]:
        print(f"note: {note}")
    joints = [[one["name"], one["type"], one["kind"], one["carries"], one["command"] or _undriven(one), _limits(one)]
              for one in info["joints"]]  # fmt: skip
    print_known("Joints (A active, L locked, F free; E elastic, R rigid gear)",
                ["joint", "type", "kind", "carries", "drive", "limits"], joints)  # fmt: skip
    columns = ["link", "model", "mass [kg]", "length [m]", "EI y, z [N*m^2]", "GJ [N*m^2]", "EA [N]",
               "alone y, z [Hz]"]  # fmt: skip
    print_known("Links", columns, [_link(one) for one in info["links"]])
    for one in info["links"]:
        if "equivalent_mass_kg" in one:
            print(f"link {one['name']}: {one['equivalent_mass_kg']:.4g} kg in the equations, 33/140 of each mode's "
                  "mass at its tip")  # fmt: skip
    if info["gears"]:
        gears = [[one["joint"], ", ".join(f"{k:.4g}" for k in one["stiffness"]), one["unit"],
                  _number(one["stiffness_over_EI_per_L"])] for one in info["gears"]]  # fmt: skip
        print_known("Gears", ["joint", "stiffness", "unit", "over EI/L of the link"], gears)
    if info["springs"]:
        springs = [[one["joint"], *map(_number, (one["stiffness"], one["rest"], one["damping"])), one["unit"]]
                   for one in info["springs"]]  # fmt: skip
        print_known("Springs of joints", ["joint", "stiffness", "rest", "damping", "unit of stiffness"], springs)
    if sag := info["sag"]:
        if sag["displacement_m"] is None:
            place = ", ".join(numbers(sag["position_m"], 1.0, 1.0))
            print(f"Sag of the tip under weight: none, a joint is free; it comes to rest at {place} m (x, y, z)")
        else:
            travel = ", ".join(numbers(sag["displacement_m"], 1e3, 1.0))
            print(f"Sag of the tip under weight: {travel} mm (x, y, z), turned by {sag['rotation_rad']:.4g} rad")
        print(f"Sag and stiffness{whose}: {where}\n")
    print_stiffness(info["stiffness"])


def _link(one: dict[str, Any]) -> list[str]:
    bending = [one.get(f"bending_stiffness_{axis}_Nm2") for axis in ("y", "z")]
    bare = [one.get(f"bare_bend_{axis}_Hz") for axis in ("y", "z")]
    others = [_ends(one.get(name)) for name in ("torsional_stiffness_Nm2", "axial_stiffness_N")]
    shown = ", ".join(_ends(pair) for pair in bending) if bending[0] else "-"
    rings = ", ".join(_number(value) for value in bare) if "bare_bend_y_Hz" in one else "-"
    return [one["name"], one["model"], f"{one['mass_kg']:.4g}", _number(one["length_m"]), shown, *others, rings]


def _undriven(one: dict[str, Any]) -> str:
    """What a joint without a drive does."""
    return "free" if one["state"] == "free" else "held"


def _ends(pair: list[float | None] | None) -> str:
    """A number that is the same at both ends, or both; ``rigid`` for none."""
    if pair is None:
        return "-"
    info = ["rigid" if value is None else f"{value:.4g}" for value in pair]
    return info[0] if info[0] == info[1] else f"{info[0]} to {info[1]}"


def _number(value: float | None) -> str:
    return "-" if value is None else f"{value:.4g}"


def _limits(one: dict[str, Any]) -> str:
    if one["lower"] is None and one["upper"] is None:
        return "-"
    return f"{_number(one['lower'])} to {_number(one['upper'])} {one['unit']}"


UNITS = {
    "frequencies_Hz": "Hz, motors locked, about rest",
    "sag_m": "m, tip at rest off the undeformed robot's",
    "cost_us": "us, one forward dynamics, native, median",
    "highest_eigenvalue": "1/s, an explicit step must be below about 2.8 over it",
    "tip_difference_m": "m, largest in the motion, to the finest rung",
    "tip_error": "1, of the largest deflection of the tip in the motion",
    "frequency_error": "1, of the first frequency",
    "deflection_m": "m, largest deflection of the tip in the motion, by the finest rung",
}


def ladder(
    robot: SheetArgument,
    tolerance: Annotated[float, typer.Option(help="Share of the tip's deflection that a model may be off.")] = 1e-3,
    finest: Annotated[int, typer.Option(min=1, max=12, help="Functions of the finest rung, each direction.")] = 6,
    settings: Settings = None,
    root: Roots = None,
    trust_paths: TrustPaths = False,
    fix_inertia: FixInertia = False,
    as_json: AsJson = False,
) -> None:
    """The ladder of link models: rigid, segments, modes, strain with more and more functions, against the finest.

    All rungs make the sheet's own motion under its own loads: motors at their setpoints where the drives command
    positions, else as efforts, voltages and controllers move them. A robot that nothing in its sheet moves makes a
    short move of all joints.
    """
    from tmodes.simulation.hierarchy.hierarchy import ladder as climbed

    sheet = chosen_sheet(robot, settings, roots=root, trust_paths=trust_paths, fix_inertia=fix_inertia)
    with working("preparing") as tell:
        found = climbed(sheet, tolerance, finest=finest, progress=tell)
    if as_json:
        print_json({"units": UNITS, **found.as_data()})
    else:
        _print_ladder(found)


def _print_ladder(found: Ladder) -> None:
    columns = ["model", "coordinates", "first mode [Hz]", "sag [mm]", "tip error [mm]", "of deflection",
               "frequency error", "evaluation [us]", "fastest [1/s]", ""]  # fmt: skip
    title = f"{found.robot}: {found.move}; the tip deflects by up to {found.deflection_m * 1e3:.4g} mm"
    print_table(title, columns, [_rung_row(rung, found) for rung in found.rungs])
    print(
        f"Recommended: {found.recommended}, the cheapest within {_share(found.tolerance)} of {found.rungs[-1].model}."
    )
    if not found.converged:
        info = f"{found.rungs[-2].model} is not within the tolerance of {found.rungs[-1].model}"
        notice(f"{info}: that itself may be off by more; add --finest {len(found.rungs) - 1}")
    if all(rung.tip_error is None for rung in found.rungs):
        notice("the tip does not deflect in this motion, so only frequencies are compared: is `tip` on the right link?")
    for rung in found.rungs:
        if rung.why:
            notice(f"{rung.model}: {rung.why}")


def _rung_row(rung: Rung, found: Ladder) -> list[str]:
    last = rung is found.rungs[-1]
    off = "-" if rung.tip_difference_m is None or last else f"{rung.tip_difference_m * 1e3:.4g}"
    return [
        rung.model,
        str(rung.coordinates),
        f"{rung.frequencies_Hz[0]:.4f}" if rung.frequencies_Hz else "-",
        f"{rung.sag_m * 1e3:.4f}",
        off,
        "-" if last else _share(rung.tip_error),
        "-" if last else _share(rung.frequency_error),
        f"{rung.cost_us:.2f}",
        "-" if rung.highest_eigenvalue is None else f"{rung.highest_eigenvalue:.3g}",
        "<- recommended" if rung.model == found.recommended else "",
    ]


def _share(error: float | None) -> str:
    return "-" if error is None else f"{100 * error:.2g} %" if error < 1 else f"{100 * error:.0f} %"
