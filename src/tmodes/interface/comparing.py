"""A league of variants of one robot on one task: what ``tmodes compare`` computes and prints."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass, field
from math import inf, isfinite, nan
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tmodes.errors import SimulationError
from tmodes.interface.variants import (
    FINAL,
    LARGEST,
    differences,
    effort_limits,
    effort_quantities,
    read_task,
    uncertain_study,
    varied,
)  # fmt: skip
from tmodes.io.arguments import checked_arguments
from tmodes.io.files import FilePath
from tmodes.io.printed import CommandResult, Table, known_columns, written
from tmodes.io.words import count_of

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray
    from xarray import Dataset

    from tmodes import Robot as UsersRobot
    from tmodes.sheet import Robot
    from tmodes.study.rows import Rows
    from tmodes.study.statistics import Interval, Stack
    from tmodes.study.study import Study

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

PERCENT = 95.0


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
    task's. ``out``: a folder that keeps the cases and resumes; ``figure``: a file for the plot, which may ``overwrite``
    another; ``threads``: None for one on each core.

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
    robots = {name: varied(robot, name, one, task) for name, one in task.variants.items()}
    studies = {name: uncertain_study(one, task, runs or CASES, runs) for name, one in robots.items()}
    contenders = []
    for k, (name, one) in enumerate(robots.items()):

        def tell(stage: str, share: float, name: str = name) -> None:
            progress(f"{name}: {stage}", share)

        contenders.append(_contender(name, one, studies[name], threads, out, k, overwrite, tell))
    drawn = next(iter(studies.values()))
    certain = drawn is not None and drawn.sheet.plan.draws and not drawn.sheet.plan.repeats
    found = Comparison(
        robot.name, tuple(contenders), task.tolerance, tuple(task.uncertain), certain, tuple(differences(robots))
    )
    write_files(None, found, figure, overwrite=overwrite)
    return found


@dataclass(frozen=True)
class RunNumbers:
    """What is reported of one run, see ``UNITS``; None where it has no such number, and why it failed if it did."""

    largest_m: float | None = None
    final_m: float | None = None
    settling_s: float | None = None
    rest_s: float | None = None
    residual_m: float | None = None
    effort_share: float | None = None
    status: str = "failed"
    reason: str = ""

    @property
    def good(self) -> bool:
        """Whether it reached its end."""
        return self.status in ("finished", "stopped_by_condition")


def _run_numbers(robot: UsersRobot, progress: Progress) -> RunNumbers:
    """The numbers of a run of the robot, without the estimates of its errors."""
    try:
        result = robot.run(error_estimate=False, model_error=False, progress=progress)
    except SimulationError as error:
        return RunNumbers(reason=str(error))
    summary = result.summary()
    judged, after, ends = summary["verdict"], summary["settling"]["time_s"], result.move_end
    limits = effort_limits(robot)
    efforts = [abs(one["largest_effort"]) / limits[name] for name, one in summary["joints"].items() if name in limits]
    return RunNumbers(
        judged["largest_m"], judged["final_m"], after, None if after is None or ends is None else ends + after,
        (summary["vibration"].get("actual") or {}).get("amplitude_m"), max(efforts, default=None), result.status,
        "" if result.success else result.message,
    )  # fmt: skip


def _contender(
    name: str, robot: UsersRobot, study: Study | None, threads: int | None, out: FilePath | None, number: int,
    overwrite: bool, progress: Progress,
) -> Contender:  # fmt: skip
    import numpy as np

    from tmodes.study.plans.systematic import Tolerance
    from tmodes.study.statistics import tolerance_stack

    nominal = _run_numbers(robot.with_({"real": {}}), lambda stage, share: progress("nominal run", share))
    if study is None:
        actual = _run_numbers(robot, lambda stage, share: progress("actual robot", share)) if robot.real else None
        return Contender(name, robot, nominal, actual)
    design = study.design()
    if out is None:
        rows = study.evaluate(0, design.values, progress, threads=threads)
    else:
        from tmodes.study.runner import run_study

        folder = Path(out) / f"{number + 1}-{re.sub(r'[^A-Za-z0-9]+', '-', name).strip('-')}"
        rows = run_study(study, folder, threads=threads, overwrite=overwrite, progress=progress).rows
    stack = None
    if isinstance(study.sheet.plan, Tolerance):
        stack = tolerance_stack(np.where(rows.good, rows.quantities[LARGEST], np.nan), design.info)
    return Contender(name, robot, nominal, None, rows, stack)


@dataclass(frozen=True, eq=False)
class Contender:
    """One variant: its ``robot``, its ``nominal`` run, and its cases: those of ``rows``, else the ``actual`` robot."""

    name: str
    robot: UsersRobot = field(repr=False)
    nominal: RunNumbers
    actual: RunNumbers | None = None
    rows: Rows | None = field(default=None, repr=False)
    stack: Stack | None = field(default=None, repr=False)

    @property
    def attribution(self) -> dict[str, float]:
        """By uncertain parameter how much it alone adds to the largest error [m]; ``remainder``: only together.

        Of the plan ``tolerance``, at the worse end of each; with the error of the nominal case they add up to that of
        the worst corner. Empty for another plan.
        """
        if self.stack is None:
            return {}
        parts = {name: max(0.0, *ends) for name, ends in self.stack.parts.items()}
        whole = (self.stack.corners or self.stack.worst)[1] - self.stack.nominal
        return parts | {"remainder": whole - sum(parts.values())}

    @property
    def errors(self) -> NDArray[np.float64]:
        """Largest error of the tip in each case, (cases,) [m]; not-a-number where it failed."""
        return self._of_cases(LARGEST, self.actual and self.actual.largest_m)

    @property
    def finals(self) -> NDArray[np.float64]:
        """Error of the tip at the end of each case, (cases,) [m]; not-a-number where it failed."""
        return self._of_cases(FINAL, self.actual and self.actual.final_m)

    @property
    def efforts(self) -> NDArray[np.float64]:
        """Largest effort of a drive over its limit in each case, (cases,) [-]; not-a-number without a limit."""
        import numpy as np

        if self.rows is None:
            return self._of_cases("", self.actual and self.actual.effort_share)
        known = effort_quantities(self.robot).items()
        shares = [self.rows.quantities[name] / limit for name, (_, limit) in known]
        return np.max(shares, axis=0) if shares else np.full(len(self.rows), np.nan)

    def _of_cases(self, name: str, of_actual: float | None) -> NDArray[np.float64]:
        import numpy as np

        if self.rows is not None:
            return np.where(self.rows.good, self.rows.quantities[name], np.nan)
        known = self.actual is not None and self.actual.good and of_actual is not None
        return np.full(int(self.actual is not None), of_actual if known else np.nan, dtype=float)

    @property
    def reason(self) -> str:
        """Why the first run that failed did so; empty where none did."""
        runs = [one for one in (self.nominal, self.actual) if one and not one.good]
        said = [why or status for why, status, good in self._endings if not good]
        return next(iter([*(one.reason or one.status for one in runs), *said]), "")

    @property
    def _endings(self) -> Iterator[tuple[str, str, bool]]:
        if self.rows is not None:
            yield from zip(self.rows.reason, self.rows.status, self.rows.good.tolist(), strict=True)

    def failed(self, tolerance: float | None) -> int:
        """How many cases did not end, or exceed the tolerance [m]."""
        import numpy as np

        errors = self.errors
        return int((~np.isfinite(errors) | (errors > (inf if tolerance is None else tolerance))).sum())

    @property
    def seconds(self) -> float | None:
        """Processor time of one case [s], the mean of all; None where there are none."""
        return None if self.rows is None else float(self.rows.seconds.mean())

    def share(self, tolerance: float | None) -> Interval:
        """Share of the cases that did not end or exceed the tolerance [m], with its interval of 95 % confidence."""
        from tmodes.study.statistics import exact_share

        return exact_share(self.failed(tolerance), len(self.errors))

    @property
    def worst(self) -> float | None:
        """The largest error of all cases that ended [m]; None where there is none."""
        known = self.errors[~(self.errors != self.errors)]
        return float(known.max()) if len(known) else None

    def below(self, percent: float = PERCENT) -> Interval:
        """Error that so many of the cases that ended do not exceed [m], with its interval of 95 % confidence."""
        from tmodes.study.statistics import percentile

        return percentile(self.errors, percent)


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
        """The largest error of each variant [mm]: nominal, the worst case, and what 90 % of the cases lie between."""
        from tmodes.plot.commands import spans

        every = self.ranked
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
        said = f"largest error {_mm(best.nominal.largest_m)} nominal"
        if self.cases:
            where = f"in the worst of {self.cases} cases" if self.uncertain else "of the actual robot"
            said += f", {_mm(best.worst)} {where}"
        yield f"Best: {best.name}: {said}."
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
        said.append("at end, rings (amplitude after the move), at rest: of the nominal run; effort: the largest of all")
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
