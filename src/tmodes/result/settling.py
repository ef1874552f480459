"""When the move ends, and how long after it the tip deviates from its reference; the run is continued until then."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.errors import InputError
from tmodes.integrate.registry import integrator
from tmodes.kinds.signals.schedule import MergedSchedule, Schedule, merge
from tmodes.result.summary import info_settling
from tmodes.simulation.motion_run import RunData, tip_positions
from tmodes.simulation.parts import Trajectory
from tmodes.simulation.plan import Planned
from tmodes.simulation.start import RunSetup
from tmodes.simulation.trajectory import integrate

__all__ = ["BAND", "move_end", "settling"]

Array = NDArray[np.float64]

BAND = 0.05
"""Share of the largest deviation within which the tip counts as settled."""

_HORIZON, _SHORTEST = 30.0, 1e-3
"""Longest and shortest continuation [s]."""

_DECAYS = 4.0
"""Decay times of the slowest vibration over which a run is continued."""

_SAMPLES = 6000

_LAST = 0.05
"""Share of the continuation at its end in which a deviation out of the band means that the tip has not settled."""


_STILL = 1e-9
"""Change of a signal within a piece, over its largest value, that is rounding."""

_BEYOND = 2.0
"""How far signals are looked at, as a multiple of the run's duration."""


def settling(run: RunData, move_end: float | None, band: float = BAND) -> dict[str, Any] | None:
    """Time from the end of the move [s] after which the deviation stays below ``band`` of its largest value.

    All signals keep their last value, noise ends, and the run and its reference are continued beyond their end, for
    some decay times of their slowest vibration, and longer where the tip has not settled by then, up to 30 s.
    ``time_s`` is None, with a ``reason``, where that is not enough. Only the samples are looked at where a run did not
    reach its end, where its signals change up to its end, where a Python function controls it, and where a vibration
    does not decay. None without a reference.
    """
    reference = run.reference
    if reference is None:
        return None
    count = min(len(run.times), len(reference.times))
    tips = [one.points.position[:count, 0] for one in (reference, run)]
    time, deviation = run.times[:count], np.linalg.norm(tips[1] - tips[0], axis=1)
    inside = info_settling(deviation, time, move_end, band)
    setups = [one.setup for one in (reference, run)]
    finished = reference.status == run.status == "finished"
    known = [setup for setup in setups if not setup.planned.plan.is_sampled]  # of a sampled one: with a held command
    rates = [decay for setup in known if (decay := setup.spectrum.slowest_decay) is not None]
    fixed = not any(setup.callback for setup in setups)
    if (
        move_end is None
        or move_end > time[-1] * (1 + 1e-9)
        or not finished
        or not fixed
        or min(rates, default=1.0) <= 0
    ):
        return inside
    horizon = max(min(_HORIZON, _DECAYS / min(rates, default=1.0)), _SHORTEST)
    info: dict[str, Any] = {"time_s": None, "band": band, "limit_m": inside["limit_m"], "reason": ""}
    while True:
        carried = [_continued(setup, one, horizon) for setup, one in zip(setups, (reference, run), strict=True)]
        if lost := next((done for done, _ in carried if done.status != "finished"), None):
            return info | {"reason": f"continued beyond its end, the run was lost: {lost.message}"}
        later, afterwards = carried[1][0].times, np.linalg.norm(carried[1][1] - carried[0][1], axis=1)
        times, far = np.append(time, time[-1] + later[1:]), np.append(deviation, afterwards[1:])
        info["limit_m"] = limit = band * float(far.max())
        outside = times[(far > limit) & (times > move_end)]
        if not outside.size or outside[-1] <= times[-1] - _LAST * horizon:
            return info | {"time_s": float(outside[-1] - move_end) if outside.size else 0.0}
        if horizon >= _HORIZON:
            return info | {"reason": f"the deviation is still {far[-1]:.3g} m {horizon:.3g} s after the end of the run"}
        horizon = min(2 * horizon, _HORIZON)


def _continued(setup: RunSetup, run: RunData, duration: float) -> tuple[Trajectory, Array]:
    """The run from where it ended, all signals at rest, and its tip at each sample (n, 3) [m]."""
    setup, state = at_rest_from(setup, float(run.times[-1]), run.states[-1], duration)
    settings = setup.robot.integration.model_copy(update={"duration": duration, "output_step": duration / _SAMPLES})
    if not integrator(settings.method).adaptive:
        settings = settings.chosen("dormand_prince")
    later = setup.otherwise and setup.otherwise.model_copy(update={"duration": duration})
    schedule = setup.planned.schedule
    done = integrate(setup.model, setup.model.numbers, schedule, state, settings, otherwise=later)
    if done.status == "interrupted":
        raise KeyboardInterrupt
    return done, tip_positions(setup, done.times, done.states)


def at_rest_from(setup: RunSetup, time: float, state: Array, duration: float) -> tuple[RunSetup, Array]:
    """The same robot with all signals at their values at a time [s], and the state from which it continues."""
    plan, layout = setup.planned, setup.model.layout
    values = plan.signals.at(time)
    values[[drive.noise for drive in plan.plan.drives if drive.noise >= 0]] = 0.0
    knots, clocks = np.array([0.0, duration]), {drive.clock for drive in plan.plan.drives}
    still = np.zeros((len(values), 1, plan.signals.degree + 1))
    still[:, 0, 0] = values
    each = [plan.each[k].schedule(duration) if k in clocks else Schedule(knots, still[k]) for k in range(len(values))]
    signals = merge(each) if each else plan.signals
    kept = state.copy()
    for driver in setup.model.loop.drivers:
        if driver.plan.servo is None:
            kept[layout.q][driver.coordinate] = values[driver.plan.signal]
            kept[layout.v][driver.coordinate] = 0.0
    rows = signals.coefficients.reshape(len(signals.coefficients), -1)
    planned = replace(plan, schedule=Schedule(signals.knots, rows), signals=signals)
    return replace(setup, planned=planned, start=kept), kept


def move_end(planned: Planned) -> float | None:
    """When the last signal of a drive, a load or the base stops changing [s]; None where one never does.

    Signals are looked at beyond the end of the run, so that a move that ends there is known to end; noise on what a
    controller receives is no move.
    """
    own = [k for k in range(len(planned.each)) if k not in planned.plan.aside]
    if not own:
        return 0.0
    until = float(planned.signals.knots[-1])
    try:
        longer = merge([planned.each[k].schedule(_BEYOND * until) for k in own])
    except InputError:  # a signal without a value there
        longer = MergedSchedule(planned.signals.knots, planned.signals.coefficients[:, own])
    return _last_change(longer)


def _last_change(signals: MergedSchedule) -> float | None:
    """When signals stop changing [s]; None where that is not before their end."""
    knots, powers = signals.knots, np.array(signals.coefficients)
    size = np.abs(powers[:, :, :1]).max(axis=0, keepdims=True, initial=0.0)
    lengths = np.diff(knots)[:, None, None] ** np.arange(powers.shape[2])
    changes = np.abs(powers * lengths)[:, :, 1:].max(axis=2, initial=0.0) > _STILL * np.maximum(size[..., 0], 1e-12)
    jumps = np.zeros_like(changes)
    jumps[1:] = np.abs(np.diff(signals.at(knots[:-1]), axis=0)) > _STILL * np.maximum(size[0, :, 0], 1e-12)
    moving = np.flatnonzero((changes | jumps).any(axis=1))
    if not len(moving):
        return 0.0
    last = int(moving[-1])
    end = float(knots[last + 1] if changes[last].any() else knots[last])
    return end if end < knots[-1] * (1 - 1e-9) else None
