"""The rigid link: bodies in one frame."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from tmodes.kinds.links.contract import Body, Link, LinkNumbers
from tmodes.kinds.links.line import LineOfLink

__all__ = ["RigidLink", "rod"]

Array = NDArray[np.float64]


def rod(mass: float, length: float) -> Body:
    """A thin uniform rod of a mass [kg] along x that ends at its frame."""
    return Body(mass, np.array([-length / 2, 0.0, 0.0]), np.diag([0.0, 1.0, 1.0]) * mass * length**2 / 12)


@dataclass(frozen=True, eq=False)
class RigidLink(Link):
    """A link that does not bend; ``bodies`` in its link frame, which is also its tip frame.

    ``beam``: the :class:`tmodes.kinds.links.rigid_beam.RigidBeam` that it is made of, None where it is of bodies alone.
    """

    kind: ClassVar[str] = "rigid"

    bodies: tuple[Body, ...] = ()
    length: float = field(default=0.0, init=False)
    beam: Any = None

    @property
    def bends(self) -> bool:
        """Never."""
        return False

    @property
    def mass_line(self) -> Any:
        """Where its mass is along it, of a beam that does not bend."""
        return self.beam

    @property
    def coordinates(self) -> tuple[str, ...]:
        """None."""
        return ()

    def bodies_at(self, s: float) -> tuple[Body, ...]:  # noqa: ARG002
        """All bodies: the link has only one place."""
        return self.bodies

    def described(self, row: Sequence[Any]) -> dict[str, Any]:  # noqa: ARG002
        """Nothing but its bodies."""
        return {}

    def lines(self, stations: tuple[float, ...], s: Array) -> Sequence[LineOfLink]:  # noqa: ARG002
        """None: where its far end is, is a matter of the chain."""
        return []

    def numbers(self, stations: tuple[float, ...]) -> LinkNumbers:
        """A rigid link has no equations of its own."""
        raise NotImplementedError
