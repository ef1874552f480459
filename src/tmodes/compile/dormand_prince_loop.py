"""Dormand and Prince's pair of order 5(4) with dense output, adaptive, as a native loop.

Tableau: J. R. Dormand, P. J. Prince, J. Comp. Appl. Math. 6 (1980) 19-26; dense output of order 4: L. F. Shampine,
Math. Comp. 46 (1986) 135-150; step control (PI): E. Hairer, G. Wanner, Solving Ordinary Differential Equations, DOPRI5.
"""

from __future__ import annotations

from typing import Any

from tmodes.compile.block import ScheduleRate
from tmodes.compile.emit import F64, counted, declare, load, number, store
from tmodes.compile.gate import Gate
from tmodes.compile.lower import Lowered
from tmodes.compile.native import POWER
from tmodes.compile.time_loop import Status, TimeLoop

__all__ = [
    "BETA", "B_ERROR", "DENSE", "LARGEST", "SAFETY", "SMALLEST", "STAGES", "A", "C", "mean_square", "power",
    "write_dormand_prince_loop",
]  # fmt: skip

C = (0.0, 1 / 5, 3 / 10, 4 / 5, 8 / 9, 1.0, 1.0)
A = (
    (),
    (1 / 5,),
    (3 / 40, 9 / 40),
    (44 / 45, -56 / 15, 32 / 9),
    (19372 / 6561, -25360 / 2187, 64448 / 6561, -212 / 729),
    (9017 / 3168, -355 / 33, 46732 / 5247, 49 / 176, -5103 / 18656),
    (35 / 384, 0.0, 500 / 1113, 125 / 192, -2187 / 6784, 11 / 84),
)
B_ERROR = (71 / 57600, 0.0, -71 / 16695, 71 / 1920, -17253 / 339200, 22 / 525, -1 / 40)
"""Weights of order 5 less weights of order 4."""
DENSE = (
    (1.0, -8048581381 / 2820520608, 8663915743 / 2820520608, -12715105075 / 11282082432),
    (0.0, 0.0, 0.0, 0.0),
    (0.0, 131558114200 / 32700410799, -68118460800 / 10900136933, 87487479700 / 32700410799),
    (0.0, -1754552775 / 470086768, 14199869525 / 1410260304, -10690763975 / 1880347072),
    (0.0, 127303824393 / 49829197408, -318862633887 / 49829197408, 701980252875 / 199316789632),
    (0.0, -282668133 / 205662961, 2019193451 / 616988883, -1453857185 / 822651844),
    (0.0, 40617522 / 29380423, -110615467 / 29380423, 69997945 / 29380423),
)
"""Weight of stage i at the share s of a step: sum over j of DENSE[i][j] s^(j+1)."""

SAFETY, SMALLEST, LARGEST, BETA = 0.9, 0.2, 10.0, 0.04
STAGES = tuple(f"k{i}" for i in range(1, 8))


def write_dormand_prince_loop(module: Any, name: str, lowered: Lowered | ScheduleRate, guarded: int) -> None:
    """Write the loop: steps end exactly on the knots, where the first stage is taken anew."""
    loop = TimeLoop(module, name, lowered, (*STAGES[1:], "probe", "new"), guarded)
    b = loop.builder
    gate = Gate(loop, lowered.gate_offset)
    gate.begin("y", "probe")
    _first_stage(loop)
    time, wanted = loop.get("t"), loop.get("h")
    h, last, time_after = loop.step_until(loop.knot(1))
    _stages(loop, time, h)
    error = _error(loop, h)
    loop.add("done", 1.0)
    accepted, rejected = loop.block("accepted"), loop.block("rejected")
    b.cbranch(b.fcmp_ordered("<=", error, number(1.0)), accepted, rejected)
    b.position_at_end(rejected)
    loop.reject(h, b.fdiv(number(SAFETY), power(loop, error, 0.2 - 0.75 * BETA)), SMALLEST)
    b.position_at_end(accepted)
    loop.stop_if(b.not_(loop.within_bounds("new")), Status.DIVERGED)
    gate.meet(h)
    _write_samples(loop, time, h, time_after)
    _accept(loop, wanted, h, error, last, time_after)
    b.branch(loop.again)


def _first_stage(loop: TimeLoop) -> None:
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


def _stages(loop: TimeLoop, time: Any, h: Any) -> None:
    b = loop.builder
    for stage in range(1, 7):
        into = "new" if stage == 6 else "probe"
        weights = {STAGES[j]: b.fmul(h, number(a)) for j, a in enumerate(A[stage]) if a}
        loop.combine(into, weights)
        loop.evaluate(b.fadd(time, b.fmul(number(C[stage]), h)), into, STAGES[stage])


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


def _error(loop: TimeLoop, h: Any) -> Any:
    b = loop.builder

    def difference(i: Any) -> Any:
        total: Any = number(0.0)
        for stage, weight in zip(STAGES, B_ERROR, strict=True):
            if weight:
                total = b.fadd(total, b.fmul(number(weight), load(b, loop.array[stage], i)))
        return b.fmul(h, total)

    return mean_square(loop, difference, "y", "new")


def power(loop: TimeLoop, base: Any, exponent: Any) -> Any:
    """``base`` to the power ``exponent``, a number or a value."""
    module = loop.module
    exponent = number(exponent) if isinstance(exponent, float) else exponent
    function = module.globals.get(POWER) or declare(module, POWER, F64, [("x", F64), ("y", F64)])
    return loop.builder.call(function, [base, exponent])


def _accept(loop: TimeLoop, wanted: Any, h: Any, error: Any, last: Any, time_after: Any) -> None:
    b = loop.builder
    error = loop.intrinsic("maxnum", error, number(1e-10))
    old = power(loop, loop.get("old_error"), BETA)
    factor = b.fdiv(b.fmul(number(SAFETY), old), power(loop, error, 0.2 - 0.75 * BETA))
    factor = loop.intrinsic("minnum", loop.intrinsic("maxnum", factor, number(SMALLEST)), number(LARGEST))
    grown = b.fmul(h, factor)
    # A step cut short by a knot says little about the next: keep the longer wish.
    loop.put("h", b.select(last, loop.intrinsic("maxnum", grown, wanted), grown))
    loop.put("old_error", loop.intrinsic("maxnum", error, number(1e-4)))
    loop.copy("y", "new")
    loop.copy("k1", "k7")
    loop.put("t", time_after)
    loop.put("fresh", b.uitofp(last, F64))
    loop.put("segment", b.fadd(loop.get("segment"), b.uitofp(last, F64)))
    loop.add("steps", 1.0)


def _write_samples(loop: TimeLoop, time: Any, h: Any, time_after: Any) -> None:
    b = loop.builder
    with loop.due_samples(time_after) as target:
        s = b.fdiv(b.fsub(loop.sample_time(), time), h)
        weights = {stage: b.fmul(h, _dense(b, s, row)) for stage, row in zip(STAGES, DENSE, strict=True) if any(row)}
        with counted(b, loop.size) as i:
            value = load(b, loop.array["y"], i)
            for stage, weight in weights.items():
                value = b.fadd(value, b.fmul(weight, load(b, loop.array[stage], i)))
            store(b, value, target, i)


def _dense(b: Any, s: Any, row: tuple[float, ...]) -> Any:
    value: Any = number(0.0)
    for coefficient in reversed(row):
        value = b.fmul(s, b.fadd(number(coefficient), value))
    return value
