"""The estimated limit of a program on this machine: from its instruction list and the measured cost of operations.

Two bounds, loads and stores left out: the critical path, the longest chain of operations that wait for each other; and
throughput, all operations at the rate at which independent ones go, sums next to products where the processor has units
for both. A product that only one sum reads counts as one operation with it, as a fused multiply-add can do.
"""

from __future__ import annotations

import statistics
from collections import Counter
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np
from benchmarks.engines.contender import now
from benchmarks.engines.latency import BODY, OPERATIONS, chains

from tmodes.compile.ir.program import READ, BlockProgram
from tmodes.compile.ir.unroll import unrolled

__all__ = ["Limit", "Machine", "critical_path", "limit", "machine", "throughput"]

_WIDTH = 10
"""Chains side by side: more than any processor's units times their depth."""

_MIXED = 16
"""The same where only each other chain is one of fused operations."""

_LOOPS, _ROUNDS = 2000, 7

_LIKE = {
    "sub": "add", "neg": None, "twice": "add", "sq": "mul", "inv": "div", "cos": "sin", "fabs": None, "copy": None,
    "not": None, "lt": "add", "le": "add", "if_else_zero": "add", "constant": None, "input": None,
}  # fmt: skip
"""The measured operation that stands for another; None: nothing to wait for."""


@dataclass(frozen=True)
class Machine:
    """Measured: time of a cycle [s]; of each operation, the time to its result and its time among independent ones.

    ``cost["mixed"]``: that of sums and fused operations in turn.
    """

    cycle: float
    latency: dict[str, float]
    cost: dict[str, float]


@dataclass(frozen=True)
class Limit:
    """Operations in all, and those that change with the state; both bounds [s], and the critical path in cycles."""

    operations: int
    changing: int
    critical_path: float
    critical_cycles: float
    throughput: float


@cache
def machine() -> Machine:
    """The machine at hand, measured by chains of dependent operations; takes a fraction of a second."""
    single, many = chains(1), chains(_WIDTH)
    latency = {name: _timed(single[name], 1) for name in OPERATIONS}
    cost = {name: _timed(many[name], _WIDTH) for name in OPERATIONS}
    cost["mixed"] = _timed(chains(_MIXED)["mixed"], _MIXED)
    return Machine(_timed(single["cycle"], 1), latency, cost)


def _timed(function: Any, width: int) -> float:
    """Seconds per operation: the median of some rounds."""
    numbers, rounds = np.linspace(1.0, 1.1, max(width, 1)), []
    for _ in range(_ROUNDS):
        began = now()
        function(_LOOPS, numbers.ctypes.data)
        rounds.append((now() - began) / (_LOOPS * BODY * width))
    return statistics.median(rounds)


def limit(schedule: Any) -> Limit:
    """The limit of a schedule's forward evaluation, parameters at hand."""
    code, here = unrolled(schedule), machine()
    program = BlockProgram(1, 1, code.main, [(0, k, index) for k, (_, index) in enumerate(code.results)])
    path = critical_path(program, here.latency)
    changing = sum(count for name, count in _kinds(program).items() if name)
    operations = sum(value.opcode not in READ for value in (*code.prepare, *code.main))
    return Limit(operations, changing, path, path / here.cycle, throughput(program, here.cost))


def _measured(kind: str) -> str | None:
    return _LIKE.get(kind, kind)


def _kinds(program: BlockProgram) -> Counter[str | None]:
    """How often each measured operation is needed; sine and cosine of one angle count once."""
    counts = Counter(_measured(value.opcode) for value in program.values if value.opcode not in ("sin", "cos"))
    counts["sin"] = len({value.args for value in program.values if value.opcode in ("sin", "cos")})
    return counts


def critical_path(program: BlockProgram, latency: dict[str, float]) -> float:
    """Time of the longest chain of operations, each of which waits for the one before [s]."""
    ready: list[float] = []
    for value in program.values:
        before = max((ready[arg] for arg in value.args), default=0.0)
        kind = _measured(value.opcode)
        ready.append(before + (latency[kind] if kind else 0.0))
    return max((ready[index] for _, _, index in program.results if index is not None), default=0.0)


def throughput(program: BlockProgram, cost: dict[str, float]) -> float:
    """Time of all operations when none waits [s]; products and sums are fused where they can be.

    Sums that remain run along with all else as far as ``cost["mixed"]`` says.
    """
    counts = _kinds(program)
    fused = _fused(program)
    counts["add"] -= fused
    counts["mul"] -= fused
    counts["fma"] += fused
    sums = counts.pop("add") * cost["add"]
    others = sum(count * cost[name] for name, count in counts.items() if name)
    together = 2 * cost["mixed"] / (cost["add"] + cost["fma"])
    return max(sums, others, together * (sums + others))


def _fused(program: BlockProgram) -> int:
    """Sums with a product that nothing else reads."""
    read = Counter(arg for value in program.values for arg in value.args)
    read.update(index for _, _, index in program.results if index is not None)
    return sum(
        value.opcode in ("add", "sub")
        and any(program.values[arg].opcode in ("mul", "sq") and read[arg] == 1 for arg in value.args)
        for value in program.values
    )
