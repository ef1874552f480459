"""The form of a vector of numbers that depends on a few others: found by probing, and verified at random points."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from tmodes.model.accuracy import mistaken
from tmodes.model.forms import Form, Range, Unfit, variables_of
from tmodes.model.probing import ENTANGLED, Evaluate, Fit, Numbers

__all__ = ["fitted"]

Array = NDArray[np.float64]


def fitted(evaluate: Evaluate, ranges: Sequence[Range], generator: np.random.Generator, trials: int = 3) -> Form:
    """The form of a vector over all variables; what is infinite at the start (a rigid stiffness) must stay so.

    Raises :class:`Unfit` that names the variables without one.
    """
    start = evaluate({})
    rigid = ~np.isfinite(start)

    def finite(values: Mapping[int, float]) -> Array:
        found = evaluate(values) if values else start
        if not np.array_equal(rigid, ~np.isfinite(found)):
            raise Unfit({max(values): "it makes what is rigid elastic"})
        return np.where(rigid, 0.0, found)

    fit = Fit(Numbers(finite), tuple(ranges))
    for k in range(len(fit.ranges)):
        fit.probe(k)
    if fit.unfit:
        raise Unfit(fit.unfit)
    form = _verified(fit, generator, trials)
    form.base[rigid] = start[rigid]
    return form


def _verified(fit: Fit, generator: np.random.Generator, trials: int) -> Form:
    ranges, form = fit.ranges, fit.form()
    for _ in range(trials):
        values = {k: one.drawn(generator) for k, one in enumerate(ranges)}
        wrong = np.flatnonzero(mistaken(form, values, fit.numbers.at(values)))
        if len(wrong):
            blamed = max((k for e in wrong.tolist() for k in variables_of(fit.depends.get(e, ()))), default=None)
            raise Unfit({len(ranges) - 1 if blamed is None else blamed: ENTANGLED})
    return form
