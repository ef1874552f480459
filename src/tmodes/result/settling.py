"""When the move ends, how long the tip then takes to come to its own rest, and how it vibrates until then."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.vibration import FEWEST, Residual, residual_vibration, settled_after
from tmodes.errors import InputError
from tmodes.integrate.band import BAND, Band
from tmodes.integrate.registry import integrator
from tmodes.kinds.signals.schedule import MergedSchedule, Schedule, merge

if TYPE_CHECKING:
    from tmodes.simulation.motion_run import RunData
    from tmodes.simulation.parts import Trajectory
    from tmodes.simulation.plan import Planned
    from tmodes.simulation.start import RunSetup

__all__ = [
    "AfterMove", "after_move", "move_end", "not_settled", "plain_vibration", "settling", "unknown_vibration",
    "vibration",
]  # fmt: skip

Array = NDArray[np.float64]

USUAL = Band(BAND)
"""The band of who names none."""

_NO_MOVE = 1e-9
"""Least band [m]: a tip that does not move is at rest."""

_HORIZON, _SHORTEST = 30.0, 1e-3
"""Longest and shortest continuation [s]."""

_DECAYS = 6.0
"""Decay times of the slowest motion over which a run is continued."""

_SAMPLES = 20_000

_MOST_WORK = 0.5
"""Steps of a continuation over those of the run itself, at most."""

_NEGLIGIBLE = 100_000
"""Steps times coordinates that a continuation may always take: about a second of computing."""

_LAST, _STEADY = 0.2, 0.5
"""Share of the time after the move, at its end, in which the tip must stay within this share of the band."""

_AT_REST = 1e-4
"""Share of the largest distance from its end, after the move, within which the tip no longer shows its vibration."""

_STILL = 1e-9
"""Change of a signal within a piece, over its largest value, that is rounding."""

_BEYOND = 2.0
"""How far signals are looked at, as a multiple of the run's duration."""


@dataclass(frozen=True, eq=False)
class AfterMove:
    """A run and its continuation with all signals at rest: its tip (n, 3) [m] and coordinates (n, nq) at ``times``.

    ``end``: of the move [s], None where it has none; ``finished`` [s]: where the run itself ends; ``join``: its sample
    from which it is continued, from there on at every ``stride``-th step; ``cut``: what ended the continuation before
    all was seen.
    """

    times: Array
    tip: Array
    q: Array
    end: float | None
    finished: float
    join: int
    stride: int = 1
    cut: str = ""

    @property
    def beyond(self) -> dict[str, Any]:
        """Time [s] that was looked at after the end of the run, and what ended that."""
        return {"continued_s": float(self.times[-1]) - self.finished, "cut": self.cut}

    def settling(self, band: Band = USUAL) -> dict[str, Any]:
        """When the tip stays near its own rest, see :func:`settling`; and how far the run was continued for it."""
        return settling(self.times, self.tip, self.end, self.finished, band) | self.beyond

    @property
    def _even(self) -> NDArray[np.intp]:
        """Samples at equal times, those of the continuation among them."""
        own = np.arange(self.join % self.stride, self.join, self.stride)
        return np.concatenate([own, np.arange(self.join, len(self.times))])

    def vibration(self) -> Residual:
        """The vibration at the end of the move, about the slowly moving mean."""
        return vibration(self.times[self._even], self.tip[self._even], self.end)

    def later(self) -> tuple[Array, Array]:
        """Times after the end of the move [s], and the coordinates then."""
        end = self.end or 0.0
        kept = self._even[self.times[self._even] >= end * (1 - 1e-12)]
        return self.times[kept] - end, self.q[kept]


def settling(times: Array, tip: Array, end: float | None, finished: float, band: Band = USUAL) -> dict[str, Any]:
    """Time from the end of the move after which the actual tip stays within ``limit_m`` of its own rest.

    Its rest is where it is in the end: the mean of the last fifth of the samples, in which it must not move by more
    than a share of the band. ``limit_m`` is the ``band``, of ``move_m``, its farthest distance from rest in the run.
    ``time_s`` is None, with a ``reason``, where the tip is not seen to come to rest, and stay there.
    """
    last = tip[times >= times[-1] - _LAST * max(times[-1] - (end or 0.0), 0.0)]
    rest = last.mean(axis=0)
    far, spread = (np.linalg.norm(part - rest, axis=1) for part in (tip[times <= finished * (1 + 1e-9)], last))
    limit = max(band.limit(float(far.max())), _NO_MOVE)
    info = not_settled("", band) | {"limit_m": limit, "move_m": float(far.max())}
    if end is None:
        return info | {"reason": "what moves the robot changes up to the end of the run"}
    if times[-1] <= end * (1 + 1e-9):
        when = f"the run ends at {times[-1]:g} s, the move at {end:g} s"
        return info | {"reason": f"{when}: simulate longer to see it settle"}
    if spread.max() > _STEADY * limit:
        seen = f"the tip still moves by {2 * spread.max():.3g} m before t = {times[-1]:.4g} s"
        return info | {"reason": f"{seen}: a vibration that does not decay, or a run that is too short"}
    return info | {"time_s": settled_after(times, tip, rest, limit, end), "rest_m": rest.tolist()}


def not_settled(reason: str, band: Band = USUAL) -> dict[str, Any]:
    """What stands in the place of the settling where there is none."""
    return {"time_s": None, "band": band.share, "within": band.words, "limit_m": None, "move_m": None, "reason": reason}


def unknown_vibration(reason: str) -> dict[str, Any]:
    """What stands in the place of a residual vibration where there is none."""
    return plain_vibration(Residual(None, (), reason))


def vibration(times: Array, tip: Array, end: float | None) -> Residual:
    """The vibration of evenly spaced samples after the move, as far as the tip moves at all."""
    if end is None:
        return Residual(None, (), "what moves the robot changes up to the end of the run")
    later = times >= end * (1 - 1e-12)
    times, tip = times[later], tip[later]
    if len(times) < FEWEST:
        return Residual(None, (), "the run ends with the move")
    uneven = np.flatnonzero(np.abs(np.diff(times) / (times[1] - times[0]) - 1) > 1e-6)
    count = int(uneven[0]) + 1 if len(uneven) else len(times)
    far = np.linalg.norm(tip[:count] - tip[count - 1], axis=1)
    moving = np.flatnonzero(far > _AT_REST * far.max())
    kept = max(int(moving[-1]) + 1 if len(moving) else 0, 4 * FEWEST)
    return residual_vibration(times[:count][:kept], tip[:count][:kept], end)


def plain_vibration(
    found: Residual, elements: Sequence[str] = (), beyond: Mapping[str, Any] | None = None
) -> dict[str, Any]:
    """The same as plain data, SI units; ``elements``: of each mode, ``beyond``: of :class:`AfterMove`."""
    modes = [
        {"frequency_Hz": mode.frequency_Hz, "damping_ratio": mode.damping_ratio, "amplitude_m": mode.amplitude,
         "share": mode.share, "drift_Hz": mode.drift and [*mode.drift]}
        | ({"element": elements[k]} if elements else {}) for k, mode in enumerate(found.modes)
    ]  # fmt: skip
    known = found.amplitude is not None
    return {
        "amplitude_m": found.amplitude, "modes": modes, "reason": found.reason,
        "largest_m": found.largest if known else None, "time_of_largest_s": found.time if known else None,
        "along_m": dict(zip("xyz", found.along, strict=False)), "unexplained": found.unexplained,
    } | dict(beyond or {})  # fmt: skip


def after_move(run: RunData, end: float | None, progress: Callable[[float], None] = lambda share: None) -> AfterMove:
    """A run and its continuation until its tip is at rest: some decay times of its slowest motion, up to 30 s.

    All signals keep their last value, noise ends. Only the samples are looked at where a run did not reach its end,
    where its signals change up to its end, where a Python function controls it, and where a vibration does not decay.
    The continuation takes at most half of the steps of the run itself, or about a second of computing; ``progress`` is
    given the share that is done. Raises KeyboardInterrupt where it is interrupted.
    """
    times, tip, last = run.times, run.points.position[:, 0], len(run.times) - 1
    setup, decays = run.setup, _decays(run)
    alone = AfterMove(times, tip, run.q, end, float(times[-1]), last)
    stops = end is not None and end <= times[-1] * (1 + 1e-9)
    if end is None or not stops or run.status != "finished" or setup.callback or min(decays, default=1.0) <= 0:
        return alone
    last = _last_even(times, end)
    band = Band.parsed(setup.robot.integration.settling_band)
    horizon, left, best = max(min(_HORIZON, _DECAYS / min(decays, default=1.0)), _SHORTEST), _work(run), alone
    while True:
        done, tips, stride = _continued(setup, run, last, horizon, left, progress)
        later = done.states[1:, setup.model.layout.q]
        found = replace(
            alone, times=np.append(times[: last + 1], times[last] + done.times[1:]), join=last, stride=stride,
            tip=np.concatenate([tip[: last + 1], tips[1:]]), q=np.concatenate([run.q[: last + 1], later]),
        )  # fmt: skip
        best = found if found.times[-1] >= best.times[-1] else best
        left -= done.statistics["steps"] + done.statistics["rejected"]
        if done.status == "stopped" or left <= 0:
            return replace(best, cut=f"not looked at beyond t = {best.times[-1]:.4g} s: half of the run's own steps")
        if done.status != "finished":
            return replace(alone, cut=f"continued beyond its end, the run was lost: {done.message}")
        if horizon >= _HORIZON or found.settling(band)["time_s"] is not None:
            return found
        horizon = min(2 * horizon, _HORIZON)


def _last_even(times: Array, end: float) -> int:
    """The last sample, or the one before where the last follows a shorter step and the move has ended by then."""
    last = len(times) - 1
    shorter = last > 1 and times[last] - times[last - 1] < (1 - 1e-6) * (times[1] - times[0])
    return last - 1 if shorter and times[last - 1] >= end else last


def _work(run: RunData) -> int:
    """Steps that a continuation may take."""
    own = run.statistics.get("steps", 0) + run.statistics.get("rejected", 0)
    return max(int(_MOST_WORK * own), _NEGLIGIBLE // max(len(run.coordinates), 1))


def _decays(run: RunData) -> list[float]:
    """Decay rates of the motions about the start that ring, or creep within the longest continuation [1/s]."""
    spectrum = run.setup.spectrum
    if run.planned.plan.is_sampled or spectrum.slowest_decay is None:  # of a sampled one: with a held command
        return []
    creeping = -spectrum.eigenvalues.real[spectrum.eigenvalues.real < -_DECAYS / _HORIZON]
    return [spectrum.slowest_decay, *map(float, creeping)]


def _continued(
    setup: RunSetup, run: RunData, sample: int, duration: float, steps: int, progress: Callable[[float], None]
) -> tuple[Trajectory, Array, int]:
    """The run from a sample on, all signals at rest, its tip at each sample (n, 3) [m], and how far these are apart."""
    from tmodes.simulation.motion_run import tip_positions
    from tmodes.simulation.trajectory import integrate

    setup, state = at_rest_from(setup, float(run.times[sample]), run.states[sample], duration)
    given = setup.robot.integration
    stride = max(1, int(np.ceil(duration / _SAMPLES / given.output_step)))
    settings = given.model_copy(
        update={"duration": duration, "output_step": stride * given.output_step, "max_steps": steps}
    )
    if not integrator(settings.method).adaptive:
        settings = settings.chosen("dormand_prince")
    later = setup.otherwise and setup.otherwise.model_copy(update={"duration": duration, "max_steps": steps})
    schedule = setup.planned.schedule
    done = integrate(setup.model, setup.model.numbers, schedule, state, settings, progress, otherwise=later)
    if done.status == "interrupted":
        raise KeyboardInterrupt
    return done, tip_positions(setup, done.times, done.states), stride


def at_rest_from(setup: RunSetup, time: float, state: Array, duration: float) -> tuple[RunSetup, Array]:
    """The same robot with all signals at their values at a time [s], and the state from which it continues."""
    plan, layout = setup.planned, setup.model.layout
    values = plan.signals.at(time)
    values[[drive.noise for drive in plan.plan.drives if drive.noise >= 0]] = 0.0
    knots, clocks = np.array([0.0, duration]), {drive.clock for drive in plan.plan.drives}
    still = np.zeros((len(values), 1, plan.signals.degree + 1))
    still[:, 0, 0] = values
    each = [plan.each[k].schedule(duration) if k in clocks else Schedule(knots, still[k]) for k in range(len(values))]
    signals = merge(each) if each else MergedSchedule(knots, still.transpose(1, 0, 2))
    kept = state.copy()
    for driver in setup.model.loop.drivers:
        if driver.plan.servo is None:
            kept[layout.q][driver.coordinate] = values[driver.plan.signal]
            kept[layout.v][driver.coordinate] = 0.0
    planned = replace(plan, schedule=signals.schedule, signals=signals)
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
