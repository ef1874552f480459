"""Which integrator suits a robot: explicit steps are held back by its fastest motion, implicit ones are not."""

from __future__ import annotations

from tmodes.integrate.registry import AUTO, integrator
from tmodes.integrate.settings import Integration

__all__ = ["STIFF", "TRIAL", "chosen_method", "explained", "otherwise", "worth_keeping", "worth_switching"]

STIFF = 20_000
"""Explicit steps over a whole run beyond which the implicit method is the cheaper one."""

TRIAL = 40
"""Attempted steps after which an implicit method is judged."""

_DEARER = 1.65
"""Cost of a step of it over an explicit one: nine passes, of four lanes (1.1), over six."""

_EXPLICIT, _IMPLICIT = "dormand_prince", "extrapolation"
"""Those between which the stiffness chooses."""


def chosen_method(given: Integration, highest: float) -> tuple[str, str]:
    """The method of a run and why, in words (empty where it was given); ``highest``: largest |eigenvalue| [1/s]."""
    if given.method != AUTO:
        return given.method, ""
    steps = highest * given.duration / (integrator(_EXPLICIT).reach or 1.0)
    info = f"chosen: fastest eigenvalue {_about(highest)} 1/s"
    if steps <= STIFF:
        return _EXPLICIT, f"{_EXPLICIT} {info}"
    info += f", about {_about(steps)} explicit steps"
    if _too_exact(given):
        return _EXPLICIT, f"{_EXPLICIT} {info}; {_IMPLICIT} would round above the tolerance"
    return _IMPLICIT, f"{_IMPLICIT} {info}"


def _about(value: float) -> str:
    """A number in two digits, without a power of ten where that is the easier to read."""
    return f"{float(f'{value:.2g}'):,.0f}" if 1 <= value < 1e7 else f"{value:.2g}"


def explained(message: str, why: str) -> str:
    """How a run ended, with why its method was chosen (empty: it was given)."""
    if not why:
        return message
    ending, semicolon, later_on = message.partition("; ")
    return f"{ending} ({why}){semicolon}{later_on}"


def otherwise(given: Integration, method: str) -> Integration | None:
    """The settings to continue with where a motion turns out stiff; None where there are none.

    ``given``: the settings of the sheet; ``method``: the one that was chosen by them. A method that was named stays;
    so does one that is implicit, or whose tolerance is below that of its rounding.
    """
    if given.method != AUTO or method != _EXPLICIT or _too_exact(given):
        return None
    return given.chosen(_IMPLICIT)


def _too_exact(given: Integration) -> bool:
    return given.chosen(_IMPLICIT).relative_tolerance < integrator(_IMPLICIT).least_tolerance


def worth_switching(left: float, step: float) -> bool:
    """Whether a run that turned out stiff is better ended by the implicit method, by the measure of ``STIFF``.

    ``left``: what is left of it [s]; ``step``: of the explicit method now [s].
    """
    return left > STIFF * step


def worth_keeping(step: float, gained: float) -> bool:
    """Whether a trial of the implicit method, which advanced by ``gained`` [s], was cheaper than explicit steps.

    ``step``: of the explicit method before [s].
    """
    return gained > _DEARER * TRIAL * step
