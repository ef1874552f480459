"""The test move of the ladder: motors follow it exactly, and every rung is integrated to far below its tolerance.

The integrator is the linearly implicit Euler step of the recursion, extrapolated (Deuflhard, SIAM Review 27, 1985): no
step is bound by the fastest motion of a link, so all rungs take about the same number.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.analysis.hierarchy.variants import driven, input_mix, whole_chain
from tmodes.analysis.statics.equilibrium import first_value
from tmodes.errors import SimulationError
from tmodes.kinds.signals.registry import MergedSchedule, constant_signal, merge, quintic_move
from tmodes.model.model import Model
from tmodes.sheet import Robot

__all__ = ["Move", "chosen_move", "followed"]

Array = NDArray[np.float64]

AMPLITUDE = 0.2
"""Travel [rad, m] of each joint where the robot has no drives of its own."""

_SHORTEST, _LONGEST = 0.5, 5.0
"""Duration of that move [s]: at least, at most."""

_SAMPLES = 100
"""Samples of a move, next to the knots of its signals."""

_ORDER = 5
"""Order of the extrapolation: 1 to 5 steps in each column."""

_MOST_STEPS = 20_000

_SAME = 1e-6
"""A jump smaller than this share of the largest value is rounding."""


@dataclass(frozen=True, eq=False)
class Move:
    """Signals of the motors over ``times`` (n,) [s], and in words; ``mix``: gear inputs over motors."""

    signals: MergedSchedule
    times: Array
    words: str
    mix: Array

    def at(self, time: ArrayLike, derivative: int = 0) -> Array:
        """Gear inputs [rad, m], or their derivatives, (*times, joints)."""
        return self.signals.at(time, derivative) @ self.mix.T


def chosen_move(robot: Robot, lowest_frequency: float) -> Move:
    """The robot's own drives where they are smooth; else 0.2 rad in each joint over max(0.5 s, three periods)."""
    chain = whole_chain(robot)
    joints, mix = [joint.name for joint in driven(chain)], input_mix(chain)
    own = {drive.joint: drive for drive in robot.drives if drive.command.is_motion}
    if own:
        until = min(robot.integration.duration, _LONGEST)
        signals = [own[name].signal if name in own else constant_signal(_held(robot, name)) for name in joints]
        merged = merge([signal.schedule(until) for signal in signals])
        if _is_smooth(merged):
            return Move(merged, _times(merged), f"the arm's own drives, {until:.3g} s", mix)
    until = float(np.clip(3 / max(lowest_frequency, 1e-9), _SHORTEST, _LONGEST))
    starts = [first_value(robot, own[name].signal) if name in own else _held(robot, name) for name in joints]
    moves = [quintic_move(x, x + AMPLITUDE, until) for x in starts]
    merged = merge([move.schedule(1.3 * until) for move in moves])
    return Move(merged, _times(merged), f"{AMPLITUDE:g} rad (m) in each joint in {until:.3g} s, quintic", mix)


def _held(robot: Robot, joint: str) -> float:
    given = robot.initial.coordinates
    return given.get(f"{joint}.motor", given.get(joint, 0.0))


def _is_smooth(signals: MergedSchedule) -> bool:
    """Whether positions and rates have no jumps."""
    inner = signals.knots[1:-1]
    for derivative in range(2):
        size = np.abs(signals.at(_times(signals), derivative)).max(initial=1e-12)
        before = signals.at(np.nextafter(inner, -np.inf), derivative)
        if np.abs(signals.at(inner, derivative) - before).max(initial=0.0) > _SAME * size:
            return False
    return True


def _times(signals: MergedSchedule) -> Array:
    return np.unique(np.concatenate([np.linspace(0, signals.knots[-1], _SAMPLES + 1), signals.knots]))


def followed(model: Model, move: Move, start: Array, allowed: float) -> tuple[Array, Array]:
    """Coordinates and rates (n, nq) at the times of a move, from rest at ``start`` (nq,); ``allowed``: error of a step.

    ``model`` has its gear inputs given (:func:`tmodes.analysis.hierarchy.variants.moved_chain`). Raises
    :class:`tmodes.errors.SimulationError` where the motion cannot be followed.
    """
    stepper = _Stepper(model, move)
    q, v = [start], [np.zeros_like(start)]
    step = float(move.times[1] - move.times[0]) / 4
    steps = 0
    for begin, end in zip(move.times[:-1], move.times[1:], strict=True):
        time, here, rate = float(begin), q[-1], v[-1]
        while time < end:
            steps += 1
            size = min(step, float(end) - time)
            state, error = stepper.extrapolated(time, here, rate, size)
            if steps > _MOST_STEPS or not np.isfinite(state).all():
                raise SimulationError(f"the test move cannot be followed beyond t = {time:.4g} s; use a slower "
                                      "move, or more points of the links")  # fmt: skip
            worst = max(error / allowed, 1e-10)
            if worst <= 1:
                time, (here, rate) = float(end) if size == end - time else time + size, state
            if worst > 1 or size == step:
                step = size * float(np.clip(0.9 * worst ** (-1 / _ORDER), 0.2, 3.0))
        q.append(here)
        v.append(rate)
    return np.array(q), np.array(v)


class _Stepper:
    """Extrapolated steps of a model whose given joints follow a move."""

    def __init__(self, model: Model, move: Move) -> None:
        self.model, self.move = model, move
        self.given = np.array(model.parts.held, dtype=int)

    def extrapolated(self, time: float, q: Array, v: Array, size: float) -> tuple[Array, float]:
        """(2, nq) after a step, and the last correction of the coordinates (Aitken and Neville, columns j)."""
        first = self._euler(time, q, v, size)
        table: list[Array] = []
        for j, plain in enumerate(first, start=1):
            row = [plain]
            for k, before in enumerate(table, start=1):
                row.append(row[-1] + (row[-1] - before) / (j / (j - k) - 1))
            table = row
        return table[-1], float(np.abs(table[-1][0] - table[-2][0]).max())

    def _euler(self, time: float, q: Array, v: Array, size: float) -> Array:
        """(columns, 2, nq): 1, 2, ... linearly implicit Euler steps over the same time, side by side."""
        counts = np.arange(1, _ORDER + 1)
        h = size / counts
        q, v = np.tile(q, (_ORDER, 1)), np.tile(v, (_ORDER, 1))
        for k in range(_ORDER):
            now = slice(k, None)  # the columns that have a step left
            ends = time + h[now] * (k + 1)
            speeds = self.move.at(ends, 1)
            gain = (speeds - self.move.at(ends - h[now], 1)) / h[now, None]
            steps: Any = h[now, None]  # a step for each row
            v[now] += steps * self.model.forward_dynamics(q[now], v[now], given=gain, step=steps)
            q[now] += steps * v[now]
            q[now, self.given], v[now, self.given] = self.move.at(ends), speeds
        return np.stack([q, v], axis=1)
