"""``tmodes ladder``: the model hierarchy of a robot's links: the cost and error of each model, and a recommendation."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from tmodes.cli.options import AsJson, Roots, Settings, SheetArgument, TrustPaths, chosen_sheet
from tmodes.cli.output import notice, print_json, print_table
from tmodes.cli.progress import working

if TYPE_CHECKING:
    from tmodes.analysis.hierarchy.hierarchy import Ladder, Rung

__all__ = ["ladder"]

UNITS = {
    "frequencies_Hz": "Hz, motors locked, about rest",
    "sag_m": "m, tip at rest off the undeformed arm's",
    "cost_us": "us, one forward dynamics, native, median",
    "highest_eigenvalue": "1/s, an explicit step must be below about 2.8 over it",
    "tip_difference_m": "m, largest along the move, to the finest rung",
    "tip_error": "1, of the largest deflection of the tip along the move",
    "frequency_error": "1, of the first frequency",
    "deflection_m": "m, largest deflection of the tip along the move, by the finest rung",
}


def ladder(
    robot: SheetArgument,
    tolerance: Annotated[float, typer.Option(help="Share of the tip's deflection that a model may be off.")] = 1e-3,
    finest: Annotated[int, typer.Option(min=1, max=12, help="Functions of the finest rung, each direction.")] = 6,
    settings: Settings = None,
    root: Roots = None,
    trust_paths: TrustPaths = False,
    as_json: AsJson = False,
) -> None:
    """The ladder of link models: rigid, segments, modes, strain with more and more functions, against the finest.

    All rungs make the same move, which the motors follow exactly: that of the sheet's drives, else a short one.
    """
    from tmodes.analysis.hierarchy.hierarchy import ladder as climbed

    arm = chosen_sheet(robot, settings, roots=root, trust_paths=trust_paths)
    with working() as tell:
        found = climbed(arm, tolerance, finest=finest, progress=tell)
    if as_json:
        print_json({"units": UNITS, **found.as_data()})
    else:
        _print(found)


def _print(found: Ladder) -> None:
    columns = ["model", "coordinates", "first [Hz]", "sag [mm]", "tip off by [mm]", "of deflection", "first off by",
               "one step [us]", "fastest [1/s]", ""]  # fmt: skip
    title = f"{found.robot}: {found.move}; the tip deflects by up to {found.deflection_m * 1e3:.4g} mm"
    print_table(title, columns, [_row(rung, found) for rung in found.rungs])
    print(f"Within {found.tolerance:g} of {found.rungs[-1].model}, the cheapest is {found.recommended}.")
    if not found.converged:
        info = f"{found.rungs[-2].model} is not within the tolerance of {found.rungs[-1].model}"
        notice(f"{info}: that itself may be off by more; add --finest {len(found.rungs) - 1}")
    if all(rung.tip_error is None for rung in found.rungs):
        notice("the tip does not deflect in this move, so only frequencies are compared: is `tip` on the right link?")
    for rung in found.rungs:
        if rung.why:
            notice(f"{rung.model}: {rung.why}")


def _row(rung: Rung, found: Ladder) -> list[str]:
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
        f"{rung.highest_eigenvalue:.3g}",
        "<- take this" if rung.model == found.recommended else "",
    ]


def _share(error: float | None) -> str:
    return "-" if error is None else f"{error:.1e}"
