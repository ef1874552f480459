"""Stop conditions and the settling band as a person writes them."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import NamedTuple, Self

from tmodes.errors import InputError

__all__ = ["BAND", "EXPECTED", "LONGEST", "MOST", "Band", "Condition"]

LONGEST, MOST = 300, 50
"""Characters of a condition, and how many of them a run takes."""

EXPECTED = "a name, > or <, and a number, such as `joint2.position > 1.2` or `abs(elbow.velocity) > 90 deg/s`"

_NAME = r"[^\s<>=()]+"
_GRAMMAR = re.compile(rf"(?:abs\( *(?P<size>{_NAME}) *\)|(?P<name>{_NAME})) *(?P<sign>[<>]) *(?P<value>[^<>=()]+)")


@dataclass(frozen=True)
class Condition:
    """The parts of a condition: ``name`` of the quantity, whether its ``size`` counts, which side, and the value.

    ``above``: it holds above the value; ``value`` is a number as text, perhaps with a unit.
    """

    name: str
    size: bool
    above: bool
    value: str

    @classmethod
    def parsed(cls, text: str, which: str = "stop") -> Condition:
        """The parts of a text; raises :class:`tmodes.errors.InputError` for one that is none."""
        found = _GRAMMAR.fullmatch(" ".join(text.split())) if isinstance(text, str) and len(text) <= LONGEST else None
        if found is None:
            shown = repr(text if len(str(text)) <= 60 else f"{str(text)[:60]}...")
            raise InputError(which, shown, EXPECTED, _hint(str(text)))
        name = found["size"] or found["name"]
        return cls(name, found["size"] is not None, found["sign"] == ">", found["value"].strip())

    @property
    def quantity(self) -> str:
        """What is compared, in words."""
        return f"abs({self.name})" if self.size else self.name


def _hint(text: str) -> str:
    if "=" in text:
        return "write > or <: a quantity passes a value at one time, with or without it"
    if "<" not in text and ">" not in text:
        return "write what is compared with what, with > or <"
    if text.strip()[-1] in "<>":
        return "write the number after it"
    if text.strip()[0] in "<>":
        return "write the name before it"
    return "write one comparison; several conditions are several items of the list"


BAND = 0.001
"""The usual one, a share of the move: 1 mm of 1 m."""

_EXPECTED = "a share of the move between 0 and 1, such as 0.1 %, or a length above 0, such as 0.1 mm"

_BAND = re.compile(r"(?P<value>[0-9.]+(?:e[-+]?[0-9]+)?) *(?P<unit>%|[a-zµμ]*)", re.IGNORECASE)

_LENGTHS = {"m": 1.0, "cm": 1e-2, "mm": 1e-3, "um": 1e-6, "µm": 1e-6, "μm": 1e-6}


class Band(NamedTuple):
    """``share`` [-] of the move, or ``length`` [m] where it is one."""

    share: float | None
    length: float | None = None

    @classmethod
    def parsed(cls, text: str | float | Band, which: str = "band") -> Self:
        """From ``0.001``, ``0.1 %`` or ``0.1 mm``; raises :class:`tmodes.errors.InputError` for what is none."""
        if isinstance(text, Band):
            return cls(*text)
        found = _BAND.fullmatch(str(text).strip()) if len(str(text)) <= _LONGEST else None
        try:
            value = float(found["value"]) if found else 0.0
        except ValueError:
            value = 0.0
        unit = found["unit"] if found else ""
        if unit in _LENGTHS and 0 < value < _FARTHEST:
            return cls(None, value * _LENGTHS[unit])
        share = value / 100 if unit == "%" else value
        if unit in ("", "%") and 0 < share < 1:
            return cls(share)
        raise InputError(which, str(text)[:_LONGEST], _EXPECTED, f"{BAND} is the usual one")

    def limit(self, move: float) -> float:
        """The distance from rest [m] that it is, of a move [m]."""
        return self.length if self.length is not None else (self.share or 0.0) * move

    @property
    def words(self) -> str:
        """``0.1 % of the move``, ``0.1 mm``."""
        return f"{100 * (self.share or 0.0):g} % of the move" if self.length is None else f"{1e3 * self.length:g} mm"


_LONGEST, _FARTHEST = 40, 1e6
"""Characters of a text, and the number before its unit, at most."""
