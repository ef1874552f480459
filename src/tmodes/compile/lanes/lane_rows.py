"""A schedule at many samples side by side: rows of single numbers become vectors of lanes, and vectors rows again."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from llvmlite import ir

from tmodes.compile.ir.arithmetic import Lanes
from tmodes.compile.ir.block import call_prepare, write_main
from tmodes.compile.ir.calls import I32, table_of
from tmodes.compile.ir.emit import I64, POINTER, VOID, at, counted, declare, load, store, whole
from tmodes.compile.ir.unroll import pays
from tmodes.compile.lanes.lanes_memory import Layout

__all__ = ["write_lane_samples"]


def write_lane_samples(module: Any, schedule: Any, lanes: Lanes, name: str) -> None:
    """The function of :func:`tmodes.compile.ir.block.write_samples` over lanes: n counts groups of them.

    Each vector is put together before it is stored: one that is loaded soon after its parts were stored is waited for.
    """
    layout = None if pays(schedule) else Layout(schedule)
    offset = layout.offset if layout else schedule.offset
    main = write_main(module, schedule, lanes, f"{name}.main", layout.offset if layout else None)
    labels = [("n", I64), ("each", I64), ("p", POINTER), ("workspace", POINTER), ("in", POINTER), ("out", POINTER)]
    function = declare(module, name, VOID, labels)
    count, each, parameters, workspace, source, target = function.args
    b = ir.IRBuilder(function.append_basic_block("entry"))
    taken = _places(schedule.inputs.values(), offset)
    given = _places((slot for slots in schedule.outputs.values() for slot in slots), offset)
    own = list(range(schedule.parameters))
    alike, apart = b.function.append_basic_block("alike"), b.function.append_basic_block("apart")
    b.cbranch(b.icmp_signed("!=", each, whole(0)), apart, alike)
    b.position_at_end(alike)
    _gather(b, lanes, parameters, workspace, own, 0)
    call_prepare(b, main, workspace)
    b.branch(apart)
    b.position_at_end(apart)
    with counted(b, count, "sample") as sample:
        with b.if_then(b.icmp_signed("!=", each, whole(0))):
            first = at(b, parameters, b.mul(sample, whole(len(own) * lanes.stride)))
            _gather(b, lanes, first, workspace, own, len(own))
            call_prepare(b, main, workspace)
        first = at(b, source, b.mul(sample, whole(len(taken) * lanes.stride)))
        _gather(b, lanes, first, workspace, taken, len(taken))
        b.call(main, [workspace])
        first = at(b, target, b.mul(sample, whole(len(given) * lanes.stride)))
        _scatter(b, lanes, workspace, first, given)
    b.ret_void()


def _places(slots: Any, offset: Any) -> list[int]:
    """Where the numbers of a row stand in the workspace, in vectors."""
    return [place for slot in slots for place in range(offset(slot), offset(slot) + slot.size)]


def _gather(b: Any, lanes: Lanes, rows: Any, workspace: Any, places: list[int], apart: int) -> None:
    """Rows that begin ``apart`` numbers after each other (0: one row for all) into the vectors at ``places``."""
    with _numbers(b, lanes, places, "in") as (k, place):
        vector = lanes.constant(0.0)
        for lane in range(lanes.stride):
            vector = b.insert_element(vector, load(b, rows, b.add(k, whole(lane * apart))), whole(lane))
        lanes.store(b, vector, at(b, workspace, place), 0)


def _scatter(b: Any, lanes: Lanes, workspace: Any, rows: Any, places: list[int]) -> None:
    """The vectors at ``places`` into rows, one after the other."""
    with _numbers(b, lanes, places, "out") as (k, place):
        vector = lanes.load(b, at(b, workspace, place), 0)
        for lane in range(lanes.stride):
            value = b.extract_element(vector, whole(lane))
            store(b, value, rows, b.add(k, whole(lane * len(places))))


@contextmanager
def _numbers(b: Any, lanes: Lanes, places: list[int], label: str) -> Iterator[tuple[Any, Any]]:
    """Each number's index in a row, and its place in the workspace, in doubles; by a table where they lie about."""
    first = places[0] if places else 0
    together = places == list(range(first, first + len(places)))
    with counted(b, len(places), label) as k:
        if together:
            yield k, b.mul(b.add(k, whole(first)), whole(lanes.stride))
            return
        name = f"{b.function.name}.{label}"
        table = b.function.module.globals.get(name) or table_of(b, name, [place * lanes.stride for place in places])
        yield k, b.sext(b.load(b.gep(table, [k], source_etype=I32), typ=I32), I64)
