"""The elastic line: moments and shear from the dynamics agree with the gear, with levers, and with the curvature."""

from __future__ import annotations

import numpy as np
import pytest

from tmodes.equations.lagrange.coordinates import deformations
from tmodes.paper.mechanism import Drive
from tmodes.paper.model import PaperModel

PHI = np.array([0.302, 0.012, 0.3, -0.004, -0.02, 0.29])
PHID = np.array([0.5, -0.2, 0.45, 0.05, -0.1, 0.6])


def state(robot, phi=PHI, phid=PHID, contact=True, **changes):
    """The line's quantities at 201 stations of both modes, and the terms of the equations."""
    robot = robot.with_({path.replace("__", "."): value for path, value in changes.items()}) if changes else robot
    mechanism, parameters = robot.split(Drive.VOLTAGE, contact=contact)
    model, s = PaperModel(mechanism), np.linspace(0, 1, 201)
    terms = {name: value[0] for name, value in model.evaluate(phi, phid, [3.0], parameters).items()}
    motion = np.concatenate([phi, phid, terms["phidd"], terms["F_tip_on_environment"]])
    return s, {name: value[0] for name, value in model.line(motion, s, parameters).items()}, terms


def test_root_moment_is_gear_torque(robot):
    """The horizontal moment at the root of mode 1 is the gear torque, in motion and in contact, exactly."""
    _, line, _ = state(robot)
    angles, rates = deformations(PHI), deformations(PHID)
    assert line["bending_moment"][0, 0, 0] == pytest.approx(robot.gear.torque(angles.xi, rates.xi), rel=1e-9)


def test_shear_is_minus_the_slope_of_the_moment(robot):
    """dM/dx = -V along both modes in both planes."""
    s, line, _ = state(robot)
    for mode, length in enumerate((0.6, 0.3)):
        slope = np.gradient(line["bending_moment"][mode], s * length, axis=0, edge_order=2)
        assert np.allclose(slope, -line["shear_force"][mode], rtol=2e-4, atol=1e-4)


def test_line_moments_obey_galerkin(robot):
    """(29)-(33) in the mode's own shape: the work of M equals that of beta (y + eta y')'' over the shape 1 - s.

    Small angles: moments about the chord and about the line differ by the square of the bending angle.
    """
    for scale in (1.0, 0.1):
        rest = np.array([PHI[5], 0, PHI[5], 0, 0, PHI[5]])
        s, line, _ = state(robot, rest + scale * (PHI - rest), scale * PHID)
        shape = 1 - s
        for mode in (0, 1):
            for plane in (0, 1):
                load = np.trapezoid(line["bending_moment"][mode, :, plane] * shape, s)
                bend = np.trapezoid(line["flexibility_moment"][mode, :, plane] * shape, s)
                assert load == pytest.approx(bend, rel=2e-2 * scale + 5e-4), (scale, mode, plane)


def test_static_moments_are_levers(robot):
    """At rest without contact: the vertical moment is weight times lever, the shear is the weight outboard."""
    mechanism, parameters = robot.split(Drive.VOLTAGE, contact=False)
    phi = PaperModel(mechanism).rest(0.0, parameters)[:6]
    _, line, terms = state(robot, phi, np.zeros(6), contact=False)
    first, second = robot.link.modes
    inner, outer = first.tip_mass * 9.81, (second.tip_mass + 0.5) * 9.81
    middle = line["line"][0, -1]
    at_root = -(inner * middle[0] + outer * terms["tip"][0])
    at_middle = -outer * (terms["tip"][0] - middle[0])
    # At rest the voltage of 3 V turns only the motor: the gear does not twist yet.
    assert np.allclose(terms["phidd"][:5], 0, atol=1e-9)
    assert line["bending_moment"][0, 0, 1] == pytest.approx(at_root, rel=1e-9)
    assert line["bending_moment"][1, 0, 1] == pytest.approx(at_middle, rel=1e-9)
    assert line["bending_moment"][1, -1, 1] == pytest.approx(0, abs=1e-12)
    assert line["shear_force"][0, 0, 1] == pytest.approx(-(inner + outer), rel=1e-9)
    assert line["shear_force"][1, 0, 1] == pytest.approx(-outer, rel=1e-3)


def test_line_is_whole(robot):
    """The line ends at the tip; deflection and slope are those of the shape."""
    _, line, terms = state(robot)
    angles = deformations(PHI)
    assert np.allclose(line["line"][1, -1], terms["tip"], atol=1e-14)
    assert line["slope"][0, -1, 0] == pytest.approx(1.5 * angles.th11q)
    assert line["deflection"][1, -1, 1] == pytest.approx(0.3 * angles.th12e)
    assert line["deflection"][1, -1, 0] == pytest.approx(0.3 * np.cos(PHI[3] + PHI[4]) * angles.th12d)
