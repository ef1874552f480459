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
from tmodes.compile.ir.emit import F64, counted, number, store, whole
from tmodes.compile.loops.frame import MotionNorm
from tmodes.compile.loops.step_control import FixedGate, next_step, take_step
from tmodes.compile.loops.time_loop import Status, TimeLoop
from tmodes.errors import CompileError

__all__ = ["ITERATIONS", "write_midpoint_loop"]

ITERATIONS = 40
"""Most iterations of a step; of those that converge at all few need more than ten."""


def write_midpoint_loop(module: Any, name: str, lowered: ScheduleRate, guarded: int, *, pairs: int) -> None:
    """Write the loop: each segment is divided into equal steps not longer than the option ``step``.

    Iterations end when two agree within the tolerances; where they do not, the run ends (``NOT_CONVERGED``). Samples
    between steps stand on the parabola of constant acceleration. Raises :class:`CompileError` for a schedule that has
    no inputs for a step's length and its start.
    """
    if lowered.step_offset is None or lowered.call_from is None:
        raise CompileError(f"{name}: the schedule has no inputs `step` and `start` for implicit steps")
    loop = TimeLoop(module, name, lowered, ("ahead", "start", "before", "slope", "new"), guarded)
    b, gate = loop.builder, FixedGate(loop)
    gate.begin("y", "slope")
    step = next_step(loop)
    loop.put("h", step.h)  # where the iterations do not converge, the message names it
    _Middle(loop, pairs).solve(b.fadd(step.time, b.fmul(step.h, number(0.5))), step.h)
    _move(loop, pairs, step.h, loop.array["new"])
    gate.end(step, "before")
    loop.stop_if(b.not_(loop.within_bounds("new")), Status.DIVERGED)
    until = b.fadd(step.time_after, b.fmul(step.h, number(1e-9)))
    with loop.due_samples(until, step.time_after) as target:
        _move(loop, pairs, b.fsub(loop.sample_time(), step.time), target)
    take_step(loop, step)


class _Middle:
    """Finds the state in the middle of a step, ``ahead``; the last rates are left in ``slope``."""

    def __init__(self, loop: TimeLoop, pairs: int) -> None:
        self.loop, self.pairs, self.b = loop, pairs, loop.builder
        self.norm, self.round = MotionNorm(loop, pairs), loop.local("round")

    def solve(self, middle: Any, h: Any) -> None:
        """Iterate until two middles agree within the tolerances."""
        loop, b = self.loop, self.b
        half = b.fmul(h, number(0.5))
        self._predict(half)
        b.store(number(0.0), self.round)
        turn, done = loop.block("turn"), loop.block("solved")
        b.branch(turn)
        b.position_at_end(turn)
        self._evaluate(middle, half)
        loop.copy("before", "ahead")
        self._advance(half)
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
        b, loop = self.b, self.loop
        loop.copy("ahead", "y")
        with counted(b, self.pairs, "pair") as i:
            paired = b.add(i, whole(self.pairs))
            rate = loop.load("y", paired)
            moved = b.fadd(loop.load("y", i), b.fmul(half, rate))
            loop.store(moved, "ahead", i)
            loop.store(moved, "start", i)
            loop.store(rate, "start", paired)

    def _evaluate(self, time: Any, h: Any) -> None:
        """Rates at ``ahead`` of springs that start from ``start``, with h D + h^2 K added to the masses."""
        b, loop, rate = self.b, self.loop, self.loop.rate
        held = loop.array["held"]
        store(b, h, held, rate.step_offset)
        states = [loop.array["ahead"], loop.array["start"]]
        b.call(rate.call_from, [time, *states, loop.row(), held, loop.array["slope"]])
        store(b, number(0.0), held, rate.step_offset)
        loop.add("evaluations", 1.0)

    def _advance(self, h: Any) -> None:
        """``ahead`` is ``y`` moved on by h with its accelerations; coordinates follow the new rates."""
        b, n, loop = self.b, self.pairs, self.loop
        with counted(b, n, "pair") as i:
            paired = b.add(i, whole(n))
            rate = b.fadd(loop.load("y", paired), b.fmul(h, loop.load("slope", paired)))
            loop.store(rate, "ahead", paired)
            loop.store(b.fadd(loop.load("y", i), b.fmul(h, rate)), "ahead", i)
        with counted(b, loop.size - 2 * n, "rest") as i:
            place = b.add(i, whole(2 * n))
            loop.store(b.fadd(loop.load("y", place), b.fmul(h, loop.load("slope", place))), "ahead", place)


def _move(loop: TimeLoop, pairs: int, time: Any, place: Any) -> None:
    """``y`` moved on by ``time`` with the accelerations of the step, written to an address."""
    b = loop.builder
    with counted(b, pairs, "move") as i:
        paired = b.add(i, whole(pairs))
        rate, change = loop.load("y", paired), b.fmul(time, loop.load("slope", paired))
        store(b, b.fadd(rate, change), place, paired)
        mean = b.fadd(rate, b.fmul(number(0.5), change))
        store(b, b.fadd(loop.load("y", i), b.fmul(time, mean)), place, i)
    with counted(b, loop.size - 2 * pairs, "rest") as i:
        at = b.add(i, whole(2 * pairs))
        store(b, b.fadd(loop.load("y", at), b.fmul(time, loop.load("slope", at))), place, at)
