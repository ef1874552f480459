"""The four-mass axis of Moberg, Ohr and Gunnarsson: its poles and zeros to all digits that are known of it.

Reference values computed with the matrices of its linear equations by NumPy, from the benchmark's numbers alone.
"""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from scipy.linalg import expm, solve_discrete_are

import tmodes

LOW, HIGH, KNEE = 16.7, 100.0, 0.064
POLES = {
    LOW: [(8.8157, 0.1153), (14.4407, 0.0657), (41.6126, 0.1413)],
    HIGH: [(12.4026, 0.0386), (19.1207, 0.0471), (54.6641, 0.1183)],
}
LOCKED = {LOW: [2.91097, 14.25002, 41.65449], HIGH: [5.25497, 15.37823, 52.32146]}


def axis(**changes: Any) -> tmodes.Robot:
    """The robot with other entries of its sheet."""
    sheet = tmodes.load("moberg2009").model_dump(mode="json", by_alias=True, exclude_none=True)
    return tmodes.Robot.from_data(sheet | {"loads": []} | changes)


def pushed(force: float) -> tmodes.Robot:
    """With a force on the tool, which winds the gear up where the motor is held."""
    return axis(loads=[{"point": "tip", "force": [0, 0, force], "frame": "world"}])


STIFF = 400.0
"""Force on the tool [N] that winds the gear beyond its knee, against a motor that is held."""


def torque(twist: float) -> float:
    """Of the gear, from the equations of motion."""
    return float(tmodes.Model(axis()).inverse_dynamics([twist, 0.0, 0.0, 0.0], np.zeros(4), np.zeros(4))[0])


@pytest.mark.parametrize(("stiffness", "force"), [(LOW, 0.0), (HIGH, STIFF)])
def test_poles_and_zeros_are_those_of_the_benchmark(stiffness: float, force: float) -> None:
    linear = pushed(force).linearize(at={"motor": 0.0}, inputs="motor.effort", outputs="tip.z")
    ringing = linear.poles[linear.poles.imag > 1e-6]
    ringing = ringing[np.argsort(np.abs(ringing))]
    found = [(abs(pole) / (2 * np.pi), -pole.real / abs(pole)) for pole in ringing]
    assert [(f"{f:.4f}", f"{d:.4f}") for f, d in found] == [(f"{f:.4f}", f"{d:.4f}") for f, d in POLES[stiffness]]
    real = np.sort(linear.poles[np.abs(linear.poles.imag) < 1e-6].real)
    assert f"{real[0]:.4f}" == "-0.1915"
    assert abs(real[1]) < 1e-8
    zeros = linear.zeros()
    across = sorted(f"{zero.real:.2f}{zero.imag:+.2f}i" for zero in zeros if abs(zero.imag) > 1e-6)
    assert across == sorted(f"{re}{sign}{im}i" for re, im in (("-7.37", 119.82), ("-43.18", "402.80")) for sign in "+-")
    assert [round(float(zero.real), 2) for zero in zeros if abs(zero.imag) < 1e-6] == [-stiffness / 0.08]


@pytest.mark.parametrize(("stiffness", "force"), [(LOW, 0.0), (HIGH, STIFF)])
def test_frequencies_with_the_motor_locked(stiffness: float, force: float) -> None:
    linear = pushed(force).linearize(at={"motor": 0.0})
    arms = np.linalg.solve(linear.mass[1:, 1:], linear.stiffness[1:, 1:])
    found = np.sqrt(np.sort(np.linalg.eigvals(arms).real)) / (2 * np.pi)
    assert found == pytest.approx(LOCKED[stiffness], abs=6e-6)


def test_gear_hardens_from_the_low_to_the_high_stiffness_at_its_knee() -> None:
    """Torque: low x + (high - low) x^3/(3 knee^2) up to the knee, then a straight line; its energy is its integral."""
    at_knee = LOW * KNEE + (HIGH - LOW) * KNEE / 3
    for twist in (0.01, 0.05, KNEE):
        assert torque(twist) == pytest.approx(LOW * twist + (HIGH - LOW) * twist**3 / (3 * KNEE**2), rel=1e-12)
        assert torque(-twist) == -torque(twist)
    assert torque(0.1) == pytest.approx(at_knee + HIGH * (0.1 - KNEE), rel=1e-12)
    nodes, weights = np.polynomial.legendre.leggauss(4)
    ends = (0.0, KNEE, 0.1)
    work = sum(
        (b - a) / 2 * weight * torque(a + (b - a) / 2 * (1 + node))
        for a, b in pairwise(ends) for node, weight in zip(nodes, weights, strict=True)
    )  # fmt: skip
    energies = tmodes.Model(axis()).energies([0.1, 0.0, 0.0, 0.0], np.zeros(4))
    assert sum(float(part) for part in energies.values()) == pytest.approx(work, rel=1e-12)


def test_all_friction_is_against_the_ground() -> None:
    """Where all four masses turn as one the motor carries their friction, and no spring or damper acts."""
    linear = axis().linearize()
    assert linear.damping @ np.ones(4) == pytest.approx([6e-3, 1e-3, 1e-3, 1e-3], rel=1e-9)
    assert np.abs(linear.stiffness @ np.ones(4)).max() < 1e-10


def test_a_force_on_the_tool_and_a_torque_on_the_shaft_do_what_they_say() -> None:
    linear = axis().linearize(inputs="motor.effort,shaft.moment.z,tip.force.z", outputs="motor.position,tip.z")
    masses, lengths = [5e-3, 2e-3, 0.02, 0.02], np.array([0.0, 0.02, 0.6, 1.53]) / 220
    assert linear.B[4:, 0] == pytest.approx([1 / masses[0], 0, 0, 0])
    assert linear.B[4:, 1] == pytest.approx(linear.B[4:, 0])
    assert linear.B[4:, 2] == pytest.approx(lengths / masses)
    assert linear.C[1, :4] == pytest.approx(lengths)


def row_of(stiffness: tuple[float, ...], own: tuple[float, ...]) -> np.ndarray:
    """Stiffness, or damping, of masses in a row, (4, 4): between neighbours and against the ground."""
    found = np.diag(own).astype(float)
    for k, one in enumerate(stiffness):
        found[k : k + 2, k : k + 2] += one * np.array([[1, -1], [-1, 1]])
    return found


PERIOD = 5e-4


def held_step() -> tuple[np.ndarray, Any]:
    """Lengths (4,) of the tool; x, torque on the motor, force on the tool (10, 10) over a sample, all by SciPy."""
    K, D = row_of((LOW, 110, 80), (0, 0, 0, 0)), row_of((0.08, 0.06, 0.08), (6e-3, 1e-3, 1e-3, 1e-3))
    masses, lengths = np.array([5e-3, 2e-3, 0.02, 0.02]), np.array([0.0, 0.02, 0.6, 1.53]) / 220
    whole = np.zeros((10, 10))
    whole[:4, 4:8] = np.eye(4)
    whole[4:8] = np.column_stack([-K, -D, np.eye(4)[0], lengths]) / masses[:, None]
    return lengths, expm(whole * PERIOD)


def by_exponentials(gains: tuple[float, ...], times: int) -> tuple[np.ndarray, np.ndarray]:
    """Tool [m] and torque [N*m] before each sample under the sheet's loads, without the package: held over 0.5 ms.

    The torque of a sample acts one sample later; the gear has its low stiffness throughout.
    """
    period, (kp, ki, kv, filter_time) = PERIOD, gains
    lengths, step = held_step()
    x, waiting, z, rate, last = np.zeros(8), 0.0, 0.0, 0.0, 0.0
    tools, torques = [], []
    for k in range(times):
        tools.append(lengths @ x[:4])
        rate, last = (filter_time * rate + x[0] - last) / (filter_time + period), x[0]
        given, waiting = waiting, -kp * x[0] + ki * z - kv * rate
        z -= period * x[0]
        torques.append(given)
        x = (step @ [*x, given + (k >= 200), 50.0 * (k >= 2200)])[:8]
    return np.array(tools), np.array(torques)


@pytest.mark.parametrize("gains", [(3.9, 9.0, 0.86, 1e-3), (25.3, 117.0, 3.0, 0.01)])
@pytest.mark.parametrize(("method", "share"), [("auto", 1e-9), ("rk4", 1e-6)])
def test_closed_loop_is_that_of_matrix_exponentials(gains: tuple[float, ...], method: str, share: float) -> None:
    """The sampled PID behind its delay, both disturbances, a gear without hardening: 2.1 s, each sample."""
    sheet = tmodes.load("moberg2009").model_dump(mode="json", by_alias=True, exclude_none=True)
    sheet["parameters"]["gear_stiffness_high"] = LOW
    sheet["integration"] |= {"output_step": 5e-4, "method": method} | ({"step": 5e-4} if method == "rk4" else {})
    names = "position_gain", "integral_gain", "velocity_gain", "filter_time"
    sheet["drives"][0]["controller"] |= dict(zip(names, gains, strict=True))
    result = tmodes.Robot.from_data(sheet).run()
    for name, wanted in zip(("tip.z", "motor.effort"), by_exponentials(gains, 4200), strict=True):
        assert np.abs(np.asarray(result.output(name))[:4200] - wanted).max() < share * np.abs(wanted).max()


def test_regulator_that_estimates_the_load_is_that_of_matrix_exponentials() -> None:
    """LQG with a load of the motor, behind its delay: Riccati equations and loop by SciPy alone, each sample."""
    lengths, step = held_step()
    A, B, c = step[:8, :8], step[:8, 8:9], np.eye(8)[:1]
    Q = np.diag([1e4, 0, 0, 1e4, 0, 0, 0, 30.0])
    X = solve_discrete_are(A, B, Q, np.eye(1))
    gain = np.append(np.linalg.solve(1 + B.T @ X @ B, B.T @ X @ A)[0], 1.0)
    A9, B9, c9 = np.block([[A, B], [np.zeros((1, 8)), np.eye(1)]]), np.append(B, 0.0), np.append(c, 0.0)
    P = solve_discrete_are(A9.T, c9[:, None], np.diag([0, 0, 0, 0, 1e-2, 0, 0, 1e-2, 1e-4]), np.full((1, 1), 1e-6))
    kalman = P @ c9 / (c9 @ P @ c9 + 1e-6)
    x, guess, waiting, tools = np.zeros(8), np.zeros(9), 0.0, []
    for k in range(4200):
        tools.append(lengths @ x[:4])
        after = guess + kalman * (x[0] - c9 @ guess)
        given, waiting = waiting, -gain @ after
        guess = A9 @ after + B9 * waiting
        x = (step @ [*x, given + (k >= 200), 50.0 * (k >= 2200)])[:8]
    sheet = tmodes.load("moberg2009").model_dump(mode="json", by_alias=True, exclude_none=True)
    for key in ("controller", "delay"):
        sheet["drives"][0].pop(key)
    sheet["parameters"]["gear_stiffness_high"] = LOW
    sheet["integration"] |= {"output_step": PERIOD}
    block = {"type": "lqg", "sample_time": PERIOD, "measured": ["encoder"], "measurement_noise": [1e-6],
             "process_noise": {"motor'": 1e-2, "arm3'": 1e-2}, "load_noise": 1e-4,
             "state_weights": {"motor": 1e4, "arm3": 1e4, "arm3'": 30.0}}  # fmt: skip
    sheet["control"] = [{"name": "law", "drives": ["motor"], "delay": PERIOD, "block": block}]
    found = np.asarray(tmodes.Robot.from_data(sheet).run().output("tip.z"))[:4200]
    assert np.abs(found - tools).max() < 1e-9 * np.abs(tools).max()
    late, little = tmodes.Robot.from_data(sheet).run(error_estimate=False).warnings
    assert "delay_in_design" in late
    assert "disk margin" in little
