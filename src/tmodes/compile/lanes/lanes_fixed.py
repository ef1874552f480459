"""Any explicit Runge-Kutta method with a fixed step over runs side by side.

The method is that of :mod:`tmodes.compile.loops.explicit_loop`.
"""

from __future__ import annotations

from typing import Any

from tmodes.compile.ir.block import ScheduleRate
from tmodes.compile.ir.lower import Lowered
from tmodes.compile.lanes.lanes_loop import LanesLoop
from tmodes.compile.lanes.lanes_samples import due_samples, write_sample
from tmodes.compile.loops.explicit_loop import hermite, slopes, stages
from tmodes.compile.loops.time_loop import Status
from tmodes.integrate.method import Tableau

__all__ = ["write_lanes_fixed"]


def write_lanes_fixed(module: Any, name: str, rate: Lowered | ScheduleRate, guarded: int, tableau: Tableau) -> None:
    """Write the loop; each lane parts its own segments into equal steps not longer than the option ``step``."""
    loop = LanesLoop(module, name, rate, (*slopes(tableau)[1:], "probe", "new"), guarded)
    b = loop.builder
    count, h = _equal_steps(loop)
    time, running = loop.get("t"), loop.running()
    after = b.fadd(loop.get("index"), loop.constant(1.0))
    last = b.fcmp_ordered(">=", after, count)
    time_after = b.select(last, loop.get("end"), b.fadd(loop.get("start"), b.fmul(after, h)))
    loop.put("h", h, running)
    loop.evaluate(time, "y", "k1")
    stages(loop, tableau, time, h, loop.constant)
    loop.count("evaluations", running, float(tableau.own))
    inside = loop.within_bounds("new")
    loop.end_where(b.not_(inside), Status.DIVERGED)
    taken = b.and_(running, inside)
    _write_samples(loop, slopes(tableau)[-1], taken, time, h, time_after)
    _take(loop, taken, after, last, time_after)
    b.branch(loop.again)


def _equal_steps(loop: LanesLoop) -> tuple[Any, Any]:
    """Steps of each lane's segment, and their length."""
    b: Any = loop.builder
    length = b.fsub(loop.get("end"), loop.get("start"))
    ratio = b.fmul(b.fdiv(length, loop.option("step")), loop.constant(1 - 1e-12))
    count = loop.call("maxnum", loop.call("ceil", ratio), loop.constant(1.0))
    return count, b.fdiv(length, count)


def _take(loop: LanesLoop, taken: Any, after: Any, last: Any, time_after: Any) -> None:
    b: Any = loop.builder
    loop.copy_where(taken, "y", "new")
    loop.put("t", time_after, taken)
    loop.count("steps", taken)
    loop.put("index", b.select(last, loop.constant(0.0), after), taken)
    over = b.and_(taken, last)
    loop.count("segment", over)
    with b.if_then(loop.any(over), likely=False):
        loop.enter_segments()


def _write_samples(loop: LanesLoop, end: str, taken: Any, time: Any, h: Any, time_after: Any) -> None:
    """Samples on a step's end are its result; those between come from Hermite's polynomial."""
    b: Any = loop.builder
    with due_samples(loop, taken, b.fadd(time_after, b.fmul(h, loop.constant(1e-9)))) as (due, wanted):
        share = b.fdiv(b.fsub(wanted, time), h)
        between = b.fcmp_ordered("<", share, loop.constant(1 - 1e-9))
        with b.if_then(loop.any(b.and_(due, between)), likely=False):
            loop.evaluate(time_after, "new", end)
            loop.count("evaluations", b.and_(due, between))
        weights = hermite(b, share, h, loop.constant(1.0), loop.constant(2.0), end)

        def value_of(i: Any) -> Any:
            total: Any = loop.constant(0.0)
            for label, weight in weights.items():
                total = b.fadd(total, b.fmul(weight, loop.load(label, i)))
            return b.select(between, total, loop.load("new", i))

        write_sample(loop, due, value_of)
