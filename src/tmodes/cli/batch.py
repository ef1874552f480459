"""``tmodes batch``: the short form of a study, many runs of one robot with some of its numbers varied."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from tmodes.cli import options
from tmodes.cli.terminal import print_result, working

__all__ = ["batch"]

MOST_CASES = 1_000_000


def batch(
    robot: options.SheetArgument,
    vary: Annotated[
        list[str] | None,
        typer.Option(metavar="PATH=LOW:HIGH:COUNT", help="Evenly spaced numbers; of several, all combinations."),
    ] = None,
    draw: Annotated[
        list[str] | None, typer.Option(metavar="PATH=LOW:HIGH", help="Random numbers, uniform; with --runs and --seed.")
    ] = None,
    runs: Annotated[int, typer.Option(min=1, max=MOST_CASES, help="How many runs --draw makes.")] = 100,
    seed: Annotated[int, typer.Option(min=0, help="Same seed, same numbers.")] = 0,
    settings: options.Settings = None,
    integrator: options.IntegratorOption = None,
    rtol: options.Tolerance = None,
    atol: options.AbsoluteTolerance = None,
    duration: options.Duration = None,
    threads: Annotated[int | None, typer.Option(min=1, help="Threads; else one for each core.")] = None,
    out: Annotated[
        Path | None, typer.Option(help="A folder for all samples; without it only the table is shown.")
    ] = None,
    root: options.Roots = None,
    trust_paths: options.TrustPaths = False,
    fix_inertia: options.FixInertia = False,
    as_json: options.AsJson = False,
) -> None:
    """Many runs at once with numbers varied: a sweep (--vary) or a Monte Carlo study (--draw).

    The short form of `tmodes study`, which has other plans, distributions and quantities, and keeps what it has done.
    Each run is the actual robot under control, as of `tmodes run`, compared with the run of the sheet as it stands: the
    distance of their tips. Everything is checked before anything runs. A run that cannot continue is named, and
    disturbs no other. The folder of --out holds states.npy, tips.npy, times.npy and batch.json;
    tmodes.simulation.batch.result.load_batch("FOLDER") reads them.

    Example, a gear whose stiffness is known to 20 %: tmodes batch filipovic2010
    --draw real.gear.stiffness=0.16:0.24 --runs 1000

    Example, payload and damping, 11 by 3 runs: tmodes batch filipovic2010 --vary payload.mass=0.4:0.6:11
    --vary gear.damping=0:4:3

    Example, noise on the position that the controller receives, 100 seeds: tmodes batch filipovic2010
    --set reference.noise.deviation=1e-4 --vary reference.noise.seed=0:99:100
    """
    from tmodes.interface.batches import batch as found_of

    sheet = options.chosen_sheet(robot, settings, roots=root, trust_paths=trust_paths, fix_inertia=fix_inertia)
    with working() as tell:
        found = found_of(
            sheet, vary=vary or (), draw=draw or (), runs=runs, seed=seed, integrator=integrator, rtol=rtol, atol=atol,
            duration=duration, threads=threads, out=out, progress=tell,
        )  # fmt: skip
    print_result(found, as_json)
    if not found.complete:
        raise typer.Exit(130 if "interrupted" in found.rows.status else 3)
