"""The order of a straight-line program: such that a processor finds at each cycle something to do, with few registers.

List scheduling (Gibbons and Muchnick 1986) for two multipliers and two adders: among the operations whose operands are
known by then goes first what leaves fewest values waiting for their last use, then what the longest chain follows.
"""

from __future__ import annotations

import heapq
from collections import OrderedDict
from collections.abc import Iterable, Sequence
from typing import Any

import casadi as ca

from tmodes.compile.ir.program import READ, BlockProgram, Instruction, block_program, needed
from tmodes.compile.ir.tracing import traced
from tmodes.kinds.kernel.schedule import Kernel

__all__ = ["in_good_order", "kernel_function", "kernel_program"]

_LONGEST = 1000
"""Values of a program up to which its order is looked for."""

_UNITS = 2
_CYCLES = {"add": 2, "sub": 2, "twice": 2, "neg": 1, "div": 13, "inv": 13, "sqrt": 13, "sin": 40, "cos": 40}
_ADDERS = ("add", "sub", "twice", "neg")


_programs: OrderedDict[Any, BlockProgram] = OrderedDict()
_KEPT = 256
"""Programs that are kept: the schedules of one robot share most of their kernels."""


def kernel_program(kernel: Any) -> BlockProgram:
    """The program of a kernel, in an order that suits processors where that is not left to LLVM."""
    same = (kernel.key, kernel.inputs, kernel.outputs)
    if same not in _programs:
        _programs[same] = _program(kernel)
        while len(_programs) > _KEPT:
            _programs.popitem(last=False)
    return _programs[same]


def _program(kernel: Any) -> BlockProgram:
    program = traced(kernel) if kernel.plain else block_program(kernel_function(kernel))
    if kernel.long or len(program.values) > _LONGEST:
        return program
    order = in_good_order(program.values, [index for _, _, index in program.results if index is not None])
    places = {index: place for place, index in enumerate(order)}
    values = [program.values[k]._replace(args=tuple(places[arg] for arg in program.values[k].args)) for k in order]
    results = [(out, k, None if index is None else places[index]) for out, k, index in program.results]
    return BlockProgram(program.inputs, program.outputs, values, results)


def in_good_order(values: Sequence[Instruction], results: Sequence[int]) -> list[int]:
    """Indices of the values that ``results`` need, in a better order, what is read first."""
    chosen = needed(values, results)
    scheduler = _Scheduler(values, chosen, results)
    return [k for k in chosen if values[k].opcode in READ] + scheduler.run()


class _Scheduler:
    """One pass over the cycles of a simple processor."""

    def __init__(self, values: Sequence[Instruction], chosen: Sequence[int], results: Iterable[int]) -> None:
        count = len(values)
        reads = [value.opcode in READ for value in values]
        operations = [index for index in chosen if not reads[index]]
        self.cycles = [_CYCLES.get(value.opcode, 4) for value in values]
        self.unit = [value.opcode in _ADDERS for value in values]
        self.args = [[arg for arg in {*value.args} if not reads[arg]] for value in values]
        self.readers: list[list[int]] = [[] for _ in values]
        for index in operations:
            for arg in self.args[index]:
                self.readers[arg].append(index)
        self.unread = [len(readers) for readers in self.readers]
        for index in results:
            self.unread[index] += count  # it is kept to the end, and never read for the last time
        self.after = [0] * count
        for index in reversed(operations):
            self.after[index] = self.cycles[index] + max((self.after[k] for k in self.readers[index]), default=0)
        self.missing = [len(args) for args in self.args]
        self.known = [0] * count
        self.ready = [index for index in operations if not self.missing[index]]

    def run(self) -> list[int]:
        """All operations in the order in which they begin."""
        order: list[int] = []
        waiting: list[tuple[int, int]] = []
        cycle = 0
        while self.ready or waiting:
            while waiting and waiting[0][0] <= cycle:
                self.ready.append(heapq.heappop(waiting)[1])
            order += self._cycle(cycle, waiting)
            cycle += 1
        return order

    def _cycle(self, cycle: int, waiting: list[tuple[int, int]]) -> list[int]:
        """What begins in a cycle."""
        free, begun = [_UNITS, _UNITS], []
        while chosen := [index for index in self.ready if free[self.unit[index]]]:
            best = min(chosen, key=self._rank)
            self.ready.remove(best)
            free[self.unit[best]] -= 1
            begun.append(best)
            for arg in self.args[best]:
                self.unread[arg] -= 1
            for reader in self.readers[best]:
                self.missing[reader] -= 1
                self.known[reader] = max(self.known[reader], cycle + self.cycles[best])
                if not self.missing[reader]:
                    heapq.heappush(waiting, (self.known[reader], reader))
        return begun

    def _rank(self, index: int) -> tuple[int, int, int]:
        last = 0
        for arg in self.args[index]:
            last += self.unread[arg] == 1
        return -last, -self.after[index], index


def kernel_function(kernel: Kernel) -> ca.Function:
    """The kernel as a CasADi function; common subexpressions are found."""
    symbols = [ca.SX.sym(f"i{k}", size) for k, size in enumerate(kernel.inputs)]
    results = [ca.vertcat(*map(ca.SX, entries)) for entries in kernel.build(*symbols)]
    for size, result in zip(kernel.outputs, results, strict=True):
        assert result.numel() == size, f"{kernel.key}: {result.numel()} numbers, expected {size}"  # noqa: S101
    dense = [ca.densify(result) for result in results]
    return ca.Function("kernel", symbols, dense, {"cse": True})
