"""Our own forward dynamics of the rigid chain: one lane, a vector of lanes, and such on every core."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from ctypes import c_void_p
from functools import cached_property
from typing import Any

import numpy as np
from benchmarks.engines.contender import CHECKED, Contender, now
from benchmarks.engines.rigid import RigidChain
from numpy.typing import NDArray

from tmodes.compile.ir import kernels
from tmodes.compile.ir.arithmetic import Wide
from tmodes.equations.recursion.forward import forward_dynamics
from tmodes.model.model import Model
from tmodes.simulation.batch.simd_batch import private

__all__ = ["LANES", "SAMPLES", "Ours", "cores"]

SAMPLES = 1024
"""States of a batch."""

LANES = Wide.stride
"""States that go at once, as in batches of runs."""

_ROUND = 2e-2
"""Least time of a round [s]: the batch is repeated that often."""

_LONG_ROUND = 0.1
"""The same on several cores: a system takes some hundredths of a second until each thread has a core of its own."""


def cores() -> int:
    """Processor cores that this process may use."""
    import os

    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


class Ours:
    """The chain, its batch of states as the native code reads them, and the contenders."""

    def __init__(self, robot: RigidChain) -> None:
        self.robot = robot
        self.model = Model(robot.chain())
        self.schedule = forward_dynamics(self.model.parts)

    @cached_property
    def rows(self) -> NDArray[np.float64]:
        """The inputs of the batch, (SAMPLES, numbers)."""
        q, v = self.robot.states(SAMPLES)
        blocks = {"q": q, "v": v, "base": np.tile(self.model.at_rest(), (SAMPLES, 1))}
        given = [blocks.get(name, np.zeros((SAMPLES, slot.size))) for name, slot in self.schedule.inputs.items()]
        return np.ascontiguousarray(np.concatenate(given, axis=1))

    def library(self, arithmetic: str) -> Any:
        """The native code: ``double``, or lanes by their name."""
        return kernels.schedule_function("arm", self.schedule, arithmetic)

    def batch(self, arithmetic: str) -> tuple[Callable[[], None], NDArray[np.float64]]:
        """One pass over the batch, in memory of its own, and where it leaves the accelerations."""
        width = LANES if arithmetic == Wide.name else 1
        workspace, out = private(self.schedule.workspace * width), private(SAMPLES, self.robot.joints)
        arrays = self.model.parameters, workspace, self.rows, out
        run, given = self.library(arithmetic)["run"], [array.ctypes.data_as(c_void_p) for array in arrays]

        def once() -> None:
            run(SAMPLES // width, 0, *given)

        return once, out

    def contenders(self) -> Iterator[Contender]:
        """1 lane; lanes; lanes on each core."""
        for name, arithmetic in (("tmodes, 1 lane", "double"), (f"tmodes, {LANES} lanes, per lane", Wide.name)):
            once, out = self.batch(arithmetic)
            yield Contender(name, repeated(once), found_in(once, out))
        yield self._on_all_cores()

    def _on_all_cores(self) -> Contender:
        count = cores()
        pool = ThreadPoolExecutor(count)
        batches = [self.batch(Wide.name) for _ in range(count)]
        repeats = _repeats(batches[0][0], _LONG_ROUND)

        def often(once: Callable[[], None]) -> None:
            for _ in range(repeats):
                once()

        def run() -> float:
            began = time.perf_counter()
            list(pool.map(often, [once for once, _ in batches]))
            return (time.perf_counter() - began) / (SAMPLES * repeats * count)

        return Contender(
            f"tmodes, {LANES} lanes on {count} cores, per lane", run, found_in(*batches[-1]), cores=count
        )  # fmt: skip


def found_in(once: Callable[[], None], out: NDArray[np.float64]) -> Callable[[], NDArray[np.float64]]:
    """The accelerations of the states that are checked, after one pass."""

    def found() -> NDArray[np.float64]:
        out.fill(np.nan)
        once()
        return out[:CHECKED].copy()

    return found


def _repeats(once: Callable[[], None], round_time: float = _ROUND) -> int:
    once()
    began = now()
    once()
    return max(1, int(round_time / max(now() - began, 1e-9)))


def repeated(once: Callable[[], None]) -> Callable[[], float]:
    """Seconds per state of a batch, repeated until the time can be measured well."""
    repeats = _repeats(once)

    def run() -> float:
        began = now()
        for _ in range(repeats):
            once()
        return (now() - began) / (SAMPLES * repeats)

    return run
