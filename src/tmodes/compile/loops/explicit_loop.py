"""Any explicit Runge-Kutta method as a native loop, from its tableau: adaptive, or with a fixed step."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from tmodes.compile.ir.block import ScheduleRate
from tmodes.compile.ir.emit import counted, load, number, store
from tmodes.compile.ir.lower import Lowered
from tmodes.compile.loops.step_control import ExplicitMethod, StepControl, mean_square, next_step, take_step
from tmodes.compile.loops.stiffness import StiffnessTest
from tmodes.compile.loops.time_loop import Status, TimeLoop
from tmodes.integrate.method import Tableau

__all__ = ["adaptive_control", "dense_weights", "hermite", "slopes", "stages", "write_explicit_loop"]


def write_explicit_loop(
    module: Any, name: str, lowered: Lowered | ScheduleRate, guarded: int, tableau: Tableau
) -> None:
    """Write the loop of a method: adaptive where it has an embedded error, else with the option ``step``."""
    (_write_fixed if tableau.error is None else _write_adaptive)(module, name, lowered, guarded, tableau)


def slopes(tableau: Tableau) -> tuple[str, ...]:
    """The arrays of the slopes of all stages."""
    return tuple(f"k{stage + 1}" for stage in range(tableau.stages))


def stages(loop: Any, tableau: Tableau, time: Any, h: Any, constant: Callable[[float], Any]) -> None:
    """The stages of a step from ``y`` to ``new``, whose first slope is known, in a loop of doubles or of lanes.

    The slope at the step's end is evaluated where the error needs it. ``constant`` gives a number of the loop's kind.
    """
    b, names, last = loop.builder, slopes(tableau), tableau.own
    for stage in range(1, tableau.stages):
        into = "new" if stage == last else "probe"
        weights = {names[j]: b.fmul(h, constant(a)) for j, a in enumerate(tableau.a[stage]) if a}
        loop.combine(into, weights)
        if stage < last or tableau.error is not None:
            loop.evaluate(b.fadd(time, b.fmul(constant(tableau.c[stage]), h)), into, names[stage])


def _write_adaptive(module: Any, name: str, lowered: Lowered | ScheduleRate, guarded: int, tableau: Tableau) -> None:
    """Steps end exactly on the knots, where the first stage is evaluated again."""
    names = slopes(tableau)
    loop = TimeLoop(module, name, lowered, (*names[1:], "probe", "new", "local"), guarded)
    method = _method(tableau)
    gate, step = method.begin(loop, lowered.gate_offset)
    time, h = step.time, step.h
    stages(loop, tableau, time, h, number)
    errors = _error(loop, tableau, h), number(1.0)
    method.end_with(loop, gate, step, errors, lambda: _write_samples(loop, tableau, time, h, step.time_after))


def _method(tableau: Tableau) -> ExplicitMethod:
    names, test = slopes(tableau), None
    if tableau.stiff:
        test = StiffnessTest((names[-1], names[-2]), ("new", "probe"), *tableau.stiff)
    return ExplicitMethod(adaptive_control(tableau), test, names[-1])


def adaptive_control(tableau: Tableau) -> StepControl:
    """How the error of a step of a method gives the length of the next."""
    order = float(_order(tableau))
    return StepControl(order, tableau.beta, 0.75, tableau.smallest, tableau.largest, tableau.safety)


def _order(tableau: Tableau) -> int:
    """By which power of the step its local error goes: the conditions of quadrature that its weights meet."""
    order = 0
    while order < 12 and abs(sum(w * c**order for w, c in zip(tableau.error or (), tableau.c, strict=True))) < 1e-12:
        order += 1
    return order + 1


def _error(loop: TimeLoop, tableau: Tableau, h: Any) -> Any:
    b = loop.builder

    def difference(i: Any) -> Any:
        total: Any = number(0.0)
        for stage, weight in zip(slopes(tableau), tableau.error or (), strict=True):
            if weight:
                total = b.fadd(total, b.fmul(number(weight), load(b, loop.array[stage], i)))
        error = b.fmul(h, total)
        store(b, error, loop.array["local"], i)
        return error

    return mean_square(loop, difference, "y", "new")


def _write_samples(loop: TimeLoop, tableau: Tableau, time: Any, h: Any, time_after: Any) -> None:
    b = loop.builder
    with loop.due_samples(time_after) as target:
        share = b.fdiv(b.fsub(loop.sample_time(), time), h)
        if tableau.dense is None:
            _write_row(loop, target, hermite(b, share, h, number(1.0), number(2.0), slopes(tableau)[-1]))
            return
        weights = dense_weights(b, tableau, share, h, number)
        with counted(b, loop.size) as i:
            value = load(b, loop.array["y"], i)
            for stage, weight in weights.items():
                value = b.fadd(value, b.fmul(weight, load(b, loop.array[stage], i)))
            store(b, value, target, i)


def dense_weights(b: Any, tableau: Tableau, s: Any, h: Any, constant: Callable[[float], Any]) -> dict[str, Any]:
    """Weights of the slopes in the state at the share s of a step, by the method's own polynomial."""

    def value_of(row: tuple[float, ...]) -> Any:
        value: Any = constant(0.0)
        for coefficient in reversed(row):
            value = b.fmul(s, b.fadd(constant(coefficient), value))
        return value

    rows = zip(slopes(tableau), tableau.dense or (), strict=True)
    return {stage: b.fmul(h, value_of(row)) for stage, row in rows if any(row)}


def _write_fixed(module: Any, name: str, lowered: Lowered | ScheduleRate, guarded: int, tableau: Tableau) -> None:
    """Each segment is divided into equal steps not longer than the option ``step``.

    Samples between steps come from the cubic Hermite polynomial, whose error is of order 4.
    """
    names = slopes(tableau)
    loop = TimeLoop(module, name, lowered, (*names[1:], "probe", "new"), guarded)
    b = loop.builder
    step = next_step(loop)
    loop.evaluate(step.time, "y", names[0])
    stages(loop, tableau, step.time, step.h, number)
    loop.stop_if(b.not_(loop.within_bounds("new")), Status.DIVERGED)
    with loop.due_samples(b.fadd(step.time_after, b.fmul(step.h, number(1e-9))), step.time_after) as target:
        _write_fixed_sample(loop, target, step.time, step.h, step.time_after, names[-1])
    take_step(loop, step)


def _write_fixed_sample(loop: TimeLoop, target: Any, time: Any, h: Any, time_after: Any, end: str) -> None:
    b = loop.builder
    share = b.fdiv(b.fsub(loop.sample_time(), time), h)
    inside = b.fcmp_ordered("<", share, number(1 - 1e-9))
    exact, between, written = loop.block("sample_exact"), loop.block("sample_between"), loop.block("sample_written")
    b.cbranch(inside, between, exact)
    b.position_at_end(exact)
    _write_row(loop, target, {"new": number(1.0)})
    b.branch(written)
    b.position_at_end(between)
    loop.evaluate(time_after, "new", end)
    _write_row(loop, target, hermite(b, share, h, number(1.0), number(2.0), end))
    b.branch(written)
    b.position_at_end(written)


def hermite(b: Any, s: Any, h: Any, one: Any, two: Any, end: str) -> dict[str, Any]:
    """Weights of both ends and their slopes (``end``: that at the end) at the share s of a step of length h."""
    rest = b.fsub(one, s)
    s2, rest2 = b.fmul(s, s), b.fmul(rest, rest)
    return {
        "y": b.fmul(rest2, b.fadd(one, b.fmul(two, s))),
        "new": b.fmul(s2, b.fadd(one, b.fmul(two, rest))),
        "k1": b.fmul(b.fmul(h, s), rest2),
        end: b.fneg(b.fmul(b.fmul(h, rest), s2)),
    }


def _write_row(loop: TimeLoop, target: Any, weights: dict[str, Any]) -> None:
    b = loop.builder
    with counted(b, loop.size) as i:
        total: Any = number(0.0)
        for label, weight in weights.items():
            total = b.fadd(total, b.fmul(weight, load(b, loop.array[label], i)))
        store(b, total, target, i)
