"""Many runs of one robot with some of its numbers varied: what ``tmodes batch`` computes and prints."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from math import isfinite, prod
from typing import TYPE_CHECKING, Any

from tmodes.errors import InputError
from tmodes.interface.integration import integration_changes
from tmodes.io.arguments import checked_arguments, numbers_of
from tmodes.io.printed import CommandResult, Table

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray
    from xarray import Dataset

    from tmodes.sheet import Robot
    from tmodes.study.rows import Rows

__all__ = ["BatchResult", "batch"]

MOST_CASES = 1_000_000
MOST_REPORTED = 5
"""Cases that did not finish, reported one by one."""

Ranges = Mapping[str, Any] | Sequence[str]
"""Ranges by path, or texts ``PATH=LOW:HIGH``."""


@checked_arguments
def batch(
    robot: Robot,
    *,
    vary: Ranges = (),
    draw: Ranges = (),
    runs: int = 100,
    seed: int = 0,
    integrator: str | None = None,
    rtol: float | None = None,
    atol: float | None = None,
    duration: float | None = None,
    threads: int | None = None,
    out: str | os.PathLike[str] | None = None,
    progress: Callable[[str, float], None] = lambda stage, share: None,
) -> BatchResult:
    """Many runs with numbers varied: a sweep (``vary``) or a Monte Carlo study (``draw``), one of the two.

    ``vary``: by path ``(low, high, count)`` or an array of all numbers; of several paths all combinations, the last
    one fastest. ``draw``: by path ``(low, high)``, uniform, ``runs`` of them, the same for the same ``seed``.
    ``integrator``, ``rtol``, ``atol``, ``duration`` [s]: as of a run. ``threads``: None for one on each core. ``out``:
    an empty folder for all samples. Each is the actual robot under control, compared with the run of the sheet as it
    stands: the distance of their tips [m].

    Raises :class:`tmodes.errors.InputError` or :class:`tmodes.errors.InputErrors` for wrong ranges, unknown paths and
    numbers that the sheet refuses, before anything runs.

    >>> robot = tmodes.load("spong1987")
    >>> robot.batch(vary={"gear.stiffness": (80, 120, 3)}, duration=0.1).data.sizes["case"]
    3
    """
    if bool(vary) == bool(draw):
        hint = "write --vary payload.mass=0.4:0.6:11, or --draw payload.mass=0.4:0.6"
        raise InputError("--vary, --draw", "both" if vary else "neither", "one of them", hint)
    from tmodes.study.ranges import computed, drawn_study, grid_study, sampled

    drawn, spread = _drawn(draw), _spread(vary)
    changes = integration_changes(
        method=integrator, relative_tolerance=rtol, absolute_tolerance=atol, duration=duration
    )
    sheet = robot.with_(changes) if changes else robot
    asked = drawn_study(sheet, drawn, runs, seed) if drawn else grid_study(sheet, spread)
    rows = sampled(asked, out, threads, progress) if out else computed(asked, threads, progress)
    paths = {name: one.path or name for name, one in asked.sheet.parameters.items()}
    return BatchResult(
        sheet.name, rows, paths, asked.parameter_units, asked.cases, None if out is None else os.fspath(out)
    )


@dataclass(frozen=True, eq=False, repr=False)
class BatchResult(CommandResult):
    """Cases of a robot: ``rows`` has their numbers and how each ended; ``paths`` and ``units``: of each parameter."""

    name: str
    rows: Rows = field(repr=False)
    paths: Mapping[str, str]
    units: Mapping[str, str]
    cases: int
    out: str | None = None

    @property
    def finished(self) -> int:
        """How many runs reached their end."""
        return int(self.rows.good.sum())

    @property
    def complete(self) -> bool:
        """Whether all did."""
        return self.finished == self.cases

    def info(self) -> dict[str, Any]:
        """Plain data, as ``tmodes batch --json`` prints it."""
        return self._spread() | {"each": [_case(self.rows, self.paths, k) for k in range(len(self.rows))]}

    def _spread(self) -> dict[str, Any]:
        return _info(self.rows, self.paths, self.cases)

    @property
    def data(self) -> Dataset:
        """Along ``case``: the varied numbers by path, ``tip_difference_m``, ``tip_difference_at_end_m``, ``status``."""
        from xarray import Dataset

        rows = self.rows
        series: dict[str, Any] = {self.paths[name]: ("case", values) for name, values in rows.parameters.items()}
        series |= {name: ("case", values, {"units": rows.units[name]}) for name, values in rows.quantities.items()}
        return Dataset(series | {"status": ("case", list(rows.status))}, {"case": rows.case})

    def plot(self, ax: Any = None) -> list[Any]:
        """The largest distance of the tip from that of the sheet's own run, over the first number that is varied."""
        from tmodes.plot.commands import points
        from tmodes.study.ranges import LARGEST

        (name, across), *_ = self.rows.parameters.items()
        shown = {"": (across, self.rows.quantities[LARGEST] * 1e3)}
        path, unit = self.paths[name], self.units[name]
        label = path if unit == "-" else f"{path} [{unit}]"
        return points(shown, label, "largest tip difference [mm]", title=self.name, ax=ax)

    @property
    def notices(self) -> list[str]:
        """The first cases that did not finish, and why."""
        rows, lost = self.rows, [k for k, good in enumerate(self.rows.good.tolist()) if not good]
        found = [f"case {k} ({_words(_values(rows, self.paths, k))}) {rows.status[k]}: {rows.reason[k]}"
                 for k in lost[:MOST_REPORTED]]  # fmt: skip
        more = len(lost) - MOST_REPORTED
        return [*found, f"and {more} more cases that did not finish"] if more > 0 else found

    def tables(self) -> Iterator[str | Table]:
        """Least, median and largest distance, and the case with the largest one."""
        info = self._spread()
        labels = {"tip_difference_m": "largest tip difference [mm]", "tip_difference_at_end_m": "at the end [mm]"}
        rows = [
            [label, *(f"{info[key][part] * 1e3:.4g}" if info[key] else "-" for part in ("min", "median", "max"))]
            for key, label in labels.items()
        ]
        title = f"{self.name}: {info['finished']} of {info['lanes']} runs finished"
        yield Table(title, ["from the sheet's own run", "least", "median", "largest"], rows)
        if worst := info["worst"]:
            distance = f"{worst['tip_difference_m'] * 1e3:.4g} mm"
            yield f"Largest tip difference: {distance}, in case {worst['lane']}: {_words(worst['values'])}."
        if self.out:
            yield f"All samples are in {self.out}."


def _drawn(given: Ranges) -> dict[str, tuple[float, float]]:
    """Least and largest number of each path."""
    for path, low, high in (ranges := _ranges("--draw", given)):
        if low >= high:
            hint = "swap the two" if low > high else f"write --set {path}={low:g} for the same number in all"
            raise InputError(f"--draw {path}", f"{low:g}:{high:g}", "LOW:HIGH, the lower number first", hint)
    return {path: (low, high) for path, low, high in ranges}


def _spread(given: Ranges) -> dict[str, NDArray[np.float64]]:
    """Evenly spaced numbers of each path."""
    import numpy as np

    arrays = {
        path: numbers_of(values, f"--vary {path}", ((None,),), "its numbers") for path, values in _arrays(given).items()
    }
    for path, numbers in arrays.items():
        if not len(numbers):
            raise InputError(f"--vary {path}", "no numbers", "at least one number", "give (low, high, count)")
    ranges = {path: (low, high, _count(path, count)) for path, low, high, count in _ranges("--vary", given)}
    cases = prod([*(count for _, _, count in ranges.values()), *map(len, arrays.values())])
    if cases > MOST_CASES:
        raise InputError("--vary", f"{cases} combinations", f"at most {MOST_CASES}", "take fewer numbers of each path")
    return arrays | {path: np.linspace(low, high, count) for path, (low, high, count) in ranges.items()}


def _arrays(given: Ranges) -> dict[str, Any]:
    """Numbers that are all given, by path: arrays, and lists that are no range."""
    return (
        {path: ends for path, ends in given.items() if not isinstance(ends, tuple)}
        if isinstance(given, Mapping)
        else {}
    )


def _ranges(option: str, given: Ranges) -> list[tuple[Any, ...]]:
    """Path and numbers of each range; a path that stands twice would hide its first range."""
    if isinstance(given, Mapping):
        return [_numbers(option, f"{path}={ends}", path, ends) for path, ends in given.items()
                if isinstance(ends, tuple)]  # fmt: skip
    ranges = [_range(option, text) for text in given]
    paths = [path for path, *_ in ranges]
    if twice := [path for path in paths if paths.count(path) > 1]:
        raise InputError(option, f"{twice[0]} twice", "given once for each path", "give one range for it")
    return ranges


def _range(option: str, text: str) -> tuple[Any, ...]:
    """Path and numbers of ``PATH=LOW:HIGH`` or ``PATH=LOW:HIGH:COUNT``."""
    path, _, numbers = text.partition("=")
    return _numbers(option, text, path.strip(), numbers.split(":"))


def _numbers(option: str, text: str, path: str, words: Sequence[Any]) -> tuple[Any, ...]:
    expected = "PATH=LOW:HIGH" + (":COUNT" if option == "--vary" else "")
    try:
        values = [float(word) for word in words]
    except (TypeError, ValueError):
        values = []
    if len(values) != expected.count(":") + 1 or not all(map(isfinite, values)):
        example = "payload.mass=0.4:0.6" + (":5" if option == "--vary" else "")
        raise InputError(option, ascii(text)[:80], expected, f"write numbers in SI units, as in {example}")
    return path, *values


def _count(path: str, count: float) -> int:
    if count < 1 or not count.is_integer():
        raise InputError(
            f"--vary {path}", f"{count:g} numbers", "a whole COUNT of at least 1", "write how many numbers to take"
        )
    return int(count)


def _values(rows: Rows, paths: Mapping[str, str], k: int) -> dict[str, float]:
    return {paths[name]: float(values[k]) for name, values in rows.parameters.items()}


def _words(values: dict[str, float]) -> str:
    return ", ".join(f"{path} = {value:.6g}" for path, value in values.items())


def _case(rows: Rows, paths: Mapping[str, str], k: int) -> dict[str, Any]:
    """A case: its numbers, how it ended, and how far its tip was from that of the sheet's own run."""
    numbers = {name: float(values[k]) for name, values in rows.quantities.items()}
    return {
        "values": _values(rows, paths, k),
        "status": rows.status[k],
        "message": rows.reason[k],
        **{name: number if isfinite(number) else None for name, number in numbers.items()},
    }


def _info(rows: Rows, paths: Mapping[str, str], cases: int) -> dict[str, Any]:
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
