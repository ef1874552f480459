"""``tmodes learn``: the same move again and again, with setpoints that get better from run to run."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from tmodes.cli.options import AsJson, FixInertia, Roots, Settings, SheetArgument, TrustPaths, chosen_sheet
from tmodes.cli.terminal import print_result, working

__all__ = ["learn"]


def learn(
    robot: SheetArgument,
    iterations: Annotated[int, typer.Option(help="How many corrections.")] = 5,
    samples: Annotated[int, typer.Option(help="Instants of the run at which the setpoints are corrected.")] = 200,
    caution: Annotated[
        float, typer.Option(help="Regularization: larger learns slower, tolerates larger model errors.")
    ] = 0.03,
    by: Annotated[
        str, typer.Option(help="What shall follow: joints their signals, or the tip its commanded path.")
    ] = "joints",
    out: Annotated[Path | None, typer.Option(help="A file for the data sheet with the learnt setpoints.")] = None,
    figure: Annotated[Path | None, typer.Option(help="A file for the errors by run: .svg, .png or .pdf.")] = None,
    overwrite: Annotated[bool, typer.Option("--overwrite", help="Replace these files.")] = False,
    settings: Settings = None,
    root: Roots = None,
    trust_paths: TrustPaths = False,
    fix_inertia: FixInertia = False,
    as_json: AsJson = False,
) -> None:
    """Iterative learning control: setpoints corrected from run to run until the joints follow the sheet's signals.

    With --by tip until the tip, behind gears and links that bend, follows its commanded path. After each run of the
    actual robot, the setpoints are corrected by the inverse of the nominal closed loop, linearized about its start.
    What repeats is learnt: sag, friction, and what is not known exactly.

    Example: tmodes learn spong1987 --set real.gear.stiffness=0.8 --out learnt.yaml; tmodes run learnt.yaml
    """
    from tmodes.interface.learning import learn as found_of

    sheet = chosen_sheet(robot, settings, roots=root, trust_paths=trust_paths, fix_inertia=fix_inertia)
    with working("preparing") as tell:
        found = found_of(
            sheet, iterations=iterations, samples=samples, caution=caution, by=by, out=out, figure=figure,
            overwrite=overwrite, progress=tell,
        )  # fmt: skip
    print_result(found, as_json)
