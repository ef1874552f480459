"""Cases that are written out, one by one."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated, Literal

import numpy as np
from pydantic import Field

from tmodes.kinds.schema.frames import list_of_numbers
from tmodes.kinds.schema.quantity import LARGEST, Issue
from tmodes.study.plans.contract import PLANS, Design, Plan, Space
from tmodes.study.plans.named import unknown_names

__all__ = ["ListOfCases"]

Value = Annotated[float, Field(ge=-LARGEST, le=LARGEST)]


@PLANS.register
class ListOfCases(Plan):
    """The ``cases``, each with values of parameters by name, or a CSV ``file`` with a column for each of them.

    What a case leaves out is nominal. A choice is given by its name or its number.
    """

    type: Literal["list"] = Field(description="kind of plan")
    rows: tuple[dict[str, Value], ...] = list_of_numbers(
        "parameter", "x", "values by parameter, for each case", default=()
    )
    file: str | None = Field(default=None, min_length=1, max_length=200, description="CSV file in the study's folder")

    def _issues(self) -> Iterator[Issue]:
        if bool(self.rows) == bool(self.file):
            got = "both" if self.file else "neither"
            yield Issue("", got, "either rows or a file", "write `rows: [{gear: 0.8}, {gear: 1.2}]`, or `file`")

    def cases(self, space: Space) -> int:  # noqa: ARG002
        """Those that are written."""
        return len(self.rows)

    def design(self, space: Space) -> Design:
        """The values of each, nominal where none is given."""
        values = np.tile(space.nominal, (len(self.rows), 1))
        for k, row in enumerate(self.rows):
            for name, value in row.items():
                values[k, list(space.names).index(name)] = value
        return Design(values)

    def issues(self, space: Space) -> Iterator[Issue]:
        """Names that no parameter has, and numbers of choices that there are not."""
        for k, row in enumerate(self.rows):
            yield from unknown_names(f"rows.{k}", row, space)
            for name in space.chosen & row.keys():
                most = len(space.levels(name, 1)) - 1
                if row[name] not in range(most + 1):
                    got = repr(row[name])
                    yield Issue(f"rows.{k}.{name}", got, f"a whole number from 0 to {most}", "count entries from 0")
