"""Sensitivities of a run to its data sheet, and gradients of what is measured on it.

The steps of the run are recorded and differentiated as they are, whatever their lengths would be for other numbers: the
results are exact for these steps, and as exact as the tolerances for the motion itself. Where a contact or a gear's
dead zone sets in, steps end on the change; that its time moves with the numbers is not seen, which leaves nothing out
where the force is continuous there. A unilateral surface with a damper lets go with a jump of its force: behind it,
derivatives by what moves that time are wrong.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.arm import Arm
from tmodes.recording import MOST_BYTES
from tmodes.robot import Robot
from tmodes.sensitivity.changes import Changes
from tmodes.sensitivity.lowering import lowered

__all__ = ["Functional", "Gradient", "Sensitivities", "adjoint_gradient", "forward_sensitivities"]

Array = NDArray[np.float64]

Functional = Callable[[Array, Array], tuple[float, ArrayLike]]
"""(times (n,), states (n, size)) -> (value, its derivative by the states (n, size))."""


@dataclass(frozen=True, eq=False)
class Sensitivities:
    """``times`` (n,) [s], ``states`` (n, size), and by path their derivatives (n, size) per unit of the quantity."""

    times: Array
    states: Array
    by: dict[str, Array]


@dataclass(frozen=True, eq=False)
class Gradient:
    """Value of a functional, and its derivatives: by path, by the state at the start (size,), by all parameters.

    ``by`` holds what a quantity does through the state at the start and the signals as well.
    """

    value: float
    by: dict[str, float]
    start: Array
    parameters: Array


def forward_sensitivities(
    sheet: Arm | Robot,
    paths: Sequence[str] = (),
    *,
    start: Mapping[str, ArrayLike] | None = None,
    most_bytes: float = MOST_BYTES,
) -> Sensitivities:
    """Derivatives of the states at all samples by quantities of the sheet: ``links.arm.length``, ``gear.stiffness``.

    ``start``: directions (size,) of the state at the start, by names of one's own. Eight directions are carried along
    at once; of many quantities and one number of interest :func:`adjoint_gradient` is the quicker. ``most_bytes``:
    memory for the states of the steps. Raises :class:`tmodes.errors.InputError` for a path or a method that cannot be
    differentiated (dormand_prince and rk4 can), and :class:`tmodes.errors.SimulationError` for a run that ends early.
    """
    here = lowered(sheet)
    replay = here.recorded(most_bytes)
    done = replay.recording
    lowering = Changes(sheet, here)
    changes = [lowering.along(path) for path in paths]
    first = [change.start for change in changes]
    first += [np.asarray(direction, dtype=float) for direction in (start or {}).values()]
    names = [*paths, *(start or {})]
    parameters, rows = np.zeros((len(names), len(here.parameters.vector))), np.zeros((len(names), *done.rows.shape))
    for k, change in enumerate(changes):
        parameters[k], rows[k] = change.parameters, change.rows
    found = replay.along(np.stack(first), parameters, rows) if names else ()
    return Sensitivities(done.times, done.samples, dict(zip(names, found, strict=True)))


def adjoint_gradient(
    sheet: Arm | Robot, functional: Functional, paths: Sequence[str] = (), *, most_bytes: float = MOST_BYTES
) -> Gradient:
    """Derivatives of one number measured on the samples of a run, by any number of quantities of the sheet.

    One sweep in reverse over the recorded steps gives them all. Errors as of :func:`forward_sensitivities`.
    """
    here = lowered(sheet)
    replay = here.recorded(most_bytes)
    done = replay.recording
    value, weights = functional(done.times, done.samples)
    found = replay.back(np.asarray(weights, dtype=float))
    by, changes = {}, Changes(sheet, here)
    for path in paths:
        change = changes.along(path)
        told = found.parameters @ change.parameters + found.start @ change.start
        by[path] = float(told + (found.rows * change.rows).sum())
    return Gradient(float(value), by, found.start, found.parameters)
