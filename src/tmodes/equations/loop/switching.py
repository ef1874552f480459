"""What sticks and what slips: dry friction that is a set at rest, and the instants at which it switches.

While a coordinate slips, friction has the size of its level against the slip, also a little beyond its end: so the
motion is smooth, and the end is located. While it sticks it has an inertia without bound, and that times its
acceleration is the force that friction bears. B. Armstrong-Helouvry, P. Dupont, C. Canudas de Wit, Automatica 30 (1994)
1083-1138; F. Pfeiffer, C. Glocker, Multibody Dynamics with Unilateral Contacts, 1996.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from typing import Any, NamedTuple

from tmodes.equations.loop.contact_kernels import SLIP
from tmodes.equations.loop.friction import with_wrench
from tmodes.equations.loop.holding import Holding
from tmodes.equations.loop.landing import OWN, Landing, jump_kernel
from tmodes.equations.loop.layout import WORKS
from tmodes.equations.loop.rubbing import Rubbing
from tmodes.equations.loop.serving import Serving
from tmodes.equations.recursion.drive_kernels import LOCK
from tmodes.kinds.kernel import functions as f
from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.kernel.schedule import Kernel, Schedule, Slot, kernel

__all__ = ["Switching", "switched_state"]

_STILL = 1e-18
"""A rate [rad/s, m/s] up to this is rest: what is left of the motion of a coordinate that sticks."""


class Switched(NamedTuple):
    """After a switch: rates of all coordinates, own states of a surface, work [J] of an impulse, and all modes."""

    rates: Slot
    surface: list[Slot]
    work: Slot | None
    modes: list[Slot]


class Switching:
    """Modes of an instant's coordinates with dry friction; ``sides`` of each: direction of slip, inertia that holds.

    ``mode``: of the point that touches, zeros where it has none of its own.
    """

    def __init__(self, serving: Serving) -> None:
        self.serving, self.places = serving, tuple(serving.loop.slipping)
        first = serving.loop.layout.modes.start
        self.modes = [serving.state.part(first + k, 1) for k in range(len(self.places))]
        pairs = zip(self.places, self.modes, strict=True)
        self.sides = {place: serving.call(_side(), mode)[0] for place, mode in pairs}
        touch = serving.plan.touch
        self.holding = Holding(touch.touch) if touch and touch.touch.sheet.sticks else None
        self.landing = Landing(touch.touch) if touch and touch.touch.lands else None
        last = serving.loop.layout.modes.stop - 1
        slip = serving.state.part(first + len(self.places), SLIP) if self.holding else serving.none[SLIP]
        touches = serving.state.part(last, 1) if self.landing else serving.loop.always.part(0, 1)
        self.mode = serving.pack(slip, touches) if touch else slip
        self.own = serving.state.part(serving.loop.layout.surface.start, OWN)

    @cached_property
    def _known(self) -> list[Slot]:
        """Modes, rates, accelerations and limits, each in one block."""
        serving: Any = self.serving
        limits = []
        for axis, side in serving.loop.slipping.values():
            limits.append(serving.call(axis.drive.limits(), axis.drive_numbers)[0].part(side, 1))
        rates = [serving.way.v.part(place, 1) for place in self.places]
        accelerations = [serving.accelerations[place] for place in self.places]
        return [serving.pack(*blocks) for blocks in (self.modes, rates, accelerations, limits)]

    @property
    def functions(self) -> Slot | None:
        """Of each that has a mode a number that is positive while it lasts; None where there is none."""
        serving: Any = self.serving
        found: list[Slot] = []
        if self.places:
            found += serving.call(_functions(len(self.places)), *self._known)
        if self.holding:
            pose, _, *more = self._touched
            found += serving.call(self.holding.function(), pose, *more, serving.solution.held)
        if self.landing:
            found += serving.call(self.landing.function(), *self._touched, self.own)
        return serving.pack(*found) if found else None

    @property
    def _touched(self) -> list[Slot]:
        """Of the point: pose, acceleration less gravity, numbers of the contact, mode."""
        serving: Any = self.serving
        pose, _, motion = serving.solution.point(serving.plan.touch.point)
        return [pose, motion, serving.loop.touch, self.mode]

    @property
    def surface_rate(self) -> list[Slot]:
        """Rates of the own states of a surface with mass that only pushes, where there is one."""
        return list(self.serving.call(self.landing.own(), *self._touched, self.own)) if self.landing else []

    def switched(self) -> Switched:
        """What the switch changes."""
        serving: Any = self.serving
        size, found = serving.parts.size, []
        rates = serving.state.part(size, size)
        if self.places:
            some, modes = serving.call(_switched(len(self.places)), *self._known)
            found.append(modes)
            (rates,) = serving.call(_placed(size, self.places), rates, some)
        if self.holding:
            found += serving.call(self.holding.switched(), *self._touched, serving.solution.held)
        if not self.landing:
            return Switched(rates, [], None, found)
        point, numbers, wrenches = serving.plan.touch.point, serving.loop.touch, serving.way.wrenches
        pose, before, *more = self._touched
        (push,) = serving.call(Rubbing(self.landing.touch).unit_push(), pose, numbers, wrenches[point])
        pushed = with_wrench(serving, serving.begin, push)
        impulse, touches, own, work = serving.call(
            self.landing.switched(), pose, before, pushed.point(point)[2], *more, self.own
        )
        blocks = (serving.pack(*each.accelerations) for each in (serving.solution, pushed))
        (rates,) = serving.call(jump_kernel(size), rates, *blocks, impulse)
        return Switched(rates, [own], work, [*found, touches])


def switched_state(instant: Any) -> Schedule:
    """(time, state, row, step) -> the state after one switch; called until nothing changes any more."""
    layout, state = instant.loop.layout, instant.state
    rates, surface, work, modes = instant.switching.switched()
    rest = state.part(layout.v.stop, layout.surface.start - layout.v.stop)
    works = [state.part(layout.works.start + k, 1) for k in range(len(WORKS))]
    if work is not None:
        contact = WORKS.index("contact")
        (works[contact],) = instant.call(_sum(), works[contact], work)
    instant.schedule.output("state", state.part(0, layout.q.stop), rates, rest, *surface, *works, *modes)
    return instant.schedule


@kernel("sum of two", (1, 1), (1,))
def _sum(a: Any, b: Any) -> list[list[Any]]:
    return [[a[0] + b[0]]]


@kernel("side of slip", (1,), (2,))
def _side(mode: Any) -> list[list[Any]]:
    """Mode -> (direction of slip, inertia that holds)."""
    return [[mode[0], LOCK * (f.fabs(mode[0]) < 0.5)]]


def _functions(count: int) -> Kernel:
    """(modes, rates, accelerations, limits) -> rate along the slip, or what is left of the static friction."""

    def build(modes: Any, rates: Any, accelerations: Any, limits: Any) -> list[list[Any]]:
        def left(k: int) -> Any:
            rest = limits[k] - LOCK * f.fabs(accelerations[k])
            return f.if_else(f.fabs(modes[k]) < 0.5, rest, modes[k] * rates[k])

        return [[left(k) for k in range(count)]]

    return Kernel(f"switches {count}", (count,) * 4, (count,), build)


def _switched(count: int) -> Kernel:
    """(modes, rates, accelerations, limits) -> (rates, modes) after the switch.

    All whose slip has ended stick. Where none has, the one that is furthest beyond its static friction begins to slip:
    one at a time, since the others may hold then. A slip that would begin against its own acceleration ends at once.
    """

    def build(modes: Any, rates: Any, accelerations: Any, limits: Any) -> list[list[Any]]:
        places = range(count)
        sticks = [f.fabs(modes[k]) < 0.5 for k in places]
        moves = [f.fabs(rates[k]) > _STILL for k in places]
        back = [modes[k] * rates[k] < 0 for k in places]
        turned = [(1 - moves[k]) * (modes[k] * accelerations[k] < 0) for k in places]
        ends = [(1 - sticks[k]) * f.fmin(back[k] + turned[k], 1) for k in places]
        none_ends = 1 - f.fmin(v.total(ends), 1)
        loads = [sticks[k] * (1 - moves[k]) * LOCK * f.fabs(accelerations[k]) / limits[k] for k in places]
        largest: Any = 1.0
        for load in loads:
            largest = f.fmax(largest, load)
        new_rates, new_modes = [], []
        for k in places:
            begins = none_ends * (loads[k] > 1) * (loads[k] >= largest)
            runs = sticks[k] * moves[k]
            push = accelerations[k] * begins + rates[k] * runs
            side = (push > 0) - (push < 0) * 1.0
            held = f.fmin(ends[k] + sticks[k] * (1 - moves[k]), 1)
            new_rates.append(f.if_else(held > 0.5, 0.0, rates[k]))
            new_modes.append(f.if_else(sticks[k] > 0.5, side, (1 - ends[k]) * modes[k]))
        return [new_rates, new_modes]

    return Kernel(f"switched {count}", (count,) * 4, (count, count), build)


def _placed(size: int, places: Sequence[int]) -> Kernel:
    """(rates of all coordinates, of some) -> rates of all."""

    def build(rates: Any, some: Any) -> list[list[Any]]:
        return [[some[places.index(k)] if k in places else rates[k] for k in range(size)]]

    return Kernel(f"placed {size} {places}", (size, len(places)), (size,), build)
