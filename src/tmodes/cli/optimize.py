"""``tmodes optimize``: the best design of a study within its limits."""

from __future__ import annotations

from typing import Annotated

import typer

from tmodes.cli.options import AsJson, Roots, TrustPaths
from tmodes.cli.sensitivity import CasesFolder, Seed, StudyArgument, asked_study
from tmodes.cli.terminal import print_result, working

__all__ = ["optimize"]

NOTHING_FEASIBLE = 3


def optimize(
    study: StudyArgument,
    method: Annotated[
        str, typer.Option(help="auto, grid (all of a catalogue), gradient, cobyqa, tpe, or nsga2 (several objectives).")
    ] = "auto",
    trials: Annotated[
        int | None, typer.Option(min=1, help="Designs that tpe or cobyqa (else 200) or nsga2 (else 1000) tries.")
    ] = None,
    seed: Seed = 0,
    out: CasesFolder = None,
    root: Roots = None,
    trust_paths: TrustPaths = False,
    as_json: AsJson = False,
) -> None:
    """Design optimization: objectives, constraints and design variables of a study file.

    The study file has a section `optimize`: `objectives` such as `- minimize: mass`; `limits` such as `sag <= 1.5 mm`,
    `f1 >= 14 Hz` or `settle <= 0.4 s`, each a quantity or a formula, a relation, a number with its unit; `design`, the
    parameters that are chosen: a range of any number of the robot, or a catalogue. With `worst_case: 64` each design
    is judged by the worst of 64 cases of the other parameters, which are uncertain; with `percentile: 95` as well, by
    the case that 95 % of them do not exceed.

    Up to 20,000 designs of catalogues are all tried, and the optimum is exact. Where no simulation is needed, or the
    adjoint gives the gradients, a smooth problem is solved by them. Otherwise Optuna tries designs, 16 side by side. Of
    several objectives the Pareto front is given: designs of which none is better in all.

    Exit code 3: no design keeps all limits; the one that exceeds them least is shown.

    Example: tmodes optimize tube.yaml

    Example, 500 designs, kept and resumable: tmodes optimize arm.yaml --method tpe --trials 500 --out arm-designs
    """
    from tmodes.study.optimize import optimize as best_design

    asked = asked_study(study, root, trust_paths=trust_paths)
    with working() as tell:
        found = best_design(asked, method, trials=trials, seed=seed, out=out, progress=tell)
    page = None
    if out and (found.best or found.nearest):
        from tmodes.study.page.figures import write_designs

        with working("page", at_once=True):
            page = write_designs(found, asked, out / "designs.html")
    print_result(found, as_json, **({"files": {"page": str(page)}} if page else {}))
    if out and not as_json:
        print(f"All cases are in {out}." + (f"\nPage: {page}" if page else ""))
    if found.best is None:
        raise typer.Exit(NOTHING_FEASIBLE)
