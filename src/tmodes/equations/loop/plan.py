"""What happens to a chain in a run, in plain terms: which signal moves what, what loads it, what it touches.

The numbers of the signals themselves are in the rows of a schedule; here is only which is which.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmodes.chain.chain import Chain, Motor
from tmodes.equations.loop.contact_kernels import Touch
from tmodes.equations.loop.control_kernels import Servo, Winding

__all__ = ["WORKS", "DrivePlan", "LoadPlan", "LoopPlan", "StateLayout", "TouchPlan", "winding_of"]

Array = NDArray[np.float64]

WORKS = ("motor", "loads", "base", "friction", "gear_damping", "link_damping", "contact")
"""Works [J] in the state: the first three brought in, the others taken out."""

BROUGHT_IN = 3
"""How many of the works are brought in."""


@dataclass(frozen=True)
class DrivePlan:
    """What moves one joint: a servo, or nothing but its signal, which it then follows exactly (``servo`` None).

    ``numbers``: R, CE, CM, L, then those of the controller; ``noise``: the signal of the error with which the
    controller sees its wanted value, -1 for none; ``clock``: the signal with the time since its last sample.
    """

    joint: str
    signal: int
    servo: Servo | None
    winding: Winding
    numbers: tuple[float, ...]
    noise: int = -1
    clock: int = -1

    @property
    def has_current(self) -> bool:
        """Whether the motor's current is a state."""
        return self.servo is not None and self.servo.has_current


@dataclass(frozen=True)
class LoadPlan:
    """A force and moment (6,) on a point, times a signal (-1: constant); of a follower in the point's axes."""

    point: int
    follower: bool
    wrench: tuple[float, ...]
    signal: int = -1


@dataclass(frozen=True)
class TouchPlan:
    """A point on a surface; ``numbers`` as the kernels want them."""

    point: int
    touch: Touch
    numbers: tuple[float, ...]

    @property
    def has_mass(self) -> bool:
        """Whether a mass moves with the point."""
        return self.touch.has_mass


@dataclass(frozen=True, eq=False)
class LoopPlan:
    """A chain in a run. ``base``: the six signals that move it, or none. Signals are polynomials of ``degree``."""

    chain: Chain
    drives: tuple[DrivePlan, ...]
    signals: int
    degree: int
    loads: tuple[LoadPlan, ...] = ()
    touch: TouchPlan | None = None
    base: tuple[int, ...] = ()

    @property
    def row_size(self) -> int:
        """Numbers of a row: start of the piece, coefficients of each signal."""
        return 1 + self.signals * (self.degree + 1)

    @property
    def currents(self) -> tuple[str, ...]:
        """Joints whose motor current is a state."""
        return tuple(drive.joint for drive in self.drives if drive.has_current)

    @property
    def further_states(self) -> tuple[str, ...]:
        """Names of the states between the rates and the works."""
        return (*(f"{name}.current" for name in self.currents), *self.control_names)

    @property
    def control_names(self) -> tuple[str, ...]:
        """Names of the controllers' own states, such as `hub.controller.integral`."""
        own = [(drive.joint, drive.servo.named_states) for drive in self.drives if drive.servo]
        return tuple(f"{joint}.controller.{state.name}" for joint, states in own for state in states)

    @property
    def control_units(self) -> tuple[str, ...]:
        """Units of the controllers' own states."""
        own = [(drive.joint in self.chain.sliding, drive.servo.named_states) for drive in self.drives if drive.servo]
        return tuple(state.unit_of(slides=slides) for slides, states in own for state in states)

    @property
    def aside(self) -> set[int]:
        """Signals that move nothing by themselves: noise on what controllers see, and their clocks."""
        return {place for drive in self.drives for place in (drive.noise, drive.clock)}

    @property
    def is_sampled(self) -> bool:
        """Whether any controller is."""
        return any(drive.servo.is_sampled for drive in self.drives if drive.servo)

    @property
    def controls(self) -> tuple[float, ...]:
        """The own states of all controllers at time 0, in the order of the drives."""
        return tuple(float(value) for drive in self.drives if drive.servo for value in drive.servo.start)


def winding_of(motor: Motor | None) -> tuple[Winding, tuple[float, ...]]:
    """Electric side of a motor, and R, CE, CM, L."""
    if motor is None or motor.resistance is None:
        return Winding.NONE, (1.0, 0.0, 1.0, 0.0)
    kind = Winding.INDUCTANCE if motor.inductance else Winding.RESISTANCE
    return kind, (motor.resistance, motor.back_emf, motor.torque_constant, motor.inductance)


class StateLayout(NamedTuple):
    """Where a state holds what: coordinates, rates, motor currents [A], controllers' own states, works [J]."""

    q: slice
    v: slice
    currents: slice
    controls: slice
    works: slice

    @classmethod
    def of(cls, coordinates: int, currents: int, controls: int) -> StateLayout:
        """Of so many coordinates, currents, and own states of controllers."""
        n, electric = coordinates, 2 * coordinates + currents
        end = electric + controls
        return cls(
            slice(0, n), slice(n, 2 * n), slice(2 * n, electric), slice(electric, end), slice(end, end + len(WORKS))
        )

    @property
    def size(self) -> int:
        """Numbers of a state."""
        return self.works.stop
