"""One variant of a comparison: its nominal run, its uncertain cases, and what is reported of them."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from math import inf
from pathlib import Path
from typing import TYPE_CHECKING

from tmodes.errors import SimulationError
from tmodes.interface.variants import FINAL, LARGEST, effort_limits, effort_quantities
from tmodes.io.files import FilePath

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from tmodes import Result, Robot
    from tmodes.study.rows import Rows
    from tmodes.study.statistics import Interval, Stack
    from tmodes.study.study import Study

__all__ = ["PERCENT", "Contender", "RunNumbers", "contender"]

Progress = Callable[[str, float], None]

PERCENT = 95.0


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


def _run(robot: Robot, progress: Progress) -> tuple[RunNumbers, Result | None]:
    """A run of the robot, without the estimates of its errors, and its numbers."""
    try:
        result = robot.run(error_estimate=False, model_error=False, progress=progress)
    except SimulationError as error:
        return RunNumbers(reason=str(error)), None
    summary = result.summary()
    judged, after, ends = summary["verdict"], summary["settling"]["time_s"], result.move_end
    limits = effort_limits(robot)
    efforts = [abs(one["largest_effort"]) / limits[name] for name, one in summary["joints"].items() if name in limits]
    return RunNumbers(
        judged["largest_m"], judged["final_m"], after, None if after is None or ends is None else ends + after,
        (summary["vibration"].get("actual") or {}).get("amplitude_m"), max(efforts, default=None), result.status,
        "" if result.success else result.message,
    ), result  # fmt: skip


def contender(
    name: str, robot: Robot, study: Study | None, threads: int | None, out: FilePath | None, number: int,
    overwrite: bool, progress: Progress,
) -> Contender:  # fmt: skip
    """The variant with its runs; its cases are kept in its own folder of ``out``."""
    import numpy as np

    from tmodes.study.plans.systematic import Tolerance
    from tmodes.study.statistics import tolerance_stack

    folder = f"{number + 1}-{re.sub(r'[^A-Za-z0-9]+', '-', name).strip('-')}"
    nominal, result = _run(robot.with_({"real": {}}), lambda stage, share: progress("nominal run", share))
    if study is None:
        actual = _run(robot, lambda stage, share: progress("actual robot", share))[0] if robot.real else None
        return Contender(name, folder, robot, nominal, result, actual)
    design = study.design()
    if out is None:
        rows = study.evaluate(0, design.values, progress, threads=threads)
    else:
        from tmodes.study.runner import run_study

        rows = run_study(study, Path(out) / folder, threads=threads, overwrite=overwrite, progress=progress).rows
    stack = None
    if isinstance(study.sheet.plan, Tolerance):
        stack = tolerance_stack(np.where(rows.good, rows.quantities[LARGEST], np.nan), design.info)
    return Contender(name, folder, robot, nominal, result, None, rows, stack)


@dataclass(frozen=True, eq=False)
class Contender:
    """One variant: its ``robot``, its ``nominal`` run, and its cases: those of ``rows``, else the ``actual`` robot.

    ``folder``: in which its cases are, where they are kept; ``result``: of the nominal run, if it started.
    """

    name: str
    folder: str
    robot: Robot = field(repr=False)
    nominal: RunNumbers
    result: Result | None = field(default=None, repr=False)
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
