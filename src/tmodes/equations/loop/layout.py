"""Where the state of a run holds what."""

from __future__ import annotations

from itertools import accumulate, pairwise
from typing import NamedTuple

__all__ = ["BROUGHT_IN", "WORKS", "StateLayout"]

WORKS = ("motor", "loads", "base", "friction", "gear_damping", "link_damping", "contact")
"""Works [J] in the state: the first three brought in, the others taken out."""

BROUGHT_IN = 3
"""How many of the works are brought in."""


class StateLayout(NamedTuple):
    """Where a state holds what: coordinates, rates, motor currents [A], own states of controllers and of a surface.

    Then works [J] and modes: of coordinates with dry friction (0 while one sticks, else the sign of its slip), of a
    contact, and of given motions whose rates jump. They switch at instants.
    """

    q: slice
    v: slice
    currents: slice
    controls: slice
    surface: slice
    works: slice
    modes: slice

    @classmethod
    def of(cls, coordinates: int, currents: int, controls: int, surface: int = 0, modes: int = 0) -> StateLayout:
        """Of so many coordinates, currents, own states of controllers and of a surface, and modes."""
        n = coordinates
        sizes = (n, n, currents, controls, surface, len(WORKS), modes)
        return cls(*(slice(*pair) for pair in pairwise(accumulate(sizes, initial=0))))

    @property
    def size(self) -> int:
        """Numbers of a state."""
        return self.modes.stop
