"""``tmodes optimize``: the best design of a study within its limits."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from tmodes.cli.options import AsJson, Roots, TrustPaths
from tmodes.cli.sensitivity import CasesFolder, Seed, StudyArgument, asked_study
from tmodes.cli.terminal import notice, print_json, print_table, working

if TYPE_CHECKING:
    from tmodes.study.optimize import Candidate, Optimum

__all__ = ["optimize"]

MOST_SHOWN = 10
NOTHING_FEASIBLE = 3


def optimize(
    study: StudyArgument,
    method: Annotated[
        str, typer.Option(help="auto, grid (all designs of a catalogue), gradient, tpe, or nsga2 (several objectives).")
    ] = "auto",
    trials: Annotated[
        int | None, typer.Option(min=1, help="Designs that tpe (else 200) or nsga2 (else 1000) tries.")
    ] = None,
    seed: Seed = 0,
    out: CasesFolder = None,
    root: Roots = None,
    trust_paths: TrustPaths = False,
    as_json: AsJson = False,
) -> None:
    """The best design of a study: what to minimize or maximize, within limits, among what may be chosen.

    The study says it under `optimize`: `objectives` such as `- minimize: mass`; `limits` such as `sag <= 1.5 mm`,
    `f1 >= 14 Hz` or `settle <= 0.4 s`, each a quantity or a formula, a relation, a number with its unit; `design`, the
    parameters that are chosen: a range of any number of the robot, or a catalogue. With `worst_case: 64` each design
    is judged by the worst of 64 cases of the other parameters, which are uncertain; with `percentile: 95` as well, by
    the case that 95 % of them do not exceed.

    Up to 20,000 designs of catalogues are all tried, and the optimum is exact. Where no simulation is needed, or the
    adjoint gives the slopes, a smooth problem is solved along its gradients. Otherwise Optuna tries designs, 16 side
    by side. Of several objectives the Pareto front is given: designs of which none is better in all.

    Exit code 3: no design keeps all limits; the one that exceeds them least is shown.

    Example: tmodes optimize tube.yaml

    Example, 500 designs, kept and resumable: tmodes optimize arm.yaml --method tpe --trials 500 --out arm-designs
    """
    from tmodes.study.optimize import optimize as best_design

    asked = asked_study(study, root, trust_paths=trust_paths)
    with working() as tell:
        found = best_design(asked, method, trials=trials, seed=seed, folder=out, progress=tell)
    page = None
    if out and (found.best or found.nearest):
        from tmodes.study.page.figures import write_designs

        with working("page", at_once=True):
            page = write_designs(found, asked, out / "designs.html")
    if as_json:
        print_json(found.info() | ({"files": {"page": str(page)}} if page else {}))
    else:
        _print(found)
        if out:
            print(f"All cases are in {out}." + (f"\nPage: {page}" if page else ""))
    if found.best is None:
        raise typer.Exit(NOTHING_FEASIBLE)


def _print(found: Optimum) -> None:
    how = "every design tried, so the optimum is exact" if found.exact else _METHODS[found.method]
    counts = f"{found.designs:,} designs, {found.feasible:,} feasible"
    failed = f", {found.failed:,} failed" if found.failed else ""
    cases = f", {found.cases:,} cases" if found.cases != found.designs else ""
    runs = f", {found.gradients:,} runs with gradients" if found.gradients else ""
    print(f"{found.name}: {counts}{failed}{cases}{runs} ({how})\n")
    if found.front:
        _print_designs(found, f"Pareto front ({len(found.front)} designs)", found.front)
    elif found.best:
        _print_designs(found, "Best designs", found.ranked[:MOST_SHOWN])
    elif found.nearest:
        _print_nearest(found, found.nearest)
    if found.best and not found.front:
        _print_limits(found, found.best)


_METHODS = {
    "gradient": "along gradients: a local optimum",
    "tpe": "tree-structured Parzen estimators: a better design may exist",
    "nsga2": "NSGA-II: better designs may exist",
}


def _print_designs(found: Optimum, title: str, designs: tuple[Candidate, ...]) -> None:
    """One row for each design: what is chosen, the objectives, the quantities of the limits."""
    first = designs[0]
    objectives = [text.partition(" ")[2] for text in found.objectives]
    columns = [*first.values, *(_with_unit(found, text) for text in objectives), *(one.text for one in first.limits)]
    rows = [
        [
            *(one.choices.get(name, f"{value:.6g}") for name, value in one.values.items()),
            *(f"{value:.6g}" for value in one.objectives),
            *(f"{limit.value:.5g}" for limit in one.limits),
        ]
        for one in designs
    ]
    print_table(title, columns, rows)


def _with_unit(found: Optimum, text: str) -> str:
    unit = found.units.get(text, "-")
    return text if unit == "-" else f"{text} [{unit}]"


def _print_limits(found: Optimum, best: Candidate) -> None:
    """How far the best design is from its limits, and what each limit costs."""
    for limit in best.limits:
        lost = found.lost_to[limit.text]
        state = "is active" if limit.active else f"has {limit.margin:.1%} left"
        price = found.prices.get(limit.text)
        cost = "" if price is None else f"; the objective changes by {price:.4g} for each {_of(limit.unit)} of it"
        print(f"{limit.text} {state}{cost}; {lost:,} designs exceed it")


def _of(unit: str) -> str:
    return "unit" if unit == "-" else unit


def _print_nearest(found: Optimum, nearest: Candidate) -> None:
    """No design is feasible: the one that is nearest to it."""
    shown = ", ".join(f"{name} = {nearest.choices.get(name, f'{value:.6g}')}" for name, value in nearest.values.items())
    notice(f"no design keeps all limits; the one that exceeds them least: {shown}")
    for limit in nearest.limits:
        if limit.margin < 0:
            unit = "" if limit.unit == "-" else f" {limit.unit}"
            notice(f"  {limit.text}: {limit.value:.5g}{unit}, exceeded by {-limit.margin:.2%}")
    if nearest.reason:
        notice(f"  a case of it failed: {nearest.reason}")
    for text, lost in found.lost_to.items():
        notice(f"  {text} is exceeded by {lost:,} of {found.designs:,} designs")
