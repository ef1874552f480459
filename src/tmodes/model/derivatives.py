"""Derivatives of a schedule's outputs: along directions, of weighted outputs in reverse, and by many inputs at once."""

from __future__ import annotations

import threading
from collections import OrderedDict
from collections.abc import Callable, Sequence
from functools import partial
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmodes.compile.ir.derivative_kernels import LANES
from tmodes.compile.ir.linear_solve import aligned, padded
from tmodes.compile.ir.tape import Tape
from tmodes.compile.loops.tape_loop import RowTable, operations
from tmodes.model.passes import Blocks, packed, split

__all__ = ["Columns", "Desk", "Differentiated", "Group", "Ready", "differentiated"]

Array = NDArray[np.float64]
Group = tuple[str, Sequence[Sequence[int]]]


_known: OrderedDict[tuple[str, tuple[str, ...]], Differentiated] = OrderedDict()
_MOST = 24


def differentiated(schedule: Any, outputs: Sequence[str] | None = None) -> Differentiated:
    """A schedule that can be differentiated, as made before for one of the same structure.

    Tables hold no number of the robot; to make them takes longer than a short run.
    """
    key = (schedule.key, tuple(outputs or schedule.outputs))
    if key not in _known:
        _known[key] = Differentiated(schedule, outputs)
        while len(_known) > _MOST:
            _known.popitem(last=False)
    return _known[key]


class Ready(NamedTuple):
    """A table, how wide its slopes are, and where its seeds and its results stand among them."""

    table: RowTable
    lanes: int
    seeds: tuple[int, int]
    found: tuple[int, int]


class Differentiated:
    """A schedule that can be differentiated; ``outputs``: those wanted, all by default.

    Tables are made once for each set of inputs, and kept. Blocks are arrays (n, size) by the names of the inputs.
    """

    def __init__(self, schedule: Any, outputs: Sequence[str] | None = None) -> None:
        self.schedule = schedule
        self.outputs = {name: schedule.outputs[name] for name in (outputs or schedule.outputs)}
        self.tape = Tape(schedule, list(self.outputs))
        self._made: dict[Any, Any] = {}

    def values(self, parameters: Array, blocks: Blocks) -> Blocks:
        """The outputs themselves by name, (n, size)."""
        size = self.tape.output_size
        ready = self.kept("values", lambda: Ready(self.tape.values(), 1, (0, 0), (self.tape.end, size)))
        nothing = np.empty((len(next(iter(blocks.values()))), 0))
        return split(self._run(ready, parameters, blocks, nothing, None), self.outputs)

    def along(self, parameters: Array, blocks: Blocks, directions: Blocks, *, change: Array | None = None) -> Blocks:
        """Slopes of the outputs by name, (n, size), along a direction of the inputs named, and of the parameters.

        ``change`` (parameters,): that of the parameters, the same at all samples. Costs about 2.5 evaluations.
        """
        names = tuple(name for name in self.schedule.inputs if name in directions)
        ready = self.kept(("along", names, change is not None), lambda: self._along(names, change is not None))
        count = len(next(iter(blocks.values())))
        size = self.schedule.input_size
        seeds = [directions.get(name, np.zeros((count, slot.size))) for name, slot in self.schedule.inputs.items()]
        slopes = np.zeros(self.tape.size)
        slopes[: 0 if change is None else len(parameters)] = change if change is not None else ()
        along = np.concatenate(seeds, axis=1).reshape(count, size)
        return split(self._run(ready, parameters, blocks, along, slopes), self.outputs)

    def back(self, parameters: Array, blocks: Blocks, weights: Blocks, names: Sequence[str]) -> Blocks:
        """Sums of ``weights`` times the derivatives of the outputs by the inputs named, (n, size).

        ``weights``: (n, size) by names of outputs. With ``parameters`` among the names also by each of them, summed
        over the samples, (parameters,). Costs about 3.5 evaluations, whatever the number of inputs.
        """
        wanted = tuple(sorted(names))
        ready = self.kept(("back", wanted), lambda: self._back(wanted))
        count = len(next(iter(blocks.values())))
        sizes = {name: sum(slot.size for slot in slots) for name, slots in self.outputs.items()}
        seeds = np.concatenate([weights.get(name, np.zeros((count, size))) for name, size in sizes.items()], axis=1)
        slopes = np.zeros(self.tape.size)
        found = self._run(ready, parameters, blocks, seeds, slopes)
        first = self.schedule.parameters
        parts = {name: found[:, start - first :][:, :size] for name, (start, size) in self._spans(names).items()}
        return parts | ({"parameters": slopes[:first].copy()} if "parameters" in wanted else {})

    def columns(self, groups: Sequence[Group]) -> Columns:
        """Ready to compute the derivatives of the outputs by the elements of inputs that ``groups`` name."""
        key = ("columns", tuple((name, tuple(map(tuple, bodies))) for name, bodies in groups))
        return Columns(self, groups, self.kept(key, lambda: self._columns(groups)))

    def desk(self, way: str, name: str) -> Desk:
        """Ready for one sample after another, by one input: ``back`` in reverse, ``along`` eight directions of it."""

        def make() -> Ready:
            marks, table = self.tape.marked([self.tape.span(name)]), self.tape.values()
            found, (first, size) = (self.tape.end, self.tape.output_size), self._inputs()
            if way == "back":
                table.extend(self.tape.back(marks, self.tape.marked([])))
                return Ready(table, 1, found, (first, size))
            table.extend(self.tape.along(marks, LANES))
            return Ready(table, LANES, (LANES * first, LANES * size), (LANES * found[0], LANES * found[1]))

        return Desk(self.tape, self.kept(("desk", way, name), make))

    def kept(self, key: Any, make: Callable[[], Any]) -> Any:
        """What was made for a key, once."""
        if key not in self._made:
            self._made[key] = make()
        return self._made[key]

    def _spans(self, names: Sequence[str]) -> dict[str, tuple[int, int]]:
        return {name: self.tape.span(name) for name in names if name != "parameters"}

    def _inputs(self) -> tuple[int, int]:
        return self.schedule.parameters, self.schedule.input_size

    def _along(self, names: Sequence[str], changes: bool) -> Ready:
        known = [(0, self.schedule.parameters)] if changes else []
        marks = self.tape.marked([*self._spans(names).values(), *known])
        return Ready(self.tape.along(marks, 1, valued=True), 1, self._inputs(), (self.tape.end, self.tape.output_size))

    def _back(self, names: Sequence[str]) -> Ready:
        own = self.tape.marked([(0, self.schedule.parameters)] if "parameters" in names else [])
        wanted = self.tape.marked([*self._spans(names).values()]) | own
        table = self.tape.values()
        table.extend(self.tape.back(wanted, own))
        return Ready(table, 1, (self.tape.end, self.tape.output_size), self._inputs())

    def _columns(self, groups: Sequence[Group]) -> Ready:
        table = self.tape.values()
        start = target = LANES * self.tape.size
        for name, bodies in groups:
            first, _ = self.tape.span(name)
            order = [element for body in bodies for element in body]
            for k in range(0, len(order), LANES):
                chosen = order[k : k + LANES]
                marked = [element for body in bodies if set(body) & set(chosen) for element in body]
                for element in marked:
                    lane = [chosen.index(element)] if element in chosen else []
                    table.operation("unit" if lane else "clear", LANES * (first + element), LANES, *lane)
                marks = self.tape.marked([(first + element, 1) for element in marked])
                table.extend(self.tape.along(marks, LANES, target=target, seldom=True))
                target += LANES * self.tape.output_size
        return Ready(table, LANES, (0, 0), (start, target - start))

    def _run(self, ready: Ready, parameters: Array, blocks: Blocks, seeds: Array, slopes: Array | None) -> Array:
        """Run a table at all samples; without ``slopes`` what is found stands among the values."""
        inputs = packed(self.schedule, blocks)
        count, seeds = len(inputs), np.ascontiguousarray(seeds)
        values, found = np.empty(self.tape.size), np.empty((count, ready.found[1]))
        values[: len(parameters)] = parameters
        counts = (count, ready.table.rows, *self._inputs(), *ready.seeds, *ready.found)
        arrays = (ready.table.words, values, values if slopes is None else slopes, inputs, seeds, found)
        operations()["samples"](*counts, *(array.ctypes.data for array in arrays))
        return found


class Columns:
    """Derivatives of all outputs by many elements of inputs, eight directions side by side.

    A group names an input, and lists of its elements that belong to one body. Only what depends on a direction is
    computed for it, so the order matters: neighbours should touch the same calls.
    """

    def __init__(self, of: Differentiated, groups: Sequence[Group], ready: Ready) -> None:
        self.tape, self.ready, self._own = of.tape, ready, threading.local()
        self.place: dict[str, slice | NDArray[np.intp]] = {}
        """By the name of an input: the column of each of its elements, in their own order."""
        self.width = first = 0
        for name, bodies in groups:
            order = np.array([element for body in bodies for element in body], dtype=int)
            where = first + np.argsort(order)
            straight = np.array_equal(order, np.arange(len(order)))
            self.place[name] = slice(first, first + len(order)) if straight else where
            self.width = first = first + padded(len(order))

    @property
    def calls(self) -> int:
        """How many calls the outputs need: none, and all derivatives are zero."""
        return len(self.tape.calls)

    def at(self, parameters: Array, inputs: Array, out: Array) -> None:
        """One sample, its inputs packed; ``out`` (outputs, width) is filled, with zeros between the groups."""
        desk, size = self._run(parameters, inputs), self.tape.output_size
        if not out.size:  # nothing moves
            return
        out.reshape(size, -1, LANES)[:] = desk.found.reshape(-1, size, LANES).transpose(1, 0, 2)

    def values(self, parameters: Array, inputs: Array) -> Array:
        """The outputs themselves at one sample, (outputs,)."""
        return self._run(parameters, inputs).values[self.tape.end :][: self.tape.output_size].copy()

    def _run(self, parameters: Array, inputs: Array) -> Desk:
        desk: Desk | None = getattr(self._own, "desk", None)
        if desk is None:
            desk = self._own.desk = Desk(self.tape, self.ready)
        desk.values[: len(parameters)] = parameters
        desk.inputs[:] = inputs
        desk.run()
        return desk


class Desk:
    """Memory of one thread for one table at one sample, kept between calls.

    ``values`` begin with the parameters; ``inputs`` (size,), packed; ``seeds`` and what is ``found``, where eight
    directions are carried along with the lanes last.
    """

    def __init__(self, tape: Tape, ready: Ready) -> None:
        start, count = ready.found
        taken = (tape.schedule.parameters, tape.schedule.input_size)
        self.values, self.inputs, self.seeds = np.zeros(tape.size), np.empty(taken[1]), np.zeros(ready.seeds[1])
        self.slopes, self.found = aligned(max(start + count, ready.lanes * tape.size)), np.empty(count)
        arrays = (ready.table.words, self.values, self.slopes, self.inputs, self.seeds, self.found)
        addresses = (array.ctypes.data for array in arrays)
        arguments = (1, ready.table.rows, *taken, *ready.seeds, start, count, *addresses)
        self.run: Callable[[], None] = partial(operations()["samples"], *arguments)
