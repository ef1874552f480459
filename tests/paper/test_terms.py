"""The statements of the paper, one by one."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest

from lagrange.robot2010 import TO_ROBOT, chain, terms
from oracle.line import angles
from tmodes.equations.lagrange.filipovic2010 import COORDINATES, basis
from tmodes.io.filipovic2010.importer import to_robot
from tmodes.kinds.links.modes_sheet import Mode, shape_angle, shape_deflection, shape_slope
from tmodes.model.model import Model
from tmodes.simulation.initial_state import run_setup

PHI = np.array([0.3, -0.2, 0.25, 0.15, -0.1, 0.2])
PHID = np.array([0.5, -1.0, 0.7, 0.3, -0.4, 0.6])
Q, DELTA, GAMMA, VT, E, THETA = PHI
READINGS = ("printed", "consistent")


def energies(p, reading, phid=PHID) -> dict[str, float]:
    """Energies [J] and half of the losses [W] at PHI and given rates."""
    model, at = Model(chain(reading, p)), (TO_ROBOT @ PHI, TO_ROBOT @ phid)
    half = {name: float(value) / 2 for name, value in model.losses(*at).items()}
    return {name: float(value) for name, value in model.energies(*at).items()} | half


def levers(reading):
    """Lengths that turn th11q and th12d into deflections."""
    return (0.6, 0.3) if reading == "printed" else (0.6 * np.cos(VT), 0.3 * np.cos(VT + E))


def test_mode_shape():
    """The shape solves EI y'''' = 0 of a cantilever under a tip force; the tip turns by 3/2 of its chord."""
    s = ca.SX.sym("s")
    fourth = shape_deflection(s)
    for _ in range(4):
        fourth = ca.jacobian(fourth, s)
    assert ca.simplify(fourth).is_zero()
    at = ca.Function("at", [s], [shape_deflection(s), ca.jacobian(shape_deflection(s), s), shape_slope(s)])
    for place in (0.0, 0.3, 1.0):
        value, slope, info = (float(x) for x in at(place))
        assert slope == pytest.approx(info)
        assert value == pytest.approx(place * shape_angle(place))
    assert [float(x) for x in at(0)] == [0, 0, 0]
    assert float(at(1)[0]) == 1
    assert float(at(1)[1]) == pytest.approx(1 + 1 / 2)  # the chord's angle th and omega = th/2


def test_deformation_angles():
    """(5)-(7): q = gamma + th11q, gamma = theta + xi, delta = th11q/2 + th12d, e = th11m/2 + th12e."""
    own = dict(zip(COORDINATES, np.linalg.solve(basis(), PHI[:5]), strict=True))
    assert own["joint"] == pytest.approx(GAMMA)
    assert pytest.approx(Q) == GAMMA + own["azimuth1"]
    assert pytest.approx(DELTA) == own["azimuth1"] / 2 + own["azimuth2"]
    assert pytest.approx(VT) == own["elevation1"]
    assert pytest.approx(E) == own["elevation1"] / 2 + own["elevation2"]
    names = ["joint.motor", "joint", *(f"link.{name}" for name in COORDINATES[1:])]
    assert to_robot(names) @ PHI == pytest.approx([THETA, *own.values()], abs=1e-15)


@pytest.mark.parametrize("reading", READINGS)
def test_elastic_energy_terms(numbers, reading):
    """(16)-(19), (24), (26) written out by hand."""
    inner, outer = levers(reading)
    c1, c2 = 3 * numbers["EI1"] / 0.6**3, 3 * numbers["EI2"] / 0.3**3
    by_hand = (
        c1 * VT**2 * 0.6**2
        + c2 * (E - VT / 2) ** 2 * 0.3**2
        + c1 * (Q - GAMMA) ** 2 * inner**2
        + c2 * (DELTA - (Q - GAMMA) / 2) ** 2 * outer**2
    ) / 2
    found = energies(numbers, reading)
    assert found["elastic_link"] == pytest.approx(by_hand, rel=1e-13)
    assert found["elastic_gear"] == pytest.approx(4700 * (GAMMA - THETA) ** 2 / 2, rel=1e-13)


@pytest.mark.parametrize("reading", READINGS)
def test_rayleigh_terms(numbers, reading):
    """(20)-(23), (25), (27): the rates of the angles, with the dots that the print lost; without rates no loss."""
    found, rates = energies(numbers, reading), angles(PHID)
    by_hand = sum(
        numbers[name] * (lever * rate) ** 2 / 2
        for name, lever, rate in zip(("Bs1", "Bs2") * 2, (*levers(reading), 0.6, 0.3), rates, strict=True)
    )
    assert found["link_damping"] == pytest.approx(by_hand, rel=1e-13)
    assert found["gear_damping"] == pytest.approx(2.0 * (PHID[2] - PHID[5]) ** 2 / 2, rel=1e-13)
    assert energies(numbers, reading, np.zeros(6))["link_damping"] == 0


@pytest.mark.parametrize("reading", READINGS)
def test_gravity_energy(numbers, reading):
    """(15) as it stands in the print."""
    mel1, mel2 = 33 / 140 * numbers["w1"] * 0.6, 33 / 140 * numbers["w2"] * 0.3
    z1, z2 = 0.6 * np.sin(VT), 0.3 * np.sin(VT + E)
    printed = 9.81 * (mel1 * z1 + 0.5 * z1 + mel2 * z1 + 0.5 * z2 + mel2 * z2)
    assert energies(numbers, reading)["gravity"] == pytest.approx(printed, rel=1e-13)


@pytest.mark.parametrize("reading", READINGS)
def test_printed_h11_entry(numbers, reading):
    """H11 as the paper prints it, with its 9/4 and 9/16, follows from the energies in both readings."""
    outer, lm, le = 0.5 + numbers["mel2"], 0.6 * np.cos(VT), 0.3 * np.cos(VT + E)
    printed = numbers["mel1"] * lm**2 + outer * (lm**2 + le**2 + 2 * lm * le * np.cos(DELTA))
    printed += 9 / 4 * numbers["Jel1"] + 9 / 16 * (2.5e-4 + numbers["Jel2"])
    assert terms(reading, PHI, PHID, 0.0, numbers)["H"][0, 0] == pytest.approx(printed, rel=1e-13)


@pytest.mark.parametrize("reading", READINGS)
def test_rows_are_lagrange(numbers, reading):
    """(34)-(38): along any free motion without loss, H phi'' + h + f_el is d/dt dT/dphi' - dT/dphi + dV/dphi."""
    model, step = Model(chain(reading, numbers)), 1e-5

    def lagrangian(phi, phid):
        e = model.energies(TO_ROBOT @ phi, TO_ROBOT @ phid)
        return e["kinetic"] - e["gravity"] - e["elastic_gear"] - e["elastic_link"]

    def momentum(phi, phid):
        return np.array(
            [(lagrangian(phi, phid + d) - lagrangian(phi, phid - d)) / (2 * step) for d in step * np.eye(6)]
        )

    phidd = np.array([3.0, -2.0, 1.0, 4.0, -5.0, 2.0])
    t = 1e-4
    ahead = momentum(PHI + t * PHID + t**2 / 2 * phidd, PHID + t * phidd)
    behind = momentum(PHI - t * PHID + t**2 / 2 * phidd, PHID - t * phidd)
    by_position = np.array(
        [(lagrangian(PHI + d, PHID) - lagrangian(PHI - d, PHID)) / (2 * step) for d in step * np.eye(6)]
    )
    found = terms(reading, PHI, PHID, 0.0, numbers)
    rows = found["H"] @ phidd + found["h"] + found["f_el"]
    assert np.allclose(rows, (ahead - behind) / (2 * t) - by_position, rtol=2e-5, atol=2e-4)


def test_half_coupling(numbers):
    """(37): the elastic row of vt is eps11 - 1/2 eps12, the -1/2 by itself (`printed`, where levers are constant)."""
    rows, (th11q, th12d, th11m, th12e) = terms("printed", PHI, PHID, 0.0, numbers)["f_el"], angles(PHI)
    first, second = numbers["Cs1"] * 0.6**2, numbers["Cs2"] * 0.3**2
    eps11, eps12 = first * th11m, second * th12e
    assert rows[3] == pytest.approx(eps11 - eps12 / 2, rel=1e-12)
    assert rows[4] == pytest.approx(eps12, rel=1e-12)
    eps11q, eps12d = first * th11q, second * th12d
    sigma = numbers["Cxi"] * (GAMMA - THETA)
    assert rows[0] == pytest.approx(eps11q - eps12d / 2, rel=1e-12)
    assert rows[2] == pytest.approx(eps12d / 2 - eps11q + sigma, rel=1e-12)


@pytest.mark.parametrize("equations", ["printed", "consistent", "recursion"])
def test_tip_is_the_paper_formula(numbers, equations):
    """(42) as printed, with (8): seen from above, the modes are l1 cos vt and l2 cos(vt + e) long."""
    lm, le = 0.6 * np.cos(VT), 0.3 * np.cos(VT + E)
    printed = [
        lm * np.cos(Q) + le * np.cos(Q + DELTA),
        lm * np.sin(Q) + le * np.sin(Q + DELTA),
        0.6 * np.sin(VT) + 0.3 * np.sin(VT + E),
    ]
    assert np.allclose(terms(equations, PHI, PHID, 0.0, numbers)["tip"], printed, atol=1e-15)


def test_local_pd(robot):
    """(41): each gain times its own error, as the voltage of the robot's drive."""
    setup = run_setup(robot.with_({"contact": False}))
    layout = setup.model.layout
    state = setup.start.copy()
    state[layout.q.start], state[layout.v.start] = 0.2, 0.5
    signal = setup.planned.schedule
    voltage = setup.model.observe([0.3], state, signal.rows_at(np.array([0.3])))["drives"][0, 0, 1]
    wanted, rate = float(signal.at(0.3)), float(signal.at(0.3, 1))
    assert voltage == pytest.approx(2000 * (wanted - 0.2) + 20 * (rate - 0.5), rel=1e-12)


def test_static_shape_of_a_mode_is_euler_bernoulli():
    """Cs = 3 EI/l^3 is the tip stiffness of the cantilever; with it l Cs th at the tip is the moment at the root."""
    mode = Mode(length=0.6, bending_stiffness=1082.0, mass_per_length=2.0, damping_time=0.0)
    force = 2.5
    deflection = force * 0.6**3 / (3 * 1082.0)
    assert mode.tip_stiffness * deflection == pytest.approx(force)
