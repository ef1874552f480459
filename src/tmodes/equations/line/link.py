"""What the schedule of the elastic lines asks of a kind of bending link: its numbers, and the calls for its places."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from tmodes.kinds.kernel.kernel import Kernel
from tmodes.kinds.kernel.schedule import Numbers, Slot

__all__ = ["LineOfLink", "Moved"]


@dataclass(frozen=True)
class Moved:
    """A link in the schedule: its coordinates with rates and accelerations, and how its root moves and what it carries.

    ``tables``: the numbers that the recursion has of it. ``pose`` (15) of the root in the world, ``rate`` (3) and
    ``acceleration`` (6: angular, linear less gravity) of the root; ``outer``: of each station and of the tip the force
    (6: moment, force) that all single bodies and points from there on need, about the root. All but the pose in the
    axes of the root.
    """

    call: Callable[..., tuple[Slot, ...]]
    numbers: Numbers
    tables: Slot
    q: Slot
    v: Slot
    a: Slot
    pose: Slot
    rate: Slot
    acceleration: Slot
    outer: Sequence[Slot]

    def one(self, kernel: Kernel, *inputs: Slot) -> Slot:
        """Call a kernel of one output."""
        return self.call(kernel, *inputs)[0]


class LineOfLink(ABC):
    """The line of one link at places s in 0..1 (0 its root, 1 its tip)."""

    kind: str
    length: float
    stressed: bool = False
    """Whether section and material are known."""

    @abstractmethod
    def places(self, moved: Moved) -> list[Slot]:
        """Add the numbers and the calls; one block for each place, see :func:`tmodes.equations.line.place.layout`."""
