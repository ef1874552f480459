"""What happens to a chain in a run, in plain terms: which signal moves what, what loads it, what it touches.

The numbers of the signals themselves are in the rows of a schedule; here is only which is which.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmodes.chain.chain import Chain
from tmodes.equations.loop.contact_kernels import Touch
from tmodes.equations.loop.control_kernels import Servo, Winding

__all__ = ["WORKS", "DrivePlan", "LoadPlan", "LoopPlan", "StateLayout", "TouchPlan"]

Array = NDArray[np.float64]

WORKS = ("motor", "loads", "base", "friction", "gear_damping", "link_damping", "contact")
"""Works [J] in the state: the first three brought in, the others taken out."""

BROUGHT_IN = 3
"""How many of the works are brought in."""


@dataclass(frozen=True)
class DrivePlan:
    """What moves one joint: a servo, or nothing but its signal, which it then follows exactly (``servo`` None).

    ``numbers``: R, CE, CM, L, then those of the controller; ``noise``: the signal of the error with which the
    controller sees its wanted value, -1 for none.
    """

    joint: str
    signal: int
    servo: Servo | None
    winding: Winding
    numbers: tuple[float, ...]
    noise: int = -1

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
        own = [(drive.joint, drive.servo.states) for drive in self.drives if drive.servo]
        names = (f"{joint}.controller{k + 1}" for joint, count in own for k in range(count))
        return (*(f"{name}.current" for name in self.currents), *names)

    @property
    def controls(self) -> tuple[float, ...]:
        """The own states of all controllers at time 0, in the order of the drives."""
        laws = [drive.servo.controller for drive in self.drives if drive.servo]
        return tuple(float(value) for law in laws if law for value in law.initial())


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
