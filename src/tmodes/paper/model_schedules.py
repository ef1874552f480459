"""The equations of the 2010 robot as schedules of two kernels: what follows from its numbers alone, and the rest."""

from __future__ import annotations

from functools import cache
from itertools import pairwise
from typing import Any

import numpy as np

from tmodes.equations.lagrange.layout import OBSERVED, STATE_SIZE
from tmodes.kinds.kernel.kernel import Kernel
from tmodes.kinds.kernel.schedule import Schedule, Slot
from tmodes.paper.mechanism import Mechanism

__all__ = ["implicit_schedule", "observe_schedule", "rate_schedule"]

_INSTANT = ("time", "state", "row")


@cache
def rate_schedule(mechanism: Mechanism) -> Schedule:
    """(time, state, row) -> ``rate``, the derivative of the state; what follows from the parameters alone comes first.

    Parameters and inputs are those of :meth:`tmodes.paper.model.PaperModel.rate`.
    """
    from tmodes.equations.lagrange.closed_loop import closed_loop, rate_function

    return _parted(mechanism.key, rate_function(closed_loop(mechanism)), _INSTANT, {"rate": STATE_SIZE})


@cache
def implicit_schedule(mechanism: Mechanism) -> Schedule:
    """(time, state, start, row, step) -> ``rate`` of implicit steps: :mod:`tmodes.equations.lagrange.implicit_step`."""
    from tmodes.equations.lagrange.implicit_step import implicit_rate_function

    names = ("time", "state", "start", "row", "step")
    schedule = _parted(f"implicit {mechanism.key}", implicit_rate_function(mechanism), names, {"rate": STATE_SIZE})
    schedule.often = True
    return schedule


@cache
def observe_schedule(mechanism: Mechanism, names: tuple[str, ...]) -> Schedule:
    """(time, state, row) -> outputs of ``PaperModel.observe``, with its parameters and inputs."""
    from tmodes.equations.lagrange.closed_loop import closed_loop, observe_function

    function = observe_function(closed_loop(mechanism), names)
    return _parted(f"{mechanism.key} {names}", function, _INSTANT, {name: OBSERVED[name] for name in names})


def _parted(key: str, function: Any, names: tuple[str, ...], outputs: dict[str, int]) -> Schedule:
    """A function of the inputs of these names, and of parameters last, with its outputs one after the other."""
    from tmodes.compile.ir.invariant import parted

    held, rest = parted(function, invariant=len(names))
    sizes = (*(function.nnz_in(k) for k in range(len(names))), held.nnz_out(0))
    schedule, ends = Schedule(function.nnz_in(len(names))), np.cumsum([0, *outputs.values()]).tolist()

    def build(*blocks: Any) -> list[list[Any]]:
        (info,) = rest.call([*blocks])
        return [[info[start:end]] for start, end in pairwise(ends)]

    first = Kernel(f"held {key}", (schedule.parameters,), sizes[-1:], lambda p: [[value] for value in held.call([p])])
    second = Kernel(f"rest {key}", sizes, tuple(outputs.values()), build)
    inputs = [schedule.input(name, size) for name, size in zip(names, sizes, strict=False)]
    (kept,) = schedule.call(first, Slot("parameters", 0, schedule.parameters))
    for name, slot in zip(outputs, schedule.call(second, *inputs, kept), strict=True):
        schedule.output(name, slot)
    return schedule
