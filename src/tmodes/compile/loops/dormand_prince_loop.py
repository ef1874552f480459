"""Dormand and Prince's pair of order 5(4) with dense output, adaptive, as a native loop.

Tableau: J. R. Dormand, P. J. Prince, J. Comp. Appl. Math. 6 (1980) 19-26; dense output of order 4: L. F. Shampine,
Math. Comp. 46 (1986) 135-150; step control as in the code DOPRI5 of E. Hairer and G. Wanner.
"""

from __future__ import annotations

from typing import Any

from tmodes.compile.ir.block import ScheduleRate
from tmodes.compile.ir.emit import counted, load, number, store
from tmodes.compile.ir.lower import Lowered
from tmodes.compile.loops.explicit_step import ExplicitMethod
from tmodes.compile.loops.step_control import StepControl, mean_square
from tmodes.compile.loops.stiffness import StiffnessTest
from tmodes.compile.loops.time_loop import TimeLoop

__all__ = [
    "BETA", "B_ERROR", "DENSE", "LARGEST", "SAFETY", "SMALLEST", "STAGES", "A", "C", "write_dormand_prince_loop",
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
_CONTROL = StepControl(order=5.0, beta=BETA, damping=0.75, smallest=SMALLEST, largest=LARGEST, safety=SAFETY)
_STIFFNESS = StiffnessTest(slopes=("k7", "k6"), states=("new", "probe"), limit=3.25, ringing=0.99)
_METHOD = ExplicitMethod(_CONTROL, _STIFFNESS, "k7")
STAGES = tuple(f"k{i}" for i in range(1, 8))


def write_dormand_prince_loop(module: Any, name: str, lowered: Lowered | ScheduleRate, guarded: int) -> None:
    """Write the loop: steps end exactly on the knots, where the first stage is evaluated again."""
    loop = TimeLoop(module, name, lowered, (*STAGES[1:], "probe", "new", "local"), guarded)
    gate, step = _METHOD.begin(loop, lowered.gate_offset)
    time, h = step.time, step.h
    _stages(loop, time, h)
    errors = _error(loop, h), number(1.0)
    _METHOD.end_with(loop, gate, step, errors, lambda: _write_samples(loop, time, h, step.time_after))


def _stages(loop: TimeLoop, time: Any, h: Any) -> None:
    b = loop.builder
    for stage in range(1, 7):
        into = "new" if stage == 6 else "probe"
        weights = {STAGES[j]: b.fmul(h, number(a)) for j, a in enumerate(A[stage]) if a}
        loop.combine(into, weights)
        loop.evaluate(b.fadd(time, b.fmul(number(C[stage]), h)), into, STAGES[stage])


def _error(loop: TimeLoop, h: Any) -> Any:
    b = loop.builder

    def difference(i: Any) -> Any:
        total: Any = number(0.0)
        for stage, weight in zip(STAGES, B_ERROR, strict=True):
            if weight:
                total = b.fadd(total, b.fmul(number(weight), load(b, loop.array[stage], i)))
        error = b.fmul(h, total)
        store(b, error, loop.array["local"], i)
        return error

    return mean_square(loop, difference, "y", "new")


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
