"""The native time loops around a right-hand side, each compiled when its method is first asked for."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Any

from tmodes.compile.ir.kernels import arithmetic_of, called, kernels_of, library
from tmodes.compile.native import Library

__all__ = [
    "EXPLICIT", "EXTRAPOLATION", "IMPLICIT", "ROSENBROCK", "implicit_loops", "loop_arithmetic", "program_loop_module",
    "rosenbrock_loop", "schedule_loop_module", "schedule_loops", "time_loops",
]  # fmt: skip

EXPLICIT = ("rk4", "dormand_prince", "dop853")
EXTRAPOLATION = "extrapolation"
IMPLICIT = (EXTRAPOLATION, "midpoint")
ROSENBROCK = "rosenbrock"
"""Names of the methods, as in :class:`tmodes.integrate.settings.Method`."""


@dataclass(frozen=True)
class _Loops:
    """The native time loops around one right-hand side by the name of their method, each made at its first use."""

    methods: tuple[str, ...]
    library: Callable[[str], Library]

    def __getitem__(self, method: str) -> Any:
        """The function of a method; KeyError for one that is not among them."""
        if method not in self.methods:
            raise KeyError(method)
        return self.library(method)[method]


def _writer(method: str) -> Any:
    """What writes the loop of a method."""
    from tmodes.compile.loops.dop853_loop import write_dop853_loop
    from tmodes.compile.loops.dormand_prince_loop import write_dormand_prince_loop
    from tmodes.compile.loops.extrapolation_loop import write_extrapolation_loop
    from tmodes.compile.loops.midpoint_loop import write_midpoint_loop
    from tmodes.compile.loops.rk4_loop import write_rk4_loop
    from tmodes.compile.loops.rosenbrock_loop import write_rosenbrock_loop

    return {
        "rk4": write_rk4_loop, "dormand_prince": write_dormand_prince_loop, "dop853": write_dop853_loop,
        "extrapolation": write_extrapolation_loop, "midpoint": write_midpoint_loop, "rosenbrock": write_rosenbrock_loop,
    }[method]  # fmt: skip


def time_loops(name: str, key: str, make: Callable[[], Any], guarded: int) -> Any:
    """The native time loops, by their methods, around one right-hand side of (time, state, row, parameters).

    Methods: EXPLICIT.
    """
    from tmodes.compile.loops.time_loop import ARGUMENTS

    def made(method: str) -> Library:
        write = partial(program_loop_module, make, guarded, method, method)
        return library(f"{name} {method}", key, write, {method: len(ARGUMENTS)}, level=3)

    return _Loops(EXPLICIT, made)


def program_loop_module(make: Callable[[], Any], guarded: int, method: str, symbol: str) -> Any:
    """The IR of an explicit loop, called ``symbol``, around one right-hand side."""
    from llvmlite import ir

    from tmodes.compile.ir.lower import lower
    from tmodes.compile.ir.program import straight_line

    module = ir.Module(symbol)
    _writer(method)(module, symbol, lower(module, straight_line(make(), invariant=3)), guarded)
    return module


def schedule_loops(name: str, schedule: Any, guarded: int) -> Any:
    """The explicit time loops, by their methods, around a schedule of time, state and row that gives their rate.

    Methods: EXPLICIT.
    """
    return _Loops(EXPLICIT, lambda method: _schedule_loop(name, schedule, guarded, method))


def implicit_loops(name: str, schedule: Any, guarded: int, pairs: int) -> Any:
    """The loops of implicit steps around a schedule that has the inputs ``step`` and ``start`` too.

    The state begins with ``pairs`` coordinates and as many rates. Methods: IMPLICIT.
    """
    return _Loops(IMPLICIT, lambda method: _schedule_loop(name, schedule, guarded, method, pairs=pairs))


def rosenbrock_loop(name: str, schedule: Any, guarded: int, pairs: int, columns: int) -> Any:
    """The loop of a Rosenbrock method, with the exact Jacobian by the first ``columns`` numbers of the state."""
    more = {"pairs": pairs, "columns": columns}
    return _Loops((ROSENBROCK,), lambda method: _schedule_loop(f"{name} {columns}", schedule, guarded, method, **more))


def _schedule_loop(name: str, schedule: Any, guarded: int, method: str, **more: Any) -> Library:
    from tmodes.compile.loops.time_loop import ARGUMENTS

    def imports() -> dict[str, Library]:
        slopes = kernels_of(schedule, "derivative") if method == ROSENBROCK else {}
        return called(schedule, loop_arithmetic(method)) | slopes

    write = partial(schedule_loop_module, schedule, guarded, method, method, **more)
    return library(f"{name} {method}", schedule.key, write, {method: len(ARGUMENTS)}, 1, imports)


def loop_arithmetic(method: str) -> str:
    """The numbers of a loop around a schedule: of extrapolation the rows of a tableau go side by side."""
    return "lanes" if method == EXTRAPOLATION else "double"


def schedule_loop_module(schedule: Any, guarded: int, method: str, symbol: str, **more: Any) -> Any:
    """The IR of a loop, called ``symbol``, around a schedule; ``more``: pairs and columns, as the method needs them."""
    from llvmlite import ir

    from tmodes.compile.ir.block import write_rate
    from tmodes.compile.loops.rows_rate import write_rows_rate

    module, arithmetic = ir.Module(symbol), loop_arithmetic(method)
    if arithmetic == "double":
        rate = write_rate(module, schedule, arithmetic_of(arithmetic)(module), "rate")
    else:
        rate = write_rows_rate(module, schedule, "rate")
    needed = {"schedule": schedule} if method == ROSENBROCK else {}
    _writer(method)(module, symbol, rate, guarded, **needed, **more)
    return module
