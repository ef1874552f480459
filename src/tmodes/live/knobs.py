"""What a page may change of a run: numbers of the data sheet, the most useful first, and how far each goes."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from tmodes.io.sheet_check import sheet_data
from tmodes.io.sheet_groups import real_entry
from tmodes.live.sheet_numbers import SheetNumber, sheet_numbers
from tmodes.model.parameters import STRUCTURE
from tmodes.sheet import Robot

__all__ = ["REAL", "Ahead", "Knob", "SliderRule", "knobs_of", "rule_of", "stretched_length"]


Ahead = Mapping[str, tuple[float, float]]
"""Numbers that come first, with the least and the largest value that each must reach: by their path in the sheet.

``real:PATH``: the factor of the actual robot on what stands there.
"""

REAL = "real:"


@dataclass(frozen=True)
class Knob:
    """What a run is changed by: one number of the sheet, or all of a kind in proportion (``together``).

    ``targets``: path and value of each number; the knob itself stands at the value, or at 1 where it is a proportion.
    ``reals``: where in ``real`` the factor on each stands, empty where one acts on other numbers as well; ``factor``:
    that of the actual robot on them, None where their factors differ. ``first``: the first of the numbers.
    """

    pattern: str
    targets: tuple[tuple[str, float], ...]
    start: float
    low: float
    high: float
    log: bool
    reals: tuple[str, ...]
    factor: float | None
    first: SheetNumber

    @property
    def together(self) -> bool:
        """Whether it moves several numbers in proportion."""
        return len(self.targets) > 1

    def changes(self, value: float) -> dict[str, float]:
        """Path and value of each number where the knob stands at ``value``."""
        return {path: base * value if self.together else value for path, base in self.targets}


class SliderRule(NamedTuple):
    """A kind of number that is worth a slider: its path, its group, how far it goes, and whether the real one differs.

    ``reach``: the largest value over the present one (the least is its inverse); ``room``: how far a number that
    may be zero goes at least; ``span``: how far one goes both ways, as a share of the robot's length. ``words``: its
    label where the sheet's own words do not say whose it is. ``design``: chosen by the designer of the robot, other
    than the constants of a material, damping and friction.
    """

    pattern: str
    group: str
    reach: float = 4.0
    real: bool = False
    room: float = 0.0
    log: bool = True
    span: float = 0.0
    words: str = ""
    design: bool = False


_RULES = (
    SliderRule(r"links\.\*\.bodies\.\*\.mass", "payload", 3.0, log=False),
    SliderRule(r"joints\.\*\.gear\.stiffness(\.0)?(\.\*)?", "gear", real=True, design=True),
    SliderRule(r"links\.\*\.beam\.(modes\.\*|section)\.bending_stiffness(\.\*)?", "links", real=True, design=True),
    SliderRule(
        r"links\.\*\.beam\.section\.(\w*diameter|\w*thickness|width|height)", "links", 2.0, log=False, design=True
    ),
    SliderRule(r"drives\.\*\.signal\.duration", "move", 2.0),
    SliderRule(r"drives\.\*\.controller\.position_gain", "controller", design=True),
    SliderRule(r"drives\.\*\.controller\.velocity_gain", "controller", design=True),
    SliderRule(r"links\.\*\.beam\.material\.young", "links", real=True),
    SliderRule(r"contact\.stiffness", "environment"),
    SliderRule(r"contact\.shape\.distance", "environment", span=0.03, log=False, words="distance of the wall"),
    SliderRule(r"contact\.shape\.radius", "environment", span=0.03, log=False, words="radius of the surface touched"),
    SliderRule(
        r"contact\.shape\.position\.\*", "environment", span=0.03, log=False, words="place of the surface along {}"
    ),
    SliderRule(r"contact\.damping", "environment"),
    SliderRule(r"contact\.friction", "environment", 3.0, log=False),
    SliderRule(r"contact\.preload", "environment", 3.0, room=20.0, log=False),
    SliderRule(r"joints\.\*\.gear\.damping", "gear", real=True),
    SliderRule(r"joints\.\*\.spring\.stiffness", "gear", real=True, design=True),
    SliderRule(r"joints\.\*\.spring\.damping", "gear", real=True),
    SliderRule(r"links\.\*\.beam\.(modes\.\*\.)?damping_time", "links"),
    SliderRule(r"joints\.\*\.motor\.inertia", "motor", design=True),
    SliderRule(r"joints\.\*\.motor\.friction\.viscous", "motor"),
    SliderRule(r"joints\.\*\.friction\.viscous", "motor"),
)
_ALONE = 2
"""Numbers of a kind that have a slider each; more of them move together."""


def knobs_of(sheet: Robot, ahead: Ahead | None = None, *, others: bool = False) -> list[Knob]:
    """What is most useful to change, the most useful first; no zero, on which structure may depend.

    Numbers ``ahead`` come before all others, each by itself. With ``others`` every other number of the robot follows.
    """
    numbers, ahead = list(sheet_numbers(sheet)), ahead or {}
    named = {path.removeprefix(REAL) for path in ahead}
    found = [_named(sheet, number, ahead.get(number.path)) for number in numbers if number.path in named]
    for rule in _RULES:
        kinds: dict[str, list[SheetNumber]] = {}
        for number in numbers:
            if re.fullmatch(rule.pattern, number.pattern) and _useful(sheet, number, rule):
                kinds.setdefault(number.pattern, []).append(number)
        for group in kinds.values():
            left = [number for number in group if number.path not in named]
            if left == group or len(group) <= _ALONE:
                found += _knobs(sheet, left, rule)
    if others:
        own = {*STRUCTURE, *(knob.first.path for knob in found if not knob.together)}
        found += _others(sheet, [one for one in numbers if not {one.path, one.path.split(".")[0]} & own])
    return found


_SURROUNDINGS = ("gravity", "base", "base_motion", "contact", "loads", "initial", "task")


def _others(sheet: Robot, numbers: Sequence[SheetNumber]) -> Iterator[Knob]:
    """Numbers by themselves: from half to twice, or of a zero as far as its unit suggests.

    Those of the robot first, then those of its surroundings; directions of axes and zeros come last of each.
    """
    away = {"m": 0.05 * stretched_length(sheet), "rad": 0.5}

    def last(one: SheetNumber) -> tuple[bool, bool, bool]:
        return one.path.split(".")[0] in _SURROUNDINGS, ".axis." in one.path, one.value == 0.0

    for number in sorted(numbers, key=last):
        zero = away.get(number.unit, 1.0) if number.value == 0.0 else 0.0
        low, high = sorted((number.value / 2 - zero, 2 * number.value + zero))
        low, high = max(low, number.least), min(high, number.most)
        if low <= number.value <= high:
            targets = ((number.path, number.value),)
            yield Knob(number.pattern, targets, number.value, low, high, number.value > 0, (), None, number)


def _named(sheet: Robot, number: SheetNumber, span: tuple[float, float] | None) -> Knob:
    """A knob of one number that goes from end to end of a span, and a little beyond."""
    low, high = span or (number.value / 2, 2 * number.value)
    low, high = min(low, number.value), max(high, number.value)
    edge = _BEYOND * (high - low)
    low = max(low - edge, number.least, low * _BEYOND if low > 0 else number.least)
    return _knob(sheet, [number], (number.value, low, min(high + edge, number.most)), log=False)


_BEYOND = 0.1
"""How far beyond its span a number that was named goes, as a share of it."""


def _useful(sheet: Robot, number: SheetNumber, rule: SliderRule) -> bool:
    """A payload is on the link with its tip; a plane moves along its normal; a slider is finite."""
    if not math.isfinite(number.value):
        return False
    if number.pattern == "contact.shape.position.*":
        return sheet.contact is not None and int(number.path[-1]) == sheet.contact.shape.steep_axis
    if number.pattern == "links.*.bodies.*.mass":
        tip = sheet.tip.link if sheet.tip else sheet.links[-1].name if sheet.links else ""
        return number.owner == tip and number.value > 0
    return number.value > 0 or (rule.room > 0 and number.least < 0)


def _knobs(sheet: Robot, group: Sequence[SheetNumber], rule: SliderRule) -> Iterator[Knob]:
    if not group:
        return
    if len(group) <= _ALONE:
        for number in group:
            low, high = _reach(sheet, number, rule)
            yield _knob(sheet, [number], (number.value, low, high), _log(low, rule))
        return
    least = max(max(number.least / number.value, 1 / rule.reach) for number in group)
    most = min(min(number.most / number.value, rule.reach) for number in group)
    yield _knob(sheet, group, (1.0, least, most), _log(least, rule))


def _knob(sheet: Robot, group: Sequence[SheetNumber], span: tuple[float, float, float], log: bool) -> Knob:
    data = sheet_data(sheet)
    entries = [real_entry(data, number.path) for number in group]
    reals, factors = [path for path, _ in entries if path], {factor for _, factor in entries}
    common = factors.pop() if len(factors) == 1 else None
    targets, own = tuple((number.path, number.value) for number in group), reals if len(reals) == len(group) else ()
    return Knob(group[0].pattern, targets, *span, log, tuple(own), common, group[0])


def _reach(sheet: Robot, number: SheetNumber, rule: SliderRule) -> tuple[float, float]:
    if rule.span:
        away = rule.span * stretched_length(sheet)
        least = number.value - away if number.least < 0 else max(number.value - away, number.value / rule.reach)
        return least, number.value + away
    if rule.room:
        far = max(rule.reach * abs(number.value), rule.room)
        return (0.0, far) if number.value >= 0 else (-far, 0.0)  # of the other sign it buckles the robot
    return max(number.value / rule.reach, number.least), min(number.value * rule.reach, number.most)


def _log(low: float, rule: SliderRule) -> bool:
    return rule.log and low > 0


OTHER = SliderRule("", "")
"""Of numbers without a rule of their own."""


def rule_of(knob: Knob) -> SliderRule:
    """The rule of a knob."""
    return next((rule for rule in _RULES if re.fullmatch(rule.pattern, knob.pattern)), OTHER)


def stretched_length(robot: Robot) -> float:
    """Length of all links and of what is between them [m]."""
    nodes = robot.chain().nodes
    between = sum(float(np.linalg.norm(node.joint.placement.position)) for node in nodes)
    return between + sum(getattr(node.link, "length", 0.0) for node in nodes)
