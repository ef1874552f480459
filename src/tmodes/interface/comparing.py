"""A league of variants of one robot on one task: what ``tmodes compare`` computes and prints."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass
from math import inf, isfinite, nan
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tmodes.interface.contenders import PERCENT, Contender, RunNumbers, contender
from tmodes.interface.variants import differences, read_task, uncertain_study, varied
from tmodes.io.arguments import checked_arguments
from tmodes.io.files import FilePath
from tmodes.io.printed import CommandResult, Table, known_columns, written
from tmodes.io.words import count_of

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray
    from xarray import Dataset

    from tmodes.sheet import Robot

__all__ = ["Comparison", "Contender", "RunNumbers", "compare"]

Progress = Callable[[str, float], None]

UNITS = {
    "largest_m": "m, largest error of the tip from its commanded path",
    "final_m": "m, the same at the end of the run",
    "settling_s": "s, after the move",
    "rest_s": "s, from the start of the run until it stays near its rest",
    "residual_m": "m, amplitude of the vibration after the move",
    "effort_share": "1, largest effort of a drive over its limit (of the joint, or of the drive's saturation)",
    "fails": "1, share of the cases that do not end, or exceed the tolerance, with the interval of Clopper and Pearson",
    "seconds": "s of processor time for one run",
}

CASES = 200
"""Uncertain runs of each variant where the file does not say how many."""


@checked_arguments
def compare(
    robot: Robot,
    variants: Mapping[str, Any] | FilePath,
    *,
    sheets: Mapping[str, Robot] | None = None,
    uncertain: Mapping[str, Any] | None = None,
    plan: Mapping[str, Any] | None = None,
    runs: int | None = None,
    tolerance: float | str | None = None,
    threads: int | None = None,
    out: FilePath | None = None,
    reports: bool = False,
    figure: FilePath | None = None,
    overwrite: bool = False,
    progress: Progress = lambda stage, share: None,
) -> Comparison:
    """Variants of one robot, such as its controllers, on the same task: nominal, and as far as it is not known.

    ``variants``: by name another robot, or values by path of this one (``{}``: as it is); a value may be a whole
    controller, signal or ``control`` section, ``shaper`` stands for :meth:`tmodes.Robot.shaper` with its arguments. Or
    a YAML file with ``variants`` and, as they are given here, ``uncertain``, ``plan`` and ``tolerance``. ``sheets``:
    further robots by name, variants before these. ``uncertain``: as ``parameters`` of a study; with ``relative: true``
    factors on numbers of the actual robot, which no controller knows. ``plan``: as of a study, 200 ``monte_carlo`` ones
    if left out; ``runs`` in place of its number. Every variant gets the same cases, with the same noise. Without
    ``uncertain`` the actual robot of the sheet is the only case. ``tolerance`` [m]: of the error of the tip, else the
    task's. ``out``: a folder for compare.html (:meth:`Comparison.page`, with ``reports``), compare.csv and compare.svg,
    which keeps the cases and resumes; ``figure``: a file for the plot, which may ``overwrite`` another; ``threads``:
    None for one on each core.

    Raises :class:`tmodes.errors.InputError` or :class:`tmodes.errors.InputErrors` for what is wrong with a variant or
    the study, before anything runs. A run that fails is one that fails, with its reason.

    >>> robot = tmodes.load("spong1987").with_({"integration.duration": 0.1})
    >>> between = {"type": "uniform", "low": 0.8, "high": 1}
    >>> soft = {"k": {"path": "gear.stiffness", "relative": True, "distribution": between}}
    >>> laws = {"as it is": {}, "stiff": {"drives.0.controller.position_gain": 160.0}}
    >>> found = robot.compare(laws, uncertain=soft, runs=4)
    >>> [one.name for one in found.ranked], found.data.sizes["case"]
    (['stiff', 'as it is'], 4)
    """
    from tmodes.interface.files import write_files

    task = read_task(variants, uncertain, plan, tolerance, robot, sheets or {})
    robots = {name: varied(robot, name, one, task, progress) for name, one in task.variants.items()}
    studies = {name: uncertain_study(one, task, runs or CASES, runs) for name, one in robots.items()}
    contenders = []
    for k, (name, one) in enumerate(robots.items()):

        def tell(stage: str, share: float, name: str = name) -> None:
            progress(f"{name}: {stage}", share)

        contenders.append(contender(name, one, studies[name], threads, out, k, overwrite, tell))
    drawn = next(iter(studies.values()))
    certain = drawn is not None and drawn.sheet.plan.draws and not drawn.sheet.plan.repeats
    found = Comparison(
        robot.name, tuple(contenders), task.tolerance, tuple(task.uncertain), certain, tuple(differences(robots))
    )
    write_files(None, found, figure, overwrite=overwrite)
    if out is not None:
        from tmodes.interface.league import write_league

        write_league(found, Path(out), reports=reports, progress=progress)
    return found


@dataclass(frozen=True, eq=False, repr=False)
class Comparison(CommandResult):
    """Variants of one robot on one task. ``tolerance`` [m]: None where the errors are not judged.

    ``contenders``: in the order in which they were given, each with its runs; ``certain``: the cases are independent
    draws, so that intervals hold.
    """

    name: str
    contenders: tuple[Contender, ...]
    tolerance: float | None
    uncertain: tuple[str, ...]
    certain: bool
    warned: tuple[str, ...] = ()

    @property
    def ranked(self) -> tuple[Contender, ...]:
        """The best one first: by the share of its cases that fails, then the largest error in the worst case."""

        def key(one: Contender) -> tuple[float, float, float]:
            nominal = one.nominal.largest_m if one.nominal.good and one.nominal.largest_m is not None else inf
            worst = nominal if one.worst is None else one.worst
            share = one.failed(self.tolerance) / len(one.errors) if len(one.errors) else float(not one.nominal.good)
            return share, worst, nominal

        return tuple(sorted(self.contenders, key=key))

    @property
    def sentence(self) -> str:
        """Which is best, and which fail how often, with the bounds of their shares."""
        best = self.ranked[0]
        said = f"Best: {best.name}: largest error {_mm(best.nominal.largest_m)} nominal"
        if self.cases:
            where = f"in the worst of {self.cases} cases" if self.uncertain else "of the actual robot"
            said += f", {_mm(best.worst)} {where}"
        lost = [one for one in self.ranked if one.failed(self.tolerance)] if self.uncertain else []
        fails = ", ".join(f"{one.name} in {self._share(one)}" for one in lost)
        return f"{said}. Fails: {fails}." if fails else f"{said}."

    def _share(self, one: Contender) -> str:
        share, said = one.share(self.tolerance), f"{one.failed(self.tolerance)} of {self.cases}"
        return f"{said} ({100 * share.low:.1f} to {100 * share.high:.1f} %)" if self.certain else said

    def page(self, path: FilePath, *, reports: bool = False) -> Path:
        """Write it as one self-contained HTML file: the answer in a sentence, charts, and the table.

        ``reports``: next to it one of each nominal run, linked. Raises :class:`tmodes.errors.ResultFileError` where
        files cannot be written.

        >>> robot = tmodes.load("spong1987").with_({"integration.duration": 0.1})
        >>> robot.compare({"as it is": {}}).page("compare.html").name
        'compare.html'
        """
        from tmodes.interface.league import write_page

        return write_page(self, Path(path), reports=reports)

    @property
    def cases(self) -> int:
        """How many cases each variant had."""
        return len(self.contenders[0].errors)

    @property
    def warnings(self) -> list[str]:
        """In what variants differ that a fair comparison has alike."""
        return list(self.warned)

    def info(self) -> dict[str, Any]:
        """Plain data, as ``tmodes compare --json`` prints it: the variants by rank."""
        return {
            "robot": self.name, "units": UNITS, "tolerance_m": self.tolerance, "cases": self.cases,
            "uncertain": list(self.uncertain), "variants": [self._info(one) for one in self.ranked],
            "warnings": self.warnings,
        }  # fmt: skip

    def _info(self, one: Contender) -> dict[str, Any]:
        found = {"name": one.name, "nominal": asdict(one.nominal), "actual": one.actual and asdict(one.actual)}
        share, below = one.share(self.tolerance), one.below()
        cases = {
            "worst_m": one.worst, "percentile_95_m": _known(below.value), "worst_final_m": _largest(one.finals),
            "worst_effort_share": _largest(one.efforts),
            "fails": {"count": one.failed(self.tolerance), "share": share.value, "interval": [share.low, share.high]},
        }  # fmt: skip
        if self.certain:
            cases["percentile_95_interval_m"] = [_known(below.low), _known(below.high)]
        else:
            del cases["fails"]["interval"]
        more = {"seconds": one.seconds, "reason": one.reason, "attribution_m": one.attribution or None}
        return found | {"cases": cases if len(one.errors) else None} | more

    @property
    def data(self) -> Dataset:
        """``error``, ``final_error`` [m], ``effort`` [-] (variant, case); of nominal runs ``nominal_...`` (variant)."""
        import numpy as np
        from xarray import Dataset

        every = self.contenders
        series: dict[str, Any] = {
            name: (("variant", "case"), np.stack([getattr(one, own) for one in every]), {"units": unit})
            for name, own, unit in (
                ("error", "errors", "m"),
                ("final_error", "finals", "m"),
                ("effort", "efforts", "1"),
            )
        }
        numbers = {"largest_m": "m", "final_m": "m", "rest_s": "s", "residual_m": "m", "effort_share": "1"}
        for name, unit in numbers.items():
            values = [nan if (own := getattr(one.nominal, name)) is None else own for one in every]
            series[f"nominal_{name}"] = ("variant", values, {"units": unit})
        return Dataset(series, {"variant": [one.name for one in every], "case": np.arange(self.cases)})

    def plot(self, ax: Any = None) -> list[Any]:
        """The largest error of each variant [mm]: nominal, the worst case, and what 90 % of the cases lie between.

        Of the plan ``tolerance`` what each uncertain parameter adds to it at its worse end, and what only all together
        do (:attr:`Contender.attribution`), up to the worst corner; next to each other where a part is negative.
        """
        from tmodes.plot.commands import bars, spans

        every = self.ranked
        if split := [(one.name, one.stack.nominal, one.attribution) for one in every if one.stack]:
            parts = {"as known": _scaled([known for _, known, _ in split])}
            parts |= {name: _scaled([own[name] for *_, own in split]) for name in split[0][2]}
            stacked = all(length >= 0 for lengths in parts.values() for length in lengths)
            names = [name for name, *_ in split]
            what = "largest error of the tip [mm], by what is uncertain"
            return bars(parts, names, what, title=self.name, ax=ax, stacked=stacked)
        marks = {"nominal": [one.nominal.largest_m for one in every]}
        if self.cases > 1:
            marks[f"worst of {self.cases}"] = [one.worst for one in every]
        elif self.cases:
            marks["actual robot"] = [one.worst for one in every]
        low, high = (_scaled([one.below(share).value for one in every]) for share in (5.0, PERCENT))
        title = f"{self.name}: {', '.join(self.uncertain)} uncertain" if self.uncertain else self.name
        return spans(
            [one.name for one in every], {key: _scaled(ones) for key, ones in marks.items()},
            "largest error of the tip [mm]",
            between=("5 to 95 % of the cases", low, high) if self.cases > 1 else None,
            limit=None if self.tolerance is None else ("tolerance", 1e3 * self.tolerance), title=title, ax=ax,
        )  # fmt: skip

    def tables(self) -> Iterator[str | Table]:
        """Which is best, and a row for each variant, the best one first."""
        best = self.ranked[0]
        yield self.sentence
        cases = [f"worst of {self.cases}", f"{PERCENT:.0f} % below"] if self.uncertain else ["actual", "-"]
        columns = ["variant", "fails", *cases, "nominal", "at end", "rings", "at rest [s]", "effort", "run [ms]"]
        judged = "" if self.tolerance is None else f", tolerance {_mm(self.tolerance)}"
        title = f"{self.name}: {count_of(len(self.contenders), 'variant')}{judged}; errors of the tip [mm]"
        yield known_columns(title, columns, [self._row(one) for one in self.ranked])
        if best.stack:
            title = "Largest error by what is uncertain, each alone at its worse end [mm]"
            shown = [(one, one.stack.nominal) for one in self.ranked if one.stack]
            rows = [[one.name, *map(_number, (own, *one.attribution.values(), one.worst))] for one, own in shown]
            yield Table(title, ["variant", "all as known", *best.attribution, "worst corner"], rows)

    def _row(self, one: Contender) -> list[str]:
        own, share = one.nominal, one.share(self.tolerance)
        fails = f"{one.failed(self.tolerance)} of {self.cases}" if self.cases else "-"
        if self.certain:
            fails = f"{100 * share.value:.3g} % ({100 * share.low:.1f} to {100 * share.high:.1f})"
        below = _known(one.below().value) if self.uncertain else None
        effort = max((size for size in (own.effort_share, _largest(one.efforts)) if size is not None), default=None)
        lengths = (one.worst, below, own.largest_m, own.final_m, own.residual_m)
        return [
            one.name, fails, *map(_number, lengths),
            "-" if own.rest_s is None else f"{own.rest_s:.3f}", "-" if effort is None else f"{100 * effort:.3g} %",
            "-" if one.seconds is None else f"{1e3 * one.seconds:.3g}",
        ]  # fmt: skip

    @property
    def notices(self) -> list[str]:
        """Why runs failed, and what the numbers are."""
        said = [f"{one.name}: {one.reason}" for one in self.ranked if one.reason]
        said.append(
            "at end, rings (amplitude after the move), at rest: of the nominal run; effort: the largest of all, as a "
            "share of the effort limit of its joint or drive"
        )
        if self.uncertain and self.certain:
            said.append(
                "fails: did not end, or beyond the tolerance; in brackets where its share is, with 95 % confidence"
            )
        return said


def _known(value: float) -> float | None:
    return value if isfinite(value) else None


def _largest(values: NDArray[np.float64]) -> float | None:
    import numpy as np

    return float(np.nanmax(values)) if np.isfinite(values).any() else None


def _scaled(values: Sequence[float | None]) -> list[float]:
    """Lengths [mm], not-a-number where there is none."""
    return [nan if one is None else 1e3 * one for one in values]


def _number(length: float | None) -> str:
    return "-" if length is None or not isfinite(length) else f"{1e3 * length:.3g}"


def _mm(length: float | None) -> str:
    return "unknown" if length is None else written(length, "m", 3)
