"""The sheet of the link kind ``modes``."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, ClassVar, Literal

import numpy as np
from pydantic import Field

from tmodes.frame import Placement
from tmodes.kinds.links.beam_pieces import BeamModel, Piece, uniform_piece
from tmodes.kinds.links.beam_sheet import BeamSheet, Functions, PieceSheet
from tmodes.kinds.links.body import BodySheet
from tmodes.kinds.links.contract import Body
from tmodes.kinds.links.modes import ModesLink, RigidModesLink
from tmodes.kinds.links.modes_sheet import Mode
from tmodes.kinds.links.section import GivenSection
from tmodes.kinds.links.sheet import LINKS, BendingSheet, LoweredLink, Spot, moved_body, placed, sheet_body, straight
from tmodes.kinds.noted.functions import isfinite, number
from tmodes.kinds.schema.frames import Origin

__all__ = ["MOST_MODES", "ModesSheet"]

MOST_MODES = 12
"""Largest number of modes of a link."""


@LINKS.register
class ModesSheet(BendingSheet):
    """Modes from root to tip, as in the 2010 paper: their angles add up, their masses stand at their ends."""

    words: ClassVar[tuple[str, ...]] = ("modes",)

    model: Literal["modes"] = Field(description="modes")
    modes: tuple[Mode, ...] = Field(
        strict=False, min_length=1, max_length=MOST_MODES, description="the modes from root to tip"
    )
    root_mount: Origin | None = Field(default=None, description="the beam's root in the link's frame; none: there")
    tip_mount: Origin | None = Field(default=None, description="the link's tip frame in its end section; none: there")

    @property
    def line_length(self) -> float:
        """Sum of the modes' lengths [m]."""
        return number(sum(mode.length for mode in self.modes))

    @property
    def coordinate_count(self) -> int:
        """An azimuth and an elevation of each mode that bends."""
        return 2 * sum(isfinite(mode.bending_stiffness) for mode in self.modes)

    @property
    def description(self) -> str:
        """The word with the number of modes."""
        return f"modes ({len(self.modes)})"

    @property
    def modal_damping(self) -> float:
        """The mean of the modes'."""
        return sum(mode.damping_time * mode.length for mode in self.modes) / self.line_length

    @property
    def _ends(self) -> list[float]:
        """Where each mode ends, as a share of the length."""
        return [number(end) for end in np.cumsum([mode.length for mode in self.modes]) / self.line_length]

    def section_pieces(self) -> list[Piece]:
        """One uniform piece for each mode."""
        return [
            uniform_piece(end, _section(mode).properties(None))
            for end, mode in zip(self._ends, self.modes, strict=True)
        ]

    def lowered(self, bodies: Sequence[BodySheet]) -> LoweredLink:
        """One link with all modes; where all are rigid, their masses stand in one rigid link."""
        rest = straight(self.root_mount, self.line_length) @ placed(self.tip_mount)
        if not self.coordinate_count:
            return self._rigid(bodies, rest)
        carried = tuple((one.station, sheet_body(one, self._mount(one.station))) for one in bodies if one.station > 0)
        at_root = tuple(sheet_body(one, Placement()) for one in bodies if one.station == 0)
        link = ModesLink(self.modes, carried)
        tip = placed(self.tip_mount)
        return LoweredLink((link,), tip, rest, lambda s: Spot(0, s, self._mount(s)), placed(self.root_mount), at_root)

    def _rigid(self, bodies: Sequence[BodySheet], rest: Placement) -> LoweredLink:
        masses = [
            moved_body(Body(mode.tip_mass, np.zeros(3), mode.tip_inertia * np.eye(3)), self._at_rest(end))
            for end, mode in zip(self._ends, self.modes, strict=True)
        ]
        whole = (*masses, *(sheet_body(one, self._at_rest(one.station)) for one in bodies))
        carried = tuple((one.station, sheet_body(one, self._mount(one.station))) for one in bodies)
        link = RigidModesLink(whole, modes=self.modes, carried=carried)
        return LoweredLink((link,), rest, rest, lambda s: Spot(0, 1.0, self._at_rest(s)), rigid=link)

    def element_stations(self, element: int, stations: Any) -> Any:
        """Places along all modes of places along one, whose line is drawn by itself."""
        start, end = [0.0, *self._ends][element : element + 2]
        return start + (end - start) * stations

    @classmethod
    def in_place_of(cls, other: BendingSheet, count: int | None) -> BendingSheet | None:
        """Equal modes of a straight link that bends alike in both planes; of one that is made of as many, itself."""
        if other.description == f"modes ({count})":
            return other
        pieces, time = other.section_pieces(), other.modal_damping
        alike = all(math.isclose(n.bend_y, n.bend_z, rel_tol=1e-9) and math.isfinite(n.bend_y)
                    for piece in pieces for n in (piece.start, piece.stop))  # fmt: skip
        if not (count and pieces and alike) or time is None:
            return None
        means = [_means(pieces, k / count, (k + 1) / count) for k in range(count)]
        modes = tuple(
            Mode(length=other.line_length / count, bending_stiffness=ei, mass_per_length=mass, damping_time=time)
            for ei, mass in means
        )
        return cls(model="modes", modes=modes, **other.mounts)

    def _mount(self, s: float) -> Placement:
        return placed(self.tip_mount) if s == 1 else Placement()

    def _at_rest(self, s: float) -> Placement:
        return straight(self.root_mount, s * self.line_length) @ self._mount(s)

    def variant(self, model: str, count: int | None) -> BendingSheet | None:
        """The link with its mass spread along it, as another model."""
        if model not in [*BeamModel]:
            return super().variant(model, count)
        if 0 < self.coordinate_count < 2 * len(self.modes):
            return None  # a beam that is rigid in some pieces only
        beam = BeamSheet(
            model=BeamModel.STRAIN,
            functions=Functions(bend_y=1, bend_z=1),
            length=self.line_length,
            damping_time=self.modal_damping,
            pieces=tuple(
                PieceSheet(end=end * self.line_length, section=_section(mode))
                for end, mode in zip(self._ends, self.modes, strict=True)
            ),
            root_mount=self.root_mount,
            tip_mount=self.tip_mount,
        )
        return beam.variant(model, count)


def _means(pieces: Sequence[Piece], start: float, end: float) -> tuple[float, float]:
    """Bending stiffness, by the mean compliance, and mean mass per length between two shares of a link."""
    nodes, weights = np.polynomial.legendre.leggauss(8)
    compliance = mass = begin = 0.0
    for piece in pieces:
        a, b = max(start, begin), min(end, piece.end)
        if b > a:
            share = ((a + b) / 2 + (b - a) / 2 * nodes - begin) / (piece.end - begin)
            share_of = (b - a) / 2 * weights / (end - start)
            compliance += float(np.sum(share_of / piece.at("bend_z", share)))
            mass += float(np.sum(share_of * piece.at("mass", share)))
        begin = piece.end
    return 1 / compliance, mass


def _section(mode: Mode) -> GivenSection:
    stiffness = mode.bending_stiffness
    return GivenSection.model_construct(bending_stiffness=(stiffness, stiffness), mass_per_length=mode.mass_per_length)
