"""Friction of a normal force that has the point's acceleration in it: both are found together, exactly.

Accelerations are affine in the forces at a state. So the recursion runs twice, without friction and with that of a
trial force; what is asked of both, a weighted mean, is exact, for joints and links of every kind. Inertias and rates
are shared: calls with the same blocks are made once.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from tmodes.equations.recursion.body_kernels import point_kernel
from tmodes.equations.recursion.forward import Recursion
from tmodes.kinds.kernel.kernel import Kernel
from tmodes.kinds.kernel.schedule import Slot

if TYPE_CHECKING:
    from tmodes.equations.loop.instant import Instant

__all__ = ["Solution", "contact_fold", "solved"]


@dataclass(eq=False)
class Solution:
    """What a recursion found, or the mean of two that differ by a force alone, by the weight of the second.

    ``accelerations`` are blocks in the order of the coordinates; ``roots`` and ``tips`` those of both ends of each link
    by the number of its node; ``hung``: inertia and bias force at its root. ``fold``: see :meth:`Touch.share`;
    ``free``: the accelerations without the friction.
    """

    instant: Instant
    first: Recursion
    accelerations: list[Slot]
    second: Recursion | None = None
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

    def _both(self, of: Callable[[Recursion], Slot]) -> Slot:
        return self.mean(of(self.first), of(self.second)) if self.second else of(self.first)

    def root(self, index: int) -> Slot:
        """Acceleration of a link's root."""
        return self._both(lambda run: run.roots[index])

    def tip(self, index: int) -> Slot:
        """Acceleration of a link's tip."""
        return self._both(lambda run: run.tips[index])

    def hung(self, index: int) -> tuple[Slot, Slot]:
        """Inertia and bias force at a link's root."""
        return self.first.hung[index][0], self._both(lambda run: run.hung[index][1])

    def at_base(self) -> tuple[Slot, Slot]:
        """Inertia and bias force of all that hangs on the base."""
        inertia, bias = self.first.at_base()
        return inertia, self.mean(bias, self.second.at_base()[1]) if self.second else bias

    def point(self, k: int) -> tuple[Slot, ...]:
        """Pose, rate and acceleration (less gravity) of a point in the world."""
        instant, parts = self.instant, self.instant.parts
        point = parts.points[k]
        way, number, link = instant.way.ways[point.node], parts.station(point), parts.nodes[point.node].link
        pose, section, motion = way.tip_pose, way.tip, self.tip(point.node)
        if number is not None and link:
            pose, section = way.section_poses[number], way.sections[number]
            own = instant.pack(*self.accelerations).part(link.first, link.kernels.n)
            (motion,) = instant.call(link.kernels.motion(), self.root(point.node), section, own)
        assert pose is not None  # noqa: S101
        rate = section.part(12, 3) if section else way.tip_rate
        kernel = point_kernel(on_section=section is not None)
        return instant.call(kernel, pose, instant.way.frame(section), rate, motion, parts.offsets[k])


def _mean_kernel(size: int) -> Kernel:
    """(weight, a, b) -> a + weight (b - a)."""

    def build(weight: Any, a: Any, b: Any) -> list[list[Any]]:
        return [[a[i] + weight[0] * (b[i] - a[i]) for i in range(size)]]

    return Kernel(f"mean {size}", (1, size, size), (size,), build)


def solved(instant: Instant, start: Callable[[], Recursion]) -> Solution:
    """Run the recursion that ``start`` gives; twice where friction depends on the accelerations."""
    run = start()
    free = Solution(instant, run, run.run())
    plan, numbers = instant.plan.touch, instant.loop.touch
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


def contact_fold(solution: Solution, start: Callable[[], Recursion]) -> Slot:
    """1 plus the surface's mass times the mobility along the push, 1 without such friction; for observers only."""
    instant, plan = solution.instant, solution.instant.plan.touch
    if solution.fold is None or plan is None or instant.loop.touch is None:
        return instant.loop.always.part(0, 1)
    free = Solution(instant, solution.first, solution.free)
    pose, _, before = free.point(plan.point)
    (pushed,) = instant.call(plan.touch.unit_push(), pose, instant.loop.touch, instant.way.wrenches[plan.point])
    after = _with_wrench(instant, start, pushed).point(plan.point)[2]
    return instant.call(plan.touch.fold(), pose, before, after, instant.loop.touch, solution.fold)[0]


def _with_wrench(instant: Instant, start: Callable[[], Recursion], wrench: Slot) -> Solution:
    """The solution with another wrench on the point that touches."""
    assert instant.plan.touch is not None  # noqa: S101
    wrenches, point = instant.way.wrenches, instant.plan.touch.point
    before, wrenches[point] = wrenches[point], wrench
    run = start()
    found = Solution(instant, run, run.run())
    wrenches[point] = before
    return found
