"""Limits of a design such as ``sag <= 1.5 mm``: a formula, a relation, a number with its unit."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tmodes.errors import InputError
from tmodes.io.units import NotANumber, number
from tmodes.study.optimize.terms import Term

__all__ = ["Limit", "limits_of", "refuse_contradictions"]

Array = NDArray[np.float64]

_RELATION = re.compile(r"(<=|>=|=<|=>|<|>|≤|≥)")
_PLAIN = {"=<": "<=", "=>": ">=", "≤": "<=", "≥": ">="}
_MIRRORED = {"<=": ">=", ">=": "<=", "<": ">", ">": "<"}
_ARITHMETIC = re.compile(r"[*/(]|[0-9a-z)][+-][a-z(]")
_NUMBER = re.compile(r"[-+]?\.?[0-9]")

ROUNDING = 1e-9
"""Share of a limit by which it may be exceeded: what is on the limit is within it."""


@dataclass(frozen=True)
class Limit:
    """``term`` must be below (``sign`` 1) or above (-1) ``bound`` [``unit``]; ``text`` as it was written."""

    text: str
    term: Term
    sign: int
    bound: float
    unit: str
    strict: bool = False

    @property
    def scale(self) -> float:
        """What excess is relative to."""
        return abs(self.bound) or 1.0

    def excess(self, values: Array) -> Array:
        """By which share of the bound it is exceeded; negative: what is left; infinite where there is no value."""
        over = self.sign * (values - self.bound) / self.scale
        return np.where(np.isnan(over), np.inf, over)

    def kept(self, values: Array) -> NDArray[np.bool_]:
        """Where it holds."""
        over = self.excess(values)
        return over < 0 if self.strict else over <= ROUNDING


def limits_of(texts: Sequence[str], units: Mapping[str, str | None]) -> tuple[Limit, ...]:
    """Limits from their texts; ``units`` of all quantities and parameters by name, None where not known yet.

    Raises :class:`tmodes.errors.InputError` for a text that is no limit, a name that is not known, and a unit that does
    not fit.
    """
    return tuple(limit for text in texts for limit in _limits(text, units))


def refuse_contradictions(texts: Sequence[str]) -> None:
    """Raise :class:`tmodes.errors.InputError` for two limits of one term that no design can keep both."""
    pieces = [(text, *piece) for text in texts for piece in _pieces(text)]
    for first, left, relation, low in pieces:
        for second, other, against, high in pieces:
            if left.split() != other.split() or relation[0] != ">" or against[0] != "<":
                continue
            unit = high.partition(" ")[2].strip() or "-"
            try:
                apart = number(low, unit) - number(high, unit)
            except NotANumber:  # of another dimension, which is refused where the unit of the term is known
                continue
            if apart > 0 or (apart == 0 and len(relation) + len(against) < 4):
                got = f"`{first}`" if first == second else f"`{first}` and `{second}`"
                raise InputError(
                    "optimize.limits", f"{got}, which exclude each other", "limits that a design can keep",
                    "change one of them",
                )  # fmt: skip


def _limits(text: str, units: Mapping[str, str | None]) -> list[Limit]:
    """One limit, or both of ``1 mm <= sag <= 2 mm``."""
    return [_limit(text, left, relation, right, units) for left, relation, right in _pieces(text)]


def _pieces(text: str) -> list[tuple[str, str, str]]:
    """Term, relation and number of one limit, or of both."""
    parts = [part.strip() for part in _RELATION.split(text)]
    relations = [_PLAIN.get(one, one) for one in parts[1::2]]
    sides = parts[::2]
    if len(sides) == 3 and _is_number(sides[0]) and _is_number(sides[2]):
        return [(sides[1], _MIRRORED[relations[0]], sides[0]), (sides[1], relations[1], sides[2])]
    if len(sides) == 2 and _is_number(sides[1]):
        return [(sides[0], relations[0], sides[1])]
    if len(sides) == 2 and _is_number(sides[0]):
        return [(sides[1], _MIRRORED[relations[0]], sides[0])]
    hint = "write it as `sag <= 1.5 mm` or `f1 >= 14 Hz`"
    raise InputError("optimize.limits", repr(text), "a quantity, one of <= >= < >, and a number", hint)


def _is_number(side: str) -> bool:
    return bool(_NUMBER.match(side)) and not _ARITHMETIC.search(side.split(" ", maxsplit=1)[0])


def _limit(text: str, left: str, relation: str, right: str, units: Mapping[str, str | None]) -> Limit:
    term = Term.of(left, "optimize.limits", units)
    known = left not in units or units[left] is not None
    unit = units.get(left)
    bound = _bound(text, left, right, unit) if known else 0.0
    return Limit(text, term, 1 if relation[0] == "<" else -1, bound, unit or "-", strict=len(relation) == 1)


def _bound(text: str, left: str, right: str, unit: str | None) -> float:
    """The number of a limit in the unit of its quantity; the unit of a formula is not known."""
    try:
        bound = number(right, unit or "-")
    except NotANumber as error:
        which = f"optimize.limits: `{text}`"
        if unit is None:
            hint = "give the formula a name and a `unit` under `quantities`, and limit that"
            raise InputError(
                which, error.got, f"a number without a unit: that of `{left}` is not known", hint
            ) from None
        expected = "a number without a unit" if unit == "-" else f"a number in {unit}, the unit of {left}"
        raise InputError(which, error.got, expected, error.hint) from None
    if not np.isfinite(bound):
        raise InputError(f"optimize.limits: `{text}`", right, "a finite number", "remove a limit that limits nothing")
    return bound
