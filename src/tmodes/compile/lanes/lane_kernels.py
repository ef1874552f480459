"""Native time loops over runs side by side, made at their first use and kept like all others."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Any

from tmodes.compile.ir.kernels import called, library
from tmodes.compile.native import Library
from tmodes.integrate.registry import integrators

__all__ = ["goes_side_by_side", "schedule_lane_loops", "time_lane_loops"]


def goes_side_by_side(method: str) -> bool:
    """Whether a method has a loop over runs side by side: those with a tableau have."""
    one = integrators().get(method)
    return one is not None and one.tableau is not None


@dataclass(frozen=True)
class _LaneLoops:
    """The loops by the name of their method; ``NAME.work`` gives how many numbers the loop ``NAME`` works on."""

    library: Callable[[str], Library]

    def __getitem__(self, name: str) -> Any:
        """The function of a method; KeyError for one that has none."""
        method = name.removesuffix(".work")
        if not goes_side_by_side(method):
            raise KeyError(name)
        return self.library(method)[name]


def time_lane_loops(name: str, key: str, make: Callable[[], Any], guarded: int) -> _LaneLoops:
    """The explicit loops of :func:`tmodes.compile.loops.loops.time_loops` over runs side by side."""

    def write(method: str) -> Any:
        from llvmlite import ir

        from tmodes.compile.ir.arithmetic import Wide
        from tmodes.compile.ir.lower import lower
        from tmodes.compile.ir.program import straight_line

        module = ir.Module(name)
        return _lane_loop(module, lower(module, straight_line(make(), invariant=3), Wide(module)), guarded, method)

    return _LaneLoops(
        lambda method: library(_named(name, method), key, partial(write, method), _functions(method), level=3)
    )


def schedule_lane_loops(name: str, schedule: Any, guarded: int) -> _LaneLoops:
    """As :func:`time_lane_loops`, of a schedule of kernels (:func:`tmodes.compile.loops.loops.schedule_loops`)."""
    from tmodes.compile.ir.arithmetic import Wide

    def write(method: str) -> Any:
        from llvmlite import ir

        from tmodes.compile.lanes.lanes_rate import write_lanes_rate

        module = ir.Module(name)
        return _lane_loop(module, write_lanes_rate(module, schedule, "rate"), guarded, method)

    def made(method: str) -> Library:
        kernels = partial(called, schedule, Wide.name)
        return library(_named(name, method), schedule.key, partial(write, method), _functions(method), 3, kernels)

    return _LaneLoops(made)


def _named(name: str, method: str) -> str:
    return f"{name} {integrators()[method].key}"


def _lane_loop(module: Any, rate: Any, guarded: int, method: str) -> Any:
    from tmodes.compile.lanes.lanes_explicit import write_lanes_loop

    tableau = integrators()[method].tableau
    assert tableau is not None  # noqa: S101
    write_lanes_loop(module, method, rate, guarded, tableau)
    return module


def _functions(method: str) -> dict[str, int]:
    from tmodes.compile.lanes.lanes_loop import LANE_ARGUMENTS

    return {method: len(LANE_ARGUMENTS), f"{method}.work": 1}
