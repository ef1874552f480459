"""What steps share: fixed ones their lengths, adaptive ones how their error gives the length of the next.

Step control (PI) of explicit methods: E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I,
section II.4, as in their codes DOPRI5 and DOP853.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Any, NamedTuple

from llvmlite import ir

from tmodes.compile.ir.emit import F64, I64, counted, declare, number, whole
from tmodes.compile.loops.frame import Frame
from tmodes.compile.loops.gate import Gate
from tmodes.compile.loops.time_loop import AdaptiveStep, Status, TimeLoop
from tmodes.compile.native import POWER

__all__ = [
    "ExplicitMethod",
    "FixedGate",
    "ImplicitControl",
    "StepControl",
    "StiffnessTest",
    "first_length",
    "next_step",
    "take_step",
]

_IN_A_ROW, _CALM, _EVERY = 15.0, 6.0, 8
"""Stiff steps that tell; steps not stiff that forget; each so many steps are looked at while nothing is suspected."""


@dataclass(frozen=True)
class StiffnessTest:
    """``slopes`` and ``states`` are the two arrays of each; ``limit``: of step times eigenvalue.

    ``ringing``: the same on the imaginary axis.
    """

    slopes: tuple[str, str]
    states: tuple[str, str]
    limit: float
    ringing: float

    def write(self, loop: TimeLoop, h: Any) -> None:
        """After a step of length h was taken: count it, and end the loop where it is asked to watch."""
        b: Any = loop.builder
        watched = b.fcmp_ordered("!=", loop.option("watch"), number(0.0))
        limit = b.select(watched, number(self.ringing), number(self.limit))
        suspected = b.fcmp_ordered(">", loop.get("stiff"), number(0.0))
        turn = b.icmp_signed("==", b.and_(b.fptosi(loop.get("steps"), I64), whole(_EVERY - 1)), whole(0))
        with b.if_then(b.or_(suspected, turn), likely=False):
            self._count(loop, b.fcmp_ordered(">", self._reach(loop, h), limit))
        info = b.fcmp_ordered(">=", loop.get("stiff"), number(_IN_A_ROW))
        with b.if_then(b.and_(info, b.fcmp_ordered("<=", loop.get("stiff_time"), number(0.0))), likely=False):
            loop.put("stiff_time", loop.get("t"))
        loop.stop_if(b.and_(info, watched), Status.STIFF)

    def _reach(self, loop: TimeLoop, h: Any) -> Any:
        """Step times eigenvalue; not a number where nothing moves, which counts as calm."""
        b: Any = loop.builder
        above, below = self._size(loop, "above", self.slopes), self._size(loop, "below", self.states)
        return b.fmul(h, loop.intrinsic("sqrt", b.fdiv(above, below)))

    def _size(self, loop: TimeLoop, name: str, pair: tuple[str, str]) -> Any:
        b: Any = loop.builder
        total = loop.local(name)
        b.store(number(0.0), total)
        with counted(b, loop.size) as i:
            apart = b.fsub(*(loop.load(label, i) for label in pair))
            b.store(b.fadd(b.load(total, typ=F64), b.fmul(apart, apart)), total)
        return b.load(total, typ=F64)

    def _count(self, loop: TimeLoop, stiff: Any) -> None:
        b: Any = loop.builder
        zero, one = number(0.0), number(1.0)
        calm = b.select(stiff, zero, b.fadd(loop.get("calm"), one))
        count = b.select(stiff, b.fadd(loop.get("stiff"), one), loop.get("stiff"))
        forgotten = b.fcmp_ordered(">=", calm, number(_CALM))
        loop.put("stiff", b.select(forgotten, zero, count))
        loop.put("calm", b.select(forgotten, zero, calm))


@dataclass(frozen=True)
class StepControl:
    """How the error of a step gives the length of the next: factor = safety old^beta / error^(1/order - 3/4 beta).

    The factor stays between ``smallest`` and ``largest``; ``damping``: what beta takes from the exponent.
    """

    order: float
    beta: float
    damping: float
    smallest: float
    largest: float
    safety: float = 0.9

    @property
    def exponent(self) -> float:
        """Power of the error by which a step shrinks."""
        return 1.0 / self.order - self.damping * self.beta

    def judge(self, loop: TimeLoop, h: Any, error: Any) -> None:
        """Try again with a shorter step where the error is beyond 1; go on otherwise."""
        loop.add("done", 1.0)
        safety, b = number(self.safety), loop.builder
        loop.judge(error, h, lambda: b.fdiv(safety, _power(loop, error, self.exponent)), self.smallest)

    def accept(self, loop: TimeLoop, step: AdaptiveStep, error: Any, slope: str) -> None:
        """Take the step; ``slope``: at its end."""
        b = loop.builder
        loop.put("errors", b.fadd(loop.get("errors"), error))
        error = loop.intrinsic("maxnum", error, number(1e-10))
        wish = number(self.safety)
        if self.beta:
            wish = b.fmul(wish, _power(loop, loop.get("old_error"), self.beta))
        factor = b.fdiv(wish, _power(loop, error, self.exponent))
        factor = loop.intrinsic("minnum", loop.intrinsic("maxnum", factor, number(self.smallest)), number(self.largest))
        loop.put("old_error", loop.intrinsic("maxnum", error, number(1e-4)))
        loop.copy("k1", slope)
        loop.put("fresh", b.uitofp(step.last, F64))
        loop.take(step, b.fmul(step.h, factor))


@dataclass(frozen=True)
class ImplicitControl:
    """The same of implicit methods: factor = 0.9 / error^exponent; ``first``: length of the first step [s]."""

    exponent: float
    smallest: float
    first: float
    largest: float = 6.0

    def begin(self, loop: TimeLoop) -> AdaptiveStep:
        """The step that comes, which ends on a knot where one comes."""
        b = loop.builder
        start, end = loop.segment()
        with b.if_then(b.fcmp_ordered("<=", loop.get("h"), number(0.0)), likely=False):
            loop.put("h", loop.intrinsic("minnum", number(self.first), b.fsub(end, start)))
        return _adaptive_step(loop, end)

    def judge(self, loop: TimeLoop, step: AdaptiveStep, error: Any, wish: str = "h") -> Any:
        """Try again with a shorter step, or go on; the length that the error allows the next one.

        ``wish``: the cell that keeps it.
        """
        loop.add("done", 1.0)
        factor = self._factor(loop, error)
        loop.judge(error, step.h, lambda: factor, self.smallest, wish)
        loop.put("errors", loop.builder.fadd(loop.get("errors"), error))
        return self._grown(loop, step.h, factor)

    def grown(self, loop: TimeLoop, h: Any, error: Any) -> Any:
        """The length that the error of a step of length h allows the next one."""
        return self._grown(loop, h, self._factor(loop, error))

    def _grown(self, loop: TimeLoop, h: Any, factor: Any) -> Any:
        return loop.builder.fmul(h, loop.intrinsic("minnum", factor, number(self.largest)))

    def _factor(self, loop: TimeLoop, error: Any) -> Any:
        """By how much a step may be longer; of an error that is no number no number: it is then shortened most."""
        b, tiny = loop.builder, number(1e-10)
        floor = b.select(b.fcmp_ordered("<", error, tiny), tiny, error)
        return b.fdiv(number(0.9), _power(loop, floor, self.exponent))


def _adaptive_step(loop: TimeLoop, end: Any) -> AdaptiveStep:
    time, wanted = loop.get("t"), loop.get("h")
    return AdaptiveStep(time, wanted, *loop.step_until(end))


def first_length(loop: Frame, order: float, power: Callable[[Any, float], Any]) -> Any:
    """Length of the first step: Hairer, Norsett, Wanner, Solving ODEs I, II.4, from ``y`` and its slope ``k1``.

    A hundredth of what an Euler step may move (``power``: of a number, by an exponent), then by the change of the slope
    over such a step. It is not shorter than 1e-6 s: where the state is no more than rounding, as at rest, its size over
    that of its slope says nothing, and a step that is too long is tried again.
    """
    b, least, shortest = loop.builder, loop.constant(1e-5), loop.constant(1e-6)
    start, end = loop.segment()
    span, hundredth = b.fsub(end, start), loop.constant(0.01)
    state, slope = (loop.mean_square(lambda i, a=a: loop.load(a, i), "y") for a in ("y", "k1"))
    moving = b.and_(b.fcmp_ordered(">", state, least), b.fcmp_ordered(">", slope, least))
    guess = loop.intrinsic("maxnum", b.fmul(hundredth, b.fdiv(state, slope)), shortest)
    guess = loop.intrinsic("minnum", b.select(moving, guess, shortest), span)
    loop.combine("probe", {"k1": guess})
    loop.evaluate(b.fadd(loop.get("t"), guess), "probe", "new")
    change = loop.mean_square(lambda i: b.fsub(loop.load("new", i), loop.load("k1", i)), "y")
    largest = loop.intrinsic("maxnum", slope, b.fdiv(change, guess))
    still = b.fcmp_ordered("<=", largest, loop.constant(1e-15))
    largest = loop.intrinsic("minnum", loop.intrinsic("maxnum", largest, loop.constant(1e-15)), loop.constant(1e290))
    wish = b.select(still, shortest, power(b.fdiv(hundredth, largest), 1.0 / order))
    wish = loop.intrinsic("minnum", wish, b.fmul(loop.constant(100.0), guess))
    return loop.intrinsic("minnum", wish, span)


def _power(loop: TimeLoop, base: Any, exponent: float) -> Any:
    module = loop.module
    function = module.globals.get(POWER) or declare(module, POWER, F64, [("x", F64), ("y", F64)])
    return loop.builder.call(function, [base, number(exponent)])


@dataclass(frozen=True)
class ExplicitMethod:
    """How steps are controlled and tested; ``end``: the slope at a step's end, the first stage of the next."""

    control: StepControl
    stiffness: StiffnessTest | None
    end: str

    def begin(self, loop: TimeLoop) -> tuple[Gate, AdaptiveStep]:
        """The first stage of a step, which ends on a knot where one comes."""
        b, gate = loop.builder, Gate(loop)
        gate.begin("y", "probe")
        with b.if_then(b.fcmp_ordered("!=", loop.get("fresh"), number(0.0)), likely=False):
            loop.evaluate(loop.get("t"), "y", "k1")
            loop.put("fresh", number(0.0))
            with b.if_then(b.fcmp_ordered("<=", loop.get("h"), number(0.0)), likely=False):
                loop.put("h", first_length(loop, self.control.order, partial(_power, loop)))
        return gate, _adaptive_step(loop, loop.segment()[1])

    def end_with(self, loop: TimeLoop, gate: Gate, step: AdaptiveStep, error: Any, write: Callable[[], None]) -> None:
        """Judge, write and take the step to ``new``, or try it again shorter.

        ``error``: that of the step over its tolerance; ``write`` writes the samples.
        """
        self.control.judge(loop, step.h, error)
        gate.meet(step.h)  # which may shorten a step that goes far beyond a change
        loop.stop_if(loop.builder.not_(loop.within_bounds("new")), Status.DIVERGED)
        write()
        self.control.accept(loop, step, error, self.end)
        if self.stiffness:
            self.stiffness.write(loop, step.h)
        loop.builder.branch(loop.again)


_LONGER = 10.0
"""How much longer a step may be than one before it that was cut: the regula falsi over long steps stands still."""


class FixedStep(NamedTuple):
    """A step of length h from ``time`` to ``time_after``; ``count`` of its segment with it, ``last``: it ends it.

    A change makes two of a step: it ends at the change, and the next one where it would have ended. ``longest``: of the
    next step, after one that was cut; 0: as long as it is.
    """

    h: Any
    time: Any
    time_after: Any
    count: Any
    last: Any
    longest: Any = None


def next_step(loop: Frame) -> FixedStep:
    """The step that comes: each segment is parted into equal steps not longer than the option ``step``."""
    b, (start, end) = loop.builder, loop.segment()
    length = b.fsub(end, start)
    ratio = b.fmul(b.fdiv(length, loop.option("step")), loop.constant(1 - 1e-12))
    steps = loop.intrinsic("maxnum", loop.intrinsic("ceil", ratio), loop.constant(1.0))
    h, count = b.fdiv(length, steps), b.fadd(loop.get("index"), loop.constant(1.0))
    last = b.fcmp_ordered(">=", count, steps)
    time, after = loop.get("t"), b.select(last, end, b.fadd(start, b.fmul(count, h)))
    if not loop.rate.changes:
        return FixedStep(h, time, after, count, last)
    left, cut = b.fsub(after, time), loop.get("cut")
    whole_step = b.or_(b.fcmp_ordered("<=", cut, loop.constant(0.0)), b.fcmp_ordered(">=", cut, left))
    count, last = b.select(whole_step, count, loop.get("index")), b.and_(last, whole_step)
    h, after = b.select(whole_step, left, cut), b.select(whole_step, after, b.fadd(time, cut))
    longest = b.select(whole_step, loop.constant(0.0), b.fmul(loop.constant(_LONGER), cut))
    return FixedStep(h, time, after, count, last, longest)


class FixedGate(Gate):
    """What switches, starts or ends within fixed steps."""

    def end(self, step: FixedStep, into: str) -> None:
        """Look at the end of a step to ``new``, and shorten it where it goes beyond a change."""
        if not self.exists:
            return
        self.loop.evaluate(step.time_after, "new", into)
        self.meet(step.h, lambda shorter: self.loop.put("cut", shorter))
        self.loop.put("cut", step.longest)


def take_step(loop: TimeLoop, step: FixedStep) -> None:
    """The state ``new`` is where the next step starts; back to the begin of the loop."""
    b = loop.builder
    loop.copy("y", "new")
    loop.put("h", step.h)
    loop.put("t", step.time_after)
    loop.count_step(step.h, ir.Constant(ir.IntType(1), 0))
    loop.add("done", 1.0)
    loop.put("index", b.select(step.last, number(0.0), step.count))
    loop.put("segment", b.fadd(loop.get("segment"), b.uitofp(step.last, F64)))
    b.branch(loop.again)
