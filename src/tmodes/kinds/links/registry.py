"""The kinds of bending links by the word of their sheet's field ``model``: those of tmodes, and a user's own."""

from __future__ import annotations

from typing import TypeVar

from tmodes.kinds.links.beam_sheet import BeamSheet
from tmodes.kinds.links.modes_beam import ModesSheet
from tmodes.kinds.links.sheet import BendingSheet

__all__ = ["link_sheets", "link_words", "register", "sheet_of"]

_Sheet = TypeVar("_Sheet", bound=BendingSheet)

_SHEETS: dict[str, type[BendingSheet]] = {}


def register(sheet: type[_Sheet]) -> type[_Sheet]:
    """Add a kind by its sheet; a decorator. The same class again (a cell run twice) replaces it.

    Raises :class:`TypeError` for what is no :class:`BendingSheet`, :class:`ValueError` for a word that is taken.
    """
    if not issubclass(sheet, BendingSheet):
        raise TypeError(f"{sheet.__name__} is not a BendingSheet")
    for word in sheet.words:
        taken = _SHEETS.get(word)
        if taken and (taken.__module__, taken.__qualname__) != (sheet.__module__, sheet.__qualname__):
            raise ValueError(f"the link kind `{word}` is already registered by {taken.__module__}.{taken.__qualname__}")
        _SHEETS[word] = sheet
    return sheet


def sheet_of(word: str) -> type[BendingSheet] | None:
    """The sheet of a kind, None for a word that no registered kind has."""
    return _SHEETS.get(word)


def link_words() -> tuple[str, ...]:
    """All words of the field ``model``."""
    return tuple(_SHEETS)


def link_sheets() -> tuple[type[BendingSheet], ...]:
    """All sheets, each once."""
    return tuple(dict.fromkeys(_SHEETS.values()))


for _sheet in (BeamSheet, ModesSheet):
    register(_sheet)
