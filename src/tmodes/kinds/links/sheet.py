"""The sheet of a link that bends: what a kind lets a person write, and the elements of a chain that follow from it."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, ClassVar, NamedTuple

import numpy as np

from tmodes.frame import Placement
from tmodes.kinds.links.beam_pieces import Piece
from tmodes.kinds.links.body import BodySheet
from tmodes.kinds.links.contract import Body, Link
from tmodes.kinds.links.rigid import RigidLink
from tmodes.kinds.registry import Registry, UnknownKindError
from tmodes.kinds.schema.frames import Origin
from tmodes.kinds.schema.quantity import DataSheet, Issue, refuse

__all__ = ["LINKS", "BendingSheet", "LoweredLink", "Spot", "moved_body", "placed", "sheet_body", "straight"]

MORE = 4
"""Functions that a finer link has more, of each direction that has any: what four change is 0.6 of the error or more in
99 % of random beams with steps and bodies; what two change is so in 77 %."""


class Spot(NamedTuple):
    """A place on a link: ``node`` counts from the link's first element, ``s`` along it, ``placement`` there."""

    node: int
    s: float
    placement: Placement


@dataclass(frozen=True)
class LoweredLink:
    """The elements of a link, joined rigidly.

    ``root``: frame of the first element in the link's frame, where it bends; ``at_root``: bodies there; ``tip``: the
    tip frame in the chain's tip frame of the last element; ``undeformed``: the tip frame in the link's frame, at rest;
    ``spot``: the place of a station. A rigid element stands in the link's frame itself; ``rigid``: the one that a
    link becomes as a whole where no element bends, its bodies put into place.
    """

    links: tuple[Link, ...]
    tip: Placement
    undeformed: Placement
    spot: Callable[[float], Spot]
    root: Placement = field(default_factory=Placement)
    at_root: tuple[Body, ...] = ()
    rigid: RigidLink = field(default_factory=RigidLink)

    @property
    def bends(self) -> bool:
        """Whether any element does."""
        return any(link.bends for link in self.links)


class BendingSheet(DataSheet):
    """What a person writes under ``beam:``; its field ``model`` has one of ``words``."""

    words: ClassVar[tuple[str, ...]] = ()
    """Words of the field ``model`` that mean this sheet."""

    @classmethod
    def members(cls) -> tuple[type[DataSheet], ...]:
        """Of the contract, the sheets of all registered kinds."""
        return LINKS.members if cls is BendingSheet else (cls,)

    @classmethod
    def kind_named(cls, data: Any) -> type[DataSheet] | None:
        """Of the contract, the sheet of the word ``model``."""
        word = data.get("model") if isinstance(data, Mapping) else None
        return cls if cls is not BendingSheet else LINKS.get(word) if isinstance(word, str) else None

    @classmethod
    def chosen_by(cls) -> tuple[str, tuple[str, ...]]:
        """The field ``model``."""
        return "model", tuple(map(str, cls.words))

    @classmethod
    def of(cls, data: Any) -> BendingSheet:
        """The sheet of the kind that plain data name, checked; without ``model`` the first."""
        if isinstance(data, BendingSheet):
            return data
        word = data.get("model") if isinstance(data, Mapping) else None
        if not isinstance(word, str):
            return LINKS.members[0].model_validate(data)
        try:
            return LINKS[word].model_validate(data)
        except UnknownKindError as error:
            refuse([Issue("model", repr(word), error.expected, error.hint)])
            raise

    @property
    @abstractmethod
    def line_length(self) -> float:
        """Length of the unloaded line [m]."""

    @property
    @abstractmethod
    def coordinate_count(self) -> int:
        """Number of coordinates, 0 where it is rigid."""

    def massless_issues(self) -> Iterator[Issue]:
        """What no mass resists, so that it has modes, but no runs."""
        yield from ()

    def link(self, bodies: tuple[Body, ...]) -> Link:
        """The link of a kind that is one element with all bodies at its tip."""
        raise NotImplementedError

    def lowered(self, bodies: Sequence[BodySheet]) -> LoweredLink:
        """Elements of a chain for this link with the bodies it carries; by default one, :meth:`link`."""
        link = self.link(tuple(sheet_body(body, Placement()) for body in bodies))
        end = Placement(position=np.array([self.line_length, 0.0, 0.0]))
        return LoweredLink((link,), Placement(), end, lambda _: Spot(0, 1.0, Placement()))

    def section_pieces(self) -> list[Piece]:
        """Its sections from root to tip, as pieces over the share of its length; none where they are not known."""
        return []

    @property
    def modal_damping(self) -> float | None:
        """Damping over stiffness [s] of the whole link; None where it is curved, or bends in one plane alone."""
        return None

    @property
    def mounts(self) -> dict[str, Origin | None]:
        """Offsets of the beam's root in the link's frame and of the tip frame in the end section."""
        found = {name: getattr(self, name, None) for name in ("root_mount", "tip_mount")}
        return {name: origin for name, origin in found.items() if origin}

    def bending_about(self, axis: str) -> BendingSheet:
        """The same link bending about one axis of its section alone, y or z, without twist; by default as it is."""
        del axis
        return self

    @property
    def description(self) -> str:
        """Its model with its size, such as ``segments (2)``."""
        return str(getattr(self, "model", self.words[0]))

    @property
    def yield_strengths(self) -> tuple[float, ...]:
        """Yield strengths of its materials, as far as they are known [Pa]."""
        return ()

    @property
    def is_round(self) -> bool:
        """Whether it is drawn round."""
        return False

    def station_issues(self, bodies: Sequence[BodySheet]) -> Iterator[Issue]:  # noqa: ARG002
        """Bodies that stand where this model has no place for them."""
        yield from ()

    def notices(self) -> Iterator[str]:
        """What is strange about its model, each to be put after the path of the beam."""
        yield from ()

    def finer(self, more: int = MORE) -> BendingSheet:  # noqa: ARG002
        """The same link with ``more`` functions of each direction; itself where there is nothing to refine."""
        return self

    def variant(self, model: str, count: int | None) -> BendingSheet | None:
        """The link with another model and its number of functions or modes; None where there is no such link."""
        return LINKS[model].in_place_of(self, count) if model in LINKS else None

    @classmethod
    def in_place_of(cls, other: BendingSheet, count: int | None) -> BendingSheet | None:
        """A link of this kind in place of another; None where this kind cannot be that."""
        del other, count
        return None

    def element_stations(self, element: int, stations: Any) -> Any:  # noqa: ARG002
        """Places along the whole link of ``stations`` (0..1) along one of its elements, counted from 0."""
        return stations


def placed(origin: Origin | None) -> Placement:
    """The placement of a sheet's origin; none: no offset."""
    return Placement(origin.rotation(), np.array(origin.position)) if origin else Placement()


def sheet_body(body: BodySheet, frame: Placement) -> Body:
    """A body of a sheet as seen from where ``frame`` is given."""
    return moved_body(Body(body.mass, np.array(body.center), body.inertia_matrix()), frame)


def moved_body(body: Body, frame: Placement) -> Body:
    """The body as seen from where ``frame`` is given."""
    center = frame.rotation @ body.center + frame.position
    return Body(body.mass, center, frame.rotation @ body.inertia @ frame.rotation.T)


def straight(root: Origin | None, distance: float) -> Placement:
    """The frame at a distance [m] along a straight beam, in the link's frame."""
    return placed(root) @ Placement(position=np.array([distance, 0.0, 0.0]))


LINKS: Registry[type[BendingSheet]] = Registry("link", BendingSheet, names=lambda sheet: sheet.words)
"""The sheets of the kinds of bending links by the words of their field ``model``: ``@LINKS.register``."""
