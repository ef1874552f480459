"""Elementary effects of parameters, from the values at the cases of :class:`tmodes.study.plans.morris`."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tmodes.study.sensitivity.sobol import Indices

__all__ = ["elementary_effects"]

Array = NDArray[np.float64]

_CONFIDENCE = 0.95
_LEAST = 4


def elementary_effects(values: Array, order: NDArray[np.intp], steps: Array) -> Indices | None:
    """Mean, mean size and standard deviation of the effects of one quantity; None where too few cases have a value.

    ``values`` (trajectories, d + 1); ``order`` (trajectories, d): which parameter changes from one case to the next;
    ``steps`` (trajectories, d): by which share of its distribution. Sizes: F. Campolongo et al., An effective screening
    design for sensitivity analysis of large models, Environ. Model. Softw. 22 (2007). The intervals are Student's:
    trajectories are independent.
    """
    from scipy.stats import t as student

    effects = np.empty(order.shape)
    np.put_along_axis(effects, order, np.diff(values, axis=1), axis=1)
    effects = (effects / steps)[np.isfinite(values).all(axis=1)]
    count = len(effects)
    if count < _LEAST:
        return None
    found = {"effect": effects.mean(axis=0), "size": np.abs(effects).mean(axis=0), "spread": effects.std(0, ddof=1)}
    factor = float(student.ppf((1 + _CONFIDENCE) / 2, count - 1)) / np.sqrt(count)
    half = {"effect": factor * found["spread"], "size": factor * np.abs(effects).std(axis=0, ddof=1)}
    ends = {name: np.stack([found[name] - part, found[name] + part], axis=-1) for name, part in half.items()}
    return Indices(found, ends)
