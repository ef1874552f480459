"""One instant of a robot in a run: signals, controllers, loads and contact, and the recursion that they drive.

The calls of a schedule, in the order in which one thing follows from another.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from tmodes.equations.loop.control_kernels import WINDING
from tmodes.equations.loop.friction import solved
from tmodes.equations.loop.plan import LoopParts, Placed
from tmodes.equations.loop.serving import Serving
from tmodes.equations.loop.signals_kernels import base_kernel, load_kernel
from tmodes.equations.loop.switching import Switching
from tmodes.equations.mechanics import Dynamics, Way
from tmodes.equations.recursion.drive_kernels import braked_kernel
from tmodes.equations.recursion.driven import Drives
from tmodes.equations.recursion.passes import Blocks
from tmodes.errors import InputError
from tmodes.kinds.kernel.schedule import Divisible, Slot
from tmodes.kinds.kernel.spatial import FORCE

__all__ = ["Instant"]


class Instant(Serving):
    """Blocks of one schedule by what they mean.

    ``way`` and ``solution`` have what the passes found; ``accelerations`` are blocks in the order of the coordinates.
    By the number of a drive: ``efforts`` of servos, ``info`` (4), and rates of the controller's own states
    (``controls``), the states themselves (``own``); by the number of a current: its ``change``.
    ``dead``: wrenches on points but for the contact's. ``switching``: what sticks, and what slips.
    """

    def __init__(
        self,
        loop: LoopParts,
        *,
        apart: bool = False,
        euler: bool = False,
        after: bool = False,
        posed: bool = False,
        given: int = 0,
        jolted: bool = False,
        within: Serving | None = None,
    ) -> None:
        """``apart``: springs, dampers and servos start from an input of their own, ``start`` (coordinates, rates).

        ``euler``: the state has the rates of the start, so that a surface can be taken at the end of the step too.
        ``after``: controllers are shown as they are after the samples with which the row begins. ``posed``: poses are
        asked for; ``given``: numbers behind the state that are compared with. ``jolted``: rates may jump here.
        ``within``: another one of the same instant, whose schedule this one shares.
        """
        super().__init__(loop, implicit=apart, given=given, within=within)
        samples_late = after and any(getattr(one, "late", False) for one in loop.plan.sources.values())
        self.before = Instant(loop, posed=posed, within=self) if samples_late else None
        reads = any(not isinstance(source, int) for source in self.plan.sources.values())
        self.posed = posed or reads or bool(self.plan.loads or self.plan.touch)
        self.after = after
        self.way = self.outwards()
        self.apart, self.euler, self.start = apart, euler, self._start(apart=apart)
        self.efforts: dict[int, Slot] = {}
        self.info: dict[int, Slot] = {}
        self.change: dict[int, Slot] = {}
        self.controls: dict[int, Slot] = {}
        self.own: dict[int, Slot] = {}
        self.wires: dict[str, Slot] = {}
        self.blocks: dict[str, tuple[Slot, ...]] = {}
        self.accelerations: list[Slot] = [
            self.none[1]
        ] * self.parts.size  # what is read before they are known is at rest
        self.dead: dict[int, Slot] = {}
        self.mass_step = self.none[1]
        self.switching = Switching(self, jolted=jolted)
        self.mode = self.switching.mode
        self._push()
        self._mesh()
        self.begin = self._drive()
        self.solution = solved(self, self.begin)
        self.recursion, self.accelerations = self.solution.first, self.solution.accelerations

    def wire(self, name: str) -> Slot:
        """A signal that a block reads, by name.

        Of an output that follows from the commands of its instant a sample reads what was before it.
        """
        if name in self.wires:
            return self.wires[name]
        block = next((one for one in self.loop.blocks if name in one.plan.signals), None)
        if block is not None:
            found = self.block(block)[0]
            self.wires |= {key: found.part(k, 1) for k, key in enumerate(block.plan.signals)}
            return self.wires[name]
        source = self.plan.sources[name]
        if isinstance(source, int):
            self.wires[name] = super().wire(name)
        elif source.late and self.plan.at_rest:
            self.wires[name] = self._at_rest(source)
        else:
            self.wires[name] = source.slot(self.before if source.late and self.before else self)
        return self.wires[name]

    def _at_rest(self, source: Any) -> Slot:
        """An output that follows from accelerations and efforts, where nothing moves."""
        found = source.resting(self)
        if found is None:
            got, hint = f"`{source.name}`", "let the run begin with `initial: {state: zero}` and its coordinates"
            expected = "accelerations, forces of the contact, of gears and along links, or what follows from q and v"
            raise InputError("sensors", f"{got} in a control loop that starts at rest", expected, hint)
        return found

    def block(self, placed: Placed) -> tuple[Slot, ...]:
        """Outputs of a block, its own states, and their rates where there are any."""
        plan, law = placed.plan, placed.plan.law
        if plan.name in self.blocks:
            return self.blocks[plan.name]
        own = self.state.part(self.loop.layout.controls.start + placed.controls, law.states)
        if law.is_sampled:
            if self.after:
                clocks = self._clocks(plan.clock, plan.late)
                own = self.call(law.sample_kernel(), *self._block_inputs(placed, own), *clocks)[0]
            found: tuple[Slot, ...] = (own.part(0, law.outputs), own)
        else:
            outputs, _, *rates = self.call(law.kernel(), *self._block_inputs(placed, own))
            found = (outputs, own, *rates)
        self.blocks[plan.name] = found
        return found

    def _block_inputs(self, placed: Placed, own: Slot) -> list[Slot]:
        """The inputs of the kernels of a block."""
        law, driver, q, rates = placed.plan.law, placed.driver, self.way.q, self.way.v
        blocks = [placed.numbers]
        if driver:
            k = driver.coordinate
            blocks += [self.signals[driver.plan.signal], q.part(k, 1), rates.part(k, 1), self._current(driver)]
            if law.limited and driver.plan.servo:
                limits = driver.plan.servo.limits
                blocks.append(driver.numbers.part(WINDING + limits.index(driver.plan.servo.limit), 1))
        blocks += [own] if law.states else []
        blocks += self._seen(law.view, q, rates) if law.view else ()
        return [*blocks, *([self.pack(*map(self.wire, law.block.reads))] if law.block.reads else [])]

    def outwards(self) -> Way:
        """Where all is, and how fast, by the state and the signals."""
        q, rates = self.moved(self.state)
        base = self.loop.base
        if self.plan.base:
            base = self.call(base_kernel(), base, *(self.signals[k] for k in self.plan.base))[0]
        way = self.loop.mechanics.way(Blocks(self.schedule, q, rates, base), posed=self.posed)
        for driver in self.loop.drivers:
            if driver.plan.brake >= 0:
                numbers, on_motor = driver.kind_numbers, driver.part.node.joint.motor is not None
                blocks = (numbers, self.signals[driver.plan.brake])
                (way.braked[driver.part.angle],) = self.call(braked_kernel(numbers.size, on_motor=on_motor), *blocks)
        return way

    def _start(self, *, apart: bool) -> tuple[Divisible, Slot]:
        """Coordinates and rates that springs start from: an input of implicit steps, else those of the state."""
        if apart:
            return self.moved(self.schedule.input("start", 2 * self.parts.size))
        return self.way.q, self.way.v

    def _push(self) -> None:
        """Loads and contact, as wrenches on points, and the contact's mass."""
        wrenches = self.way.wrenches
        for load, numbers in zip(self.plan.loads, self.loop.loads, strict=True):
            signal = self.signals[load.signal] if load.signal >= 0 else self.loop.always
            pose, before = self.way.frame_of(load.point)[0], wrenches.get(load.point, self.none[FORCE])
            blocks = (pose, self.way.offset(load.point), numbers, signal, before)
            (wrenches[load.point],) = self.call(load_kernel(follower=load.follower), *blocks)
        self.dead |= wrenches
        touch = self.plan.touch
        if touch and self.loop.touch:
            blocks = (*self.way.frame_of(touch.point), self.way.offset(touch.point), self.loop.touch)
            before = wrenches.get(touch.point, self.none[FORCE])
            wrench, gate = self.call(touch.touch.wrench(), *blocks, before, self.mode)
            self.schedule.gate = gate if touch.touch.sheet.unilateral and not touch.touch.lands else None
            moves = touch.touch.has_mass or (self.euler and self.way.takes_mass(touch.point))
            self.mass_step = self.step if self.euler and moves else self.none[1]
            step = self.mass_step if moves else None
            self.way.touched(touch.point, touch.touch, self.loop.touch, wrench, step, self.mode)

    def _mesh(self) -> None:
        """Gates of gears with play."""
        coupled = self.way.coupled_inputs()
        blocks = [self.schedule.gate] if self.schedule.gate else []
        for axis in self.parts.axes:
            if axis.drive and axis.drive_numbers and axis.drive.dead_zone:
                at_input = coupled.get(axis.motor) or self.way.motor(axis)
                blocks += self.call(axis.drive.teeth(), axis.drive_numbers, *at_input, *self.way.angle(axis))
        self.schedule.gate = self.pack(*blocks) if len(blocks) > 1 else next(iter(blocks), None)

    def _drive(self) -> Callable[..., Dynamics]:
        """Efforts of the servos, and the motions that are given: the start of the dynamics, as often as asked.

        Of other accelerations of the joints whose motions are given, where it is called with these.
        """
        efforts: dict[str, Slot] = {}
        feedback: dict[str, Slot] = {}
        given: dict[str, Slot] = {}
        followed: dict[int, Slot] = {}
        for k, driver in enumerate(self.loop.drivers):
            plan, signal = driver.plan, self.signals[driver.plan.signal]
            if plan.servo is None:
                if driver.part.motor >= 0:
                    followed[driver.part.motor] = signal.part(2, 1)
                else:
                    given[plan.joint] = signal.part(2, 1)
                continue
            own = self.sampled(driver, *self.start) if self.after else self.own_states(driver)
            self.own[k] = own
            efforts[plan.joint], feedback[plan.joint], change, *found = self.serve(driver, *self.start, own)
            self.efforts[k] = efforts[plan.joint]
            if self.apart:  # what is shown, what works and own states are of the effort where the state is
                self.efforts[k], _, _, *found = self.serve(driver, self.way.q, self.way.v)
            self.info[k] = found[0]
            if len(found) > 1:
                self.controls[k] = found[1]
            if driver.current >= 0:
                self.change[driver.current] = change
        parts, none = self.parts, self.none
        effort = self.pack(*(efforts.get(name, none[1]) for name in parts.efforts))
        swing = self.pack(*(feedback.get(name, none[2]) for name in parts.efforts))
        moved = self.pack(*(given[name] for name in parts.given))

        sides = self.switching.sides

        def start(pushed: Slot = moved) -> Dynamics:
            begun = self.loop.mechanics.dynamics(self.way, Drives(effort, pushed, self.step, self.start, swing, sides))
            begun.followed = followed
            return begun

        return start
