"""When the move ends, how long the tip then takes to come to its own rest, and how it vibrates until then."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.vibration import (
    AT_REST,
    FEWEST,
    STANDS,
    Residual,
    are_coarse,
    farthest,
    residual_vibration,
    settled_after,
)
from tmodes.errors import InputError
from tmodes.integrate.conditions import BAND, Band
from tmodes.integrate.registry import integrator
from tmodes.io.printed import written
from tmodes.kinds.signals.schedule import MergedSchedule, SignalPieces, merge

if TYPE_CHECKING:
    from tmodes.simulation.initial_state import RunSetup
    from tmodes.simulation.motion_run import RunData
    from tmodes.simulation.parts import Trajectory
    from tmodes.simulation.plan import Planned

__all__ = [
    "AfterMove", "after_move", "continuing", "move_end", "not_settled", "plain_vibration", "settling",
    "unknown_vibration", "vibration",
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

_CREEPS = 0.9
"""Ratio of two changes, one fifth of that time apart, up to which a motion creeps to a rest that is known by them."""

_UNREST = "a motion that does not decay, or a run that is too short"
_LONGER = ": simulate longer to see it settle"
"""What helps where a run that reached its end ends before its move."""

_COSTLY = "the run was continued by half of its steps; simulate longer to see it settle"

_AT_REST = 1e-4
"""Share of the largest distance from its end, after the move, within which the tip no longer shows its vibration."""

_STILL = 1e-9
"""Change of a signal within a piece, over its largest value, that is rounding."""

_BEYOND = 2.0
"""How far signals are looked at, as a multiple of the run's duration."""


@dataclass(frozen=True, eq=False)
class AfterMove:
    """A run and its continuation with all signals at rest: its tip at ``times``, and coordinates ``q`` (n, nq).

    ``tip`` (n, 3) [m] and ``rates`` (n, 3) [m/s]; ``end``: of the move [s], None where it has none; ``finished`` [s]:
    where the run itself ends; ``even``: samples at equal times, in which vibrations are looked for; ``cut``: what ended
    the continuation before all was seen; ``whose``: motion ``tip`` is; ``unrest``: what keeps it from its rest, in
    words, and whether that is no vibration; ``longer``: what helps where the run ends before the move.
    """

    times: Array
    tip: Array
    rates: Array
    q: Array
    end: float | None
    finished: float
    even: NDArray[np.intp]
    cut: str = ""
    whose: str = "the tip"
    unrest: tuple[str, bool] = "", False
    longer: str = _LONGER

    @property
    def beyond(self) -> dict[str, Any]:
        """Time [s] that was looked at after the end of the run, and what ended that."""
        return {"continued_s": float(self.times[-1]) - self.finished, "cut": self.cut}

    def settling(self, band: Band = USUAL) -> dict[str, Any]:
        """When the tip stays near its own rest, see :func:`settling`; and how far the run was continued for it."""
        (found, alone), cut = self.unrest, self.cut
        words = self.whose, (found if alone or not cut else cut) or _UNREST, self.longer
        return settling(self.times, self.tip, self.rates, self.end, self.finished, band, *words) | self.beyond

    def vibration(self) -> Residual:
        """The vibration at the end of the move, about the slowly moving mean."""
        own = self.times[self.even], self.tip[self.even], self.end
        found = Residual(None) if self.unrest[1] else vibration(*own)
        return found._replace(reason=self.unrest[0]) if self.unrest[0] and not found.modes else found

    def later(self) -> tuple[Array, Array]:
        """Times after the end of the move [s], and the coordinates then."""
        kept = self.even[self.times[self.even] >= (self.end or 0.0) * (1 - 1e-12)]
        return self.times[kept] - (self.end or 0.0), self.q[kept]

    def joined(self, sample: int, motion: Sequence[Array], stride: int | None = None) -> AfterMove:
        """With another motion (times, tip, its rates, coordinates) in the place of its samples after one.

        ``stride``: how many of its steps are one of that motion, for which they are evenly spaced; None: none are.
        """
        last = int(np.searchsorted(self.times, motion[0][-1] * (1 + 1e-12)))
        pairs = zip((self.times, self.tip, self.rates, self.q), motion, strict=True)
        times, tip, rates, q = (np.concatenate([own[: sample + 1], one[1:], own[last:]]) for own, one in pairs)
        own = np.arange(sample % stride, sample, stride) if stride else np.arange(0)
        even = np.append(own, sample + np.arange(len(motion[0])))
        return AfterMove(times, tip, rates, q, self.end, self.finished, even)


def settling(
    times: Array,
    tip: Array,
    rates: Array | None,
    end: float | None,
    finished: float,
    band: Band = USUAL,
    whose: str = "the tip",
    unrest: str = _UNREST,
    longer: str = _LONGER,
) -> dict[str, Any]:
    """Time from the end of the move after which the actual tip stays within ``limit_m`` of its own rest.

    Its rest is where it ends: its mean over the last fifth of the time after the move, in which it must not be farther
    away than a share of the band, and what creeping adds to that. ``limit_m`` is the ``band``, of ``move_m``, its
    farthest distance from rest in the run. Between samples the tip moves by cubics of its positions and ``rates``.
    ``time_s`` is None, with a ``reason``, where the tip is not seen to come to rest, and stay there; ``whose`` motion
    it is, what keeps it from its rest (``unrest``), and what helps (``longer``), are words of it. Where nothing moves
    that is the reason, too.
    """
    (rest, spread), run = _rest(times, tip, end), times <= finished * (1 + 1e-9)
    move = farthest(times[run], tip[run], rates if rates is None else rates[run], rest)
    limit = max(band.limit(move), _NO_MOVE)
    info = not_settled("", band) | {"limit_m": limit, "move_m": move}
    if end is None:
        return info | {"reason": "what moves the robot changes up to the end of the run"}
    if times[-1] <= end * (1 + 1e-9):
        when = f"the run ends at {times[-1]:g} s, the move at {end:g} s"
        return info | {"reason": f"{when}{longer}"}
    if move <= STANDS * np.abs(tip).max():
        return info | {"time_s": 0.0, "rest_m": rest.tolist(), "reason": AT_REST}
    if spread > _STEADY * limit:
        size = written(2 * spread, "m", 3)
        return info | {"reason": f"{whose} still moves by {size} at t = {times[-1]:.4g} s: {unrest}"}
    return info | {"time_s": settled_after(times, tip, rest, limit, end, rates), "rest_m": rest.tolist()}


def _rest(times: Array, tip: Array, end: float | None) -> tuple[Array, float]:
    """Where a tip comes to rest: its smooth mean over the last fifth, and what creeping adds; its distance then."""
    length = _LAST * max(float(times[-1]) - (end or 0.0), 0.0)
    steps, means = np.gradient(times) if len(times) > 1 else np.ones(1), []
    for back in (2, 1, 0):
        share = (times - times[-1]) / (length or 1.0) + back + 1
        weight = np.where((share >= 0) & (share <= 1), np.sin(np.pi * share) ** 2, 0.0) * steps
        means.append(weight @ tip / weight.sum() if weight.sum() > 0 else tip[-1])
    before, last = means[1] - means[0], means[2] - means[1]
    ratio = float(last @ before) / (float(before @ before) or 1.0)
    rest = means[2] + (last * ratio / (1 - ratio) if 0 < ratio < _CREEPS else 0.0)
    return rest, float(np.linalg.norm(tip[times >= times[-1] - length] - rest, axis=1).max())


def not_settled(reason: str, band: Band = USUAL) -> dict[str, Any]:
    """What stands in the place of the settling where there is none."""
    return {"time_s": None, "band": band.share, "within": band.words, "limit_m": None, "move_m": None, "reason": reason}


def vibration(times: Array, tip: Array, end: float | None) -> Residual:
    """The vibration of evenly spaced samples after the move, as far as the tip moves at all."""
    if end is None:
        return Residual(None, (), "what moves the robot changes up to the end of the run")
    later = slice(np.searchsorted(times, end * (1 - 1e-12)), _last_even(times, end) + 1)
    times, tip = times[later], tip[later]
    if len(times) < FEWEST:
        return Residual(None, (), "the run ends with the move")
    far = np.linalg.norm(tip - tip[-1], axis=1)
    moving = np.flatnonzero(far > _AT_REST * far.max())
    kept = max(int(moving[-1]) + 1 if len(moving) else 0, 4 * FEWEST)
    return residual_vibration(times[:kept], tip[:kept], end)


def unknown_vibration(reason: str) -> dict[str, Any]:
    """What stands in the place of a residual vibration where there is none."""
    return plain_vibration(Residual(None, (), reason))


def plain_vibration(
    found: Residual, elements: Sequence[str] = (), beyond: Mapping[str, Any] | None = None
) -> dict[str, Any]:
    """The same as plain data, SI units; ``elements``: of each mode, ``beyond``: of :class:`AfterMove`."""
    modes = [
        {"frequency_Hz": mode.frequency_Hz / np.sqrt(1 - mode.damping_ratio**2),
         "damped_frequency_Hz": mode.frequency_Hz, "damping_ratio": mode.damping_ratio, "amplitude_m": mode.amplitude,
         "share": mode.share, "drift_Hz": mode.drift and [*mode.drift]}
        | ({"element": elements[k]} if elements else {}) for k, mode in enumerate(found.modes)
    ]  # fmt: skip
    known = found.amplitude is not None
    plain = {
        "amplitude_m": found.amplitude, "modes": modes, "reason": found.reason,
        "largest_m": found.largest if known else None, "time_of_largest_s": found.time if known else None,
        "along_m": dict(zip("xyz", found.along, strict=False)), "unexplained": found.unexplained,
    } | dict(beyond or {})  # fmt: skip
    return _rounded(plain)


def _rounded(value: Any) -> Any:
    """Plain data with numbers of ten digits: the last ones of a fit depend on how many threads add it up."""
    if isinstance(value, dict):
        return {key: _rounded(one) for key, one in value.items()}
    if isinstance(value, list):
        return [_rounded(one) for one in value]
    return float(f"{value:.10g}") if isinstance(value, float) else value


def after_move(run: RunData, end: float | None, progress: Callable[[float], None] = lambda share: None) -> AfterMove:
    """A run and its continuation until its tip is at rest: some decay times of its slowest motion, up to 30 s.

    All signals keep their last value, noise ends. Only the samples are looked at where a run did not reach its end,
    where its signals change up to its end, where a Python function controls it, and where a vibration does not decay.
    Where samples are too far apart for its motion, it is integrated once more from the end of the move on. Both go on
    by the method by which the run ended, and take at most half of its own steps, or about a second of computing; what
    ends then is kept up to an even time, so that a page sees as much. ``progress`` is given the share that is done.
    Raises KeyboardInterrupt where it is interrupted.
    """
    setup, decays = run.setup, _decays(run)
    motion, last = (run.points.position[:, 0], run.points.velocity[:, 0], run.q), len(run.times)
    longer = _LONGER if run.status == "finished" else ""
    found = AfterMove(run.times, *motion, end, float(run.times[-1]), np.arange(last), longer=longer)
    stops = end is not None and end <= run.times[-1] * (1 + 1e-9)
    if end is None or not stops or run.status != "finished" or setup.callback:
        return found
    own = run.statistics.get("steps", 0) + run.statistics.get("rejected", 0)
    more = _Continued(run, end, max(int(_MOST_WORK * own), _NEGLIGIBLE // max(len(run.coordinates), 1)), progress)
    if min(decays, default=1.0) > 0:
        found = more.beyond(found, max(min(_HORIZON, _DECAYS / min(decays, default=1.0)), _SHORTEST))
    return more.finer(found)


class _Continued:
    """A run whose move is over at ``end`` [s], and how many steps may be taken ``left`` to see what follows."""

    def __init__(self, run: RunData, end: float, left: int, progress: Callable[[float], None]) -> None:
        self.run, self.end, self.left, self.progress = run, end, left, progress
        self.band = Band.parsed(run.robot.integration.settling_band)

    def beyond(self, alone: AfterMove, horizon: float) -> AfterMove:
        """With what follows its last sample, for ``horizon`` [s] or up to the longest where it is not at rest then."""
        last, best = _last_even(self.run.times, self.end), alone
        while True:
            stride = max(1, int(np.ceil(horizon / _SAMPLES / self.run.robot.integration.output_step)))
            done, *motion = self._from(last, horizon, stride * self.run.robot.integration.output_step)
            found = alone.joined(last, motion, stride)
            best = found if found.times[-1] >= best.times[-1] else best
            if done.status == "stopped" or self.left <= 0:
                return replace(best, cut=_COSTLY)
            if done.status != "finished":
                return replace(alone, cut=f"continued beyond its end, the run was lost: {done.message}")
            if horizon >= _HORIZON or found.settling(self.band)["time_s"] is not None:
                return found
            horizon = min(2 * horizon, _HORIZON)

    def finer(self, found: AfterMove) -> AfterMove:
        """With samples as near as the steps of the integration, where its own are too far apart after the move."""
        run, first = self.run, int(np.searchsorted(self.run.times[:-1], self.end * (1 - 1e-12)))
        step = _evened(run.statistics.get("mean_step_s") or np.inf)
        span = min(float(found.times[-1] - run.times[first]), _SAMPLES * step)
        later = found.times >= run.times[first]
        rest, limit = _rest(found.times, found.tip, self.end)[0], found.settling(self.band)["limit_m"]
        fine = step >= run.robot.integration.output_step or not are_coarse(
            found.times[later], found.tip[later], found.rates[later], rest, limit
        )
        if fine or min(span, self.left) <= 0 or run.planned.noises:
            return found
        done, *motion = self._from(first, span, span / np.ceil(span / step))
        seen = found.joined(first, motion) if len(motion[0]) > FEWEST else found
        return replace(seen, cut=found.cut) if done.status in ("finished", "stopped") else found

    def _from(self, sample: int, duration: float, step: float) -> tuple[Trajectory, Array, Array, Array, Array]:
        """The run from a sample on, all signals at rest: its times [s], its tip and the rates of that, coordinates."""
        from tmodes.simulation.motion_run import tip_motion
        from tmodes.simulation.solve import solve

        begin = float(self.run.times[sample])
        setup, state = at_rest_from(self.run.setup, begin, self.run.states[sample], duration)
        some = {"duration": duration, "max_steps": self.left}
        method = self.run.statistics.get("method", setup.robot.integration.method)
        settings = setup.robot.integration.chosen(continuing(method))
        settings = settings.model_copy(update=some | {"output_step": step})
        done = solve(replace(setup, start=state, otherwise=None).problem(settings), progress=self.progress)
        if done.status == "interrupted":
            raise KeyboardInterrupt
        self.left -= done.statistics["steps"] + done.statistics["rejected"]
        if done.status == "stopped":
            kept = done.times <= _evened(done.times[-1]) * (1 + 1e-9)
            done = replace(done, times=done.times[kept], states=done.states[kept])
        motion = tip_motion(setup, done.times, done.states)
        return done, begin + done.times, *motion, done.states[:, setup.model.layout.q]


def continuing(method: str) -> str:
    """The method by which a run is continued: its own where that chooses its steps."""
    return method if integrator(method).adaptive else "dormand_prince"


def _evened(time: float) -> float:
    """A time [s] rounded down to halves of a power of ten, the same where rounding decides on some of many steps."""
    half = 10.0 ** np.floor(np.log10(time)) / 2 if 0 < time < np.inf else 1.0
    return float(half * np.floor(time / half * (1 + 1e-12)))


def _last_even(times: Array, end: float) -> int:
    """The last sample, or the one before where the last follows a shorter step and the move has ended by then."""
    last = len(times) - 1
    shorter = last > 1 and times[last] - times[last - 1] < (1 - 1e-6) * (times[1] - times[0])
    return last - 1 if shorter and times[last - 1] >= end else last


def _decays(run: RunData) -> list[float]:
    """Decay rates of the motions about the start that ring, or creep within the longest continuation [1/s]."""
    spectrum = run.setup.spectrum
    if run.planned.plan.is_sampled or spectrum.slowest_decay is None:  # of a sampled one: with a held command
        return []
    creeping = -spectrum.eigenvalues.real[spectrum.eigenvalues.real < -_DECAYS / _HORIZON]
    return [spectrum.slowest_decay, *map(float, creeping)]


def at_rest_from(setup: RunSetup, time: float, state: Array, duration: float) -> tuple[RunSetup, Array]:
    """The same robot with all signals at their values at a time [s], and the state from which it continues."""
    plan, layout = setup.planned, setup.model.layout
    values = plan.signals.at(time)
    values[plan.noises] = 0.0
    knots, clocks = np.array([0.0, duration]), {k for k, _ in plan.clocks}
    still = np.zeros((len(values), 1, plan.signals.degree + 1))
    still[:, 0, 0] = values
    each = [
        one.schedule(time + duration).since(time) if k in clocks else SignalPieces(knots, still[k])
        for k, one in enumerate(plan.each)
    ]
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

    Signals are looked at beyond the end of the run and of their moves, so that a move that ends there, or later, is
    known to end; noise on what a controller receives is no move.
    """
    own = [k for k in range(len(planned.each)) if k not in planned.plan.aside]
    if not own:
        return 0.0
    ends = [planned.each[k].move_ends(_BEYOND) for k in own]
    until = max([float(planned.signals.knots[-1]), *(float(end) for end in ends if end is not None)])
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
