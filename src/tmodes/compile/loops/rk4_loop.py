"""The classical Runge-Kutta method of order 4 at fixed step, as a native loop."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from tmodes.compile.ir.block import ScheduleRate
from tmodes.compile.ir.emit import counted, load, number, store
from tmodes.compile.ir.lower import Lowered
from tmodes.compile.loops.fixed_step import next_step, take_step
from tmodes.compile.loops.time_loop import Status, TimeLoop

__all__ = ["hermite", "runge_kutta_step", "write_rk4_loop"]


def write_rk4_loop(module: Any, name: str, lowered: Lowered | ScheduleRate, guarded: int) -> None:
    """Write the loop: each segment is parted into equal steps not longer than the option ``step``.

    Samples between steps come from the cubic Hermite polynomial, whose error is of the method's own order.
    """
    loop = TimeLoop(module, name, lowered, ("k2", "k3", "k4", "probe", "new"), guarded)
    b = loop.builder
    step = next_step(loop)
    runge_kutta_step(loop, step.time, step.h, number)
    loop.stop_if(b.not_(loop.within_bounds("new")), Status.DIVERGED)
    _write_samples(loop, step.time, step.h, step.time_after)
    take_step(loop, step)


def runge_kutta_step(loop: Any, time: Any, h: Any, constant: Callable[[float], Any]) -> None:
    """A step from ``y`` to ``new`` in a loop of doubles or of lanes; ``constant`` gives a number of its kind."""
    b = loop.builder
    half, sixth, third = (b.fmul(h, constant(share)) for share in (1 / 2, 1 / 6, 1 / 3))
    middle = b.fadd(time, half)
    loop.evaluate(time, "y", "k1")
    loop.combine("probe", {"k1": half})
    loop.evaluate(middle, "probe", "k2")
    loop.combine("probe", {"k2": half})
    loop.evaluate(middle, "probe", "k3")
    loop.combine("probe", {"k3": h})
    loop.evaluate(b.fadd(time, h), "probe", "k4")
    loop.combine("new", {"k1": sixth, "k2": third, "k3": third, "k4": sixth})


def _write_samples(loop: TimeLoop, time: Any, h: Any, time_after: Any) -> None:
    b = loop.builder
    with loop.due_samples(b.fadd(time_after, b.fmul(h, number(1e-9))), time_after) as target:
        _write_sample(loop, target, time, h, time_after)


def _write_sample(loop: TimeLoop, target: Any, time: Any, h: Any, time_after: Any) -> None:
    b = loop.builder
    share = b.fdiv(b.fsub(loop.sample_time(), time), h)
    inside = b.fcmp_ordered("<", share, number(1 - 1e-9))
    exact, between, written = loop.block("sample_exact"), loop.block("sample_between"), loop.block("sample_written")
    b.cbranch(inside, between, exact)
    b.position_at_end(exact)
    _write_row(loop, target, {"new": number(1.0)})
    b.branch(written)
    b.position_at_end(between)
    loop.evaluate(time_after, "new", "k4")
    _write_row(loop, target, hermite(b, share, h, number(1.0), number(2.0)))
    b.branch(written)
    b.position_at_end(written)


def hermite(b: Any, s: Any, h: Any, one: Any, two: Any) -> dict[str, Any]:
    """Weights of both ends and their slopes at the share s of a step of length h; ``one`` and ``two`` are constants."""
    rest = b.fsub(one, s)
    s2, rest2 = b.fmul(s, s), b.fmul(rest, rest)
    return {
        "y": b.fmul(rest2, b.fadd(one, b.fmul(two, s))),
        "new": b.fmul(s2, b.fadd(one, b.fmul(two, rest))),
        "k1": b.fmul(b.fmul(h, s), rest2),
        "k4": b.fneg(b.fmul(b.fmul(h, rest), s2)),
    }


def _write_row(loop: TimeLoop, target: Any, weights: dict[str, Any]) -> None:
    b = loop.builder
    with counted(b, loop.size) as i:
        total: Any = number(0.0)
        for label, weight in weights.items():
            total = b.fadd(total, b.fmul(weight, load(b, loop.array[label], i)))
        store(b, total, target, i)
