"""The form of a vector of numbers that depends on a few others: found by probing, and verified at random points."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from tmodes.model.accuracy import mistaken
from tmodes.model.entangled import disentangled
from tmodes.model.forms import Form, Range, Unfit, variables_of
from tmodes.model.probing import ENTANGLED, Entangled, Evaluate, Fit, Numbers

__all__ = ["fitted"]

Array = NDArray[np.float64]


def fitted(
    evaluate: Evaluate,
    ranges: Sequence[Range],
    generator: np.random.Generator,
    trials: int = 3,
    *,
    curves: bool = False,
    most: int = 0,
) -> Form:
    """The form of a vector over all variables; what is infinite at the start (a rigid stiffness) must stay so.

    ``curves``: what is no power of a variable may be a smooth function of it, which takes some tens of vectors.
    ``most``: then variables that are entangled may have smooth functions together that take no more vectors than that.
    Raises :class:`Unfit` that names the variables without one.
    """
    start = evaluate({})
    rigid = ~np.isfinite(start)

    def finite(values: Mapping[int, float]) -> Array:
        found = evaluate(values) if values else start
        if not np.array_equal(rigid, ~np.isfinite(found)):
            raise Unfit({max(values): "it makes what is rigid elastic"})
        return np.where(rigid, 0.0, found)

    form = _found(Fit(Numbers(finite), tuple(ranges), curves=curves), generator, trials, most)
    form.base[rigid] = start[rigid]
    return form


def _found(fit: Fit, generator: np.random.Generator, trials: int, most: int) -> Form:
    for k in range(len(fit.ranges)):
        fit.probe(k)
    if fit.unfit:
        raise Unfit(fit.unfit)
    try:
        return _verified(fit, generator, trials)
    except Entangled:
        other = disentangled(fit, most) if fit.curves else None
        if other is None:
            raise
    return _verified(other, generator, trials, exact=fit.depends)


def _verified(fit: Fit, generator: np.random.Generator, trials: int, exact: Collection[int] = ()) -> Form:
    ranges, form = fit.ranges, fit.form()
    for _ in range(trials):
        values = {k: one.drawn(generator) for k, one in enumerate(ranges)}
        wrong = np.flatnonzero(mistaken(form, values, fit.numbers.at(values), exact=exact))
        if len(wrong):
            blamed = max((k for e in wrong.tolist() for k in variables_of(fit.depends.get(e, ()))), default=None)
            raise Entangled({len(ranges) - 1 if blamed is None else blamed: ENTANGLED})
    return form
