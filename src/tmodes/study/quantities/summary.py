"""A number of the run's summary, by its path."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Literal

import numpy as np
from pydantic import Field

from tmodes.study.quantities.contract import QUANTITIES, Array, Asked, Needs, Quantity

__all__ = ["Summary"]


@QUANTITIES.register
class Summary(Quantity):
    """A number of the summary by its ``path``: ``settling.time_s``, ``first_frequency_Hz.controlled``."""

    type: Literal["summary"] = Field(description="kind of quantity")
    path: str = Field(min_length=1, max_length=200, description="path in the summary, as `tmodes run --json` prints it")

    def needs(self) -> Needs:
        """The result of the run."""
        return Needs(result=True)

    def own_unit(self, units: Mapping[Any, str]) -> str:
        """By the ending of its key."""
        raise NotImplementedError

    def values(self, asked: Asked) -> tuple[Array, Mapping[int, str]]:
        """What stands there in the summary of each result."""
        return np.array([np.nan if one is None else one.summary() for one in asked.results]), {}
