"""Compliance of a point and its parts: springs in a row in closed form, and differences of equilibria under load."""

from __future__ import annotations

import numpy as np
import pytest

from analysis.statics.test_elements import geared, on_joint
from tmodes.analysis.statics.compliance import LOADS, point_compliance, springs_of
from tmodes.analysis.statics.equilibrium import Load, equilibrium
from tmodes.chain.chain import Chain, Joint, Node
from tmodes.kinds.joints.registry import joint_kind
from tmodes.kinds.links.strain import Beam, BeamPiece
from tmodes.model.model import Model

STIFFNESS, BENDING, TORSION, LENGTH = 300.0, 7.5, 5.0, 1.2


def arm(drive_axis=(0.0, 0.0, 1.0), gravity=(0.0, 0.0, 0.0)) -> Model:
    pair = (BENDING, BENDING)
    piece = BeamPiece(
        1.0, pair, pair, (TORSION, TORSION), (0.0, 0.0), (0.2, 0.2), ((1e-4, 1e-4), (0.0, 0.0), (0.0, 0.0))
    )
    link = Beam(LENGTH, (piece,), twist=1, bend_y=3, bend_z=3)
    return on_joint(geared((STIFFNESS,), axis=drive_axis), link, gravity=np.array(gravity))


def test_springs_in_a_row():
    """A gear and a beam: L^2/k + L^3/3EI across, 1/k + L/EI in turning; rigid along the line."""
    found = point_compliance(equilibrium(arm()))
    across, turning = LENGTH**2 / STIFFNESS, LENGTH**3 / (3 * BENDING)
    assert found.compliance[1, 1] == pytest.approx(across + turning, rel=1e-10)
    assert found.compliance[2, 2] == pytest.approx(turning, rel=1e-10)
    assert found.compliance[5, 5] == pytest.approx(1 / STIFFNESS + LENGTH / BENDING, rel=1e-10)
    assert found.compliance[3, 3] == pytest.approx(LENGTH / TORSION, rel=1e-10)
    assert found.compliance[1, 5] == pytest.approx(LENGTH / STIFFNESS + LENGTH**2 / (2 * BENDING), rel=1e-10)
    assert found.shares(1)["hinge.gear"] == pytest.approx(across / (across + turning), rel=1e-10)
    assert found.shares(1)["link.bend_z"] == pytest.approx(turning / (across + turning), rel=1e-10)
    assert found.shares(3) == pytest.approx(
        {"hinge.gear": 0, "link.twist": 1, "link.bend_y": 0, "link.bend_z": 0, LOADS: 0}
    )
    assert found.stiffness[0] == np.inf
    assert found.shares(0) == {}
    assert found.stiffness_matrix is None


def test_loaded_arm_gives_way_as_its_equilibria_differ():
    """In space, under weight, a tip force and a moment: exact to the error of the difference."""
    model = arm((0.0, 1.0, 0.0), (0.0, 0.0, -9.81))
    force, moment = np.array([1.0, 0.8, -0.6]), np.array([0.3, 0.2, -0.1])
    found = point_compliance(equilibrium(model, [Load("tip", force, moment)]))
    step = 1e-4
    for k in range(3):
        more, less = (equilibrium(model, [Load("tip", force + sign * step * np.eye(3)[k], moment)]) for sign in (1, -1))
        slope = (model.pose(more.q)[0][0] - model.pose(less.q)[0][0]) / (2 * step)
        assert found.compliance.T[:3, k] == pytest.approx(slope, abs=1e-7)
        assert sum(found.shares(k).values()) == pytest.approx(1.0, abs=1e-12)
    assert abs(found.shares(2)[LOADS]) > 1e-3
    matrix = found.stiffness_matrix
    assert matrix is not None
    assert matrix @ found.compliance == pytest.approx(np.eye(6), abs=1e-6)


def test_elements_are_all_of_the_elastic_slope():
    """At a bent pose, without weight, the elements together are K."""
    model = arm()
    q = np.array([0.1, 0.3, 0.2, 0.1, -0.2, 0.05, 0.3, 0.1, -0.05])
    together = np.sum([one.matrix for one in springs_of(model, q).values()], axis=0)
    assert together == pytest.approx(model.linearize(q)[2], abs=1e-9)


def test_a_rigid_arm_does_not_give():
    chain = Chain(
        "rigid", (Node("link", -1, Joint("clamp", joint_kind("revolute")), arm().chain.nodes[0].link),), np.zeros(3)
    )
    found = point_compliance(equilibrium(Model(chain), held=dict.fromkeys(Model(chain).coordinates, 0.0)))
    assert (found.stiffness == np.inf).all()
