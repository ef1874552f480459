"""What every schedule of a run begins with: its inputs, the signals, and the servos between state and efforts."""

from __future__ import annotations

from tmodes.equations.loop.control_kernels import Servo, View
from tmodes.equations.loop.plan import Driver, LoopParts
from tmodes.equations.loop.signals_kernels import replacing_kernel, signal_kernel
from tmodes.equations.mechanics import Way
from tmodes.equations.recursion.driven import packing_kernel
from tmodes.kinds.kernel.schedule import Divisible, Kernel, Schedule, Slot

__all__ = ["Serving", "sampled_state"]


class Serving:
    """A schedule of (time, state, row, step), and its ``signals`` (3 each).

    ``way``: the outward pass; ``mass_step``: step of the mass of a surface that moves with a point; ``mode``: direction
    in which a point slips.
    """

    way: Way
    mass_step: Slot
    mode: Slot

    def __init__(self, loop: LoopParts, *, implicit: bool = False, given: int = 0) -> None:
        """``implicit``: the input ``step`` may be other than zero; ``given``: how many numbers are behind the state."""
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

    def _signal(self, k: int) -> Slot:
        count = self.plan.degree + 1
        block = self.row.part(1 + k * count, count)
        return self.call(signal_kernel(self.plan.degree), self.time, self.row.part(0, 1), block)[0]

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
        """The outputs of the servo's kernel at coordinates and rates; ``own``: its controller's states."""
        servo, view, blocks = self._seen(driver, q, rates, own)
        return self.call(servo.kernel(view), *blocks)

    def sampled(self, driver: Driver, q: Divisible, rates: Slot) -> Slot:
        """The states of a driver's controller, new where the row begins with a sample of it."""
        servo, view, blocks = self._seen(driver, q, rates, None)
        if not servo.is_sampled:
            return self.own_states(driver)
        return self.call(servo.sample_kernel(view), *blocks, self.signals[driver.plan.clock])[0]

    def _seen(
        self, driver: Driver, q: Divisible, rates: Slot, own: Slot | None
    ) -> tuple[Servo, View | None, list[Slot]]:
        """The servo, its view, and the inputs of its kernel."""
        place, signal, servo = driver.coordinate, self.signals[driver.plan.signal], driver.plan.servo
        assert servo is not None  # noqa: S101
        blocks = [driver.numbers, signal, q.part(place, 1), rates.part(place, 1), self._current(driver), self.step]
        if servo.noisy:
            blocks.append(self.signals[driver.plan.noise])
        if servo.states:
            blocks.append(own or self.own_states(driver))
        if not servo.sees_all:
            return servo, None, blocks
        names = tuple(other.plan.joint for other in self.loop.drivers)
        view = View(tuple(self.parts.names), names, len(self.plan.currents), place)
        setpoints = self.pack(*(self.signals[other.plan.signal] for other in self.loop.drivers))
        currents = self.state.part(self.loop.layout.currents.start, view.currents)
        size = self.parts.size
        return servo, view, [*blocks, q.part(0, size), rates.part(0, size), currents, setpoints]

    def _current(self, driver: Driver) -> Slot:
        if driver.current < 0:
            return self.none[1]
        return self.state.part(self.loop.layout.currents.start + driver.current, 1)


def sampled_state(loop: LoopParts) -> Schedule:
    """(time, state, row, step) -> the state after the samples with which the row begins."""
    serving, controls = Serving(loop), loop.layout.controls
    q, rates = serving.moved(serving.state)
    served = [driver for driver in loop.drivers if driver.plan.servo and driver.plan.servo.states]
    new = [serving.sampled(driver, q, rates) for driver in served]
    rest = serving.state.part(controls.stop, loop.layout.size - controls.stop)
    serving.schedule.output("state", serving.state.part(0, controls.start), *new, rest)
    return serving.schedule
