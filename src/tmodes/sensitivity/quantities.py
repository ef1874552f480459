"""Quantities at the samples of a run, and their derivatives by the states, the parameters and the signals."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.model.derivatives import Blocks
from tmodes.sensitivity.lowering import Lowered
from tmodes.sensitivity.outputs import RunOutputs
from tmodes.simulation.recording import Recording

__all__ = ["Quantities", "Weights"]

Array = NDArray[np.float64]


class Weights(NamedTuple):
    """Derivatives of a number: by the states at the samples, (n, size), the parameters, the rows (segments, row)."""

    states: Array
    parameters: Array
    rows: Array


class Quantities:
    """Quantities at the samples of a run, by their names.

    ``state`` (n, size); what :meth:`tmodes.simulation.loop.LoopModel.observe` gives; and ``tip``, ``tip_velocity``,
    ``points.NAME`` and ``points.NAME_velocity`` (n, 3) [m, m/s] of the named points, in the world. Raises
    :class:`tmodes.errors.InputError` for other names.
    """

    def __init__(self, here: Lowered, done: Recording, names: Sequence[str]) -> None:
        self.done, self.names = done, tuple(dict.fromkeys(names))
        self._pieces = np.clip(np.searchsorted(done.rows[:, 0], done.times, side="right") - 1, 0, len(done.rows) - 1)
        time = done.times[:, None]
        instants = {"time": time, "state": done.samples, "row": done.rows[self._pieces], "step": np.zeros_like(time)}
        self._seen = RunOutputs(here, instants, tuple(name for name in self.names if name != "state"))

    def info(self) -> Blocks:
        """Their values at the samples."""
        info = self._seen.info()
        return {name: self.done.samples if name == "state" else info[name] for name in self.names}

    def back(self, weights: Mapping[str, ArrayLike]) -> Weights:
        """Derivatives of the sum of ``weights`` times the quantities, each in its shape."""
        done = self.done
        given = {name: np.asarray(value, dtype=float) for name, value in weights.items()}
        states, rows = np.zeros_like(done.samples), np.zeros_like(done.rows)
        states += given.pop("state", 0.0)
        if not given:
            return Weights(states, np.zeros(len(self._seen.parameters)), rows)
        found = self._seen.back(given)
        np.add.at(rows, self._pieces, found["row"])
        return Weights(states + found["state"], found["parameters"], rows)

    def along(self, states: Array, parameters: Array, rows: Array) -> Blocks:
        """Their slopes, by names, where the states have slopes (n, size), and parameters and rows change."""
        slopes = {"state": states, "row": rows[self._pieces]}
        found = self._seen.along(slopes, parameters)
        return {name: states if name == "state" else found[name] for name in self.names}
