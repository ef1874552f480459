"""Studies of a robot: many cases by a plan, sensitivity, the best design, and the gradient of one run."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tmodes.errors import InputError
from tmodes.io.arguments import checked_arguments
from tmodes.io.printed import CommandResult, Table

if TYPE_CHECKING:
    from xarray import Dataset

    from tmodes.gradients.gradient import Gradient as Derivatives
    from tmodes.gradients.quantities import Functional
    from tmodes.sheet import Robot
    from tmodes.study.optimize import Optimum
    from tmodes.study.result import StudyResult
    from tmodes.study.sensitivity import Sensitivity
    from tmodes.study.study import Study

__all__ = ["GradientResult", "changed_study", "gradient", "optimize", "sensitivity", "study"]

Asked = str | os.PathLike[str] | Mapping[str, Any]
"""The file of a study, or its plain data."""

Functions = Mapping[str, Callable[[Any], float]]
Progress = Callable[[str, float], None]


@checked_arguments
def study(
    robot: Robot,
    study: Study | Asked,
    *,
    on: str = "local",
    out: str | os.PathLike[str] | None = None,
    runs: int | None = None,
    threads: int | None = None,
    recompute: bool = False,
    overwrite: bool = False,
    page: bool = False,
    insecure: bool = False,
    tls: Path | None = None,
    resource: Mapping[str, str] | None = None,
    functions: Functions | None = None,
    progress: Progress = lambda stage, share: None,
) -> StudyResult:
    """Many cases of this robot by a plan, and the quantities that are asked of each.

    ``study``: plain data with the keys of a study file (``parameters``, ``plan``, ``quantities``), such a file, or a
    :class:`tmodes.Study`; its robot is this one. ``out``: its folder, None for a temporary one; what is finished is
    kept there, and the same call computes what is missing. ``on``, ``threads``, ``recompute``, ``overwrite``,
    ``insecure``, ``tls``, ``resource``: as of :func:`tmodes.run_study`. ``runs``: number of cases in place of the
    plan's own. ``page``: also write study.html. ``functions``: Python functions of a :class:`tmodes.Result` that
    quantities of the type ``function`` name.

    Raises :class:`tmodes.errors.InputErrors` with all that is wrong in the study, before anything runs, and
    :class:`tmodes.errors.ResultFileError` for a folder that cannot be used. A case that fails is a row with its reason.

    >>> robot = tmodes.load("spong1987").with_({"integration.duration": 0.1})
    >>> between = {"type": "uniform", "low": 80, "high": 120}
    >>> found = robot.study({
    ...     "parameters": {"k": {"path": "gear.stiffness", "distribution": between}},
    ...     "plan": {"type": "grid", "levels": 3},
    ...     "quantities": {"peak": {"series": "deviation", "reduce": "max"}},
    ... })
    >>> found.data["peak"].sizes["case"]
    3
    """
    from tmodes.study.read import study_of_robot
    from tmodes.study.runner import run_study

    asked = changed_study(study_of_robot(robot, study, functions=functions), {}, runs)
    folder = Path(tempfile.mkdtemp(prefix="tmodes-study-") if out is None else out)
    found = run_study(
        asked, folder, on, threads=threads, recompute=recompute, overwrite=overwrite, insecure=insecure, tls=tls,
        resources=resource, progress=progress,
    )  # fmt: skip
    if page:
        from tmodes.study.page import write_page

        write_page(found, folder / "study.html", progress=progress)
    return found


def changed_study(asked: Study, changes: Mapping[str, Any], runs: int | None) -> Study:
    """The study with changes of its robot by path, and its number of cases.

    Raises :class:`tmodes.errors.InputError` for a plan without runs, and for changes of a study without a robot.
    """
    from tmodes.io.sheet_check import sheet_data

    sheet, robot = dict(asked.data["study"]), asked.data["robot"]
    if runs is not None:
        if "runs" not in type(asked.sheet.plan).model_fields:
            got = f"{runs} runs of the plan `{asked.sheet.plan.name_of_kind()}`"
            raise InputError("--runs", got, "given for a plan that has runs", "change the plan in the file")
        sheet["plan"] = {**sheet["plan"], "runs": runs}
    if changes:
        if asked.robot is None:
            raise InputError("--set", "a study without a robot", "given for a study of a robot", "leave it out")
        sheet["set"] = {**sheet.get("set", {}), **changes}
        robot = sheet_data(asked.robot.stated.with_(changes))
    if runs is None and not changes:
        return asked
    found = asked.from_data({"study": sheet, "robot": robot}, functions=asked.functions)
    return replace(found, places=asked.places)


@checked_arguments
def sensitivity(
    robot: Robot,
    study: Study | Asked,
    *,
    method: str = "sobol",
    samples: int | None = None,
    seed: int = 0,
    second_order: bool = False,
    out: str | os.PathLike[str] | None = None,
    functions: Functions | None = None,
    progress: Progress = lambda stage, share: None,
) -> Sensitivity:
    """How much each parameter of a study of this robot makes its quantities vary.

    Arguments and errors as of :func:`tmodes.sensitivity`, the study as of :meth:`tmodes.Robot.study`.

    >>> parameters = {"k": {"distribution": {"type": "uniform", "low": 1, "high": 2}}}
    >>> study = {"parameters": parameters, "quantities": {"y": {"expression": "k**2"}}}
    >>> tmodes.load("spong1987").sensitivity(study, samples=64).ranked("y")
    ('k',)
    """
    from tmodes.study.read import study_of_robot
    from tmodes.study.sensitivity import sensitivity as analysed

    asked = study_of_robot(robot, study, functions=functions)
    how = {"samples": samples, "seed": seed, "second_order": second_order, "out": out, "progress": progress}
    return analysed(asked, method, **how)


@checked_arguments
def optimize(
    robot: Robot,
    study: Study | Asked,
    *,
    method: str = "auto",
    trials: int | None = None,
    seed: int = 0,
    out: str | os.PathLike[str] | None = None,
    functionals: Mapping[str, Functional] | None = None,
    functions: Functions | None = None,
    progress: Progress = lambda stage, share: None,
) -> Optimum:
    """The best design of this robot by the objectives and limits of a study's ``optimize``.

    Arguments and errors as of :func:`tmodes.optimize`, the study as of :meth:`tmodes.Robot.study`.

    >>> parameters = {"k": {"distribution": {"type": "discrete", "values": [1, 2, 3]}}}
    >>> study = {"parameters": parameters, "quantities": {"y": {"expression": "(k - 2)**2"}}}
    >>> study["optimize"] = {"objectives": [{"minimize": "y"}], "design": ["k"]}
    >>> round(tmodes.load("spong1987").optimize(study).best.values["k"], 6)
    2.0
    """
    from tmodes.study.optimize import optimize as best_design
    from tmodes.study.read import study_of_robot

    asked = study_of_robot(robot, study, functions=functions)
    how = {"trials": trials, "seed": seed, "out": out, "functionals": functionals, "progress": progress}
    return best_design(asked, method, **how)


@checked_arguments
def gradient(
    robot: Robot, functional: Functional, paths: Sequence[str], *, most_bytes: float | None = None
) -> GradientResult:
    """Exact derivatives of one number that is measured on a run, by numbers of the sheet.

    ``functional``: as :func:`tmodes.tracking_error` gives it, or a :class:`tmodes.Functional` of one's own; ``paths``:
    of the sheet, such as ``gear.stiffness``; the derivatives are per SI unit of each. One sweep in reverse over the
    recorded steps, see :func:`tmodes.adjoint_gradient`, which has the errors and the sources. ``most_bytes``: of
    memory, for the states of the steps.

    >>> robot = tmodes.load("spong1987").with_({"integration.duration": 0.1})
    >>> found = robot.gradient(tmodes.tracking_error("tip", [0, 0, -1]), ["gear.stiffness"])
    >>> found.by["gear.stiffness"] != 0
    True
    """
    from tmodes.gradients.gradient import adjoint_gradient

    memory = {} if most_bytes is None else {"most_bytes": most_bytes}
    return GradientResult(robot.name, adjoint_gradient(robot, functional, paths, **memory))


@dataclass(frozen=True, eq=False, repr=False)
class GradientResult(CommandResult):
    """The ``value`` that is measured on a run, and its derivatives ``by`` path, per SI unit of each number.

    ``found``: also by the state at the start, by all numbers of the compiled code and by the signals, and the cost.
    """

    name: str
    found: Derivatives = field(repr=False)

    @property
    def value(self) -> float:
        """What is measured."""
        return self.found.value

    @property
    def by(self) -> dict[str, float]:
        """Derivatives by path."""
        return self.found.by

    def info(self) -> dict[str, Any]:
        """Plain data."""
        return {"robot": self.name, "value": self.value, "by": dict(self.by)}

    @property
    def data(self) -> Dataset:
        """``value`` and ``derivative`` (path)."""
        from xarray import Dataset

        return Dataset({"value": self.value, "derivative": ("path", list(self.by.values()))}, {"path": list(self.by)})

    def plot(self, ax: Any = None) -> list[Any]:
        """The derivatives as bars."""
        from tmodes.plot.commands import bars

        return bars({"": list(self.by.values())}, list(self.by), "derivative [1/unit]", title=self.name, ax=ax)

    def tables(self) -> Iterator[str | Table]:
        """The value and one row for each path."""
        rows = [[path, f"{slope:.6g}"] for path, slope in self.by.items()]
        yield Table(f"{self.name}: {self.value:.6g}, and its derivatives", ["by", "per SI unit"], rows)
