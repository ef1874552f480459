"""Native time loops over runs side by side, made at their first use and kept like all others."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

from tmodes.compile.ir.kernels import called, library
from tmodes.compile.native import Library

__all__ = ["schedule_lane_loops", "time_lane_loops"]


def time_lane_loops(name: str, key: str, make: Callable[[], Any], guarded: int) -> Library:
    """The explicit loops of :func:`tmodes.compile.loops.loops.time_loops` over runs side by side.

    ``NAME.work`` says how many numbers the loop ``NAME`` works on.
    """

    def write() -> Any:
        from llvmlite import ir

        from tmodes.compile.ir.lower import lower
        from tmodes.compile.ir.program import straight_line
        from tmodes.compile.lanes.wide import Wide

        module = ir.Module(name)
        return _lane_loops(module, lower(module, straight_line(make(), invariant=3), Wide(module)), guarded)

    return library(name, key, write, _lane_functions(), level=3)


def schedule_lane_loops(name: str, schedule: Any, guarded: int) -> Library:
    """As :func:`time_lane_loops`, of a schedule of kernels (:func:`tmodes.compile.loops.loops.schedule_loops`)."""
    from tmodes.compile.lanes.wide import Wide

    def write() -> Any:
        from llvmlite import ir

        from tmodes.compile.lanes.lanes_rate import write_lanes_rate

        module = ir.Module(name)
        return _lane_loops(module, write_lanes_rate(module, schedule, "rate"), guarded)

    return library(name, schedule.key, write, _lane_functions(), 3, partial(called, schedule, Wide.name))


def _lane_loops(module: Any, rate: Any, guarded: int) -> Any:
    from tmodes.compile.lanes.lanes_dormand_prince import write_lanes_dormand_prince
    from tmodes.compile.lanes.lanes_rk4 import write_lanes_rk4

    write_lanes_rk4(module, "rk4", rate, guarded)
    write_lanes_dormand_prince(module, "dormand_prince", rate, guarded)
    return module


def _lane_functions() -> dict[str, int]:
    from tmodes.compile.lanes.lanes_loop import LANE_ARGUMENTS, LANE_METHODS

    loops = dict.fromkeys(LANE_METHODS, len(LANE_ARGUMENTS))
    return loops | {f"{method}.work": 1 for method in LANE_METHODS}
