"""The native loop that runs a table of rows, and the small operations that a table needs besides kernels."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache, cached_property
from typing import Any

import numpy as np
from llvmlite import ir
from numpy.typing import NDArray

from tmodes.compile.ir.emit import F64, I64, POINTER, VOID, Builder, at, counted, declare, load, store, whole
from tmodes.compile.ir.kernels import native_functions
from tmodes.compile.ir.linear_solve import BLOCK, write_elimination
from tmodes.compile.native import Library

__all__ = ["WORDS", "RowTable", "operations", "write_run"]

WORDS = I64.as_pointer()

_ROW = ir.FunctionType(VOID, [POINTER, POINTER, WORDS])

_SAMPLES = (
    "n", "rows", "in_start", "in_size", "seed_start", "seed_size", "found_start", "found_size",
    "table", "values", "slopes", "in", "seeds", "found",
)  # fmt: skip
"""Arguments of ``samples``: eight counts, then pointers."""


_OPERATIONS = ("move", "move_values", "gain", "clear", "unit")
_MATRICES = ("table", "columns", "more_columns", "diagonal", "solve")


@cache
def operations() -> Library:
    """The operations of rows, ``kernel(values, slopes, row)``, and ``samples``, which runs a table at n samples.

    ``move`` and ``gain`` (to, from, count): slopes are copied, or added to others; ``move_values``: the same of values;
    ``clear`` (start, count): zero; ``unit`` (start, count, lane): zero but for one lane. ``table`` (address, rows,
    values, slopes): run another table, whose blocks start there. ``columns`` (to, stride, from, size, groups): slopes
    of ``size`` outputs in groups of eight lanes become columns of a matrix, or are added to them (``more_columns``);
    ``diagonal`` (to, step, from, count): add; ``solve`` (n, blocks, rows, failed): as :mod:`elimination` does.
    """
    functions = dict.fromkeys((*_OPERATIONS, *_MATRICES), 3) | {"samples": len(_SAMPLES)}
    return native_functions("tape", _write, functions)


class RowTable:
    """Rows (address of a function, words of the row, its numbers), and the libraries that they jump into."""

    def __init__(self) -> None:
        self._words: list[int] = []
        self._libraries: dict[str, Library] = {}
        self.rows = 0

    def add(self, symbol: str, library: Library, numbers: Sequence[int]) -> None:
        """Append a row."""
        self._libraries[symbol] = library  # kept alive: the table holds addresses inside it
        self._words += [library.address(symbol), 2 + len(numbers), *numbers]
        self.rows += 1

    def operation(self, name: str, *numbers: int) -> None:
        """Append a row of one of the :func:`operations`."""
        self.add(name, operations(), numbers)

    def extend(self, other: RowTable) -> None:
        """Append all rows of another table."""
        self._words += other._words
        self._libraries |= other._libraries
        self.rows += other.rows

    @cached_property
    def words(self) -> NDArray[np.int64]:
        """The finished table."""
        return np.array(self._words, dtype=np.int64)


def _write() -> Any:
    module = ir.Module("tape")
    for name in _OPERATIONS:
        _write_operation(module, name)
    run = write_run(module)
    _write_samples(module, run)
    _write_matrices(module, run)
    return module


def _write_matrices(module: Any, run: Any) -> None:
    solve = write_elimination(module, "eliminate", private=True)
    for name in _MATRICES:
        function = declare(module, name, VOID, [("values", POINTER), ("slopes", POINTER), ("row", WORDS)])
        values, slopes, row = function.args
        b: Any = Builder(function.append_basic_block("entry"))
        word = [_word(b, row, k) for k in range({"columns": 5, "more_columns": 5}.get(name, 4))]
        if name == "table":
            inner = b.inttoptr(word[0], WORDS)
            b.call(run, [word[1], inner, at(b, values, word[2]), at(b, slopes, word[3])])
        elif name == "solve":
            b.call(solve, [word[0], word[1], at(b, slopes, word[2]), at(b, slopes, word[3])])
        elif name == "diagonal":
            with counted(b, word[3]) as k:
                place = b.add(word[0], b.mul(k, word[1]))
                store(b, b.fadd(load(b, slopes, place), load(b, slopes, b.add(word[2], k))), slopes, place)
        else:
            _columns(b, slopes, word, adds=name == "more_columns")
        b.ret_void()


def _columns(b: Any, slopes: Any, word: list[Any], *, adds: bool) -> None:
    to, stride, source, size, groups = word
    wide = ir.VectorType(F64, BLOCK)
    with counted(b, groups, "group") as group, counted(b, size, "output") as output:
        place = b.add(b.add(to, b.mul(output, stride)), b.mul(group, whole(BLOCK)))
        here = b.bitcast(at(b, slopes, place), wide.as_pointer())
        from_ = b.add(source, b.mul(b.add(b.mul(group, size), output), whole(BLOCK)))
        value = b.load(b.bitcast(at(b, slopes, from_), wide.as_pointer()), align=8, typ=wide)
        b.store(b.fadd(value, b.load(here, align=8, typ=wide)) if adds else value, here, align=8)


def _write_operation(module: Any, name: str) -> None:
    function = declare(module, name, VOID, [("values", POINTER), ("slopes", POINTER), ("row", WORDS)])
    values, slopes, row = function.args
    array = values if name == "move_values" else slopes
    b = Builder(function.append_basic_block("entry"))
    start, second = _word(b, row, 0), _word(b, row, 1)
    copies = name in ("move", "move_values", "gain")
    with counted(b, _word(b, row, 2) if copies else second) as i:
        place = b.add(start, i)
        value = load(b, array, b.add(second, i)) if copies else ir.Constant(F64, 0.0)
        if name == "gain":
            value = b.fadd(value, load(b, array, place))
        store(b, value, array, place)
    if name == "unit":
        store(b, ir.Constant(F64, 1.0), array, b.add(start, _word(b, row, 2)))
    b.ret_void()


def write_run(module: Any) -> Any:
    """The private ``run(rows, table, values, slopes)``: calls the function of each row."""
    arguments = [("rows", I64), ("table", WORDS), ("values", POINTER), ("slopes", POINTER)]
    run = declare(module, "run", VOID, arguments, private=True)
    run.attributes.add("noinline")
    count, table, values, slopes = run.args
    b = Builder(run.append_basic_block("entry"))
    place = b.alloca(WORDS)
    b.store(table, place)
    with counted(b, count, "row"):
        row = b.load(place, typ=WORDS)
        function = b.inttoptr(_word(b, row, 0), _ROW.as_pointer())
        b.call(function, [values, slopes, _words(b, row, whole(2))])
        b.store(_words(b, row, _word(b, row, 1)), place)
    b.ret_void()
    return run


def _word(b: Any, row: Any, index: int) -> Any:
    return b.load(_words(b, row, whole(index)), typ=I64)


def _words(b: Any, row: Any, index: Any) -> Any:
    return b.gep(row, [index], source_etype=I64)


def _write_samples(module: Any, run: Any) -> None:
    """For each sample: its inputs among the values, its seeds among the slopes, the table, and what is found there."""
    kinds = [I64] * 8 + [WORDS] + [POINTER] * 5
    function = declare(module, "samples", VOID, list(zip(_SAMPLES, kinds, strict=True)))
    given: dict[str, Any] = dict(zip(_SAMPLES, function.args, strict=True))
    b = Builder(function.append_basic_block("entry"))
    with counted(b, given["n"], "sample") as sample:
        for label, array in (("in", "values"), ("seed", "slopes")):
            source = given["in" if label == "in" else "seeds"]
            with counted(b, given[f"{label}_size"], label) as i:
                value = load(b, source, b.add(b.mul(sample, given[f"{label}_size"]), i))
                store(b, value, given[array], b.add(given[f"{label}_start"], i))
        b.call(run, [given[label] for label in ("rows", "table", "values", "slopes")])
        with counted(b, given["found_size"], "found") as i:
            place = b.add(b.mul(sample, given["found_size"]), i)
            store(b, load(b, given["slopes"], b.add(given["found_start"], i)), given["found"], place)
    b.ret_void()
