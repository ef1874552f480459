"""What a study's terms are made of: formulas of numbers at rest and of series of a run."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from tmodes.io.units import number
from tmodes.study.quantities import Asked, Needs
from tmodes.study.space import ordered
from tmodes.study.study import Study

__all__ = ["cheap", "factor", "formulas", "leaves", "restricted"]

Array = NDArray[np.float64]


def leaves(study: Study, names: Iterable[str]) -> list[str]:
    """The quantities from which these follow that are no formulas."""
    left, found = list(names), dict[str, None]()
    while left:
        name = left.pop()
        if name not in study.sheet.quantities:
            continue
        needs = study.sheet.quantities[name].needs()
        left += needs.names
        if needs.reductions or needs.static or needs.result:
            found[name] = None
    return list(found)


def cheap(study: Study) -> bool:
    """Whether no quantity of a study needs a simulation."""
    return not (study.needs.reductions or study.needs.result)


def restricted(study: Study, names: Iterable[str]) -> Study:
    """The study with these quantities alone."""
    kept = {name: study.sheet.quantities[name] for name in names}
    return replace(study, sheet=study.sheet.model_copy(update={"quantities": kept}))


def formulas(study: Study, known: Mapping[str, Array]) -> dict[str, Array]:
    """With ``known`` (m,) all quantities that are formulas of these; others are not-a-number."""
    found = dict(known)
    nothing = np.full_like(next(iter(found.values())), np.nan)
    needs = {name: one.needs() for name, one in study.sheet.quantities.items()}
    for name in ordered({name: one.names for name, one in needs.items()}):
        if name not in found:
            plain = needs[name] == Needs(names=needs[name].names)
            found[name] = study.sheet.quantities[name].values(Asked(found))[0] if plain else nothing
    return found


def factor(own: str, wanted: str | None) -> float:
    """What a value in its own unit is multiplied by."""
    return 1.0 if wanted in (None, own) else 1.0 / number(f"1 {wanted}", own)
