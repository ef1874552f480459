"""The equations of the link kind ``modes``: inertia of the masses before the tip, springs and dampers of the modes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.kernel.functions import cos, sin
from tmodes.kinds.kernel.spatial import Force, body_inertia
from tmodes.kinds.links.contract import ElasticForces, LinkStructure, Row
from tmodes.kinds.links.modes_line import TANGENT, ModeAngles, ModesLine
from tmodes.kinds.links.terms import LinkTerms

__all__ = ["ModesStructure"]


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

    def angles(self, q: Any, qd: Any) -> tuple[ModeAngles, ModeAngles]:
        """Azimuths and elevations of all modes."""
        n, order, index = sum(self.free), [], 0
        for bends in self.free:
            order.append(index if bends else -1)
            index += bends

        def of(x: Any, first: int) -> list[Any]:
            return [x[first + k] if k >= 0 else 0.0 for k in order]

        return ModeAngles(of(q, 0), of(qd, 0)), ModeAngles(of(q, n), of(qd, n))

    def sections(self, tables: Any, rate: Any, q: Any, qd: Any) -> tuple[list[Any], list[list[Any]]]:
        """Inertia of the masses before the tip, and the sections at the tip and the stations."""
        m, azimuth_elevation = self.modes, self.angles(q, qd)
        line = ModesLine([tables[k] for k in range(m)], *azimuth_elevation, self.free, v.vec(rate))
        terms = LinkTerms.nothing(self.size)
        for k in range(m - 1):
            turning = [v.scale(tables[2 * m + k], v.unit(i)) for i in range(3)]
            inertia = body_inertia(tables[m + k], v.zero(), turning)
            terms = terms.with_body(line.section(k, 1.0, 1.0, TANGENT), inertia, Force.zero())
        found = [line.section(m - 1, 1.0, 1.0, TANGENT)]
        for number, mode in enumerate(self.places):
            found.append(line.section(mode, *(tables[3 * m + 3 * number + i] for i in range(3))))
        return terms.packed() if self.own_terms else [0.0], [section.packed() for section in found]

    def elastic(self, stiffness: Any, damping: Any, q: Any, qd: Any) -> ElasticForces:
        """Forces of 1/2 sum Cs l^2 (th_e^2 + cos(b)^2 th_a^2); dampers likewise in the rates, with cos(b) held."""
        azimuth, elevation = self.angles(q, qd)
        springs, dampers = _ModeSums(self.free), _ModeSums(self.free)
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

    def _lever(self, elevation: ModeAngles, mode: int) -> tuple[Any, Any]:
        """Cosine and sine of the elevation of a chord."""
        angle = elevation.direction(mode, 1.0)[0]
        return cos(angle), sin(angle)


class _ModeSums:
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
