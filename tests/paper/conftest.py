"""The paper's robot, and the bridge from the oracle's symbols to the package's paths."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np
import pytest

from tmodes.paper.mechanism import Parameters
from tmodes.paper.sheet import PaperRobot
from tmodes.robots import load_robot

PATHS = {
    "g": "gravity", "R": "motor.resistance", "CE": "motor.back_emf_constant", "CM": "motor.torque_constant",
    "I": "motor.inertia", "Bm": "motor.friction", "Cxi": "gear.stiffness", "Bxi": "gear.damping",
    "l1": "link.modes.0.length", "l2": "link.modes.1.length", "w1": "link.modes.0.mass_per_length",
    "w2": "link.modes.1.mass_per_length", "m": "payload.mass", "Jzz": "payload.inertia", "me": "environment.mass",
    "be": "environment.damping", "Fc0": "environment.preload", "ka1": "environment.stiffness",
    "mu": "environment.friction", "veps": "environment.friction_velocity",
}  # fmt: skip


@pytest.fixture(scope="session")
def robot() -> PaperRobot:
    """The paper's robot as shipped."""
    return load_robot("filipovic2010")


@pytest.fixture(scope="session")
def to_parameters(robot: PaperRobot) -> Callable[[Mapping[str, float]], Parameters]:
    """Parameters of the package from the oracle's symbols (Cs, Bs become EI and eta)."""

    def convert(symbols: Mapping[str, float]) -> Parameters:
        numbers = dict(robot.numbers()) | {path: symbols[symbol] for symbol, path in PATHS.items()}
        for k in (1, 2):
            numbers[f"link.modes.{k - 1}.bending_stiffness"] = symbols[f"Cs{k}"] * symbols[f"l{k}"] ** 3 / 3
            numbers[f"link.modes.{k - 1}.damping_time"] = symbols[f"Bs{k}"] / symbols[f"Cs{k}"]
        return Parameters(tuple(numbers), np.array(list(numbers.values())))

    return convert
