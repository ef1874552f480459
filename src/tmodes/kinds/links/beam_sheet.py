"""The sheet of a beam, lowered to elements of a chain: rigid, one strain beam, or segments in a row."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

import numpy as np

from tmodes.frame import Placement
from tmodes.kinds.links.beam_data import BeamData, Functions, PieceSheet
from tmodes.kinds.links.beam_functions import MODULI
from tmodes.kinds.links.beam_pieces import Basis, BeamModel, BeamPiece, Piece
from tmodes.kinds.links.body import BodySheet
from tmodes.kinds.links.contract import Body
from tmodes.kinds.links.material import Material, find_material
from tmodes.kinds.links.rigid import RigidLink
from tmodes.kinds.links.rigid_beam import RigidBeam, rigid_body
from tmodes.kinds.links.section import Round, Tube
from tmodes.kinds.links.sheet import LINKS, MORE, BendingSheet, LoweredLink, Spot, moved_body, placed, sheet_body
from tmodes.kinds.noted.functions import array, floor, highest, isinf, number, rounded
from tmodes.kinds.schema.axes import bent_line
from tmodes.kinds.schema.quantity import Issue

if TYPE_CHECKING:
    from tmodes.kinds.links.segment import Segment

__all__ = ["MOST_USEFUL_SEGMENTS", "BeamSheet", "Functions", "PieceSheet"]

MOST_USEFUL_SEGMENTS = 3
"""Number of segments beyond which the model `segments` is used for what it cannot do."""

POISSON = (-1.0, 0.5)
"""Range of the Poisson ratio of an isotropic material [-]."""


@LINKS.register
class BeamSheet(BeamData):
    """A beam along x of its root frame."""

    @property
    def line_length(self) -> float:
        """Length of the unloaded line [m]."""
        return self.length

    @property
    def coordinate_count(self) -> int:
        """Number of coordinates as far as the sheet's counts say."""
        if self.model is BeamModel.RIGID:
            return 0
        if self.model is BeamModel.SEGMENTS:
            return 2 * (self.segments or 0)
        return sum(self.functions.model_dump().values()) if self.functions else 0

    @property
    def description(self) -> str:
        """The model with the number of segments."""
        return f"segments ({self.segments})" if self.model is BeamModel.SEGMENTS else str(self.model)

    @property
    def yield_strengths(self) -> tuple[float, ...]:
        """Yield strengths of its materials, as far as they are known [Pa]."""
        choices = [choice for choice in (self.material, *(piece.material for piece in self.pieces)) if choice]
        materials = [find_material(choice) if isinstance(choice, str) else choice for choice in choices]
        return tuple(material.yield_strength for material in materials if material.yield_strength is not None)

    @property
    def is_round(self) -> bool:
        """Whether its first section is a rod or a tube."""
        return isinstance(self.section or self.pieces[0].section, (Round, Tube))

    def station_issues(self, bodies: Sequence[BodySheet]) -> Iterator[Issue]:
        """Segments carry bodies at their ends only."""
        if self.model is not BeamModel.SEGMENTS or self.segments is None:
            return
        for index, body in enumerate(bodies):
            if abs(body.station * self.segments - rounded(body.station * self.segments)) > 1e-9:
                expected = f"an end of one of the {self.segments} segments: a multiple of 1/{self.segments}"
                hint = "move the body, change `segments`, or take the model `strain`"
                yield Issue(f"bodies.{index}.at", f"{body.station:g}", expected, hint)

    def notices(self) -> Iterator[str]:
        """A model that is not what its name promises, and moduli that no isotropic material has."""
        if self.model is BeamModel.STRAIN and self.functions and not any(dict(self.functions).values()):
            yield " is rigid: its model `strain` has 0 functions in every direction"
        if self.model is BeamModel.SEGMENTS and (self.segments or 0) > MOST_USEFUL_SEGMENTS:
            info = "more segments do not converge (docs/links.md); was the model `strain` meant?"
            yield f" has {self.segments} segments, more than {MOST_USEFUL_SEGMENTS}: {info}"
        low, high = POISSON
        for material in (self.material, *(piece.material for piece in self.pieces)):
            if isinstance(material, Material):
                ratio = material.young / (2 * material.shear) - 1
                if not low <= ratio <= high:
                    info = f"young/(2 shear) - 1 = {ratio:.3g}, a Poisson ratio outside {low:g} to {high:g}"
                    yield f".material has {info}; right for a laminate only: are both moduli in Pa?"

    def finer(self, more: int = MORE) -> BendingSheet:
        """A strain link with more functions, also than a sheet may ask for: to judge what it asks for."""
        if self.model is not BeamModel.STRAIN or self.functions is None:
            return self
        given = self.functions.model_dump()
        counts = {name: count + more for name, count in given.items() if count}
        return self.model_copy(update={"functions": self.functions.model_copy(update=counts), "points": 0})

    def variant(self, model: str, count: int | None) -> BendingSheet | None:
        """The beam with another model; directions that do not bend stay so."""
        if model not in [*BeamModel]:
            return super().variant(model, count)
        given = self.functions or Functions(bend_y=1, bend_z=1)
        changes: dict[str, object] = {"model": BeamModel(model), "points": 0, "functions": given}
        if changes["model"] is BeamModel.SEGMENTS:
            changes |= {"segments": count, "rest_curvature": (0.0, 0.0, 0.0)}
        elif changes["model"] is BeamModel.STRAIN:
            bends = {name: count for name in ("bend_y", "bend_z") if getattr(given, name)}
            changes["functions"] = given.model_copy(update=bends)
        return self.model_copy(update=changes)

    def element_stations(self, element: int, stations: object) -> object:
        """Places along all segments."""
        return (element + stations) / (self.segments or 1)  # pyright: ignore[reportOperatorIssue]

    def lowered(self, bodies: Sequence[BodySheet]) -> LoweredLink:
        """One rigid link, one strain beam, or segments in a row."""
        if self.model is BeamModel.RIGID or not _bends(self):
            return _rigid(self, bodies)
        return _segments(self, bodies) if self.model is BeamModel.SEGMENTS else _strain(self, bodies)


def _rigid(beam: BeamData, bodies: Sequence[BodySheet]) -> LoweredLink:
    """The beam as one rigid body; its places are where the unloaded line is."""

    def spot(s: float) -> Spot:
        return Spot(0, 1.0, _at_rest(beam, s))

    own = moved_body(rigid_body(beam), placed(beam.root_mount))
    carried = [sheet_body(body, _at_rest(beam, body.station)) for body in bodies]
    stations = tuple((body.station, own) for body, own in zip(bodies, carried, strict=True))
    along = RigidBeam(beam, placed(beam.root_mount), stations)
    tip = _at_rest(beam, 1.0)
    return LoweredLink((RigidLink((own, *carried)),), tip, tip, spot, rigid=RigidLink(beam=along))


def _strain(beam: BeamData, bodies: Sequence[BodySheet]) -> LoweredLink:
    """One strain beam. ``auto`` is ``legendre``: only these functions can carry a moment at the tip, and whoever asks
    for the stiffness of a robot puts one on every tip.
    """  # noqa: D205
    from tmodes.kinds.links.strain import Beam

    functions, pieces = _finite_functions(beam), beam.section_pieces()
    shape = Beam(
        length=beam.length,
        pieces=tuple(_chain_piece(piece, beam.turning_axes) for piece in pieces),
        **functions.model_dump(),
        basis=str(Basis.LEGENDRE if beam.basis is Basis.AUTO else beam.basis),
        points=beam.points,
        damping_time=beam.damping_time or 0.0,
        rest_curvature=np.array(beam.rest_curvature),
        bodies=tuple((body.station, sheet_body(body, _mount(beam, body.station))) for body in bodies),
        outer=(_largest(pieces, "outer_y"), _largest(pieces, "outer_z")),
        young=_largest(pieces, "young"),
        shear=_largest(pieces, "shear"),
    )
    root = placed(beam.root_mount)
    return LoweredLink(
        (shape,), placed(beam.tip_mount), _at_rest(beam, 1.0), lambda s: Spot(0, s, _mount(beam, s)), root
    )


def _segments(beam: BeamData, bodies: Sequence[BodySheet]) -> LoweredLink:
    """The paper's modes in a row, joined rigidly; a body at the root needs a rigid link before them."""
    count = beam.segments or 1
    links = []
    for k in range(count):
        own = [body for body in bodies if body.station > 0 and rounded(body.station * count) == k + 1]
        links.append(_segment(beam, k, tuple(sheet_body(body, _mount(beam, body.station)) for body in own)))

    def spot(s: float) -> Spot:
        k = min(floor(s * count), count - 1)
        return Spot(k, s * count - k, _mount(beam, s))

    at_root = tuple(sheet_body(body, Placement()) for body in bodies if body.station == 0)
    tip, root = placed(beam.tip_mount), placed(beam.root_mount)
    return LoweredLink(tuple(links), tip, _at_rest(beam, 1.0), spot, root, at_root)


def _segment(beam: BeamData, index: int, bodies: tuple[Body, ...]) -> Segment:
    """Segment ``index`` with the section at its middle: 3 EI/l^3 against its tip, and the mass of Eq. (13) there."""
    from tmodes.kinds.links.segment import Segment

    count = beam.segments or 1
    length, middle = beam.length / count, (index + 0.5) / count
    bend_y, bend_z, mass = (_between(beam.section_pieces(), name, middle) for name in ("bend_y", "bend_z", "mass"))
    tip_mass = 33 / 140 * mass * length
    inertia = np.diag([0.0, 1.0, 1.0]) * tip_mass * (length / 2) ** 2
    functions, damping_time = _finite_functions(beam), beam.damping_time or 0.0
    stiffness_y, stiffness_z = 3 * bend_y / length**3, 3 * bend_z / length**3
    return Segment(
        length=length,
        stiffness_y=stiffness_y,
        stiffness_z=stiffness_z,
        damping_y=damping_time * stiffness_y if functions.bend_y else 0.0,
        damping_z=damping_time * stiffness_z if functions.bend_z else 0.0,
        bend_y=bool(functions.bend_y),
        bend_z=bool(functions.bend_z),
        bodies=(Body(tip_mass, np.zeros(3), inertia), *bodies),
        mass=mass * length,
        lever=count - 1 - index,
    )


def _bends(beam: BeamData) -> bool:
    functions = _finite_functions(beam)
    names = ("bend_y", "bend_z") if beam.model is BeamModel.SEGMENTS else MODULI
    return any(getattr(functions, name) for name in names)


def _finite_functions(beam: BeamData) -> Functions:
    """The functions of the directions that are not rigid; segments bend both ways by default."""
    wanted, pieces = beam.functions or Functions(bend_y=1, bend_z=1), beam.section_pieces()
    rigid = {name: 0 for name in ("bend_y", "bend_z") if any(map(isinf, _ends(pieces, name)))}
    return wanted.model_copy(update=rigid)


def _mount(beam: BeamData, s: float) -> Placement:
    """The frame of things at a station in its section's axes: that of the tip mount at the tip."""
    return placed(beam.tip_mount) if s == 1 else Placement()


def _at_rest(beam: BeamData, s: float) -> Placement:
    """The frame of things at a station, of the unloaded line, in the link's frame."""
    return placed(beam.root_mount) @ Placement(*bent_line(beam.rest_curvature, s * beam.length)) @ _mount(beam, s)


def _chain_piece(piece: Piece, counted: str) -> BeamPiece:
    ends = {name: (getattr(piece.start, name), getattr(piece.stop, name)) for name in piece.start._fields}
    x, y, z = (ends[f"inertia_{axis}"] if axis in counted else (0.0, 0.0) for axis in "xyz")
    own = {name: ends[name] for name in (*MODULI.values(), "mass", "across_y", "across_z")}
    return BeamPiece(end=piece.end, inertia=(x, y, z), **own)


def _ends(pieces: list[Piece], name: str) -> list[float]:
    return [getattr(numbers, name) for piece in pieces for numbers in (piece.start, piece.stop)]


def _largest(pieces: list[Piece], name: str) -> float:
    return number(highest(array(_ends(pieces, name))))


def _between(pieces: list[Piece], name: str, s: float) -> float:
    """A number of the section at s."""
    start = 0.0
    for piece in pieces:
        if s <= piece.end or piece is pieces[-1]:
            return piece.at(name, (s - start) / (piece.end - start))
        start = piece.end
    return 0.0
