"""Which setting of a live report stands for a parameter of a study, and what its value is multiplied by there."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from tmodes.errors import InputError
from tmodes.io.sheet_check import sheet_data
from tmodes.io.sheet_groups import is_grouped
from tmodes.io.sheet_paths import steps_of
from tmodes.live.knobs import REAL
from tmodes.live.sheet_numbers import sheet_numbers
from tmodes.sheet.robot import Robot

__all__ = ["Setting", "ahead_of", "setting_of"]


@dataclass(frozen=True)
class Setting:
    """The path of a slider, what a parameter's value is multiplied by there, and the ends that it must reach."""

    path: str
    factor: float
    low: float
    high: float


def setting_of(robot: Robot, path: str, ends: tuple[float, float], *, relative: bool) -> Setting | None:
    """The setting that does what a study's path does; None where a report can have none.

    ``ends``: least and largest value of the parameter; ``relative``: they are factors on the sheet's own number.
    """
    if is_grouped(path) and not path.startswith(REAL):
        return Setting(path, 1.0, *ends)
    real = path.startswith((REAL, "real."))
    number = _number(robot, path.removeprefix(REAL).removeprefix("real."))
    if number is None:
        return None
    own, value = number
    factor = 1.0
    if relative:
        factor = robot.real.get(path.removeprefix("real."), 1.0) if real else value
    low, high = sorted(factor * end for end in ends)
    return Setting(f"{REAL}{own}" if real else own, factor, low, high)


def _number(robot: Robot, path: str) -> tuple[str, float] | None:
    """The one number that stands at a path, or in the list there."""
    data = sheet_data(robot)
    try:
        steps = steps_of(path, data)
    except InputError:
        return None
    found = []
    for number in sheet_numbers(robot):
        own = steps_of(number.path, data)
        if own[: len(steps)] == steps:
            found.append((number.path, number.value))
    return found[0] if len(found) == 1 else None


def ahead_of(settings: Mapping[str, Setting]) -> dict[str, tuple[float, float]]:
    """What the live report must offer for these settings, of single numbers."""
    return {one.path: (one.low, one.high) for one in settings.values() if "*" not in one.path.split(".")}
