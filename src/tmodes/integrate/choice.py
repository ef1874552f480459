"""Which integrator suits a robot: explicit steps are held back by its fastest motion, implicit ones are not."""

from __future__ import annotations

from tmodes.integrate.settings import LEAST_EXTRAPOLATED, Integration, Method

__all__ = ["STIFF", "TRIAL", "chosen_method", "explained", "otherwise", "worth_keeping", "worth_switching"]

STIFF = 20_000
"""Explicit steps over a whole run beyond which the implicit method is the cheaper one."""

TRIAL = 40
"""Attempted steps after which an implicit method is judged."""

_DEARER = 1.65
"""Cost of a step of it over an explicit one: nine passes, of four lanes (1.1), over six."""

_REACH = 3.3
"""Largest step times eigenvalue at which Dormand and Prince's method is stable, about."""


def chosen_method(given: Integration, highest: float) -> tuple[Method, str]:
    """The method of a run and why, in words (empty where it was given); ``highest``: largest |eigenvalue| [1/s]."""
    if given.method is not Method.AUTO:
        return given.method, ""
    steps = highest * given.duration / _REACH
    info = f"the fastest eigenvalue, {_about(highest)} 1/s, asks for some {_about(max(steps, 2.0))} explicit steps"
    if steps > STIFF and _too_exact(given):
        why = "because extrapolation rounds above its tolerance"
        return Method.DORMAND_PRINCE, f"by dormand_prince, {why}, though {info}"
    if steps > STIFF:
        return Method.EXTRAPOLATION, f"by extrapolation, because {info}"
    return Method.DORMAND_PRINCE, f"by dormand_prince: {info}"


def _about(value: float) -> str:
    """A number in two digits, without a power of ten where that is the easier to read."""
    return f"{float(f'{value:.2g}'):,.0f}" if 1 <= value < 1e7 else f"{value:.2g}"


def explained(message: str, why: str) -> str:
    """How a run ended, with why its method was chosen (empty: it was given)."""
    if not why:
        return message
    ending, semicolon, later_on = message.partition("; ")
    return f"{ending}, {why}{semicolon}{later_on}"


def otherwise(given: Integration, method: Method) -> Integration | None:
    """The settings to go on with where a motion turns out stiff; None where there are none.

    ``given``: the settings of the sheet; ``method``: the one that was chosen by them. A method that was named stays;
    so does one that is implicit, or whose tolerance is below that of its rounding.
    """
    if given.method is not Method.AUTO or method is not Method.DORMAND_PRINCE or _too_exact(given):
        return None
    return given.chosen(Method.EXTRAPOLATION)


def _too_exact(given: Integration) -> bool:
    return given.chosen(Method.EXTRAPOLATION).relative_tolerance < LEAST_EXTRAPOLATED


def worth_switching(left: float, step: float) -> bool:
    """Whether a run that turned out stiff is better ended by the implicit method, by the measure of ``STIFF``.

    ``left``: what is left of it [s]; ``step``: of the explicit method now [s].
    """
    return left > STIFF * step


def worth_keeping(step: float, gained: float) -> bool:
    """Whether a trial of the implicit method, which went on by ``gained`` [s], was cheaper than explicit steps.

    ``step``: of the explicit method before [s].
    """
    return gained > _DEARER * TRIAL * step
