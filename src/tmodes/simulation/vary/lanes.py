"""From a data sheet with some numbers changed to a lane of a batch: its structure, numbers, motion and start."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.stability import chosen_settings
from tmodes.errors import InputError, InputErrors
from tmodes.integrate.settings import Integration
from tmodes.kinds.signals.schedule import Schedule
from tmodes.sheet import Robot
from tmodes.simulation.loop import LoopModel
from tmodes.simulation.motion_run import tip_positions
from tmodes.simulation.start import run_setup

__all__ = ["Lane", "changed_sheet", "lane_of"]

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Lane:
    """One robot that is to run. Lanes of the same ``key`` run on the same code, that of any one's ``model``.

    ``tip`` gives the positions (n, 3) [m] of the tip in the world, of times (n,) [s] and states (n, nx).
    """

    key: Hashable
    model: LoopModel
    parameters: Array
    schedule: Schedule
    start: Array
    settings: Integration
    tip: Callable[[Array, Array], Array]


def changed_sheet(sheet: Robot, changes: Mapping[str, Any], lane: int) -> Robot:
    """The checked sheet of a lane as it really is; errors say which lane they are of."""
    try:
        return sheet.with_(changes).pair().real
    except InputErrors as wrong:
        raise InputErrors([_placed(error, lane) for error in wrong.errors]) from None
    except InputError as error:
        raise _placed(error, lane) from None


def _placed(error: InputError, lane: int) -> InputError:
    return InputError(error.which, error.got, error.expected, error.hint, f"case {lane} {error.where}".rstrip())


def lane_of(real: Robot) -> Lane:
    """A robot as its sheet says, ready to run.

    Raises :class:`tmodes.errors.SimulationError` where it cannot start, and :class:`tmodes.errors.InputError` for what
    cannot be run.
    """
    regime = run_setup(real)
    model, settings = regime.model, chosen_settings(real.integration, lambda: regime.spectrum)
    key = (model.loop.rate.key, model.coordinates, settings.method)
    schedule = regime.planned.schedule
    start, numbers = regime.start, model.numbers
    return Lane(key, model, numbers, schedule, start, settings, partial(tip_positions, regime))
