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
from tmodes.equations.loop.contact_modes import OWN, Holding, Landing, Rubbing, jump_kernel
from tmodes.equations.loop.friction import with_wrench
from tmodes.equations.loop.jolts import Jolting, given_works
from tmodes.equations.loop.layout import WORKS
from tmodes.equations.loop.serving import Serving
from tmodes.equations.recursion.drive_kernels import LOCK
from tmodes.kinds.kernel import functions as f
from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.kernel.schedule import Kernel, Schedule, Slot, kernel

__all__ = ["Switching", "switched_state"]

_STILL = 1e-18
"""A rate [rad/s, m/s] up to this is rest: what is left of the motion of a coordinate that sticks."""


class Switched(NamedTuple):
    """After a switch: rates of all coordinates, own states of a surface, works [J] of an impulse, and all modes."""

    rates: Slot
    surface: list[Slot]
    works: dict[str, Slot]
    modes: list[Slot]


class Switching:
    """Modes of an instant's coordinates with dry friction; ``sides`` of each: direction of slip, inertia that holds.

    ``mode``: of the point that touches, zeros where it has none of its own. ``jolts``: jumps of given rates, where they
    are asked for; nothing sticks then, and a surface with mass that only pushes is apart.
    """

    def __init__(self, serving: Serving, *, jolted: bool = False) -> None:
        self.serving, self.places = serving, tuple(serving.loop.slipping)
        first = serving.loop.layout.modes.start
        self.modes = [serving.state.part(first + k, 1) for k in range(len(self.places))]
        last = serving.loop.layout.modes.stop - 1
        self.memory = [serving.state.part(last, 1)] if serving.plan.jolts else []
        self.jolts = Jolting(serving, *self.memory) if jolted and self.memory else None
        pairs = zip(self.places, self.modes, strict=True)
        self.sides = {place: self._held(serving.call(_side(), mode)[0]) for place, mode in pairs}
        touch = serving.plan.touch
        self.holding = Holding(touch.touch) if touch and touch.touch.sheet.sticks else None
        self.landing = Landing(touch.touch) if touch and touch.touch.lands else None
        last -= len(self.memory)
        slip = serving.state.part(first + len(self.places), SLIP) if self.holding else serving.none[SLIP]
        self.touched = serving.state.part(last, 1) if self.landing else serving.loop.always.part(0, 1)
        touches = self._held(self.touched) if self.landing else self.touched
        self._of_touch = [*[slip] * bool(self.holding), *[touches] * bool(self.landing)]
        self.mode = serving.pack(slip, touches) if touch else slip
        self.own = serving.state.part(serving.loop.layout.surface.start, OWN)

    def _held(self, block: Slot) -> Slot:
        """What holds, but where a rate jumps."""
        return self.jolts.loosened(block) if self.jolts else block

    @cached_property
    def _known(self) -> list[Slot]:
        """Modes, rates, accelerations and limits, each in one block."""
        serving: Any = self.serving
        limits = []
        for axis, side in serving.loop.slipping.values():
            numbers = serving.way.drive_numbers(axis)
            limits.append(serving.call(axis.drive.limits(), numbers)[0].part(side, 1))
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
    def _kept(self) -> list[Slot]:
        """The own states of a surface, where there is one, when it is left at once by a jump."""
        serving: Any = self.serving
        if not self.landing:
            return []
        pose, _, numbers, _ = self._touched
        return list(serving.call(self.landing.kept(), pose, numbers, self.own, self.touched))

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
            return Switched(rates, [], {}, [*found, *self.memory])
        point, numbers, wrenches = serving.plan.touch.point, serving.loop.touch, serving.way.wrenches
        pose, before, *more = self._touched
        (push,) = serving.call(Rubbing(self.landing.touch).unit_push(), pose, numbers, wrenches[point])
        pushed = with_wrench(serving, serving.begin, push)
        impulse, touches, own, work = serving.call(
            self.landing.switched(), pose, before, pushed.point(point)[2], *more, self.own
        )
        blocks = (serving.pack(*each.accelerations) for each in (serving.solution, pushed))
        (rates,) = serving.call(jump_kernel(size), rates, *blocks, impulse)
        if self.places:
            found[0] = self._sides_of(rates, found[0], impulse)
        works = given_works(serving, (serving.solution.first, pushed.first), impulse) | {"contact": work}
        return Switched(rates, [own], works, [*found, touches, *self.memory])

    def jolted(self) -> Switched | None:
        """What jumps of given rates change; None where there are none."""
        if self.jolts is None:
            return None
        rates, works = self.jolts.jolted()
        modes = [self._sides_of(rates, self.serving.pack(*self.modes), self.jolts.acts)] if self.places else []
        return Switched(rates, self._kept, works, [*modes, *self._of_touch, self.jolts.remembered])

    def _sides_of(self, rates: Slot, modes: Slot, impulse: Slot) -> Slot:
        """Modes of coordinates after an impulse, which may have turned their slips; the same where there is none."""
        moved = self.serving.pack(*(rates.part(place, 1) for place in self.places))
        return self.serving.call(_turned(len(self.places)), moved, modes, impulse)[0]


def switched_state(instant: Any) -> Schedule:
    """(time, state, row, step) -> the state after one switch; called until nothing changes any more.

    Where the rate of a given motion jumps, that comes first.
    """
    blocks, jolted = _blocks(instant, instant.switching.switched()), instant.switching.jolted()
    if jolted is not None:
        both = instant.pack(*blocks), instant.pack(*_blocks(instant, jolted))
        blocks = list(instant.call(_chosen(both[0].size), *both, instant.switching.jolts.acts))
    instant.schedule.output("state", *blocks)
    return instant.schedule


def _blocks(instant: Any, after: Switched) -> list[Slot]:
    """The state after a switch, in blocks."""
    layout, state = instant.loop.layout, instant.state
    rest = state.part(layout.v.stop, layout.surface.start - layout.v.stop)
    works = [state.part(layout.works.start + k, 1) for k in range(len(WORKS))]
    for name, work in after.works.items():
        (works[WORKS.index(name)],) = instant.call(_sum(), works[WORKS.index(name)], work)
    return [state.part(0, layout.q.stop), after.rates, rest, *after.surface, *works, *after.modes]


def _chosen(size: int) -> Kernel:
    """(block, another, which) -> the first where ``which`` is 0, else the other."""

    def build(one: Any, other: Any, which: Any) -> list[list[Any]]:
        return [[f.if_else(which[0] > 0.5, other[k], one[k]) for k in range(size)]]

    return Kernel(f"chosen {size}", (size, size, 1), (size,), build)


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


def _turned(count: int) -> Kernel:
    """(rates, modes, impulse) -> the modes of these rates, where there is an impulse."""

    def build(rates: Any, modes: Any, impulse: Any) -> list[list[Any]]:
        sides = [(rate > _STILL) - (rate < -_STILL) * 1.0 for rate in (rates[k] for k in range(count))]
        return [[f.if_else(f.fabs(impulse[0]) > 0, side, modes[k]) for k, side in enumerate(sides)]]

    return Kernel(f"turned {count}", (count, count, 1), (count,), build)


def _placed(size: int, places: Sequence[int]) -> Kernel:
    """(rates of all coordinates, of some) -> rates of all."""

    def build(rates: Any, some: Any) -> list[list[Any]]:
        return [[some[places.index(k)] if k in places else rates[k] for k in range(size)]]

    return Kernel(f"placed {size} {places}", (size, len(places)), (size,), build)
