"""``tmodes study``: many cases of one robot by a plan; a table, a page, and what the quantities show."""

from __future__ import annotations

import time as clock
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from tmodes.cli import options
from tmodes.cli.memory import prepare_study
from tmodes.cli.run import folder_name
from tmodes.cli.terminal import notice, print_result, working
from tmodes.errors import InputError

if TYPE_CHECKING:
    from tmodes.cli.terminal import Stages
    from tmodes.study.study import Study

__all__ = ["Rate", "notice_slow", "resources", "study"]


def study(
    sheet: Annotated[Path, typer.Argument(metavar="STUDY.yaml", help="A study file; see docs/studies.md.")],
    on: Annotated[
        str,
        typer.Option(metavar="PLACE", help="local, dask://HOST:PORT, dask+tls://HOST:PORT, slurm, or gpu."),
    ] = "local",
    out: Annotated[Path | None, typer.Option(help="Folder of the study; else results/NAME.")] = None,
    settings: options.Settings = None,
    runs: Annotated[int | None, typer.Option(min=1, help="Number of cases, in place of the plan's own.")] = None,
    threads: Annotated[int | None, typer.Option(min=1, help="Threads; else one for each core.")] = None,
    recompute: Annotated[
        bool, typer.Option("--recompute", help="Compute again what another version of the engine has computed.")
    ] = False,
    overwrite: Annotated[bool, typer.Option("--overwrite", help="Remove another study from the folder.")] = False,
    page: Annotated[bool, typer.Option("--page/--no-page", help="Write study.html.")] = True,
    insecure: Annotated[
        bool, typer.Option("--insecure", help="Reach other machines without TLS: only in a network that you trust.")
    ] = False,
    tls: Annotated[
        Path | None, typer.Option(metavar="DIR", help="Folder with ca.pem, cert.pem and key.pem, for other machines.")
    ] = None,
    resource: Annotated[
        list[str] | None,
        typer.Option(metavar="KEY=VALUE", help="What Slurm is asked for: jobs, cores, memory, queue, walltime ..."),
    ] = None,
    root: options.Roots = None,
    trust_paths: options.TrustPaths = False,
    as_json: options.AsJson = False,
) -> None:
    """Run a study: many robots of one data sheet by a plan, and the quantities that are asked of each.

    Writes table.parquet (a row for each case: parameters, quantities, status and reason) and study.html into its
    folder. What is finished is kept: the same command resumes an interrupted study, and computes only what is missing
    when cases or quantities were added. A case that fails is a row with its reason; exit code 3 only if all failed.

    Example: tmodes study gear-stiffness.yaml --runs 10000

    Example, on workers of a Dask scheduler: tmodes study gear-stiffness.yaml --on dask://127.0.0.1:8786
    """
    prepare_study()
    from tmodes.interface.studies import changed_study
    from tmodes.io.assignment import parse_assignment
    from tmodes.study.read import read_study
    from tmodes.study.runner import run_study

    given = resources(resource or [])
    with working() as stages:
        stages("reading", 0.0)
        changes = dict(parse_assignment(text) for text in settings or [])
        asked = changed_study(read_study(sheet, roots=root or (), trust_paths=trust_paths), changes, runs)
        notice_slow(asked)
        place = out or Path("results") / folder_name(asked.sheet.name)
        result = run_study(
            asked, place, on, threads=threads, recompute=recompute, overwrite=overwrite, insecure=insecure, tls=tls,
            resources=given, progress=Rate(stages, asked), notice=notice,
        )  # fmt: skip
        if page:
            from tmodes.study.page import write_page

            stages("page", 0.0)
            write_page(result, place / "study.html", progress=stages)
    print_result(result, as_json)
    if not result.info()["good"]:
        raise typer.Exit(3)


def notice_slow(study: Study) -> None:
    """Say which quantities make a study slow."""
    slow = [name for name, one in study.sheet.quantities.items() if one.needs().result]
    if slow:
        names, verb = ", ".join(slow), "needs" if len(slow) == 1 else "need"
        notice(f"{names} {verb} the whole result of each case, which is run by itself: slow")


def resources(texts: list[str]) -> dict[str, str]:
    """``KEY=VALUE`` texts by their keys."""
    for text in texts:
        if "=" not in text:
            raise InputError("--resource", ascii(text)[:80], "KEY=VALUE", "write --resource cores=8")
    return {key.strip(): value.strip() for key, _, value in (text.partition("=") for text in texts)}


class Rate:
    """Progress of cases with their rate and the remaining time; other stages as they are.

    What was stored before is not counted in the rate: it begins where the first report stands.
    """

    def __init__(self, stages: Stages, asked: Study) -> None:
        self._stages = stages
        self._cases = asked.cases
        self._start: tuple[float, float] | None = None

    def __call__(self, stage: str, share: float) -> None:
        """Report a share of a stage."""
        if stage != "cases":
            self._stages(stage, share)
            return
        now = clock.monotonic()
        self._start = self._start or (now, share)
        self._stages(stage, share, self._note(share, now))

    def _note(self, share: float, now: float) -> str:
        began, start = self._start or (now, share)
        done = f"{share * self._cases:,.0f} of {self._cases:,}"
        if share <= start or now <= began:
            return done
        speed = (share - start) / (now - began)
        return f"{done}, {speed * self._cases:,.3g} 1/s, {remaining((1.0 - share) / speed)} left"


def remaining(seconds: float) -> str:
    """A time as a person says it."""
    if seconds < 90:
        return f"{seconds:.0f} s"
    return f"{seconds / 60:.0f} min" if seconds < 5400 else f"{seconds / 3600:.1f} h"
