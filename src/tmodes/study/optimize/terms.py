"""Terms: formulas of quantities and parameters, for objectives and limits."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from difflib import get_close_matches

import numpy as np
from numpy.typing import NDArray

from tmodes.errors import InputError
from tmodes.kinds.signals.formula import Formula, FormulaError, parse_formula
from tmodes.kinds.signals.formula_grammar import names_in

__all__ = ["Term", "refuse_unknown"]

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
