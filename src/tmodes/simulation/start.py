"""One arm in motion: as its drives are planned, or under control as it really is; from its first state on."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from tmodes.errors import InputError, SimulationError
from tmodes.model.model import Model
from tmodes.simulation.error_estimate import with_error
from tmodes.simulation.loop import LoopModel
from tmodes.simulation.plan import Follow, Planned, initial_value, planned, starts_at_rest
from tmodes.simulation.stops import Stops
from tmodes.simulation.trajectory import Journal, Trajectory, integrate

if TYPE_CHECKING:
    from tmodes.integrate.settings import Integration
    from tmodes.sheet import Robot

__all__ = ["RunSetup", "first_state", "run_setup", "run_trajectory"]

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class RunSetup:
    """An arm and all that moves it: its plan, its model in the run, and the state (size,) from which it starts.

    ``otherwise``: the settings to go on with where the motion turns out stiff; None: those of the arm to the end.
    """

    arm: Robot
    planned: Planned
    model: LoopModel
    start: Array
    otherwise: Integration | None = None

    @property
    def first_row(self) -> Array:
        """The row of the signals at time 0."""
        return self.planned.schedule.rows_at(np.zeros(1))[0]


def run_setup(arm: Robot, follow: Follow = Follow.SHEET) -> RunSetup:
    """An arm ready to run.

    Raises :class:`tmodes.errors.InputError` for what cannot be run, and :class:`tmodes.errors.SimulationError` where
    there is no static equilibrium to start from, or the mass matrix is singular.
    """
    plan = planned(arm, follow)
    model = LoopModel(plan.plan)
    start = first_state(arm, plan, model)
    rate = model.rate([0.0], start, plan.schedule.rows_at(np.zeros(1)))[0]
    bad = np.flatnonzero(~np.isfinite(rate[model.layout.v]))
    if len(bad):
        raise SimulationError(
            f"no acceleration at the start: got {rate[model.layout.v][bad[0]]} in coordinate "
            f"{model.coordinates[bad[0]]}; expected a number. Mend: give what it moves a mass and an inertia"
        )
    return RunSetup(arm, plan, model, start)


def first_state(arm: Robot, plan: Planned, model: LoopModel) -> Array:
    """The state at time 0: at rest under the first commands, or undeformed; given coordinates and rates on top."""
    names, layout = model.coordinates, model.layout
    state = np.zeros(layout.size)
    state[layout.controls] = model.plan.controls
    _refuse_unknown_feedback(model)
    held: dict[str, float] = {}
    for driver in model.loop.drivers:
        held[names[driver.coordinate]] = initial_value(arm, driver.plan.joint)
    state[layout.q] = _rest(arm, plan, held) if starts_at_rest(arm) else _undeformed(names, held)
    motors = {name.removesuffix(".motor"): name for name in names if name.endswith(".motor")}
    for group, block in (("coordinates", layout.q), ("rates", layout.v)):
        info: Mapping[str, float] = getattr(arm.initial, group)
        for name, value in info.items():
            if name not in names:
                known = ", ".join(names[:8]) + ("..." if len(names) > 8 else "")
                raise InputError(f"initial.{group}.{name}", "an unknown coordinate", f"one of {known}", "correct it")
            state[block][names.index(name)] = value
            if group == "rates" and name in motors and motors[name] not in info:
                state[block][names.index(motors[name])] = value
    for driver in model.loop.drivers:
        if driver.plan.servo is None:
            for block, derivative in ((layout.q, 0), (layout.v, 1)):
                state[block][driver.coordinate] = plan.signals.at(0.0, derivative)[driver.plan.signal]
    return state


def _rest(arm: Robot, plan: Planned, held: Mapping[str, float]) -> Array:
    from tmodes.analysis.statics.rest import arm_rest

    return arm_rest(arm, model=Model(plan.chain), held=held).q


def _refuse_unknown_feedback(model: LoopModel) -> None:
    for drive in model.plan.drives:
        law = drive.servo.controller if drive.servo else None
        unknown = law.unknown(model.coordinates) if law else []
        if unknown:
            known = ", ".join(model.coordinates[:8]) + ("..." if len(model.coordinates) > 8 else "")
            which = f"controller of {drive.joint}"
            raise InputError(which, f"the unknown coordinate {unknown[0]!r}", f"one of {known}", "correct it")


def _undeformed(names: tuple[str, ...], held: Mapping[str, float]) -> Array:
    """Each joint where its motor is, nothing bent."""
    return np.array([held.get(name, held.get(f"{name}.motor", 0.0)) for name in names])


def run_trajectory(
    regime: RunSetup,
    progress: Callable[[float], None] = lambda share: None,
    journal: Journal | None = None,
    until: float | None = None,
    stops: Stops | None = None,
) -> Trajectory:
    """Integrate from the regime's start, until the first of ``stops`` sets in.

    ``until`` [s] ends the run before its duration (it is then kept in no journal); 0 gives the first sample alone.
    """
    settings, otherwise = regime.arm.integration, regime.otherwise
    motion = (regime.model, regime.model.numbers, regime.planned.schedule, regime.start)
    if until is not None and until <= 0:
        return Trajectory(np.zeros(1), regime.start[None, :], "stopped", "not begun")
    if until is not None:
        settings, journal = settings.model_copy(update={"duration": until}), None
    done = integrate(*motion, settings, progress, journal, otherwise, stops)
    later = otherwise and otherwise.finer()
    return with_error(done, settings, lambda changed: integrate(*motion, changed, otherwise=later))
