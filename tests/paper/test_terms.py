"""The statements of the paper, one by one."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest

from tmodes.equations.lagrange.coordinates import basis, deformation_basis, deformations
from tmodes.equations.lagrange.energy import energies
from tmodes.equations.lagrange.kinematics import chord_slopes, line_point, tip
from tmodes.paper.local_pd import LocalPD
from tmodes.paper.mechanism import Drive, Mechanism, Reading
from tmodes.paper.mode import FlexibleMode, shape_angle, shape_deflection, shape_slope
from tmodes.paper.model import PaperModel

PHI = np.array([0.3, -0.2, 0.25, 0.15, -0.1, 0.2])
PHID = np.array([0.5, -1.0, 0.7, 0.3, -0.4, 0.6])
Q, DELTA, GAMMA, VT, E, THETA = PHI


def mechanism(reading: Reading = Reading.CONSISTENT) -> Mechanism:
    return Mechanism(reading, None, Drive.VOLTAGE)


def numbers(robot, reading, phid=PHID) -> dict[str, float]:
    """The energies at PHI and given rates."""
    symbols = ca.SX.sym("phi", 6), ca.SX.sym("phid", 6)
    found = vars(energies(robot, mechanism(reading), *symbols))
    values = ca.Function("energies", [*symbols], [ca.SX(value) for value in found.values()])(PHI, phid)
    return dict(zip(found, map(float, values), strict=True))


def array(value) -> np.ndarray:
    return ca.DM(value).full().ravel()


def terms(robot, reading):
    """Terms at PHI, PHID of the robot as known."""
    m, parameters = robot.split(Drive.VOLTAGE, reading=reading, contact=False)
    return {name: value[0] for name, value in PaperModel(m).evaluate(PHI, PHID, [0.0], parameters).items()}


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
    """(5)-(7): q = gamma + th11q, delta = th11q/2 + th12d, e = th11m/2 + th12e, and the basis is its inverse."""
    a = deformations(PHI)
    assert pytest.approx(Q) == GAMMA + a.th11q
    assert pytest.approx(THETA + a.xi) == GAMMA
    assert pytest.approx(a.th11q / 2 + a.th12d) == DELTA
    assert pytest.approx(a.th11m) == VT
    assert pytest.approx(a.th11m / 2 + a.th12e) == E
    assert np.allclose(THETA * basis()[:, 0] + deformation_basis() @ np.array(a), PHI, atol=1e-15)


@pytest.mark.parametrize("reading", list(Reading))
def test_elastic_energy_terms(robot, reading):
    """(16)-(19), (24), (26) written out by hand."""
    first, second = robot.link.modes
    levers = (first.length, second.length)
    if reading is Reading.CONSISTENT:
        levers = (first.length * np.cos(VT), second.length * np.cos(VT + E))
    c1, c2 = 3 * first.bending_stiffness / 0.6**3, 3 * second.bending_stiffness / 0.3**3
    by_hand = (
        c1 * VT**2 * 0.6**2
        + c2 * (E - VT / 2) ** 2 * 0.3**2
        + c1 * (Q - GAMMA) ** 2 * levers[0] ** 2
        + c2 * (DELTA - (Q - GAMMA) / 2) ** 2 * levers[1] ** 2
    ) / 2
    found = numbers(robot, reading)
    assert found["elastic_link"] == pytest.approx(by_hand, rel=1e-13)
    assert found["elastic_gear"] == pytest.approx(4700 * (GAMMA - THETA) ** 2 / 2, rel=1e-13)


@pytest.mark.parametrize("reading", list(Reading))
def test_rayleigh_terms(robot, reading):
    """(20)-(23), (25), (27): the rates of the angles, with the dots that the print lost; without rates no loss."""
    rates = deformations(PHID)
    found = numbers(robot, reading)
    levers = [0.6, 0.3, 0.6, 0.3]
    if reading is Reading.CONSISTENT:
        levers[:2] = [0.6 * np.cos(VT), 0.3 * np.cos(VT + E)]
    damping = [mode.tip_damping for mode in robot.link.modes] * 2
    by_hand = sum(b * (lever * rate) ** 2 for b, lever, rate in zip(damping, levers, rates[:4], strict=True)) / 2
    assert found["rayleigh_link"] == pytest.approx(by_hand, rel=1e-13)
    assert found["rayleigh_gear"] == pytest.approx(2.0 * rates.xi**2 / 2, rel=1e-13)
    assert numbers(robot, reading, np.zeros(6))["rayleigh_link"] == 0


def test_gravity_energy(robot):
    """(15) as it stands in the print."""
    first, second = robot.link.modes
    mel1, mel2 = 33 / 140 * first.mass_per_length * 0.6, 33 / 140 * second.mass_per_length * 0.3
    z1, z2 = 0.6 * np.sin(VT), 0.3 * np.sin(VT + E)
    printed = 9.81 * (mel1 * z1 + 0.5 * z1 + mel2 * z1 + 0.5 * z2 + mel2 * z2)
    found = numbers(robot, Reading.CONSISTENT)
    assert found["gravity"] == pytest.approx(printed, rel=1e-13)


@pytest.mark.parametrize("reading", list(Reading))
def test_printed_h11_entry(robot, reading):
    """H11 as the paper prints it, with its 9/4 and 9/16, follows from the energies in both readings."""
    first, second = robot.link.modes
    mel1, mel2 = first.tip_mass, second.tip_mass
    outer, lm, le = 0.5 + mel2, 0.6 * np.cos(VT), 0.3 * np.cos(VT + E)
    printed = mel1 * lm**2 + outer * (lm**2 + le**2 + 2 * lm * le * np.cos(DELTA))
    printed += 9 / 4 * first.tip_inertia + 9 / 16 * (2.5e-4 + second.tip_inertia)
    assert terms(robot, reading)["H"][0, 0] == pytest.approx(printed, rel=1e-13)


@pytest.mark.parametrize("reading", list(Reading))
def test_rows_are_lagrange(robot, reading):
    """(34)-(38): along any free motion without loss, H phi'' + h + f_el is d/dt dT/dphi' - dT/dphi + dV/dphi."""
    m, parameters = robot.split(Drive.VOLTAGE, reading=reading, contact=False)
    model, step = PaperModel(m), 1e-5

    def lagrangian(phi, phid):
        e = {name: value[0] for name, value in model.evaluate(phi, phid, [0.0], parameters).items()}
        return e["kinetic"] - e["potential_gravity"] - e["potential_elastic"]

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
    found = terms(robot, reading)
    rows = found["H"] @ phidd + found["h"] + found["f_el"]
    assert np.allclose(rows, (ahead - behind) / (2 * t) - by_position, rtol=2e-5, atol=2e-4)


def test_half_coupling(robot):
    """(37): the elastic row of vt is eps11 - 1/2 eps12, the -1/2 by itself (`printed`, where levers are constant)."""
    found, angles = terms(robot, Reading.PRINTED), deformations(PHI)
    first, second = robot.link.modes
    eps11 = first.tip_stiffness * 0.6**2 * angles.th11m
    eps12 = second.tip_stiffness * 0.3**2 * angles.th12e
    assert found["f_el"][3] == pytest.approx(eps11 - eps12 / 2, rel=1e-12)
    assert found["f_el"][4] == pytest.approx(eps12, rel=1e-12)
    eps11q = first.tip_stiffness * 0.6**2 * angles.th11q
    eps12d = second.tip_stiffness * 0.3**2 * angles.th12d
    sigma = robot.gear.torque(angles.xi, 0.0)
    assert found["f_el"][0] == pytest.approx(eps11q - eps12d / 2, rel=1e-12)
    assert found["f_el"][2] == pytest.approx(eps12d / 2 - eps11q + sigma, rel=1e-12)


def test_line_ends_at_tip(robot):
    """The point s = 1 of the line is the tip; mode 2 starts where mode 1 ends, and in its direction."""

    def at(mode, place):
        return array(line_point(mode, ca.DM(PHI), robot.link, place))

    small = 1e-7
    assert np.allclose(at(2, 1.0), array(tip(ca.DM(PHI), robot.link)), atol=1e-15)
    assert np.allclose(at(1, 1.0), at(2, 0.0), atol=1e-15)
    first, second = at(1, 1.0) - at(1, 1 - small), at(2, small) - at(2, 0.0)
    slopes = [float(x) for x in chord_slopes(PHI)]
    for piece in (first, second):
        assert np.arctan2(piece[1], piece[0]) == pytest.approx(slopes[0], abs=2e-3)
        assert np.arcsin(piece[2] / np.linalg.norm(piece)) == pytest.approx(slopes[2], abs=2e-3)


def test_tip_is_the_seed_formula(robot):
    """(42) as printed."""
    lm, le = 0.6 * np.cos(VT), 0.3 * np.cos(VT + E)
    printed = [
        lm * np.cos(Q) + le * np.cos(Q + DELTA),
        lm * np.sin(Q) + le * np.sin(Q + DELTA),
        0.6 * np.sin(VT) + 0.3 * np.sin(VT + E),
    ]
    assert np.allclose(array(tip(ca.DM(PHI), robot.link)), printed, atol=1e-15)


def test_local_pd():
    """(41): zero error, zero voltage; else each gain times its own error."""
    control = LocalPD(position_gain=2000.0, velocity_gain=20.0)
    assert control.command(0.3, 1.0, 0.3, 1.0) == 0
    assert control.command(0.3, 1.0, 0.2, 0.5) == pytest.approx(2000 * 0.1 + 20 * 0.5)


def test_static_shape_of_a_mode_is_euler_bernoulli():
    """Cs = 3 EI/l^3 is the tip stiffness of the cantilever; the flexibility moment at the root is force x length."""
    mode = FlexibleMode(length=0.6, bending_stiffness=1082.0, mass_per_length=2.0, damping_time=0.0)
    force = 2.5
    deflection = force * 0.6**3 / (3 * 1082.0)
    assert mode.tip_stiffness * deflection == pytest.approx(force)
    assert mode.flexibility_moment(deflection / 0.6, 0.0, 0.6) == pytest.approx(force * 0.6)
