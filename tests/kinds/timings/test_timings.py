"""Timings of paths: one of a user's own, and the least time within limits, against closed forms."""

from __future__ import annotations

from typing import Any, Literal

import numpy as np
import pytest
from numpy.typing import NDArray
from pydantic import Field

import tmodes
from tmodes.analysis.follow import Arm
from tmodes.errors import InputError, InputErrors
from tmodes.kinds.signals.registry import Signal
from tmodes.kinds.signals.s_curve import SCurve
from tmodes.kinds.timings.registry import TIMINGS, JointCourse, Timing

ARM = tmodes.load("two_link_arm")
STIFF = ARM.with_({"links.forearm.beam": {"model": "rigid", "length": 0.5, "material": "aluminium_6061",
                                          "section": {"shape": "tube", "outer_diameter": 0.022, "thickness": 0.0015}},
                   "joints.shoulder.gear": None, "joints.elbow.gear": None, "real": {}})  # fmt: skip
LINE = {"type": "line", "to": [0.7, 0.0, 0.2]}


@TIMINGS.register
class Halves(Timing):
    """One acceleration up to the middle of the path, and the same back."""

    type: Literal["test_halves"] = Field(description="kind of timing")
    gain: float = Field(default=2.0, description="acceleration along the path")

    def speeds(self, course: JointCourse) -> NDArray[np.float64]:
        ends = np.minimum(course.ways, course.ways[-1] - course.ways)
        return np.sqrt(2 * self.gain * np.maximum(ends, 0.0))


def test_of_ones_own_along_several_paths() -> None:
    found = STIFF.follow([LINE, {"type": "joints", "points": [[-0.4, 1.0]]}], profile={"type": "test_halves"})
    for leg in found.found.legs:
        length = leg.course.length
        assert leg.end == pytest.approx(2 * np.sqrt(length / 2.0), rel=1e-3)  # of 2 m/s^2, rad/s^2
        assert leg.pieces.at(leg.end / 2) == pytest.approx(length / 2, rel=1e-3)
    assert found.error < 1e-7


def test_needs_no_least_time() -> None:
    with pytest.raises(InputErrors) as caught:
        STIFF.follow(LINE, profile={"type": "test_halves"}, least_time=True)
    assert [one.which for one in caught.value.errors] == ["task.least_time"]


def follows(robot: Any, path: dict[str, Any], **timing: Any) -> Any:
    pytest.importorskip("toppra")
    return robot.follow(path, profile={"type": "toppra", **timing})


def test_least_time_at_a_steady_acceleration() -> None:
    """One joint that moves, far from its limits: bang-bang, 2 sqrt(d/a)."""
    found = follows(STIFF, {"type": "joints", "points": [[-0.4, 0.7]]}, acceleration=1.5)
    assert found.duration == pytest.approx(2 * np.sqrt(0.3 / 1.5), rel=1e-3)


def test_one_joint_is_at_a_limit_everywhere_and_none_beyond() -> None:
    found = follows(STIFF, LINE)
    path, arm = found.found, Arm(STIFF)
    rows = zip(path.values, path.rates, path.accelerations, strict=True)
    loads = np.abs([arm.efforts(*row) for row in rows]) / [82.0, 54.0]
    whole = np.maximum(loads, np.abs(path.rates) / 6.28).max(axis=1)
    assert whole.max() < 1.001
    assert np.quantile(whole, 0.1) > 0.98
    slower = follows(STIFF, LINE, share=0.5)
    assert slower.duration > found.duration


def test_what_it_cannot_time() -> None:
    limits = {f"joints.{name}.limits": None for name in ("shoulder", "elbow")}
    with pytest.raises(InputError, match="no limit of a joint"):
        follows(STIFF.with_(limits), LINE)
    with pytest.raises(InputError, match="no timing within the limits"):
        follows(STIFF.with_({"joints.shoulder.limits.effort": 5.0}), LINE)


ROUGH = {f"joints.shoulder.limits.{name}": value for name, value in
         {"speed": 1.0, "acceleration": 3.0, "jerk": 20.0}.items()}  # fmt: skip


def test_bounded_jerk_of_a_line_of_the_joints() -> None:
    """All joints on the line in the least time: 1.78333333333320 s by Ruckig 0.19.4, phase synchronization."""
    quick = {f"joints.elbow.limits.{name}": value for name, value in
             {"speed": 3.0, "acceleration": 9.0, "jerk": 70.0}.items()}  # fmt: skip
    path = {"type": "joints", "points": [[0.9, -0.4]]}
    found = ARM.with_(ROUGH | quick).follow(path, profile={"type": "jerk_limited"})
    assert found.duration == pytest.approx(1.7833333333332, abs=1e-10)
    half = ARM.with_(ROUGH | quick).follow(path, profile={"type": "jerk_limited", "acceleration": 1.5, "share": 0.5})
    assert np.abs(half.found.accelerations).max() == pytest.approx(0.75, rel=1e-9)


def test_bounded_jerk_on_a_curve_reaches_one_limit_and_passes_none() -> None:
    arm = STIFF.with_(ROUGH | {"joints.shoulder.limits.effort": 45.0})
    path, needs = arm.follow(LINE, profile={"type": "jerk_limited", "jerk": 40.0}).found, Arm(arm)
    efforts = np.array([needs.efforts(*row) for row in zip(path.values, path.rates, path.accelerations, strict=True)])
    jerks = np.diff(path.accelerations, axis=0) / np.maximum(np.diff(path.times), 1e-12)[:, None]
    shares = [np.abs(path.rates) / [1.0, 6.28], np.abs(path.accelerations[:, 0]) / 3.0, np.abs(efforts) / [45.0, 54.0],
              np.abs(jerks[np.diff(path.times) > 0]) / [20.0, 40.0]]  # fmt: skip
    assert 0.9 < max(float(one.max()) for one in shares) < 1.001
    assert path.times[-1] < 0.78  # 0.906 s where all of an S-curve is slowed


@pytest.mark.parametrize(("speed", "jerk", "effort"), [(1.2, 30.0, 3.0), (0.9, 10.0, 3.0), (2.0, 30.0, 8.0)])
def test_an_effort_slows_no_more_than_it_must(speed: float, jerk: float, effort: float) -> None:
    """An inertia of 2 kg m^2: the effort is a limit of its acceleration, with which the least time is an S-curve's."""
    ways, moment, gain = np.linspace(0.0, 1.5, 20), 2.0, 8.0
    fast, quick, soft, strong = (np.array([one]) for one in (speed, gain, jerk, effort))
    course = JointCourse(ways, ways[:, None], fast, quick, soft, strong, lambda q, v, a: moment * a)
    found = Signal.of(Timing.of({"type": "jerk_limited"}).signal(course))
    least, slowed = (
        SCurve(type="s_curve", start=0.0, end=1.5, speed=speed, acceleration=one, jerk=jerk).length()
        for one in (effort / moment, gain)
    )
    assert least <= found.length() < 1.015 * least
    assert found.length() < 0.8 * slowed * (moment * gain / effort) ** 0.5  # as a whole
    times = np.linspace(0.0, found.length(), 2000)[1:-1]
    for order, most in ((1, speed), (2, effort / moment), (3, jerk)):
        assert np.abs(found.schedule(found.length()).at(times, order)).max() <= most * 1.0001


def test_bounded_jerk_needs_a_limit_of_jerk_and_joints_that_stand() -> None:
    with pytest.raises(InputError, match="no limit of jerk"):
        STIFF.follow(LINE, profile={"type": "jerk_limited"})
    weak = STIFF.with_({"joints.shoulder.limits.effort": 5.0})
    with pytest.raises(InputError, match="no timing within the limits"):
        weak.follow(LINE, profile={"type": "jerk_limited", "jerk": 40.0})
