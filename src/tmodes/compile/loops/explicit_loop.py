"""Any explicit Runge-Kutta method as a native loop, from its tableau: adaptive, or with a fixed step."""

from __future__ import annotations

from typing import Any

from tmodes.compile.ir.block import ScheduleRate
from tmodes.compile.ir.emit import counted, number, store
from tmodes.compile.loops.frame import Frame, MotionNorm
from tmodes.compile.loops.step_control import (
    ExplicitMethod,
    FixedGate,
    StepControl,
    StiffnessTest,
    next_step,
    take_step,
)
from tmodes.compile.loops.time_loop import Status, TimeLoop
from tmodes.integrate.method import Tableau

__all__ = ["adaptive_control", "error_of", "hermite", "interpolation", "slopes", "stages", "write_explicit_loop"]

_LASTS = 100.0
"""Samples within which what an error of a rate moves counts: by then a law has made up for it."""


def write_explicit_loop(
    module: Any, name: str, lowered: ScheduleRate, guarded: int, tableau: Tableau, *, motion: bool = False
) -> None:
    """Write the loop of a method: adaptive where it has an embedded error, else with the option ``step``.

    ``motion``: steps are as long as errors of the motion allow.
    """
    if tableau.error is None:
        _write_fixed(module, name, lowered, guarded, tableau)
    else:
        _write_adaptive(module, name, lowered, guarded, tableau, motion=motion)


def slopes(tableau: Tableau) -> tuple[str, ...]:
    """The arrays of the slopes of all stages."""
    return tuple(f"k{stage + 1}" for stage in range(tableau.stages))


def stages(loop: Frame, tableau: Tableau, time: Any, h: Any) -> None:
    """The stages of a step from ``y`` to ``new``, whose first slope is known.

    The slope at the step's end is evaluated where the error needs it.
    """
    b, names, last = loop.builder, slopes(tableau), tableau.own
    for stage in range(1, tableau.stages):
        into = "new" if stage == last else "probe"
        weights = {names[j]: b.fmul(h, loop.constant(a)) for j, a in enumerate(tableau.a[stage]) if a}
        loop.combine(into, weights)
        if stage < last or tableau.error is not None:
            loop.evaluate(b.fadd(time, b.fmul(loop.constant(tableau.c[stage]), h)), into, names[stage])


def adaptive_control(tableau: Tableau) -> StepControl:
    """How the error of a step of a method gives the length of the next."""
    order = 0  # the conditions of quadrature that the weights of the error meet
    while order < 12 and abs(sum(w * c**order for w, c in zip(tableau.error or (), tableau.c, strict=True))) < 1e-12:
        order += 1
    return StepControl(order + 1.0, tableau.beta, 0.75, tableau.smallest, tableau.largest, tableau.safety)


def error_of(loop: Frame, tableau: Tableau, h: Any, norm: MotionNorm | None = None, *, ahead: bool = False) -> Any:
    """The error of a step over its tolerance: component by component, or by a ``norm`` of motions.

    ``ahead``: of a rate that norm counts what it moves within the next samples, not within the step.
    """
    b = loop.builder

    def difference(i: Any) -> Any:
        total = loop.constant(0.0)
        for stage, weight in zip(slopes(tableau), tableau.error or (), strict=True):
            if weight:
                total = b.fadd(total, b.fmul(loop.constant(weight), loop.load(stage, i)))
        return b.fmul(h, total)

    if norm is None:
        return loop.mean_square(difference, "y", "new")
    start, end = loop.segment()
    moves = b.fmul(loop.constant(_LASTS), b.fsub(end, start)) if ahead else h
    return norm.of_error(difference, "new", "y", moves)


def interpolation(loop: Frame, tableau: Tableau, s: Any, h: Any) -> dict[str, Any]:
    """Weights of arrays in the state at the share s of a step, by the method's own polynomial or Hermite's."""
    if tableau.dense is None:
        return hermite(loop, s, h, slopes(tableau)[-1])
    b = loop.builder

    def value_of(row: tuple[float, ...]) -> Any:
        value = loop.constant(0.0)
        for coefficient in reversed(row):
            value = b.fmul(s, b.fadd(loop.constant(coefficient), value))
        return value

    rows = zip(slopes(tableau), tableau.dense, strict=True)
    return {"y": None} | {stage: b.fmul(h, value_of(row)) for stage, row in rows if any(row)}


def hermite(loop: Frame, s: Any, h: Any, end: str) -> dict[str, Any]:
    """Weights of both ends and their slopes (``end``: that at the end) at the share s of a step of length h."""
    b, one, two = loop.builder, loop.constant(1.0), loop.constant(2.0)
    rest = b.fsub(one, s)
    s2, rest2 = b.fmul(s, s), b.fmul(rest, rest)
    return {
        "y": b.fmul(rest2, b.fadd(one, b.fmul(two, s))),
        "new": b.fmul(s2, b.fadd(one, b.fmul(two, rest))),
        "k1": b.fmul(b.fmul(h, s), rest2),
        end: b.fneg(b.fmul(b.fmul(h, rest), s2)),
    }


def _write_adaptive(
    module: Any, name: str, lowered: ScheduleRate, guarded: int, tableau: Tableau, *, motion: bool
) -> None:
    """Steps end exactly on the knots, where the first stage is evaluated again.

    Where controllers sample, knots are their samples, and commands with noise shake what hardly moves: errors of rates
    count by what they move within the next samples.
    """
    names = slopes(tableau)
    loop = TimeLoop(module, name, lowered, (*names[1:], "probe", "new"), guarded)
    test = StiffnessTest((names[-1], names[-2]), ("new", "probe"), *tableau.stiff) if tableau.stiff else None
    method = ExplicitMethod(adaptive_control(tableau), test, names[-1])
    gate, step = method.begin(loop)
    stages(loop, tableau, step.time, step.h)
    norm = MotionNorm(loop, guarded // 2) if motion or lowered.sampled else None
    b, error = loop.builder, error_of(loop, tableau, step.h, norm, ahead=not motion)

    def write() -> None:
        with loop.due_samples(step.time_after) as target:
            share = b.fdiv(b.fsub(loop.sample_time(), step.time), step.h)
            _write_row(loop, target, interpolation(loop, tableau, share, step.h))

    method.end_with(loop, gate, step, error, write)


def _write_row(loop: TimeLoop, target: Any, weights: dict[str, Any]) -> None:
    with counted(loop.builder, loop.size) as i:
        store(loop.builder, loop.weighted(weights, i), target, i)


def _write_fixed(module: Any, name: str, lowered: ScheduleRate, guarded: int, tableau: Tableau) -> None:
    """Samples between steps come from the cubic Hermite polynomial, whose error is of order 4."""
    names = slopes(tableau)
    loop = TimeLoop(module, name, lowered, (*names[1:], "probe", "new"), guarded)
    b, gate = loop.builder, FixedGate(loop)
    gate.begin("y", "probe")
    step = next_step(loop)
    loop.evaluate(step.time, "y", names[0])
    stages(loop, tableau, step.time, step.h)
    gate.end(step, names[-1])
    loop.stop_if(b.not_(loop.within_bounds("new")), Status.DIVERGED)
    with loop.due_samples(b.fadd(step.time_after, b.fmul(step.h, number(1e-9))), step.time_after) as target:
        share = b.fdiv(b.fsub(loop.sample_time(), step.time), step.h)
        with b.if_else(b.fcmp_ordered("<", share, number(1 - 1e-9))) as (between, exact):
            with between:
                loop.evaluate(step.time_after, "new", names[-1])
                _write_row(loop, target, hermite(loop, share, step.h, names[-1]))
            with exact:
                _write_row(loop, target, {"new": None})
    take_step(loop, step)
