"""Compute cases of a study: by the ways that its quantities need, grouped by what cannot differ in one batch."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from tmodes.errors import InputError
from tmodes.io.units import NotANumber, number
from tmodes.simulation.batch.executor import Executor, thread_count
from tmodes.simulation.case_results import CaseResults
from tmodes.study.mapping import Group, groups_of
from tmodes.study.quantities import Asked, Needs, Quantity
from tmodes.study.rows import GOOD, Rows
from tmodes.study.space import ordered

if TYPE_CHECKING:
    from tmodes.study.study import Study

__all__ = ["evaluated"]

Array = NDArray[np.float64]
Progress = Callable[[str, float], None]

_SAME = "gravity.2"
"""A number that every robot has: set to its own value it makes a batch of cases that are all alike."""


def evaluated(
    study: Study, first: int, values: Array, progress: Progress, threads: int | None, executor: Executor
) -> Rows:
    """The rows of cases (m, d), as :meth:`Study.evaluate`."""
    if values.ndim != 2 or values.shape[1] != len(study.names):
        expected = f"an array (cases, {len(study.names)})"
        raise InputError("values", f"an array of shape {values.shape}", expected, "take rows of Study.design().values")
    part = CaseResults.of_all(len(values), "finished")
    if study.robot:
        part = _computed(study, first, values, progress, threads, executor)
    parameters = {name: values[:, k].copy() for k, name in enumerate(study.names)}
    quantities, units = _quantities(study, parameters, part)
    return Rows(
        first + np.arange(len(values)), parameters, quantities, units, part.status.tolist(), part.message.tolist(),
        part.method.tolist(), part.seconds, {first + k: motion for k, motion in part.kept.items()}, part.errors,
    )  # fmt: skip


def _computed(
    study: Study, first: int, values: Array, progress: Progress, threads: int | None, executor: Executor
) -> CaseResults:
    """What the robots of all cases gave, group by group."""
    found, done = CaseResults.of_all(len(values), "finished"), 0
    assert study.robot is not None  # noqa: S101
    for group in groups_of(study.robot, study.names, study.targets, study.choices, values):
        size = len(group.places)

        def tell(stage: str, share: float, before: int = done, size: int = size) -> None:
            progress(stage, (before + share * size) / len(values))

        found.take(group.places, _of_group(study, group, first, tell, threads, executor))
        done += size
    return found


def _of_results(study: Study) -> dict[str, Quantity]:
    return {name: one for name, one in study.sheet.quantities.items() if one.needs().result}


def _of_group(
    study: Study, group: Group, first: int, progress: Progress, threads: int | None, executor: Executor
) -> CaseResults:
    """What the cases of one group gave; those that are all alike are computed once."""
    robot, size = group.robot, len(group.places)
    if robot is None:
        return CaseResults.of_all(size, "refused", group.wrong)
    alike = not group.vary
    vary = {_SAME: np.array([robot.gravity[2]])} if alike else dict(group.vary)
    kept = [k for k, place in enumerate(group.places.tolist()) if _is_kept(study, first + place)]
    of_vary = [0] if alike and kept else kept
    with _named(study):
        found = _found(study, group, vary, of_vary, threads, progress, executor)
    if alike:
        found.seconds /= size
        found, every = found.part(np.zeros(size, dtype=np.int64)), found.kept
        found.kept = {k: every[0] for k in kept if 0 in every}
    return found


@contextmanager
def _named(study: Study) -> Iterator[None]:
    """What a robot does not have is said of the quantity that asks for it."""
    try:
        yield
    except InputError as error:
        for name, one in study.sheet.quantities.items():
            asked = getattr(one, type(one).named, None)
            if asked and (error.which == asked or error.got.endswith(repr(asked))):
                which = f"quantities.{name}.{one.name_of_kind()}"
                where = study.places.get(name, "")
                raise InputError(which, error.got, error.expected, error.hint, where) from None
        raise


def _found(
    study: Study, group: Group, vary: Mapping[str, Array], of_vary: list[int], threads: int | None,
    progress: Progress, executor: Executor,
) -> CaseResults:  # fmt: skip
    """What the cases ``vary`` (m,) of one robot gave, by all ways that the quantities need."""
    needs, robot = study.needs, group.robot
    assert robot is not None  # noqa: S101
    found = CaseResults.of_all(len(next(iter(vary.values()))), "finished")
    if needs.reductions:
        from tmodes.study.ways.reductions import by_reductions

        whole = None if not group.vary or len(group.places) >= study.cases else study.wholes.get(group.kind)
        found.add(by_reductions(robot, vary, needs, of_vary, threads, progress, whole, executor))
    if needs.static:
        from tmodes.study.ways.reductions import by_statics

        found.add(by_statics(robot, vary, needs, threads, progress))
    if needs.result:
        from tmodes.study.ways.results import by_results

        found.add(by_results(robot, vary, _of_results(study), study.functions, needs, threads, progress))
    if of_vary and not needs.reductions:
        from tmodes.simulation.vary.simulate import kept_cases

        found.kept |= kept_cases(robot, vary, of_vary, found.status.tolist(), thread_count(threads), progress)
    return found


def _is_kept(study: Study, case: int) -> bool:
    keep = study.sheet.keep
    return case in keep.cases or bool(keep.every and case % keep.every == 0)


def _quantities(
    study: Study, parameters: Mapping[str, Array], part: CaseResults
) -> tuple[dict[str, Array], dict[str, str]]:
    """Values of all quantities and their units; what has none gives its case the reason."""
    sheet, good = study.sheet, np.array([status in GOOD for status in part.status], dtype=bool)
    known, units = dict(parameters), {}
    needs = {name: one.needs() for name, one in sheet.quantities.items()}
    for name in ordered({name: one.names for name, one in needs.items()}):
        own = sheet.quantities[name]
        asked = _asked(name, needs[name], known, part, len(good))
        if any(key not in part.units for key in (*needs[name].reductions, *needs[name].static)):
            known[name], units[name] = np.full(len(good), np.nan), own.unit or "-"  # no case could be computed
            continue
        values, reasons = own.values(asked)
        values = np.where(good, np.asarray(values, dtype=float), np.nan)
        units[name] = own.unit or own.own_unit(asked)
        known[name] = values * _factor(own.own_unit(asked), units[name], name, study.places)
        for k, why in reasons.items():
            if good[k]:
                part.status[k], part.message[k] = "failed", part.message[k] or f"{name}: {why}"
    return {name: known[name] for name in sheet.quantities}, {name: units[name] for name in sheet.quantities}


def _asked(name: str, needs: Needs, known: Mapping[str, Array], part: CaseResults, size: int) -> Asked:
    """What one quantity asked for."""
    nothing = np.full(size, np.nan)
    return Asked(
        {each: known[each] for each in needs.names} or {"": nothing},
        {pair: part.values[pair] for pair in needs.reductions if pair in part.values},
        {each: part.values[each] for each in needs.static if each in part.values},
        part.units,
        part.values.get(name, nothing) if needs.result else None,
        part.units.get(name, "-"),
        part.reasons.get(name, {}),
    )


def _factor(own: str, wanted: str, name: str, places: Mapping[str, str]) -> float:
    """What values in their own unit are multiplied by; raises InputError for a unit of another dimension."""
    if own == wanted:
        return 1.0
    try:
        one = number(f"1 {wanted}", own)
    except NotANumber as error:
        hint = f"write a unit that {own} converts to, or leave it out"
        which, where = f"quantities.{name}.unit", places.get(name, "")
        got = error.got.replace(f" of '1 {wanted}'", "")
        raise InputError(which, got, f"a unit of {own}", hint, where) from None
    return 1.0 / one if not math.isclose(1.0 / one, round(1.0 / one), rel_tol=1e-12) else float(round(1.0 / one))
