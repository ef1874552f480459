"""Whole runs against the oracle's terms: no equation of the package is used to judge what it found."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import tmodes
from lagrange.robot2010 import TO_PAPER, symbols
from oracle.line import line
from oracle.oracle import contact_map, oracle
from tmodes.analysis.modes.of_sheet import sheet_frequencies
from tmodes.analysis.statics.at_rest import robot_rest
from tmodes.simulation.plan import planned

FINE = {
    "integration.duration": 0.6, "integration.output_step": 1e-4,
    "integration.relative_tolerance": 1e-12, "integration.absolute_tolerance": 1e-15,
}  # fmt: skip
INSTANTS = (700, 2111, 3990, 4010, 5500)
STEP = FINE["integration.output_step"]
WITH_MOTOR = np.array([1.0, 0, 1, 0, 0, 1])
"""How the coordinates move with the motor when nothing deforms."""
# Columns: xi, th11q, th12d, th11m, th12e, as q, delta, gamma, vt, e, theta move with each alone.
BENT = np.array(
    [[1, 0, 1, 0, 0, 0], [1, 0.5, 0, 0, 0, 0], [0, 1, 0, 0, 0, 0], [0, 0, 0, 1, 0.5, 0], [0, 0, 0, 0, 1, 0]]
).T


def derivative(samples, at):
    """First derivative by time, central, of order 6."""
    weights = np.array([-1, 9, -45, 0, 45, -9, 1]) / 60
    return weights @ samples[at - 3 : at + 4] / STEP


@pytest.fixture(
    scope="module", params=[(reading, touch) for reading in ("printed", "consistent") for touch in (False, True)],
    ids=str,
)  # fmt: skip
def finely(request: Any, robot: Any) -> Any:
    """A finely sampled run of either reading, in free space and in contact: in the paper's coordinates."""
    reading, touch = request.param
    changed = robot.with_({**FINE, "reading": reading, "contact": touch})
    data = tmodes.run(changed).data
    return changed, data, {name: data[name].values @ TO_PAPER.T for name in ("q", "v", "q_nominal", "v_nominal")}


def terms_at(robot, p, paper, data, k):
    """The oracle's terms at a sample of the actual robot, with the voltage that (41) says."""
    phi, phid = paper["q"][k], paper["v"][k]
    wanted = planned(robot).schedule
    at = float(data["time"][k])
    voltage = float(2000 * (wanted.at(at) - phi[5]) + 20 * (wanted.at(at, 1) - phid[5]))
    return voltage, oracle(phi, phid, voltage, p, robot.equations, robot.contact is not None)


def test_run_moves_as_the_oracle(finely):
    """The rates of a run change as the oracle's accelerations at the voltage of (41) say, and so does its force."""
    robot, data, paper = finely
    p = symbols(robot.pair().real)
    for k in INSTANTS:
        voltage, found = terms_at(robot, p, paper, data, k)
        moved = derivative(paper["v"], k)
        assert np.abs(moved - found["phidd"]).max() < 1e-5 * max(1.0, np.abs(found["phidd"]).max()), k
        assert float(data["voltage"][k, 0]) == pytest.approx(voltage, rel=1e-9)
        if robot.contact:
            assert data["contact_force"].values[k] == pytest.approx(found["F_tip_on_environment"], abs=1e-7)


def test_the_reference_obeys_the_oracle(finely):
    """In the reference, whose motor follows theta_o, all rows but the motor's balance by the oracle's terms."""
    robot, data, paper = finely
    p, wanted = symbols(robot), planned(robot).schedule
    for k in INSTANTS:
        phi, phid, at = paper["q_nominal"][k], paper["v_nominal"][k], float(data["time"][k])
        assert [phi[5], phid[5]] == pytest.approx([float(wanted.at(at)), float(wanted.at(at, 1))], abs=1e-12)
        gained = derivative(paper["v_nominal"], k)
        moved = oracle(phi, phid, 0.0, p, robot.equations, robot.contact is not None)
        # The voltage that gives the motor its acceleration: the accelerations are affine in it.
        more = oracle(phi, phid, 1.0, p, robot.equations, robot.contact is not None)["phidd"] - moved["phidd"]
        expected = moved["phidd"] + more * (float(wanted.at(at, 2)) - moved["phidd"][5]) / more[5]
        assert np.abs(gained - expected).max() < 1e-5 * max(1.0, np.abs(expected).max()), k


def test_stationary_part_holds_the_loads(finely):
    """At T_st the rows of all five deformations balance: gravity, inertia of the motor's motion, contact."""
    robot, data, paper = finely
    p = symbols(robot.pair().real)
    for k in INSTANTS:
        theta, rate = paper["q"][k, 5], paper["v"][k, 5]
        phi = theta * WITH_MOTOR + BENT @ data["deformation_stationary"].values[k]
        found = oracle(phi, rate * WITH_MOTOR, 0.0, p, robot.equations, contact=False)
        rows = found["H"] @ WITH_MOTOR * derivative(paper["v"], k)[5] + found["h"] + found["f_el"]
        if robot.contact:
            rows += contact_map(phi, p, robot.equations == "consistent") @ data["contact_force"].values[k]
        assert np.abs(BENT.T @ rows).max() < 1e-6, k


def test_the_lines_of_a_run_are_those_of_the_oracle(finely):
    """Places, moments and shear of both modes at every station."""
    robot, data, paper = finely
    p, s = symbols(robot.pair().real), data["s"].values
    force = data["contact_force"].values if robot.contact else np.zeros((data.sizes["time"], 3))
    for k in INSTANTS:
        phidd = terms_at(robot, p, paper, data, k)[1]["phidd"]
        expected = line(paper["q"][k], paper["v"][k], phidd, force[k], p, s)
        assert data["line"].values[k] == pytest.approx(expected["line"], abs=1e-12)
        moment = data["moment"].sel(moment_kind=["z", "y"]).values[k] * [1, -1]
        assert moment == pytest.approx(expected["bending_moment"], abs=2e-6)
        assert data["shear_force"].values[k] == pytest.approx(expected["shear_force"], abs=2e-5)


@pytest.mark.parametrize("touch", [False, True])
@pytest.mark.parametrize("state", ["locked", "free", "controlled"])
@pytest.mark.parametrize("reading", ["printed", "consistent"])
def test_frequencies_are_those_of_the_oracle(robot, reading, state, touch):
    """Eigenvalues of the oracle's accelerations, differenced about rest, in every state of the motor.

    Without friction in the contact, which modes leave out: it is smoothed, so that it is a strong damper at rest.
    """
    changes = {"reading": reading, "payload.mass": 1.5, "controller.position_gain": 150.0, "contact": touch}
    robot = robot.with_(changes)
    rest = TO_PAPER @ robot_rest(robot, contact=touch).q
    p, count, small = symbols(robot) | {"mu": 0.0}, 5 if state == "locked" else 6, 2e-6
    if state == "locked":
        p["I"] = 1e15

    def accelerate(x):
        phi, phid = rest + x[:6], x[6:]
        volts = -150.0 * x[5] - 20.0 * phid[5] if state == "controlled" else p["CE"] * phid[5]
        return oracle(phi, phid, volts, p, reading, touch)["phidd"]

    slopes = np.array([(accelerate(d) - accelerate(-d)) / (2 * small) for d in small * np.eye(12)]).T
    keep = [*range(count), *range(6, 6 + count)]
    system = np.vstack([np.eye(12)[6:], slopes])[np.ix_(keep, keep)]
    ringing = sorted((value for value in np.linalg.eigvals(system) if value.imag > 1e-3), key=lambda value: value.imag)
    rings, modes = "damped_frequency_Hz", sheet_frequencies(robot, contact=touch)[state]
    found = sorted((mode for mode in modes if mode[rings]), key=lambda mode: mode[rings])
    assert [mode[rings] for mode in found] == pytest.approx([v.imag / 2 / np.pi for v in ringing], rel=1e-6)
    assert [mode["damping_ratio"] for mode in found] == pytest.approx([-v.real / abs(v) for v in ringing], abs=1e-6)
