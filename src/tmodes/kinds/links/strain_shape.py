"""What a strain link's equations look like: how many functions, points and stations; and where its numbers stand."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from itertools import accumulate
from typing import Any

__all__ = ["StrainShape", "TableReader"]


@dataclass(frozen=True)
class StrainShape:
    """Structure of a strain link, without a number.

    ``points``: Gauss points; ``stations``: for each station, the number of the points before it; ``rotary``: 0 no
    section inertia, 1 about the tangent, 3 about all axes; ``curved``: bent at rest; ``full``: stiffness matrices are
    not diagonal; ``spans``: points of each span between bodies inside, none where there is but one.
    """

    twist: int
    bend_y: int
    bend_z: int
    stretch: int
    shear_y: int
    shear_z: int
    points: int
    stations: tuple[int, ...] = ()
    rotary: int = 0
    curved: bool = False
    full: bool = False
    spans: tuple[int, ...] = ()

    @property
    def directions(self) -> tuple[int, ...]:
        """Component of curvature (0 twist, 1 about y, 2 about z) of each rotating function, in order."""
        return (0,) * self.twist + (1,) * self.bend_y + (2,) * self.bend_z

    @property
    def turning(self) -> int:
        """Number of functions that turn sections."""
        return len(self.directions)

    @property
    def shifts(self) -> tuple[int, ...]:
        """Axis of the section (0 stretch, 1 and 2 shear along y and z) of each function that only shifts, in order."""
        return (0,) * self.stretch + (1,) * self.shear_y + (2,) * self.shear_z

    @property
    def shifting(self) -> int:
        """Number of functions that shift sections without turning them."""
        return len(self.shifts)

    @property
    def size(self) -> int:
        """Number of coordinates."""
        return self.turning + self.shifting

    @property
    def work(self) -> int:
        """How long its line's code is, in proportion."""
        return self.size**2 * (self.points + len(self.stations))

    @property
    def planar(self) -> int | None:
        """The only component of curvature where there is but one, which needs no series; else None."""
        only = set(self.directions)
        return only.pop() if len(only) == 1 and not self.curved else None

    @property
    def breaks(self) -> tuple[tuple[str, int], ...]:
        """Where sections are, from root to tip: ("point", m), ("station", k), ("tip", 0)."""
        found: list[tuple[str, int]] = []
        for m in range(self.points + 1):
            found += [("station", k) for k, before in enumerate(self.stations) if before == m]
            found.append(("point", m) if m < self.points else ("tip", 0))
        return tuple(found)

    @cached_property
    def parts(self) -> tuple[range, ...]:
        """The points of each span."""
        ends = list(accumulate(self.spans or (self.points,), initial=0))
        return tuple(map(range, ends, ends[1:]))

    @cached_property
    def tables(self) -> dict[str, int]:
        """Sizes of the tables of numbers, in the order in which they are packed."""
        intervals, g = len(self.breaks), self.points
        return {
            "alpha": intervals * self.turning,
            "beta": intervals * self.turning if self.planar is None else 0,
            "rest": intervals * 3 if self.curved else 0,
            "root_mass": sum(n * (n + 1) for n in self.spans) or g * (g + 1) // 2,
            "first_moment": g,
            "mass": 1,
            "to_tip": g,
            "shifts": g * self.shifting,
            "rotary": g * self.rotary,
            "to_station": g * len(self.stations),
        }

    @cached_property
    def table_starts(self) -> dict[str, int]:
        """Where each table begins."""
        return dict(zip(self.tables, accumulate(self.tables.values(), initial=0), strict=False))

    @property
    def table_size(self) -> int:
        """Numbers in all tables."""
        return sum(self.tables.values())

    @property
    def stiffness_sizes(self) -> tuple[int, ...]:
        """Functions of each direction, for the blocks of the stiffness matrix."""
        counts = (self.twist, self.bend_y, self.bend_z, self.stretch, self.shear_y, self.shear_z)
        return tuple(count for count in counts if count)

    @property
    def key(self) -> str:
        """The structure in words."""
        stations = ".".join(map(str, self.stations)) or "-"
        spans = "".join(f" p{number}" for number in self.spans)
        return (
            f"strain t{self.twist} y{self.bend_y} z{self.bend_z} x{self.stretch} v{self.shear_y} w{self.shear_z} "
            f"g{self.points} s{stations} r{self.rotary} {'curved' if self.curved else 'straight'} "
            f"{'full' if self.full else 'diagonal'}{spans}"
        )


class TableReader:
    """Entries of the packed tables of a strain link, by name."""

    def __init__(self, shape: StrainShape, packed: Any) -> None:
        self._packed, self._start = packed, shape.table_starts

    def __call__(self, name: str, index: int = 0) -> Any:
        """Entry ``index`` of a table."""
        return self._packed[self._start[name] + index]
