"""``tmodes compare``: controllers and references of one robot side by side on one task."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

import typer

from tmodes.cli.options import AsJson, FixInertia, Roots, Settings, TrustPaths, chosen_sheet
from tmodes.cli.terminal import print_result, working

__all__ = ["compare"]


def compare(
    robot: Annotated[
        list[str], typer.Argument(metavar="NAME|FILE...", help="The robot; or several sheets, each of them a variant.")
    ],
    variants: Annotated[
        Path | None, typer.Option(help="A YAML file: `variants`, and `uncertain`, `plan`, `tolerance`.")
    ] = None,
    runs: Annotated[
        int | None, typer.Option(min=1, help="Uncertain cases of each variant; else those of the file's plan. [200]")
    ] = None,
    tolerance: Annotated[
        str | None, typer.Option(help='Largest error of the tip that is accepted, "2 mm"; else that of the task.')
    ] = None,
    threads: Annotated[int | None, typer.Option(min=1, help="Threads; else one for each core.")] = None,
    out: Annotated[
        Path | None,
        typer.Option(help="A folder for page, table and figure, and all cases; the same command adds what is missing."),
    ] = None,
    reports: Annotated[
        bool, typer.Option("--reports", help="Also a report of each nominal run in --out, linked from the page.")
    ] = False,
    figure: Annotated[Path | None, typer.Option(help="A file for the figure: .svg, .png or .pdf.")] = None,
    overwrite: Annotated[
        bool, typer.Option("--overwrite", help="Replace the figure, and what another comparison left in the folder.")
    ] = False,
    settings: Settings = None,
    root: Roots = None,
    trust_paths: TrustPaths = False,
    fix_inertia: FixInertia = False,
    as_json: AsJson = False,
) -> None:
    """Rank variants of one robot on the same task, nominal and in the same uncertain cases; the best one first.

    A variant is a sheet, or a name in the file of --variants with what it changes, by paths: a whole controller or
    signal, a `control` section; `{}` is the robot as it is, `shaper: {kind: zvd}` its motion shaped. `uncertain` in
    that file is as `parameters` of a study; `relative: true`: factors on the actual robot, which no controller knows.

    Nominal are the largest error of the tip from its commanded path, that at the end, when it is at rest, its
    vibration, and the largest effort over its limit. Of the uncertain cases the worst, what 95 % stay below, and the
    share that fails, which did not end or exceeds the tolerance, with its interval.

    Example: tmodes compare two_link_arm --variants laws.yaml --runs 500 --figure league.svg

    Example, with a page and reports of all: tmodes compare two_link_arm --variants laws.yaml --out league --reports

    Example, two sheets: tmodes compare pd.yaml lqg.yaml --tolerance "1 mm"
    """
    from tmodes.errors import InputError
    from tmodes.interface.comparing import compare as found_of

    if variants is None and len(robot) < 2:
        hint = "write `--variants laws.yaml`, or name two data sheets"
        raise InputError("--variants", "nothing", "variants in a file, or several sheets", hint)
    how: dict[str, Any] = {"roots": root, "trust_paths": trust_paths, "fix_inertia": fix_inertia}
    sheets = {one: chosen_sheet(one, settings, **how) for one in dict.fromkeys(robot)}
    first, several = next(iter(sheets.values())), {Path(name).stem: one for name, one in sheets.items()}
    with working("preparing") as tell:
        found = found_of(
            first, variants or {}, sheets=several if len(several) > 1 else {}, runs=runs, tolerance=tolerance,
            threads=threads, out=out, reports=reports, figure=figure, overwrite=overwrite, progress=tell,
        )  # fmt: skip
    page = out and out / "compare.html"
    print_result(found, as_json, **({"files": {"page": str(page)}} if page else {}))
    if page and not as_json:
        print(f"All cases are in {out}.\nPage: {page}")
    if not any(one.nominal.good for one in found.contenders):
        raise typer.Exit(3)
