"""The slips of the print: what stands there is shown to be wrong, and what the package does to be right."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import quad

from lagrange import robot2010
from tmodes.analysis.inverse import coordinate_rates
from tmodes.integrate.settings import Integration
from tmodes.kinds.links.modes_sheet import Mode, shape_deflection
from tmodes.simulation.initial_state import run_setup

PHI = np.array([0.3, -0.2, 0.25, 0.15, -0.1, 0.2])
PHID = np.array([0.5, -1.0, 0.7, 0.3, -0.4, 0.6])
Q, DELTA, GAMMA, VT, E, THETA = PHI


def terms(numbers, reading="consistent", contact=False, phi=PHI, u=0.0, **changes):
    return robot2010.terms(reading, phi, PHID, u, numbers | changes, contact=contact)


def test_slip_13_mass():
    """33/140 is the mass of the static shape in motion: its rotation is in it. Weight would ask for 3/8."""
    mode = Mode(length=0.6, bending_stiffness=1082.0, mass_per_length=2.0, damping_time=0.0)
    in_motion = quad(lambda s: shape_deflection(s) ** 2, 0, 1)[0]
    under_weight = quad(shape_deflection, 0, 1)[0]
    assert in_motion == pytest.approx(33 / 140)
    assert under_weight == pytest.approx(3 / 8)
    assert mode.tip_mass == pytest.approx(33 / 140 * 2.0 * 0.6)
    assert mode.tip_inertia == pytest.approx(mode.tip_mass * 0.3**2)


def test_slip_44_jacobian(numbers):
    """J is the derivative of the tip; the print's lm, le exchanged is not, and it lacks the columns of vt and e."""
    found, step = terms(numbers), 1e-6
    shifted = [
        (terms(numbers, phi=PHI + d)["tip"] - terms(numbers, phi=PHI - d)["tip"]) / (2 * step) for d in step * np.eye(6)
    ]
    assert np.allclose(found["J"], np.array(shifted).T, atol=1e-9)
    lm, le = 0.6 * np.cos(VT), 0.3 * np.cos(VT + E)
    printed = -(lm * np.sin(Q + DELTA) + le * np.sin(Q))
    assert abs(found["J"][0, 0] - printed) > 0.02
    assert found["J"][0, 0] == pytest.approx(-(lm * np.sin(Q) + le * np.sin(Q + DELTA)))
    assert np.abs(found["J"][:2, 3:5]).min() > 1e-3


def test_slip_43_pseudo_inverse(numbers):
    """The print's 6 x 6 matrix is singular; the pseudo-inverse of the 3 x 6 gives the tip its velocity."""
    jacobian = terms(numbers)["J"]
    blocks = np.zeros((6, 6))
    blocks[:2, :2], blocks[3:5, 3:5] = jacobian[:2, :2], jacobian[1:, 3:5]
    assert np.linalg.matrix_rank(blocks) < 6
    wanted = np.array([0.1, -0.2, 0.05])
    assert np.allclose(jacobian @ coordinate_rates(jacobian, wanted), wanted, atol=1e-14)


def test_slip_34_repeated_entry(numbers):
    """Hel1,1, Hel1,2 and Hel1,3 are three different numbers."""
    row = terms(numbers, "printed")["H"][0, :3]
    assert np.abs(np.diff(row)).min() > 0.01


def test_every_row_needs_its_column_of_the_jacobian(numbers):
    """A contact force at the tip loads rows q, delta, vt and e at once, each by its column of J."""
    free, touched = terms(numbers), terms(numbers, contact=True)
    rows = free["H"] @ (free["phidd"] - touched["phidd"])
    columns = free["J"].T @ touched["F_tip_on_environment"]
    assert np.allclose(rows, columns, atol=1e-9 * np.abs(columns).max())
    assert np.abs(columns[[0, 1, 3, 4]]).min() > 0.1


def test_slip_18_geometric_terms(numbers):
    """With lm and le varying, horizontal bending loads the vertical rows; with constant levers it does not."""
    stretched = PHI + np.array([0.05, 0, 0, 0, 0, 0])
    change = {
        reading: terms(numbers, reading, phi=stretched)["f_el"] - terms(numbers, reading)["f_el"]
        for reading in ("printed", "consistent")
    }
    assert np.abs(change["consistent"][3:5]).min() > 1e-3
    assert np.abs(change["printed"][3:5]).max() == 0


def test_slip_contact_stiffness_sign(robot):
    """Further out, the environment pushes harder; with the print's Delta kappa it would push less."""
    environment = robot.contact
    for out, expected in ((0.0, 5.0), (0.001, 6.0), (-0.001, 4.0)):
        assert environment.normal_force(environment.numbers(), out, 0.0) == pytest.approx(expected)
    shorter = robot.with_({"contact.shape.radius": 0.899, "contact.mass": 0.0})
    rests = [run_setup(one).rest for one in (robot, shorter)]
    pressed = [float(np.linalg.norm(rest.wrenches[0, :3])) for rest in rests if rest and rest.wrenches is not None]
    assert pressed[1] > pressed[0] + 0.5


def test_slip_friction_sign(numbers):
    """Friction takes power from the robot while the environment is pressed."""
    found = terms(numbers, contact=True, mu=0.3, Fc0=100.0)
    velocity, force = found["J"] @ PHID, found["F_tip_on_environment"]
    normal = found["tip"] / np.linalg.norm(found["tip"])
    slip = velocity - normal * (normal @ velocity)
    assert force @ normal > 0
    assert force @ slip > 0.1  # the power that leaves the robot through friction [W]


def test_slip_planar_map_is_not_power(numbers):
    """The print's map counts F_x in both planes: the rows' power is not F.v; with the full Jacobian it is."""
    for reading, equal in (("printed", False), ("consistent", True)):
        free, touched = terms(numbers, reading), terms(numbers, reading, contact=True)
        rows = free["H"] @ (free["phidd"] - touched["phidd"])
        power, at_tip = rows @ PHID, touched["F_tip_on_environment"] @ (touched["J"] @ PHID)
        assert (abs(power - at_tip) < 1e-6 * abs(at_tip)) == equal, (power, at_tip)


def test_motor_row_is_in_newton_metres(numbers):
    """Row 6 with (39) put in: a volt more gives CM/R newton metres more, on the reflected inertia I alone."""
    one, two = terms(numbers, u=1.0), terms(numbers, u=2.0)
    torque = numbers["CM"] / numbers["R"]
    assert two["Q"][5] - one["Q"][5] == pytest.approx(torque)
    assert two["phidd"][5] - one["phidd"][5] == pytest.approx(torque / numbers["I"])
    expected = torque * (1.0 - numbers["CE"] * PHID[5]) - numbers["Bm"] * PHID[5]
    assert one["Q"][5] == pytest.approx(expected)


def test_slip_step_divides_the_move(robot):
    """The print's dt does not divide T = 2 s; the shipped step does, ramps included."""
    printed, step = 2.0 / 0.000053335, robot.integration.step
    assert abs(printed - round(printed)) > 0.1
    for length in (0.4, 1.2, 2.0):
        assert length / step == pytest.approx(round(length / step), abs=1e-9)
    assert round(2.0 / step) == 37500
    assert Integration().step == pytest.approx(step, rel=1e-12)
