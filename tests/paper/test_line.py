"""The elastic line: moments and shear from the dynamics agree with the gear, with levers, and with the curvature."""

from __future__ import annotations

import numpy as np
import pytest

from lagrange.robot2010 import TO_PAPER, close, lines, terms
from oracle.line import angles, line
from oracle.parameters import random_parameters, random_state
from tmodes.analysis.statics.at_rest import robot_rest

PHI = np.array([0.302, 0.012, 0.3, -0.004, -0.02, 0.29])
PHID = np.array([0.5, -0.2, 0.45, 0.05, -0.1, 0.6])


def state(p, phi=PHI, phid=PHID, contact=True):
    """The line's quantities at 201 stations of both modes, and the terms of the equations."""
    s = np.linspace(0, 1, 201)
    found = terms("consistent", phi, phid, 3.0, p, contact=contact)
    force = found.get("F_tip_on_environment", np.zeros(3))
    return s, lines("consistent", phi, phid, found["phidd"], force, p, s), found


@pytest.mark.parametrize("equations", ["printed", "consistent", "recursion"])
def test_lines_of_modes_are_those_of_the_paper(equations):
    """Line, deflection, slope, moments and shear of both modes under a force on the tip, as an oracle has them."""
    rng, s = np.random.default_rng(200), np.linspace(0.0, 1.0, 5)
    for _ in range(3):
        p, (phi, phid, _) = random_parameters(rng), random_state(rng)
        phidd, force = TO_PAPER @ (5 * rng.normal(size=6)), 20 * rng.normal(size=3)
        expected = line(phi, phid, phidd, force, p, s)
        found = lines(equations, phi, phid, phidd, force, p, s)
        for name, values in expected.items():
            close(found[name], values, 1e-12)


def test_root_moment_is_gear_torque(numbers):
    """The horizontal moment at the root of mode 1 is the gear torque, in motion and in contact, exactly."""
    _, found, _ = state(numbers)
    torque = numbers["Cxi"] * (PHI[2] - PHI[5]) + numbers["Bxi"] * (PHID[2] - PHID[5])
    assert found["bending_moment"][0, 0, 0] == pytest.approx(torque, rel=1e-9)


def test_shear_is_minus_the_slope_of_the_moment(numbers):
    """dM/dx = -V along both modes in both planes."""
    s, found, _ = state(numbers)
    for mode, length in enumerate((0.6, 0.3)):
        slope = np.gradient(found["bending_moment"][mode], s * length, axis=0, edge_order=2)
        assert np.allclose(slope, -found["shear_force"][mode], rtol=2e-4, atol=1e-4)


def test_line_moments_obey_galerkin(numbers):
    """(29)-(33) in the mode's own shape: the work of M equals that of beta (y + eta y')'' over the shape 1 - s.

    Small angles: moments about the chord and about the line differ by the square of the bending angle.
    """
    for scale in (1.0, 0.1):
        rest = np.array([PHI[5], 0, PHI[5], 0, 0, PHI[5]])
        s, found, _ = state(numbers, rest + scale * (PHI - rest), scale * PHID)
        shape = 1 - s
        for mode in (0, 1):
            for plane in (0, 1):
                load = np.trapezoid(found["bending_moment"][mode, :, plane] * shape, s)
                bend = np.trapezoid(found["flexibility_moment"][mode, :, plane] * shape, s)
                assert load == pytest.approx(bend, rel=2e-2 * scale + 5e-4), (scale, mode, plane)


def test_static_moments_are_levers(robot, numbers):
    """At rest without contact: the vertical moment is weight times lever, the shear is the weight outboard."""
    phi = TO_PAPER @ robot_rest(robot.with_({"contact": False})).q
    _, found, info = state(numbers, phi, np.zeros(6), contact=False)
    inner, outer = numbers["mel1"] * 9.81, (numbers["mel2"] + 0.5) * 9.81
    middle = found["line"][0, -1]
    at_root = -(inner * middle[0] + outer * info["tip"][0])
    at_middle = -outer * (info["tip"][0] - middle[0])
    # At rest the voltage of 3 V turns only the motor: the gear does not twist yet.
    assert np.allclose(info["phidd"][:5], 0, atol=1e-9)
    assert found["bending_moment"][0, 0, 1] == pytest.approx(at_root, rel=1e-9)
    assert found["bending_moment"][1, 0, 1] == pytest.approx(at_middle, rel=1e-9)
    assert found["bending_moment"][1, -1, 1] == pytest.approx(0, abs=1e-12)
    assert found["shear_force"][0, 0, 1] == pytest.approx(-(inner + outer), rel=1e-9)
    assert found["shear_force"][1, 0, 1] == pytest.approx(-outer, rel=1e-3)


def test_line_ends_at_tip(numbers):
    """The point s = 1 of the line is the tip; mode 2 starts where mode 1 ends, and in its direction; angles add up."""
    _, found, info = state(numbers)
    th11q, th12d, th11m, th12e = angles(PHI)
    assert np.allclose(found["line"][1, -1], info["tip"], atol=1e-14)
    assert np.allclose(found["line"][0, -1], found["line"][1, 0], atol=1e-15)
    assert found["slope"][0, -1] == pytest.approx([1.5 * th11q, 1.5 * th11m])
    assert found["deflection"][1, -1] == pytest.approx([0.3 * np.cos(PHI[3] + PHI[4]) * th12d, 0.3 * th12e])
    for piece in (found["line"][0, -1] - found["line"][0, -2], found["line"][1, 1] - found["line"][1, 0]):
        assert np.arctan2(piece[1], piece[0]) == pytest.approx(PHI[0] + th11q / 2, abs=3e-4)
        assert np.arcsin(piece[2] / np.linalg.norm(piece)) == pytest.approx(PHI[3] + th11m / 2, abs=3e-4)
