"""Numbers that are measured on a run: of quantities at its samples, with their derivatives by these."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.errors import InputError

__all__ = ["Functional", "tracking_error"]

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Functional:
    """One number of a run: ``measure(times (n,), quantities)`` -> its value and its derivatives.

    ``quantities``: names of what is looked at, as :class:`tmodes.sensitivity.quantities.Quantities` knows them;
    ``quantities`` holds each as an array (n, numbers), derivatives by the same names in the same shapes; a name that
    is left out has none.
    """

    quantities: tuple[str, ...]
    measure: Callable[[Array, Mapping[str, Array]], tuple[float, Mapping[str, ArrayLike]]]


def tracking_error(quantity: str, reference: ArrayLike | Callable[[Array], ArrayLike]) -> Functional:
    """The integral over the run of the squared distance of a quantity from its reference, by the trapezoidal rule.

    ``tracking_error("tip", path)`` [m^2 s] with ``path`` (n, 3) [m] at the samples, one position (3,) for all, or a
    function of the times (n,) [s]. The rule's error is that of the samples' distance squared; its derivative is exact.
    """

    def measure(times: Array, info: Mapping[str, Array]) -> tuple[float, Mapping[str, ArrayLike]]:
        is_ = info[quantity]
        wanted = np.asarray(reference(times) if callable(reference) else reference, dtype=float)
        if wanted.shape not in (is_.shape, is_.shape[1:]):
            expected = f"{is_.shape}, one at each sample, or {is_.shape[1:]}, one for all"
            raise InputError(
                "reference", f"an array of shape {wanted.shape}", expected, "reshape it, or sample it again"
            )
        if not np.isfinite(wanted).all():
            raise InputError("reference", "not-a-number or an infinite value", "finite numbers", "look for gaps in it")
        apart = is_ - wanted
        shares = _trapezoids(times)[:, None]
        return float((shares * apart**2).sum()), {quantity: 2 * shares * apart}

    return Functional((quantity,), measure)


def _trapezoids(times: Array) -> Array:
    """Weights of samples in an integral over time."""
    steps = np.diff(times)
    return (np.append(steps, 0.0) + np.append(0.0, steps)) / 2
