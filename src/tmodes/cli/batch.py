"""``tmodes batch``: the short form of a study, many runs of one robot with some of its numbers varied."""

from __future__ import annotations

from math import isfinite, prod
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from tmodes.cli import options
from tmodes.cli.terminal import notice, print_json, print_table, working
from tmodes.errors import InputError

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from tmodes.sheet import Robot
    from tmodes.study.rows import Rows
    from tmodes.study.study import Study

__all__ = ["batch"]

MOST_CASES = 1_000_000
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
    runs: Annotated[int, typer.Option(min=1, max=MOST_CASES, help="How many runs --draw makes.")] = 100,
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

    The short form of `tmodes study`, which has other plans, distributions and quantities, and keeps what it has done.
    Each run is the actual robot under control, as of `tmodes run`, compared with the run of the sheet as it stands: the
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
    if bool(vary) == bool(draw):
        hint = "write --vary payload.mass=0.4:0.6:11, or --draw payload.mass=0.4:0.6"
        raise InputError("--vary, --draw", "both" if vary else "neither", "one of them", hint)
    changes = options.integration_changes(
        method=integrator, relative_tolerance=rtol, absolute_tolerance=atol, duration=duration
    )
    from tmodes.study.ranges import computed, sampled

    drawn, spread = _drawn(draw or []), _spread(vary or [])
    sheet = options.chosen_sheet(
        robot, settings, roots=root, trust_paths=trust_paths, fix_inertia=fix_inertia, changes=changes
    )
    with working() as tell:
        asked = _asked(sheet, drawn, spread, runs, seed)
        rows = sampled(asked, out, threads, tell) if out else computed(asked, threads, tell)
    _report(sheet.name, asked, rows, out, as_json)
    if not rows.good.all() or len(rows) < asked.cases:
        raise typer.Exit(130 if "interrupted" in rows.status else 3)


def _asked(sheet: Robot, drawn: dict[str, Any], spread: dict[str, Any], runs: int, seed: int) -> Study:
    from tmodes.study.ranges import drawn_study, grid_study

    return drawn_study(sheet, drawn, runs, seed) if drawn else grid_study(sheet, spread)


def _drawn(texts: list[str]) -> dict[str, tuple[float, float]]:
    """Least and largest number of each path."""
    for path, low, high in (ranges := _ranges("--draw", texts)):
        if low >= high:
            hint = "swap the two" if low > high else f"write --set {path}={low:g} for the same number in all"
            raise InputError(f"--draw {path}", f"{low:g}:{high:g}", "LOW:HIGH, the lower number first", hint)
    return {path: (low, high) for path, low, high in ranges}


def _spread(texts: list[str]) -> dict[str, NDArray[np.float64]]:
    """Evenly spaced numbers of each path."""
    import numpy as np

    ranges = {path: (low, high, _count(path, count)) for path, low, high, count in _ranges("--vary", texts)}
    cases = prod(count for _, _, count in ranges.values())
    if cases > MOST_CASES:
        raise InputError("--vary", f"{cases} combinations", f"at most {MOST_CASES}", "take fewer numbers of each path")
    return {path: np.linspace(low, high, count) for path, (low, high, count) in ranges.items()}


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


def _report(name: str, study: Study, rows: Rows, out: Path | None, as_json: bool) -> None:
    paths = {name: one.path or name for name, one in study.sheet.parameters.items()}
    info = _info(rows, paths, study.cases)
    if as_json:
        print_json(info | {"each": [_case(rows, paths, k) for k in range(len(rows))]})
    else:
        _print(name, info, out)
    lost = [k for k, good in enumerate(rows.good.tolist()) if not good]
    for k in lost[:MOST_REPORTED]:
        notice(f"case {k} ({_words(_values(rows, paths, k))}) {rows.status[k]}: {rows.reason[k]}")
    if len(lost) > MOST_REPORTED:
        notice(f"and {len(lost) - MOST_REPORTED} more cases that did not finish")


def _values(rows: Rows, paths: dict[str, str], k: int) -> dict[str, float]:
    return {paths[name]: float(values[k]) for name, values in rows.parameters.items()}


def _words(values: dict[str, float]) -> str:
    return ", ".join(f"{path} = {value:.6g}" for path, value in values.items())


def _case(rows: Rows, paths: dict[str, str], k: int) -> dict[str, Any]:
    """A case: its numbers, how it ended, and how far its tip was from that of the sheet's own run."""
    numbers = {name: float(values[k]) for name, values in rows.quantities.items()}
    return {
        "values": _values(rows, paths, k),
        "status": rows.status[k],
        "message": rows.reason[k],
        **{name: number if isfinite(number) else None for name, number in numbers.items()},
    }


def _info(rows: Rows, paths: dict[str, str], cases: int) -> dict[str, Any]:
    """Least, median and largest of both distances, and the case with the largest; None for nothing."""
    import numpy as np

    from tmodes.study.ranges import LARGEST

    largest = rows.quantities[LARGEST]
    worst = int(np.nanargmax(largest)) if np.isfinite(largest).any() else None
    return {
        "lanes": cases,
        "finished": int(rows.good.sum()),
        **{name: _least_median_most(values) for name, values in rows.quantities.items()},
        "worst": None if worst is None else {
            "lane": worst, LARGEST: float(largest[worst]), "values": _values(rows, paths, worst)
        },
    }  # fmt: skip


def _least_median_most(values: NDArray[np.float64]) -> dict[str, float] | None:
    import numpy as np

    known = values[np.isfinite(values)]
    if not len(known):
        return None
    return {"min": float(known.min()), "median": float(np.median(known)), "max": float(known.max())}


def _print(name: str, info: dict[str, Any], out: Path | None) -> None:
    title = f"{name}: {info['finished']} of {info['lanes']} runs finished"
    labels = {"tip_difference_m": "largest tip difference [mm]", "tip_difference_at_end_m": "at the end [mm]"}
    rows = [
        [label, *(f"{info[key][part] * 1e3:.4g}" if info[key] else "-" for part in ("min", "median", "max"))]
        for key, label in labels.items()
    ]
    print_table(title, ["from the sheet's own run", "least", "median", "largest"], rows)
    if worst := info["worst"]:
        distance = f"{worst['tip_difference_m'] * 1e3:.4g} mm"
        print(f"Largest tip difference: {distance}, in case {worst['lane']}: {_words(worst['values'])}.")
    if out:
        print(f"All samples are in {out}.")
