"""``tmodes sensitivity``: which parameters of a study make its quantities vary, and how sure that is."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from tmodes.cli.memory import prepare_study
from tmodes.cli.options import AsJson, Roots, TrustPaths
from tmodes.cli.study import notice_slow
from tmodes.cli.terminal import print_result, working

if TYPE_CHECKING:
    from tmodes.study.sensitivity import Sensitivity
    from tmodes.study.study import Study

__all__ = ["CasesFolder", "Seed", "StudyArgument", "asked_study", "sensitivity"]

StudyArgument = Annotated[Path, typer.Argument(metavar="STUDY.yaml", help="A study file; see docs/studies.md.")]
Seed = Annotated[int, typer.Option(min=0, help="Same seed, same cases.")]
CasesFolder = Annotated[
    Path | None, typer.Option(help="A folder for all cases; the same command resumes what was interrupted.")
]


def asked_study(path: Path, roots: list[Path] | None, *, trust_paths: bool) -> Study:
    """The study of a file; what makes it slow is said."""
    prepare_study()
    from tmodes.study.read import read_study

    with working("reading", at_once=True):
        asked = read_study(path, roots=roots or (), trust_paths=trust_paths)
    notice_slow(asked)
    return asked


def sensitivity(
    study: StudyArgument,
    method: Annotated[
        str, typer.Option(help="sobol: shares of the variance. morris: size of effects, from far fewer cases.")
    ] = "sobol",
    samples: Annotated[
        int | None,
        typer.Option(help="sobol: a power of two, 1024 if left out, times the parameters and 2 cases. morris: 64."),
    ] = None,
    seed: Seed = 0,
    second_order: Annotated[
        bool, typer.Option("--second-order", help="sobol: also for pairs of parameters, from nearly twice as many.")
    ] = False,
    out: CasesFolder = None,
    root: Roots = None,
    trust_paths: TrustPaths = False,
    as_json: AsJson = False,
) -> None:
    """Global sensitivity of quantities to parameters, with confidence intervals.

    Each parameter has a share of the variance of each quantity: `first` is what it makes by itself, `total` what it
    makes alone and together with others. A parameter whose total is near 0 may stay at any value; if the totals add up
    to much more than 1, parameters act together. The numbers after ± are half of a 95 % confidence interval: four
    times as many samples make it half as wide, or less.

    With --method morris: the mean size of the change of a quantity when a parameter goes through its whole range, and
    how much this change itself varies (spread): a quick way to find the few of many parameters that matter.

    The plan in the study file is not used. Cases that fail are left out; the table says by how much this may change an
    index. More than 5 % are refused. Parameters must not be correlated.

    Example: tmodes sensitivity gear.yaml

    Example, kept and resumable, four times as many samples: tmodes sensitivity gear.yaml --samples 4096 --out
    gear-indices
    """
    from tmodes.study.sensitivity import sensitivity as analyse

    asked = asked_study(study, root, trust_paths=trust_paths)
    with working() as tell:
        found = analyse(asked, method, samples=samples, seed=seed, second_order=second_order, out=out, progress=tell)
        page = _page(found, out, tell) if out else None
    print_result(found, as_json, **({"files": {"page": str(page)}} if page else {}))
    if page and not as_json:
        print(f"All cases are in {out}.\nPage: {page}")


def _page(found: Sensitivity, folder: Path, tell: Callable[[str, float], None]) -> Path:
    """The page of the study in the folder, with the indices."""
    from tmodes.study.page import write_page
    from tmodes.study.page.figures import indices_of
    from tmodes.study.result import load_study

    more = {"indices": indices_of(found), "sentence": found.sentence, "answers": found.answers}
    return write_page(load_study(folder), folder / "study.html", progress=tell, **more)
