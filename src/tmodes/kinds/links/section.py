"""The library of cross-sections: drawn shapes, or stiffnesses as given."""

from __future__ import annotations

import math
from typing import Annotated, Any

from pydantic import Discriminator, Tag

from tmodes.errors import InputError
from tmodes.kinds.links.section_given import GivenSection, SectionNumbers
from tmodes.kinds.links.section_shapes import Box, DrawnSection, IBeam, Round, Tube

__all__ = [
    "SHAPES",
    "Box",
    "DrawnSection",
    "GivenSection",
    "IBeam",
    "Round",
    "Section",
    "SectionNumbers",
    "Tube",
    "between",
]

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
    first, last = root.model_dump(exclude_none=True), tip.model_dump(exclude_none=True)
    if type(root) is not type(tip) or first.keys() != last.keys():
        ends = [f"{end.shape} ({', '.join(names)})" for end, names in ((root, first), (tip, last))]
        hint = "draw both ends in the same shape, or write the beam as pieces"
        raise InputError("taper", f"{ends[1]} at the tip of {ends[0]}", "the same shape at both ends", hint)
    return type(root)(**{name: _mixed(first[name], last[name], share) for name in first})


def _mixed(first: Any, last: Any, share: float) -> Any:
    if first == last:
        return first
    if isinstance(first, tuple):
        return tuple(_mixed(*both, share) for both in zip(first, last, strict=True))
    if math.isinf(first) or math.isinf(last):
        got, hint = f"a stiffness from {first:g} to {last:g}", "make both ends elastic or both .inf, or write pieces"
        raise InputError("taper", got, "both ends elastic, or both rigid", hint)
    return first + share * (last - first)
