"""Trials: designs that were computed, each once; through a study folder they survive an interruption."""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.study.optimize.goals import Goals, Judged
from tmodes.study.optimize.space import DesignSpace
from tmodes.study.plans.systematic import ListOfCases
from tmodes.study.rows import Rows
from tmodes.study.study import Study

__all__ = ["Trials", "stored_rows"]

Array = NDArray[np.float64]


def stored_rows(
    study: Study, cases: Array, first: int, folder: str | os.PathLike[str],
    progress: Callable[[str, float], None], where: dict[str, Any],
) -> Rows:  # fmt: skip
    """Rows of the ``cases`` (m, d) from ``first`` on, of which those that the folder has are not computed again.

    The folder is that of a study whose plan lists all of them: it can be read, and shown, as any other.
    """
    from tmodes.study.runner import run_study

    return _from(run_study(_listed(study, cases), folder, progress=progress, **where).rows, first)


def _listed(study: Study, cases: Array) -> Study:
    rows = [dict(zip(study.names, row, strict=True)) for row in cases.tolist()]
    plan = ListOfCases.model_validate({"type": "list", "rows": rows})
    data = {**study.data, "study": {**study.data["study"], "plan": {"type": "list", "rows": rows}}}
    return replace(study, sheet=study.sheet.model_copy(update={"plan": plan}), data=data)


def _from(rows: Rows, first: int) -> Rows:
    """The rows from a case on."""

    def cut(columns: Any) -> dict[str, Array]:
        return {name: one[first:] for name, one in columns.items()}

    return Rows(
        rows.case[first:], cut(rows.parameters), cut(rows.quantities), rows.units, rows.status[first:],
        rows.reason[first:], rows.method[first:], rows.seconds[first:], errors=rows.errors[first:],
    )  # fmt: skip


Progress = Callable[[str, float], None]


class Trials:
    """Designs in the order in which they were asked for, and what each has given.

    ``scenarios`` (s, d): values of all parameters of a study, in which those of the design are replaced. ``folder``:
    where finished cases are stored: a method that asks for the same designs again, being the same, finds them there.
    """

    def __init__(
        self, study: Study, space: DesignSpace, goals: Goals, scenarios: Array,
        folder: str | os.PathLike[str] | None, progress: Progress, where: dict[str, Any],
    ) -> None:  # fmt: skip
        self.study, self.space, self.goals, self.scenarios = study, space, goals, scenarios
        self._folder, self._progress, self._where = folder, progress, where
        self._number: dict[bytes, int] = {}
        self.designs = np.empty((0, len(space.names)))
        self.values: dict[str, Array] = {}
        self.reasons: list[str] = []

    @property
    def start(self) -> Array:
        """The sheet's own design, within the ranges, (k,) of the unit cube."""
        own = self.study.space.nominal[list(self.space.columns)]
        return np.clip(self.space.shares(own), 0.0, 1.0)

    def __len__(self) -> int:
        return len(self.designs)

    @property
    def cases(self) -> int:
        """Cases that were computed for them."""
        return len(self) * len(self.scenarios)

    def at(self, designs: Array) -> NDArray[np.intp]:
        """The numbers (m,) of designs (m, k) among the trials; those that are new are computed together."""
        designs = np.ascontiguousarray(designs, dtype=float) + 0.0  # no negative zeros
        keys = [row.tobytes() for row in designs]
        new = [k for k, key in enumerate(keys) if key not in self._number and key not in keys[:k]]
        if new:
            self._compute(designs[new])
            for k in new:
                self._number[keys[k]] = len(self._number)
        return np.array([self._number[key] for key in keys], dtype=np.intp)

    def judged(self, numbers: Any = slice(None)) -> Judged:
        """Trials by their numbers, judged; all in order, where none are given."""
        return self.goals.judged({name: one[numbers] for name, one in self.values.items()})

    def add(self, design: Array, values: dict[str, float], reason: str = "") -> None:
        """A design (k,) that was computed elsewhere, in one case; what is not given of it is not-a-number."""
        self._number[(design + 0.0).tobytes()] = len(self)
        for name in {*self.study.names, *self.study.sheet.quantities, *values}:
            before = self.values.get(name, np.full((len(self), 1), np.nan))
            self.values[name] = np.concatenate([before, [[values.get(name, np.nan)]]])
        self.reasons.append(reason)
        self.designs = np.concatenate([self.designs, design[None]])

    def complete(self) -> None:
        """Compute the quantities that a search did not ask for, of all designs."""
        missing = [name for name in self.study.sheet.quantities if np.isnan(self.values[name]).all()]
        rows = self.study.evaluate(0, self.cases_of(self.designs), self._progress).quantities if missing else {}
        self.values |= {name: rows[name].reshape(len(self), -1) for name in missing}

    def _compute(self, designs: Array) -> None:
        first, cases = self.cases, self.cases_of(designs)
        self.take(designs, self._rows(first, cases))

    def take(self, designs: Array, rows: Rows) -> None:
        """Designs (m, k) that were computed, with the rows of all their cases."""
        shape = len(designs), len(self.scenarios)
        for name, one in {**rows.parameters, **rows.quantities}.items():
            before = self.values.get(name, np.empty((0, shape[1])))
            self.values[name] = np.concatenate([before, np.asarray(one, dtype=float).reshape(shape)])
        reasons = np.array([reason or status for reason, status in zip(rows.reason, rows.status, strict=True)], object)
        sums = np.sum([*rows.quantities.values()], axis=0)
        lost: NDArray[np.bool_] = ~np.isfinite(np.asarray(sums, dtype=float)).reshape(shape)
        for group, bad in zip(reasons.reshape(shape), lost, strict=True):
            self.reasons.append(str(group[bad][0]) if bad.any() else "")
        self.designs = np.concatenate([self.designs, designs])

    def cases_of(self, designs: Array) -> Array:
        """All cases (m s, d) of designs (m, k)."""
        cases = np.tile(self.scenarios, (len(designs), 1))
        cases[:, self.space.columns] = np.repeat(designs, len(self.scenarios), axis=0)
        return cases

    def _rows(self, first: int, cases: Array) -> Rows:
        if self._folder is None:
            return self.study.evaluate(first, cases, self._progress)

        known = self.cases_of(self.designs)
        every = np.concatenate([known, cases]) if len(self.designs) else cases
        return stored_rows(self.study, every, first, self._folder, self._progress, self._where)
