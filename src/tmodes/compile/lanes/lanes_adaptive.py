"""Any adaptive explicit Runge-Kutta method over runs side by side, each with steps of its own.

The method is that of :mod:`tmodes.compile.loops.explicit_loop`.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

from tmodes.compile.ir.block import ScheduleRate
from tmodes.compile.ir.emit import counted
from tmodes.compile.ir.lower import Lowered
from tmodes.compile.lanes.lanes_gate import LanesGate
from tmodes.compile.lanes.lanes_loop import LanesLoop
from tmodes.compile.lanes.lanes_power import exponential, logarithm
from tmodes.compile.lanes.lanes_samples import due_samples, write_sample
from tmodes.compile.loops.explicit_loop import adaptive_control, dense_weights, hermite, slopes, stages
from tmodes.compile.loops.step_control import StepControl
from tmodes.compile.loops.time_loop import Status
from tmodes.integrate.method import Tableau

__all__ = ["write_lanes_adaptive"]


def write_lanes_adaptive(module: Any, name: str, rate: Lowered | ScheduleRate, guarded: int, tableau: Tableau) -> None:
    """Write the loop; a rejected lane tries again while its neighbours go on."""
    loop = LanesLoop(module, name, rate, (*slopes(tableau)[1:], "probe", "new"), guarded)
    control = adaptive_control(tableau)
    b = loop.builder
    gate = LanesGate(loop, rate.gate_offset)
    gate.begin("y", "probe")
    _first_stage(loop)
    time, wanted = loop.get("t"), loop.get("h")
    h, last, time_after = _step_until_knot(loop)
    running = loop.running()
    stages(loop, tableau, time, h, loop.constant)
    loop.count("evaluations", running, float(tableau.own))
    error = _error(loop, tableau, h)
    size = _size(loop, error)
    good = b.fcmp_ordered("<=", error, loop.constant(1.0))
    _reject(loop, control, b.and_(running, b.not_(good)), h, size)
    good = b.and_(running, good)
    inside = loop.within_bounds("new")
    loop.end_where(b.and_(good, b.not_(inside)), Status.DIVERGED)
    accepted = gate.meet(h, b.and_(good, inside))
    _write_samples(loop, tableau, accepted, time, h, time_after)
    _accept(loop, control, slopes(tableau)[-1], accepted, (wanted, h, last, time_after), size)
    b.branch(loop.again)


def _first_stage(loop: LanesLoop) -> None:
    """k1 where the last step did not leave it, and the first step's length (Hairer's rule of a hundredth)."""
    b: Any = loop.builder
    zero = loop.constant(0.0)
    fresh = b.and_(loop.running(), b.fcmp_ordered("!=", loop.get("fresh"), zero))
    with b.if_then(loop.any(fresh), likely=False):
        loop.evaluate(loop.get("t"), "y", "probe")
        loop.copy_where(fresh, "k1", "probe")
        loop.count("evaluations", fresh)
        loop.put("fresh", zero, fresh)
        state, slope = (_mean_square(loop, lambda i, a=a: loop.load(a, i), "y") for a in ("y", "k1"))
        least = loop.constant(1e-5)
        moving = b.and_(b.fcmp_ordered(">", state, least), b.fcmp_ordered(">", slope, least))
        guess = b.fmul(loop.constant(0.01), b.fdiv(state, slope))
        guess = b.select(moving, guess, loop.constant(1e-6))
        guess = loop.call("minnum", guess, b.fsub(loop.get("end"), loop.get("start")))
        loop.put("h", guess, b.and_(fresh, b.fcmp_ordered("<=", loop.get("h"), zero)))


def _step_until_knot(loop: LanesLoop) -> tuple[Any, Any, Any]:
    """Length of each lane's step, zero where it idles, whether it ends on a knot, and the time after it."""
    b: Any = loop.builder
    time, wanted, end = loop.get("t"), loop.get("h"), loop.get("end")
    last = b.fcmp_ordered(">=", b.fadd(time, b.fmul(loop.constant(1.0001), wanted)), end)
    h = b.select(last, b.fsub(end, time), wanted)
    smallest = b.fmul(loop.constant(4e-15), loop.call("fabs", end))
    loop.end_where(b.not_(b.fcmp_ordered(">", h, smallest)), Status.STEP_TOO_SMALL)
    h = b.select(loop.running(), h, loop.constant(0.0))
    return h, last, b.select(last, end, b.fadd(time, h))


def _mean_square(loop: LanesLoop, value_of: Callable[[Any], Any], *states: str) -> Any:
    """Root of the mean square of ``value_of(i)`` over the scale of each component."""
    b: Any = loop.builder
    absolute, relative = loop.option("atol"), loop.option("rtol")
    loop.put("total", loop.constant(0.0))
    with counted(b, loop.size) as i:
        largest: Any = loop.call("fabs", loop.load(states[0], i))
        for state in states[1:]:
            largest = loop.call("maxnum", largest, loop.call("fabs", loop.load(state, i)))
        ratio = b.fdiv(value_of(i), b.fadd(absolute, b.fmul(relative, largest)))
        loop.put("total", b.fadd(loop.get("total"), b.fmul(ratio, ratio)))
    return loop.call("sqrt", b.fdiv(loop.get("total"), loop.constant(float(loop.size))))


def _error(loop: LanesLoop, tableau: Tableau, h: Any) -> Any:
    b: Any = loop.builder

    def difference(i: Any) -> Any:
        total: Any = loop.constant(0.0)
        for stage, weight in zip(slopes(tableau), tableau.error or (), strict=True):
            if weight:
                total = b.fadd(total, b.fmul(loop.constant(weight), loop.load(stage, i)))
        return b.fmul(h, total)

    return _mean_square(loop, difference, "y", "new")


def _size(loop: LanesLoop, error: Any) -> Any:
    """Logarithm of the error to base 2, between those of 1e-10 and of what is as good as infinite or no number."""
    b, huge = loop.builder, loop.constant(1e300)
    error = b.select(b.fcmp_ordered("<", error, huge), error, huge)
    return logarithm(b, loop.lanes, loop.call("maxnum", error, loop.constant(1e-10)))


def _reject(loop: LanesLoop, control: StepControl, rejected: Any, h: Any, size: Any) -> None:
    """Shorter steps; where the error is not a number, the shortest. ``size``: logarithm of the error."""
    b: Any = loop.builder
    info = b.fsub(loop.constant(math.log2(control.safety)), b.fmul(loop.constant(control.exponent), size))
    factor = loop.call("maxnum", exponential(b, loop.lanes, info), loop.constant(control.smallest))
    loop.put("h", b.fmul(h, factor), rejected)
    loop.count("rejected", rejected)


def _accept(
    loop: LanesLoop, control: StepControl, end: str, accepted: Any, step: tuple[Any, Any, Any, Any], size: Any
) -> None:
    """Take a step (wanted and taken length, whether it ends on a knot, time after it); ``end``: the slope there."""
    b: Any = loop.builder
    wanted, h, last, time_after = step
    before = b.fmul(loop.constant(control.beta), loop.get("old_error"))
    info = b.fadd(loop.constant(math.log2(control.safety)), before)
    factor = exponential(b, loop.lanes, b.fsub(info, b.fmul(loop.constant(control.exponent), size)))
    factor = loop.call(
        "minnum", loop.call("maxnum", factor, loop.constant(control.smallest)), loop.constant(control.largest)
    )
    grown = b.fmul(h, factor)
    # A step cut short by a knot says little about the next: keep the longer wish.
    loop.put("h", b.select(last, loop.call("maxnum", grown, wanted), grown), accepted)
    loop.put("old_error", loop.call("maxnum", size, loop.constant(math.log2(1e-4))), accepted)
    loop.copy_where(accepted, "y", "new")
    loop.copy_where(accepted, "k1", end)
    loop.put("t", time_after, accepted)
    loop.count("steps", accepted)
    over = b.and_(accepted, last)
    loop.put("fresh", loop.constant(1.0), over)
    loop.count("segment", over)
    with b.if_then(loop.any(over), likely=False):
        loop.enter_segments()


def _write_samples(loop: LanesLoop, tableau: Tableau, accepted: Any, time: Any, h: Any, time_after: Any) -> None:
    b: Any = loop.builder
    with due_samples(loop, accepted, time_after) as (due, wanted):
        s = b.fdiv(b.fsub(wanted, time), h)
        if tableau.dense is None:
            weights = hermite(b, s, h, loop.constant(1.0), loop.constant(2.0), slopes(tableau)[-1])
        else:
            weights = {"y": None} | dense_weights(b, tableau, s, h, loop.constant)
        write_sample(loop, due, lambda i: _combined(loop, weights, i))


def _combined(loop: LanesLoop, weights: dict[str, Any], i: Any) -> Any:
    """The weighted sum of arrays; a weight None counts as 1."""
    b: Any = loop.builder
    value: Any = None
    for label, weight in weights.items():
        term = loop.load(label, i) if weight is None else b.fmul(weight, loop.load(label, i))
        value = term if value is None else b.fadd(value, term)
    return value
