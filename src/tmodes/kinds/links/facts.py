"""What analyses ask of a link besides its equations: how far its model holds, how it gives way, and its data."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from typing import Any, ClassVar, NamedTuple, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.kinds.noted.functions import isfinite

__all__ = ["DIRECTIONS", "LUMPS_OF_BEAM", "AngleLimit", "LinkFacts"]

Array = NDArray[np.float64]

DIRECTIONS = ("twist", "bend_y", "bend_z", "stretch", "shear_y", "shear_z")
"""Ways in which a link may deform."""


class AngleLimit(NamedTuple):
    """Angles [rad] up to which a model holds, and up to which it is a fair guess.

    ``warning``: the angle at which a run warns, ``what``: then said of the link, with ``hint``; ``cure``: in short.
    """

    good: float
    fair: float
    warning: float
    what: str
    hint: str
    cure: str


SMALL_ANGLES = AngleLimit(
    0.1, 0.3, 0.1,
    "leaves the small angles of its model (up to 0.1 rad)",
    "take the model `strain`, which is exact in large deflection",
    "take the model strain",
)  # fmt: skip
"""Of lumped modes: the sine of the chord's angle is off by 0.2 % and 1.5 %; tan th = th holds to 0.3 % at 0.1 rad."""


LUMPS_OF_BEAM = "the lumped masses and springs of its links nearer to those of beams"
"""What is compared of links of lumps."""

LUMPED = 1.5
"""Uncertainty of the difference to masses and springs that are nearer to those of a beam."""


class LinkFacts(ABC):
    """Asked by describe, static, warnings and reports; of a rigid link only ``functions`` and ``outer_distance``."""

    angle_limit: ClassVar[AngleLimit] = SMALL_ANGLES

    comparison: ClassVar[str] = ""
    """What :meth:`compared` changes, after ``a run with``."""

    @property
    def bends(self) -> bool:
        """Whether it has coordinates of its own."""
        return True

    def compared(self) -> Self | None:
        """The same structure with other numbers, whose difference shows the error of the link's model.

        None where the error cannot be estimated so; a link that does not bend is compared with itself.
        """
        return None if self.bends else self

    @property
    def functions(self) -> Mapping[str, int]:
        """Number of coordinates in each of :data:`DIRECTIONS`; 0 where the link does not give way."""
        return dict.fromkeys(DIRECTIONS, 0)

    @property
    def projected(self) -> tuple[str, ...]:
        """Directions in which the material's moment is the projection of the load's on the link's functions."""
        return ()

    def uncertainty(self, direction: str, ratio: float, angle: float) -> float:  # noqa: ARG002
        """How far the true error may be, over the difference that :meth:`compared` makes; docs/errors.md.

        ``ratio``: of a projected direction, the energy of the moments that no function has over that of those which
        :meth:`compared` softens; ``angle``: the largest by which its line turns [rad]; of any other neither counts.
        """
        return LUMPED

    def other_moments(self, direction: str, s: ArrayLike) -> Array:  # noqa: ARG002
        """Moments (functions, *s) of a projected direction that :meth:`compared` does not soften."""
        return np.zeros((0, *np.shape(s)))

    @property
    def outer_distance(self) -> float:
        """Largest distance of the outer fibre from the line [m]; 0 where it is not known."""
        return 0.0

    def limiting_angles(self, q: Array, stations: tuple[float, ...] = ()) -> Array:  # noqa: ARG002
        """The angle that limits its model, (n,) [rad], at coordinates ``q`` (n, size)."""
        return np.abs(q).max(axis=1, initial=0.0)

    def stiffness_at(self, direction: str, s: ArrayLike) -> Array:  # noqa: ARG002
        """Stiffness of the section against a direction at s [N*m^2], of stretch and shear [N]; infinite: rigid."""
        return np.full(np.shape(s), np.inf)

    @property
    def beam_mass(self) -> float | None:
        """Mass of the beam itself [kg]; None where masses are lumped: then the sheet's own mass counts."""
        return self.described([self]).get("beam_mass_kg")

    @abstractmethod
    def described(self, row: Sequence[Any]) -> dict[str, Any]:
        """Data for ``tmodes describe`` of all elements of one link, ``row``, of which this is the first.

        ``mass_kg`` is left out where masses are lumped: then the sheet's own mass counts.
        """


def ends(first: float, last: float) -> list[float | None]:
    """Values at root and tip; None: rigid."""
    return [x if isfinite(x) else None for x in (first, last)]
