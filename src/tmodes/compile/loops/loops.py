"""The native time loops around a right-hand side, each compiled when its method is first asked for."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Any

from tmodes.compile.ir.kernels import arithmetic_of, called, kernels_of, library
from tmodes.compile.native import Library
from tmodes.integrate.method import EULER, EXPLICIT, IMPLICIT, JACOBIAN
from tmodes.integrate.registry import integrator, integrators

__all__ = [
    "implicit_loops", "loop_arithmetic", "loop_methods", "program_loop_module", "rosenbrock_loop",
    "schedule_loop_module", "schedule_loops", "time_loops",
]  # fmt: skip


@dataclass(frozen=True)
class _Loops:
    """The native time loops around one right-hand side by the name of their method, each made at its first use.

    ``asks``: what methods may ask of it, of :mod:`tmodes.integrate.method`.
    """

    asks: tuple[str, ...]
    library: Callable[[str], Library]

    def __getitem__(self, method: str) -> Any:
        """The function of a method; KeyError for one that is not among them."""
        if method not in loop_methods(*self.asks):
            raise KeyError(method)
        return self.library(method)[method]


def loop_methods(*asks: str) -> list[str]:
    """The methods that ask no more of the equations than this."""
    return [name for name, one in integrators().items() if one.asks in asks]


def _writer(method: str) -> Any:
    """What writes the loop of a method: its own, or that of all tableaus."""
    from tmodes.compile.loops.dop853_loop import write_dop853_loop
    from tmodes.compile.loops.explicit_loop import write_explicit_loop
    from tmodes.compile.loops.extrapolation_loop import write_extrapolation_loop
    from tmodes.compile.loops.midpoint_loop import write_midpoint_loop
    from tmodes.compile.loops.rosenbrock_loop import write_rosenbrock_loop

    tableau = integrator(method).tableau
    if tableau is not None:
        return partial(write_explicit_loop, tableau=tableau)
    return {
        "dop853": write_dop853_loop, "extrapolation": write_extrapolation_loop, "midpoint": write_midpoint_loop,
        "rosenbrock": write_rosenbrock_loop,
    }[method]  # fmt: skip


def time_loops(name: str, key: str, make: Callable[[], Any], guarded: int) -> Any:
    """The native time loops, by their methods, around one right-hand side of (time, state, row, parameters).

    Methods: the explicit ones.
    """
    from tmodes.compile.loops.time_loop import ARGUMENTS

    def made(method: str) -> Library:
        write = partial(program_loop_module, make, guarded, method, method)
        return library(f"{name} {integrator(method).key}", key, write, {method: len(ARGUMENTS)}, level=3)

    return _Loops((EXPLICIT,), made)


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

    Methods: the explicit ones.
    """
    return _Loops((EXPLICIT,), lambda method: _schedule_loop(name, schedule, guarded, method))


def implicit_loops(name: str, schedule: Any, guarded: int, pairs: int) -> Any:
    """The loops of implicit steps around a schedule that has the inputs ``step`` and ``start`` too.

    The state begins with ``pairs`` coordinates and as many rates. Methods: those of implicit steps.
    """
    return _Loops((IMPLICIT, EULER), lambda method: _schedule_loop(name, schedule, guarded, method, pairs=pairs))


def rosenbrock_loop(name: str, schedule: Any, guarded: int, pairs: int, columns: int) -> Any:
    """The loop of a Rosenbrock method, with the exact Jacobian by the first ``columns`` numbers of the state."""
    more = {"pairs": pairs, "columns": columns}
    return _Loops((JACOBIAN,), lambda method: _schedule_loop(f"{name} {columns}", schedule, guarded, method, **more))


def _schedule_loop(name: str, schedule: Any, guarded: int, method: str, **more: Any) -> Library:
    from tmodes.compile.loops.time_loop import ARGUMENTS

    def imports() -> dict[str, Library]:
        slopes = kernels_of(schedule, "derivative") if integrator(method).asks == JACOBIAN else {}
        sampling = called(schedule.sampled, "double") if schedule.sampled else {}
        return called(schedule, loop_arithmetic(method)) | slopes | sampling

    write = partial(schedule_loop_module, schedule, guarded, method, method, **more)
    return library(f"{name} {integrator(method).key}", schedule.key, write, {method: len(ARGUMENTS)}, 1, imports)


def loop_arithmetic(method: str) -> str:
    """The numbers of a loop around a schedule: of extrapolation the rows of a tableau go side by side."""
    return "lanes" if integrator(method).asks == EULER else "double"


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
    needed = {"schedule": schedule} if integrator(method).asks == JACOBIAN else {}
    _writer(method)(module, symbol, rate, guarded, **needed, **more)
    return module
