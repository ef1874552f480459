"""The link kind ``modes``: the 2010 paper's modes in one link, with angles that add up inside it.

Coordinates are the bending angles th_k of the n modes: all azimuths, then all elevations. Masses (33/140 of each mode)
and isotropic rotary inertias sit at the modes' ends. The springs act on deflections: l_k th in elevation, and
l_k cos(elevation of chord k) th in azimuth, so they are not quadratic in the coordinates.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, ClassVar, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.kinds.links.contract import Body, Link, LinkNumbers
from tmodes.kinds.links.facts import DIRECTIONS, LUMPS_OF_BEAM, ends
from tmodes.kinds.links.line import LineOfLink
from tmodes.kinds.links.modes_places import ModePlaces
from tmodes.kinds.links.modes_sheet import Mode, eased, shape_angle, shape_slope
from tmodes.kinds.links.modes_structure import ModesStructure
from tmodes.kinds.links.rigid import RigidLink, rod
from tmodes.kinds.noted.functions import distinct, isfinite, minimum, number

__all__ = ["ModesLink", "RigidModesLink"]

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class ModesLink(Link):
    """Modes from root to tip; ``bodies``: (s, body) in section axes, s over the length of all modes.

    ``likened``: with the masses and springs of :meth:`compared`.
    """

    kind: ClassVar[str] = "modes"
    comparison: ClassVar[str] = LUMPS_OF_BEAM

    modes: tuple[Mode, ...]
    bodies: tuple[tuple[float, Body], ...] = ()
    likened: bool = False
    length: float = field(init=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "length", number(sum(mode.length for mode in self.modes)))

    @property
    def carried(self) -> tuple[tuple[float, Body], ...]:
        """The bodies with their stations."""
        return self.bodies

    @property
    def free(self) -> tuple[bool, ...]:
        """Which modes bend."""
        return tuple(isfinite(mode.bending_stiffness) for mode in self.modes)

    @property
    def coordinates(self) -> tuple[str, ...]:
        """``azimuth1`` ... of the modes that bend, then ``elevation1`` ..."""
        numbers = [k + 1 for k, bends in enumerate(self.free) if bends]
        return tuple(f"{plane}{number}" for plane in ("azimuth", "elevation") for number in numbers)

    def stations(self, asked: Sequence[float] = ()) -> tuple[float, ...]:
        """Bodies and named points anywhere along it."""
        return self.along(asked)

    @property
    def body_places(self) -> tuple[float, ...]:
        """Places s < 1 that carry bodies."""
        return tuple(distinct(s for s, _ in self.bodies if s < 1.0))

    def bodies_at(self, s: float) -> tuple[Body, ...]:
        """Bodies on the section at s; at the tip the last mode's equivalent mass, too."""
        own = tuple(body for at, body in self.bodies if (at >= 1.0 if s >= 1.0 else at == s))
        if s < 1.0:
            return own
        last = self.modes[-1]
        lump = Body(last.tip_mass, np.zeros(3), last.tip_inertia * np.eye(3))
        return (rod(last.mass, last.length) if self.likened else lump, *own)

    def compared(self) -> Self:
        """The last mode with its mass as a rod that turns with the tip, all as stiff as beams under a force there.

        Before the last one only a mass at the end of a mode can change: to 0.4 of the mode's, between the half that a
        rigid beam's first moment asks for and the third of its second.
        """
        return replace(self, likened=True)

    @property
    def functions(self) -> Mapping[str, int]:
        """One angle of each mode that bends, in both planes."""
        return dict.fromkeys(DIRECTIONS, 0) | {"bend_y": sum(self.free), "bend_z": sum(self.free)}

    def limiting_angles(self, q: Array, stations: tuple[float, ...] = ()) -> Array:  # noqa: ARG002
        """Largest angle of a mode's chord."""
        return np.hypot(*np.split(q, 2, axis=1)).max(axis=1)

    def stiffness_at(self, direction: str, s: ArrayLike) -> Array:
        """EI of the mode at s."""
        if direction not in ("bend_y", "bend_z"):
            return np.full(np.shape(s), np.inf)
        places = np.asarray(s, dtype=float)
        values = [self.modes[self.place(float(one))[0]].bending_stiffness for one in places.ravel()]
        return np.reshape(values, places.shape)

    def described(self, row: Sequence[Any]) -> dict[str, Any]:  # noqa: ARG002
        """Its modes."""
        stiffness = ends(self.modes[0].bending_stiffness, self.modes[-1].bending_stiffness)
        return {
            "model": f"modes ({len(self.modes)})",
            "length_m": self.length,
            "bending_stiffness_y_Nm2": stiffness,
            "bending_stiffness_z_Nm2": stiffness,
        }

    def place(self, s: float) -> tuple[int, float]:
        """The mode at s and the share of its length that is before s."""
        at, start = s * self.length, 0.0
        for k, mode in enumerate(self.modes):
            if at <= start + mode.length * (1 + 1e-12) or k == len(self.modes) - 1:
                return k, minimum((at - start) / mode.length, 1.0)
            start += mode.length
        raise AssertionError

    def lines(self, stations: tuple[float, ...], s: NDArray[np.float64]) -> Sequence[LineOfLink]:
        """One line for each mode."""
        structure, start, found = self.numbers(stations).structure, 0.0, []
        for k, mode in enumerate(self.modes):
            suffix, share = f".{k + 1}" * (len(self.modes) > 1), mode.length / self.length
            found.append(ModePlaces(mode.length, stations, s, suffix, structure=structure, mode=k, start=start,
                                    share=share))  # fmt: skip
            start += share
        return found

    def numbers(self, stations: tuple[float, ...]) -> LinkNumbers:
        """Lengths, equivalent masses and inertias, stations; Cs l^2 and Bs l^2 of the modes that bend."""
        places = [self.place(s) for s in stations]
        lumps = [(0.4 * m.mass, 0.0) if self.likened else (m.tip_mass, m.tip_inertia) for m in self.modes]
        table = [[mode.length for mode in self.modes], *map(list, zip(*lumps, strict=True))]
        table += [[share, shape_angle(share), shape_slope(share)] for _, share in places]
        bending = [mode for mode, bends in zip(self.modes, self.free, strict=True) if bends]
        beyond = self.length - np.cumsum([mode.length for mode in self.modes])[np.array(self.free)]
        ease = [eased(b / m.length) if self.likened else 1.0 for b, m in zip(beyond, bending, strict=True)]
        springs, dampers = (
            np.array([getattr(m, name) * m.length**2 * share for m, share in zip(bending, ease, strict=True)])
            for name in ("tip_stiffness", "tip_damping")
        )
        structure = ModesStructure(self.free, tuple(mode for mode, _ in places))
        return LinkNumbers(structure, np.concatenate(table), springs, dampers)


@dataclass(frozen=True, eq=False)
class RigidModesLink(RigidLink):
    """A link whose ``modes`` are all rigid: its bodies, and of what they were made; ``carried``: (s, body)."""

    modes: tuple[Mode, ...] = ()
    carried: tuple[tuple[float, Body], ...] = ()
