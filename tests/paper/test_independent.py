"""Whole runs against the oracle's terms: no equation of the package is used to judge what it found."""

from __future__ import annotations

import numpy as np
import pytest

from oracle.oracle import contact_map, oracle
from oracle.parameters import with_equivalents
from paper.conftest import PATHS
from tmodes.analysis.spectrum import MotorState
from tmodes.paper.mechanism import Drive, Reading
from tmodes.paper.modes import vibration_modes
from tmodes.paper.regime import run_paper
from tmodes.paper.simulate import simulate

FINE = {
    "integration.duration": 0.6, "integration.output_step": 1e-4,
    "integration.relative_tolerance": 1e-12, "integration.absolute_tolerance": 1e-15,
}  # fmt: skip
INSTANTS = (30, 700, 2111, 3990, 4010, 5500)
STEP = FINE["integration.output_step"]
WITH_MOTOR = np.array([1.0, 0, 1, 0, 0, 1])
"""How the coordinates move with the motor when nothing deforms."""
# Columns: th11q, th12d, th11m, th12e, xi, as q, delta, gamma, vt, e, theta move with each alone.
BENT = np.array(
    [[1, 0.5, 0, 0, 0, 0], [0, 1, 0, 0, 0, 0], [0, 0, 0, 1, 0.5, 0], [0, 0, 0, 0, 1, 0], [1, 0, 1, 0, 0, 0]]
).T


def symbols(robot) -> dict[str, float]:
    """The oracle's parameters of a robot."""
    numbers = dict(robot.numbers())
    data = {symbol: numbers[path] for symbol, path in PATHS.items()}
    for k in "12":
        data[f"EI{k}"] = numbers[f"link.modes.{int(k) - 1}.bending_stiffness"]
        data[f"eta{k}"] = numbers[f"link.modes.{int(k) - 1}.damping_time"]
    return with_equivalents(data)


def derivative(samples, at):
    """First derivative by time, central, of order 6."""
    weights = np.array([-1, 9, -45, 0, 45, -9, 1]) / 60
    return weights @ samples[at - 3 : at + 4] / STEP


@pytest.fixture(scope="module", params=[(reading, touch) for reading in Reading for touch in (False, True)], ids=str)
def finely(request, robot):
    """A finely sampled run of either reading, in free space and in contact."""
    reading, touch = request.param
    changed = robot.with_({**FINE, "reading": reading.value, "contact": touch})
    return changed, simulate(changed).data


def test_run_moves_as_the_oracle(finely):
    """The rates of a run change as the oracle's accelerations at the voltage of (41) say, and so does its force."""
    robot, data = finely
    real, wanted = robot.pair().real, robot.reference.schedule()
    for k in INSTANTS:
        phi, phid, time = data["q"].values[k], data["v"].values[k], float(data["time"][k])
        voltage = 2000 * (wanted.at(time) - phi[5]) + 20 * (wanted.at(time, 1) - phid[5])
        found = oracle(phi, phid, float(voltage), symbols(real), robot.reading.value, robot.contact)
        moved = derivative(data["v"].values, k)
        assert np.abs(moved - found["phidd"]).max() < 1e-5 * max(1.0, np.abs(found["phidd"]).max()), k
        assert float(data["voltage"][k]) == pytest.approx(float(voltage), rel=1e-9)
        if robot.contact:
            assert data["contact_force"].values[k] == pytest.approx(found["F_tip_on_environment"], abs=1e-7)


def test_voltage_of_the_reference_moves_the_oracle_along_it(finely):
    """Fed with the voltage that the prescribed motor asks for, the known robot accelerates as theta_o''."""
    robot, data = finely
    regime = run_paper(robot.pair().nominal, Drive.PRESCRIBED)
    taken = regime.trajectory
    assert np.array_equal(data["q_reference"].values, taken.states[:, :6])
    seen = regime.model.observe(taken.times, taken.states, regime.rows, regime.parameters)
    for k in INSTANTS:
        phi, phid = taken.states[k, :6], taken.states[k, 6:12]
        found = oracle(phi, phid, seen["voltage"][k], symbols(robot), robot.reading.value, robot.contact)
        assert found["phidd"][5] == pytest.approx(robot.reference.schedule().at(taken.times[k], 2), abs=1e-9)
        assert np.abs(found["phidd"] - seen["acceleration"][k]).max() < 1e-8 * np.abs(found["phidd"]).max()


def test_stationary_part_holds_the_loads(finely):
    """At T_st the rows of all five deformations balance: gravity, inertia of the motor's motion, contact."""
    robot, data = finely
    p, full = symbols(robot.pair().real), robot.reading is Reading.CONSISTENT
    for k in INSTANTS:
        theta, rate = data["q"].values[k, 5], data["v"].values[k, 5]
        phi = theta * WITH_MOTOR + BENT @ data["deformation_stationary"].values[k]
        found = oracle(phi, rate * WITH_MOTOR, 0.0, p, robot.reading.value, contact=False)
        rows = found["H"] @ WITH_MOTOR * derivative(data["v"].values, k)[5] + found["h"] + found["f_el"]
        if robot.contact:
            rows += contact_map(phi, p, full) @ data["contact_force"].values[k]
        assert np.abs(BENT.T @ rows).max() < 1e-6, k


def test_bending_moment_is_that_of_the_seen_accelerations(finely):
    """d'Alembert with accelerations differenced from the positions: moment at every station, both modes and planes."""
    robot, data = finely
    first, second = robot.pair().real.link.modes
    masses = (first.tip_mass, second.tip_mass + robot.payload.mass)
    inertias = (first.tip_inertia, second.tip_inertia + robot.payload.inertia)
    line, angles, q = data["line"].values, data["deformation"].values, data["q"].values
    ends = (line[:, 0, -1], line[:, 1, -1])
    turns = np.stack([q[:, 0] + angles[:, 0] / 2, q[:, 3] + angles[:, 2] / 2], axis=1)
    slopes = (turns, turns + 1.5 * angles[:, [1, 3]])
    bend = np.array([2, -27, 270, -490, 270, -27, 2]) / 180 / STEP**2
    for k in INSTANTS[1:]:
        near = slice(k - 3, k + 4)
        loads = [-m * (bend @ end[near] + [0, 0, robot.gravity]) for m, end in zip(masses, ends, strict=True)]
        loads[1] = loads[1] - (data["contact_force"].values[k] if robot.contact else 0)
        for mode in (0, 1):
            azimuth = q[k, : mode + 1].sum()
            axes = np.array([[0, 0, 1], [np.sin(azimuth), -np.cos(azimuth), 0]])
            for station, point in enumerate(line[k, mode]):
                moment = np.zeros(2)
                for end, load, inertia, slope in list(zip(ends, loads, inertias, slopes, strict=True))[mode:]:
                    moment += axes @ np.cross(end[k] - point, load) - inertia * (bend @ slope[near])
                assert data["bending_moment"].values[k, mode, :, station] == pytest.approx(moment, abs=2e-6)


@pytest.mark.parametrize("touch", [False, True])
@pytest.mark.parametrize("state", list(MotorState))
@pytest.mark.parametrize("reading", list(Reading))
def test_frequencies_are_those_of_the_oracle(robot, reading, state, touch):
    """Eigenvalues of the oracle's accelerations, differenced about rest, in every state of the motor."""
    robot = robot.with_({"reading": reading.value, "payload.mass": 1.5, "controller.position_gain": 150.0})
    rest = run_paper(robot.with_({"contact": touch}), Drive.CONTROLLED, until=0.0).trajectory.states[0, :6]
    p, count, small = symbols(robot), 5 if state is MotorState.LOCKED else 6, 2e-6
    if state is MotorState.LOCKED:
        p["I"] = 1e15

    def accelerate(x):
        phi, phid = rest + x[:6], x[6:]
        volts = -150.0 * x[5] - 20.0 * phid[5] if state is MotorState.CONTROLLED else p["CE"] * phid[5]
        return oracle(phi, phid, volts, p, reading.value, touch)["phidd"]

    slopes = np.array([(accelerate(d) - accelerate(-d)) / (2 * small) for d in small * np.eye(12)]).T
    keep = [*range(count), *range(6, 6 + count)]
    system = np.vstack([np.eye(12)[6:], slopes])[np.ix_(keep, keep)]
    ringing = sorted((value for value in np.linalg.eigvals(system) if value.imag > 1e-3), key=lambda value: value.imag)
    modes = vibration_modes(robot, state, contact=touch)
    found = sorted((mode for mode in modes if mode.damped_frequency_Hz), key=lambda mode: mode.damped_frequency_Hz or 0)
    assert [mode.damped_frequency_Hz for mode in found] == pytest.approx(
        [v.imag / 2 / np.pi for v in ringing], rel=1e-6
    )
    assert [mode.damping_ratio for mode in found] == pytest.approx([-v.real / abs(v) for v in ringing], abs=1e-6)
