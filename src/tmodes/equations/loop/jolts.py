"""Jumps of the rates of given motions: the impulse that they give to all that moves freely behind them.

The momenta of the free coordinates stay, M_uu dv_u + M_uf dv_f = 0: forces are bounded, dry friction and springs among
them, and give no impulse at an instant. Accelerations are affine in given ones with the same matrices, so that those
with a given acceleration larger by dv_f (1/s) are larger by dv_u. F. Pfeiffer, C. Glocker, Multibody Dynamics with
Unilateral Contacts, 1996.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property
from typing import Any, NamedTuple

from tmodes.equations.loop.serving import Serving
from tmodes.equations.loop.signals_kernels import SIGNAL, base_kernel, base_motion
from tmodes.equations.mechanics import Dynamics
from tmodes.equations.recursion.hinge import POSE
from tmodes.equations.recursion.link_kernels import times_kernel
from tmodes.kinds.kernel import functions as f
from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.kernel.schedule import Kernel, Slot, kernel
from tmodes.kinds.kernel.spatial import FORCE

__all__ = ["Jolted", "Jolting", "given_works"]


class Jolted(NamedTuple):
    """After a jump: rates of all coordinates, and the works [J] of its impulse by kind."""

    rates: Slot
    works: dict[str, Slot]


class Jolting:
    """The jumps at an instant. ``acts`` (1): 1 where any rate is still to jump; ``memory``: see the layout."""

    def __init__(self, serving: Serving, memory: Slot) -> None:
        self.serving, self.plan, self.memory = serving, serving.plan, memory
        call, time = serving.call, serving.time
        self.sizes = {moved: call(_size(), serving.signals[jumps], memory, time)[0] for moved, jumps in self.plan.jolts}
        (self.acts,) = call(_any(len(self.sizes)), *self.sizes.values())

    def loosened(self, block: Slot) -> Slot:
        """A block that is zero where a rate jumps: dry friction does not hold then."""
        return self.serving.call(_loosened(block.size), block, self.acts)[0]

    @property
    def remembered(self) -> Slot:
        """The memory after the jump."""
        return self.serving.call(_remembered(), self.serving.time)[0]

    def _pushed(self, signal: int) -> Slot:
        """A signal whose acceleration is larger by the jump of its rate."""
        given = self.serving.signals[signal]
        return self.serving.call(_pushed(), given, self.sizes[signal])[0] if signal in self.sizes else given

    @cached_property
    def _runs(self) -> tuple[Dynamics, Dynamics]:
        """The dynamics without and with the jumps as accelerations."""
        instant: Any = self.serving
        given = [driver.plan for driver in instant.loop.drivers if driver.part.given >= 0]
        pushed = {plan.joint: self._pushed(plan.signal).part(2, 1) for plan in given}
        before, way = instant.way.base, instant.way
        if self.plan.base:
            way.base = self._base
        run = instant.begin(instant.pack(*(pushed[name] for name in instant.parts.given)))
        run.run()
        way.base = before
        return instant.solution.first, run

    @cached_property
    def _base(self) -> Slot:
        instant: Any = self.serving
        return instant.call(base_kernel(), instant.loop.base, *(self._pushed(k) for k in self.plan.base))[0]

    def jolted(self) -> Jolted:
        """Rates after the impulse, and its work."""
        instant: Any = self.serving
        size, bases = instant.parts.size, (instant.way.base, self._base) if self.plan.base else None
        blocks = [instant.pack(*run.accelerations) for run in self._runs]
        (rates,) = instant.call(_jumped(size), instant.state.part(size, size), *blocks)
        works = given_works(instant, self._runs, instant.loop.always.part(0, 1), self.sizes, bases)
        return Jolted(rates, works | self._taken())

    def _taken(self) -> dict[str, Slot]:
        """What a mass that moves with a point takes."""
        instant: Any = self.serving
        plan = self.plan.touch
        if plan is None or instant.loop.touch is None or plan.touch.lands or not plan.touch.has_mass:
            return {}
        known, instant.signals = instant.signals, [self._slowed(k) for k in range(self.plan.signals)]
        pose = instant.outwards().pose(plan.point)[0]
        instant.signals = known
        motions = (run.point(plan.point)[2] for run in self._runs)
        return {"contact": instant.call(plan.touch.taken(), pose, *motions, instant.loop.touch)[0]}

    def _slowed(self, signal: int) -> Slot:
        """A signal as it is before the jump of its rate."""
        given = self.serving.signals[signal]
        return self.serving.call(_slowed(), given, self.sizes[signal])[0] if signal in self.sizes else given


def given_works(
    instant: Any,
    runs: tuple[Dynamics, Dynamics],
    impulse: Slot,
    jumps: Mapping[int, Slot] | None = None,
    bases: tuple[Slot, Slot] | None = None,
) -> dict[str, Slot]:
    """Works [J] of the drives and of the base whose motions are given, at an impulse: half the rates' sum times it.

    ``runs``: the dynamics without and with a force, or an acceleration, whose ``impulse`` (1) [s] acts. ``jumps``: by
    how much the rates of signals jump at it; ``bases``: the rows of the base in both runs.
    """
    call, none, jumps, works = instant.call, instant.none[1], jumps or {}, {}
    found = []
    for driver in instant.loop.drivers:
        rigid, jump = driver.part.given >= 0, jumps.get(driver.plan.signal)
        if driver.plan.servo is None and (rigid or jump):
            forces = [run.force_along(driver.part) if rigid else none for run in runs]
            blocks = (driver.kind_numbers.part(0, 1), instant.signals[driver.plan.signal], jump or none)
            found += call(_work(), *forces, impulse, *blocks)
    if found:
        (works["motor"],) = call(_total(len(found)), *found)
    if instant.plan.base:
        rows = bases or (instant.way.base,) * 2
        pairs = zip(rows, (run.at_base() for run in runs), strict=True)
        push = [call(times_kernel(), hung[0], row.part(0, FORCE), hung[1])[0] for row, hung in pairs]
        accelerations = [row.part(0, FORCE) for row in rows]
        moved = rows[0].part(FORCE, 3), rows[0].part(FORCE + 3, POSE)
        (works["base"],) = call(_work_on_base(), *push, *accelerations, impulse, *moved)
    return works


@kernel("jolt size", (SIGNAL, 1, 1), (1,))
def _size(jumps: Any, memory: Any, time: Any) -> list[list[Any]]:
    """(signal of jumps, memory, time) -> by how much the rate jumps here, 0 where it has already."""
    here = (f.fabs(jumps[0]) <= 0) * (f.fabs(memory[0] - (1 + time[0])) > 0)
    return [[f.if_else(here, jumps[1], 0.0)]]


@kernel("jolt memory", (1,), (1,))
def _remembered(time: Any) -> list[list[Any]]:
    return [[1 + time[0]]]


@kernel("jolt pushed", (SIGNAL, 1), (SIGNAL,))
def _pushed(signal: Any, jump: Any) -> list[list[Any]]:
    return [[signal[0], signal[1], signal[2] + jump[0]]]


@kernel("jolt slowed", (SIGNAL, 1), (SIGNAL,))
def _slowed(signal: Any, jump: Any) -> list[list[Any]]:
    return [[signal[0], signal[1] - jump[0], signal[2]]]


@kernel("jolt work", (1, 1, 1, 1, SIGNAL, 1), (1,))
def _work(before: Any, after: Any, impulse: Any, rotor: Any, signal: Any, jump: Any) -> list[list[Any]]:
    """(forces in both runs, impulse, inertia of the rotor, signal, jump) -> work [J]; the signal is after it."""
    return [[(impulse[0] * (after[0] - before[0]) + rotor[0] * jump[0]) * (signal[1] - jump[0] / 2)]]


@kernel("jolt work on base", (FORCE, FORCE, FORCE, FORCE, 1, 3, POSE), (1,))
def _work_on_base(before: Any, after: Any, slow: Any, fast: Any, impulse: Any, rate: Any, pose: Any) -> list[list[Any]]:
    """(forces on the base, its accelerations, in both runs, impulse, its rate, its pose) -> work [J]."""
    motion, push = base_motion(rate, pose), [impulse[0] * (after[k] - before[k]) for k in range(FORCE)]
    return [[v.total([push[k] * (motion[k] - (fast[k] - slow[k]) / 2) for k in range(FORCE)])]]


def _any(count: int) -> Kernel:
    """(jumps...) -> 1 where any is not zero."""
    return Kernel(f"jolt any {count}", (1,) * count, (1,), lambda *all_: [[f.fmin(_number(all_), 1.0)]])


def _number(jumps: Any) -> Any:
    return v.total([f.if_else(f.fabs(jump[0]) > 0, 1.0, 0.0) for jump in jumps])


def _loosened(size: int) -> Kernel:
    """(block, 1 where a rate jumps) -> block, or zeros there."""
    return Kernel(
        f"jolt loosened {size}",
        (size, 1),
        (size,),
        lambda block, acts: [[block[k] * (1 - acts[0]) for k in range(size)]],
    )


def _total(count: int) -> Kernel:
    return Kernel(f"jolt total {count}", (1,) * count, (1,), lambda *works: [[v.total([work[0] for work in works])]])


def _jumped(size: int) -> Kernel:
    """(rates, accelerations without and with the jump) -> rates after it."""

    def build(rates: Any, before: Any, after: Any) -> list[list[Any]]:
        return [[rates[k] + (after[k] - before[k]) for k in range(size)]]

    return Kernel(f"jolt rates {size}", (size,) * 3, (size,), build)
