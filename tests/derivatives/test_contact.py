"""Derivatives over the onset of a contact: as a closed form has them where the force is continuous, else refused."""

from __future__ import annotations

import cmath

import numpy as np
import pytest

from simulation.sheets import landing
from tmodes.errors import SimulationError
from tmodes.gradients.gradient import adjoint_gradient, forward_sensitivities
from tmodes.gradients.quantities import tracking_error

HEIGHT, STIFFNESS, MASS, GRAVITY = 0.05, 2e3, 1.5, 9.81


def height(begin: complex, time: float) -> complex:
    """Free fall onto a spring that only pushes, before it lets go."""
    touch, speed = cmath.sqrt(2 * begin / GRAVITY), cmath.sqrt(2 * begin * GRAVITY)
    if time < touch.real:
        return begin - GRAVITY * time**2 / 2
    rate, later = np.sqrt(STIFFNESS / MASS), time - touch
    return -GRAVITY / rate**2 * (1 - cmath.cos(rate * later)) - speed / rate * cmath.sin(rate * later)


@pytest.mark.parametrize("method", ["dormand_prince", "dop853", "rk4", "extrapolation"])
def test_a_spring_that_sets_in(method: str) -> None:
    sheet = landing(damping=0.0, stiffness=STIFFNESS, duration=0.16, method=method)
    run = forward_sensitivities(sheet, ["initial.coordinates.s"])
    wanted = [height(complex(HEIGHT, 1e-30), time).imag / 1e-30 for time in run.times]
    assert run.states[:, 0].min() < -0.01
    assert np.abs(run.by["initial.coordinates.s"][:, 0] - wanted).max() < 1e-6


@pytest.mark.parametrize("method", ["auto", "rk4"])
def test_a_damper_that_sets_in_is_refused(method: str) -> None:
    """Its force jumps with the speed of impact: that the impact comes later from higher up would be left out."""
    sheet = landing(damping=20.0, stiffness=STIFFNESS, duration=0.16, method=method)
    with pytest.raises(SimulationError, match=r"force jumps there.*before"):
        adjoint_gradient(sheet, tracking_error("tip", [0.0, 0.0, 0.0]), ["initial.coordinates.s"])
    free = sheet.with_({"integration.duration": 0.1})
    assert forward_sensitivities(free, ["initial.coordinates.s"]).by["initial.coordinates.s"][-1, 0] == pytest.approx(1)
