"""Cross-sections: drawn by their dimensions, or given by their stiffnesses.

The beam runs along x; a width lies along y, a height along z.
"""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator
from typing import Annotated, Any, Literal

from pydantic import Discriminator, Field, Tag

from tmodes.errors import InputError
from tmodes.kinds.links.material import Material
from tmodes.kinds.links.section_given import Geometry, GivenSection, SectionNumbers
from tmodes.kinds.links.section_shapes import (
    box_peak,
    box_shear,
    i_beam_peaks,
    i_beam_shear,
    i_beam_torsion,
    rectangle_shear,
    rectangle_torsion,
    round_shear,
    thin_box_torsion,
    tube_peak,
    tube_shear,
)
from tmodes.kinds.noted.functions import isinf, minimum, number
from tmodes.kinds.schema.quantity import DataSheet, Issue, positive

__all__ = [
    "SHAPES", "Box", "DrawnSection", "GivenSection", "IBeam", "Round", "Section", "SectionNumbers", "Tube",
    "between",
]  # fmt: skip


def _size(symbol: str, meaning: str, **more: Any) -> Any:
    return positive("m", symbol, meaning, smallest=1e-6, at_most=100.0, plausible=(1e-4, 2.0), **more)


class DrawnSection(DataSheet, ABC):
    """A section of one material, given by its dimensions."""

    @abstractmethod
    def geometry(self) -> Geometry:
        """Areas and second moments, without the material."""

    def properties(self, material: Material) -> SectionNumbers:
        """Stiffness, mass and inertia per length in this material."""
        return self.geometry().made_of(material)


class Round(DrawnSection):
    """A solid round bar."""

    shape: Literal["round"] = Field(description="which shape")
    diameter: float = _size("d", "diameter")

    def geometry(self) -> Geometry:
        """Exact: J = 2 I = pi d^4/32."""
        moment, radius = math.pi * self.diameter**4 / 64, self.diameter / 2
        peak = tube_peak(radius, 0.0)
        return Geometry(
            math.pi * radius**2, moment, moment, 2 * moment, radius, radius, (peak, peak), _both(round_shear)
        )


class Tube(DrawnSection):
    """A round tube."""

    shape: Literal["tube"] = Field(description="which shape")
    outer_diameter: float = _size("D", "outer diameter")
    thickness: float = _size("t", "thickness of the wall")

    def geometry(self) -> Geometry:
        """Exact: J = 2 I = pi (D^4 - d^4)/32, written by the wall so that a thin one keeps its digits."""
        radius, middle = self.outer_diameter / 2, (self.outer_diameter - self.thickness) / 2
        area = 2 * math.pi * middle * self.thickness
        moment = area * (middle**2 + self.thickness**2 / 4) / 2
        inner = 1 - self.thickness / radius
        peak = tube_peak(radius, inner * radius)
        return Geometry(
            area, moment, moment, 2 * moment, radius, radius, (peak, peak), _both(lambda nu: tube_shear(nu, inner))
        )

    def _issues(self) -> Iterator[Issue]:
        if self.thickness >= self.outer_diameter / 2:
            most = f"less than half the outer_diameter, {self.outer_diameter / 2:g} [m]"
            yield Issue("thickness", f"{self.thickness:g}", most, "for a solid bar write shape: round and its diameter")


class Box(DrawnSection):
    """A rectangle: solid, or hollow where the thickness of its walls is given."""

    shape: Literal["box"] = Field(description="which shape")
    width: float = _size("b", "width, along y")
    height: float = _size("h", "height, along z")
    thickness: float | None = _size("t", "thickness of the wall, the same all round; none: solid", default=None)
    flange_thickness: float | None = _size("tf", "of the walls along the width, with web_thickness", default=None)
    web_thickness: float | None = _size("tw", "of the walls along the height, with flange_thickness", default=None)

    @property
    def walls(self) -> tuple[float, float] | None:
        """Thickness [m] of flanges (along the width) and webs (along the height); None of a solid box."""
        if self.flange_thickness is not None and self.web_thickness is not None:
            return self.flange_thickness, self.web_thickness
        return None if self.thickness is None else (self.thickness, self.thickness)

    def geometry(self) -> Geometry:
        """Exact but for the torsion of the hollow box: Bredt, for thin walls."""
        width, height, walls = self.width, self.height, self.walls
        outer = Geometry(
            width * height,
            width * height**3 / 12,
            height * width**3 / 12,
            0.0,
            width / 2,
            height / 2,
            (box_peak(height, width, walls and (walls[1], walls[0])), box_peak(width, height, walls)),
            _both(rectangle_shear),
        )
        if walls is None:
            return outer._replace(torsion=rectangle_torsion(width, height))
        flange, web = walls
        across, up = width - 2 * web, height - 2 * flange
        return outer._replace(
            area=outer.area - across * up,
            about_y=outer.about_y - across * up**3 / 12,
            about_z=outer.about_z - up * across**3 / 12,
            torsion=thin_box_torsion(width, height, flange, web),
            shear_coefficients=lambda nu: (
                box_shear(nu, height - flange, width - web, web / flange),
                box_shear(nu, width - web, height - flange, flange / web),
            ),
        )

    def _issues(self) -> Iterator[Issue]:
        pair = {"flange_thickness": self.flange_thickness, "web_thickness": self.web_thickness}
        for name, other in (("flange_thickness", "web_thickness"), ("web_thickness", "flange_thickness")):
            if pair[name] is None and pair[other] is not None:
                hint = f"add `{name}`, or write `thickness` where all walls are the same"
                yield Issue(name, "nothing", f"a thickness next to `{other}`", hint)
        if self.thickness is not None and any(pair.values()):
            yield Issue("thickness", "one next to those of flanges and webs", "left out", "remove `thickness`")
        sides = {
            "thickness": number(minimum(self.width, self.height)),
            "flange_thickness": self.height,
            "web_thickness": self.width,
        }
        for name, side in sides.items():
            wall = getattr(self, name)
            if wall is not None and wall >= side / 2:
                most = f"less than half the {'smaller side' if name == 'thickness' else 'side'}, {side / 2:g} [m]"
                yield Issue(name, f"{wall:g}", most, "for a solid bar leave the thickness out")


class IBeam(DrawnSection):
    """An I (double T): two flanges along y, a web along z."""

    shape: Literal["i_beam"] = Field(description="which shape")
    width: float = _size("b", "width of the flanges, along y")
    height: float = _size("h", "height over both flanges, along z")
    flange_thickness: float = _size("tf", "thickness of a flange")
    web_thickness: float = _size("tw", "thickness of the web")

    def geometry(self) -> Geometry:
        """Exact for straight flanges without fillets, but for torsion: sum of b t^3/3."""
        web, side = self.height - 2 * self.flange_thickness, self.width - self.web_thickness
        return Geometry(
            area=self.width * self.height - side * web,
            about_y=(self.width * self.height**3 - side * web**3) / 12,
            about_z=(2 * self.flange_thickness * self.width**3 + web * self.web_thickness**3) / 12,
            torsion=i_beam_torsion(self.width, self.height, self.flange_thickness, self.web_thickness),
            outer_y=self.width / 2,
            outer_z=self.height / 2,
            shear_peaks=i_beam_peaks(self.width, self.height, self.flange_thickness, self.web_thickness),
            shear_coefficients=lambda nu: i_beam_shear(
                nu, self.width, self.height - self.flange_thickness, self.flange_thickness, self.web_thickness
            ),
        )

    def _issues(self) -> Iterator[Issue]:
        if self.flange_thickness >= self.height / 2:
            most = f"less than half the height, {self.height / 2:g} [m]"
            yield Issue("flange_thickness", f"{self.flange_thickness:g}", most, "thin the flanges, or raise the height")
        if self.web_thickness >= self.width:
            most = f"less than the width, {self.width:g} [m]"
            yield Issue("web_thickness", f"{self.web_thickness:g}", most, "for a rectangle write shape: box")


def _both(coefficient: Callable[[float], float]) -> Callable[[float], tuple[float, float]]:
    """The same shear coefficient along both axes."""
    return lambda nu: (coefficient(nu), coefficient(nu))


SHAPES: dict[str, type[DrawnSection] | type[GivenSection]] = {
    "round": Round,
    "tube": Tube,
    "box": Box,
    "i_beam": IBeam,
    "given": GivenSection,
}
"""Each shape's data sheet by its name; a section that names no shape is ``given``."""


def _shape(value: Any) -> str:
    named = value.get("shape", "given") if isinstance(value, dict) else getattr(value, "shape", "given")
    return named if isinstance(named, str) else "none"


Section = Annotated[
    Annotated[Round, Tag("round")]
    | Annotated[Tube, Tag("tube")]
    | Annotated[Box, Tag("box")]
    | Annotated[IBeam, Tag("i_beam")]
    | Annotated[GivenSection, Tag("given")],
    Discriminator(_shape),
]
"""A field of this type takes any shape; its ``shape`` says which, and is a step of the path in pydantic's errors."""


def between(root: Section, tip: Section, share: float) -> Section:
    """The section at ``share`` (0 root, 1 tip) of the way between two of the same shape, linear in every dimension.

    Raises :class:`tmodes.errors.InputError` when the shapes differ, or one is solid and the other hollow, or one rigid.
    """
    first, last = ({name: value for name, value in end if value is not None} for end in (root, tip))
    if type(root) is not type(tip) or first.keys() != last.keys():
        ends = [f"{end.shape} ({', '.join(names)})" for end, names in ((root, first), (tip, last))]
        hint = "draw both ends in the same shape, or write the beam as pieces"
        raise InputError("taper", f"{ends[1]} at the tip of {ends[0]}", "the same shape at both ends", hint)
    return root.model_copy(update={name: _mixed(first[name], last[name], share) for name in first})


def _mixed(first: Any, last: Any, share: float) -> Any:
    if first == last:
        return first
    if isinstance(first, tuple):
        return tuple(_mixed(*both, share) for both in zip(first, last, strict=True))
    if isinf(first) or isinf(last):
        got, hint = "a stiffness that is infinite at one end", "make both ends elastic or both .inf, or write pieces"
        raise InputError("taper", got, "finite or infinite at both ends", hint)
    return first + share * (last - first)
