"""The link that bends: its length, its sections, and which model of it is computed."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import chain
from typing import Annotated, Any, ClassVar

from pydantic import Discriminator, Field, Tag, field_validator

from tmodes.errors import InputError
from tmodes.kinds.links.beam_pieces import Basis, BeamModel, Piece, RotaryInertia, tapered_pieces, uniform_piece
from tmodes.kinds.links.material import Material, find_material
from tmodes.kinds.links.section import GivenSection, Section, between
from tmodes.kinds.links.sheet import BendingSheet
from tmodes.kinds.noted.functions import isclose, isinf
from tmodes.kinds.schema.frames import Origin, Vector, list_of_numbers
from tmodes.kinds.schema.quantity import DataSheet, Issue, dissipation, positive, quantity, refuse

__all__ = ["MOST_FUNCTIONS", "MOST_SEGMENTS", "Basis", "BeamData", "BeamModel", "Functions", "RotaryInertia"]

MOST_FUNCTIONS = 12
"""Largest number of functions of a direction."""

MOST_SEGMENTS = 200
MOST_POINTS = 24
MOST_PIECES = 50
MOST_SECTIONS = 80
"""Points along a link: each is in the link's compiled code, whose size grows with them."""

MaterialChoice = Annotated[
    Annotated[str, Tag("name")] | Annotated[Material, Tag("numbers")],
    Discriminator(lambda value: "name" if isinstance(value, str) else "numbers"),
]


def _count(symbol: str, meaning: str) -> int:
    return quantity("-", symbol, meaning, default=0, at_least=0, at_most=MOST_FUNCTIONS)


class Functions(DataSheet):
    """How many functions a strain link has in each direction."""

    twist: int = _count("n_x", "functions of twist")
    bend_y: int = _count("n_y", "functions of bending about y")
    bend_z: int = _count("n_z", "functions of bending about z")
    stretch: int = _count("n_a", "functions of stretch")
    shear_y: int = _count("n_sy", "functions of shear along y, which goes with bending about z")
    shear_z: int = _count("n_sz", "functions of shear along z, which goes with bending about y")


_OUT_OF_PLANE = {"y": ("twist", "bend_z", "shear_y"), "z": ("twist", "bend_y", "shear_z")}
"""Functions that leave the plane to which an axis of the section is normal."""

_GIVEN = {
    "twist": ("torsion", "torsional_stiffness"),
    "stretch": ("axial", "axial_stiffness"),
    "shear_y": ("shear_y", "shear_stiffness"),
    "shear_z": ("shear_z", "shear_stiffness"),
}
"""Directions that a section may be rigid in: its number, and the key that gives it."""


class PieceSheet(DataSheet):
    """A piece of a stepped beam."""

    end: float = positive("m", "x", "where it ends, from the beam's root", plausible=(1e-4, 50.0))
    section: Section
    material: MaterialChoice | None = Field(default=None, description="its material; none: that of the beam")


class Taper(DataSheet):
    """The section at the tip; every dimension is linear between."""

    section: Section


class BeamData(BendingSheet):
    """A beam along x of its root frame: its fields, and how they fit together."""

    words: ClassVar[tuple[str, ...]] = tuple(BeamModel)

    model: BeamModel = Field(strict=False, description="strain, segments or rigid")
    functions: Functions | None = Field(default=None, description="functions of each direction (strain)")
    segments: int | None = quantity(
        "-", "n", "number of segments (segments)", default=None, at_least=1, at_most=MOST_SEGMENTS
    )
    basis: Basis = Field(default=Basis.AUTO, strict=False, description="kind of functions (strain)")
    points: int = quantity(
        "-", "g", "Gauss points of a piece, 0: automatic (strain)", default=0, at_least=0, at_most=MOST_POINTS
    )
    length: float = positive("m", "L", "length", plausible=(1e-3, 50.0))
    damping_time: float | None = dissipation("s", "eta", "Kelvin-Voigt damping over stiffness", default=None, most=0.1)
    section: Section | None = None
    material: MaterialChoice | None = Field(default=None, description="material by name, or its numbers")
    taper: Taper | None = None
    pieces: tuple[PieceSheet, ...] = Field(
        default=(), strict=False, max_length=MOST_PIECES, description="pieces of different sections, from root to tip"
    )
    rotary_inertia: RotaryInertia = Field(
        default=RotaryInertia.AUTO, strict=False, description="which rotary inertia of the sections counts"
    )
    rest_curvature: Vector = list_of_numbers(
        "1/m", "kappa_0", "twist and curvature about y and z of the unloaded line", default=(0.0, 0.0, 0.0)
    )
    root_mount: Origin | None = Field(default=None, description="the beam's root in the link's frame; none: there")
    tip_mount: Origin | None = Field(default=None, description="the link's tip frame in its end section; none: there")

    @property
    def modal_damping(self) -> float | None:
        """The damping time of a straight beam that bends in both planes."""
        both = self.functions is None or (self.functions.bend_y and self.functions.bend_z)
        return (self.damping_time or 0.0) if both and not any(self.rest_curvature) else None

    def bending_about(self, axis: str) -> BeamData:
        """Its functions of bending about the axis, of the shear that goes with it, and of stretch."""
        given, others = self.functions or Functions(bend_y=1, bend_z=1), _OUT_OF_PLANE[axis]
        return self.model_copy(update={"functions": given.model_copy(update=dict.fromkeys(others, 0))})

    @field_validator("functions", mode="before")
    @classmethod
    def _one_number_bends_both_ways(cls, value: Any) -> Any:
        if isinstance(value, int) and not isinstance(value, bool):
            return {"bend_y": value, "bend_z": value}
        if isinstance(value, float):
            hint = "write `functions: 3`, or a group with twist, bend_y, bend_z, stretch, shear_y and shear_z"
            refuse([Issue("", f"{value:g}", "a whole number, that of both bending directions, or a group", hint)])
        return value

    def _issues(self) -> Iterator[Issue]:
        yield from (
            [*self._model_issues()]
            or [*self._section_issues()]
            or chain(self._order_issues(), self._stiffness_issues())
        )

    def _model_issues(self) -> Iterator[Issue]:
        needs = {BeamModel.STRAIN: "functions", BeamModel.SEGMENTS: "segments"}
        if (key := needs.get(self.model)) and getattr(self, key) is None:
            yield Issue(key, "nothing", f"the number of {key} of the model `{self.model}`", f"add `{key}: 3`")
        if self.damping_time is None and self.model is not BeamModel.RIGID:
            hint = "add `damping_time: ...`, 0 for no damping"
            yield Issue("damping_time", "nothing", "a time [s], because the beam bends", hint)
        if self.model is BeamModel.SEGMENTS and any(self.rest_curvature):
            hint = "take the model `strain`, or leave the curvature out"
            yield Issue("rest_curvature", "a curvature", "left out: segments are straight", hint)
        most = max((self.functions or Functions()).model_dump().values()) + 2
        if self.model is BeamModel.STRAIN and len(self.pieces) * most > MOST_SECTIONS:
            got = f"{len(self.pieces)} pieces with {most - 2} functions, {len(self.pieces) * most} points"
            hint = "join pieces that are nearly alike, take a taper, or fewer functions"
            yield Issue("pieces", got, f"at most {MOST_SECTIONS} points along a link", hint)

    def _section_issues(self) -> Iterator[Issue]:
        if (self.section is None) == (not self.pieces):
            got = "nothing" if self.section is None else "a section next to `pieces`"
            yield Issue("section", got, "one of `section` and `pieces`", "write the section, or a list of pieces")
        if self.taper is not None and self.section is None:
            yield Issue("taper", "a taper without `section`", "a section at the root", "add `section`")
        if isinstance(self.section, GivenSection) and self.material is not None:
            hint = "remove `material`, or draw the section"
            yield Issue("material", "a material next to given stiffnesses", "one of the two", hint)
        yield from self._material_issues("section", self.section, None)
        for index, piece in enumerate(self.pieces):
            yield from self._material_issues(f"pieces.{index}.section", piece.section, piece.material)
        if self.taper is not None and self.section is not None:
            try:
                between(self.section, self.taper.section, 0.5)
            except InputError as error:
                yield Issue("taper", error.got, error.expected, error.hint)

    def _material_issues(self, path: str, section: Section | None, own: str | Material | None) -> Iterator[Issue]:
        material = own if own is not None else self.material
        prefix = path.removesuffix("section") if own is not None else ""
        if isinstance(material, str):
            try:
                find_material(material)
            except InputError as error:
                yield Issue(f"{prefix}material", error.got, error.expected, error.hint)
        if isinstance(section, GivenSection) and own is not None:
            hint = "remove `material`, or draw the section"
            yield Issue(f"{prefix}material", "a material next to given stiffnesses", "one of the two", hint)
        elif section is not None and not isinstance(section, GivenSection) and material is None:
            hint = "add `material: steel`, or its young, shear and density"
            yield Issue("material", "nothing", f"the material of `{path}`", hint)

    def _order_issues(self) -> Iterator[Issue]:
        ends = [piece.end for piece in self.pieces]
        for index, (earlier, later) in enumerate(zip([0.0, *ends], ends, strict=False)):
            if later <= earlier:
                yield Issue(
                    f"pieces.{index}.end", repr(later), f"more than {earlier!r} [m]", "order them from root to tip"
                )
        if ends and not isclose(ends[-1], self.length, rel_tol=1e-9):
            which, hint = f"pieces.{len(ends) - 1}.end", "end the last piece at the beam's length"
            yield Issue(which, repr(ends[-1]), f"the length {self.length!r} [m]", hint)

    def _stiffness_issues(self) -> Iterator[Issue]:
        if self.model is not BeamModel.STRAIN or self.functions is None:
            return
        ends = [numbers for piece in self.section_pieces() for numbers in (piece.start, piece.stop)]
        for name in ("bend_y", "bend_z"):
            rigid = {isinf(getattr(numbers, name)) for numbers in ends}
            if getattr(self.functions, name) and len(rigid) == 2:
                hint = "give every piece a finite stiffness, or make the rigid part a link of its own"
                yield Issue("pieces", f"{name} rigid in some pieces only", "finite, or rigid, in all pieces", hint)
        for name, (stiffness, info) in _GIVEN.items():
            if getattr(self.functions, name) and any(isinf(getattr(numbers, stiffness)) for numbers in ends):
                got, hint = f"{getattr(self.functions, name)} with infinite {info}", f"write 0, or give `{info}`"
                yield Issue(f"functions.{name}", got, f"0 where {info} is infinite", hint)
        if self.functions.twist and not self._turns("x"):
            yield self._inertia_issue("twist", 0)

    def massless_issues(self) -> Iterator[Issue]:
        """Functions of shear, but the first, of a link that bends with it and whose sections do not turn.

        Bending and shear that leave the line where it is move no mass but by the rotary inertia of the sections.
        """
        functions = self.functions if self.model is BeamModel.STRAIN else None
        for name, axis, partner in (("shear_y", "z", "bend_z"), ("shear_z", "y", "bend_y")):
            if functions and getattr(functions, name) > 1 and getattr(functions, partner) and not self._turns(axis):
                yield self._inertia_issue(name, 1)

    def _turns(self, axis: str) -> bool:
        """Whether all sections have a rotary inertia about an axis that counts."""
        ends = (numbers for piece in self.section_pieces() for numbers in (piece.start, piece.stop))
        return axis in self.turning_axes and all(getattr(numbers, f"inertia_{axis}") > 0 for numbers in ends)

    @property
    def turning_axes(self) -> str:
        """Axes about which the rotary inertia of the sections counts: none, ``x`` or ``xyz``."""
        sheared = self.functions is not None and (self.functions.shear_y or self.functions.shear_z)
        chosen = self.rotary_inertia
        if chosen is RotaryInertia.AUTO:
            chosen = RotaryInertia.FULL if sheared else RotaryInertia.TWIST
        return {RotaryInertia.NONE: "", RotaryInertia.TWIST: "x", RotaryInertia.FULL: "xyz"}[chosen]

    def _inertia_issue(self, name: str, most: int) -> Issue:
        """More functions than ``most`` that no inertia resists."""
        axis, wanted = ("x", "twist") if name == "twist" else ("yz", "full")
        counts = axis[0] in self.turning_axes
        hint = "give `polar_inertia_per_length`" if counts else f"write `rotary_inertia: {wanted}`"
        expected = f"{most}, or an inertia that resists the {name.partition('_')[0]}"
        return Issue(f"functions.{name}", f"{getattr(self.functions, name)} without rotary inertia", expected, hint)

    def section_pieces(self) -> list[Piece]:
        """Its sections from root to tip, as pieces over the share of its length."""
        if self.section is None:
            return [
                uniform_piece(piece.end / self.length, _numbers(piece.section, piece.material or self.material))
                for piece in self.pieces
            ]
        if self.taper is None:
            return [uniform_piece(1.0, _numbers(self.section, self.material))]
        ends = (self.section, self.taper.section, _material(self.material))
        return list(tapered_pieces(*ends))  # pyright: ignore[reportArgumentType]  # frozen sheets have a hash


def _material(choice: str | Material | None) -> Material | None:
    return find_material(choice) if isinstance(choice, str) else choice


def _numbers(section: Section, choice: str | Material | None) -> Any:
    if isinstance(section, GivenSection):
        return section.properties(None)
    material = _material(choice)
    if material is None:
        raise InputError("material", "nothing", "the material of the section", "add `material: steel`")
    return section.properties(material)
