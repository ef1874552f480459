"""Groups of native functions, each made at its first use and kept on disk: a second start reads them in no time."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable, Mapping
from functools import partial
from typing import Any

from tmodes.compile import cache
from tmodes.compile.native import Library, host, to_object

__all__ = ["native_functions", "row_function", "sample_functions", "schedule_function", "schedule_loops", "time_loops"]


_loaded: OrderedDict[str, Library] = OrderedDict()
_KEPT = 512


def _library(
    name: str,
    key: str,
    write: Callable[[], Any],
    functions: dict[str, int],
    level: int | None = None,
    imports: Callable[[], Mapping[str, Library]] = dict,
) -> Library:
    """The functions of one module: as loaded before, from the cache, or written, optimised and kept.

    Without a ``level`` what is written tells it.
    """
    key = f"{name}\n{key}\n{host()}\n{cache.source_digest()}"
    if key not in _loaded:
        _loaded[key] = Library(name, _binary(key, write, level), functions, imports())
        while len(_loaded) > _KEPT:
            _loaded.popitem(last=False)
    _loaded.move_to_end(key)
    return _loaded[key]


def _binary(key: str, write: Callable[[], Any], level: int | None) -> bytes:
    binary = cache.load(key)
    if binary is None:
        binary = to_object(*write()) if level is None else to_object(write(), level)
        cache.save(key, binary)
    return binary


def sample_functions(name: str, key: str, make: Callable[[], Mapping[str, Any]], inputs: Mapping[str, int]) -> Library:
    """Functions over many samples; ``make`` gives a CasADi function for each name, parameters last.

    ``inputs`` holds the number of inputs of each, parameters not counted.
    """

    def write() -> Any:
        from llvmlite import ir

        from tmodes.compile.lower import lower
        from tmodes.compile.program import straight_line
        from tmodes.compile.sample_loop import write_sample_loop

        module = ir.Module(name)
        for label, function in make().items():
            program = straight_line(function, invariant=inputs[label])
            write_sample_loop(module, label, lower(module, program))
        return module

    # Called for some thousand samples: ten times quicker to compile is worth more here than quicker to run.
    return _library(name, key, write, {label: count + 3 for label, count in inputs.items()}, level=0)


def time_loops(name: str, key: str, make: Callable[[], Any], guarded: int) -> Library:
    """The native time loops around one right-hand side of (time, state, row, parameters)."""
    from tmodes.compile.time_loop import ARGUMENTS

    def write() -> Any:
        from llvmlite import ir

        from tmodes.compile.dormand_prince_loop import write_dormand_prince_loop
        from tmodes.compile.lower import lower
        from tmodes.compile.program import straight_line
        from tmodes.compile.rk4_loop import write_rk4_loop

        module = ir.Module(name)
        lowered = lower(module, straight_line(make(), invariant=3))
        write_rk4_loop(module, "rk4", lowered, guarded)
        write_dormand_prince_loop(module, "dormand_prince", lowered, guarded)
        return module

    return _library(name, key, write, {method: len(ARGUMENTS) for method in ("rk4", "dormand_prince")}, level=3)


def _kernels_of(schedule: Any, arithmetic: str) -> dict[str, Library]:
    """The libraries of all kernels that a schedule calls, by symbol; each is made once, whatever schedule needs it."""
    from tmodes.compile.block import kernel_symbol

    kernels = {kernel_symbol(kernel, arithmetic): kernel for kernel, _, _ in schedule.calls}
    return {symbol: _kernel(symbol, kernel, arithmetic) for symbol, kernel in kernels.items()}


def _kernel(symbol: str, kernel: Any, arithmetic: str) -> Library:
    def write() -> Any:
        from llvmlite import ir

        from tmodes.compile.block import write_kernel

        module = ir.Module(symbol)
        write_kernel(module, kernel, _arithmetic(arithmetic)(module))
        return module

    # Differentiated code is twice as long and seldom called: quicker to compile is worth more than quicker to run.
    level = 0 if arithmetic == "derivative" else 1
    return _library(symbol, symbol, write, {symbol: len(kernel.inputs) + len(kernel.outputs)}, level)


def _arithmetic(name: str) -> Any:
    from tmodes.compile.arithmetic import Derivative, Double, Lanes

    return {kind.name: kind for kind in (Double, Lanes, Derivative)}[name]


def schedule_function(name: str, schedule: Any, arithmetic: str) -> Library:
    """The function ``run(n, each, parameters, workspace, in, out)`` of a schedule of kernels over many samples.

    ``arithmetic``: ``double``, ``lanes`` (four samples at once) or ``derivative`` (each with a direction).
    """

    def write() -> Any:
        from llvmlite import ir

        from tmodes.compile.block import write_samples

        module = ir.Module(name)
        write_samples(module, schedule, _arithmetic(arithmetic)(module), "run")
        return module

    return _library(
        f"{name}.{arithmetic}", schedule.key, write, {"run": 6}, 1, lambda: _kernels_of(schedule, arithmetic)
    )


def schedule_loops(name: str, schedule: Any, guarded: int, pairs: int) -> Library:
    """The native time loops around a schedule whose inputs are time, state, row and step, its output the state's rate.

    The state begins with ``pairs`` coordinates and as many rates. Loops: rk4, dormand_prince, extrapolation.
    """
    from tmodes.compile.time_loop import ARGUMENTS

    def write() -> Any:
        from llvmlite import ir

        from tmodes.compile.block import write_rate
        from tmodes.compile.dormand_prince_loop import write_dormand_prince_loop
        from tmodes.compile.extrapolation_loop import write_extrapolation_loop
        from tmodes.compile.rk4_loop import write_rk4_loop

        module = ir.Module(name)
        rate = write_rate(module, schedule, _arithmetic("double")(module), "rate")
        write_rk4_loop(module, "rk4", rate, guarded)
        write_dormand_prince_loop(module, "dormand_prince", rate, guarded)
        write_extrapolation_loop(module, "extrapolation", rate, guarded, pairs=pairs)
        return module

    functions: dict[str, int] = dict.fromkeys(("rk4", "dormand_prince", "extrapolation"), len(ARGUMENTS))
    return _library(name, schedule.key, write, functions, 1, partial(_kernels_of, schedule, "double"))


def native_functions(name: str, write: Callable[[], Any], functions: dict[str, int]) -> Library:
    """Functions, with their numbers of arguments, of the module that ``write`` gives; ``name`` says all of it."""
    return _library(name, name, write, functions, 2)


def row_function(symbol: str, write: Callable[[], tuple[Any, int]]) -> Library:
    """One function ``symbol(values, slopes, row)``; ``write`` gives its module and the level, ``symbol`` tells all."""
    return _library(symbol, symbol, write, {symbol: 3})
