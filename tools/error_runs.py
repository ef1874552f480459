"""Random runs whose printed errors are compared with the true ones: one line of JSON for each, kept in a file."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.random import default_rng

from random_robots import KINDS, random_robot
from tmodes.errors import TmodesError
from tmodes.result.assemble import ResultAssembly
from tmodes.result.errors import SummaryNumber, summary_figures
from tmodes.result.summary import mean_over_time
from tmodes.sheet import Robot
from tmodes.simulation.simulate import simulate_motion

__all__ = [
    "FUNCTIONS", "LINK_MODEL", "LUMPED", "LUMPS", "METHODS", "Case", "cases", "judged", "kept", "measured",
    "model_cases", "simulated",
]  # fmt: skip

TOLERANCES = (None, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-8, 1e-10)
"""Relative tolerances that are drawn; None: the method's own."""

STEPS = (None, 5e-3, 2e-3, 1e-3, 5e-4, 2e-4)
"""Fixed steps [s] that are drawn; None: the default."""

METHODS = ("auto", "dormand_prince", "dop853", "extrapolation", "rosenbrock", "rk4", "midpoint")

LINK_MODEL = "link model"
"""In place of a method: the error of the flexible links' models is judged."""

FLEXIBLE, FUNCTIONS = ("beams", "slewing", "spatial"), (1, 2, 3, 4)
"""Kinds of robots on which that is done, and with how many functions in each direction."""

LUMPED, LUMPS, FINE = ("segments", "modes"), (1, 2), 4
"""Link models of lumped masses that are judged too, of how many lumps; functions of the links that are the truth."""

TRUTHS = (1e-13, 1e-12, 1e-11)
"""Relative tolerances of dop853 with which true values are computed: the first two that come to their end. The second
shows how exact the first is."""


class Case(NamedTuple):
    """A random run: a robot and how it is integrated; ``tolerance``: relative, or the step [s]; None: as by default.

    Of link models: the number of functions; where ``method`` is one of :data:`LUMPED`, of its lumps.
    """

    kind: str
    seed: int
    method: str
    tolerance: float | None

    def robot(self, robot: Robot) -> Robot:
        """The robot with these settings."""
        changes: dict[str, Any] = {"method": self.method}
        if self.tolerance is not None and self.method in ("rk4", "midpoint"):
            changes["step"] = self.tolerance
        elif self.tolerance is not None:
            changes |= {"relative_tolerance": self.tolerance, "absolute_tolerance": self.tolerance * 1e-3}
        return _with(robot, changes)


def cases(seeds: range) -> Iterator[list[Case]]:
    """Cases of the same robot together: every method once, the first of each robot with all defaults; link models."""
    for seed in seeds:
        for kind in KINDS:
            rng = default_rng([seed, 7, *kind.encode()])
            drawn = [
                rng.choice(np.array(STEPS if m in ("rk4", "midpoint") else TOLERANCES, dtype=object)) for m in METHODS
            ]
            yield [Case(kind, seed, m, None if m == "auto" else t) for m, t in zip(METHODS, drawn, strict=True)]
        yield from model_cases(seed)


def model_cases(seed: int) -> Iterator[list[Case]]:
    """Cases of link models; modes bend both ways, as only one kind of robot does."""
    for kind in FLEXIBLE:
        yield [Case(kind, seed, LINK_MODEL, count) for count in FUNCTIONS]
        for model in LUMPED if kind == "spatial" else LUMPED[:1]:
            yield [Case(kind, seed, model, count) for count in LUMPS]


def measured(group: list[Case]) -> Iterator[dict[str, Any]]:
    """The printed error of each number of each run of one robot, and the true one, with what is known of the latter."""
    robot = random_robot(group[0].kind, group[0].seed)
    if group[0].method not in METHODS:
        yield from ({**case._asdict(), **_of_model(robot, case)} for case in group)
        return
    exact = []
    for tolerance in TRUTHS:
        changes = {"method": "dop853", "relative_tolerance": tolerance, "absolute_tolerance": 1e-3 * tolerance}
        with suppress(TmodesError):
            exact.append(simulated(_with(robot, changes)))
    whole = [one for one in exact if one.ending[0] == "finished"][:2]
    for case in group:
        found = _one(case, robot, whole[0], whole[1]) if len(whole) == 2 else {"left_out": "no true values"}
        yield {**case._asdict(), **found}


def _of_model(robot: Robot, case: Case) -> dict[str, Any]:
    """The same of link models; two functions more in each direction are the truth."""
    lumped, count = case.method in LUMPED, int(case.tolerance or 1)
    robot = _bare(robot) if case.seed % 2 else robot
    robot = robot.model_copy(update={"real": {}}) if lumped else robot  # a factor on what modes do not have
    coarse = _with_beams(robot, lambda beam: beam.variant(case.method if lumped else beam.model, count))
    fine = _with_beams(coarse, lambda beam: beam.variant("strain", FINE) if lumped else beam.finer(2))
    try:
        run, truth = simulated(coarse), simulated(fine)
    except TmodesError as error:
        return {"left_out": str(error)}
    if {run.ending[0], truth.ending[0]} != {"finished"} or not run.model_errors["figures"]:
        return {"left_out": "not finished, or not estimated"}
    added = [one.errors.get("figures", {}) for one in (run, truth)]  # true errors below it are those of the integration
    rows = judged(run, truth, truth, run.model_errors)
    return {"rows": [(*row[:4], max(one.get(row[0], 0.0) for one in added), row[5]) for row in rows]}


def _bare(robot: Robot) -> Robot:
    """The robot without the load at its end, so that the link's own mass counts."""
    *inner, last = robot.links
    return robot.model_copy(update={"links": (*inner, last.model_copy(update={"bodies": last.bodies[:1]}))})


def _with_beams(robot: Robot, change: Callable[[Any], Any]) -> Robot:
    links = tuple(link.model_copy(update={"beam": link.beam and change(link.beam)}) for link in robot.links)
    return robot.model_copy(update={"links": links})


def _one(case: Case, robot: Robot, truth: ResultAssembly, check: ResultAssembly) -> dict[str, Any]:
    try:
        run = simulated(case.robot(robot))
    except TmodesError as error:
        return {"left_out": str(error)}
    if run.ending[0] != "finished":
        return {"left_out": run.ending[0]}
    if not run.errors:
        return {"left_out": "not estimated"}
    info = {key: run.run.statistics.get(key) for key in ("method", "steps", "contact_changes", "switches")}
    return {"used": info, "rows": judged(run, truth, check)}


def judged(
    run: ResultAssembly, truth: ResultAssembly, check: ResultAssembly, errors: Mapping[str, Any] | None = None
) -> list[tuple[str, bool, float, float, float, float]]:
    """Of each number of a run: its name, whether its error is a bound, the printed error, the true one, and sizes.

    These are: how far ``check`` is from the truth, and the number's own size. ``errors``: those that are printed; by
    default of the integration.
    """
    errors = errors or run.errors
    own, true, near = ({f.name: f for f in summary_figures(*one.series)} for one in (run, truth, check))
    rows = []
    for name, printed in errors["figures"].items():
        if name in true and name in near:
            far = _far(own[name], true[name], run, truth)
            unsure = _far(near[name], true[name], check, truth)
            scale = float(np.abs(own[name].values(run.series[0])).max())
            rows.append((name, name not in errors.get("approximate", ()), printed, far, unsure, scale))
    return rows


def _far(one: SummaryNumber, other: SummaryNumber, run: ResultAssembly, truth: ResultAssembly) -> float:
    """How far a number of a run is from the same of the truth."""
    values, exact = one.values(run.series[0]), other.values(truth.series[0])
    if one.mean:
        return abs(mean_over_time(run.run.times, values[:, 0]) - mean_over_time(truth.run.times, exact[:, 0]))
    if one.sample is None or other.sample is None:
        return float(np.linalg.norm(values - exact, axis=1).max())
    return abs(float(np.linalg.norm(values[one.sample]) - np.linalg.norm(exact[other.sample])))


def simulated(robot: Robot) -> ResultAssembly:
    """A run, and what is asked of it."""
    return ResultAssembly(simulate_motion(robot), robot)


def _with(robot: Robot, changes: Mapping[str, Any]) -> Robot:
    return robot.with_({f"integration.{name}": value for name, value in changes.items()})


def kept(file: Path) -> list[dict[str, Any]]:
    """The records of a file, if there is one; what a killed process left half is dropped."""
    lines = file.read_text(encoding="utf-8").splitlines(keepends=True) if file.exists() else []
    return [json.loads(line) for line in lines if line.endswith("\n")]
