"""Friction that is found together with the accelerations.

That of a normal force with the point's acceleration in it, and what keeps a point that sticks where it is.

Accelerations are affine in the forces at a state. So they are solved for without friction and with trial forces; what
is asked of all, a weighted mean, is exact, for joints and links of every kind. Inertias and rates are shared: calls
with the same blocks are made once.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

from tmodes.equations.loop.contact_modes import Holding, Rubbing
from tmodes.equations.loop.serving import Serving
from tmodes.equations.mechanics import Dynamics
from tmodes.equations.recursion.parts import AxisPart
from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.kernel.schedule import Kernel, Slot

__all__ = ["Solution", "contact_fold", "solved", "with_wrench"]


@dataclass(eq=False)
class Solution:
    """What one solution for the accelerations is, or the mean of several that differ by a force alone.

    ``accelerations`` are blocks in the order of the coordinates, the mean by the ``weight`` of each of the ``others``.
    ``fold``: see :meth:`Touch.share`; ``free``: the accelerations without the friction; ``held`` (3): the force that
    keeps a point that sticks.
    """

    instant: Serving
    first: Dynamics
    accelerations: list[Slot]
    others: tuple[Dynamics, ...] = ()
    weight: Slot | None = None
    fold: Slot | None = None
    free: list[Slot] = field(default_factory=list)
    held: Slot | None = None

    def mean(self, one: Slot, *others: Slot) -> Slot:
        """One block from those of all runs."""
        if self.weight is None or all(one == other for other in others):
            return one
        return self.instant.call(_mean_kernel(one.size, len(others)), self.weight, one, *others)[0]

    def force_along(self, axis: AxisPart) -> Slot:
        """Force that the bodies ask of a prescribed coordinate of a joint."""
        return self.mean(*(run.force_along(axis) for run in (self.first, *self.others)))

    def at_base(self) -> tuple[Slot, Slot]:
        """Inertia and bias force of all that hangs on the base."""
        found = [run.at_base() for run in (self.first, *self.others)]
        return found[0][0], self.mean(*(bias for _, bias in found))

    def point(self, k: int) -> tuple[Slot, ...]:
        """Pose, rate and acceleration (less gravity) of a point in the world."""
        pose, rate, motion = self.first.point(k)
        return pose, rate, self.mean(motion, *(run.point(k)[2] for run in self.others))


def _mean_kernel(size: int, others: int) -> Kernel:
    """(weights, a, the others) -> a + sum of weight (other - a)."""

    def build(weight: Any, a: Any, *blocks: Any) -> list[list[Any]]:
        shares = list(enumerate(blocks))
        return [[v.total([a[i], *(weight[k] * (b[i] - a[i]) for k, b in shares)]) for i in range(size)]]

    return Kernel(f"mean {size} {others}", (others, *(size,) * (others + 1)), (size,), build)


def solved(instant: Serving, start: Callable[[], Dynamics]) -> Solution:
    """Solve the dynamics that ``start`` gives; twice where friction depends on the accelerations."""
    run = start()
    free = Solution(instant, run, run.run())
    plan, numbers = instant.plan.touch, instant.loop.touch
    if run.contact is not None:
        free.fold = run.contact.part(1, 1)
        return free
    if plan and plan.touch.sheet.sticks:
        return _held(instant, start, free)
    if plan is None or numbers is None or not plan.touch.rubs_with_mass:
        return free
    touch, call = Rubbing(plan.touch), instant.call
    pose, _, before = free.point(plan.point)
    wrench, step = instant.way.wrenches[plan.point], instant.mass_step
    trial, rubbed = call(touch.trial(), pose, before, numbers, step, wrench)
    other = with_wrench(instant, start, rubbed)
    weight, fold = call(touch.share(), pose, before, other.point(plan.point)[2], numbers, step, trial)
    return _mixed(free, (other,), weight, fold=fold)


def _mixed(free: Solution, others: tuple[Solution, ...], weight: Slot, **more: Slot) -> Solution:
    """The mean of a solution and of others with further forces."""
    runs = tuple(other.first for other in others)
    mixed = Solution(free.instant, free.first, [], runs, weight, free=free.accelerations, **more)
    blocks = zip(free.accelerations, *(other.accelerations for other in others), strict=True)
    mixed.accelerations = [mixed.mean(*each) for each in blocks]
    return mixed


def _held(instant: Serving, start: Callable[[], Dynamics], free: Solution) -> Solution:
    """The solution in which a point that sticks has no acceleration along its surface."""
    plan, numbers = instant.plan.touch, instant.loop.touch
    assert plan is not None  # noqa: S101
    assert numbers is not None  # noqa: S101
    holding, call = Holding(plan.touch), instant.call
    pose, _, before = free.point(plan.point)
    trials = call(holding.trials(), pose, numbers, instant.way.wrenches[plan.point], instant.mode)
    others = tuple(with_wrench(instant, start, trial) for trial in trials)
    motions = [other.point(plan.point)[2] for other in others]
    weight, held = call(holding.share(), pose, before, *motions, numbers, instant.mode, instant.step)
    return _mixed(free, others, weight, held=held)


def contact_fold(solution: Solution, start: Callable[[], Dynamics]) -> Slot:
    """1 plus the surface's mass times the mobility along the push, 1 without such friction; for observers only."""
    instant, plan = solution.instant, solution.instant.plan.touch
    if solution.fold is None or plan is None or instant.loop.touch is None:
        return instant.loop.always.part(0, 1)
    if solution.first.contact is not None:
        return solution.fold
    free = Solution(instant, solution.first, solution.free)
    pose, _, before = free.point(plan.point)
    (pushed,) = instant.call(
        Rubbing(plan.touch).unit_push(), pose, instant.loop.touch, instant.way.wrenches[plan.point]
    )
    after = with_wrench(instant, start, pushed).point(plan.point)[2]
    return instant.call(Rubbing(plan.touch).fold(), pose, before, after, instant.loop.touch, solution.fold)[0]


def with_wrench(instant: Serving, start: Callable[[], Dynamics], wrench: Slot) -> Solution:
    """The solution with another wrench on the point that touches."""
    assert instant.plan.touch is not None  # noqa: S101
    wrenches, point = instant.way.wrenches, instant.plan.touch.point
    before, wrenches[point] = wrenches[point], wrench
    run = start()
    found = Solution(instant, run, run.run())
    wrenches[point] = before
    return found
