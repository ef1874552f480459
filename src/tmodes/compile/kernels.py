"""Groups of native functions, each made at its first use and kept on disk: a second start reads them in no time."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Callable, Mapping
from typing import Any

from tmodes.compile import cache
from tmodes.compile.native import Library, host, to_object

__all__ = ["sample_functions", "schedule_function", "schedule_loops", "time_loops"]


_loaded: OrderedDict[str, Library] = OrderedDict()
_KEPT = 64


def _library(name: str, key: str, write: Callable[[], Any], functions: dict[str, int], level: int) -> Library:
    """The functions of one module: as loaded before, from the cache, or written, optimised and kept."""
    key = f"{name}\n{key}\n{host()}\n{cache.source_digest()}"
    if key not in _loaded:
        _loaded[key] = Library(name, _binary(key, write, level), functions)
        while len(_loaded) > _KEPT:
            _loaded.popitem(last=False)
    _loaded.move_to_end(key)
    return _loaded[key]


def _binary(key: str, write: Callable[[], Any], level: int) -> bytes:
    binary = cache.load(key)
    if binary is None:
        binary = to_object(write(), level)
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


def schedule_function(name: str, key: str, make: Callable[[], Any], arithmetic: str, level: int = 1) -> Library:
    """The function ``run(n, each, parameters, workspace, in, out)`` of a schedule of kernels over many samples.

    ``arithmetic``: ``double``, ``lanes`` (four samples at once) or ``derivative`` (each with a direction).
    """

    def write() -> Any:
        from llvmlite import ir

        from tmodes.compile.arithmetic import Derivative, Double, Lanes
        from tmodes.compile.block import write_samples

        module = ir.Module(name)
        kind = {kind.name: kind for kind in (Double, Lanes, Derivative)}[arithmetic]
        write_samples(module, make(), kind(module), "run")
        return module

    return _library(f"{name}.{arithmetic}", key, write, {"run": 6}, level)


def schedule_loops(name: str, key: str, make: Callable[[], Any], guarded: int, pairs: int) -> Library:
    """The native time loops around a schedule whose inputs are time, state, row and step, its output the state's rate.

    The state begins with ``pairs`` coordinates and as many rates. Loops: rk4, dormand_prince, extrapolation.
    """
    from tmodes.compile.time_loop import ARGUMENTS

    def write() -> Any:
        from llvmlite import ir

        from tmodes.compile.arithmetic import Double
        from tmodes.compile.block import write_rate
        from tmodes.compile.dormand_prince_loop import write_dormand_prince_loop
        from tmodes.compile.extrapolation_loop import write_extrapolation_loop
        from tmodes.compile.rk4_loop import write_rk4_loop

        module = ir.Module(name)
        rate = write_rate(module, make(), Double(module), "rate")
        write_rk4_loop(module, "rk4", rate, guarded)
        write_dormand_prince_loop(module, "dormand_prince", rate, guarded)
        write_extrapolation_loop(module, "extrapolation", rate, guarded, pairs=pairs)
        return module

    methods = ("rk4", "dormand_prince", "extrapolation")
    return _library(name, key, write, {method: len(ARGUMENTS) for method in methods}, level=1)
