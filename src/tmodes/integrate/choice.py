"""Which integrator suits an arm: explicit steps are held back by its fastest motion, implicit ones are not."""

from __future__ import annotations

from tmodes.integrate.settings import Method

__all__ = ["STIFF", "chosen_method"]

STIFF = 20_000
"""Explicit steps over a whole run beyond which the implicit method is the cheaper one."""

_REACH = 3.3
"""Largest step times eigenvalue at which Dormand and Prince's method is stable, about."""


def chosen_method(method: Method, highest: float, duration: float) -> tuple[Method, str]:
    """The method of a run and why, in words (empty where it was given); ``highest``: largest |eigenvalue| [1/s]."""
    if method is not Method.AUTO:
        return method, ""
    steps = highest * duration / _REACH
    told = f"the fastest eigenvalue, {highest:.3g} 1/s, would take about {max(steps, 1.0):.2g} explicit steps"
    if steps > STIFF:
        return Method.EXTRAPOLATION, f"by extrapolation, because {told}"
    return Method.DORMAND_PRINCE, f"by dormand_prince: {told}"
