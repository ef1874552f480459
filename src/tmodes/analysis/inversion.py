"""Inverse dynamics of the robot as it bends: motions of its motors, and efforts, with which the tip keeps to a path.

The equations are those of :class:`tmodes.analysis.sagging.Task`. For rigid links behind elastic gears that is the
inverse by four derivatives of the path; where links bend the zeros of the tip may be unstable, and the bounded
solution begins before the path does and ends after it (pre-actuation). It is found as a periodic one: from rest along
the path to rest, and all the way back, so that no condition at an end has to say which part of it grows and which
decays. All equations at even instants, rates and accelerations by differences, Newton's method with exact derivatives.

The differences of accelerations vanish for a motion that alternates from instant to instant, as those of rates do by
their symmetry. Else a damped zero whose frequency passes that of the instants, as it may where the robot moves, finds
there a motion without damping that fulfils all equations, and these are singular.

Source: A. De Luca, Feedforward/feedback laws for the control of flexible robots, IEEE ICRA 2000 (gears); S. Devasia, D.
Chen, B. Paden, Nonlinear inversion-based output tracking, IEEE Trans. Automatic Control 41, 1996 (links); E. Bayo, A
finite-element approach to control the end-point motion of a single-link flexible robot, J. Robotic Systems 4, 1987.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.follow import Followed
from tmodes.analysis.sagging import Task, Wanted
from tmodes.errors import InputError, SimulationError
from tmodes.sheet import Robot

__all__ = ["Inverse", "inverted"]

Array = NDArray[np.float64]

_DEGREE, _REACH = 7, 4
"""Of the splines between instants; over how many neighbours on each side differences reach."""

_FIRST, _MOST = 100, 4000
"""Instants over the duration of the path: at first, at most."""

_ENTRIES = 30_000_000
"""Numbers of the linear equations at most."""

_DECAY = 16.0
"""Time constants of the zeros until what is left of a motion is nothing (1e-7)."""

_LEAST, _LONGEST, _PERIODS, _FARTHER = 0.07, 1.0, 4.0, 8.0
"""Lead and tail over the duration of the path: at least, at most; or at most periods of the slowest zero that lasts
longer, up to a bound over the duration."""

_RESTS = 1e-10
"""Rate over the largest one up to which the robot still rests."""

_FASTEST = 1e6
"""Zeros by which their equations are scaled at most [1/s]."""

_FLAT, _DEAR, _LEFT = 5, 0.01, 3e-5
"""Power of the window in which the tip gives way; weight of that over what would swing on; rate at the ends over the
largest one from which on it does."""

_ROUGH, _ROUGHER = 1e-4, 0.25
"""Difference of the efforts, over the largest one, up to which they are found; where half the step leaves more of it
than this share, they are not smooth."""

_STEPS, _SETTLED, _HALVINGS, _SLOW, _FARTHEST = 25, 1e-9, 12, 0.1, 1.0
"""Newton's method: steps, change over the largest coordinate with which it ends, halvings of a step, change over the
last one beyond which the slopes are computed again, longest step [rad, m]."""

_ROUNDED, _STALLED, _SOLVED = 1e-6, 0.5, 1e-3
"""Rounding: change over the largest coordinate below which it is rounding if it is not this share of the last one;
share of the right-hand side that linear equations may be off by."""


class Inverse(NamedTuple):
    """Motions of all coordinates ``q`` (n, nq), their rates and accelerations at ``times`` (n,) [s], from rest to rest.

    The path begins ``lead`` [s] after the motion. ``motors``: indices of the coordinates of the joints that are moved,
    ``efforts`` (n, joints) [N*m, N] of their motors; ``error``: by how much the tip would differ with half as many
    instants [m], ``rough``: the efforts, over the largest one; ``left``: largest rate at the ends, which should be 0
    [rad/s, m/s]; ``aside``: by how much the tip leaves its ends before and after the path, where what bends would swing
    on for longer than that, so that it is at rest when the motion ends [m].
    """

    times: Array
    q: Array
    rates: Array
    accelerations: Array
    motors: list[int]
    efforts: Array
    lead: float
    error: float
    rough: float
    left: float
    aside: float


def inverted(
    robot: Robot, found: Followed, tolerance: float, progress: Callable[[float], None] = lambda share: None
) -> Inverse:
    """The motion with which the tip of the nominal robot keeps to the path of the rigid one, to ``tolerance`` [m].

    In contact for surfaces that stay on the point, whose force follows its motion. Raises
    :class:`tmodes.errors.InputError` for other contacts, and for joints that no motor and no spring moves, and
    :class:`tmodes.errors.SimulationError` where no such motion is found.
    """
    touched, otherwise = robot.contact, "set `contact: null`, or take `sag`"
    if touched and (touched.sticks or (touched.unilateral and touched.moving_mass > 0)):
        got, expected = "a surface that sticks, or whose mass may part from the point", "smooth friction, no such mass"
        raise InputError("contact", got, expected, f"give it a `friction_velocity`, or {otherwise}")
    task = Task(robot, found)
    ends = _Ends.of(task)
    least = _LEAST * task.duration
    before, after = max(ends.before, least), max(ends.after, least)
    count, last, jagged, failed = int(_FIRST * (1 + (before + after) / task.duration)), None, np.inf, False
    most, aside, stills = _MOST * count // _FIRST, None, bool(ends.slow[0].size or ends.slow[1].size)
    while True:
        progress(min(0.9, 0.1 + count / most))
        here = _Solution(task, before, after, count, aside)
        is_last = 2 * count > most or 2 * here.entries > _ENTRIES
        try:
            here = here.solved(last)
        except SimulationError:
            if failed or is_last:
                raise
            count, last, failed = 2 * count, None, True
            continue
        if stills and (left := here.left) > _LEFT:
            aside = here.stilled(ends)
            here = _Solution(task, before, after, count, aside).solved(here)
            stills = here.left < left / 2  # else no joint moves what swings
        error, rough = (np.inf, np.inf) if last is None else here.off(last)
        jumps = rough > _ROUGHER * jagged  # of a path that is not smooth
        if (error <= tolerance and rough <= _ROUGH) or jumps or is_last:
            if touched and touched.unilateral and here.parts():
                got, expected = (
                    "a tip that parts from the surface",
                    "one that stays in contact, with a surface that pushes",
                )
                raise InputError("contact", got, expected, f"press on with the path, or {otherwise}")
            if last is not None and rough > jagged:  # of rounding, which grows as instants are nearer
                here, rough = last, jagged
            return here.inverse(error, rough)
        count, last, jagged = 2 * count, here, rough


class _Ends(NamedTuple):
    """How long the motion begins ``before`` the path, and ends ``after`` it [s].

    By the zeros of the tip about both ends: the finite eigenvalues of the equations with the tip held. ``slow``: those
    [1/s] of the start and of the end that decay on the way there and back, and last longer.
    """

    before: float
    after: float
    slow: tuple[NDArray[np.complex128], NDArray[np.complex128]]

    @classmethod
    def of(cls, task: Task) -> _Ends:
        """Both no longer than what lasts longest, up to a bound."""
        at = (task.along(np.array([time])) for time in (0.0, task.duration))
        zeros = [_zeros(task, task.at_rest(wanted), wanted) for wanted in at]
        both = np.concatenate(zeros)
        lasting = [_DECAY / max(float(one.min(initial=np.inf)), 1e-9)
                   for one in (both.real[both.real > 0], -both.real[both.real <= 0])]  # fmt: skip
        most = _LONGEST * task.duration
        slowest = both[np.abs(both.real) * most < _DECAY]
        periods = _PERIODS * 2 * np.pi / max(float(np.abs(slowest).min(initial=np.inf)), 1e-9)
        most = max(most, min(periods, _FARTHER * task.duration))
        slow = [one[(one.real <= 0) & (-one.real * most < _DECAY) & (one.imag >= 0)] for one in zeros]
        if slow[0].size or slow[1].size:  # what is left of the way back is to be stilled as well
            return cls(most, most, (slow[0], slow[1]))
        before, after = (min(one, most) for one in lasting)
        return cls(before, after, (slow[0], slow[1]))


def _zeros(task: Task, q: Array, wanted: Wanted) -> NDArray[np.complex128]:
    """The finite zeros [1/s] from the efforts of the motors to the tip, about a pose (1, nq) at rest."""
    from scipy.linalg import eig

    stiffness, damping, mass = (part[0] for part in task.slopes(q, 0 * q, 0 * q, wanted))
    held = stiffness[[*task.motors, *task.still]]
    ways = np.linalg.svd(held)[2][len(held) :].T  # motions that leave the tip where it is
    m, d, k = (part[task.passive] @ ways for part in (mass, damping, stiffness))
    if not len(m):
        return np.zeros(0, dtype=complex)
    n, unit = len(m), float(np.clip(np.sqrt(np.abs(k).max() / max(np.abs(m).max(), 1e-300)), 1.0, _FASTEST))
    one, none = np.eye(n), np.zeros((n, n))
    left = np.block([[none, one], [-k, -d * unit]])
    right = np.block([[one, none], [none, m * unit**2]])
    found: Any = eig(left, right, right=False, homogeneous_eigvals=True)
    alpha, beta = found
    finite = np.abs(beta) > 1e-10 * np.abs(alpha)
    return np.asarray(alpha[finite] / beta[finite] * unit, dtype=complex)


def _differences() -> Array:
    """Weights (3, 2 reach + 1) of neighbours for values, rates (order 8) and accelerations (order 6), of step 1."""
    j = np.arange(1.0, _REACH + 1)
    powers = j ** (2 * np.arange(_REACH)[:, None])
    first = np.linalg.solve(powers * j, np.eye(_REACH)[0] / 2)
    second = np.linalg.solve(np.vstack([powers[:-1] * j**2, j % 2]), np.eye(_REACH)[0])
    middle = np.array([[1.0], [0.0], [-2 * second.sum()]])
    sides = np.array([0 * j, first, second])
    return np.hstack([sides[:, ::-1] * [[0], [-1], [1]], middle, sides])


class _Solution:
    """Coordinates at even instants of the way there and back; ``count``: from the first to the last motion there."""

    def __init__(
        self, task: Task, before: float, after: float, count: int, aside: Callable[[Array], Array] | None = None
    ) -> None:
        self.task, self.count = task, count
        self.step = (before + task.duration + after) / count
        self.lead, self.tail = before, after
        rest = self.lead + self.tail
        self.instants = 2 * round((task.duration + rest) / self.step)
        self.step = 2 * (task.duration + rest) / self.instants
        self.way = np.arange(float(self.instants)) * self.step - self.lead
        self.times = np.where(self.way <= task.duration + rest / 2, self.way, 2 * task.duration + rest - self.way)
        self.wanted, self.moved, self.aside = task.along(self.times), aside, aside(self.way) if aside else None
        self.weights = _differences() / self.step ** np.arange(3)[:, None]
        self.places = (np.arange(self.instants)[:, None] + np.arange(-_REACH, _REACH + 1)) % self.instants
        self.q = np.zeros((self.instants, task.model.nq))

    @property
    def entries(self) -> int:
        """Numbers of the linear equations."""
        return self.instants * (2 * _REACH + 1) * self.task.model.nq**2

    def solved(self, last: _Solution | None) -> _Solution:
        """Itself, with what fulfils all equations; from a coarser solution, else from the pose at rest."""
        if last is None:
            times, where = np.unique(self.times.round(12), return_inverse=True)
            self.q = self.task.at_rest(self.task.along(times))[where]
        else:
            self.q = last.at(self.way)
        size, moved, shrink, scale = 1.0, np.inf, np.inf, np.ones(())
        solve: Callable[[Array], Array] = np.asarray
        for _ in range(_STEPS):
            residual = self.residual(self.q)
            if fresh := shrink > _SLOW:
                scale, solve = self.linear()
            change = solve(residual / scale)
            longest = float(np.abs(change).max())
            off, share = float(np.linalg.norm(residual / scale)), min(1.0, _FARTHEST / max(longest, 1e-300))
            for _ in range(_HALVINGS):
                tried = self.q - share * change
                there = float(np.linalg.norm(self.residual(tried) / scale))
                if there <= off * (1 - share / 4) or np.abs(share * change).max() <= _SETTLED * size:
                    break
                share /= 2
            else:
                if fresh:
                    break
                shrink = np.inf
                continue
            self.q, size = tried, 1.0 + float(np.abs(self.q).max())
            shrink, moved = longest / moved, longest
            if moved <= _SETTLED * size or (fresh and shrink > _STALLED and moved <= _ROUNDED * size):
                return self
        raise SimulationError(
            f"no motion was found with which the tip keeps to the path: after {_STEPS} steps with {self.instants} "
            f"instants coordinates still change by {moved:.2g} rad, m; take a slower path, or the reference `sag`"
        )

    def motion(self, q: Array) -> tuple[Array, Array, Array]:
        """Coordinates, rates and accelerations (instants, nq) at the instants."""
        near = q[self.places]
        v, a = (np.einsum("o,noq->nq", row, near) for row in self.weights[1:])
        return q, v, a

    def at(self, times: Array) -> Array:
        """Coordinates (n, nq) at times [s] from the beginning of the path."""
        from scipy.interpolate import make_interp_spline

        whole = np.append(self.way, self.way[0] + self.instants * self.step)
        spline = make_interp_spline(whole, np.vstack([self.q, self.q[:1]]), k=_DEGREE, bc_type="periodic")
        return np.asarray(spline(np.clip(times, whole[0], whole[-1])))

    def residual(self, q: Array) -> Array:
        """What shall vanish (instants, nq)."""
        found = self.task.residual(*self.motion(q), self.wanted)
        if self.aside is not None:
            found[:, self.task.motors] -= self.task.pushed(self.aside, self.wanted)
        return found

    @property
    def left(self) -> float:
        """The largest rate at both ends, over the largest one."""
        rates = np.abs(self.motion(self.q)[1])
        return float(rates[[0, self.instants // 2]].max() / max(rates.max(), 1e-300))

    def stilled(self, ends: _Ends) -> Callable[[Array], Array]:
        """The way (n, rows) of the tip off its ends, by times on the way there and back, with which these are at rest.

        Harmonics of the slow zeros in a window after the path, and one before it on the way back. Least squares of what
        would swing on, as it moves the tip, and of the way itself.
        """
        task, half = self.task, self.instants // 2
        windows = (
            (self.way[half] - self.tail, self.tail, ends.slow[1]),
            (self.way[0] - self.lead, self.lead, ends.slow[0]),
        )
        whole = self.instants * self.step

        def shapes(way: Array) -> Array:
            found = list[Array]()
            for begin, length, zeros in windows:
                time = (way - begin) % whole
                share = np.clip(time / length, 0.0, 1.0)
                window = (4 * share * (1 - share)) ** _FLAT
                found += [window, window * (2 * share - 1)]
                for zero in zeros[zeros.imag > 0].imag:
                    found += [window * np.cos(zero * time), window * np.sin(zero * time)]
            return np.array(found).T

        own, scale, solve = shapes(self.way), *self.linear()
        pushes = np.zeros((self.instants, task.model.nq, own.shape[1] * task.rows))
        for row in range(task.rows):
            unit = task.pushed(np.broadcast_to(np.eye(task.rows)[row], (self.instants, task.rows)), self.wanted)
            pushes[:, task.motors, row :: task.rows] = unit[:, :, None] * own[:, None, :]
        moved = solve(pushes / scale[:, :, None])
        times = min(self.tail, 1 / np.abs(np.concatenate(ends.slow)).min())

        def left(q: Array) -> Array:
            v = np.einsum("o,no...->n...", self.weights[1], q[self.places[[0, half]]])
            return np.concatenate([q[[0, half]], times * v])

        rest = task.at_rest(Wanted(*(part[[0, half]] for part in self.wanted)))
        off = left(self.q)
        off[:2] -= rest
        ways = left(moved).reshape(-1, moved.shape[2])
        moves = np.linalg.norm(task.model.jacobian(rest)[:, task.problem.point, :3], axis=1).max(axis=0)
        weights = np.tile(moves, 4)
        rows = np.vstack([weights[:, None] * ways, _DEAR * np.eye(ways.shape[1])])
        wanted = np.append(-weights * off.ravel(), np.zeros(ways.shape[1]))
        factors = np.linalg.lstsq(rows, wanted)[0].reshape(-1, task.rows)
        before = self.moved
        return lambda way: shapes(way) @ factors + (before(way) if before else 0.0)

    def slopes(self, q: Array) -> Array:
        """Its slopes (instants, nq, neighbours, nq) by the coordinates nearby."""
        parts = np.stack(self.task.slopes(*self.motion(q), self.wanted))
        return np.einsum("ko,knij->nioj", self.weights, parts)

    def linear(self) -> tuple[Array, Callable[[Array], Array]]:
        """The size (instants, nq) of each equation, and what solves the linear equations, of that size 1."""
        slopes = self.slopes(self.q)
        scale = np.abs(slopes).max(axis=(2, 3))
        scale[scale == 0] = 1.0
        return scale, self.factored(slopes / scale[:, :, None, None])

    def factored(self, slopes: Array) -> Callable[[Array], Array]:
        """The function that solves the linear equations (instants, nq)."""
        from scipy.sparse import csr_array
        from scipy.sparse.linalg import splu

        n, count = self.task.model.nq, self.instants
        columns = (self.places[:, :, None] * n + np.arange(n)).reshape(count, 1, -1)
        columns = np.broadcast_to(columns, (count, n, columns.shape[2]))
        starts = np.arange(count * n + 1) * columns.shape[2]
        matrix = csr_array((slopes.reshape(-1), columns.reshape(-1), starts), shape=(count * n, count * n))
        try:
            parts = splu(matrix.tocsc())
        except (RuntimeError, ValueError):
            raise SimulationError(
                "the tip does not follow the motors: a singular pose, or a joint that no motor moves"
            ) from None

        def solve(residual: Array) -> Array:
            wanted = residual.reshape(count * n, -1)
            found = parts.solve(wanted)
            left = np.abs(matrix @ found - wanted).max()
            if not left <= _SOLVED * np.abs(wanted).max():
                raise SimulationError(
                    f"rounding hides the motion with {count} instants: what bends grows too fast between them; take a "
                    "slower path, or the reference `sag`"
                )
            return np.asarray(found).reshape(residual.shape)

        return solve

    def off(self, coarse: _Solution) -> tuple[float, float]:
        """What differs from a coarser solution: the rigid tip by the motors [m], efforts over the largest one."""
        from scipy.interpolate import CubicSpline

        joints, own = self.task.motors, self.wanted.ways[:, :3]
        instants = [one.way for one in (self, coarse)]
        apart = (self.motion(self.q)[0] - coarse.at(instants[0]))[:, joints]
        fine, rough = (one.efforts(*one.motion(one.q)) for one in (self, coarse))
        jagged = np.abs(CubicSpline(instants[0], fine)(instants[1]) - rough)[: coarse.instants // 2]
        off = float(np.linalg.norm(np.einsum("nkj,nj->nk", own, apart), axis=1).max())
        return off, float(jagged.max() / max(np.abs(fine).max(), 1e-300))

    def efforts(self, q: Array, v: Array, a: Array) -> Array:
        """Efforts (n, joints) of the motors [N*m, N]."""
        return self.task.efforts(q, v, a)[:, self.task.motors]

    def parts(self) -> bool:
        """Whether the tip leaves the surface, or touches it, on the way."""
        if self.task.pressed is None:
            return False
        _, depth, normal = self.task.pressed.force(self.task.pressed.motion(*self.motion(self.q)))
        held = np.minimum(depth, normal) > 0
        return bool(held.any() and not held.all())

    def inverse(self, error: float, rough: float) -> Inverse:
        """The way there, from where it begins to move to where it ends."""
        task, (q, v, a) = self.task, self.motion(self.q)
        there = np.flatnonzero(self.way <= task.duration + self.tail + 1e-9 * self.step)
        rates, least = np.abs(v[there]).max(axis=1), _LEAST * task.duration
        moving = rates > _RESTS * rates.max()
        moving |= (self.way[there] > -least) & (self.way[there] < task.duration + least)
        first, last = np.flatnonzero(moving)[[0, -1]]
        there = there[max(first - 1, 0) : last + 2]
        q, v, a = (part[there] for part in (q, v, a))
        left, lead = float(np.abs(v[[0, -1]]).max(initial=0.0)), -float(self.way[there[0]])
        times, efforts = self.way[there] + lead, self.efforts(q, v, a)
        aside = 0.0 if self.aside is None else float(np.linalg.norm(self.aside[there, :3], axis=1).max())
        return Inverse(times, q, v, a, task.motors, efforts, lead, error, rough, left, aside)
