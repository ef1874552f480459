"""Kernels of what moves a joint: controller, motor winding, and the effort that a given motion needs.

DC motor: u = R i + CE th', torque CM i. With an inductance L the current is a
state: L i' = u - R i - CE th'.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum
from typing import Any

import casadi as ca

from tmodes.equations.loop.signals_kernels import SIGNAL
from tmodes.kinds.controllers.registry import Controller, Measured, OwnState
from tmodes.kinds.kernel.functions import if_else
from tmodes.kinds.kernel.schedule import Kernel

__all__ = ["OUTPUTS", "WINDING", "Servo", "View", "Winding", "needed_kernel"]

WINDING = 4
"""Numbers of a winding: R, CE, CM, L (1, 0, 1, 0 without one)."""

OUTPUTS = 4
"""What is known of a drive: effort [N*m], voltage [V], current [A], wanted value."""


class Winding(StrEnum):
    """The electric side of a motor."""

    NONE = "none"
    RESISTANCE = "resistance"
    INDUCTANCE = "inductance"


@dataclass(frozen=True)
class View:
    """What a controller that sees all sees: names of coordinates and drives, currents, and its own coordinate."""

    names: tuple[str, ...]
    drives: tuple[str, ...]
    currents: int
    own: int

    @property
    def sizes(self) -> tuple[int, ...]:
        """Sizes of the blocks q, v, currents, setpoints."""
        return len(self.names), len(self.names), self.currents, SIGNAL * len(self.drives)


@dataclass(frozen=True)
class Servo:
    """Structure of a drive whose motion is not given: under a ``controller``, or ``driven`` by its voltage.

    Without a winding, or where the effort itself is commanded, the command is the effort. ``noisy``: the controller
    sees a wanted value with an error on it. ``settles``: a sampled controller in continuous time, whose rates are the
    changes of its own states from sample to sample: zero where a constant wanted value leaves it as it is.
    """

    controller: Controller | None
    driven: bool
    winding: Winding
    noisy: bool = False
    settles: bool = False

    @property
    def has_current(self) -> bool:
        """Whether the current is a state."""
        return self.driven and self.winding is Winding.INDUCTANCE

    @property
    def is_sampled(self) -> bool:
        """Whether the controller holds its command between samples."""
        return self.controller is not None and self.controller.period is not None and not self.settles

    @property
    def start(self) -> tuple[float, ...]:
        """The controller's own states at time 0; the held command, which the first sample sets, before them."""
        own = self.controller.initial() if self.controller else ()
        return (0.0, *own) if self.is_sampled else own

    @property
    def states(self) -> int:
        """Number of the controller's own states, the held command among them."""
        return len(self.start)

    @property
    def named_states(self) -> tuple[OwnState, ...]:
        """Names and units of the states."""
        own = self.controller.states if self.controller else ()
        unit = "V" if self.driven else "N*m|N"
        return (OwnState("command", unit), *own) if self.is_sampled else own

    @property
    def sees_all(self) -> bool:
        """Whether the controller sees the whole measured state."""
        return self.controller is not None and self.controller.sees_all

    @property
    def key(self) -> str:
        """The structure in words."""
        law = self.controller.structure if self.controller else "none"
        return f"servo {law}, {self.driven} {self.winding}{' noisy' * self.noisy}{' settles' * self.settles}"

    def numbers(self, winding: tuple[float, ...]) -> tuple[float, ...]:
        """Its numbers: those of the winding, then those of the controller."""
        return (*winding, *(self.controller.numbers() if self.controller else ()))

    def kernel(self, view: View | None = None) -> Kernel:
        """(numbers, signal, th, th', current, h, ...) -> (effort, feedback (2), rate of the current, info (4), rates).

        ``feedback``: fall of the effort per th and th', for implicit steps; ``rates``: of the controller's own states.
        More inputs, where the structure has them: noise (3), own states, and the blocks of ``view``.
        """
        own = len(self.controller.numbers()) if self.controller else 0
        more = [*([SIGNAL] * self.noisy), *([self.states] * bool(self.states)), *(view.sizes if view else ())]

        def build(p: Any, signal: Any, th: Any, thd: Any, current: Any, step: Any, *rest: Any) -> list[list[Any]]:
            blocks = list(rest)
            noise = blocks.pop(0) if self.noisy else [0.0] * SIGNAL
            x = blocks.pop(0) if self.states else []
            command, stiff, damp, rates = signal[0], 0.0, 0.0, []
            if self.is_sampled:
                command, rates = x[0], [0.0] * self.states
            elif self.controller:
                wanted = [signal[k] + noise[k] for k in range(SIGNAL)] if self.noisy else signal
                numbers, x = [p[WINDING + k] for k in range(own)], [x[k] for k in range(self.states)]
                law = _Law(self.controller, numbers, x, settles=self.settles)
                command, stiff, damp, rates = law.at(wanted, th[0], thd[0], current[0], (view, blocks))
            return [*self._driven(p, (command, stiff, damp), signal, thd, (current, step)), *([rates] if rates else [])]

        inputs = (WINDING + own, SIGNAL, 1, 1, 1, 1, *more)
        seen = f", {view}" if view else ""
        return Kernel(f"{self.key}{seen}", inputs, (1, 2, 1, OUTPUTS, *([self.states] if self.states else [])), build)

    def sample_kernel(self, view: View | None = None) -> Kernel:
        """(numbers, signal, th, th', current, h, ..., clock) -> the held command and the own states.

        They are new where the clock is 0, at a sample; inputs are those of :meth:`kernel`.
        """
        law, plain = self.controller, self.kernel(view)
        assert law is not None  # noqa: S101

        def build(p: Any, signal: Any, th: Any, thd: Any, current: Any, step: Any, *rest: Any) -> list[list[Any]]:
            del step
            *blocks, clock = rest
            noise = blocks.pop(0) if self.noisy else [0.0] * SIGNAL
            x = blocks.pop(0)
            held = [x[k] for k in range(self.states)]
            wanted = [signal[k] + noise[k] for k in range(SIGNAL)] if self.noisy else signal
            numbers = [p[WINDING + k] for k in range(plain.inputs[0] - WINDING)]
            measured = _measured(wanted, (th[0], thd[0]), current[0], (view, blocks))
            new = [law.command(numbers, measured, held[1:]), *law.updates(numbers, measured, held[1:])]
            return [[if_else(clock[0] <= 0, after, before) for after, before in zip(new, held, strict=True)]]

        return Kernel(f"sampling {plain.key}", (*plain.inputs, SIGNAL), (self.states,), build)

    def _driven(
        self, p: Any, of: tuple[Any, Any, Any], signal: Any, thd: Any, electric: tuple[Any, Any]
    ) -> list[list[Any]]:
        """From the command and its slopes to the effort and what is known of the drive.

        Eq. (39) [stated]: u = R i + CE theta', so i = (u - CE theta')/R. {test_motor_row_is_in_newton_metres}
        """
        (command, stiff, damp), (current, step) = of, electric
        resistance, back, torque, inductance = (p[i] for i in range(WINDING))
        if not self.driven:
            amperes = command / torque if self.winding is not Winding.NONE else 0.0
            volts = resistance * amperes + back * thd[0] if self.winding is not Winding.NONE else 0.0
            return [[command], [stiff, damp], [0.0], [command, volts, amperes, signal[0]]]
        if self.has_current:
            change = (command - resistance * current[0] - back * thd[0]) / (inductance + step[0] * resistance)
            effort = torque * current[0]
            return [[effort], [0.0, 0.0], [change], [effort, command, current[0], signal[0]]]
        amperes = (command - back * thd[0]) / resistance
        share, effort = torque / resistance, torque * amperes
        return [[effort], [share * stiff, share * (damp + back)], [0.0], [effort, command, amperes, signal[0]]]


@dataclass(frozen=True)
class _Law:
    """A controller with the symbols of its numbers and of its own states."""

    controller: Controller
    p: list[Any]
    x: list[Any]
    settles: bool

    def at(self, wanted: Any, th: Any, thd: Any, current: Any, seen: tuple[View | None, list[Any]]) -> Any:
        """Command, its fall per th and th', and the rates of the own states."""
        own = ca.SX.sym("own", 2)
        measured = _measured(wanted, (own[0], own[1]), current, seen)
        command = ca.SX(self.controller.command(self.p, measured, self.x))
        rates = ca.SX(ca.vertcat(*self._rates(measured)))
        slopes = -ca.jacobian(command, own)
        place = ca.vertcat(th, thd)
        command, slopes, rates = ca.substitute([command, slopes, rates], [own], [place])
        return command, slopes[0], slopes[1], [rates[k] for k in range(len(self.x))]

    def _rates(self, measured: Measured) -> list[Any]:
        if not self.settles:
            return self.controller.rates(self.p, measured, self.x)
        new = self.controller.updates(self.p, measured, self.x)
        return [after - before for after, before in zip(new, self.x, strict=True)]


def _measured(wanted: Any, own: tuple[Any, Any], current: Any, seen: tuple[View | None, list[Any]]) -> Measured:
    """What a controller sees: the wanted value with two derivatives, its own position and rate, and its view."""
    view, blocks = seen
    here = {"wanted": wanted[0], "wanted_rate": wanted[1], "wanted_acceleration": wanted[2], "current": current}
    if view:
        q, v = ([block[k] for k in range(len(view.names))] for block in blocks[:2])
        q[view.own], v[view.own] = own
        setpoints = [[blocks[3][SIGNAL * k + i] for i in range(SIGNAL)] for k in range(len(view.drives))]
        setpoints[view.drives.index(view.names[view.own].removesuffix(".motor"))] = [wanted[k] for k in range(3)]
        here |= {"q": q, "v": v, "names": view.names, "setpoints": setpoints, "drives": view.drives}
        here["currents"] = [blocks[2][k] for k in range(view.currents)]
    return Measured(position=own[0], velocity=own[1], **here)


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
