"""A signal that is a formula of time."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Literal

import numpy as np
from pydantic import Field

from tmodes.kinds.schema.quantity import Issue
from tmodes.kinds.signals.contract import SIGNALS, Signal
from tmodes.kinds.signals.fit import fitted
from tmodes.kinds.signals.formula import FormulaError, parse_formula
from tmodes.kinds.signals.schedule import SignalPieces
from tmodes.kinds.signals.switches import switches

__all__ = ["Expression"]

_LOOKS, _SAME = 400, 1e-12
"""At how many instants a formula is compared with a line, and up to which share of it it is one."""


@SIGNALS.register
class Expression(Signal):
    """A formula of the time t [s], such as ``0.2*sin(2*pi*t)*exp(-t)``."""

    type: Literal["expression"] = Field(description="kind of signal")
    formula: str = Field(min_length=1, max_length=500, description="formula of t")

    def _issues(self) -> Iterator[Issue]:
        try:
            parse_formula(self.formula)
        except FormulaError as error:
            yield Issue("formula", error.got, error.expected, error.hint)

    @property
    def keeps_rate(self) -> bool:
        """Whether it is a line, by its values from 1 us to 1e6 s."""
        times = np.append(0.0, np.geomspace(1e-6, 1e6, _LOOKS))
        values = parse_formula(self.formula)(times)
        ways = values - values[0]
        line = ways[-1] / times[-1] * times
        return bool((np.abs(ways - line) <= _SAME * (np.abs(line) + np.abs(values[0]))).all())

    def pieces(self, until: float) -> SignalPieces:
        """Pieces of degree 7, exact to 1e-12 of the largest value, up to ``until`` [s].

        Raises :class:`tmodes.errors.InputError` where the formula has no value.
        """
        formula = parse_formula(self.formula)
        return fitted(formula, until, "formula", switches(formula.switches(), until))
