"""A formula of time."""

from __future__ import annotations

from typing import Literal, Self

from pydantic import Field, model_validator

from tmodes.kinds.schema.quantity import Issue, refuse
from tmodes.kinds.signals.contract import SIGNALS, Signal
from tmodes.kinds.signals.fit import fitted
from tmodes.kinds.signals.formula import FormulaError, parse_formula
from tmodes.kinds.signals.schedule import Schedule

__all__ = ["Expression"]


@SIGNALS.register
class Expression(Signal):
    """A formula of the time t [s], such as ``0.2*sin(2*pi*t)*exp(-t)``."""

    type: Literal["expression"] = Field(description="kind of signal")
    formula: str = Field(min_length=1, max_length=500, description="formula of t")

    @model_validator(mode="after")
    def _readable(self) -> Self:
        try:
            parse_formula(self.formula)
        except FormulaError as error:
            refuse([Issue("formula", error.got, error.expected, error.hint)])
        return self

    def schedule(self, until: float) -> Schedule:
        """Pieces of degree 7, exact to 1e-12 of the largest value, up to ``until`` [s].

        Raises :class:`tmodes.errors.InputError` where the formula has no value or jumps.
        """
        return fitted(parse_formula(self.formula), until, "formula")
