"""The band within which a tip counts as settled: a share of its move, or a length; as a person writes it."""

from __future__ import annotations

import re
from typing import NamedTuple, Self

from tmodes.errors import InputError

__all__ = ["BAND", "Band"]

BAND = 0.001
"""The usual one, a share of the move: 1 mm of 1 m."""

_EXPECTED = "a share of the move between 0 and 1, such as 0.1 %, or a length above 0, such as 0.1 mm"

_GRAMMAR = re.compile(r"(?P<value>[0-9.]+(?:e[-+]?[0-9]+)?) *(?P<unit>%|[a-zµμ]*)", re.IGNORECASE)

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
        found = _GRAMMAR.fullmatch(str(text).strip()) if len(str(text)) <= _LONGEST else None
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
