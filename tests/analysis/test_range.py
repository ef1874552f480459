"""How far a link bends and whether its model holds there: arcs of a circle, segments, a motion."""

from __future__ import annotations

import numpy as np
import pytest

from analysis.sheets import clamped_sheet
from analysis.statics.beams import clamped
from tmodes.analysis.line.line import elastic_line
from tmodes.analysis.statics.equilibrium import Load, equilibrium
from tmodes.analysis.validity import link_angles, link_ranges, run_warnings
from tmodes.chain.chain import Chain, Joint, Node
from tmodes.kinds.joints.registry import joint_kind
from tmodes.kinds.links.segment import Segment
from tmodes.model.model import Model
from tmodes.sheet import Robot


@pytest.mark.parametrize(("turn", "verdict"), [(np.pi / 2, "good"), (2 * np.pi, "fair"), (9.0, "beyond the model")])
def test_an_arc_of_a_circle(turn, verdict):
    """Angle, end and the largest step between the six Gauss points, the root and the tip."""
    rest = equilibrium(clamped(bend_z=4), [Load("tip", moment=(0, 0, turn))])
    (found,) = link_ranges(rest.model, rest.q)
    points = [0.0, *(1 + np.polynomial.legendre.leggauss(6)[0]) / 2, 1.0]
    assert found.angle_rad == pytest.approx(turn * np.diff(points).max(), rel=1e-9)
    assert np.cos(found.slope_rad) == pytest.approx(np.cos(turn), abs=1e-9)
    end = np.array([np.sin(turn), 1 - np.cos(turn)]) / turn - [1.0, 0.0]
    assert found.deflection_m == pytest.approx(np.linalg.norm(end), rel=1e-4)
    assert found.verdict == verdict


@pytest.mark.parametrize(("angle", "verdict"), [(0.05, "good"), (0.2, "fair"), (0.5, "beyond the model")])
def test_segments_hold_for_small_angles(angle, verdict):
    link = Segment(0.5, 100.0, 100.0)
    model = Model(Chain("one", (Node("link", -1, Joint("clamp", joint_kind("fixed")), link),), np.zeros(3)))
    (found,) = link_ranges(model, np.array([0.0, angle]))
    assert found.angle_rad == pytest.approx(angle)
    assert found.slope_rad == pytest.approx(1.5 * angle)
    assert found.deflection_over_length == pytest.approx(2 * np.sin(angle / 2))
    assert found.verdict == verdict


def test_a_motion_beyond_the_model_is_reported_with_its_first_time():
    arm = Robot.from_data(clamped_sheet(functions={"bend_z": 4}, basis="legendre"))
    model = Model(arm.chain())
    times = np.linspace(0, 1, 101)
    motion = np.outer(times, [10.0, 0, 0, 0])
    assert link_angles(model, motion)["beam"].shape == (101,)

    def turned(motion: np.ndarray) -> list[str]:
        found = run_warnings(arm, model, times, motion, elastic_line(model, motion, stations=3))
        return [line for line in found if "turns by more" in line]

    (info,) = turned(motion)
    gap = np.diff([0.0, *(1 + np.polynomial.legendre.leggauss(6)[0]) / 2, 1.0]).max()
    first = times[np.flatnonzero(10 * times * gap > 1.0)[0]]
    assert f"t = {first:.4g} s" in info
    assert f"reaches {10 * gap:.4g} rad" in info
    assert turned(motion / 10) == []
