"""Dormand and Prince's method of order 8(5,3) with dense output of order 7, adaptive, as a native loop.

Method, error estimate and step control as in the code of E. Hairer and G. Wanner (:mod:`tmodes.integrate.dop853`). The
three stages that only the dense output needs are taken where a sample lies in the step.
"""

from __future__ import annotations

from typing import Any

from tmodes.compile.ir.block import ScheduleRate
from tmodes.compile.ir.emit import F64, counted, number, store
from tmodes.compile.loops.gate import Gate
from tmodes.compile.loops.step_control import ExplicitMethod, StepControl, StiffnessTest
from tmodes.compile.loops.time_loop import AdaptiveStep, TimeLoop
from tmodes.integrate.dop853 import DENSE, ERROR_3, ERROR_5, STAGES, A, C

__all__ = ["write_dop853_loop"]

_DENSE = 10.0
"""How far the last term of the dense output may reach beyond the tolerance of a step."""

_LAST_TERM = (4 / 7) ** 4 * (3 / 7) ** 3
"""Largest value of s^4 r^3."""

_CONTROL = StepControl(order=8.0, beta=0.0, damping=0.2, smallest=1 / 3, largest=6.0)
_K = tuple(f"k{stage + 1}" for stage in range(len(A)))
_END = _K[STAGES]
_STIFFNESS = StiffnessTest(slopes=(_END, _K[STAGES - 1]), states=("new", "probe"), limit=6.1, ringing=5.9)
_METHOD = ExplicitMethod(_CONTROL, _STIFFNESS, _END)


def write_dop853_loop(module: Any, name: str, lowered: ScheduleRate, guarded: int) -> None:
    """Write the loop: steps end exactly on the knots, where the first stage is evaluated again."""
    loop = TimeLoop(module, name, lowered, (*_K[1:], "probe", "new", "between"), guarded)
    gate, step = _METHOD.begin(loop)
    time, h = step.time, step.h
    for stage in range(1, STAGES + 1):
        # The last two states stay where the test of stiffness finds them: "probe" and "new".
        _stage(loop, stage, time, h, "new" if stage == STAGES else "probe")
    error = _with_dense_error(loop, gate, _error(loop, h), step)
    _METHOD.end_with(loop, gate, step, error, lambda: _write_samples(loop, time, h, step.time_after))


def _stage(loop: TimeLoop, stage: int, time: Any, h: Any, state: str) -> None:
    b = loop.builder
    loop.combine(state, {_K[j]: b.fmul(h, number(weight)) for j, weight in A[stage].items()})
    loop.evaluate(b.fadd(time, b.fmul(number(C[stage]), h)), state, _K[stage])


def _weighted(loop: TimeLoop, i: Any, weights: dict[int, float]) -> Any:
    b = loop.builder
    total: Any = number(0.0)
    for stage, weight in weights.items():
        total = b.fadd(total, b.fmul(number(weight), loop.load(_K[stage], i)))
    return total


def _error(loop: TimeLoop, h: Any) -> Any:
    """The error h e5^2 / sqrt(e5^2 + e3^2/100)."""
    b: Any = loop.builder
    e5 = loop.mean_square(lambda i: _weighted(loop, i, ERROR_5), "y", "new")
    e3 = loop.mean_square(lambda i: _weighted(loop, i, ERROR_3), "y", "new")
    both = b.fadd(b.fmul(e5, e5), b.fmul(number(0.01), b.fmul(e3, e3)))
    share = b.select(b.fcmp_ordered("==", both, number(0.0)), number(0.0), b.fdiv(e5, loop.intrinsic("sqrt", both)))
    return b.fmul(b.fmul(h, e5), share)


def _with_dense_error(loop: TimeLoop, gate: Gate, error: Any, step: AdaptiveStep) -> Any:
    """The larger of the step's error and, where a sample lies in it, that of the polynomial between its ends.

    Takes the stages of the polynomial; what the gate reads is that of the end again after them. Fast
    motions that are stable but not followed (step times eigenvalue near the limit) leave the ends of a step untouched
    and not what lies between; its last term shows it.
    """
    b: Any = loop.builder
    _, _, h, _, time_after = step
    worst = loop.local("worst")
    b.store(error, worst)
    with b.if_then(loop.sample_due(time_after)):
        for stage in range(STAGES + 1, len(A)):
            _stage(loop, stage, step.time, h, "between")
        if gate.exists:
            loop.evaluate(time_after, "new", _END)
        largest = b.fmul(h, number(_LAST_TERM / _DENSE))
        dense = loop.mean_square(lambda i: b.fmul(largest, _weighted(loop, i, DENSE[-1])), "y", "new")
        b.store(loop.intrinsic("maxnum", error, dense), worst)
    return b.load(worst, typ=F64)


def _write_samples(loop: TimeLoop, time: Any, h: Any, time_after: Any) -> None:
    b: Any = loop.builder
    with loop.due_samples(time_after) as target:
        change, weights = _dense(b, b.fdiv(b.fsub(loop.sample_time(), time), h), h)
        with counted(b, loop.size) as i:
            before = loop.load("y", i)
            value = b.fadd(before, b.fmul(change, b.fsub(loop.load("new", i), before)))
            for stage, weight in weights.items():
                value = b.fadd(value, b.fmul(weight, loop.load(_K[stage], i)))
            store(b, value, target, i)


def _dense(b: Any, s: Any, h: Any) -> tuple[Any, dict[int, Any]]:
    """Weights of the step's change and of each slope at the share s of a step."""
    r = b.fsub(number(1.0), s)
    powers = [s]
    for factor in (r, s, r, s, r, s):
        powers.append(b.fmul(powers[-1], factor))
    twice = b.fmul(number(2.0), powers[2])
    change = b.fadd(b.fsub(powers[0], powers[1]), twice)
    weights = {0: b.fsub(powers[1], powers[2]), STAGES: b.fneg(powers[2])}
    for factor, row in zip(powers[3:], DENSE, strict=True):
        for stage, number_of in row.items():
            term = b.fmul(factor, number(number_of))
            weights[stage] = b.fadd(weights[stage], term) if stage in weights else term
    return change, {stage: b.fmul(h, weight) for stage, weight in sorted(weights.items())}
