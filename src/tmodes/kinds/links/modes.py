"""The link kind ``modes``: the 2010 paper's modes in one link, with angles that add up inside it.

Coordinates are the bending angles th_k of the n modes: all azimuths, then all elevations. Masses (33/140 of each mode)
and isotropic rotary inertias sit at the modes' ends. The springs act on deflections: l_k th in elevation, and
l_k cos(elevation of chord k) th in azimuth, so they are not quadratic in the coordinates.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.kernel.functions import cos, sin
from tmodes.kinds.links.contract import Body, ElasticForces, Link, LinkNumbers, LinkStructure, Row
from tmodes.kinds.links.facts import ends
from tmodes.kinds.links.line import LineOfLink
from tmodes.kinds.links.modes_line import TANGENT, Angles, ModesLine
from tmodes.kinds.links.modes_places import ModePlaces
from tmodes.kinds.links.modes_sheet import Mode, shape_angle, shape_slope
from tmodes.kinds.links.terms import LinkTerms, Section

__all__ = ["ModesLink", "ModesStructure"]

Array = NDArray[np.float64]


@dataclass(frozen=True)
class ModesStructure(LinkStructure):
    """``free``: which modes bend; ``places``: for each station, the mode that it is on."""

    free: tuple[bool, ...]
    places: tuple[int, ...] = ()

    @property
    def own_terms(self) -> bool:
        """Masses between root and tip."""
        return len(self.free) > 1 or bool(self.places)

    @property
    def stations(self) -> tuple[int, ...]:
        """The mode of each station."""
        return self.places

    @property
    def key(self) -> str:
        """The structure in words."""
        places = ".".join(map(str, self.places)) or "-"
        return f"modes {''.join('f' if bends else 'r' for bends in self.free)} s{places}"

    @property
    def modes(self) -> int:
        """Number of modes, the rigid ones too."""
        return len(self.free)

    @property
    def size(self) -> int:
        """Two coordinates for each mode that bends."""
        return 2 * sum(self.free)

    @property
    def table_size(self) -> int:
        """Length, mass and rotary inertia of each mode; place, chord share and slope share of each station."""
        return 3 * self.modes + 3 * len(self.places)

    @property
    def stiffness_size(self) -> int:
        """Cs l^2 of each mode that bends."""
        return sum(self.free)

    def angles(self, q: Any, qd: Any) -> tuple[Angles, Angles]:
        """Azimuths and elevations of all modes."""
        n, order, index = sum(self.free), [], 0
        for bends in self.free:
            order.append(index if bends else -1)
            index += bends

        def of(x: Any, first: int) -> list[Any]:
            return [x[first + k] if k >= 0 else 0.0 for k in order]

        return Angles(of(q, 0), of(qd, 0)), Angles(of(q, n), of(qd, n))

    def sections(self, tables: Any, rate: Any, q: Any, qd: Any) -> tuple[list[Any], list[list[Any]]]:
        """Inertia of the masses before the tip, and the sections at the tip and the stations."""
        m, azimuth_elevation = self.modes, self.angles(q, qd)
        line = ModesLine([tables[k] for k in range(m)], *azimuth_elevation, self.free, v.vec(rate))
        terms = LinkTerms.nothing(self.size)
        for k in range(m - 1):
            _add_mass(terms, line.section(k, 1.0, 1.0, TANGENT), tables[m + k], tables[2 * m + k])
        found = [line.section(m - 1, 1.0, 1.0, TANGENT)]
        for number, mode in enumerate(self.places):
            found.append(line.section(mode, *(tables[3 * m + 3 * number + i] for i in range(3))))
        return terms.packed() if self.own_terms else [0.0], [section.packed() for section in found]

    def elastic(self, stiffness: Any, damping: Any, q: Any, qd: Any) -> ElasticForces:
        """Forces of 1/2 sum Cs l^2 (th_e^2 + cos(b)^2 th_a^2); dampers likewise in the rates, with cos(b) held."""
        azimuth, elevation = self.angles(q, qd)
        springs, dampers = _Rows(self.free), _Rows(self.free)
        energy: list[Any] = []
        loss: list[Any] = []
        for b, k in enumerate(self._bending):
            flat, up = azimuth.values[k], elevation.values[k]
            c, s = self._lever(elevation, k)
            pull = stiffness[b] * c * flat
            springs.add(0, k, pull * c)
            springs.add(1, k, stiffness[b] * up)
            for j in range(k + 1):
                springs.add(1, j, -((1.0 if j == k else TANGENT) * pull * s * flat))
            energy += [pull * c * flat, stiffness[b] * up * up]
            slow = (damping[b] * c * c * azimuth.rates[k], damping[b] * elevation.rates[k])
            dampers.add(0, k, slow[0])
            dampers.add(1, k, slow[1])
            loss += [slow[0] * azimuth.rates[k], slow[1] * elevation.rates[k]]
        return ElasticForces(springs.packed(), dampers.packed(), v.total(energy) / 2, v.total(loss))

    def tangents(self, stiffness: Any, damping: Any, q: Any, qd: Any) -> tuple[list[Row], list[Row]]:
        """Second derivatives of the energy, and the dampers' coefficients."""
        azimuth, elevation = self.angles(q, qd)
        n, bending = sum(self.free), self._bending
        k_full = [[0.0 for _ in range(2 * n)] for _ in range(2 * n)]
        d_full = [[0.0 for _ in range(2 * n)] for _ in range(2 * n)]
        for b, k in enumerate(bending):
            c, s = self._lever(elevation, k)
            flat = azimuth.values[k]
            k_full[b][b] = k_full[b][b] + stiffness[b] * c * c
            k_full[n + b][n + b] = k_full[n + b][n + b] + stiffness[b]
            d_full[b][b], d_full[n + b][n + b] = damping[b] * c * c, damping[b]
            shares = [(i, 1.0 if j == k else TANGENT) for i, j in enumerate(bending) if j <= k]
            mixed, curved = -2 * (stiffness[b] * c * s * flat), stiffness[b] * flat * flat * (s * s - c * c)
            for i, share in shares:
                k_full[b][n + i] = k_full[n + i][b] = k_full[n + i][b] + share * mixed
                for j, other in shares:
                    k_full[n + i][n + j] = k_full[n + i][n + j] + share * other * curved
        return [[*enumerate(row)] for row in k_full], [[*enumerate(row)] for row in d_full]

    @property
    def _bending(self) -> list[int]:
        return [k for k, bends in enumerate(self.free) if bends]

    def _lever(self, elevation: Angles, mode: int) -> tuple[Any, Any]:
        """Cosine and sine of the elevation of a chord."""
        angle = elevation.direction(mode, 1.0)[0]
        return cos(angle), sin(angle)


class _Rows:
    """Sums by coordinate: plane 0 azimuth, 1 elevation, and the number of a mode; rigid modes have none."""

    def __init__(self, free: tuple[bool, ...]) -> None:
        self.keys = [(plane, k) for plane in (0, 1) for k, bends in enumerate(free) if bends]
        self.values: dict[tuple[int, int], Any] = {}

    def add(self, plane: int, mode: int, value: Any) -> None:
        """Add to a coordinate's sum."""
        key = (plane, mode)
        self.values[key] = self.values[key] + value if key in self.values else value

    def packed(self) -> list[Any]:
        """The sums in the order of the coordinates."""
        return [self.values[key] for key in self.keys]


def _add_mass(terms: LinkTerms, section: Section, mass: Any, inertia: Any) -> None:
    """Add a point mass with isotropic rotary inertia, fixed to a section, to the link's inertia terms."""
    columns, bias, place = section.columns, section.bias, section.position
    for i, column in enumerate(columns):
        push, turn = v.scale(mass, column.linear), v.scale(inertia, column.angular)
        for j in range(i + 1):
            terms.mass[i][j] = terms.mass[i][j] + v.dot(push, columns[j].linear) + v.dot(turn, columns[j].angular)
        terms.bias_q[i] = terms.bias_q[i] + v.dot(push, bias.linear) + v.dot(turn, bias.angular)
        own = terms.coupling[i]
        terms.coupling[i] = type(own)(v.add(own.angular, v.add(v.cross(place, push), turn)), v.add(own.linear, push))
    square = v.dot(place, place)
    for i in range(3):
        for j in range(3):
            more = -(mass * place[i] * place[j])
            terms.angular[i][j] = terms.angular[i][j] + (mass * square + inertia + more if i == j else more)
    terms.moment = v.add(terms.moment, v.scale(mass, place))
    terms.total = terms.total + mass
    push = v.scale(mass, bias.linear)
    turned = v.add(v.cross(place, push), v.scale(inertia, bias.angular))
    terms.bias = type(terms.bias)(v.add(terms.bias.angular, turned), v.add(terms.bias.linear, push))


@dataclass(frozen=True, eq=False)
class ModesLink(Link):
    """Modes from root to tip; ``bodies``: (s, body) in section axes, s over the length of all modes."""

    kind: ClassVar[str] = "modes"

    modes: tuple[Mode, ...]
    bodies: tuple[tuple[float, Body], ...] = ()
    length: float = field(init=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "length", float(sum(mode.length for mode in self.modes)))

    @property
    def free(self) -> tuple[bool, ...]:
        """Which modes bend."""
        return tuple(bool(np.isfinite(mode.bending_stiffness)) for mode in self.modes)

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
        return tuple(sorted({s for s, _ in self.bodies if s < 1.0}))

    def bodies_at(self, s: float) -> tuple[Body, ...]:
        """Bodies on the section at s; at the tip the last mode's equivalent mass, too."""
        own = tuple(body for at, body in self.bodies if (at >= 1.0 if s >= 1.0 else at == s))
        if s < 1.0:
            return own
        last = self.modes[-1]
        return (Body(last.tip_mass, np.zeros(3), last.tip_inertia * np.eye(3)), *own)

    @property
    def functions(self) -> Mapping[str, int]:
        """One angle of each mode that bends, in both planes."""
        return {"twist": 0, "bend_y": sum(self.free), "bend_z": sum(self.free), "stretch": 0}

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
                return k, min((at - start) / mode.length, 1.0)
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
        table = [[mode.length for mode in self.modes], [mode.tip_mass for mode in self.modes]]
        table += [[mode.tip_inertia for mode in self.modes]]
        table += [[share, shape_angle(share), shape_slope(share)] for _, share in places]
        bending = [mode for mode, bends in zip(self.modes, self.free, strict=True) if bends]
        springs = np.array([mode.tip_stiffness * mode.length**2 for mode in bending])
        dampers = np.array([mode.tip_damping * mode.length**2 for mode in bending])
        structure = ModesStructure(self.free, tuple(mode for mode, _ in places))
        return LinkNumbers(structure, np.concatenate(table), springs, dampers)
