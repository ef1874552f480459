"""``tmodes tune``: gains of a robot's laws for a small error, of the robot as known or in the worst case."""

from __future__ import annotations

import time as clock
from collections.abc import Callable
from pathlib import Path
from typing import Annotated

import typer

from tmodes.cli.options import AsJson, FixInertia, Roots, Settings, SheetArgument, TrustPaths, chosen_sheet
from tmodes.cli.terminal import Stages, print_result, working

__all__ = ["tune"]


def tune(
    robot: SheetArgument,
    gains: Annotated[
        list[str] | None,
        typer.Option("--gain", metavar="PATH", help="A gain that is tuned; may be given often. [all of all laws]"),
    ] = None,
    minimize: Annotated[str, typer.Option(help="What is made small: a name of `tmodes outputs`.")] = "tip_error",
    reduce: Annotated[str, typer.Option(help="Its number of a run: rms, mean, end, max, max_abs ...")] = "rms",
    against: Annotated[
        str | None, typer.Option(help="Weigh it against this output, too: a curve of designs, none better in both.")
    ] = None,
    against_reduce: Annotated[str, typer.Option(help="The number of a run of that output.")] = "rms",
    uncertain: Annotated[
        Path | None, typer.Option(help="A YAML file with `uncertain`, as of tmodes compare: tune for the worst case.")
    ] = None,
    worst_case: Annotated[int, typer.Option(min=2, help="Uncertain robots of which the worst counts.")] = 16,
    within: Annotated[float, typer.Option(help="Search range: each gain over, and times, this factor.")] = 10.0,
    method: Annotated[
        str, typer.Option(help="auto, gradient, cobyqa or tpe; with --against compromise or nsga2.")
    ] = "auto",
    trials: Annotated[
        int | None,
        typer.Option(
            min=1, help="Compromises with --against (8); designs that cobyqa, tpe (200) or nsga2 (1000) tries."
        ),
    ] = None,
    seed: Annotated[int, typer.Option(min=0, help="Same seed, same uncertain robots.")] = 0,
    out: Annotated[Path | None, typer.Option(help="A file for the data sheet with the gains.")] = None,
    page: Annotated[Path | None, typer.Option(help="A file for a page with all designs: tuned.html.")] = None,
    figure: Annotated[Path | None, typer.Option(help="A file for the figure: .svg, .png or .pdf.")] = None,
    overwrite: Annotated[bool, typer.Option("--overwrite", help="Replace these files.")] = False,
    settings: Settings = None,
    root: Roots = None,
    trust_paths: TrustPaths = False,
    fix_inertia: FixInertia = False,
    as_json: AsJson = False,
) -> None:
    """Tune the gains of any controller: before and after, and what limits them.

    Gains are those of controllers and of blocks in `control`; of LQR and LQG the weights. They follow gradients of the
    run (its adjoint), through samples too, for `rms`, `mean` or `end` of an output. Otherwise, and
    where the best gains would exceed the limits of the drives, `cobyqa` finds them, which needs no derivatives and
    keeps these limits. It is what `tmodes optimize` does with a study of these gains.

    Example: tmodes tune spong1987 --out tuned.yaml

    Example, error against effort: tmodes tune spong1987 --against joint.effort --page tuned.html

    Example, for the worst of 32 robots: tmodes tune two_link_arm --uncertain laws.yaml --worst-case 32
    """
    from tmodes.interface.tuning import tune as found_of

    sheet = chosen_sheet(robot, settings, roots=root, trust_paths=trust_paths, fix_inertia=fix_inertia)
    with working("preparing") as tell:
        found = found_of(
            sheet, gains or (), minimize=minimize, reduce=reduce, against=against,
            against_reduce=against_reduce, uncertain=uncertain, worst_case=worst_case,
            within=within, method=method, trials=trials, seed=seed, out=out, figure=figure, overwrite=overwrite,
            progress=_with_time_left(tell),
        )  # fmt: skip
        if page is not None:
            found.page(page)
    print_result(found, as_json, **({"files": {"page": str(page)}} if page else {}))
    if page and not as_json:
        print(f"Page: {page}")


def _with_time_left(tell: Stages) -> Callable[[str, float], None]:
    """Progress that says how long compromises will still take, by those that were found."""
    from tmodes.cli.study import remaining
    from tmodes.study.optimize.compromise import COMPROMISES

    began: dict[str, float] = {}

    def stage_of(stage: str, share: float) -> None:
        passed = clock.monotonic() - began.setdefault(stage, clock.monotonic())
        known = stage == COMPROMISES and 0 < share < 1
        tell(stage, share, f"about {remaining(passed * (1 - share) / share)} left" if known else "")

    return stage_of
