"""What a surface is: where a point stands with regard to it, and how a page draws it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.schema.kind import Kind

__all__ = ["SURFACE", "SURFACES", "Meeting", "Surface"]

SURFACE = 4
"""Numbers of a surface in compiled code: direction or center (3), distance or radius."""


@dataclass(frozen=True)
class Meeting:
    """A point and a surface.

    ``direction``: unit vector into the surface; ``depth``: penetration [m], negative where they are apart; ``rate``:
    its derivative; ``curving``: its second derivative but for the point's own acceleration [m/s^2].
    """

    direction: v.Vector
    depth: Any
    rate: Any
    curving: Any


class Surface(Kind, family="surface", key="type"):
    """The shape of what a point touches."""

    @property
    def shape(self) -> str:
        """The structure of :meth:`meet`: surfaces of the same word share their compiled code."""
        return self.fingerprint()

    def numbers(self) -> tuple[float, float, float, float]:
        """What :meth:`meet` reads as ``p``."""
        raise NotImplementedError

    def meet(self, p: Any, place: v.Vector, velocity: v.Vector) -> Meeting:
        """A point at ``place`` with ``velocity``, in any arithmetic; ``p`` are the surface's numbers."""
        raise NotImplementedError

    def drawing(self) -> dict[str, Any]:
        """As ``SceneContact.surface`` of ``web/src/contract.ts``: a plane (position, normal) or a ball."""
        raise NotImplementedError

    def moving_numbers(self) -> tuple[float, float, float, float]:
        """Its place and its radius [m] as a page moves them; the radius of a plane is 0."""
        drawn = self.drawing()
        x, y, z = drawn.get("position") or drawn["center"]
        return x, y, z, drawn.get("radius", 0.0)

    @property
    def steep_axis(self) -> int:
        """The axis of the world along which a page moves it; -1: it is not moved."""
        return -1


SURFACES = Surface.registry
"""Those of tmodes, and what a user registers: ``@SURFACES.register``."""
