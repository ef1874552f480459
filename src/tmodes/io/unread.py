"""What a robot's file says and nobody takes: each such element and attribute is named, unless it is known to be idle.

A format states what is read of it (:class:`Format`); all else that stands in a file is named in a notice, the same
element or attribute of many owners in one.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import NamedTuple

from tmodes.io.xml_file import Element

__all__ = ["Format", "Left", "few", "sentences"]

MOST_NAMES = 6
"""Owners that one notice names; of further ones the number."""

LEFT_OUT = "what it changes in the motion is left out"


class Left(NamedTuple):
    """Something that is not taken: what, with which effect, and of which joint, link or other owner."""

    what: str
    effect: str
    owner: str


@dataclass(frozen=True)
class Format:
    """What is read of a format, by ``tag`` or ``parent/tag``, which comes first.

    ``read``: the attributes that are taken of an element; ``idle``: elements that change no motion, with all inside
    them, and ``tag@attribute``; ``owners``: tags whose name tells where something stands; ``effects``: what follows for
    the motion, by ``tag@attribute``, ``parent/tag`` or ``tag``.
    """

    read: Mapping[str, Collection[str]]
    idle: Collection[str]
    owners: Collection[str]
    effects: Mapping[str, str] = field(default_factory=dict)

    def left(self, element: Element, parent: str = "", owner: str = "") -> Iterator[Left]:
        """What is not taken of an element and of all inside it."""
        tag, within = element.tag, f"{parent}/{element.tag}"
        if tag in self.idle or within in self.idle:
            return
        if tag in self.owners:
            owner = _label(element)
        known = self.read.get(within, self.read.get(tag))
        if known is None:
            effect = self.effects.get(within, self.effects.get(tag, LEFT_OUT))
            yield Left(f"<{tag[:60]}>", effect, owner or _label(element))
            return
        for name in element.attributes:
            declares = name.partition(":")[0] == "xmlns"
            if name not in known and not declares and f"{tag}@{name}" not in self.idle:
                what = f"`{name[:60]}` of <{tag[:60]}>"
                yield Left(what, self.effects.get(f"{tag}@{name}", LEFT_OUT), owner or f"line {element.line}")
        for child in element.children:
            yield from self.left(child, tag, owner)


def _label(element: Element) -> str:
    """Its tag with its name, else with its line."""
    given = element.attributes
    name = given.get("name") or given.get("class") or given.get("reference")
    return f"{element.tag[:60]} {name[:100]}" if name else f"{element.tag[:60]} in line {element.line}"


def sentences(found: Iterable[Left]) -> list[str]:
    """A sentence for each kind of thing that is left out, with its owners."""
    owners: dict[tuple[str, str], dict[str, None]] = {}
    for what, effect, owner in found:
        owners.setdefault((what, effect), {})[owner] = None
    return [f"{what} is not read: {effect} ({few([*names])})." for (what, effect), names in owners.items()]


def few(names: list[str]) -> str:
    """Some of them, and how many more there are."""
    more = f" and {len(names) - MOST_NAMES} more" if len(names) > MOST_NAMES else ""
    return ", ".join(names[:MOST_NAMES]) + more
