"""The rows of a tableau of linearly implicit Euler steps, side by side in the lanes of vectors.

A step takes springs, dampers and servos at its end, through h D + h^2 K inside the recursion, and all else where it is
expected to end, at q + h v. With the geometry left at the start instead, what is not in h D + h^2 K excites the stiff
modes a little in every step, as in W-methods (T. Steihaug, A. Wolfbrandt, Math. Comp. 33 (1979) 521-534), and
extrapolation loses its order: by a factor of 20 in the error of 8 rows over 1 ms on the benchmarks' stiff arm.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cache
from typing import Any, NamedTuple

import numpy as np
from llvmlite import ir
from numpy.typing import ArrayLike, NDArray

from tmodes.compile.ir.arithmetic import Double, Lanes
from tmodes.compile.ir.block import ScheduleRate, write_jumps, write_main
from tmodes.compile.ir.emit import F64, POINTER, VOID, Builder, at, counted, declare, load, store, whole
from tmodes.compile.ir.rows import copy_numbers, take_rows
from tmodes.compile.loops.time_loop import TimeLoop
from tmodes.errors import CompileError

__all__ = [
    "LANES",
    "PairedRows",
    "RowStep",
    "RowsRate",
    "constants",
    "difference_weights",
    "limit_weights",
    "passes_of",
    "schedule_of",
    "spread_weights",
    "steady_weights",
    "write_rows_rate",
]

LANES = 4
"""Rows side by side: of vectors of eight, which take half as long again, most lanes would idle."""

Array = NDArray[np.float64]


class RowStep(NamedTuple):
    """Step ``step`` (from 0) of row ``row`` (from 1) is taken in pass ``at`` (from 0), in ``lane``."""

    row: int
    step: int
    at: int
    lane: int


@cache
def schedule_of(rows: int) -> tuple[RowStep, ...]:
    """All steps of rows 1 to ``rows``, row by row."""
    free = [0] * LANES
    first: dict[int, tuple[int, int]] = {}
    for row in range(rows, 0, -1):
        lane = free.index(min(free))
        first[row] = free[lane], lane
        free[lane] += row
    places = [(row, step, *first[row]) for row in range(1, rows + 1) for step in range(row)]
    return tuple(RowStep(row, step, begin + step, lane) for row, step, begin, lane in places)


def passes_of(rows: int) -> int:
    """How many passes all steps of so many rows take."""
    return 1 + max((step.at for step in schedule_of(rows)), default=-1)


def limit_weights(rows: int, first: int = 1) -> dict[int, float]:
    """Weights of the ends of rows ``first`` to ``rows`` in the value extrapolated from them."""
    used = range(first, rows + 1)
    return {row: math.prod(row / (row - other) for other in used if other != row) for row in used}


_STEADY = {8: (-22.6, 7.5), 5: (-3.53, 1.07)}


def steady_weights(rows: int = 8) -> dict[int, float]:
    """Weights of the ends of so many rows that let no vibration grow: of order 6 of eight, two less than the limit.

    The limit itself lets a vibration of frequency w that nothing damps grow by 1.3 % in each step of h w near 3.8, and
    in an arm of many modes one is always there. Shares of the limits of rows 2 to 8 and 3 to 8, found as those for
    which the growth is least, bring it to 0.1 %, at h w near 3.4; beyond, vibrations die. Of five ``rows`` the same
    leaves order 3, and brings 0.7 % to 0.01 %.
    """
    whole = limit_weights(rows)
    parts = [(share, limit_weights(rows, first)) for first, share in enumerate(_STEADY[rows], 2)]
    return {row: value + sum(a * (part.get(row, 0.0) - value) for a, part in parts) for row, value in whole.items()}


def difference_weights(rows: int, order: int) -> dict[tuple[int, int], float]:
    """Weights of the states of ``rows`` rows in the derivative of this order at the end, times h^order / order!.

    Backward differences of each row, extrapolated: E. Hairer, A. Ostermann, Numer. Math. 58 (1990) 419-439. By (row,
    steps done); (0, 0) is the start.
    """
    weights: dict[tuple[int, int], float] = {}
    for row, limit in limit_weights(rows, order).items():
        share = limit * row**order / math.factorial(order)
        for back in range(order + 1):
            place = (row, row - back) if row > back else (0, 0)
            weights[place] = weights.get(place, 0.0) + share * (-1) ** back * math.comb(order, back)
    return weights


def spread_weights(weights: dict[tuple[int, int], float], rows: int) -> Array:
    """Such weights by slots and lanes: slot 0 holds the start, slot p + 1 what pass p of ``rows`` rows gave."""
    spread = np.zeros((passes_of(rows) + 1, LANES))
    spread[0, 0] = weights.get((0, 0), 0.0)
    for row, step, place, lane in schedule_of(rows):
        spread[place + 1, lane] = weights.get((row, step + 1), 0.0)
    return spread


@dataclass(frozen=True)
class RowsRate(ScheduleRate):
    """``call`` takes one state, as any other; ``call_rows(times, steps, row, held, out)`` takes one in each lane.

    Their coordinates and rates stand in ``held`` at ``state_offset``, what springs start from at ``start_offset``, in
    vectors, and are lost by the call.
    """

    call_rows: Any = None
    state_offset: int = 0
    start_offset: int = 0


def write_rows_rate(module: Any, schedule: Any, name: str) -> RowsRate:
    """The functions of :class:`RowsRate` around a schedule that has the inputs ``step`` and ``start``.

    Raises :class:`CompileError` for one that has not.
    """
    if not {"step", "start"} <= set(schedule.inputs):
        raise CompileError(f"{name}: the schedule has no inputs `step` and `start` for implicit steps")
    return _RatesWriter(module, schedule, name).written()


class _RatesWriter:
    """Offsets are those of doubles in a workspace of vectors."""

    def __init__(self, module: Any, schedule: Any, name: str) -> None:
        self.module, self.schedule, self.name, self.lanes = module, schedule, name, Lanes(module)
        self.main = write_main(module, schedule, self.lanes, f"{name}.main")
        self.outputs = self.main.blocks(slot for slots in schedule.outputs.values() for slot in slots)

    def written(self) -> RowsRate:
        """All functions."""
        s, memory, double = self.schedule, self.main.memory, Double(self.module)
        prepare, rows = self._prepare(), self._call_rows()
        step, state, start = (self._offset(s.inputs[label]) for label in ("step", "state", "start"))
        end = memory.workspace * self.lanes.stride
        watched = sum(slot.size for slot in s.watched)
        call, sizes = self._call(rows, end), (end + watched, s.output_size, s.inputs["row"].size)
        sampled, switched = write_jumps(self.module, s, double, self.name)
        gate = (end, s.gate.size // 2) if s.gate else (None, 0)
        count = s.switches.size if s.switches else 0
        narrow = (end + 2 * gate[1], s.narrow.size // 2) if s.narrow else (0, 0)
        jumps = (sampled, end + watched - count, count, switched, narrow[0], narrow[1], s.jolts)
        return RowsRate(prepare, call, *sizes, step, *gate, None, *jumps, rows, state, start)

    def _offset(self, slot: Any) -> int:
        return self.main.memory.offset(slot) * self.lanes.stride

    def _function(self, name: str, kinds: list[tuple[str, Any]]) -> tuple[Any, Any]:
        function = declare(self.module, f"{self.name}.{name}", VOID, kinds, private=True)
        function.attributes.add("noinline")
        return function, Builder(function.append_basic_block("entry"))

    def _prepare(self) -> Any:
        prepare, b = self._function("prepare", [("parameters", POINTER), ("held", POINTER)])
        parameters, held = prepare.args
        take_rows(b, self.lanes, parameters, held, [(0, self.schedule.parameters)], 1)
        self.lanes.store(b, self.lanes.constant(0.0), held, self.main.memory.offset(self.schedule.inputs["step"]))
        self.main.prepare(b, held)
        b.ret_void()
        return prepare

    def _call_rows(self) -> Any:
        """``call_rows(times, steps, row, held, out)``."""
        lanes, inputs = self.lanes, self.schedule.inputs
        kinds = [("times", lanes.kind), ("steps", lanes.kind), ("row", POINTER), ("held", POINTER), ("out", POINTER)]
        call, b = self._function("call_rows", kinds)
        times, steps, row, held, out = call.args
        lanes.store(b, times, held, self.main.memory.offset(inputs["time"]))
        lanes.store(b, steps, held, self.main.memory.offset(inputs["step"]))
        take_rows(b, lanes, row, held, self.main.blocks([inputs["row"]]), 1)
        b.call(self.main.function, [held])
        copy_numbers(b, lanes, out, held, self.outputs, into=False)
        b.ret_void()
        return call

    def _call(self, rows: Any, gate: int) -> Any:
        """``call(time, state, row, held, out)``: the same state in all lanes, explicit; the first lane's rates.

        What loops read of its workspace is put at ``gate``, as of one run.
        """
        lanes, inputs = self.lanes, self.schedule.inputs
        kinds = [("time", F64), ("state", POINTER), ("row", POINTER), ("held", POINTER), ("out", POINTER)]
        call, b = self._function("call", kinds)
        time, state, row, held, out = call.args
        found = b.alloca(F64, size=whole(self.schedule.output_size * lanes.stride))
        for label in ("state", "start"):
            take_rows(b, lanes, state, held, self.main.blocks([inputs[label]]), 1)
        b.call(rows, [lanes.spread(b, time), lanes.constant(0.0), row, held, found])
        with counted(b, self.schedule.output_size) as i:
            store(b, load(b, found, b.mul(i, whole(lanes.stride))), out, i)
        watched = [(slot, k) for slot in self.schedule.watched for k in range(slot.size)]
        for place, (slot, k) in enumerate(watched):
            store(b, load(b, held, self._offset(slot) + k * lanes.stride), held, gate + place)
        b.ret_void()
        return call


_LINE = 64


def constants(loop: TimeLoop, name: str, numbers: ArrayLike) -> Any:
    """The address of constant numbers; the name serves once in a loop."""
    info = np.ravel(numbers).tolist()
    kind = ir.ArrayType(F64, len(info))
    table: Any = ir.GlobalVariable(loop.module, kind, f"{loop.function.name}.{name}")
    table.global_constant, table.linkage, table.align = True, "internal", _LINE
    table.initializer = ir.Constant(kind, info)
    return loop.builder.bitcast(table, POINTER)


class PairedRows:
    """Takes all steps of a tableau and keeps their states.

    Slot 0 of what is kept holds the start in all lanes, slot p + 1 the states after pass p.
    """

    def __init__(self, loop: TimeLoop, rate: RowsRate, pairs: int, rows: int) -> None:
        self.loop, self.rate, self.pairs, self.b = loop, rate, pairs, loop.builder
        self.lanes, self.rows, self.slots = Lanes(loop.module), rows, 1 + passes_of(rows)
        with self.b.goto_entry_block():
            self.kept = self._vectors(self.slots * loop.size, "kept")
            self.slope = self._vectors(loop.size, "slopes")
        loop.array["held"].align = _LINE
        self.tables = {label: constants(loop, f"{label}{rows}", table) for label, table in self._info().items()}

    def _vectors(self, count: int, name: str) -> Any:
        place: Any = self.b.alloca(F64, size=whole(count * LANES), name=name)
        place.align = _LINE
        return place

    def _info(self) -> dict[str, Any]:
        """By pass and lane: what h is divided by, where a step ends, if a row begins; idle lanes take steps of 0."""
        info = {"lengths": np.inf, "times": 1.0, "begins": 0.0}
        tables = {label: np.full((self.slots, LANES), value) for label, value in info.items()}
        for row, step, pass_, lane in schedule_of(self.rows):
            for label, value in zip(info, (row, (step + 1) / row, step == 0), strict=True):
                tables[label][pass_, lane] = value
        return tables

    def take(self, time: Any, h: Any) -> None:
        """All steps of all rows over h from the array ``y``."""
        b, lanes, loop, passes = self.b, self.lanes, self.loop, self.slots - 1
        with counted(b, loop.size, "start") as i:
            lanes.store(b, lanes.spread(b, loop.load("y", i)), self._vector(self.kept, i), 0)
        wide_h, wide_time = lanes.spread(b, h), lanes.spread(b, time)
        with counted(b, passes, "pass") as p:
            length, share, begins = (self._at(table, p) for table in self.tables.values())
            step, end = b.fdiv(wide_h, length), b.fadd(wide_time, b.fmul(wide_h, share))
            self._expect(p, step, b.fcmp_ordered("!=", begins, lanes.constant(0.0)))
            b.call(self.rate.call_rows, [end, step, loop.row(), loop.array["held"], self.slope])
            self._advance(p, step)
        loop.add("evaluations", float(len(schedule_of(self.rows))))
        loop.add("passes", float(passes))

    def _expect(self, p: Any, step: Any, begins: Any) -> None:
        """What the recursion reads: where steps are expected to end, and the same for springs to start from."""
        b, n = self.b, self.pairs
        moved, start = (
            at(b, self.loop.array["held"], offset) for offset in (self.rate.state_offset, self.rate.start_offset)
        )
        with counted(b, n, "expect") as i:
            paired = b.add(i, whole(n))
            place, rate = (self._begun(p, k, begins) for k in (i, paired))
            self._put([(moved, paired), (start, paired)], rate)
            self._put([(moved, i), (start, i)], b.fadd(place, b.fmul(step, rate)))
        with counted(b, self.loop.size - 2 * n, "others") as i:
            other = b.add(i, whole(2 * n))
            self._put([(moved, other)], self._begun(p, other, begins))

    def _begun(self, p: Any, i: Any, begins: Any) -> Any:
        """Component i before a pass, the start's where a row begins; kept where the pass will find it."""
        before = self._kept(p, i)
        value = self.b.select(begins, self._kept(whole(0), i), before)
        self.lanes.store(self.b, value, self._place(self.b.add(p, whole(1)), i), 0)
        return value

    def _advance(self, p: Any, step: Any) -> None:
        """v+ = v + h a, q+ = q + h v+; what follows them explicit."""
        b, n, after = self.b, self.pairs, self.b.add(p, whole(1))

        def moved(i: Any, slope: Any) -> Any:
            value = b.fadd(self._kept(after, i), b.fmul(step, slope))
            self.lanes.store(b, value, self._place(after, i), 0)
            return value

        with counted(b, n, "pair") as i:
            paired = b.add(i, whole(n))
            moved(i, moved(paired, self._at(self.slope, paired)))
        with counted(b, self.loop.size - 2 * n, "rest") as i:
            other = b.add(i, whole(2 * n))
            moved(other, self._at(self.slope, other))

    def weighted(self, table: Any, line: Any, i: Any) -> Any:
        """Sum of all kept states' component i with the weights of a line of a table (slots of lanes each)."""
        b, lanes = self.b, self.lanes
        with b.goto_entry_block():
            total = b.alloca(lanes.kind, name="weighted")
        b.store(lanes.constant(0.0), total)
        first = b.mul(line, whole(self.slots))
        with counted(b, self.slots, "slot") as slot:
            term = b.fmul(self._at(table, b.add(first, slot)), self._kept(slot, i))
            b.store(b.fadd(b.load(total, typ=lanes.kind), term), total)
        found = b.load(total, typ=lanes.kind)
        parts = [b.extract_element(found, whole(lane)) for lane in range(LANES)]
        return b.fadd(b.fadd(parts[0], parts[1]), b.fadd(parts[2], parts[3]))

    def _vector(self, base: Any, index: Any) -> Any:
        return at(self.b, base, self.b.mul(index, whole(LANES)))

    def _at(self, base: Any, index: Any) -> Any:
        return self.lanes.load(self.b, self._vector(base, index), 0)

    def _place(self, slot: Any, i: Any) -> Any:
        return self._vector(self.kept, self.b.add(self.b.mul(slot, whole(self.loop.size)), i))

    def _kept(self, slot: Any, i: Any) -> Any:
        return self.lanes.load(self.b, self._place(slot, i), 0)

    def _put(self, places: Iterable[tuple[Any, Any]], value: Any) -> None:
        for base, index in places:
            self.lanes.store(self.b, value, self._vector(base, index), 0)
