"""Groups of native functions, each made at its first use and kept on disk: a second start reads them in no time."""

from __future__ import annotations

import gc
from collections import OrderedDict
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from functools import partial
from typing import Any

from tmodes.compile import cache
from tmodes.compile.native import Library, host, kernel_symbol, pays, to_object

__all__ = [
    "arithmetic_of", "called", "kernel_code", "kernels_of", "library", "native_functions", "row_function",
    "schedule_function", "schedule_module",
]  # fmt: skip


_loaded: OrderedDict[str, Library] = OrderedDict()
_KEPT = 512


def library(
    name: str,
    key: str,
    write: Callable[[], Any],
    functions: dict[str, int],
    level: int | None = None,
    imports: Callable[[], Mapping[str, Library]] = dict,
    *,
    tidy: bool = True,
) -> Library:
    """The functions of one module: as loaded before, from the cache, or written, optimised and kept.

    Without a ``level`` it follows from what is written.
    """
    key = f"{name}\n{key}\n{host()}\n{cache.source_digest()}"
    if key not in _loaded:
        with _without_collector():
            _loaded[key] = Library(name, _binary(key, write, level, tidy=tidy), functions, imports())
        while len(_loaded) > _KEPT:
            _loaded.popitem(last=False)
    _loaded.move_to_end(key)
    return _loaded[key]


def _binary(key: str, write: Callable[[], Any], level: int | None, *, tidy: bool) -> bytes:
    binary = cache.load(key)
    if binary is None:
        binary = to_object(*write()) if level is None else to_object(write(), level, tidy=tidy)
        cache.save(key, binary)
    return binary


@contextmanager
def _without_collector() -> Iterator[None]:
    """Python's cyclic garbage collector waits: it would look at all objects of all modules again and again meanwhile.

    That took an eighth of the time to compile.
    """
    was_on = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if was_on:
            gc.enable()


def kernels_of(schedule: Any, arithmetic: str) -> dict[str, Library]:
    """The libraries of all kernels that a schedule calls, by symbol; each is made once, whatever schedule needs it."""
    kernels = {kernel_symbol(kernel, arithmetic): kernel for kernel, _, _ in schedule.calls}
    level = _level(arithmetic, often=schedule.often)
    return {symbol: _kernel(symbol, kernel, arithmetic, level) for symbol, kernel in kernels.items()}


def called(schedule: Any, arithmetic: str) -> dict[str, Library]:
    """The same of a schedule as it is written, if any: one that is unrolled calls nothing."""
    unrolled = not schedule or (arithmetic_of(arithmetic).unrolls and pays(schedule))
    return {} if unrolled else kernels_of(schedule, arithmetic)


def _level(arithmetic: str, *, often: bool) -> int:
    """Work for the code of a kernel: of one that is seldom called, quick to compile is worth more than quick to run.

    Differentiated code is twice as long and seldom called too, and so are programs of lowering (``exact``).
    """
    seldom = arithmetic in ("derivative", "second") or arithmetic.startswith("exact")
    return 0 if seldom or (arithmetic == "double" and not often) else 1


def _kernel(symbol: str, kernel: Any, arithmetic: str, level: int) -> Library:
    functions = {symbol: len(kernel.inputs) + len(kernel.outputs)}
    write = partial(kernel_code, kernel, arithmetic)
    return library(symbol, f"{symbol} {level}", write, functions, level, tidy=kernel.long)


def kernel_code(kernel: Any, arithmetic: str) -> str:
    """The IR of one kernel as text, written once for native code and for that of pages."""
    from llvmlite import ir

    from tmodes.compile.ir.block import write_program
    from tmodes.compile.ir.program import kernel_program

    program = kernel_program(kernel)
    if arithmetic not in program.codes:
        module = ir.Module(kernel_symbol(kernel, arithmetic))
        write_program(module, module.name, program, arithmetic_of(arithmetic)(module))
        program.codes[arithmetic] = str(module)
    return program.codes[arithmetic]


def arithmetic_of(name: str) -> Any:
    """The kind of numbers of a name: ``double``, ``lanes`` or ``derivative``, ``exact``: without fused products."""
    from tmodes.compile.ir.arithmetic import Derivative, Double, Exact, Lanes, Second, Wide

    return {kind.name: kind for kind in (Double, Lanes, Wide, Exact, Derivative, Second)}[name]


def schedule_function(name: str, schedule: Any, arithmetic: str) -> Library:
    """The function ``run(n, each, parameters, workspace, in, out)`` of a schedule of kernels over many samples.

    ``arithmetic``: ``double``, ``lanes`` (four samples at once; ``wide8``: eight) or ``derivative`` (each with a
    direction; ``second``: with two).
    """
    write, imports = partial(schedule_module, schedule, arithmetic, "run"), partial(called, schedule, arithmetic)
    level = _level(arithmetic, often=schedule.often)
    return library(f"{name}.{arithmetic}", schedule.key, write, {"run": 6}, level, imports, tidy=False)


def schedule_module(schedule: Any, arithmetic: str, symbol: str) -> Any:
    """The IR of the function of :func:`schedule_function`, called ``symbol``."""
    from llvmlite import ir

    from tmodes.compile.ir.block import write_samples

    module = ir.Module(symbol)
    write_samples(module, schedule, arithmetic_of(arithmetic)(module), symbol)
    return module


def native_functions(name: str, write: Callable[[], Any], functions: dict[str, int]) -> Library:
    """Functions, with their numbers of arguments, of the module that ``write`` gives; ``name`` says all of it."""
    return library(name, name, write, functions, 2)


def row_function(symbol: str, write: Callable[[], tuple[Any, int]]) -> Library:
    """One function ``symbol(values, slopes, row)``; ``write`` gives its module and the level."""
    return library(symbol, symbol, write, {symbol: 3})
