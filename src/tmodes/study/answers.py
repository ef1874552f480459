"""Answers in words: what a study has found of its quantities; amounts and intervals as all answers write them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from tmodes.io.printed import pretty, written
from tmodes.io.words import count_of
from tmodes.study.rows import Rows
from tmodes.study.statistics import CONFIDENCE, Interval, statistics

if TYPE_CHECKING:
    from tmodes.study.study import Study

__all__ = ["SURE", "amount", "between", "joined_answers", "quantity_answers", "study_sentence"]

_SI = ("m", "rad", "s", "N", "N m", "N*m", "Pa", "W", "J", "m/N")
"""Units that may take a prefix; a study's others stay as they were asked for."""

SURE = f"{100 * CONFIDENCE:.0f} % confidence"
_MOST_NAMED = 3

_FEWEST = 20
"""Cases of which one is 5 %; of fewer the outer percentiles are but the ends."""


def amount(value: float, unit: str) -> str:
    """A value with its unit: ``12.41 mm``."""
    if unit in _SI:
        return written(value, unit)
    text = f"{value:.0f}" if 1e4 <= abs(value) < 1e6 else f"{value:.4g}"
    return f"{text} {pretty(unit)}".removesuffix(" –")


def study_sentence(answers: Sequence[str], rows: Rows) -> str:
    """What is found of the first quantities, and how many cases finished."""
    return f"{joined_answers(answers)} {int(rows.good.sum()):,} of {count_of(len(rows), 'case')} finished.".lstrip()


def quantity_answers(study: Study, rows: Rows) -> dict[str, str]:
    """A sentence for each quantity that any case has.

    Of cases that come as often as their distributions say, and are not few: what 95 % stay below and above, with the
    confidence interval where cases are independent; else its least and largest value, and where these are.
    """
    plan = type(study.sheet.plan)
    found = {}
    for name, one in study.sheet.quantities.items():
        values, title, unit = rows.quantities[name], one.title or name, rows.units[name]
        if np.isfinite(values).any():
            own = _shares(values, unit, certain=not plan.repeats) if plan.draws else _ends(study, rows, values, unit)
            found[name] = f"{title[:1].upper()}{title[1:]}: {own}."
    return found


def _shares(values: np.ndarray, unit: str, *, certain: bool) -> str:
    found = statistics(values, (5.0, 50.0, 95.0))
    if found.count < _FEWEST:
        ends = dict.fromkeys(amount(one, unit) for one in (found.least, found.largest))
        return f"{' to '.join(ends)} in {count_of(found.count, 'case')}, too few for percentiles"
    low, middle, high = found.percentiles.values()
    below, above, half = (amount(one.value, unit) for one in (high, low, middle))
    sure = f" ({between(high, unit)} at {SURE})" if certain and np.isfinite([high.low, high.high]).all() else ""
    return f"95 % of cases stay below {below}{sure}, 95 % above {above}, half below {half}"


def between(one: Interval, unit: str) -> str:
    """Both ends with their unit."""
    low, high = amount(one.low, unit), amount(one.high, unit)
    _, _, own = high.partition(" ")
    return f"{low.removesuffix(f' {own}')} to {high}"


def _ends(study: Study, rows: Rows, values: np.ndarray, unit: str) -> str:
    ends = [(amount(float(values[k]), unit), _at(study, rows, k))
            for k in (int(np.nanargmin(values)), int(np.nanargmax(values)))]  # fmt: skip
    return " to ".join(f"{value} ({where})" for value, where in ends)


def _at(study: Study, rows: Rows, row: int) -> str:
    """The parameters of a case in words, at most three."""
    words = []
    for name, one in list(study.sheet.parameters.items())[:_MOST_NAMED]:
        labels, value = study.choice_names(name), float(rows.parameters[name][row])
        shown = labels[int(value)] if labels else amount(value, study.parameter_units[name])
        words.append(f"{one.title or name} {shown}")
    return ", ".join(words)


def joined_answers(answers: Sequence[str]) -> str:
    """At most three of them; of more it is said that there are more."""
    more = [f"{len(answers) - _MOST_NAMED} more quantities below."] if len(answers) > _MOST_NAMED else []
    return " ".join([*answers[:_MOST_NAMED], *more])
