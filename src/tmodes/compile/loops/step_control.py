"""What steps share: fixed ones their lengths, adaptive explicit ones their first slope, error norm and next length.

Step control (PI): E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I, section II.4, as in
their codes DOPRI5 and DOP853.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, NamedTuple

from llvmlite import ir

from tmodes.compile.ir.emit import F64, counted, declare, load, number, store
from tmodes.compile.loops.gate import Gate
from tmodes.compile.loops.stiffness import StiffnessTest
from tmodes.compile.loops.time_loop import Status, TimeLoop
from tmodes.compile.native import POWER

__all__ = [
    "ExplicitMethod", "StepControl", "add_local_errors", "mean_square", "next_step", "power", "take_step",
]  # fmt: skip


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
        b: Any = loop.builder
        loop.add("done", 1.0)
        accepted, rejected = loop.block("accepted"), loop.block("rejected")
        b.cbranch(b.fcmp_ordered("<=", error, number(1.0)), accepted, rejected)
        b.position_at_end(rejected)
        loop.reject(h, b.fdiv(number(self.safety), power(loop, error, self.exponent)), self.smallest)
        b.position_at_end(accepted)

    def accept(self, loop: TimeLoop, step: tuple[Any, Any, Any, Any], error: Any, slope: str) -> None:
        """Take the step (wanted and taken length, whether it ends on a knot, time after it); ``slope``: at its end."""
        b: Any = loop.builder
        wanted, h, last, time_after = step
        error = loop.intrinsic("maxnum", error, number(1e-10))
        wish = number(self.safety)
        if self.beta:
            wish = b.fmul(wish, power(loop, loop.get("old_error"), self.beta))
        factor = b.fdiv(wish, power(loop, error, self.exponent))
        factor = loop.intrinsic("minnum", loop.intrinsic("maxnum", factor, number(self.smallest)), number(self.largest))
        grown = b.fmul(h, factor)
        # A step cut short by a knot says little about the next: keep the longer wish.
        loop.put("h", b.select(last, loop.intrinsic("maxnum", grown, wanted), grown))
        loop.put("old_error", loop.intrinsic("maxnum", error, number(1e-4)))
        loop.copy("y", "new")
        loop.copy("k1", slope)
        loop.put("t", time_after)
        loop.put("fresh", b.uitofp(last, F64))
        loop.put("segment", b.fadd(loop.get("segment"), b.uitofp(last, F64)))
        loop.count_step(h, last)


def first_stage(loop: TimeLoop) -> None:
    """k1 where the last step did not leave it, and the first step's length (Hairer's rule of a hundredth)."""
    b = loop.builder
    with b.if_then(b.fcmp_ordered("!=", loop.get("fresh"), number(0.0)), likely=False):
        loop.evaluate(loop.get("t"), "y", "k1")
        loop.put("fresh", number(0.0))
        with b.if_then(b.fcmp_ordered("<=", loop.get("h"), number(0.0)), likely=False):
            state, slope = _norm(loop, "y", "y"), _norm(loop, "k1", "y")
            moving = b.and_(b.fcmp_ordered(">", state, number(1e-5)), b.fcmp_ordered(">", slope, number(1e-5)))
            guess = b.select(moving, b.fmul(number(0.01), b.fdiv(state, slope)), number(1e-6))
            loop.put("h", loop.intrinsic("minnum", guess, b.fsub(loop.knot(1), loop.knot(0))))


def _scale(loop: TimeLoop, i: Any, *states: str) -> Any:
    """``atol`` + ``rtol`` times the larger of the states, for component i."""
    b = loop.builder
    largest: Any = number(0.0)
    for state in states:
        largest = loop.intrinsic("maxnum", largest, loop.intrinsic("fabs", load(b, loop.array[state], i)))
    return b.fadd(loop.option("atol"), b.fmul(loop.option("rtol"), largest))


def mean_square(loop: TimeLoop, value_of: Any, *states: str) -> Any:
    """Root of the mean square of ``value_of(i)`` over the scale of each component."""
    b = loop.builder
    total = loop.cell["total"] = loop.cell.get("total") or loop.local("total")
    b.store(number(0.0), total)
    with counted(b, loop.size) as i:
        ratio = b.fdiv(value_of(i), _scale(loop, i, *states))
        b.store(b.fadd(b.load(total, typ=F64), b.fmul(ratio, ratio)), total)
    return loop.intrinsic("sqrt", b.fdiv(b.load(total, typ=F64), number(float(loop.size))))


def _norm(loop: TimeLoop, label: str, state: str) -> Any:
    return mean_square(loop, lambda i: load(loop.builder, loop.array[label], i), state)


def add_local_errors(loop: TimeLoop, label: str, factor: Any) -> None:
    """Add the sizes of a step's error, an array times a factor, to the sums that the run keeps."""
    b = loop.builder
    factor = loop.intrinsic("fabs", factor)
    with counted(b, loop.size) as i:
        size = loop.intrinsic("fabs", load(b, loop.array[label], i))
        total = b.fadd(load(b, loop.array["errors"], i), b.fmul(factor, size))
        store(b, total, loop.array["errors"], i)


def power(loop: TimeLoop, base: Any, exponent: Any) -> Any:
    """``base`` to the power ``exponent``, a number or a value."""
    module = loop.module
    exponent = number(exponent) if isinstance(exponent, float) else exponent
    function = module.globals.get(POWER) or declare(module, POWER, F64, [("x", F64), ("y", F64)])
    return loop.builder.call(function, [base, exponent])


class AdaptiveStep(NamedTuple):
    """A step of length h from ``time`` to ``time_after``; ``wanted``: its length if no knot had cut it (``last``)."""

    time: Any
    wanted: Any
    h: Any
    last: Any
    time_after: Any


@dataclass(frozen=True)
class ExplicitMethod:
    """How steps are controlled and tested; ``end``: the slope at a step's end, the first stage of the next."""

    control: StepControl
    stiffness: StiffnessTest | None
    end: str

    def begin(self, loop: TimeLoop, offset: int | None) -> tuple[Gate, AdaptiveStep]:
        """The first stage of a step, which ends on a knot where one comes; ``offset``: where the gate's numbers are."""
        gate = Gate(loop, offset)
        gate.begin("y", "probe")
        first_stage(loop)
        time, wanted = loop.get("t"), loop.get("h")
        h, last, time_after = loop.step_until(loop.knot(1))
        return gate, AdaptiveStep(time, wanted, h, last, time_after)

    def end_with(
        self, loop: TimeLoop, gate: Gate, step: AdaptiveStep, errors: tuple[Any, Any], write: Callable[[], None]
    ) -> None:
        """Judge, write and take the step to ``new``, or try it again shorter.

        ``errors``: that of the step over its tolerance, and what the array ``local`` is multiplied with to be its local
        error; ``write`` writes the samples.
        """
        error, share = errors
        self.control.judge(loop, step.h, error)
        loop.stop_if(loop.builder.not_(loop.within_bounds("new")), Status.DIVERGED)
        gate.meet(step.h)
        add_local_errors(loop, "local", share)
        write()
        self.control.accept(loop, (step.wanted, step.h, step.last, step.time_after), error, self.end)
        if self.stiffness:
            self.stiffness.write(loop, step.h)
        loop.builder.branch(loop.again)


class FixedStep(NamedTuple):
    """A step of length h from ``time`` to ``time_after``; ``count`` of its segment with it, ``last``: it ends it."""

    h: Any
    time: Any
    time_after: Any
    count: Any
    last: Any


def next_step(loop: TimeLoop) -> FixedStep:
    """The step that comes; its length is put into the cell ``h``."""
    b = loop.builder
    start, end = loop.knot(0), loop.knot(1)
    length = b.fsub(end, start)
    ratio = b.fdiv(length, loop.option("step"))
    steps = loop.intrinsic("maxnum", loop.intrinsic("ceil", b.fmul(ratio, number(1 - 1e-12))), number(1.0))
    h = b.fdiv(length, steps)
    time, count = loop.get("t"), b.fadd(loop.get("index"), number(1.0))
    last = b.fcmp_ordered(">=", count, steps)
    time_after = b.select(last, end, b.fadd(start, b.fmul(count, h)))
    loop.put("h", h)
    return FixedStep(h, time, time_after, count, last)


def take_step(loop: TimeLoop, step: FixedStep) -> None:
    """The state ``new`` is where the next step starts; back to the begin of the loop."""
    b = loop.builder
    loop.copy("y", "new")
    loop.put("t", step.time_after)
    loop.count_step(step.h, ir.Constant(ir.IntType(1), 0))
    loop.add("done", 1.0)
    loop.put("index", b.select(step.last, number(0.0), step.count))
    loop.put("segment", b.fadd(loop.get("segment"), b.uitofp(step.last, F64)))
    b.branch(loop.again)
