"""Friction of a normal force that has the point's acceleration in it: both are found together, exactly.

Accelerations are affine in the forces at a state. So they are solved for twice, without friction and with that of a
trial force; what is asked of both, a weighted mean, is exact, for joints and links of every kind. Inertias and rates
are shared: calls with the same blocks are made once.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

from tmodes.equations.loop.serving import Serving
from tmodes.equations.mechanics import Dynamics
from tmodes.equations.recursion.parts import AxisPart
from tmodes.kinds.kernel.schedule import Kernel, Slot

__all__ = ["Solution", "contact_fold", "solved"]


@dataclass(eq=False)
class Solution:
    """What one solution for the accelerations is, or the mean of two that differ by a force alone.

    ``accelerations`` are blocks in the order of the coordinates, the mean by the ``weight`` of the second. ``fold``:
    see :meth:`Touch.share`; ``free``: the accelerations without the friction.
    """

    instant: Serving
    first: Dynamics
    accelerations: list[Slot]
    second: Dynamics | None = None
    weight: Slot | None = None
    fold: Slot | None = None
    free: list[Slot] = field(default_factory=list)
    _means: dict[tuple[Slot, Slot], Slot] = field(default_factory=dict)

    def mean(self, one: Slot, other: Slot) -> Slot:
        """One block from those of both runs."""
        if self.weight is None or one == other:
            return one
        if (one, other) not in self._means:
            kernel = _mean_kernel(one.size)
            self._means[one, other] = self.instant.call(kernel, self.weight, one, other)[0]
        return self._means[one, other]

    def force_along(self, axis: AxisPart) -> Slot:
        """Force that the bodies ask of a prescribed coordinate of a joint."""
        one = self.first.force_along(axis)
        return self.mean(one, self.second.force_along(axis)) if self.second else one

    def at_base(self) -> tuple[Slot, Slot]:
        """Inertia and bias force of all that hangs on the base."""
        inertia, bias = self.first.at_base()
        return inertia, self.mean(bias, self.second.at_base()[1]) if self.second else bias

    def point(self, k: int) -> tuple[Slot, ...]:
        """Pose, rate and acceleration (less gravity) of a point in the world."""
        pose, rate, motion = self.first.point(k)
        return pose, rate, self.mean(motion, self.second.point(k)[2]) if self.second else motion


def _mean_kernel(size: int) -> Kernel:
    """(weight, a, b) -> a + weight (b - a)."""

    def build(weight: Any, a: Any, b: Any) -> list[list[Any]]:
        return [[a[i] + weight[0] * (b[i] - a[i]) for i in range(size)]]

    return Kernel(f"mean {size}", (1, size, size), (size,), build)


def solved(instant: Serving, start: Callable[[], Dynamics]) -> Solution:
    """Solve the dynamics that ``start`` gives; twice where friction depends on the accelerations."""
    run = start()
    free = Solution(instant, run, run.run())
    plan, numbers = instant.plan.touch, instant.loop.touch
    if run.contact is not None:
        free.fold = run.contact.part(1, 1)
        return free
    if plan is None or numbers is None or not plan.touch.rubs_with_mass:
        return free
    touch, call = plan.touch, instant.call
    pose, _, before = free.point(plan.point)
    wrench, step = instant.way.wrenches[plan.point], instant.mass_step
    trial, rubbed = call(touch.trial(), pose, before, numbers, step, wrench)
    other = _with_wrench(instant, start, rubbed)
    weight, fold = call(touch.share(), pose, before, other.point(plan.point)[2], numbers, step, trial)
    both = Solution(instant, run, [], other.first, weight, fold, free.accelerations)
    pairs = zip(free.accelerations, other.accelerations, strict=True)
    both.accelerations = [both.mean(one, two) for one, two in pairs]
    return both


def contact_fold(solution: Solution, start: Callable[[], Dynamics]) -> Slot:
    """1 plus the surface's mass times the mobility along the push, 1 without such friction; for observers only."""
    instant, plan = solution.instant, solution.instant.plan.touch
    if solution.fold is None or plan is None or instant.loop.touch is None:
        return instant.loop.always.part(0, 1)
    if solution.first.contact is not None:
        return solution.fold
    free = Solution(instant, solution.first, solution.free)
    pose, _, before = free.point(plan.point)
    (pushed,) = instant.call(plan.touch.unit_push(), pose, instant.loop.touch, instant.way.wrenches[plan.point])
    after = _with_wrench(instant, start, pushed).point(plan.point)[2]
    return instant.call(plan.touch.fold(), pose, before, after, instant.loop.touch, solution.fold)[0]


def _with_wrench(instant: Serving, start: Callable[[], Dynamics], wrench: Slot) -> Solution:
    """The solution with another wrench on the point that touches."""
    assert instant.plan.touch is not None  # noqa: S101
    wrenches, point = instant.way.wrenches, instant.plan.touch.point
    before, wrenches[point] = wrenches[point], wrench
    run = start()
    found = Solution(instant, run, run.run())
    wrenches[point] = before
    return found
