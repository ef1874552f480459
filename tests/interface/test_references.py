"""References that know what bends: against closed forms, and each against the one that knows less."""

from __future__ import annotations

import copy
from typing import Any

import numpy as np
import pytest

import tmodes
from random_sheets import rotation, turned
from tmodes.analysis.follow import Arm
from tmodes.errors import InputError, InputErrors
from tmodes.io.sheet_check import sheet_data
from tmodes.kinds.signals.registry import Signal
from tmodes.robots import installed_models

LINE = {"type": "line", "to": [0.7, 0.0, 0.2]}
SMOOTH = {"type": "polynomial", "duration": 1.0}


def checks(robot: Any, path: Any, duration: float, more: tuple[str, ...] = ()) -> dict[str, dict[str, float]]:
    """Largest distance of the tip from the path [m] of all references but the optimal one, and of ``more``."""
    found = {}
    for reference in ("motors", "sag", "quasi_static", "inverse", *more):
        profile = SMOOTH | {"duration": duration}
        found[reference] = dict(robot.follow(path, profile=profile, reference=reference).checks)
    return found


def test_the_inverse_of_an_elastic_joint_is_that_of_its_equations() -> None:
    """J th'' + k (th - q) = u and I q'' + m g l sin q = k (th - q), with four derivatives of q; u to 2e-4."""
    robot = tmodes.load("spong1987")
    own = robot.follow({"type": "joints", "points": [[1.0]]}, profile=SMOOTH, reference="inverse")
    move = Signal.of(SMOOTH | {"start": 0.0, "end": 1.0}).schedule(2.0)
    times = np.linspace(0.05, 0.95, 181)
    q, rate, push, _, fourth = (move.at(times, order) for order in range(5))
    motor = q + (push + 9.8 * np.sin(q)) / 100
    turned = push + (fourth + 9.8 * (np.cos(q) * push - np.sin(q) * rate**2)) / 100
    drive = own.robot.drives[0]
    assert drive.signal.schedule(2.0).at(times + own.lead) == pytest.approx(motor, abs=1e-8)
    effort = 0.3 * turned + push + 9.8 * np.sin(q)
    given = drive.feed_forward.schedule(2.0).at(times + own.lead)
    assert given == pytest.approx(effort, abs=2e-4 * np.abs(effort).max())
    assert own.checks["this"] < 1e-9
    assert own.checks["open loop"] < 1e-8
    assert own.warnings == []


def test_references_of_an_arm_with_a_flexible_link_are_a_hierarchy() -> None:
    found = checks(tmodes.load("two_link_arm"), LINE, 1.0)
    rigid = found["motors"]["rigid"]
    assert found["motors"]["this"] < rigid
    assert found["sag"]["this"] < rigid / 3
    assert found["quasi_static"]["this"] < found["sag"]["this"] / 100
    assert found["inverse"]["this"] < 1e-8
    assert found["inverse"]["open loop"] < 1e-6


def test_references_of_the_robot_of_2010_are_a_hierarchy() -> None:
    """In two periods of its first mode, without weight; what the inverse leaves is across the way of its one joint."""
    robot = tmodes.load("filipovic2010", {"contact": False, "gravity": 0.0})
    found = checks(robot, {"type": "joints", "points": [[0.7]]}, 0.4)
    rigid = found["motors"]["rigid"]
    assert found["motors"]["this"] < rigid
    assert found["sag"]["this"] < rigid
    for way in ("this", "open loop"):
        assert found["quasi_static"][way] < rigid / 30
        assert found["inverse"][way] < found["quasi_static"][way] / 3
        assert found["inverse"][way] < found["sag"][way] / 100


def test_the_quasi_static_reference_of_a_joint_is_that_of_its_equations() -> None:
    """Nothing else bends, so that k (th - q) = I q'' + m g l sin q is all."""
    found = tmodes.load("spong1987").follow(
        {"type": "joints", "points": [[1.0]]}, profile=SMOOTH, reference="quasi_static"
    )
    times = found.motors.positions.times
    q, push = (Signal.of(SMOOTH | {"start": 0.0, "end": 1.0}).schedule(2.0).at(times, order) for order in (0, 2))
    assert found.motors.positions.values[:, 0] == pytest.approx(q + (push + 9.8 * np.sin(q)) / 100, abs=1e-5)
    assert found.checks["this"] < 1e-6


def test_accelerations_that_jump_are_said() -> None:
    arm, jumps = tmodes.load("two_link_arm"), {"type": "trapezoid", "speed": 0.6, "acceleration": 4.0}
    assert arm.follow(LINE, profile=jumps, reference="quasi_static").warnings
    smooth = {"type": "s_curve", "speed": 0.6, "acceleration": 4.0, "jerk": 60.0}
    found = {kind: arm.follow(LINE, profile=smooth, reference=kind) for kind in ("sag", "quasi_static")}
    assert not found["quasi_static"].warnings
    assert found["quasi_static"].checks["this"] < found["sag"].checks["this"] / 50


def test_an_estimator_knows_the_efforts_of_the_inverse() -> None:
    """Measured at the motors alone; 30 mm where its filter does not know them, 1.7 mm without them."""
    robot = tmodes.load("two_link_arm")
    names = [drive.joint for drive in robot.drives]
    weights = {f"{name}.motor{rate}": weight for name in names for rate, weight in (("", 1e6), ("'", 1e3))}
    noise = {f"{name}{rate}": 1e-3 for name in names for rate in (".motor'", "'")}
    block = {"type": "lqg", "sample_time": 1e-3, "measured": [f"{name}.motor.position" for name in names],
             "measurement_noise": [1e-9], "state_weights": weights, "process_noise": noise}  # fmt: skip
    law = {"control": [{"name": "law", "drives": names, "block": block}]}
    own = robot.with_(law | {f"drives.{k}.controller": None for k in range(2)})
    found = own.follow(LINE, profile=SMOOTH, reference="inverse")
    assert found.checks["rigid"] > 5e-3
    assert found.checks["this"] < 1e-9
    assert found.swings["this"] < 1e-9
    assert {*found.robot.control[0].block.reference} == {"shoulder", "elbow", "forearm.bend_y1", "forearm.bend_y2"}
    again = found.robot.follow(LINE, profile=SMOOTH)
    assert not again.robot.control[0].block.reference


def test_rigid_links_behind_elastic_gears_follow_exactly() -> None:
    """The six joints of the Manutec r3, 1e-6 of the way of its tip."""
    robot = tmodes.load("manutec_r3")
    own = robot.follow({"type": "joints", "points": [[0.5, 0.3, -0.4, 0.5, 0.4, 0.3]]},
                       profile=SMOOTH | {"duration": 0.8}, reference="inverse")  # fmt: skip
    assert own.checks["rigid"] > 0.1
    assert own.checks["this"] < 1e-7
    assert own.checks["open loop"] < 1e-7


@pytest.mark.nightly
@pytest.mark.parametrize("turn", [False, True])
@pytest.mark.parametrize("name", ["manutec_r3", "panda_elastic"])
def test_rigid_links_follow_exactly_however_they_stand(name: str, *, turn: bool) -> None:
    """Six and seven joints, as published and on a base of any attitude: 1e-6 of the way of the tip."""
    if name == "panda_elastic" and not installed_models():
        pytest.skip("example-robot-data is not installed")
    sheet = sheet_data(tmodes.load(name))
    robot = tmodes.Robot.from_data(turned(sheet, rotation(3)) if turn else sheet)
    goal = [value + 0.3 for value in Arm(robot).start.values()]
    own = robot.follow({"type": "joints", "points": [goal]}, profile=SMOOTH | {"duration": 0.8}, reference="inverse")
    assert own.checks["rigid"] > 0.04
    assert own.checks["open loop"] < 1e-7


@pytest.mark.nightly
@pytest.mark.skipif(not installed_models(), reason="example-robot-data is not installed")
def test_references_of_a_six_axis_arm_that_bends_are_a_hierarchy() -> None:
    """The UR5 with linear gears and two flexible links: 62 mm in two periods of its first mode, 17 Hz."""
    gears = {f"{side}_joint": 5e4 for side in ("shoulder_pan", "shoulder_lift", "elbow")}
    gears |= {f"wrist_{k}_joint": 6100.0 for k in (1, 2, 3)}
    changes = {f"joints.{name}.gear": {"stiffness": value, "damping": 10.0 if value > 1e4 else 1.0}
               for name, value in gears.items()}  # fmt: skip
    robot = tmodes.load("ur5_elastic", changes)
    free = {f"joints.{joint.name}.limits": None for joint in robot.joints if joint.limits}
    found = checks(robot.with_(free), {"type": "line", "to": [0.597, 0.221, 0.508]}, 0.12, ("optimal",))
    rigid = found["motors"]["rigid"]
    assert found["motors"]["this"] < rigid / 3
    assert found["sag"]["this"] < rigid / 3
    for way in ("this", "open loop"):
        assert found["quasi_static"][way] < rigid / 10
        for best in ("inverse", "optimal"):
            assert found[best][way] < found["quasi_static"][way] / 10


def limited(limits: Any) -> Any:
    """The arm with limits of both joints."""
    return tmodes.load("two_link_arm").with_({f"joints.{joint}.limits": limits for joint in ("shoulder", "elbow")})


def test_the_least_time_is_that_of_the_limits() -> None:
    """A speed by hand: the way of a septic times 35/16 over its duration."""
    turn = {"type": "joints", "points": [[0.2, 0.8]]}
    found = limited({"speed": 0.5}).follow(turn, profile={"type": "septic", "duration": 1.0}, least_time=True)
    assert found.length == pytest.approx(float(np.hypot(0.6, 0.2)))
    assert found.duration == pytest.approx(0.6 * 35 / 16 / 0.5, rel=0.01)
    assert np.abs(found.data["velocity"].values).max() <= 0.5 * (1 + 1e-6)
    with pytest.raises(InputError, match="no limit of speed or effort"):
        limited(None).follow(turn, least_time=True)


@pytest.mark.nightly
def test_the_least_time_keeps_efforts() -> None:
    found = limited({"effort": 60.0}).follow(LINE, reference="sag", least_time=True)
    assert found.motors is not None
    assert found.motors.efforts is not None
    assert 0.98 * 60 < np.abs(found.motors.efforts.values).max() <= 60
    with pytest.raises(InputError, match="however slow"):
        limited({"effort": 5.0}).follow(LINE, reference="sag", least_time=True)


@pytest.mark.nightly
def test_a_redundant_arm_that_bends_follows() -> None:
    """Three joints move the tip in a plane: as the inverse of the rigid one, with what bends."""
    sheet = sheet_data(tmodes.load("two_link_arm"))
    wrist, tool = copy.deepcopy(sheet["joints"][1]), copy.deepcopy(sheet["links"][0])
    wrist |= {"name": "wrist", "parent": "forearm", "child": "hand"}
    tool |= {"name": "hand", "bodies": []}
    tool["beam"]["length"] = 0.15
    drive = copy.deepcopy(sheet["drives"][1]) | {"joint": "wrist"}
    sheet["links"][1]["bodies"][1]["mass"] = 0.5
    sheet |= {"joints": [*sheet["joints"], wrist], "links": [*sheet["links"], tool],
              "drives": [*sheet["drives"], drive]}  # fmt: skip
    line = {"type": "line", "to": [0.65, 0.0, 0.4]}
    found = tmodes.Robot.from_data(sheet).follow(line, profile=SMOOTH, reference="inverse").checks
    assert found["rigid"] > 1e-3
    assert found["this"] < 1e-7
    assert found["open loop"] < 1e-5


@pytest.mark.nightly
def test_what_no_joint_moves_stays_and_the_rest_is_on_the_path() -> None:
    """A joint about the vertical cannot lift what weight bends, 5 mm."""
    robot = tmodes.load("filipovic2010", {"contact": False})
    path, profile = {"type": "joints", "points": [[0.7]]}, SMOOTH | {"duration": 0.4}
    own = robot.follow(path, profile=profile, reference="inverse")
    assert own.checks["this"] < own.checks["rigid"] / 5


@pytest.mark.nightly
def test_without_weight_nothing_is_left_but_the_modes() -> None:
    robot = tmodes.load("filipovic2010", {"contact": False, "gravity": 0.0})
    path, profile = {"type": "joints", "points": [[0.7]]}, SMOOTH | {"duration": 0.4}
    own = robot.follow(path, profile=profile, reference="inverse")
    assert own.checks["this"] < own.checks["rigid"] / 100


def test_efforts_of_a_motor_with_a_winding_are_given_as_a_voltage() -> None:
    """The 2010 robot commands a voltage: its motor stays on its reference to a hundredth of what it is off without."""
    robot = tmodes.load("filipovic2010", {"contact": False, "real": {}})
    path, profile = {"type": "joints", "points": [[0.5]]}, SMOOTH
    found = {}
    for reference in ("rigid", "motors"):
        own = robot.follow(path, profile=profile, reference=reference).robot
        result = own.run()
        wanted = own.drives[0].signal.schedule(2.0).at(result.data["time"].values)
        found[reference] = np.abs(result.data["q"].sel(coordinate="joint.motor").values - wanted).max()
    assert found["motors"] < found["rigid"] / 100


def test_the_run_counts_errors_from_the_path() -> None:
    own = tmodes.load("two_link_arm", {"real": {}}).follow(LINE, profile=SMOOTH, reference="inverse")
    drives = own.robot.drives
    assert own.lead > 0
    assert own.motors.end < 1.15  # where all rests again: no later
    assert drives[0].motion.delay == pytest.approx(own.lead)
    assert own.robot.run().verdict["largest_m"] < 1e-6
    again = tmodes.Robot.from_data(own.robot.model_dump(mode="json", exclude_none=True, by_alias=True))
    assert again.drives == drives


WALL = {"point": "tip", "stiffness": 2e4, "damping": 40.0,
        "shape": {"type": "plane", "position": [0.85, 0.0, 0.0], "normal": [-1.0, 0.0, 0.0]}}  # fmt: skip
ALONG = {"type": "line", "to": [0.87, 0.0, 0.3]}


def pressing(law: dict[str, Any], *, bends: bool = False) -> tmodes.Robot:
    """The arm whose tip, 3 mm deep in a wall, shall go along it and deeper."""
    arm = tmodes.load("two_link_arm", {"real": {}})
    if not bends:
        tube = {"shape": "tube", "outer_diameter": 0.022, "thickness": 0.0015}
        arm = arm.with_({"links.forearm.beam": {"model": "rigid", "length": 0.5, "material": "aluminium_6061",
                                                "section": tube}})  # fmt: skip
    return tmodes.Robot.from_data(
        arm.model_dump(mode="json", exclude_none=True, by_alias=True) | {"contact": WALL | law}
    )


RUBBING = {"friction": 0.2, "friction_velocity": 0.02}


@pytest.mark.parametrize(
    ("law", "bends"),
    [
        ({"law": "bilateral", "mass": 0.5, **RUBBING}, False),
        *(
            pytest.param({"law": law, **RUBBING, **more}, True, marks=pytest.mark.nightly)
            for law, more in (("unilateral", {}), ("dynamic_environment", {"mass": 0.5, "preload": 0.0}))
        ),
    ],
)
def test_in_contact_the_tip_keeps_to_the_path(law: dict[str, Any], bends: bool) -> None:
    """Spring, damper, moving mass and friction of the wall are part of the motion."""
    found = pressing(law, bends=bends).follow(ALONG, profile=SMOOTH, reference="inverse").checks
    assert found["rigid"] > 5e-3
    assert found["this"] < 1e-8
    assert found["open loop"] < 1e-6


def test_what_has_no_inverse_is_said() -> None:
    robot = tmodes.load("filipovic2010")
    for law in ({"law": "unilateral", "mass": 0.1}, {"law": "unilateral", "friction": 0.3}):
        with pytest.raises(InputError) as caught:
            pressing(law).follow(ALONG, reference="inverse")
        assert caught.value.which == "contact"
    with pytest.raises(InputErrors) as wrong:
        robot.follow({"type": "joints", "points": [[0.7]]}, reference="inverted")
    assert [one.which for one in wrong.value.errors] == ["task.reference"]


def test_a_profile_that_is_not_smooth_is_warned_of() -> None:
    own = tmodes.load("spong1987").follow(
        {"type": "joints", "points": [[0.5]]}, profile={"type": "quintic", "duration": 1.0}, reference="inverse"
    )
    assert len(own.warnings) == 1


def most(found: Any) -> float:
    """The largest effort of a reference [N*m]."""
    return float(np.abs(found.motors.efforts.values).max())


TURN = {"type": "joints", "points": [[1.0]]}


def test_the_optimal_one_ends_without_swing_near_the_path() -> None:
    """An elastic joint: near its path and still at the end; within a limit that binds, still at the end."""
    robot = tmodes.load("spong1987")
    own = robot.follow(TURN, profile=SMOOTH | {"duration": 0.8}, reference="optimal")
    assert own.checks["this"] < own.checks["rigid"] / 1000
    assert own.swings["this"] < 1e-6
    assert own.swings["rigid"] > 0.1
    assert own.lead == 0
    assert own.warnings == []
    bounded = robot.with_({"joints.joint.limits": {"effort": 0.9 * most(own)}})
    bound = bounded.follow(TURN, profile=SMOOTH | {"duration": 0.8}, reference="optimal")
    assert bound.warnings == []
    assert most(bound) <= 0.9 * most(own)
    assert bound.swings["open loop"] < 1e-6
    assert own.checks["this"] < bound.checks["this"] < bound.checks["rigid"]


@pytest.mark.nightly
def test_the_optimal_one_in_two_periods_of_the_first_mode() -> None:
    """Far less than a tenth of the error of the sag, on the path and after it: a flexible link, the 2010 robot."""
    profile = SMOOTH | {"duration": 0.26}
    arm = limited(None)
    sag, own = (arm.follow(LINE, profile=profile, reference=one) for one in ("sag", "optimal"))
    assert own.checks["this"] < sag.checks["this"] / 1000
    assert own.checks["open loop"] < sag.checks["open loop"] / 1000
    assert own.swings["this"] < sag.swings["this"] / 1000
    robot = tmodes.load("filipovic2010", {"contact": False, "gravity": 0.0})
    path, profile = {"type": "joints", "points": [[0.7]]}, SMOOTH | {"duration": 0.4}
    sag, own = (robot.follow(path, profile=profile, reference=one) for one in ("sag", "optimal"))
    assert own.checks["this"] < sag.checks["this"] / 100
    assert own.swings["this"] < sag.swings["this"] / 1000


@pytest.mark.nightly
def test_the_least_time_of_the_optimal_one_keeps_the_limit() -> None:
    robot = tmodes.load("spong1987", {"joints.joint.limits": {"effort": 25.0}})
    own = robot.follow(TURN, profile=SMOOTH | {"duration": 0.6}, reference="optimal", least_time=True)
    assert own.warnings == []
    assert 0.97 * 25 < most(own) <= 25
    assert own.swings["open loop"] < 1e-5
    with pytest.raises(InputError, match="no limit of speed or effort"):
        tmodes.load("spong1987").follow(TURN, reference="optimal", least_time=True)


def test_the_optimal_one_comes_back_to_where_it_began() -> None:
    there, back = TURN, {"type": "joints", "points": [[0.0]]}
    own = tmodes.load("spong1987").follow([there, back], profile=SMOOTH | {"duration": 0.8}, reference="optimal")
    assert own.swings["this"] < 1e-6
    assert own.checks["this"] < own.checks["rigid"] / 10
