"""The exact Jacobian of a schedule's rates, column by column in native code, by forward differentiation of its kernels.

Every number of the workspace is next to its derivative; a column is one pass with the direction of one state.
"""

from __future__ import annotations

from typing import Any

from tmodes.compile.ir.arithmetic import Derivative
from tmodes.compile.ir.block import write_main
from tmodes.compile.ir.builder import Builder
from tmodes.compile.ir.emit import F64, POINTER, VOID, counted, declare, load, number, store, whole

__all__ = ["RateJacobian"]


class RateJacobian:
    """Writes ``prepare(parameters, held)`` and ``call(time, state, row, held, by_state, by_time)`` into a module.

    ``by_state``: (outputs, columns), row by row, the derivatives by the first ``columns`` numbers of the state;
    ``by_time``: (outputs,). ``held_size``: numbers of the memory that the caller keeps.
    """

    def __init__(self, module: Any, schedule: Any, columns: int, name: str) -> None:
        self.schedule, self.columns, self.held_size = schedule, columns, 2 * schedule.workspace
        self.main = write_main(module, schedule, Derivative(module), f"{name}.main")
        self.prepare = self._write_prepare(module, f"{name}.prepare")
        self.call = self._write_call(module, f"{name}.call")

    def _write_prepare(self, module: Any, name: str) -> Any:
        labels = [("parameters", POINTER), ("held", POINTER)]
        function = declare(module, name, VOID, labels, private=True)
        b = Builder(function.append_basic_block("entry"))
        with counted(b, self.schedule.workspace, "number") as k:
            self._put(b, function.args[1], k, number(0.0))
        with counted(b, self.schedule.parameters, "parameter") as k:
            self._put(b, function.args[1], k, load(b, function.args[0], k))
        b.ret_void()
        return function

    def _write_call(self, module: Any, name: str) -> Any:
        pointers = [(label, POINTER) for label in ("state", "row", "held", "by_state", "by_time")]
        function = declare(module, name, VOID, [("time", F64), *pointers], private=True)
        function.attributes.add("noinline")
        time, state, row, held, by_state, by_time = function.args
        b = Builder(function.append_basic_block("entry"))
        inputs = self.schedule.inputs
        places = {label: self.schedule.offset(slot) for label, slot in inputs.items()}
        for label, source in (("state", state), ("row", row)):
            with counted(b, inputs[label].size, label) as k:
                self._put(b, held, b.add(k, whole(places[label])), load(b, source, k))
        self._put(b, held, whole(places["time"]), time)
        with counted(b, self.columns, "column") as k:
            self._column(b, held, b.add(k, whole(places["state"])), by_state, k, self.columns)
        self._column(b, held, whole(places["time"]), by_time, whole(0), 1)
        b.ret_void()
        return function

    def _put(self, b: Any, held: Any, place: Any, value: Any) -> None:
        """A number that does not change."""
        first = b.mul(place, whole(2))
        store(b, value, held, first)
        store(b, number(0.0), held, b.add(first, whole(1)))

    def _column(self, b: Any, held: Any, place: Any, into: Any, column: Any, width: int) -> None:
        """The derivatives of all outputs along one number of the workspace."""
        slope = b.add(b.mul(place, whole(2)), whole(1))
        store(b, number(1.0), held, slope)
        b.call(self.main.function, [held])
        first = 0
        for slots in self.schedule.outputs.values():
            for slot in slots:
                start = 2 * self.schedule.offset(slot) + 1
                with counted(b, slot.size, "output") as k:
                    found = load(b, held, b.add(b.mul(k, whole(2)), whole(start)))
                    line = b.mul(b.add(k, whole(first)), whole(width))
                    store(b, found, into, b.add(line, column))
                first += slot.size
        store(b, number(0.0), held, slope)  # not before: an output may be an input itself
