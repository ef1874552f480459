"""Which numbers of a run a page may change: found among those of the data sheet, the most useful first."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from tmodes.io.sheet_check import sheet_data
from tmodes.io.sheet_groups import group_path, real_entry
from tmodes.live.sheet_numbers import SheetNumber, sheet_numbers
from tmodes.sheet import Robot

__all__ = ["MOST", "Knob", "Slider", "knobs_of", "sliders_of", "stretched_length"]

MOST = 16
"""Sliders of a page."""


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


@dataclass(frozen=True)
class Slider:
    """A knob that a page shows, as it is known (``real`` False) or as the factor of the actual robot on it."""

    knob: int
    real: bool
    path: str
    label: str
    symbol: str
    unit: str
    group: str
    value: float
    low: float
    high: float
    log: bool

    def changes(self, knob: Knob, value: float) -> dict[str, float]:
        """What ``--set`` is to change, path and value, where the slider stands at ``value``."""
        if self.real:
            return {f"real.{path}": value for path in knob.reals}
        return knob.changes(value)

    def info(self) -> dict[str, Any]:
        """As ``Slider`` of ``web/src/contract.ts``."""
        return {
            "path": self.path, "label": self.label, "symbol": self.symbol, "unit": self.unit, "group": self.group,
            "value": self.value, "min": self.low, "max": self.high, "log": self.log,
        }  # fmt: skip


class _Rule(NamedTuple):
    """A kind of number that is worth a slider: its path, its group, how far it goes, and whether the real one differs.

    ``reach``: the largest value over the present one (the least is its inverse); ``room``: how far a number that
    may be zero goes at least; ``span``: how far one goes both ways, as a share of the robot's length. ``words``: its
    label where the sheet's own words do not say whose it is.
    """

    pattern: str
    group: str
    reach: float = 4.0
    real: bool = False
    room: float = 0.0
    log: bool = True
    span: float = 0.0
    words: str = ""


_RULES = (
    _Rule(r"links\.\*\.bodies\.\*\.mass", "payload", 3.0, log=False),
    _Rule(r"joints\.\*\.gear\.stiffness(\.0)?(\.\*)?", "gear", real=True),
    _Rule(r"links\.\*\.beam\.modes\.\*\.bending_stiffness", "links", real=True),
    _Rule(r"links\.\*\.beam\.(section\.bending_stiffness(\.\*)?|material\.young)", "links", real=True),
    _Rule(r"drives\.\*\.signal\.duration", "move", 2.0),
    _Rule(r"drives\.\*\.controller\.position_gain", "controller"),
    _Rule(r"drives\.\*\.controller\.velocity_gain", "controller"),
    _Rule(r"contact\.stiffness", "environment"),
    _Rule(r"contact\.shape\.distance", "environment", span=0.03, log=False, words="distance of the wall"),
    _Rule(r"contact\.shape\.radius", "environment", span=0.03, log=False, words="radius of the surface touched"),
    _Rule(r"contact\.shape\.position\.\*", "environment", span=0.03, log=False, words="place of the surface along {}"),
    _Rule(r"contact\.damping", "environment"),
    _Rule(r"contact\.friction", "environment", 3.0, log=False),
    _Rule(r"contact\.preload", "environment", 3.0, room=20.0, log=False),
    _Rule(r"joints\.\*\.gear\.damping", "gear", real=True),
    _Rule(r"links\.\*\.beam\.(modes\.\*\.)?damping_time", "links"),
    _Rule(r"joints\.\*\.motor\.(inertia|friction\.viscous)", "motor"),
    _Rule(r"joints\.\*\.friction\.viscous", "motor"),
)
_ALONE = 2
"""Numbers of a kind that have a slider each; more of them move together."""


def knobs_of(sheet: Robot) -> list[Knob]:
    """All that a page could change, the most useful first; a zero, where structure may hang on it, stays as it is."""
    numbers = list(sheet_numbers(sheet))
    found: list[Knob] = []
    for rule in _RULES:
        kinds: dict[str, list[SheetNumber]] = {}
        for number in numbers:
            if re.fullmatch(rule.pattern, number.pattern) and _useful(sheet, number, rule):
                kinds.setdefault(number.pattern, []).append(number)
        for group in kinds.values():
            found += _knobs(sheet, group, rule)
    return found


def _useful(sheet: Robot, number: SheetNumber, rule: _Rule) -> bool:
    """A payload is on the link with its tip; a plane moves along its normal; a slider is finite."""
    if not math.isfinite(number.value):
        return False
    if number.pattern == "contact.shape.position.*":
        return sheet.contact is not None and int(number.path[-1]) == sheet.contact.shape.steep_axis
    if number.pattern == "links.*.bodies.*.mass":
        tip = sheet.tip.link if sheet.tip else sheet.links[-1].name if sheet.links else ""
        return number.owner == tip and number.value > 0
    return number.value > 0 or (rule.room > 0 and number.least < 0)


def _knobs(sheet: Robot, group: Sequence[SheetNumber], rule: _Rule) -> Iterator[Knob]:
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


def _reach(sheet: Robot, number: SheetNumber, rule: _Rule) -> tuple[float, float]:
    if rule.span:
        away = rule.span * stretched_length(sheet)
        least = number.value - away if number.least < 0 else max(number.value - away, number.value / rule.reach)
        return least, number.value + away
    if rule.room:
        far = max(rule.reach * abs(number.value), rule.room)
        return (0.0, far) if number.value >= 0 else (-far, 0.0)  # of the other sign it buckles the robot
    return max(number.value / rule.reach, number.least), min(number.value * rule.reach, number.most)


def _log(low: float, rule: _Rule) -> bool:
    return rule.log and low > 0


def _label(number: SheetNumber, knob: Knob) -> str:
    """What a knob moves, and whose: ``bending stiffness about z, forearm``."""
    words, owner = re.split("[,;]", number.meaning)[0], number.owner
    if knob.together:
        return f"{words}, all {'motors' if '.motor.' in knob.pattern else knob.pattern.partition('.')[0]}"
    steps = number.path.split(".")
    if words.endswith("about y and about z"):
        words = words.replace("about y and about z", f"about {'yz'[int(steps[-1])]}") if steps[-1] in "01" else words
    if "modes" in steps[:-1]:
        owner = f"mode {int(steps[steps.index('modes') + 1]) + 1} of {owner}"
    if "bodies" in steps and steps[-2] != owner and not steps[-2].isdecimal():
        owner = f"{steps[-2]} on {owner}"
    return f"{words}, {owner}" if owner else words


def sliders_of(sheet: Any, knobs: Sequence[Knob], most: int = MOST, *, factors: bool = True) -> list[Slider]:
    """The sliders of these knobs, each as known and, where it makes sense, as the factor of the actual robot.

    Without ``factors`` all are as known.
    """
    found, data = list[Slider](), sheet_data(sheet)
    for index, knob in enumerate(knobs):
        if len(found) >= most:
            break
        number = knob.first
        rule = next(rule for rule in _RULES if re.fullmatch(rule.pattern, knob.pattern))
        label = rule.words.format("xyz"[int(number.path[-1])] if "{" in rule.words else "") or _label(number, knob)
        path, unit = number.path, number.unit
        if knob.together:
            path, unit = group_path(knob.pattern, [own for own, _ in knob.targets], data), "-"
        shown = f"{label}: times the sheet's" if knob.together else label
        own = (path, shown, number.symbol, unit, rule.group, knob.start, knob.low, knob.high, knob.log)
        found.append(Slider(index, False, *own))
        if factors and rule.real and knob.factor and knob.reals:
            low, high = min(knob.factor, 0.2) / 2, 2 * max(knob.factor, 1.0)
            real = (f"real:{path}", f"{label}: actual / nominal", number.symbol, "-", rule.group)
            found.append(Slider(index, True, *real, knob.factor, low, high, log=True))
    return found[:most]


def stretched_length(robot: Robot) -> float:
    """Length of all links and of what is between them [m]."""
    nodes = robot.chain().nodes
    between = sum(float(np.linalg.norm(node.joint.placement.position)) for node in nodes)
    return between + sum(getattr(node.link, "length", 0.0) for node in nodes)
