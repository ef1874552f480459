"""The compiled code of models as parts of a WebAssembly module: time loops, functions over samples, kernels."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from functools import partial
from typing import Any

from tmodes.compile.ir.kernels import arithmetic_of, sample_module, schedule_module
from tmodes.compile.loops.loops import loop_arithmetic, program_loop_module, schedule_loop_module
from tmodes.compile.wasm.wasm import Part
from tmodes.integrate.method import JACOBIAN
from tmodes.integrate.registry import integrator

PIECE = 5000
"""Values of a kernel that make one function: shorter ones only make the code of usual beams longer."""

__all__ = ["each_once", "program_loop", "sample_part", "schedule_loop", "schedule_samples"]


def sample_part(key: str, make: Callable[[], Mapping[str, Any]], inputs: Mapping[str, int]) -> Part:
    """Functions as of :func:`tmodes.compile.ir.kernels.sample_functions`, named by the labels of ``inputs``."""
    symbols = tuple(inputs)
    return Part(f"samples {key} {dict(inputs)}", partial(sample_module, "+".join(symbols), make, inputs), symbols)


def program_loop(symbol: str, key: str, make: Callable[[], Any], guarded: int, method: str) -> Part:
    """An explicit loop around one right-hand side, as of :func:`tmodes.compile.loops.loops.time_loops`."""
    write = partial(program_loop_module, make, guarded, method, symbol)
    return Part(f"loop {method} {guarded} {key}", write, (symbol,), level=1)


def schedule_loop(symbol: str, schedule: Any, guarded: int, method: str, **more: Any) -> list[Part]:
    """A loop around a schedule with the kernels that it calls; ``more``: pairs and columns, as the method needs."""
    arithmetic = loop_arithmetic(method)
    write = partial(schedule_loop_module, schedule, guarded, method, symbol, **more)
    simd = arithmetic == "lanes"
    loop = Part(f"loop {method} {guarded} {more} {schedule.key}", write, (symbol,), simd=simd, level=1)
    slopes = _kernels(schedule, "derivative") if integrator(method).asks == JACOBIAN else []
    sampling = _called(schedule.sampled, "double") if schedule.sampled else []
    return [loop, *_called(schedule, arithmetic), *sampling, *slopes]


def schedule_samples(symbol: str, schedule: Any, arithmetic: str = "double", piece: int = PIECE) -> list[Part]:
    """A schedule over many samples with its kernels, as of :func:`tmodes.compile.ir.kernels.schedule_function`.

    ``piece``: values of a kernel that make one function.
    """
    write = partial(schedule_module, schedule, arithmetic, symbol)
    run = Part(f"schedule {arithmetic} {schedule.key}", write, (symbol,), simd=arithmetic == "lanes")
    return [run, *_called(schedule, arithmetic, piece)]


def each_once(parts: Iterable[Part]) -> list[Part]:
    """The parts without those that came before: kernels are the same wherever they are called from."""
    return list({part.symbols: part for part in parts}.values())


def _called(schedule: Any, arithmetic: str, piece: int = PIECE) -> list[Part]:
    from tmodes.compile.ir.unroll import pays

    unrolled = arithmetic_of(arithmetic).unrolls and pays(schedule)
    return [] if unrolled else _kernels(schedule, arithmetic, piece)


def _kernels(schedule: Any, arithmetic: str, piece: int = PIECE) -> list[Part]:
    from tmodes.compile.ir.block import kernel_symbol
    from tmodes.compile.wasm.wasm_pieces import kernel_in_pieces

    kernels = {kernel_symbol(kernel, arithmetic): kernel for kernel, _, _ in schedule.calls}
    return [
        Part(
            f"{symbol} {piece}", partial(kernel_in_pieces, kernel, arithmetic, piece), (symbol,),
            exported=False, simd=arithmetic == "lanes",
        )
        for symbol, kernel in kernels.items()
    ]  # fmt: skip
