"""Runs for the benchmark of gradients: what is run, by which numbers it is differentiated, and differences to compare.

Differences are of sixth order on the same steps: with other parameters, from another start, by other signals.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.gradients.changes import changes_of, number_at
from tmodes.gradients.lowering import lowered
from tmodes.gradients.quantities import Functional, Quantities, tracking_error
from tmodes.io.sheet_check import sheet_data
from tmodes.robots.load import load
from tmodes.simulation.solve import solve

from .stiff_arm import stiff_arm

__all__ = ["DURATION", "Case", "cases"]

Array = NDArray[np.float64]

DURATION = 2.0
"""Of every run [s]."""

_ROBOT = (
    "motor.resistance", "motor.torque_constant", "motor.back_emf_constant", "motor.inertia", "gear.stiffness",
    "gear.damping", "link.modes.0.length", "link.modes.0.bending_stiffness", "link.modes.0.mass_per_length",
    "link.modes.0.damping_time", "link.modes.1.length", "link.modes.1.bending_stiffness",
    "link.modes.1.mass_per_length", "link.modes.1.damping_time", "payload.mass", "payload.inertia",
    "controller.position_gain", "controller.velocity_gain", "motor.friction", "reference.end",
)  # fmt: skip


_MULTIPLES = (1, 2, 3, 4, 6)


class Case:
    """One run, the squared distance of its tip from where it ends, and the numbers by which that is differentiated."""

    def __init__(self, name: str, sheet: Any, paths: tuple[str, ...], each: int = 1) -> None:
        """``each``: one of so many numbers is compared with differences, of runs that take long."""
        self.name, self.sheet, self.paths, self.compared = name, sheet, paths, paths[::each]
        self.here = lowered(sheet)
        self.replay = self.here.recorded()
        done = self.replay.recording
        tip = Quantities(self.here, done, ("tip",)).info()["tip"]
        self.functional: Functional = tracking_error("tip", tip[-1])
        self.values = {path: number_at(path, sheet_data(sheet)) for path in paths}

    def run(self) -> Any:
        """The run alone, from its plan on."""
        here = self.here
        return solve(here.setup.problem())

    def differences(self, path: str, step: float) -> tuple[float, float]:
        """Derivative of the functional by the logarithm of a number, and by how much twice the step changes it."""
        change = changes_of(self.sheet, self.here, self.replay, [path])[path]
        value = self.values[path]
        apart = {k: self._moved(change, k * step * value) - self._moved(change, -k * step * value) for k in _MULTIPLES}
        near, far = ([apart[k * times] / (2 * k * times * step) for k in (1, 2, 3)] for times in (1, 2))
        found, other = ((15 * ways[0] - 6 * ways[1] + ways[2]) / 10 for ways in (near, far))
        return found, abs(found - other)

    def _moved(self, change: Any, by: float) -> float:
        """The functional on the same steps with numbers changed along a direction."""
        here, done = self.here, self.replay.recording
        parameters = here.parameters + by * change.parameters
        other = replace(done, rows=done.rows + by * change.rows)
        self.replay.recording = other
        samples = self.replay.samples(parameters, here.start + by * change.start)
        self.replay.recording = done
        seen = Quantities(replace(here, parameters=parameters), replace(other, samples=samples), ("tip",))
        return self.functional.measure(done.times, seen.info())[0]


def cases() -> dict[str, Callable[[], Case]]:
    """The runs by name: the seed's robot, an industrial arm with elastic gears, the stiff arm of the benchmarks."""
    info = {"integration.duration": DURATION}
    joints = [f"joints.panda_joint{k}" for k in range(1, 8)]
    panda = [f"{joint}.gear.{what}" for joint in joints for what in ("stiffness", "damping")]
    panda += [f"{joint}.motor.inertia" for joint in joints[:3]]
    panda += [f"drives.{k}.controller.position_gain" for k in range(3)]
    stiff = [f"joints.j{k}.gear.stiffness" for k in range(6)] + [f"links.l{k}.beam.section.thickness" for k in range(6)]
    stiff += [f"joints.j{k}.motor.inertia" for k in range(4)] + [
        f"drives.{k}.controller.position_gain" for k in range(4)
    ]
    return {
        "seed": lambda: Case("filipovic2010", load("filipovic2010").with_(info), _ROBOT),
        "panda": lambda: Case("panda_elastic", load("panda_elastic").with_(info), tuple(panda)),
        "stiff": lambda: Case("stiff arm, 54", stiff_arm(duration=DURATION, method="extrapolation"), tuple(stiff), 5),
    }
