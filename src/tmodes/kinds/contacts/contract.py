"""What a contact is: a surface, and the law of normal force, moving mass and friction of a point that touches it.

A law of a user's own is a class with the field ``law`` and two methods::

    @CONTACTS.register
    class Soil(Contact):
        law: Literal["soil"] = Field(description="contact law")
        modulus: float = positive("N/m^1.5", "k", "Hertz stiffness")

        def numbers(self) -> tuple[float, ...]:
            return (self.modulus,)

        def normal_force(self, p, depth, rate):
            return p[0] * depth * functions.sqrt(depth)

Laws are written in an arithmetic that is passed in (numbers or symbols): sums, products, quotients, and the functions
of :mod:`tmodes.kinds.kernel.functions`. They run in native code, in batches, in derivatives and in WebAssembly.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, ClassVar

from pydantic import Field

from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.schema.frames import Vector, list_of_numbers
from tmodes.kinds.schema.kind import Kind

__all__ = ["CONTACTS", "SURFACE", "SURFACES", "Contact", "Meeting", "Surface"]

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
        """As ``SceneContact.surface`` of ``web/src/contract_scene.ts``: a plane (position, normal) or a ball."""
        raise NotImplementedError

    def moving_numbers(self) -> tuple[float, ...]:
        """Its place (3), radius [m] and normal (3) as a page moves them; 0: a plane's radius, a ball's normal."""
        drawn = self.drawing()
        place = drawn.get("position") or drawn["center"]
        return (*place, drawn.get("radius", 0.0), *drawn.get("normal", (0.0, 0.0, 0.0)))

    @property
    def steep_axis(self) -> int:
        """The axis of the world along which a page moves it; -1: it is not moved."""
        return -1


SURFACES = Surface.registry
"""Those of tmodes, and what a user registers: ``@SURFACES.register``."""


_OFF = 1e-3
"""Distance [m] from a surface that holds a point, from which on a run reports it."""


class Contact(Kind, family="contact law", key="law"):
    """Contact of one point with one surface."""

    unilateral: ClassVar[bool] = True
    """Whether the surface only pushes: no force where the point is outside, or where the law would pull."""

    rubs_with_mass: ClassVar[bool] = False
    """Whether friction is taken from the whole normal force, that of the moving mass included."""

    point: str = Field(default="tip", min_length=1, max_length=100, description="which point touches")
    shape: Surface
    velocity: Vector = list_of_numbers(
        "m/s", "vb", "velocity of the surface along itself (a belt), in the world", default=(0.0, 0.0, 0.0)
    )

    def numbers(self) -> tuple[float, ...]:
        """Numbers of the law, which its methods read as ``p``."""
        raise NotImplementedError

    def normal_force(self, p: Any, depth: Any, rate: Any) -> Any:
        """Normal force [N] by penetration [m] and its rate [m/s], but for the moving mass.

        The depth of a law that only pushes is greater than zero; where the result is negative, there is no force. That
        of a surface with a mass of its own is of either sign, and so is the force, which then moves the surface.
        """
        raise NotImplementedError

    @property
    def moving_mass(self) -> float:
        """Mass of the surface [kg] that moves with the point along the normal."""
        return 0.0

    @property
    def is_rough(self) -> bool:
        """Whether there is friction."""
        return False

    def friction_force(self, p: Any, normal: Any, slip: v.Vector, velocity: v.Vector) -> v.Vector:
        """Friction by the point on the surface [N]; ``normal`` [N], the force's own sign, enters as a factor.

        ``velocity`` is the point's against the surface's [m/s], ``slip`` its part along the surface. Proportional to
        the value of ``normal`` or to its magnitude.
        """
        del p, normal, slip, velocity
        return v.zero()

    @property
    def sticks(self) -> bool:
        """Whether friction at rest is a set: what keeps the point where it is, up to :meth:`static_limit`.

        Then :meth:`friction_force` is asked of slip alone, with ``slip`` and ``velocity`` a unit vector along it.
        """
        return False

    def static_limit(self, p: Any, normal: Any) -> Any:
        """Largest friction at rest [N], of a law that sticks."""
        del p, normal
        return 0.0

    def friction_width(self, p: Any) -> Any | None:
        """Slip [m/s] within which smooth friction changes, else None."""
        del p
        return None

    def resting(self) -> Contact:
        """The law of a robot at rest: nothing sticks, and no mass is apart from the point."""
        return self

    def restitution_of(self, p: Any) -> Any:
        """Speed of parting over that of meeting, of a surface with mass that only pushes."""
        del p
        return 0.0

    def spring(self) -> tuple[float, float, float] | None:
        """Stiffness [N/m], damping [N*s/m] and preload [N] of a law that is linear in these, else None."""
        return None

    @property
    def jumps(self) -> bool:
        """Whether the force starts or ends with a jump, so that derivatives of a run do not exist there."""
        return self.unilateral

    @property
    def structure(self) -> str:
        """The law's compiled form: two contacts of the same structure share their code."""
        rough = f"{' rough' * self.is_rough}{' sticks' * self.sticks}"
        return f"{self.fingerprint()}{rough} {len(self.numbers())}"

    def start_notices(self, normal: float, depth: float) -> Iterator[str]:
        """What a user should know of a start with this penetration [m] and normal force [N]."""
        if self.unilateral and depth > 0:
            yield f"the point starts {1e3 * depth:.3g} mm inside of the surface, which pushes it with {normal:.3g} N"
        if not self.unilateral and abs(depth) > _OFF:
            off = f"{1e3 * abs(depth):.3g} mm off the surface that holds it"
            yield f"the point starts {off}: a force of {normal:.3g} N at once"


CONTACTS = Contact.registry
"""The laws of tmodes, and what a user registers: ``@CONTACTS.register``."""
