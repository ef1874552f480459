"""A native loop around any native time loop: step by step, keeping where each step starts."""

from __future__ import annotations

import ctypes
from functools import cache
from typing import Any, NamedTuple

import numpy as np
from llvmlite import ir
from numpy.typing import NDArray

from tmodes.compile.ir.emit import I64, POINTER, VOID, Builder, at, counted, load, number, store, whole
from tmodes.compile.ir.kernels import native_functions
from tmodes.compile.loops.tape_loop import WORDS
from tmodes.compile.loops.time_loop import ARGUMENTS, CELLS, Status
from tmodes.compile.native import Library

__all__ = ["Steps", "record_steps"]

Array = NDArray[np.float64]

_WHOLE = ("loop", "capacity", "size", "every", "total")
_WORDS, _REAL = ("arguments", "taken", "segments"), ("memory", "y", "t", "states", "evaluations")


class Steps(NamedTuple):
    """Starts of steps: time (n,), segment (n,), and the state of every so many, (n / every, size).

    ``evaluations`` (n,): of the attempt that was taken.
    """

    t: Array
    segments: NDArray[np.int64]
    states: Array
    evaluations: Array


def record_steps(loop: Any, arguments: dict[str, Any], *, capacity: int, every: int = 1, total: int = 0) -> Steps:
    """Take at most ``capacity`` steps, of which ``total`` went before; fewer where the loop ends.

    ``arguments``: those of the loop by name, with its option ``chunk`` at 1; ``memory`` and ``y`` as arrays.
    """
    size = len(arguments["y"])
    t, segments, taken = np.empty(capacity), np.empty(capacity, dtype=np.int64), np.zeros(1, dtype=np.int64)
    states, evaluations = np.empty((capacity // every + 2, size)), np.empty(capacity)
    addresses = [value if isinstance(value, int) else value.ctypes.data for value in arguments.values()]
    given = {
        "loop": ctypes.cast(loop, ctypes.c_void_p).value, "capacity": capacity, "size": size, "every": every,
        "total": total, "arguments": np.array(addresses, dtype=np.int64), "taken": taken, "segments": segments,
        "memory": arguments["memory"], "y": arguments["y"], "t": t, "states": states,
        "evaluations": evaluations,
    }  # fmt: skip
    values = [given[name] for name in (*_WHOLE, *_WORDS, *_REAL)]
    _library()["record"](*(value.ctypes.data if isinstance(value, np.ndarray) else value for value in values))
    count = int(taken[0])
    kept = -(-(total + count) // every) - -(-total // every)
    return Steps(t[:count], segments[:count], states[:kept], evaluations[:count])


@cache
def _library() -> Library:
    return native_functions(f"record {len(ARGUMENTS)}", _write, {"record": len((*_WHOLE, *_WORDS, *_REAL))})


def _write() -> Any:
    module = ir.Module("record")
    kinds = [(name, I64) for name in _WHOLE] + [(name, WORDS) for name in _WORDS] + [(name, POINTER) for name in _REAL]
    function = ir.Function(module, ir.FunctionType(VOID, [kind for _, kind in kinds]), "record")
    given = {name: argument for (name, _), argument in zip(kinds, function.args, strict=True)}
    b: Any = Builder(function.append_basic_block("entry"))
    kind = ir.FunctionType(VOID, [I64] * len(ARGUMENTS))
    loop = b.inttoptr(given["loop"], kind.as_pointer())
    passed = [_word(b, given["arguments"], whole(k)) for k in range(len(ARGUMENTS))]
    fresh = b.alloca(I64, name="fresh")
    b.store(whole(1), fresh)
    head, body, after = (function.append_basic_block(name) for name in ("head", "body", "after"))
    b.branch(head)
    b.position_at_end(head)
    taken, running = _word(b, given["taken"], whole(0)), number(float(Status.RUNNING))
    going = b.fcmp_ordered("==", _cell(b, given, "status"), running)
    b.cbranch(b.and_(going, b.icmp_signed("<", taken, given["capacity"])), body, after)
    b.position_at_end(body)
    _step(b, given, taken, fresh, lambda: b.call(loop, passed))
    b.branch(head)
    b.position_at_end(after)
    b.ret_void()
    return module


def _step(b: Any, given: dict[str, Any], taken: Any, fresh: Any, advance: Any) -> None:
    """One attempt of a step; ``fresh``: the first one, before samples at its start; others keep the state of that."""
    steps, segment = _cell(b, given, "steps"), b.fptosi(_cell(b, given, "segment"), I64)
    evaluations = _cell(b, given, "evaluations")
    store(b, _cell(b, given, "t"), given["t"], taken)
    b.store(segment, b.gep(given["segments"], [taken], source_etype=I64))
    whole_run = b.add(given["total"], taken)
    wanted = b.icmp_signed("==", b.srem(whole_run, given["every"]), whole(0))
    with b.if_then(b.and_(wanted, b.icmp_signed(">", b.load(fresh, typ=I64), whole(0)))):
        up = b.sub(given["every"], whole(1))
        before = b.sdiv(b.add(given["total"], up), given["every"])
        slot = b.sub(b.sdiv(whole_run, given["every"]), before)
        target = at(b, given["states"], b.mul(slot, given["size"]))
        with counted(b, given["size"], "state") as k:
            store(b, load(b, given["y"], k), target, k)
    advance()
    store(b, b.fsub(_cell(b, given, "evaluations"), evaluations), given["evaluations"], taken)
    more = b.fcmp_ordered(">", _cell(b, given, "steps"), steps)
    b.store(b.zext(more, I64), fresh)
    b.store(b.add(taken, b.zext(more, I64)), given["taken"])


def _cell(b: Any, given: dict[str, Any], name: str) -> Any:
    return load(b, given["memory"], CELLS.index(name))


def _word(b: Any, words: Any, index: Any) -> Any:
    return b.load(b.gep(words, [index], source_etype=I64), typ=I64)
