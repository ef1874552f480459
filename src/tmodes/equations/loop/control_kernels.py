"""Kernels of what moves a joint: servo with its limits, motor winding, and the effort that a given motion needs.

DC motor: u = R i + CE th', torque CM i. With an inductance L the current is a
state: L i' = u - R i - CE th'.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from enum import StrEnum
from typing import Any

from tmodes.equations.loop.laws import Delay, Law, View
from tmodes.equations.loop.rigid_terms import RigidModel
from tmodes.equations.loop.signals_kernels import SIGNAL
from tmodes.kinds.controllers.registry import Controller, OwnState
from tmodes.kinds.kernel import functions as f
from tmodes.kinds.kernel.schedule import Kernel, Slot

__all__ = ["LIMITS", "OUTPUTS", "WINDING", "Served", "Servo", "View", "Winding", "needed_kernel"]

WINDING = 4
"""Numbers of a winding: R, CE, CM, L (1, 0, 1, 0 without one)."""

OUTPUTS = 4
"""What is known of a drive: effort [N*m], voltage [V], current [A], wanted value."""

LIMITS = ("voltage", "current", "torque", "speed")
"""Limits that a drive may have, in the order of their numbers."""

SPEED_BAND = 0.05
"""Share of the largest speed below it over which the effort that drives on falls to nothing."""


class Winding(StrEnum):
    """The electric side of a motor."""

    NONE = "none"
    RESISTANCE = "resistance"
    INDUCTANCE = "inductance"


@dataclass(frozen=True)
class Served:
    """What a servo is called with: its ``numbers``, setpoint, position, rate, current, length of the step.

    ``noise``, ``states``: None where it has none; ``seen``: the blocks of its view, ``reads``: the signals that its law
    reads; ``command``: what another block commands; ``feed``: the signal of the effort that is added.
    """

    numbers: Slot
    signal: Slot
    position: Slot
    velocity: Slot
    current: Slot
    step: Slot
    noise: Slot | None = None
    states: Slot | None = None
    seen: tuple[Slot, ...] = ()
    reads: Slot | None = None
    command: Slot | None = None
    feed: Slot | None = None


@dataclass(frozen=True)
class Servo:
    """Structure of a drive whose motion is not given: under a ``controller``, or ``driven`` by its voltage.

    Without a winding, or where the effort itself is commanded, the command is the effort. ``noisy``, ``settles``,
    ``timed``, ``delay``, ``view``, ``model``: see :class:`tmodes.equations.loop.laws.Law`. ``limits``: which of
    :data:`LIMITS` it has; ``wired``: its command is the output of a block; ``fed``: an effort is added to it.
    """

    controller: Controller | None
    driven: bool
    winding: Winding
    noisy: bool = False
    settles: bool = False
    timed: bool = False
    delay: Delay = field(default_factory=Delay)
    limits: tuple[str, ...] = ()
    wired: bool = False
    fed: bool = False
    view: View | None = None
    model: RigidModel | None = None

    @property
    def has_current(self) -> bool:
        """Whether the current is a state."""
        return self.driven and self.winding is Winding.INDUCTANCE

    @property
    def limit(self) -> str:
        """The limit of its command itself; empty for none."""
        name = "voltage" if self.driven else "torque"
        return name if name in self.limits else ""

    @property
    def limit_places(self) -> list[int]:
        """Where limits of a command that moves between samples stand in its numbers."""
        if self.is_sampled and not self.driven:
            return []
        own = WINDING + len(self.limits)
        return [*range(WINDING, own), *(own + k for k in (self.controller.limits_at if self.controller else ()))]

    @property
    def law(self) -> Law | None:
        """The compiled form of its controller."""
        if self.controller is None:
            return None
        how = {"noisy": self.noisy, "settles": self.settles, "timed": self.timed, "delay": self.delay,
               "fed": self.fed}  # fmt: skip
        return Law(self.controller, view=self.view, limited=bool(self.limit), model=self.model, **how)  # pyright: ignore[reportArgumentType]

    @property
    def is_controlled(self) -> bool:
        """Whether a block commands it, its own or another."""
        return self.controller is not None or self.wired

    @property
    def is_sampled(self) -> bool:
        """Whether the controller holds its command between samples."""
        return self.law is not None and self.law.is_sampled

    @property
    def start(self) -> tuple[float, ...]:
        """The controller's states at time 0; those of its held commands, which the first sample sets, come first."""
        return self.law.start if self.law else ()

    @property
    def states(self) -> int:
        """Number of the controller's states, the held command among them."""
        return len(self.start)

    @property
    def held(self) -> int:
        """How many of the states are commands."""
        return self.law.held if self.law else 0

    @property
    def named_states(self) -> tuple[OwnState, ...]:
        """Names and units of the states."""
        return self.law.named_states(("V" if self.driven else "N*m|N",)) if self.law else ()

    @property
    def sees_all(self) -> bool:
        """Whether the controller sees the whole measured state."""
        return self.controller is not None and self.controller.sees_all

    def seeing(self, view: View) -> Servo:
        """The same with what its controller sees, where it sees all."""
        return replace(self, view=view) if self.sees_all else self

    def numbers(self, winding: tuple[float, ...], limits: tuple[float, ...] = (), period: float = 0.0) -> Any:
        """Its numbers: those of the winding, its limits, then those of the controller, and its period."""
        return (*winding, *limits, *(self.law.numbers(period) if self.law else ()))

    def serve(self, call: Callable[..., tuple[Slot, ...]], given: Served) -> tuple[Slot, ...]:
        """Call its kernels: (effort, feedback (2), rate of the current, info (4), rates of own states if any).

        ``feedback``: fall of the effort per th and th', for implicit steps.
        """
        electric = given.numbers.part(0, WINDING + len(self.limits))
        motion = given.signal, given.velocity, given.current, given.step, *([given.feed] if given.feed else [])
        if self.law is None:
            command = given.command or given.signal.part(0, 1)
            return call(self.actuator(sloped=False), electric, command, *motion)
        command, slopes, *rates = call(self.law.kernel(), *self._law_inputs(given))
        return (*call(self.actuator(sloped=True), electric, command, *motion, slopes), *rates)

    def sample(self, call: Callable[..., tuple[Slot, ...]], given: Served, *clocks: Slot) -> Slot:
        """The states of the controller, new where a clock is 0."""
        assert self.law is not None  # noqa: S101
        return call(self.law.sample_kernel(), *self._law_inputs(given), *clocks)[0]

    def _law_inputs(self, given: Served) -> list[Slot]:
        law, first = self.law, WINDING + len(self.limits)
        assert law is not None  # noqa: S101
        limit = given.numbers.part(WINDING + self.limits.index(self.limit), 1) if self.limit else None
        more = [slot for slot in (given.noise, limit, given.states) if slot is not None]
        read = [given.reads] if given.reads else []
        own = given.signal, given.position, given.velocity, given.current
        return [given.numbers.part(first, law.count), *own, *more, *given.seen, *read]

    def actuator(self, *, sloped: bool) -> Kernel:
        """(winding and limits, command, signal, th', current, h, slopes) -> (effort, feedback, current's rate, info).

        Eq. (39) [stated]: u = R i + CE theta', so i = (u - CE theta')/R. {test_motor_row_is_in_newton_metres}
        """

        def build(p: Any, command: Any, signal: Any, thd: Any, current: Any, step: Any, *more: Any) -> list[list[Any]]:
            stiff, damp = (more[-1][0], more[-1][1]) if sloped else (0.0, 0.0)
            limits = {name: p[WINDING + k] for k, name in enumerate(self.limits)}
            added: Any = self._added(p, signal, more[0]) if self.fed else 0.0
            cut = _Cut(command[0] + added, (stiff, damp))
            return self._driven(p, cut, limits, (signal[0], thd[0], current[0], step[0]))

        more = (*((SIGNAL,) if self.fed else ()), *((2,) if sloped else ()))
        inputs = (WINDING + len(self.limits), 1, SIGNAL, 1, 1, 1, *more)
        key = f"servo {self.driven} {self.winding} {' '.join(self.limits)}{' sloped' * sloped}{' fed' * self.fed}"
        return Kernel(key, inputs, (1, 2, 1, OUTPUTS), build)

    def _added(self, p: Any, signal: Any, feed: Any) -> Any:
        """What is added to the command for an effort: itself, or the voltage that gives it at the setpoint's rate."""
        if not self.driven:
            return feed[0]
        resistance, back, torque, inductance = (p[i] for i in range(WINDING))
        return (resistance * feed[0] + inductance * feed[1]) / torque + back * signal[1]

    def _driven(self, p: Any, cut: _Cut, limits: dict[str, Any], at: tuple[Any, Any, Any, Any]) -> list[list[Any]]:
        """From the command and its slopes to the effort and what is known of the drive."""
        wanted, thd, current, step = at
        resistance, back, torque, inductance = (p[i] for i in range(WINDING))
        most = limits.get("current")
        if "torque" in limits and self.driven:  # a motor's torque is its current
            amperes = limits["torque"] / f.fabs(torque)
            most = amperes if most is None else f.fmin(most, amperes)
        if not self.driven:
            winds, over = self.winding is not Winding.NONE, limits.get("voltage")
            if winds and over is not None:
                cut = cut.within(f.fabs(torque) * over / resistance, -torque * back * thd / resistance)
            cut = cut.within(limits.get("torque")).within(most * f.fabs(torque) if most is not None and winds else None)
            cut = cut.slowed(limits.get("speed"), thd, 0.0)
            amperes = cut.value / torque if winds else 0.0
            volts = resistance * amperes + back * thd if winds else 0.0
            return [[cut.value], [*cut.slopes], [0.0], [cut.value, volts, amperes, wanted]]
        cut = cut.within(limits.get("voltage"))
        cut = cut.within(None if most is None else resistance * most, back * thd)
        cut = cut.slowed(limits.get("speed"), thd, back * thd)
        command, (stiff, damp) = cut.value, cut.slopes
        if self.has_current:
            change = (command - resistance * current - back * thd) / (inductance + step * resistance)
            effort = torque * current
            return [[effort], [0.0, 0.0], [change], [effort, command, current, wanted]]
        amperes = (command - back * thd) / resistance
        share, effort = torque / resistance, torque * amperes
        return [[effort], [share * stiff, share * (damp + back)], [0.0], [effort, command, amperes, wanted]]


@dataclass(frozen=True)
class _Cut:
    """A command with its fall per own position and rate, cut at limits."""

    value: Any
    slopes: tuple[Any, Any]

    def within(self, most: Any, middle: Any = 0.0) -> _Cut:
        """Not farther than ``most`` from ``middle``; None: without a limit."""
        if most is None:
            return self
        inside = f.fabs(self.value - middle) < most
        value = f.fmax(f.fmin(self.value, middle + most), middle - most)
        stiff, damp = (f.if_else(inside, slope, 0.0) for slope in self.slopes)
        return _Cut(value, (stiff, damp))

    def slowed(self, most: Any, rate: Any, idle: Any) -> _Cut:
        """What drives on beyond the command ``idle`` falls to nothing just below the speed ``most``."""
        if most is None:
            return self
        left = f.fmax(f.fmin((most - f.fabs(rate)) / (SPEED_BAND * most), 1.0), 0.0)
        over = self.value - idle
        share = f.if_else(over * rate > 0, left, 1.0)
        return _Cut(idle + share * over, (share * self.slopes[0], share * self.slopes[1]))


def needed_kernel(winding: Winding) -> Kernel:
    """(winding, rotor inertia, signal, load of robot, gear and friction) -> (effort, info (4)).

    Of a motor whose motion is given: what it must do. The voltage leaves out the inductance.
    """

    def build(p: Any, inertia: Any, signal: Any, load: Any) -> list[list[Any]]:
        effort = inertia[0] * signal[2] + load[0]
        amperes: Any = effort / p[2] if winding is not Winding.NONE else 0.0
        volts = p[0] * amperes + p[1] * signal[1] if winding is not Winding.NONE else 0.0
        return [[effort], [effort, volts, amperes, signal[0]]]

    return Kernel(f"needed {winding}", (WINDING, 1, SIGNAL, 1), (1, OUTPUTS), build)
