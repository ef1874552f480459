"""A straight-line program as the right-hand side of implicit steps, and its Jacobian, for the time loops."""

from __future__ import annotations

from typing import Any

from llvmlite import ir

from tmodes.compile.block import ScheduleRate
from tmodes.compile.emit import F64, POINTER, VOID, at, counted, declare, load, number, scratch, store, whole
from tmodes.compile.lower import Lowered, lower
from tmodes.compile.program import Program

__all__ = ["StraightJacobian", "write_straight_rate"]


def write_straight_rate(module: Any, program: Program) -> ScheduleRate:
    """The rate of a program of (time, ahead, start, row, step, parameters); the step's length stands behind the held.

    ``call`` takes the state for ``ahead`` and ``start``.
    """
    lowered = lower(module, program)
    prepare = declare(module, f"{program.name}.prepare", VOID, [("p", POINTER), ("held", POINTER)], private=True)
    b = ir.IRBuilder(prepare.append_basic_block("entry"))
    b.call(lowered.prepare, prepare.args)
    store(b, number(0.0), prepare.args[1], lowered.held_size)
    b.ret_void()
    calls = [_write_call(module, lowered, labels) for labels in (("state", "row"), ("ahead", "start", "row"))]
    size, row, step = program.output_size, program.sizes[3], lowered.held_size
    return ScheduleRate(prepare, calls[0], step + 1, size, row, step, None, calls[1])


def _write_call(module: Any, lowered: Lowered, labels: tuple[str, ...]) -> Any:
    """The private function ``(time, labels..., held, out)``."""
    kinds = [("time", F64), *((label, POINTER) for label in (*labels, "held", "out"))]
    call = declare(module, f"{lowered.program.name}.{'.'.join(labels)}", VOID, kinds, private=True)
    b = ir.IRBuilder(call.append_basic_block("entry"))
    time, *states, row, held, out = call.args
    step = load(b, held, lowered.held_size)
    b.call(lowered.call, [time, states[0], states[-1], row, step, held, out])
    b.ret_void()
    return call


class StraightJacobian:
    """``prepare(parameters, held)`` and ``call(time, state, row, held, by_state, by_time)`` of a program in a module.

    What :class:`tmodes.compile.rate_jacobian.RateJacobian` is to a schedule. The program's output is ``by_state``
    (outputs, columns), row by row, and then ``by_time`` (outputs,).
    """

    def __init__(self, module: Any, program: Program, outputs: int, columns: int) -> None:
        self.columns = columns
        lowered = lower(module, program)
        self.held_size, self.prepare = lowered.held_size, lowered.prepare
        self.call = self._write_call(module, lowered, outputs)

    def _write_call(self, module: Any, lowered: Lowered, outputs: int) -> Any:
        pointers = [(label, POINTER) for label in ("state", "row", "held", "by_state", "by_time")]
        call = declare(module, f"{lowered.program.name}.parted", VOID, [("time", F64), *pointers], private=True)
        *given, by_state, by_time = call.args
        b = ir.IRBuilder(call.append_basic_block("entry"))
        both = scratch(b, lowered.size, "both")
        b.call(lowered.call, [*given, both])
        first = outputs * self.columns
        for source, target, size in ((both, by_state, first), (at(b, both, whole(first)), by_time, outputs)):
            with counted(b, size, "copy") as k:
                store(b, load(b, source, k), target, k)
        b.ret_void()
        return call
