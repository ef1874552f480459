"""A whole robot in a run as schedules: signals, controllers, motors, chain, loads, contact, works.

Inputs ``time`` (1), ``state``, ``row``, and ``step`` h (1). The output ``rate`` is the derivative of the state; with
h > 0 its accelerations are those of a linearly implicit Euler step of h.
"""

from __future__ import annotations

from functools import cached_property
from typing import Any

from tmodes.equations.loop.contact_kernels import CONTACT_OUTPUTS
from tmodes.equations.loop.contact_modes import against_kernel, narrow_rates
from tmodes.equations.loop.control_kernels import WINDING, needed_kernel
from tmodes.equations.loop.friction import contact_fold
from tmodes.equations.loop.instant import Instant
from tmodes.equations.loop.layout import WORKS, StateLayout
from tmodes.equations.loop.plan import Driver, LoopParts, Placed
from tmodes.equations.loop.serving import Serving
from tmodes.equations.loop.signals_kernels import base_motion, power_kernel
from tmodes.equations.loop.switching import switched_state
from tmodes.equations.recursion.hinge import POSE
from tmodes.equations.recursion.link_kernels import times_kernel
from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.kernel.schedule import Kernel, Schedule, Slot, kernel
from tmodes.kinds.kernel.spatial import FORCE

__all__ = ["ClosedLoop", "Driver", "LeanLoop", "Powers", "gear_torque"]


class Powers:
    """What the forces of an instant do: ``works`` by kind, and what is reported of drives, gears and the contact."""

    def __init__(self, instant: Instant) -> None:
        self.instant, self.loop, self.plan, self.parts = instant, instant.loop, instant.plan, instant.parts
        self.way, self.recursion, self.none = instant.way, instant.recursion, instant.none
        self.solution = instant.solution
        self.powers: dict[str, list[Slot]] = {name: [] for name in WORKS}
        self.info = dict(instant.info)
        self.gear: dict[int, Slot] = {}
        for k, effort in instant.efforts.items():
            speed = self.way.v.part(self.loop.drivers[k].coordinate, 1)
            self.powers["motor"].append(self._product(effort, speed))
        self._need()
        self._lose()
        self.contact = self._power_of_loads()
        self._power_of_base()

    @property
    def works(self) -> list[Slot]:
        """Powers [W] by kind, in the order of the works."""
        return [self.added(*blocks) if blocks else self.none[1] for blocks in self.powers.values()]

    def _call(self, kernel: Kernel, *blocks: Slot) -> tuple[Slot, ...]:
        return self.instant.call(kernel, *blocks)

    def _product(self, a: Slot, b: Slot) -> Slot:
        return self._call(Kernel("product", (1, 1), (1,), lambda x, y: [[x[0] * y[0]]]), a, b)[0]

    def added(self, *blocks: Slot) -> Slot:
        """Sum of single numbers."""
        if len(blocks) == 1:
            return blocks[0]

        def build(*values: Any) -> list[list[Any]]:
            return [[v.total([value[0] for value in values])]]

        return self._call(Kernel(f"added {len(blocks)}", (1,) * len(blocks), (1,), build), *blocks)[0]

    def _need(self) -> None:
        """What the motors that follow their signals exactly must do."""
        inputs, loads = self.recursion.coupled, self.recursion.coupled_loads
        for k, driver in enumerate(self.loop.drivers):
            load, gear = self._losses_of(driver, inputs)
            self.gear[k] = gear or self.none[1]
            if driver.plan.servo is None and driver.part.motor not in inputs:
                self._needed(k, driver, load)
        for k, driver in enumerate(self.loop.drivers):
            if driver.plan.servo is None and driver.part.motor in loads:
                speed, motor = self.way.motor(driver.part)[1], driver.part.motor
                sides = self.way.sides(driver.part)
                blocks = (driver.kind_numbers, speed, self.none[1], loads[motor], sides)
                held = self._call(driver.kind.coupled_motor(), *blocks)
                self._needed(k, driver, held[1])

    def _losses_of(self, driver: Driver, inputs: dict[int, tuple[Slot, Slot]]) -> tuple[Slot, Slot | None]:
        """Load on the motor but for its inertia, and the gear's torque; the losses go to the powers."""
        part, none = driver.part, self.none[1]
        numbers = self.way.braked.get(part.angle, driver.kind_numbers)
        if part.motor in inputs:
            blocks = (numbers, *inputs[part.motor], *self.way.angle(part))
            lost = self._call(driver.kind.coupled_elastic(), *blocks)[2]
            moving = (self.way.motor(part)[1], none, none, self.way.sides(part))
            own = self._call(driver.kind.coupled_motor(), numbers, *moving)[2]
            self.powers["friction"] += [lost.part(1, 1), own]
            self.powers["gear_damping"].append(lost.part(0, 1))
            return none, self.recursion.torques[part.motor]
        blocks = (numbers, *self.way.motor(part), *self.way.angle(part))
        forces, _, lost = self._call(driver.kind.elastic(), *blocks)
        self.powers["friction"].append(lost.part(1, 1))
        if part.motor >= 0 or driver.kind.spring:
            self.powers["gear_damping"].append(lost.part(0, 1))
        if part.motor >= 0:
            return forces.part(1, 1), gear_torque(self.instant, driver)
        if part.given < 0:
            return forces.part(0, 1), None
        return self.added(forces.part(0, 1), self.solution.force_along(part)), None

    def _needed(self, k: int, driver: Driver, load: Slot) -> None:
        signal, inertia = self.instant.signals[driver.plan.signal], driver.kind_numbers.part(0, 1)
        found = self._call(needed_kernel(driver.plan.winding), driver.numbers.part(0, WINDING), inertia, signal, load)
        self.info[k] = found[1]
        self.powers["motor"].append(self._product(found[0], signal.part(1, 1)))

    def _lose(self) -> None:
        """Losses of what no drive of the plan moves: locked springs, and the links."""
        driven = {driver.part.angle for driver in self.loop.drivers}
        for axis in self.parts.axes:
            if axis.drive and axis.drive_numbers and axis.angle not in driven:
                blocks = (axis.drive_numbers, *self.way.motor(axis), *self.way.angle(axis))
                lost = self._call(axis.drive.elastic(), *blocks)[2]
                self.powers["gear_damping"].append(lost.part(0, 1))
                self.powers["friction"].append(lost.part(1, 1))
        self.powers["link_damping"] += self.way.link_losses()

    def _power_of_loads(self) -> Slot:
        """Powers of loads and contact; what is reported of the contact."""
        for k, wrench in self.instant.dead.items():
            pose, rate, _ = self.solution.point(k)
            self.powers["loads"] += self._call(power_kernel(), wrench, pose, rate)
        touch = self.plan.touch
        if not (touch and self.loop.touch):
            return self.instant.pack(*(self.none[1],) * CONTACT_OUTPUTS)
        pose, _, motion = self.solution.point(touch.point)
        held = self.solution.held or self.none[3]
        info, power = self._call(touch.touch.info(), pose, motion, self.loop.touch, self.instant.mode, held)
        solved = self.solution.first.contact
        self.powers["contact"].append(power if solved is None else solved.part(2, 1))
        switching = self.instant.switching
        return self._call(against_kernel(), info, switching.mode, switching.own)[0] if switching.landing else info

    def _power_of_base(self) -> None:
        """Power of what moves the base."""
        if not self.plan.base:
            return
        inertia, bias = self.solution.at_base()
        (force,) = self._call(times_kernel(), inertia, self.way.base.part(0, FORCE), bias)
        moved = self.way.base.part(FORCE, 3), self.way.base.part(FORCE + 3, POSE)
        self.powers["base"] += self._call(_power_of_base(), force, *moved)


def gear_torque(at: Instant, driver: Driver) -> Slot:
    """The torque in an elastic gear that is coupled with no other: force on the motor less the motor's friction."""
    way, none, part = at.way, at.none[1], driver.part
    numbers = way.braked.get(part.angle, driver.kind_numbers)
    forces = at.call(driver.kind.elastic(), numbers, *way.motor(part), *way.angle(part))[0]
    motor = at.call(driver.kind.coupled_motor(), numbers, way.motor(part)[1], none, none, way.sides(part))[1]
    return at.call(_difference(), forces.part(1, 1), motor)[0]


@kernel("difference", (1, 1), (1,))
def _difference(x: Any, y: Any) -> list[list[Any]]:
    return [[x[0] - y[0]]]


@kernel("power of base", (FORCE, 3, POSE), (1,))
def _power_of_base(push: Any, rate: Any, pose: Any) -> list[list[Any]]:
    """(force on the base in its axes, its rate, its pose) -> power [W]."""
    motion = base_motion(rate, pose)
    return [[v.dot(v.vec(push), v.vec(motion)) + v.dot(v.vec(push, 3), v.vec(motion, 3))]]


class ClosedLoop(LoopParts):
    """The schedules of a plan; every schedule reads the same parameters."""

    keeps_works = True

    def __post_init__(self) -> None:
        super().__post_init__()
        along = [name for name, one in self.plan.sources.items() if getattr(one, "along", False)]
        at = Instant(self) if along else None
        for name in along:  # whose numbers stand among those of every schedule
            assert at is not None  # noqa: S101
            at.wire(name)

    @cached_property
    def rate(self) -> Schedule:
        """(time, state, row, step) -> derivative of the state."""
        return self._rate(Instant(self))

    @cached_property
    def implicit_rate(self) -> Schedule:
        """(time, state, row, step, start) -> derivative of the state, for the steps of implicit methods.

        Springs, dampers and servos start from ``start`` (2 nq), and h D + h^2 K are added to the masses; all else is
        taken where ``state`` is, at ``time``.
        """
        return self._rate(Instant(self, apart=True))

    @cached_property
    def euler_rate(self) -> Schedule:
        """The same for implicit Euler steps, whose ``state`` is h of its rates ahead of ``start``.

        A surface in contact with a tip is taken at the end of the step as well.
        """
        return self._rate(Instant(self, apart=True, euler=True))

    def _rate(self, instant: Instant) -> Schedule:
        currents = [instant.change[k] for k in sorted(instant.change)]
        controls = [instant.controls[k] for k in sorted(instant.controls)]
        for block in self.blocks:
            controls += self._block_rates(instant, block)
        surface = instant.switching.surface_rate
        works = Powers(instant).works if self.keeps_works else []
        still = [self.parts.none[1]] * self.modes
        instant.schedule.often, instant.schedule.jolts = True, bool(self.plan.jolts)
        instant.schedule.sampled, instant.schedule.switched = self.sampled, self.switched
        instant.schedule.switches, instant.schedule.narrow = instant.switching.functions, narrow_rates(instant)
        further = (*currents, *controls, *surface, *works, *still)
        instant.schedule.output("rate", instant.way.v, *instant.accelerations, *further)
        if not self.plan.is_sampled:
            return instant.schedule
        return instant.schedule.only(("rate",), watched=True)  # what sensors and noises say is needed at samples alone

    def _block_rates(self, instant: Instant, block: Placed) -> list[Slot]:
        """Rates of the own states of a block, zero of what is sampled."""
        found = instant.block(block)
        return [found[2]] if len(found) > 2 else [self.parts.none[1]] * block.plan.law.states

    @cached_property
    def sampled(self) -> Schedule | None:
        """(time, state, row, step) -> the state after the samples at the row's start; None without a sampled one."""
        if not self.plan.is_sampled:
            return None
        at = Instant(self, after=True) if self.blocks else Serving(self)
        q, rates = at.moved(at.state)
        new = [
            at.sampled(driver, q, rates) for driver in self.drivers if driver.plan.servo and driver.plan.servo.states
        ]
        new += [at.block(one)[1] for one in self.blocks if isinstance(at, Instant) and one.plan.law.states]
        controls = self.layout.controls
        rest = at.state.part(controls.stop, self.layout.size - controls.stop)
        at.schedule.output("state", at.state.part(0, controls.start), *new, rest)
        return at.schedule.only(("state",)) if self.blocks else at.schedule

    @cached_property
    def switched(self) -> Schedule | None:
        """(time, state, row, step) -> the state after a switch of what sticks and slips; None where nothing does."""
        return switched_state(Instant(self, jolted=True)) if self.modes else None

    @cached_property
    def event_data(self) -> Schedule:
        """(time, state, row, step) -> what distinguishes events.

        gate: pairs of numbers; contact (6); sliding speed of its point; rates of the deflections of gears with play.
        """
        instant = Instant(self)
        touch, none = self.plan.touch, instant.none[1]
        coupled, rates = instant.way.coupled_inputs(), []
        for axis in self.parts.axes:
            if axis.drive and axis.drive.dead_zone:
                given = coupled.get(axis.motor) or instant.way.motor(axis)
                rates += instant.call(_difference(), given[1], instant.way.angle(axis)[1])
        sliding = [none]
        if touch and self.touch:
            sliding = [*instant.call(touch.touch.sliding(), instant.solution.point(touch.point)[0], self.touch)]
        gate = [instant.schedule.gate] if instant.schedule.gate else []
        shown = {"gate": gate, "contact": [Powers(instant).contact], "sliding": sliding, "gear_rates": rates}
        for name, blocks in shown.items():
            instant.schedule.output(name, *blocks)
        return instant.schedule.only(tuple(shown))

    @cached_property
    def observe(self) -> Schedule:
        """(time, state, row, step) -> what is shown.

        q, v, a, drives (4 each), own states of controllers, gear, contact (6), fold, the base's row, powers.
        """
        instant = Instant(self, after=self.plan.is_sampled)
        powers, drives = Powers(instant), range(len(self.drivers))
        shown = {
            "q": [instant.way.q],
            "v": [instant.way.v],
            "a": instant.accelerations,
            "drives": [powers.info[k] for k in drives],
            "controls": [
                *(instant.own[k] for k in sorted(instant.own) if instant.own[k].size),
                *(instant.block(block)[1] for block in self.blocks if block.plan.law.states),
            ],
            "gear": [powers.gear[k] for k in drives],
            "contact": [powers.contact],
            "contact_fold": [contact_fold(instant.solution, instant.begin)],
            "base": [instant.way.base],
            "powers": powers.works,
        }
        for name, blocks in shown.items():
            instant.schedule.output(name, *blocks)
        return instant.schedule


class LeanLoop(ClosedLoop):
    """The rates of a plan in which nothing sticks, without works, for runs of which only some outputs are wanted.

    The state is the first part of the whole one.
    """

    keeps_works = False

    @cached_property
    def layout(self) -> StateLayout:
        """Where the state holds what; works and modes have no room."""
        whole = super().layout
        end = slice(whole.works.start, whole.works.start)
        return whole._replace(works=end, modes=end)
