"""How the numbers of a run of the 2010 robot change with the quantities of its data sheet."""

from __future__ import annotations

from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.errors import InputError
from tmodes.paper.mechanism import Drive, Parameters
from tmodes.paper.model import PaperModel
from tmodes.paper.model_derivatives import rest_change
from tmodes.paper.sheet import PaperRobot
from tmodes.sensitivity.differences import Change, near_difference, number_at
from tmodes.sensitivity.lowering import Lowered, rows_of

__all__ = ["RobotChanges"]

Array = NDArray[np.float64]


class RobotChanges:
    """Numbers are the parameters themselves; a reference changes the rows of its pieces and where the motor starts."""

    def __init__(self, sheet: PaperRobot, here: Lowered) -> None:
        self.sheet, self.here = sheet, here
        assert isinstance(here.parameters, Parameters)  # noqa: S101
        assert isinstance(here.model, PaperModel)  # noqa: S101
        self.parameters, self.mechanism = here.parameters, here.model.mechanism
        self.rows = rows_of(here.schedule, here.settings.duration)

    def along(self, path: str) -> Change:
        """By one quantity; see :class:`tmodes.sensitivity.changes.Changes`."""
        if path.startswith("reference."):
            return self._of_reference(path)
        number_at(path, self._known.get(path))
        unit, start = np.zeros_like(self.parameters.vector), np.zeros_like(self.here.start)
        unit[self.parameters.names.index(path)] = self.sheet.real.get(path, 1.0)
        start[:6] = self._rest[1] @ unit
        return Change(unit, start, np.zeros_like(self.rows))

    @cached_property
    def _known(self) -> dict[str, float]:
        return dict(self.sheet.numbers())

    @cached_property
    def _rest(self) -> tuple[Array, Array]:
        return rest_change(self.mechanism, self.parameters, self.sheet.reference.start, self.here.start)

    def _of_reference(self, path: str) -> Change:
        value = number_at(path, _inside(self.sheet.model_dump(), path), zero=True)

        def numbers(change: float) -> Array:
            changed = self.sheet.with_({path: value + change})
            rows = rows_of(changed.wanted(Drive.CONTROLLED), self.here.settings.duration)
            if rows.shape != self.rows.shape or not np.array_equal(rows[:, 0], self.rows[:, 0]):
                raise InputError(
                    path, "a change of the times at which pieces of the reference end",
                    "a change of numbers alone, along which a run can be differentiated", "name another quantity",
                )  # fmt: skip
            return np.append(rows, changed.reference.start)

        found, start = near_difference(numbers, value), np.zeros_like(self.here.start)
        start[:6] = self._rest[0] * found[-1]
        return Change(np.zeros_like(self.parameters.vector), start, found[:-1].reshape(self.rows.shape))


def _inside(data: Any, path: str) -> Any:
    for step in path.split("."):
        data = data.get(step) if isinstance(data, dict) else None
    return data
