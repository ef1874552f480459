"""``tmodes batch``: many runs of one robot with some of its numbers varied, and how far their tips part."""

from __future__ import annotations

from math import isfinite, prod
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from tmodes.cli import options
from tmodes.cli.terminal import notice, print_json, print_table, working
from tmodes.errors import InputError

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from tmodes.simulation.batch.result import BatchRun
    from tmodes.simulation.vary.study import Spread

__all__ = ["batch"]

MOST_LANES = 1_000_000
MOST_REPORTED = 5
"""Cases that did not finish, reported one by one."""


def batch(
    robot: options.SheetArgument,
    vary: Annotated[
        list[str] | None,
        typer.Option(metavar="PATH=LOW:HIGH:COUNT", help="Evenly spaced numbers; of several, all combinations."),
    ] = None,
    draw: Annotated[
        list[str] | None, typer.Option(metavar="PATH=LOW:HIGH", help="Random numbers, uniform; with --runs and --seed.")
    ] = None,
    runs: Annotated[int, typer.Option(min=1, max=MOST_LANES, help="How many runs --draw makes.")] = 100,
    seed: Annotated[int, typer.Option(min=0, help="Same seed, same numbers.")] = 0,
    settings: options.Settings = None,
    integrator: options.IntegratorOption = None,
    rtol: options.Tolerance = None,
    atol: options.AbsoluteTolerance = None,
    duration: options.Duration = None,
    threads: Annotated[int | None, typer.Option(min=1, help="Threads; else one for each core.")] = None,
    out: Annotated[
        Path | None, typer.Option(help="An empty folder for all samples; without it only the table is shown.")
    ] = None,
    root: options.Roots = None,
    trust_paths: options.TrustPaths = False,
    fix_inertia: options.FixInertia = False,
    as_json: options.AsJson = False,
) -> None:
    """Many runs at once with numbers varied: a sweep (--vary) or a Monte Carlo study (--draw).

    Each is the actual robot under control, as of `tmodes run`, compared with the run of the sheet as it stands: the
    distance of their tips. Everything is checked before anything runs. A run that cannot continue is named, and
    disturbs no other. The folder of --out holds states.npy, tips.npy, times.npy and batch.json;
    tmodes.simulation.batch.result.load_batch("FOLDER") reads them.

    Example, a gear whose stiffness is known to 20 %: tmodes batch filipovic2010
    --draw real.gear.stiffness=0.16:0.24 --runs 1000

    Example, payload and damping, 11 by 3 runs: tmodes batch filipovic2010 --vary payload.mass=0.4:0.6:11
    --vary gear.damping=0:4:3

    Example, noise on what the controller hears, 100 seeds: tmodes batch filipovic2010
    --set reference.noise.deviation=1e-4 --vary reference.noise.seed=0:99:100
    """
    values = _values(vary or [], draw or [], runs, seed)
    changes = options.integration_changes(
        method=integrator, relative_tolerance=rtol, absolute_tolerance=atol, duration=duration
    )
    sheet = options.chosen_sheet(
        robot, settings, roots=root, trust_paths=trust_paths, fix_inertia=fix_inertia, changes=changes
    )
    found, parted = _run(sheet, values, threads, out)
    _report(sheet.name, found, parted, as_json)
    if not found.finished.all():
        raise typer.Exit(130 if "interrupted" in found.status else 3)


def _values(vary: list[str], draw: list[str], runs: int, seed: int) -> dict[str, NDArray[Any]]:
    """Numbers of every lane, by path."""
    from tmodes.simulation.vary.study import drawn, grid

    if bool(vary) == bool(draw):
        hint = "write --vary payload.mass=0.4:0.6:11, or --draw payload.mass=0.4:0.6"
        raise InputError("--vary, --draw", "both" if vary else "neither", "one of them", hint)
    if draw:
        return drawn({path: (low, high) for path, low, high in _ranges("--draw", draw)}, runs, seed)
    ranges = {path: (low, high, _count(path, count)) for path, low, high, count in _ranges("--vary", vary)}
    lanes = prod(count for _, _, count in ranges.values())
    if lanes > MOST_LANES:
        raise InputError("--vary", f"{lanes} combinations", f"at most {MOST_LANES}", "take fewer numbers of each path")
    return grid(ranges)


def _ranges(option: str, texts: list[str]) -> list[tuple[Any, ...]]:
    """Path and numbers of each text; a path that stands twice would hide its first range."""
    ranges = [_range(option, text) for text in texts]
    paths = [path for path, *_ in ranges]
    if twice := [path for path in paths if paths.count(path) > 1]:
        raise InputError(option, f"{twice[0]} twice", "given once for each path", "give one range for it")
    return ranges


def _range(option: str, text: str) -> tuple[Any, ...]:
    """Path and numbers of ``PATH=LOW:HIGH`` or ``PATH=LOW:HIGH:COUNT``."""
    path, _, numbers = text.partition("=")
    expected = "PATH=LOW:HIGH" + (":COUNT" if option == "--vary" else "")
    try:
        values = [float(word) for word in numbers.split(":")]
    except ValueError:
        values = []
    if len(values) != expected.count(":") + 1 or not all(map(isfinite, values)):
        example = "payload.mass=0.4:0.6" + (":5" if option == "--vary" else "")
        raise InputError(option, ascii(text)[:80], expected, f"write numbers in SI units, as in {example}")
    return path.strip(), *values


def _count(path: str, count: float) -> int:
    if count < 1 or not count.is_integer():
        raise InputError(
            f"--vary {path}", f"{count:g} numbers", "a whole COUNT of at least 1", "write how many numbers to take"
        )
    return int(count)


def _run(sheet: Any, values: dict[str, Any], threads: int | None, out: Path | None) -> tuple[BatchRun, Spread]:
    """The batch and its spread; without a folder no samples are kept."""
    from tmodes.simulation.vary.simulate import prepared, run_prepared
    from tmodes.simulation.vary.study import Spread, spread

    with working() as tell:
        lanes = prepared(sheet, values, out=out, keep=out is not None, progress=tell)
        own = run_prepared(prepared(sheet, None), tips=True, threads=1, progress=tell)
        if "interrupted" in own.status:
            raise KeyboardInterrupt
        figures = None if out else lambda part: vars(spread(part, own))
        found = run_prepared(lanes, tips=True, threads=threads, figures=figures, progress=tell)
    return found, spread(found, own) if out else Spread(**found.figures)


def _report(name: str, found: BatchRun, parted: Spread, as_json: bool) -> None:
    info = parted.info(found)
    if as_json:
        print_json(info | {"each": _each(found, parted)})
    else:
        _print(name, found, info)
    lost = [lane for lane, status in enumerate(found.status) if status != "finished"]
    for lane in lost[:MOST_REPORTED]:
        values = ", ".join(f"{path} = {values[lane]:.6g}" for path, values in found.values.items())
        notice(f"case {lane} ({values}) {found.status[lane]}: {found.message[lane]}")
    if len(lost) > MOST_REPORTED:
        notice(f"and {len(lost) - MOST_REPORTED} more cases that did not finish")


def _each(found: BatchRun, parted: Spread) -> list[dict[str, Any]]:
    """Every lane: its numbers, how it ended, and how far its tip parted."""
    pairs = zip(parted.largest.tolist(), parted.at_end.tolist(), strict=True)
    return [
        {
            "values": {path: float(values[lane]) for path, values in found.values.items()},
            "status": found.status[lane],
            "message": found.message[lane],
            "tip_difference_m": largest if isfinite(largest) else None,
            "tip_difference_at_end_m": at_end if isfinite(at_end) else None,
        }
        for lane, (largest, at_end) in enumerate(pairs)
    ]


def _print(name: str, found: BatchRun, info: dict[str, Any]) -> None:
    title = f"{name}: {info['finished']} of {info['lanes']} runs finished"
    labels = {"tip_difference_m": "largest tip difference [mm]", "tip_difference_at_end_m": "at the end [mm]"}
    rows = [
        [label, *(f"{info[key][part] * 1e3:.4g}" if info[key] else "-" for part in ("min", "median", "max"))]
        for key, label in labels.items()
    ]
    print_table(title, ["from the sheet's own run", "least", "median", "largest"], rows)
    if worst := info["worst"]:
        values = ", ".join(f"{path} = {value:.6g}" for path, value in worst["values"].items())
        print(f"Largest tip difference: {worst['tip_difference_m'] * 1e3:.4g} mm, in case {worst['lane']}: {values}.")
    if found.folder:
        print(f"All samples are in {found.folder}.")
