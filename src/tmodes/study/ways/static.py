"""Numbers of robots at rest: no simulation."""

from __future__ import annotations

import time as clock
from collections.abc import Callable, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.describe.describe import sag
from tmodes.analysis.modes.of_sheet import frequencies_about
from tmodes.analysis.statics.equilibrium import robot_rest
from tmodes.errors import InputError, InputErrors, SimulationError
from tmodes.sheet import Robot
from tmodes.study.quantities import Needs
from tmodes.study.ways.part import Part

__all__ = ["by_statics"]

Array = NDArray[np.float64]


def by_statics(robot: Robot, vary: Mapping[str, Array], needs: Needs, progress: Callable[[str, float], None]) -> Part:
    """Static numbers of the cases ``vary`` (m,) of one robot; raises InputError for a name that is unknown."""
    size = len(next(iter(vary.values())))
    part = Part.of_all(size, "finished")
    part.numbers = {name: np.full(size, np.nan) for name in needs.static}
    for k in range(size):
        began = clock.process_time()
        try:
            real = robot.with_({path: float(values[k]) for path, values in vary.items()}).pair().real
            for name, (value, unit) in _numbers(real, needs.static).items():
                part.numbers[name][k], part.units[name] = value, unit
        except SimulationError as error:
            part.status[k], part.reason[k] = "failed", str(error)
        except InputErrors as errors:
            part.status[k], part.reason[k] = "refused", str(errors)
        part.seconds[k] = clock.process_time() - began
        progress("statics", (k + 1) / size)
    return part


def _numbers(robot: Robot, names: Sequence[str]) -> dict[str, tuple[float, str]]:
    rest = robot_rest(robot)
    info, found = sag(rest), {}
    states = frequencies_about(robot, rest) if any(name.startswith("frequency.") for name in names) else {}
    for name in names:
        match name.split("."):
            case ["sag"]:
                found[name] = info["displacement_size_m"], "m"
            case ["sag", ("x" | "y" | "z") as axis]:
                found[name] = info["displacement_m"]["xyz".index(axis)], "m"
            case ["frequency", state, number] if state in states and number.isdecimal():
                modes = states[state]
                found[name] = (modes[int(number) - 1]["frequency_Hz"] if int(number) <= len(modes) else np.nan), "Hz"
            case _:
                expected = "sag, sag.z, frequency.locked.1"
                raise InputError("static", f"the unknown name {name!r}", expected, "write one of these")
    return found
