"""The designs among which an optimization chooses."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from math import prod

import numpy as np
from numpy.typing import NDArray

from tmodes.errors import InputError
from tmodes.study.optimize.goals import refuse_unknown
from tmodes.study.sensitivity.run import with_plan
from tmodes.study.sheet import Parameter
from tmodes.study.study import Study

__all__ = ["DesignSpace", "design_space", "scenarios_of"]

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class DesignSpace:
    """k parameters that are chosen: ``names``, their ``columns`` in the study, and ``low`` and ``high`` (k,) values.

    ``levels``: how many entries a parameter has that is chosen from a list, whose values are 0, 1, 2 ...; 0: one that
    may have any value from low to high. ``logarithmic`` (k,): shares of such a one are of the logarithm of its value.
    """

    names: tuple[str, ...]
    columns: tuple[int, ...]
    levels: tuple[int, ...]
    low: Array
    high: Array
    logarithmic: NDArray[np.bool_]

    @property
    def continuous(self) -> bool:
        """Whether every parameter may have any value of its range."""
        return not any(self.levels)

    @cached_property
    def count(self) -> int | None:
        """How many designs there are; None: infinitely many."""
        return prod(self.levels) if all(self.levels) else None

    def all(self) -> Array:
        """Every design of a finite space, (count, k)."""
        return np.array([*itertools.product(*map(range, self.levels))], dtype=float)

    def at(self, shares: Array) -> Array:
        """Designs (m, k) at shares (m, k) of the way from the least to the largest value."""
        levels = np.array(self.levels)
        entries = np.minimum(np.floor(shares * levels), levels - 1)
        shares = np.clip(shares, 0.0, 1.0)
        values = np.where(self.logarithmic, self.low * self._ratios**shares, self.low + shares * (self.high - self.low))
        return np.where(levels > 0, entries, values)

    def shares(self, designs: Array) -> Array:
        """The other way round; entries of a list are apart by more than 0."""
        linear = (designs - self.low) / np.where(self.high > self.low, self.high - self.low, 1.0)
        with np.errstate(invalid="ignore", divide="ignore"):
            return np.where(self.logarithmic, np.log(designs / self.low) / np.log(self._ratios), linear)

    def slopes(self, shares: Array) -> Array:
        """Derivatives (k,) of the values at shares (k,), each by its own."""
        return np.where(self.logarithmic, self.at(shares) * np.log(self._ratios), self.high - self.low)

    @cached_property
    def _ratios(self) -> Array:
        return np.divide(self.high, self.low, out=np.full(len(self.low), np.e), where=self.logarithmic)


def design_space(study: Study, names: Sequence[str]) -> DesignSpace:
    """The space of the parameters ``names``; all of the study where there is none.

    Raises :class:`tmodes.errors.InputError` for a name that is no parameter.
    """
    refuse_unknown(names, "optimize.design", study.names)
    chosen = tuple(dict.fromkeys(names)) or study.names
    levels = [_levels(study.sheet.parameters[name]) for name in chosen]
    ends = [_ends(study.sheet.parameters[name], count) for name, count in zip(chosen, levels, strict=True)]
    low, high = np.array(ends, dtype=float).T
    known = [study.sheet.parameters[name].distribution for name in chosen]
    logarithmic = np.array([one is not None and one.logarithmic for one in known])
    columns = tuple(study.names.index(name) for name in chosen)
    return DesignSpace(chosen, columns, tuple(levels), low, high, logarithmic)


def _levels(parameter: Parameter) -> int:
    return 0 if parameter.distribution else len(parameter.choices)


def _ends(parameter: Parameter, levels: int) -> tuple[float, float]:
    if parameter.distribution is None:
        return 0.0, max(levels - 1.0, 0.0)
    return parameter.distribution.ends


def scenarios_of(study: Study, space: DesignSpace, count: int, seed: int) -> NDArray[np.float64]:
    """Values of all parameters in ``count`` cases of what the design leaves uncertain, the same for all designs.

    Without any case the sheet's own values. Raises :class:`tmodes.errors.InputError` where nothing is uncertain.
    """
    if not count:
        return study.space.nominal[None].copy()
    if len(space.names) == len(study.names):
        hint = "name what is chosen under `optimize.design`; the other parameters are uncertain"
        raise InputError(
            "optimize.worst_case", f"{count} cases of nothing", "left out: all parameters are chosen", hint
        )
    return with_plan(study, {"type": "latin_hypercube", "runs": count, "seed": seed}).design().values
