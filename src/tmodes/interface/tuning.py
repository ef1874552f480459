"""Gains of a robot's laws, tuned for the nominal plant or for the worst of an uncertain family."""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tmodes.errors import InputError, InputErrors
from tmodes.interface.tradeoff import Against, curve_table, effects_of, in_all_cases, plot_curve, said, weighed
from tmodes.interface.variants import effort_quantities, uncertain_of, uncertain_parameters
from tmodes.io.arguments import checked_arguments, numbers_of
from tmodes.io.files import FilePath
from tmodes.io.printed import CommandResult, Table, changed_by, known_columns
from tmodes.io.sheet_check import sheet_data
from tmodes.io.words import count_of

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray
    from xarray import Dataset

    from tmodes import Robot as UsersRobot
    from tmodes.sheet import Robot
    from tmodes.study.optimize import Optimum
    from tmodes.study.optimize.result import Candidate
    from tmodes.study.study import Study

__all__ = ["Gain", "Tuning", "tune"]

Gains = Sequence[str] | Mapping[str, Sequence[float]]
Progress = Callable[[str, float], None]

_AT_END, _AT_LIMIT, _LIMIT_PASSED = 1e-3, 0.99, 1 + 1e-6

_IDLE = 1e-4
"""Effect of a gain below which it is said to have none."""


@checked_arguments
def tune(
    robot: Robot,
    gains: Gains = (),
    *,
    minimize: str = "tip_error",
    reduce: str = "rms",
    against: str | None = None,
    against_reduce: str = "rms",
    uncertain: Mapping[str, Any] | FilePath | None = None,
    worst_case: int = 16,
    within: float = 10.0,
    method: str = "auto",
    trials: int | None = None,
    seed: int = 0,
    out: FilePath | None = None,
    figure: FilePath | None = None,
    overwrite: bool = False,
    progress: Progress = lambda stage, share: None,
) -> Tuning:
    """Gains of any law such that an output of the run becomes small, on the robot as known or in the worst case.

    ``gains``: their paths, or ranges (low, high) by path; all that the laws of the robot name as ``tuned`` if left out,
    from a ``within``-th of what they are to ``within`` times it. ``minimize``: an output of ``robot.outputs``,
    ``reduce`` d to one number. ``against``: another output, with its ``against_reduce``, that is to be small, too: then
    ``curve`` has the designs of which none is better in both, along gradients to ``trials`` compromises (else 8) or,
    where there are none, by ``nsga2`` (1000 designs, extra ``study``), and the gains are those of the least error that
    do not make it larger than it is. ``uncertain``: as of :func:`tmodes.compare`, or its file:
    then for the worst of ``worst_case`` robots. ``method``, ``trials``, ``seed``: of :func:`tmodes.optimize`, which
    does it; ``auto`` goes along gradients (the adjoint of the run; ``reduce`` one of ``rms``, ``mean``, ``end``), and
    where there are none, or the drives would pass their limits, by ``cobyqa``, which keeps them. ``out``: a file for
    the sheet with the gains, ``figure`` for the plot, which may ``overwrite`` others.

    Raises :class:`tmodes.errors.InputError` or :class:`tmodes.errors.InputErrors` for what is wrong in the arguments,
    and :class:`tmodes.errors.SimulationError` where no design could be computed.

    >>> robot = tmodes.load("spong1987").with_({"integration.duration": 1.0})
    >>> found = robot.tune()
    >>> f"{1e3 * found.before.max():.0f} mm, {1e3 * found.after.max():.0f} mm"
    '104 mm, 61 mm'
    >>> [(one.path, one.end) for one in found.gains][0]
    ('drives.0.controller.position_gain', 'upper')
    """
    from tmodes import Robot as Whole
    from tmodes.interface.files import write_files

    whole = Whole.of(robot)
    plant = Whole.of(whole.commanded(progress)).with_({"real": {}})
    if not (within > 1.0):
        raise InputError("within", f"{within:g}", "a number > 1", "write 10: from a tenth to ten times the gain")
    ranges = _ranges(plant, gains, within)
    family = uncertain_parameters(uncertain_of(uncertain), sheet_data(plant))

    aims = {_named(reduce, minimize): (minimize, reduce)}
    if against is not None:
        aims[_named(against_reduce, against)] = against, against_reduce
        if len(aims) == 1:
            raise InputError(
                "against", against, "another output, or another number of it", "write against='power.motor'"
            )

    def study(limits: Sequence[str]) -> Study:
        return _study(plant, ranges, family, aims, worst_case, limits)

    optimum = _searched(plant, study, method, trials, seed, progress)
    words = {name: f"{how} of {what}" for name, (what, how) in aims.items()}
    found = _tuning(whole, plant, ranges, words, optimum, tuple(family))
    write_files(out, found, figure, overwrite=overwrite)
    return found


def _named(how: str, what: str) -> str:
    return re.sub(r"\W+", "_", f"{how}_{what}")


@dataclass(frozen=True)
class Gain:
    """One gain by its ``path`` [``unit``]: what it was and is, and between what it was searched.

    ``effect``: largest change of what is made small, as a share of what it is, where this gain alone goes to an end of
    its range; None where a run fails there.
    """

    path: str
    unit: str
    before: float
    after: float
    low: float
    high: float
    effect: float | None = None

    @property
    def idle(self) -> bool:
        """Whether it has no effect on what is made small."""
        return self.effect is not None and self.effect < _IDLE

    @property
    def end(self) -> str:
        """At which end of its range it is; empty inside."""
        near = _AT_END * (self.high - self.low)
        ends = {"lower": abs(self.after - self.low) <= _AT_END * abs(self.low), "upper": self.high - self.after <= near}
        return next((name for name, there in ends.items() if there), "")


def _ranges(robot: Robot, gains: Gains, within: float) -> dict[str, Gain]:
    """The gains by names of parameters, each as it is now."""
    from tmodes.study.mapping import target_of
    from tmodes.study.resolve import words_of_path

    data, found = sheet_data(robot), dict[str, Gain]()
    given = gains if isinstance(gains, Mapping) else {}
    for path in gains or [*_tuned(robot)]:
        try:
            target = target_of(path, data, relative=False)
        except InputError as error:
            raise InputError("gains", *words_of_path(error)) from None
        own, now = target.paths[0], target.nominal
        if now is None or (path not in given and now == 0.0):
            hint = f"give its range: {{{path!r}: (low, high)}}" if now == 0.0 else "write a number there first"
            raise InputError(f"gains: {path}", "nothing" if now is None else "0", "a number that can be scaled", hint)
        ends = given[path] if path in given else sorted((now / within, now * within))
        low, high = numbers_of(ends, f"gains: {path}", ((2,),), "(low, high)").tolist()
        name = re.sub(r"\W+", "_", own.removeprefix("drives.").removeprefix("control."))
        found[f"gain_{len(found)}_{name}"] = Gain(own, target.unit, now, now, low, high)
    if not found:
        hint = "write them, such as `drives.0.controller.kp`; the class of a law of your own names its gains as `tuned`"
        raise InputError("gains", "none, and no law with gains of its own", "paths of numbers", hint)
    return found


def _tuned(robot: Robot) -> Iterator[str]:
    """Paths of all numbers that the laws of a robot name as tuned, and that are not 0."""
    laws = [(f"drives.{one.joint}.controller", one.controller) for one in robot.drives if one.controller]
    for place, law in laws + [(f"control.{one.name}.block", one.block) for one in robot.control]:
        for name in law.tuned:
            value = getattr(law, name, None)
            each = value.items() if isinstance(value, Mapping) else [("", value)]
            known = [key for key, number in each if isinstance(number, float) and number]
            yield from (f"{place}.{name}.{key}".rstrip(".") for key in known)


def _study(
    robot: Robot, ranges: Mapping[str, Gain], family: Mapping[str, Any], aims: Mapping[str, tuple[str, str]],
    cases: int, limits: Sequence[str],
) -> Study:  # fmt: skip
    from tmodes.study.read import study_of_robot

    def parameter(one: Gain) -> dict[str, Any]:
        kind = "loguniform" if one.low > 0 else "uniform"
        return {"path": one.path, "title": one.path, "distribution": {"type": kind, "low": one.low, "high": one.high}}

    efforts = effort_quantities(robot).items()
    aim = {name: {"series": what, "reduce": how, "title": f"{how} of {what}"} for name, (what, how) in aims.items()}
    asked = {
        "objectives": [{"minimize": name} for name in aims],
        "design": [*ranges],
        "worst_case": cases if family else 0,
    }
    data = {
        "parameters": {name: parameter(one) for name, one in ranges.items()} | dict(family),
        "quantities": aim | {name: {"series": f"{joint}.effort", "reduce": "max_abs",
                                       "title": f"largest {joint}.effort{'' if limits else f', of {limit:g} allowed'}"}
                                for name, (joint, limit) in efforts},
        "optimize": asked | {"limits": [*limits]},
    }  # fmt: skip
    try:
        return study_of_robot(robot, data)
    except InputErrors as errors:
        raise InputErrors([replace(one, which=_as_given(one.which, ranges, aims)) for one in errors.errors]) from None


def _as_given(which: str, ranges: Mapping[str, Gain], aims: Collection[str]) -> str:
    """A path of the study as the arguments have it."""
    group, _, rest = which.partition(".")
    name, _, part = rest.partition(".")
    if group == "quantities" and name in aims:
        first = name == next(iter(aims))
        given = {"series": "minimize" if first else "against", "reduce": "reduce" if first else "against_reduce"}
        return given.get(part.partition(".")[0], which)
    if group != "parameters":
        return which
    return f"gains: {ranges[name].path}" if name in ranges else f"uncertain.{rest}"


def _searched(
    robot: Robot, study: Callable[[Sequence[str]], Study], method: str, trials: int | None, seed: int,
    progress: Progress,
) -> Optimum:  # fmt: skip
    """The optimum, within the limits of the drives; along gradients, which they do not have, where it keeps them."""
    from tmodes.study.optimize import optimize

    free, how = study(()), {"trials": trials, "seed": seed, "progress": progress}
    limits = [f"{name} <= {limit!r}" for name, (_, limit) in effort_quantities(robot).items()]
    if free.sheet.optimize and len(free.sheet.optimize.objectives) > 1:
        return _curve(study, limits, method, how)
    if method in ("auto", "gradient"):
        try:
            found = optimize(free, "gradient", **how)
        except InputError:
            if method == "gradient":
                raise
        else:
            if method == "gradient" or not found.best or _keeps(robot, found.best):
                return found
    return optimize(study(limits), "cobyqa" if method == "auto" else method, **how)


def _curve(
    study: Callable[[Sequence[str]], Study], limits: Sequence[str], method: str, how: Mapping[str, Any]
) -> Optimum:
    """Of two objectives the compromises, along gradients where they have some."""
    from tmodes.study.optimize import optimize

    if method == "auto":
        try:
            return optimize(study(limits), "compromise", **how)
        except InputError:
            method = "nsga2"
    return optimize(study(limits), method, **how)


def _keeps(robot: Robot, best: Candidate) -> bool:
    """Whether the drives keep their limits with these gains."""
    return all(
        best.quantities[name][1] <= _LIMIT_PASSED * limit for name, (_, limit) in effort_quantities(robot).items()
    )


def _tuning(
    whole: UsersRobot, plant: UsersRobot, ranges: Mapping[str, Gain], words: Mapping[str, str], optimum: Optimum,
    family: tuple[str, ...],
) -> Tuning:  # fmt: skip
    best, trials = weighed(optimum), optimum.trials
    assert trials  # noqa: S101
    every = in_all_cases(optimum, best)
    effects = dict(zip(ranges, effects_of([every[name] for name in words]), strict=True))
    gains = tuple(replace(one, after=best.values[name], effect=effects[name]) for name, one in ranges.items())
    before, after = ({name: one[k] for name, one in every.items()} for k in (0, 1))
    changed = {one.path: one.after for one in gains}
    units = trials.study.evaluate(0, trials.study.space.nominal[None]).units
    (aim, what), *more = words.items()
    others = [Against(word, units[name] or "-", before[name], after[name]) for name, word in more]
    efforts = {
        joint: float(after[name].max() / limit) for name, (joint, limit) in effort_quantities(plant).items()
    }  # fmt: skip
    verdicts = [
        one.run(error_estimate=False, model_error=False).summary()["verdict"] for one in (plant, plant.with_(changed))
    ]
    return Tuning(
        whole.name, whole.with_(changed), gains, what, units[aim] or "-", before[aim], after[aim], family, efforts,
        (verdicts[0], verdicts[1]), optimum, next(iter(others), None),
    )  # fmt: skip


@dataclass(frozen=True, eq=False, repr=False)
class Tuning(CommandResult):
    """A ``robot`` with tuned ``gains``, and what that has changed.

    ``what`` [``unit``] was made small; ``before`` and ``after`` (cases,): in each case, the only one is the robot as
    known where nothing is ``uncertain``. ``efforts``: the largest effort of each drive over its limit [-], of all
    cases; ``verdicts``: on the run of the robot as known before and after; ``optimum``: how the gains were found;
    ``against``: what the error is weighed against, if anything.
    """

    name: str
    robot: UsersRobot = field(repr=False)
    gains: tuple[Gain, ...]
    what: str
    unit: str
    before: NDArray[np.float64]
    after: NDArray[np.float64]
    uncertain: tuple[str, ...]
    efforts: Mapping[str, float]
    verdicts: tuple[Mapping[str, Any], Mapping[str, Any]]
    optimum: Optimum
    against: Against | None = None

    @property
    def curve(self) -> Dataset:
        """The trade-off along ``design``: ``error``, ``against``, ``gain`` (design, gain); none is better in both.

        Raises :class:`tmodes.errors.InputError` where nothing was weighed against the error.
        """
        from xarray import Dataset

        if self.against is None:
            raise InputError("curve", "one objective", "an error weighed against something", "tune(against='...')")
        front = self.optimum.front
        parts = zip(("error", "against"), (self.unit, self.against.unit), strict=True)
        series: dict[str, Any] = {name: ("design", [one.objectives[k] for one in front], {"units": unit})
                                  for k, (name, unit) in enumerate(parts)}  # fmt: skip
        gains = [[*one.values.values()] for one in front]
        return Dataset(series | {"gains": (("design", "gain"), gains)}, {"gain": [one.path for one in self.gains]})

    def at(self, design: int) -> UsersRobot:
        """The robot of one ``design`` of the :attr:`curve`."""
        gains = self.curve["gains"].values[design].tolist()
        return self.robot.with_(dict(zip([one.path for one in self.gains], gains, strict=True)))

    def page(self, path: FilePath) -> Path:
        """One self-contained HTML file with all designs that were tried, the curve and the start.

        Raises :class:`tmodes.errors.ResultFileError` where it cannot be written.
        """
        from tmodes.study.page.figures import write_designs

        assert self.optimum.trials  # noqa: S101
        return write_designs(self.optimum, self.optimum.trials.study, Path(path))

    @property
    def sheet(self) -> str:
        """The data sheet of the tuned robot, as YAML."""
        from tmodes.io.sheet_write import robot_to_yaml

        return robot_to_yaml(self.robot)

    @property
    def limited(self) -> tuple[str, ...]:
        """What keeps it from being better: ends of ranges, limits of drives, and what the error that is left is of."""
        from tmodes.result.verdict import culprit_words

        said = [f"{one.path} is at the {one.end} end of its range" for one in self.gains if one.end]
        said += [f"{name} needs {100 * share:.3g} % of its largest effort" for name, share in self.efforts.items()
                 if share >= _AT_LIMIT]  # fmt: skip
        if words := culprit_words(self.verdicts[1]):
            said.append(f"the largest error that is left is of {words}")
        return tuple(said)

    def info(self) -> dict[str, Any]:
        """Plain data, as ``tmodes tune --json`` prints it."""
        return {
            "robot": self.name, "minimized": self.what, "unit": self.unit, "uncertain": list(self.uncertain),
            "cases": len(self.before), "before": float(self.before.max()), "after": float(self.after.max()),
            "gains": [asdict(one) for one in self.gains], "efforts": dict(self.efforts), "limited": list(self.limited),
            "verdicts": [dict(one) for one in self.verdicts], "optimum": self.optimum.info(),
            "against": self.against and {
                "minimized": self.against.what, "unit": self.against.unit,
                "before": float(self.against.before.max()), "after": float(self.against.after.max()),
                "curve": [list(one.objectives) for one in self.optimum.front],
            },
        }  # fmt: skip

    @property
    def data(self) -> Dataset:
        """``before`` and ``after`` (case); ``gain_before``, ``gain_after`` (gain)."""
        from xarray import Dataset

        gains = {f"gain_{when}": ("gain", [getattr(one, when) for one in self.gains]) for when in ("before", "after")}
        cases = {when: ("case", getattr(self, when), {"units": self.unit}) for when in ("before", "after")}
        return Dataset({**cases, **gains}, {"gain": [one.path for one in self.gains]})

    def plot(self, ax: Any = None) -> list[Any]:
        """What was made small over the designs that were tried, the best so far, and where it was before."""
        from tmodes.plot.commands import points
        from tmodes.plot.units import readable

        if self.against:
            return plot_curve(self, self.against, ax)
        rows = self.optimum.history
        best = [self.before.max(), *(min(self.before.max(), value) for _, value in rows), self.after.max()]
        tried = [0, *(k + 1 for k, _ in rows), self.optimum.designs]
        unit = readable(self.unit, best)
        what = f"{self.what} [{unit.name}]" + (f", worst of {len(self.before)}" if self.uncertain else "")
        return points({"": (tried, unit.of(best))}, "designs tried", what, title=self.name, ax=ax, line="-")

    def tables(self) -> Iterator[str | Table]:
        """Before and after, the gains, and what limits."""
        before, after = float(self.before.max()), float(self.after.max())
        where = f" in the worst of {len(self.before)} cases" if self.uncertain else ""
        yield f"{self.name}: {self.what} {said(before, self.unit)} before, {said(after, self.unit)} after{where}."
        if other := self.against:
            ends = (said(float(one.max()), other.unit) for one in (other.before, other.after))
            yield f"Against {other.what}: {' before, '.join(ends)} after{where}."
        columns = ["gain", "unit", "before", "after", "", "range"]
        rows = [
            [one.path, one.unit, f"{one.before:.5g}", f"{one.after:.5g}", changed_by(one.after, one.before),
             f"{one.low:.4g} to {one.high:.4g}"]
            for one in self.gains
        ]  # fmt: skip
        how = "along gradients" if self.optimum.method == "gradient" else f"by {self.optimum.method}"
        title = f"{count_of(len(self.gains), 'gain')}, {count_of(self.optimum.designs, 'design')} tried {how}"
        yield known_columns(title, columns, rows)
        if self.against:
            yield curve_table(self, self.against)
        yield "\n".join(f"Limited: {one}." for one in self.limited)
        if idle := [one.path for one in self.gains if one.idle]:
            yield f"Without effect on the {self.what} from end to end of the range: {', '.join(idle)}."

    @property
    def warnings(self) -> list[str]:
        """Where the gains are no better, or drives pass their limits."""
        said = [f"{name} needs {100 * share:.3g} % of its largest effort" for name, share in self.efforts.items()
                if share > _LIMIT_PASSED]  # fmt: skip
        return [*said, "no better gains were found"] if self.after.max() >= self.before.max() else said
