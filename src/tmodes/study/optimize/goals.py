"""What an optimization is for: objectives and limits, judged over what is uncertain."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from difflib import get_close_matches
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmodes.errors import InputError
from tmodes.io.units import NotANumber, number
from tmodes.kinds.signals.formula import Formula, FormulaError, parse_formula
from tmodes.kinds.signals.formula_grammar import names_in
from tmodes.study.sheet import Objective, Optimize

__all__ = [
    "Aim",
    "Goals",
    "Judged",
    "Limit",
    "Term",
    "goals_of",
    "limits_of",
    "refuse_contradictions",
    "refuse_unknown",
]

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Term:
    """A formula of quantities and parameters; a name alone is the simplest one. ``names``: what it is made of."""

    text: str
    names: tuple[str, ...]
    formula: Formula

    @classmethod
    def of(cls, text: str, which: str, known: Iterable[str]) -> Term:
        """A term from its text; raises :class:`tmodes.errors.InputError` for a name that is not ``known``."""
        text = text.strip()
        try:
            names = names_in(text)
            refuse_unknown(names, which, known)
            if not names and parse_formula(text, ()):
                raise InputError(which, f"`{text}`", "a formula of quantities or parameters", "name one")
            return cls(text, names, parse_formula(text, names))
        except FormulaError as error:
            raise InputError(f"{which}: `{text}`", error.got, error.expected, error.hint) from None

    def at(self, values: Mapping[str, Array]) -> Array:
        """Its value (...) from those of quantities and parameters, each (...)."""
        return self.formula.at({name: values[name] for name in self.names})


def refuse_unknown(names: Iterable[str], which: str, known: Iterable[str]) -> None:
    """Raise for a name that no quantity and no parameter has; the nearest one is named."""
    known = tuple(known)
    for name in names:
        if name not in known:
            close = get_close_matches(name, known, n=1)
            hint = f"did you mean `{close[0]}`?" if close else "add it under `quantities`, or correct the name"
            raise InputError(which, f"the unknown quantity `{name}`", f"one of {', '.join(known)}", hint)


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


@dataclass(frozen=True)
class Aim:
    """An objective: a term that is to be small (``sign`` 1) or large (-1)."""

    term: Term
    sign: int

    @property
    def text(self) -> str:
        """In words."""
        return f"{'minimize' if self.sign > 0 else 'maximize'} {self.term.text}"


class Judged(NamedTuple):
    """m designs: values of the ``objectives`` (m, o) and of the terms of the ``limits`` (m, l), each the worst.

    ``excess`` (m, l): by which share each limit is exceeded, negative where it is kept, infinite where a case failed;
    ``feasible`` (m,): all limits are kept, and no case failed.
    """

    objectives: Array
    limits: Array
    excess: Array
    feasible: NDArray[np.bool_]

    @property
    def violation(self) -> Array:
        """Sum of what limits are exceeded by, (m,)."""
        return np.maximum(self.excess, 0.0).sum(axis=1)


@dataclass(frozen=True)
class Goals:
    """Objectives and limits; ``percentile`` of the cases of a design, from its best to its worst one, that counts."""

    aims: tuple[Aim, ...]
    limits: tuple[Limit, ...]
    percentile: float = 100.0

    @property
    def signs(self) -> Array:
        """1 for each objective that is to be small, -1 for one that is to be large."""
        return np.array([aim.sign for aim in self.aims], dtype=float)

    @property
    def names(self) -> tuple[str, ...]:
        """Quantities and parameters of which they are made."""
        terms = (*(aim.term for aim in self.aims), *(limit.term for limit in self.limits))
        return tuple(dict.fromkeys(name for term in terms for name in term.names))

    def judged(self, values: Mapping[str, Array]) -> Judged:
        """Designs from the values (m, cases) of parameters and quantities."""
        objectives = np.stack([self._worst(aim.term.at(values), aim.sign) for aim in self.aims], axis=-1)
        count = len(objectives)
        terms = [self._worst(limit.term.at(values), limit.sign) for limit in self.limits]
        kept = [limit.kept(one) for limit, one in zip(self.limits, terms, strict=True)]
        excess = [limit.excess(one) for limit, one in zip(self.limits, terms, strict=True)]
        held = np.array([*np.isfinite(objectives).T, *kept], dtype=bool)
        feasible: NDArray[np.bool_] = np.logical_and.reduce(held, axis=0)
        return Judged(objectives, _columns(terms, count), _columns(excess, count), feasible)

    def deciding(self, values: Mapping[str, Array]) -> list[int]:
        """The case of one design, values (1, cases), by which each term is judged: objectives, then limits."""
        judged, terms = self.judged(values), [one.term.at(values)[0] for one in (*self.aims, *self.limits)]
        found = np.concatenate([judged.objectives[0], judged.limits[0]])
        return [int(np.argmin(np.abs(term - one))) for term, one in zip(terms, found, strict=True)]

    def _worst(self, values: Array, sign: int) -> Array:
        """The worst (m,) of all cases (m, cases), or the percentile that counts; a case without value is the worst."""
        bad = np.where(np.isnan(values), np.inf, sign * values)
        found = sign * np.percentile(bad, self.percentile, axis=1, method="higher")
        return np.where(np.isfinite(found), found, np.nan)


def _columns(parts: list[Array], count: int) -> Array:
    return np.stack(parts, axis=-1) if parts else np.empty((count, 0))


def goals_of(asked: Optimize, units: Mapping[str, str | None]) -> Goals:
    """The goals of a sheet; ``units`` of all quantities and parameters by name."""
    aims = tuple(_aim(objective, units) for objective in asked.objectives)
    return Goals(aims, limits_of(asked.limits, units), asked.percentile)


def _aim(objective: Objective, units: Mapping[str, str | None]) -> Aim:
    if bool(objective.minimize) == bool(objective.maximize):
        got = "both" if objective.minimize else "neither"
        hint = "write `- minimize: mass`"
        raise InputError("optimize.objectives", got, "one of minimize and maximize", hint)
    text = objective.minimize or objective.maximize or ""
    return Aim(Term.of(text, "optimize.objectives", units), 1 if objective.minimize else -1)
