"""What the floors above need of a maker of equations: the recursion and Lagrange's equations both fulfil it.

A maker gives three schedules of the dynamics alone (``forward``, ``inertia``, ``elastic``), and, for the closed loop,
the outward pass and the accelerations under drives and loads in a schedule that is being written.
"""

from __future__ import annotations

from typing import Any, Protocol

from tmodes.equations.recursion.parts import AxisPart, Parts
from tmodes.equations.recursion.passes import Blocks
from tmodes.kinds.kernel.schedule import Divisible, Schedule, Slot

__all__ = ["Dynamics", "Mechanics", "Way"]


class Way(Protocol):
    """Motion of the bodies at one instant, before accelerations are known; the calls are added to a schedule."""

    parts: Parts
    schedule: Schedule
    q: Slot
    v: Slot
    base: Slot
    none: dict[int, Slot]
    wrenches: dict[int, Slot]
    """Number of a point -> force and moment on it, in world axes."""

    def angle(self, axis: AxisPart) -> tuple[Slot, Slot]:
        """Coordinate and rate of a joint."""
        ...

    def motor(self, axis: AxisPart) -> tuple[Slot, Slot]:
        """Angle and rate of a motor."""
        ...

    def frame_of(self, k: int) -> tuple[Slot, Slot, Slot]:
        """Pose of the frame that a point is fixed to, pose of its link's axes, and its rate in them."""
        ...

    def offset(self, k: int) -> Slot:
        """Placement of a point in its frame."""
        ...

    def takes_mass(self, k: int) -> bool:
        """Whether an inertia can be attached at a point."""
        ...

    def touched(self, k: int, touch: Any, numbers: Slot, wrench: Slot, step: Slot | None) -> None:
        """A contact on a point: its push is in ``wrench``; ``step``: a mass moves with the point, in steps of this.

        ``touch``: the kernels of :class:`tmodes.equations.loop.contact_kernels.Touch`.
        """
        ...

    def link_losses(self) -> list[Slot]:
        """Powers lost inside the links [W]."""
        ...


class Dynamics(Protocol):
    """Accelerations under drives and loads, and what follows from them."""

    followed: dict[int, Slot]
    coupled: dict[int, tuple[Slot, Slot]]
    coupled_loads: dict[int, Slot]
    torques: dict[int, Slot]
    accelerations: list[Slot]
    contact: Slot | None
    """Normal force, fold and power of a contact that was solved for with the accelerations; None where it was not."""

    def run(self) -> list[Slot]:
        """Accelerations of the coordinates, in their order."""
        ...

    def force_along(self, axis: AxisPart) -> Slot:
        """Force that the bodies ask of a prescribed joint."""
        ...

    def point(self, k: int) -> tuple[Slot, ...]:
        """Pose, rate and acceleration (less gravity) of a point in the world."""
        ...

    def at_base(self) -> tuple[Slot, Slot]:
        """Inertia and bias force of all that hangs on the base."""
        ...


class Mechanics(Protocol):
    """One maker with the numbers of one chain."""

    @property
    def parts(self) -> Parts:
        """Coordinates, drives, points and numbers."""
        ...

    @property
    def base_moves(self) -> bool:
        """Whether the base may be moved in a run."""
        ...

    @property
    def on_links(self) -> bool:
        """Whether the chain's links are the robot's own, so that the recursion gives the places along them."""
        ...

    @property
    def zeros(self) -> tuple[Slot, ...]:
        """Parameters that are zero whatever the robot's numbers."""
        ...

    def schedule(self, name: str, *, loaded: bool = False) -> Schedule:
        """``forward``, ``inertia`` or ``elastic``; ``loaded``: forces act on the points."""
        ...

    def drawn(self, blocks: Blocks) -> dict[str, Slot]:
        """What is drawn besides the links, by name: each axes (9), start and end (3 each), in world axes."""
        ...

    def way(self, blocks: Blocks, *, posed: bool) -> Any:
        """The outward pass in a schedule; ``posed``: poses of points are needed."""
        ...

    def dynamics(
        self,
        way: Any,
        effort: Slot,
        given: Slot,
        step: Slot,
        start: tuple[Divisible, Slot],
        feedback: Slot | None = None,
    ) -> Any:
        """The accelerations, as :class:`tmodes.equations.recursion.driven.Driven` takes its inputs."""
        ...
