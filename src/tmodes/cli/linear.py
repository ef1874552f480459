"""``tmodes linear``: the robot in small motions, with named inputs and outputs."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from tmodes.cli.options import AsJson, FixInertia, Roots, Settings, SheetArgument, TrustPaths, chosen_sheet
from tmodes.cli.static import PoseOption
from tmodes.cli.terminal import print_result, working

__all__ = ["linear"]


def linear(
    robot: SheetArgument,
    inputs: Annotated[
        str | None,
        typer.Option(
            metavar="NAME,...",
            help="Commands of drives and loads on points, such as shoulder.torque,tip.force.z; with --closed also "
            "shoulder.setpoint. Without: all drives.",
        ),
    ] = None,
    outputs: Annotated[
        str | None,
        typer.Option(metavar="NAME,...", help="Names of `tmodes outputs`, and sensors. Without: all driven joints."),
    ] = None,
    closed: Annotated[bool, typer.Option("--closed", help="Under the controllers of the sheet.")] = False,
    loop: Annotated[
        str | None, typer.Option(metavar="JOINT", help="The loop of this drive, opened at its command: its margins.")
    ] = None,
    period: Annotated[float | None, typer.Option(help="Sampled with a zero-order hold every so many seconds.")] = None,
    delay: Annotated[float, typer.Option(help="From a sample to its input [s], of any length.")] = 0.0,
    reduce: Annotated[int | None, typer.Option(help="A model with so many states, by the method.")] = None,
    method: Annotated[
        str | None, typer.Option(help="balanced (without: this), modal, or minimal, which finds how many states.")
    ] = None,
    at: PoseOption = None,
    time: Annotated[float | None, typer.Option(help="About this time of the run [s], not the equilibrium.")] = None,
    uncertain: Annotated[
        Path | None, typer.Option(help="A YAML file with `uncertain`, as of tmodes compare: uncertain robots.")
    ] = None,
    cases: Annotated[int, typer.Option(min=2, help="Number of uncertain robots.")] = 50,
    seed: Annotated[int, typer.Option(min=0, help="Same seed, same robots.")] = 0,
    out: Annotated[Path | None, typer.Option(help="Write it to a file: .mat, .npz or .json.")] = None,
    page: Annotated[Path | None, typer.Option(help="A file for a page with all charts and tables: arm.html.")] = None,
    figure: Annotated[Path | None, typer.Option(help="A file for the figure: .svg, .png or .pdf.")] = None,
    chart: Annotated[str, typer.Option(help="What the figure shows: bode, nyquist or step.")] = "bode",
    overwrite: Annotated[bool, typer.Option("--overwrite", help="Replace that figure.")] = False,
    settings: Settings = None,
    root: Roots = None,
    trust_paths: TrustPaths = False,
    fix_inertia: FixInertia = False,
    as_json: AsJson = False,
) -> None:
    """Linearization about the equilibrium: poles, zeros, and A, B, C, D for other tools.

    x' = A x + B u, y = C x + D u by exact derivatives of the equations, about the equilibrium at the first commands, or
    --at a pose; under the sheet's controllers with --closed, then with the margins of the loop of each drive. Zeros in
    the right half-plane (non-minimum phase) are named: such an output first moves the wrong way.

    Example: tmodes linear two_link_arm --inputs elbow.torque --outputs tip.acceleration.z,elbow.position
    """
    from tmodes.interface.files import write_files
    from tmodes.interface.linear import linearize

    sheet = chosen_sheet(robot, settings, roots=root, trust_paths=trust_paths, fix_inertia=fix_inertia)
    with working("preparing") as tell:
        found = linearize(
            sheet, at=at, time=time, inputs=inputs, outputs=outputs or (), closed=closed, loop=loop, period=period,
            delay=delay, uncertain=uncertain, cases=cases, seed=seed, progress=tell,
        )  # fmt: skip
        if reduce is not None or method is not None:
            found = found.reduce(reduce, method or "balanced")
        if figure is not None:
            write_files(None, found, figure, overwrite=overwrite, chart=chart)
        if out is not None:
            found.save(out)
        if page is not None:
            found.page(page)
    print_result(found, as_json, **({"files": {"page": str(page)}} if page else {}))
    if page and not as_json:
        print(f"Page: {page}")
