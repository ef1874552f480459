"""A controller that is a Python function, asked with care."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.errors import SimulationError, error_words

__all__ = ["Controller", "Guarded", "controller_error", "controller_name"]

Array = NDArray[np.float64]

Controller = Callable[[float, Array, Array], ArrayLike]
"""(time [s], q (nq,), v (nq,)) -> effort (m,) [N*m, N] of each drive that follows no signal, in their order."""


@dataclass
class Guarded:
    """A controller that is asked with care: wrong returns and raised errors are reported with name and time."""

    controller: Controller
    joints: tuple[str, ...]
    size: int

    def __call__(self, time: float, q: Array, v: Array) -> Array:
        """The efforts (m,); raises :class:`tmodes.errors.SimulationError` for an answer that is none."""
        q, v = q.copy(), v.copy()
        q.flags.writeable = v.flags.writeable = False
        try:
            effort = np.asarray(self.controller(time, q, v), dtype=float)
        except Exception as error:
            raise controller_error(self.controller, time, error_words(error), "an answer") from error
        wanted = f"an array of shape ({len(self.joints)},), the efforts of {', '.join(self.joints)}"
        if effort.shape != (len(self.joints),):
            raise controller_error(self.controller, time, f"an array of shape {effort.shape}", wanted)
        if not np.isfinite(effort).all():
            bad = int(np.flatnonzero(~np.isfinite(effort))[0])
            raise controller_error(
                self.controller, time, f"{effort[bad]} for joint {self.joints[bad]}", "finite numbers"
            )
        return effort


def controller_name(controller: object) -> str:
    """What a controller is called."""
    return getattr(controller, "__qualname__", type(controller).__qualname__)


def controller_error(controller: object, time: float, got: str, expected: str) -> SimulationError:
    """The error of an answer that is none, with name and time [s]."""
    name = controller_name(controller)
    return SimulationError(
        f"controller {name} at t = {time:.6g} s must return {expected}, got {got}; correct the function"
    )
