"""The native time loops around a schedule of rates, each compiled when its method is first asked for."""

from __future__ import annotations

from functools import partial
from typing import Any

from tmodes.compile.ir.kernels import arithmetic_of, called, kernels_of, library
from tmodes.compile.native import Library
from tmodes.integrate.method import EULER, JACOBIAN
from tmodes.integrate.registry import integrator, integrators

__all__ = ["goes_side_by_side", "lane_loop", "loop_arithmetic", "schedule_loop", "schedule_loop_module"]


def schedule_loop(schedule: Any, guarded: int, method: str, **more: Any) -> Library:
    """The loop of a method around a schedule of time, state and row that gives their rate, by the method's name.

    ``guarded``: how many of the first components of the state are watched for divergence. Implicit steps take a
    schedule that has the inputs ``step`` and ``start`` too, and ``pairs``: the state begins with so many coordinates
    and as many rates. A Rosenbrock method takes ``columns`` as well: the first numbers of the state, by which its
    Jacobian is.
    """
    from tmodes.compile.loops.time_loop import ARGUMENTS

    def imports() -> dict[str, Library]:
        jumps = called(schedule.sampled, "double") | called(schedule.switched, "double")
        slopes = kernels_of(schedule, "derivative") if integrator(method).asks == JACOBIAN else {}
        return called(schedule, loop_arithmetic(method)) | jumps | slopes

    write = partial(schedule_loop_module, schedule, guarded, method, method, **more)
    name = f"loop {more} {integrator(method).key}"
    return library(name, schedule.key, write, {method: len(ARGUMENTS)}, 1, imports)


def loop_arithmetic(method: str) -> str:
    """The numbers of a loop around a schedule: of extrapolation the rows of a tableau go side by side."""
    return "lanes" if integrator(method).asks == EULER else "double"


def schedule_loop_module(schedule: Any, guarded: int, method: str, symbol: str, **more: Any) -> Any:
    """The IR of a loop, called ``symbol``, around a schedule; ``more``: pairs and columns, as the method needs them."""
    from llvmlite import ir

    from tmodes.compile.ir.block import write_rate
    from tmodes.compile.loops.extrapolation_rows import write_rows_rate

    module, arithmetic = ir.Module(symbol), loop_arithmetic(method)
    if arithmetic == "double":
        rate = write_rate(module, schedule, arithmetic_of(arithmetic)(module), "rate")
    else:
        rate = write_rows_rate(module, schedule, "rate")
    needed = {"schedule": schedule} if integrator(method).asks == JACOBIAN else {}
    _writer(method)(module, symbol, rate, guarded, **needed, **more)
    return module


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


def goes_side_by_side(method: str) -> bool:
    """Whether a method has a loop over runs side by side: those with a tableau have."""
    one = integrators().get(method)
    return one is not None and one.tableau is not None


def lane_loop(
    schedule: Any, guarded: int, method: str, shown: Any = None, *, given: int = 0, folds: bool = False
) -> Library:
    """As :func:`schedule_loop`, of an explicit method over runs side by side.

    ``METHOD.work`` gives how many numbers the loop works on. ``shown``: a schedule of time, state and so many ``given``
    numbers, and row, whose outputs are wanted of each sample: they are written, or with ``folds`` reduced at once.
    """
    from tmodes.compile.ir.arithmetic import Wide
    from tmodes.compile.lanes.lanes_loop import LANE_ARGUMENTS, LaneSeries

    def write() -> Any:
        from llvmlite import ir

        from tmodes.compile.ir.block import write_rate
        from tmodes.compile.lanes.lanes_explicit import write_lanes_loop

        module, tableau, series = ir.Module(method), integrator(method).tableau, None
        assert tableau is not None  # noqa: S101
        rate = write_rate(module, schedule, Wide(module), "rate")
        if shown is not None:
            series = LaneSeries(write_rate(module, shown, Wide(module), "shown"), given, folds)
        write_lanes_loop(module, method, rate, guarded, tableau, series)
        return module

    def imports() -> dict[str, Library]:
        found = [called(each, Wide.name) for each in (schedule, schedule.sampled, shown)]
        return {symbol: kernel for each in found for symbol, kernel in each.items()}

    functions = {method: len(LANE_ARGUMENTS), f"{method}.work": 1}
    kind = f"{shown.key} {given} {folds}" if shown else ""
    return library(f"lane loop {kind} {integrator(method).key}", schedule.key, write, functions, 3, imports)
