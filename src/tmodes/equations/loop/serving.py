"""What every schedule of a run begins with: its inputs, the signals, and the servos between state and efforts."""

from __future__ import annotations

from tmodes.equations.loop.control_kernels import Served, View
from tmodes.equations.loop.plan import Driver, LoopParts
from tmodes.equations.loop.signals_kernels import SIGNAL, replacing_kernel, signal_kernel
from tmodes.equations.mechanics import Way
from tmodes.equations.recursion.driven import packing_kernel
from tmodes.kinds.kernel.schedule import Divisible, Kernel, Schedule, Slot

__all__ = ["Serving"]


class Serving:
    """A schedule of (time, state, row, step), and its ``signals`` (3 each).

    ``way``: the outward pass; ``mass_step``: step of the mass of a surface that moves with a point; ``mode``: direction
    in which a point slips.
    """

    way: Way
    mass_step: Slot
    mode: Slot

    def __init__(
        self, loop: LoopParts, *, implicit: bool = False, given: int = 0, within: Serving | None = None
    ) -> None:
        """``implicit``: the input ``step`` may be other than zero; ``given``: how many numbers are behind the state.

        ``within``: the same instant of another one, whose schedule this one shares.
        """
        if within is not None:
            vars(self).update(vars(within))
            return
        self.loop, self.plan, self.parts = loop, loop.plan, loop.parts
        self.none = loop.parts.none
        self.schedule = Schedule(loop.parts.numbers.size, zeros=loop.mechanics.zeros)
        self.time = self.schedule.input("time", 1)
        whole = self.schedule.input("state", loop.layout.size + given)
        self.state, self.given = whole.part(0, loop.layout.size), whole.part(loop.layout.size, given)
        self.row = self.schedule.input("row", loop.plan.row_size)
        self.step = self.schedule.input("step", 1)
        if not implicit:  # always zero then: what it multiplies folds away
            self.schedule.zeros = (*self.schedule.zeros, self.step)
        self.signals = [self._signal(k) for k in range(loop.plan.signals)]

    def call(self, kernel: Kernel, *blocks: Slot) -> tuple[Slot, ...]:
        """Call a kernel; its outputs are new blocks."""
        return self.schedule.call(kernel, *blocks)

    def pack(self, *blocks: Slot) -> Slot:
        """Blocks that must stand side by side."""
        if not blocks:
            return self.none[1].part(0, 0)
        return self.call(packing_kernel(tuple(block.size for block in blocks)), *blocks)[0]

    def _signal(self, k: int, orders: int = SIGNAL) -> Slot:
        count = self.plan.degree + 1
        block = self.row.part(1 + k * count, count)
        return self.call(signal_kernel(self.plan.degree, orders), self.time, self.row.part(0, 1), block)[0]

    def moved(self, state: Slot) -> tuple[Slot, Slot]:
        """Coordinates and rates of a state; those that follow their signals exactly are where these are."""
        n = self.parts.size
        q, rates = state.part(0, n), state.part(n, n)
        exact = [driver for driver in self.loop.drivers if driver.plan.servo is None]
        if not exact:
            return q, rates
        places = tuple(driver.coordinate for driver in exact)
        moved = [self.signals[driver.plan.signal] for driver in exact]
        q, rates = self.call(replacing_kernel(n, places), q, rates, *moved)
        return q, rates

    def own_states(self, driver: Driver) -> Slot:
        """The states of a driver's controller."""
        count = driver.plan.servo.states if driver.plan.servo else 0
        return self.state.part(self.loop.layout.controls.start + driver.controls, count)

    def serve(self, driver: Driver, q: Divisible, rates: Slot, own: Slot | None = None) -> tuple[Slot, ...]:
        """The outputs of the servo's kernels at coordinates and rates; ``own``: its controller's states."""
        assert driver.plan.servo is not None  # noqa: S101
        return driver.plan.servo.serve(self.call, self._served(driver, q, rates, own))

    def sampled(self, driver: Driver, q: Divisible, rates: Slot) -> Slot:
        """The states of a driver's controller, new where the row begins with a sample of it."""
        servo, plan = driver.plan.servo, driver.plan
        if servo is None or not servo.is_sampled:
            return self.own_states(driver)
        return servo.sample(self.call, self._served(driver, q, rates, None), *self._clocks(plan.clock, plan.late))

    def _clocks(self, *places: int) -> list[Slot]:
        return [self.signals[place] for place in places if place >= 0]

    def _served(self, driver: Driver, q: Divisible, rates: Slot, own: Slot | None) -> Served:
        """The inputs of the kernels of a servo."""
        place, plan, servo = driver.coordinate, driver.plan, driver.plan.servo
        assert servo is not None  # noqa: S101
        reads = servo.controller.reads if servo.controller else ()
        return Served(
            driver.numbers, self.signals[plan.signal], q.part(place, 1), rates.part(place, 1), self._current(driver),
            self.step, self.signals[plan.noise] if servo.noisy else None,
            (own or self.own_states(driver)) if servo.states else None,
            self._seen(servo.view, q, rates) if servo.view else (),
            self.pack(*(self.wire(name) for name in reads)) if reads else None,
            self.wire(plan.command) if plan.command else None, self.signals[plan.feed] if servo.fed else None,
        )  # fmt: skip

    def wire(self, name: str) -> Slot:
        """A signal that a block reads, by name; raises KeyError where there is none here."""
        source = self.plan.sources[name]
        return self.signals[source].part(getattr(source, "order", 0), 1)

    def _seen(self, view: View, q: Divisible, rates: Slot) -> tuple[Slot, ...]:
        """What a block that sees all sees."""
        places = [other.plan.signal for other in self.loop.drivers]
        orders = view.orders
        setpoints = self.pack(*(self.signals[k] if orders == SIGNAL else self._signal(k, orders) for k in places))
        currents = self.state.part(self.loop.layout.currents.start, view.currents)
        size = self.parts.size
        return q.part(0, size), rates.part(0, size), currents, setpoints

    def _current(self, driver: Driver) -> Slot:
        if driver.current < 0:
            return self.none[1]
        return self.state.part(self.loop.layout.currents.start + driver.current, 1)
