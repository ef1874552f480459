"""The implicit midpoint rule at fixed step, as a native loop: for long runs whose energy must not drift.

a = acceleration at (q + q+)/2, (v + v+)/2; v+ = v + h a, q+ = q + h (v + v+)/2: of order 2, symmetric, and without
damping of its own; quadratic energies of a linear arm are kept exactly, others without drift, as time can be reversed
(E. Hairer, C. Lubich, G. Wanner, Geometric Numerical Integration, sections II.1, XI.3). A step is solved by iterating
the recursion: geometry where the last iteration put the middle, springs and dampers from the step's start with
h D/2 + h^2 K/4 added to the masses, so that stiffness does not hold back the iteration.
"""

from __future__ import annotations

from typing import Any

from tmodes.compile.ir.block import ScheduleRate
from tmodes.compile.ir.emit import F64, counted, load, number, store, whole
from tmodes.compile.loops.motion_norm import MotionNorm
from tmodes.compile.loops.step_control import next_step, take_step
from tmodes.compile.loops.time_loop import Status, TimeLoop
from tmodes.errors import CompileError

__all__ = ["ITERATIONS", "ImplicitStep", "refuse_explicit_only", "write_midpoint_loop"]

ITERATIONS = 40
"""Most iterations of a step; of those that converge at all few need more than ten."""


def write_midpoint_loop(module: Any, name: str, lowered: ScheduleRate, guarded: int, *, pairs: int) -> None:
    """Write the loop: each segment is parted into equal steps not longer than the option ``step``.

    Iterations end when two agree within the tolerances; where they do not, the run ends (``NOT_CONVERGED``). Samples
    between steps stand on the parabola of constant acceleration. Raises :class:`CompileError` as
    :func:`write_extrapolation_loop`.
    """
    refuse_explicit_only(name, lowered)
    loop = TimeLoop(module, name, lowered, ("ahead", "start", "before", "slope", "new"), guarded)
    b, step = loop.builder, next_step(loop)
    _Middle(loop, lowered, pairs).solve(b.fadd(step.time, b.fmul(step.h, number(0.5))), step.h)
    _move(loop, pairs, step.h, loop.array["new"])
    loop.stop_if(b.not_(loop.within_bounds("new")), Status.DIVERGED)
    until = b.fadd(step.time_after, b.fmul(step.h, number(1e-9)))
    with loop.due_samples(until, step.time_after) as target:
        _move(loop, pairs, b.fsub(loop.sample_time(), step.time), target)
    take_step(loop, step)


class _Middle:
    """Finds the state in the middle of a step; the last rates are left in ``slope``."""

    def __init__(self, loop: TimeLoop, lowered: ScheduleRate, pairs: int) -> None:
        self.loop, self.pairs, self.b = loop, pairs, loop.builder
        self.step, self.norm = ImplicitStep(loop, lowered, pairs), MotionNorm(loop, pairs)
        self.round = loop.local("round")

    def solve(self, middle: Any, h: Any) -> None:
        """Iterate until two middles agree within the tolerances."""
        loop, b = self.loop, self.b
        half = b.fmul(h, number(0.5))
        self._predict(half)
        b.store(number(0.0), self.round)
        turn, done = loop.block("turn"), loop.block("solved")
        b.branch(turn)
        b.position_at_end(turn)
        self.step.evaluate(middle, half, "slope")
        loop.copy("before", "ahead")
        self._put_middle(half)
        rounds = b.fadd(b.load(self.round, typ=F64), number(1.0))
        b.store(rounds, self.round)
        error = self.norm.of_difference("ahead", "before", "y", h)
        on = loop.block("not_yet")
        b.cbranch(b.fcmp_ordered("<=", error, number(1.0)), done, on)
        b.position_at_end(on)
        too_many = b.fcmp_ordered(">=", rounds, number(float(ITERATIONS)))
        loop.stop_if(b.or_(too_many, b.not_(loop.within_bounds("ahead"))), Status.NOT_CONVERGED)
        b.branch(turn)
        b.position_at_end(done)

    def _predict(self, half: Any) -> None:
        """Springs start half a step on with the rates of the start; so does the first guess of the middle."""
        b, n, array = self.b, self.pairs, self.loop.array
        self.loop.copy("ahead", "y")
        with counted(b, n, "pair") as i:
            paired = b.add(i, whole(n))
            rate = load(b, array["y"], paired)
            moved = b.fadd(load(b, array["y"], i), b.fmul(half, rate))
            store(b, moved, array["ahead"], i)
            store(b, moved, array["start"], i)
            store(b, rate, array["start"], paired)

    def _put_middle(self, half: Any) -> None:
        """The middle by the rates found: the coordinates follow its own rates."""
        self.loop.copy("ahead", "y")
        self.step.advance(half, "ahead", "slope")


def _move(loop: TimeLoop, pairs: int, time: Any, place: Any) -> None:
    """``y`` moved on by ``time`` with the accelerations of the step, written to an address."""
    b, y, slope = loop.builder, loop.array["y"], loop.array["slope"]
    with counted(b, pairs, "move") as i:
        paired = b.add(i, whole(pairs))
        rate, change = load(b, y, paired), b.fmul(time, load(b, slope, paired))
        store(b, b.fadd(rate, change), place, paired)
        mean = b.fadd(rate, b.fmul(number(0.5), change))
        store(b, b.fadd(load(b, y, i), b.fmul(time, mean)), place, i)
    with counted(b, loop.size - 2 * pairs, "rest") as i:
        at = b.add(i, whole(2 * pairs))
        store(b, b.fadd(load(b, y, at), b.fmul(time, load(b, slope, at))), place, at)


def refuse_explicit_only(name: str, rate: ScheduleRate) -> None:
    """Raise :class:`CompileError` for a schedule that has no place for a step's length or its start."""
    if rate.step_offset is None or rate.call_from is None:
        raise CompileError(f"{name}: the schedule has no inputs `step` and `start` for implicit steps")


class ImplicitStep:
    """Writes implicit evaluations; the loop has the arrays ``ahead`` (where all but springs is taken) and ``start``."""

    def __init__(self, loop: TimeLoop, rate: ScheduleRate, pairs: int) -> None:
        self.loop, self.rate, self.pairs, self.b = loop, rate, pairs, loop.builder

    def evaluate(self, time: Any, h: Any, into: str) -> None:
        """Rates at ``ahead`` of springs that start from ``start``, with h D + h^2 K added to the masses."""
        loop, b = self.loop, self.b
        store(b, h, loop.array["held"], self.rate.step_offset)
        states = [loop.array["ahead"], loop.array["start"]]
        b.call(self.rate.call_from, [time, *states, loop.row(), loop.array["held"], loop.array[into]])
        store(b, number(0.0), loop.array["held"], self.rate.step_offset)
        loop.add("evaluations", 1.0)

    def advance(self, h: Any, state: str, slope: str) -> None:
        """``state`` moved on by h with its accelerations; coordinates follow the new rates."""
        b, n, x, found = self.b, self.pairs, self.loop.array[state], self.loop.array[slope]
        with counted(b, n, "pair") as i:
            paired = b.add(i, whole(n))
            rate = b.fadd(load(b, x, paired), b.fmul(h, load(b, found, paired)))
            store(b, rate, x, paired)
            store(b, b.fadd(load(b, x, i), b.fmul(h, rate)), x, i)
        with counted(b, self.loop.size - 2 * n, "rest") as i:
            place = b.add(i, whole(2 * n))
            store(b, b.fadd(load(b, x, place), b.fmul(h, load(b, found, place))), x, place)
