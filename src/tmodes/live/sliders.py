"""The sliders of a page: each knob as it is known, and as the factor of the actual robot on it."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from tmodes.io.sheet_check import sheet_data
from tmodes.io.sheet_groups import group_path
from tmodes.kinds.schema.quantity import LARGEST
from tmodes.live.knobs import REAL, Ahead, Knob, rule_of
from tmodes.live.sheet_numbers import SheetNumber

__all__ = ["MOST", "Slider", "sliders_of"]

MOST = 16
"""Sliders that lead in a page, and all of a studio."""


@dataclass(frozen=True)
class Slider:
    """A knob that a page shows, as it is known (``real`` False) or as the factor of the actual robot on it.

    ``design``: a design variable; else it is of a material, the surroundings or the task, or known of the actual robot.
    ``least``, ``most``: what the sheet takes, None: any number.
    """

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
    design: bool = False
    least: float | None = None
    most: float | None = None

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
            "design": self.design,
            **{name: end for name, end in (("least", self.least), ("most", self.most)) if end is not None},
        }  # fmt: skip


_VECTORS = ("position", "center", "axis", "gravity", "normal", "velocity", "force", "moment")


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
    if "bodies" in steps and (body := steps[steps.index("bodies") + 1]) != owner and not body.isdecimal():
        owner = f"{body} on {owner}"
    if steps[-1] in ("0", "1", "2") and steps[-2] in _VECTORS:
        words = f"{words} along {'xyz'[int(steps[-1])]}"
    if steps[-2:-1] == ["rpy"]:
        words = ("roll", "pitch", "yaw")[int(steps[-1])]
    return f"{words}, {owner}" if owner else words


def _whose(number: SheetNumber) -> str:
    """The part of the robot that a number is of: ``link forearm``, ``drive shoulder``, ``contact``."""
    kind = number.path.split(".")[0].replace("_", " ")
    return f"{kind.removesuffix('s')} {number.owner}" if number.owner else kind


def sliders_of(sheet: Any, knobs: Sequence[Knob], most: int = MOST, *, ahead: Ahead | None = None) -> list[Slider]:
    """The sliders of these knobs, each as known and, where it makes sense, as the factor of the actual robot.

    ``ahead`` as of :func:`knobs_of`.
    """
    found, data, ahead = list[Slider](), sheet_data(sheet), ahead or {}
    for index, knob in enumerate(knobs):
        if len(found) >= most:
            break
        number = knob.first
        rule = rule_of(knob)
        group = rule.group or _whose(number)
        label = rule.words.format("xyz"[int(number.path[-1])] if "{" in rule.words else "") or _label(number, knob)
        path, unit = number.path, number.unit
        if knob.together:
            path, unit = group_path(knob.pattern, [own for own, _ in knob.targets], data), "-"
        shown = f"{label}: factor" if knob.together else label
        own = (path, shown, number.symbol, unit, group, knob.start, knob.low, knob.high, knob.log)
        whole = number.value if knob.together else 1.0
        ends = (end / whole if abs(end) < LARGEST else None for end in (number.least, number.most))
        found.append(Slider(index, False, *own, rule.design, *ends))
        span = ahead.get(REAL + path)
        if (rule.real or span) and knob.factor and knob.reals:
            low, high = min(knob.factor, 0.2) / 2, 2 * max(knob.factor, 1.0)
            low, high = (min(low, span[0]), max(high, span[1])) if span else (low, high)
            real = (f"real:{path}", f"{label}: actual / nominal", number.symbol, "-", group)
            found.append(Slider(index, True, *real, knob.factor, low, high, log=True))
    return found[:most]
