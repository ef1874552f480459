"""What an optimization is for: objectives and limits, judged over what is uncertain."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmodes.errors import InputError
from tmodes.study.optimize.limits import Limit, limits_of
from tmodes.study.optimize.terms import Term
from tmodes.study.sheet import Objective, Optimize

__all__ = ["Aim", "Goals", "Judged", "goals_of"]

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Aim:
    """An objective: a term that is to be small (``sign`` 1) or large (-1)."""

    term: Term
    sign: int

    @property
    def text(self) -> str:
        """In words."""
        return f"{'minimize' if self.sign > 0 else 'maximize'} {self.term.text}"


class Judged(NamedTuple):
    """m designs: values of the ``objectives`` (m, o) and of the terms of the ``limits`` (m, l), each the worst.

    ``excess`` (m, l): by which share each limit is exceeded, negative where it is kept, infinite where a case failed;
    ``feasible`` (m,): all limits are kept, and no case failed.
    """

    objectives: Array
    limits: Array
    excess: Array
    feasible: NDArray[np.bool_]

    @property
    def violation(self) -> Array:
        """Sum of what limits are exceeded by, (m,)."""
        return np.maximum(self.excess, 0.0).sum(axis=1)


@dataclass(frozen=True)
class Goals:
    """Objectives and limits; ``percentile`` of the cases of a design, from its best to its worst one, that counts."""

    aims: tuple[Aim, ...]
    limits: tuple[Limit, ...]
    percentile: float = 100.0

    @property
    def signs(self) -> Array:
        """1 for each objective that is to be small, -1 for one that is to be large."""
        return np.array([aim.sign for aim in self.aims], dtype=float)

    @property
    def names(self) -> tuple[str, ...]:
        """Quantities and parameters of which they are made."""
        terms = (*(aim.term for aim in self.aims), *(limit.term for limit in self.limits))
        return tuple(dict.fromkeys(name for term in terms for name in term.names))

    def judged(self, values: Mapping[str, Array]) -> Judged:
        """Designs from the values (m, cases) of parameters and quantities."""
        objectives = np.stack([self._worst(aim.term.at(values), aim.sign) for aim in self.aims], axis=-1)
        count = len(objectives)
        terms = [self._worst(limit.term.at(values), limit.sign) for limit in self.limits]
        kept = [limit.kept(one) for limit, one in zip(self.limits, terms, strict=True)]
        excess = [limit.excess(one) for limit, one in zip(self.limits, terms, strict=True)]
        held = np.array([*np.isfinite(objectives).T, *kept], dtype=bool)
        feasible: NDArray[np.bool_] = np.logical_and.reduce(held, axis=0)
        return Judged(objectives, _columns(terms, count), _columns(excess, count), feasible)

    def _worst(self, values: Array, sign: int) -> Array:
        """The worst (m,) of all cases (m, cases), or the percentile that counts; a case without value is the worst."""
        bad = np.where(np.isnan(values), np.inf, sign * values)
        found = sign * np.percentile(bad, self.percentile, axis=1, method="higher")
        return np.where(np.isfinite(found), found, np.nan)


def _columns(parts: list[Array], count: int) -> Array:
    return np.stack(parts, axis=-1) if parts else np.empty((count, 0))


def goals_of(asked: Optimize, units: Mapping[str, str | None]) -> Goals:
    """The goals of a sheet; ``units`` of all quantities and parameters by name."""
    aims = tuple(_aim(objective, units) for objective in asked.objectives)
    return Goals(aims, limits_of(asked.limits, units), asked.percentile)


def _aim(objective: Objective, units: Mapping[str, str | None]) -> Aim:
    if bool(objective.minimize) == bool(objective.maximize):
        got = "both" if objective.minimize else "neither"
        hint = "write `- minimize: mass`"
        raise InputError("optimize.objectives", got, "one of minimize and maximize", hint)
    text = objective.minimize or objective.maximize or ""
    return Aim(Term.of(text, "optimize.objectives", units), 1 if objective.minimize else -1)
