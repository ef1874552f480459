"""Settling: how long after the move the tip still strays from its reference. The run is continued until it is known."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.integrate.registry import integrator
from tmodes.kinds.signals.schedule import Schedule
from tmodes.paper.mechanism import Drive
from tmodes.paper.modes import closed_loop_spectrum
from tmodes.paper.regime import PaperRun
from tmodes.simulation.trajectory import integrate

__all__ = ["BAND", "settling"]

BAND = 0.05
"""Share of the largest deviation within which the tip counts as settled."""

_HORIZON = 30.0
_DECAYS = 4.0
_SAMPLES = 6000


def settling(reference: PaperRun, real: PaperRun) -> dict[str, Any]:
    """Time from the end of the move [s] after which the deviation stays below ``BAND`` of its largest value.

    Both regimes rest their motors' wanted angle where the move ended and are run on, beyond the end of the result, for
    some decay times of their slowest vibration. ``time_s`` is None, with a ``reason``, where that is not enough.
    """
    time, deviation = _deviation(reference, real)
    end = real.robot.reference.duration
    info: dict[str, Any] = {"time_s": None, "band": BAND, "limit_m": BAND * float(deviation.max()), "reason": ""}
    if time[-1] < end * (1 - 1e-9):
        info["reason"] = f"the run ends before the move does, at {end:g} s: simulate longer"
        return info
    horizon = min(_HORIZON, _DECAYS / _slowest_decay(reference, real))
    carried = [_carried_on(regime, horizon) for regime in (reference, real)]
    later, afterwards = _deviation(*carried)
    time, deviation = np.append(time, time[-1] + later[1:]), np.append(deviation, afterwards[1:])
    limit = info["limit_m"] = BAND * float(deviation.max())
    if lost := next((regime for regime in carried if regime.trajectory.status != "finished"), None):
        info["reason"] = f"continued beyond its end, the run did not come far: {lost.trajectory.message}"
        return info
    outside = time[(deviation > limit) & (time > end)]
    if outside.size and outside[-1] > time[-1] - 0.05 * horizon:
        info["reason"] = f"the deviation is still {deviation[-1]:.3g} m {horizon:.3g} s after the end of the run"
    else:
        info["time_s"] = float(outside[-1] - end) if outside.size else 0.0
    return info


def _slowest_decay(*regimes: PaperRun) -> float:
    """Smallest decay rate [1/s] of the vibrations about rest."""
    spectra = (closed_loop_spectrum(one.robot, drive=one.model.mechanism.drive) for one in regimes)
    return max(min((-value.real for spectrum in spectra for value in spectrum.ringing), default=1.0), 1e-9)


def _carried_on(regime: PaperRun, duration: float) -> PaperRun:
    """The regime from where it ended, its wanted motor angle at rest."""
    robot, last = regime.robot, regime.trajectory
    degree = regime.model.mechanism.reference_degree
    still = np.zeros((1, degree + 1))
    still[0, 0] = robot.reference.end
    schedule = Schedule(np.array([0.0, duration]), still)
    state = last.states[-1].copy()
    if regime.model.mechanism.drive is Drive.PRESCRIBED:
        state[5], state[11] = robot.reference.end, 0.0
    settings = robot.integration.model_copy(update={"duration": duration, "output_step": duration / _SAMPLES})
    if not integrator(settings.method).adaptive:
        settings = settings.chosen("dormand_prince")
    trajectory = integrate(regime.model, regime.parameters, schedule, state, settings)
    if trajectory.status == "interrupted":
        raise KeyboardInterrupt
    rows = schedule.rows_at(trajectory.times)
    return PaperRun(robot, regime.model, regime.parameters, rows, trajectory)


def _deviation(reference: PaperRun, real: PaperRun) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Times [s] and distance of the two tips [m]."""
    count = min(len(reference.trajectory.times), len(real.trajectory.times))
    tips = [regime.observed(count)["tip"] for regime in (reference, real)]
    return real.trajectory.times[:count], np.linalg.norm(tips[1] - tips[0], axis=1)
