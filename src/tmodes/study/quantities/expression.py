"""A formula of parameters and other quantities."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property
from typing import ClassVar, Literal

import numpy as np
from pydantic import Field

from tmodes.kinds.schema.quantity import Issue
from tmodes.kinds.signals.formula import Formula, FormulaError, parse_formula
from tmodes.kinds.signals.formula_grammar import names_in
from tmodes.study.quantities.contract import MOST, QUANTITIES, Asked, Found, Needs, Quantity

__all__ = ["FormulaQuantity"]


@QUANTITIES.register
class FormulaQuantity(Quantity):
    """A ``formula`` such as ``peak + 3*settle``, by the grammar of :mod:`tmodes.kinds.signals.formula_grammar`.

    Names are those of parameters and of other quantities, in the units in which the study gives these: a quantity in
    its ``unit``, a parameter in the unit of its path (SI; a relative one and a choice by its number have none). Its
    own unit is what ``unit`` says; nothing is converted.
    """

    named: ClassVar[str] = "formula"

    type: Literal["expression"] = Field(description="kind of quantity")
    formula: str = Field(min_length=1, max_length=500, description="a formula of parameters and quantities")

    @cached_property
    def _names(self) -> tuple[str, ...]:
        return names_in(self.formula)

    @cached_property
    def _formula(self) -> Formula:
        return parse_formula(self.formula, self._names)

    def needs(self) -> Needs:
        """The names in it."""
        return Needs(names=self._names)

    def name_issues(self, names: Sequence[str]) -> Iterator[Issue]:
        """What is no formula of these names."""
        try:
            parse_formula(self.formula, names)
        except FormulaError as error:
            yield Issue("formula", error.got, error.expected, error.hint)

    def values(self, asked: Asked) -> Found:
        """Its value in each case; one that is not finite, or whose square overflows, has the reason that says so."""
        values = self._formula.at(asked.values)
        known = np.all([np.isfinite(asked.values[name]) for name in self._names], axis=0)
        wrong = np.flatnonzero(known & ~(np.abs(values) <= MOST)).tolist()
        reasons = dict.fromkeys(wrong, f"{self.formula} has no finite value there")
        values[wrong] = np.nan
        return values, reasons
