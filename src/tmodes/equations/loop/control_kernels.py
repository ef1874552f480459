"""Kernels of what moves a joint: controller, motor winding, and the effort that a given motion needs.

DC motor, Eq. (39) of Filipovic & Djuric 2010: u = R i + CE th', torque CM i; control law (41): u = Kp (wanted - th)
+ Kv (wanted' - th'). With an inductance L the current is a state: L i' = u - R i - CE th'.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum
from typing import Any

from tmodes.equations.loop.signals_kernels import SIGNAL
from tmodes.kinds.kernel.kernel import Kernel

__all__ = ["SERVO_NUMBERS", "TOLD", "Servo", "Winding", "needed_kernel"]

SERVO_NUMBERS = 6
"""Numbers of a servo: Kp, Kv, R, CE, CM, L (1, 0, 1, 0 without a winding)."""

TOLD = 4
"""What is told of a drive: effort [N*m], voltage [V], current [A], wanted value."""


class Winding(StrEnum):
    """The electric side of a motor."""

    NONE = "none"
    RESISTANCE = "resistance"
    INDUCTANCE = "inductance"


@dataclass(frozen=True)
class Servo:
    """Structure of a drive whose motion is not given: ``controlled`` by position and rate; ``driven`` by its voltage.

    Without a winding, or where the effort itself is commanded, the command is the effort.
    """

    controlled: bool
    driven: bool
    winding: Winding

    @property
    def has_current(self) -> bool:
        """Whether the current is a state."""
        return self.driven and self.winding is Winding.INDUCTANCE

    def kernel(self) -> Kernel:
        """(numbers, signal, th, th', current, h) -> (effort, feedback (2), rate of the current, told (4)).

        ``feedback``: fall of the effort per th and th', for implicit steps.
        """

        def build(p: Any, signal: Any, th: Any, thd: Any, current: Any, step: Any) -> list[list[Any]]:
            gain, swing, resistance, back, torque, inductance = (p[i] for i in range(SERVO_NUMBERS))
            command: Any = signal[0]
            stiff, damp = 0.0, 0.0
            if self.controlled:
                command = gain * (signal[0] - th[0]) + swing * (signal[1] - thd[0])
                stiff, damp = gain, swing
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

        key = f"servo {self.controlled} {self.driven} {self.winding}"
        return Kernel(key, (SERVO_NUMBERS, SIGNAL, 1, 1, 1, 1), (1, 2, 1, TOLD), build)


def needed_kernel(winding: Winding) -> Kernel:
    """(servo's numbers, rotor inertia, signal, load of arm, gear and friction) -> (effort, told (4)).

    Of a motor whose motion is given: what it must do. The voltage leaves out the inductance.
    """

    def build(p: Any, inertia: Any, signal: Any, load: Any) -> list[list[Any]]:
        effort = inertia[0] * signal[2] + load[0]
        amperes: Any = effort / p[4] if winding is not Winding.NONE else 0.0
        volts = p[2] * amperes + p[3] * signal[1] if winding is not Winding.NONE else 0.0
        return [[effort], [effort, volts, amperes, signal[0]]]

    return Kernel(f"needed {winding}", (SERVO_NUMBERS, 1, SIGNAL, 1), (1, TOLD), build)
