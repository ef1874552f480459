"""Any explicit Runge-Kutta method over runs side by side, each with steps of its own.

The method is that of :mod:`tmodes.compile.loops.explicit_loop`.
"""

from __future__ import annotations

import math
import struct
from collections.abc import Callable
from functools import partial
from typing import Any

from llvmlite import ir

from tmodes.compile.ir.arithmetic import Lanes
from tmodes.compile.ir.block import ScheduleRate
from tmodes.compile.ir.emit import I64, counted, whole
from tmodes.compile.lanes.lanes_loop import LaneSeries, LanesLoop
from tmodes.compile.lanes.series import due_samples, write_sample
from tmodes.compile.loops.explicit_loop import adaptive_control, error_of, hermite, interpolation, slopes, stages
from tmodes.compile.loops.frame import MotionNorm
from tmodes.compile.loops.gate import gate_change, gate_numbers
from tmodes.compile.loops.step_control import StepControl, first_length, next_step
from tmodes.compile.loops.time_loop import AdaptiveStep, Status
from tmodes.integrate.method import Tableau

__all__ = ["LaneNorm", "exponential", "logarithm", "write_lanes_loop"]


class LaneNorm(MotionNorm):
    """The same norm to rounding."""

    def _add_pairs(self, error: Callable[[Any], Any], one: str, before: str, h: Any) -> None:
        b = self.b
        often = b.fdiv(self.loop.constant(1.0), h)
        with counted(b, self.pairs, "pair") as i:
            paired = b.add(i, whole(self.pairs))
            scale = self._scale(self._size(i, one, before))
            own = self._scale(self._size(paired, one, before))
            self._add(b.fdiv(error(i), scale))
            self._add(b.fdiv(error(paired), self.loop.intrinsic("maxnum", b.fmul(scale, often), own)))


_SHIFT, _ONE = 52, 1023 << 52
_MAGIC = 1.5 * 2.0**52
"""Added to a number below 2^51 it leaves the nearest whole number in the low bits."""
_ROOT_HALF = struct.unpack("<q", struct.pack("<d", math.sqrt(0.5)))[0]
"""Bits of the square root of 1/2."""


def _whole(lanes: Lanes) -> Any:
    return ir.VectorType(I64, lanes.stride)


def _bits(lanes: Lanes, value: int) -> Any:
    return ir.Constant(_whole(lanes), [value] * lanes.stride)


def logarithm(b: Any, lanes: Lanes, x: Any) -> Any:
    """Logarithm to base 2 of positive normal numbers; of others some finite number."""
    bits = b.bitcast(x, _whole(lanes))
    # The mantissa lies in [sqrt(1/2), sqrt(2)) when the exponent is taken at that boundary.
    shifted = b.sub(bits, _bits(lanes, _ROOT_HALF))
    exponent = b.and_(b.lshr(shifted, _bits(lanes, _SHIFT)), _bits(lanes, 0xFFF))
    mantissa = b.bitcast(b.sub(bits, b.shl(exponent, _bits(lanes, _SHIFT))), lanes.kind)
    # As a double: the whole number becomes the low bits of 2^52, or, where it is negative, of 2^52 + 2^12.
    signed = b.xor(exponent, _bits(lanes, 0x800))
    number = b.bitcast(b.or_(signed, _bits(lanes, (1023 + _SHIFT) << _SHIFT)), lanes.kind)
    power = b.fsub(number, lanes.constant(2.0**_SHIFT + 0x800))
    t = b.fdiv(b.fsub(mantissa, lanes.constant(1.0)), b.fadd(mantissa, lanes.constant(1.0)))
    series = _polynomial(b, lanes, b.fmul(t, t), [2 / math.log(2) / (2 * k + 1) for k in range(6)])
    return b.fadd(power, b.fmul(t, series))


def exponential(b: Any, lanes: Lanes, x: Any) -> Any:
    """2 to the power x, for |x| below 1000."""
    moved = b.fadd(x, lanes.constant(_MAGIC))
    share = b.fsub(x, b.fsub(moved, lanes.constant(_MAGIC)))
    scale = b.add(b.shl(b.bitcast(moved, _whole(lanes)), _bits(lanes, _SHIFT)), _bits(lanes, _ONE))
    series = _polynomial(b, lanes, share, [math.log(2) ** k / math.factorial(k) for k in range(9)])
    return b.fmul(series, b.bitcast(scale, lanes.kind))


def _polynomial(b: Any, lanes: Lanes, x: Any, coefficients: list[float]) -> Any:
    value = lanes.constant(coefficients[-1])
    for coefficient in reversed(coefficients[:-1]):
        value = b.fadd(lanes.constant(coefficient), b.fmul(x, value))
    return value


def write_lanes_loop(
    module: Any, name: str, rate: ScheduleRate, guarded: int, tableau: Tableau, series: LaneSeries | None = None
) -> None:
    """Write the loop of a method: adaptive where it has an embedded error, else with the option ``step``.

    ``series``: what is wanted of each sample; steps are then as long as errors of the motion allow.
    """
    loop = LanesLoop(module, name, rate, (*slopes(tableau)[1:], "probe", "new"), guarded, series)
    (_write_fixed if tableau.error is None else _write_adaptive)(loop, tableau)
    loop.builder.branch(loop.again)


def _write_adaptive(loop: LanesLoop, tableau: Tableau) -> None:
    """A rejected lane tries again while its neighbours go on."""
    b, control = loop.builder, adaptive_control(tableau)
    _begin_gate(loop, "y", "probe")
    _first_stage(loop, control)
    step = _step_until_knot(loop)
    running = loop.running()
    stages(loop, tableau, step.time, step.h)
    loop.count("evaluations", running, float(tableau.own))
    norm = LaneNorm(loop, loop.guarded // 2) if loop.series or loop.rate.sampled else None
    error = error_of(loop, tableau, step.h, norm, ahead=not loop.series)
    size = _size(loop, error)
    good = b.fcmp_ordered("<=", error, loop.constant(1.0))
    _reject(loop, control, b.and_(running, b.not_(good)), step.h, size)
    good = b.and_(running, good)
    inside = loop.within_bounds("new")
    loop.end_where(b.and_(good, b.not_(inside)), Status.DIVERGED)
    accepted = _meet_gate(loop, step.h, b.and_(good, inside))
    loop.put("errors", b.fadd(loop.get("errors"), error), accepted)
    with due_samples(loop, accepted, step.time_after) as (due, wanted):
        weights = interpolation(loop, tableau, b.fdiv(b.fsub(wanted, step.time), step.h), step.h)
        write_sample(loop, due, wanted, lambda i: loop.weighted(weights, i))
    _accept(loop, control, slopes(tableau)[-1], accepted, step, size)


def _first_stage(loop: LanesLoop, control: StepControl) -> None:
    """k1 where the last step did not leave it, and the first step's length."""
    b, zero = loop.builder, loop.constant(0.0)
    fresh = b.and_(loop.running(), b.fcmp_ordered("!=", loop.get("fresh"), zero))
    with b.if_then(loop.any(fresh), likely=False):
        loop.evaluate(loop.get("t"), "y", "probe")
        loop.copy_where(fresh, "k1", "probe")
        loop.count("evaluations", fresh)
        loop.put("fresh", zero, fresh)
        first = b.and_(fresh, b.fcmp_ordered("<=", loop.get("h"), zero))
        with b.if_then(loop.any(first), likely=False):
            loop.put("h", first_length(loop, control.order, partial(_power, loop)), first)
            loop.count("evaluations", first)


def _power(loop: LanesLoop, base: Any, exponent: float) -> Any:
    size = loop.builder.fmul(loop.constant(exponent), logarithm(loop.builder, loop.lanes, base))
    return exponential(loop.builder, loop.lanes, size)


def _step_until_knot(loop: LanesLoop) -> AdaptiveStep:
    """Each lane's step: its length is zero where it idles."""
    b, time, wanted, end = loop.builder, loop.get("t"), loop.get("h"), loop.get("end")
    last = b.fcmp_ordered(">=", b.fadd(time, b.fmul(loop.constant(1.0001), wanted)), end)
    h = b.select(last, b.fsub(end, time), wanted)
    smallest = b.fmul(loop.constant(4e-15), loop.intrinsic("fabs", end))
    loop.end_where(b.not_(b.fcmp_ordered(">", h, smallest)), Status.STEP_TOO_SMALL)
    h = b.select(loop.running(), h, loop.constant(0.0))
    return AdaptiveStep(time, wanted, h, last, b.select(last, end, b.fadd(time, h)))


def _size(loop: LanesLoop, error: Any) -> Any:
    """Logarithm of the error to base 2, between those of 1e-10 and of what is as good as infinite or no number."""
    b, huge = loop.builder, loop.constant(1e300)
    error = b.select(b.fcmp_ordered("<", error, huge), error, huge)
    return logarithm(b, loop.lanes, loop.intrinsic("maxnum", error, loop.constant(1e-10)))


def _reject(loop: LanesLoop, control: StepControl, rejected: Any, h: Any, size: Any) -> None:
    """Shorter steps; where the error is not a number, the shortest. ``size``: logarithm of the error."""
    b = loop.builder
    power = b.fsub(loop.constant(math.log2(control.safety)), b.fmul(loop.constant(control.exponent), size))
    factor = loop.intrinsic("maxnum", exponential(b, loop.lanes, power), loop.constant(control.smallest))
    loop.put("h", b.fmul(h, factor), rejected)
    loop.count("rejected", rejected)


def _accept(loop: LanesLoop, control: StepControl, end: str, accepted: Any, step: AdaptiveStep, size: Any) -> None:
    """Take a step in the accepted lanes; ``end``: the slope at its end."""
    b = loop.builder
    before = b.fmul(loop.constant(control.beta), loop.get("old_error"))
    wish = b.fadd(loop.constant(math.log2(control.safety)), before)
    factor = exponential(b, loop.lanes, b.fsub(wish, b.fmul(loop.constant(control.exponent), size)))
    factor = loop.intrinsic("maxnum", factor, loop.constant(control.smallest))
    grown = b.fmul(step.h, loop.intrinsic("minnum", factor, loop.constant(control.largest)))
    # A step cut short by a knot says little about the next: keep the longer wish.
    loop.put("h", b.select(step.last, loop.intrinsic("maxnum", grown, step.wanted), grown), accepted)
    loop.put("old_error", loop.intrinsic("maxnum", size, loop.constant(math.log2(1e-4))), accepted)
    loop.copy_where(accepted, "k1", end)
    loop.put("fresh", loop.constant(1.0), loop.take(accepted, step.time_after, step.last))


def _write_fixed(loop: LanesLoop, tableau: Tableau) -> None:
    """Each lane parts its own segments into equal steps not longer than the option ``step``.

    Samples on a step's end are its result; those between come from Hermite's polynomial.
    """
    _begin_gate(loop, "y", "probe")
    b, step, end = loop.builder, next_step(loop), slopes(tableau)[-1]
    running = loop.running()
    loop.put("h", step.h, running)
    loop.evaluate(step.time, "y", "k1")
    stages(loop, tableau, step.time, step.h)
    loop.count("evaluations", running, float(tableau.own))
    inside = loop.within_bounds("new")
    loop.end_where(b.not_(inside), Status.DIVERGED)
    taken = b.and_(running, inside)
    if loop.rate.changes:
        loop.evaluate(step.time_after, "new", end)
        loop.count("evaluations", running)
        taken = _meet_gate(loop, step.h, taken, "cut")
        loop.put("cut", step.longest, taken)
    with due_samples(loop, taken, b.fadd(step.time_after, b.fmul(step.h, loop.constant(1e-9)))) as (due, wanted):
        share = b.fdiv(b.fsub(wanted, step.time), step.h)
        between = b.fcmp_ordered("<", share, loop.constant(1 - 1e-9))
        with b.if_then(loop.any(b.and_(due, between)), likely=False):
            loop.evaluate(step.time_after, "new", end)
            loop.count("evaluations", b.and_(due, between))
        weights = hermite(loop, share, step.h, end)
        write_sample(loop, due, wanted, lambda i: b.select(between, loop.weighted(weights, i), loop.load("new", i)))
    loop.put("index", b.select(step.last, loop.constant(0.0), step.count), taken)
    loop.take(taken, step.time_after, step.last)


def _begin_gate(loop: LanesLoop, state: str, into: str) -> None:
    """The gates at the start of the first steps of a call, which all lanes take together; then they are known."""
    if loop.rate.gate_offset is None:
        return
    b = loop.builder
    unknown = b.fcmp_ordered("==", loop.get("gate_known"), loop.constant(0.0))
    with b.if_then(loop.any(unknown), likely=False):
        loop.evaluate(loop.get("t"), state, into)  # not counted: how often a loop is called must not be seen
        _keep(loop, unknown)
        loop.put("gate_known", loop.constant(1.0))


def _keep(loop: LanesLoop, where: Any) -> None:
    for label, value in zip(loop.gates, gate_numbers(loop), strict=True):
        loop.put(label, value, where)


def _meet_gate(loop: LanesLoop, h: Any, accepted: Any, length: str = "h") -> Any:
    """Of the accepted lanes those whose gate did not change too early; the others try again with a shorter step.

    ``length``: the cell for that of a step. A lane whose gate changes too often is over.
    """
    if loop.rate.gate_offset is None:
        return accepted
    b = loop.builder
    changed, missed, shorter = gate_change(loop, [loop.get(label) for label in loop.gates], h)
    missed = b.and_(accepted, missed)
    loop.put(length, shorter, missed)
    loop.count("rejected", missed)
    met = b.and_(accepted, b.not_(missed))
    changed = b.and_(met, changed)
    with b.if_then(loop.any(changed), likely=False):
        _count(loop, changed)
    calm = b.fcmp_ordered("<=", loop.get("burst"), loop.option("most_events"))
    loop.end_where(b.and_(met, b.not_(calm)), Status.CHATTERING)
    met = b.and_(met, calm)
    _keep(loop, met)
    return met


def _count(loop: LanesLoop, changed: Any) -> None:
    """Count the changes of each lane, also among those that came within a short time."""
    b, time = loop.builder, loop.get("t")
    loop.count("events", changed)
    later = b.fcmp_ordered(">", b.fsub(time, loop.get("burst_time")), loop.option("event_time"))
    loop.put("burst", loop.constant(0.0), b.and_(changed, later))
    loop.put("burst_time", time, b.and_(changed, later))
    loop.count("burst", changed)
