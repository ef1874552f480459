"""Motions by direct collocation against closed forms of two masses on a spring, and against those by gradients."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.linalg import expm
from scipy.optimize import fsolve

import tmodes
from tmodes.errors import InputError

ROTOR, LINK, SPRING = 0.3, 1.0, 100.0
TURN: dict[str, Any] = {"start": {"joint": 0.0}, "goal": {"joint": 1.0}}


def joint() -> Any:
    """A rotor on a spring that turns a link, without weight [kg*m^2, N*m/rad]."""
    return tmodes.load("spong1987", {"gravity": 0.0})


def test_least_effort_is_that_of_the_gramian() -> None:
    """u = B' exp(A' (T - t)) W^-1 x(T), W the Gramian of T = 1 s, integrated by SciPy."""
    a, b = np.zeros((4, 4)), np.array([0.0, 0.0, 1 / ROTOR, 0.0])
    a[0, 2] = a[1, 3] = 1.0
    a[2, :2], a[3, :2] = [-SPRING / ROTOR, SPRING / ROTOR], [SPRING / LINK, -SPRING / LINK]

    def spread(time: float, known: Any) -> Any:
        del known
        row = expm(a * time) @ b
        return np.outer(row, row).ravel()

    gramian = solve_ivp(spread, (0.0, 1.0), np.zeros(16), rtol=1e-10, atol=1e-14).y[:, -1].reshape(4, 4)
    weights = np.linalg.solve(gramian, [1.0, 1.0, 0.0, 0.0])
    found = joint().motion(**TURN, duration=1.0, method="collocation")
    assert found.warnings == []
    assert found.swing < 1e-6
    times, torques = found.found.knots[:-1], found.found.torques[0, :-1]
    exact = np.array([b @ expm(a.T * (1.0 - time)) @ weights for time in times])
    np.testing.assert_allclose(torques, exact, atol=2e-3 * np.abs(exact).max())
    smooth = joint().motion(**TURN, duration=1.0)
    drive: Any = smooth.robot.drives[0].signal
    square = np.mean(drive.schedule(1.0).at(np.linspace(0.0, 1.0, 2001)) ** 2)
    assert float(weights @ gramian @ weights) < square
    assert smooth.swing < 1e-6


def test_least_time_is_that_of_full_torque_to_and_fro() -> None:
    """Switched at t1, T / 2, T - t1: with a = T / 2 - t1 the mode stands, 1 - 2 cos wa + cos wT/2 = 0, and
    U (T^2 / 4 - 2 a^2) = (J + I) angle."""
    most, wave = 20.0, np.sqrt(SPRING * (1 / ROTOR + 1 / LINK))
    switches: Any = fsolve(lambda x: [1 - 2 * np.cos(wave * x[0]) + np.cos(wave * x[1]),
                                most * (x[1] ** 2 - 2 * x[0] ** 2) - ROTOR - LINK], [0.03, 0.26])  # fmt: skip
    found = joint().motion(**TURN, duration=1.0, torque="joint=20", least_time=True, method="collocation")
    assert found.warnings == []
    assert found.duration == pytest.approx(2 * switches[1], rel=1e-3)
    assert found.duration >= 2 * switches[1]
    assert found.data["torque"].max() == pytest.approx(most, rel=1e-6)
    assert found.swing < 1e-6
    with pytest.raises(InputError, match="a joint without a limit of effort"):
        joint().motion(**TURN, duration=1.0, least_time=True, method="collocation")


def test_weight_and_limits_count() -> None:
    """The joint lifts its link within a speed; the motor holds it there afterwards."""
    robot = tmodes.load("spong1987")
    found = robot.motion(**TURN, duration=1.0, speed={"joint": 1.6}, method="collocation")
    assert found.warnings == []
    assert found.swing < 1e-6
    assert found.data["motor_speed"].max() == pytest.approx(1.6, rel=1e-3)
    assert found.found.torques[0, -1] == pytest.approx(9.8 * np.sin(found.result.data["q"].values[-1, 1]), rel=1e-3)
    with pytest.raises(InputError, match=r"(?i)method.*did you mean `collocation`"):
        robot.motion(**TURN, method="colocation")
