"""The path that a slider shows is what `--set` takes: the same number changes, by as much."""

from __future__ import annotations

import math

import pytest

import tmodes
from tmodes.errors import InputError
from tmodes.io.assignment import parse_assignment
from tmodes.io.sheet_check import sheet_data
from tmodes.live.knobs import knobs_of
from tmodes.live.sliders import sliders_of
from tmodes.robots import names
from tmodes.sheet import Robot
from tmodes.studio.sheets import plain_sheet, slider_records


def loaded(name: str, assignment: str = "") -> Robot:
    """The robot as `tmodes run NAME --set ASSIGNMENT` takes it."""
    try:
        return tmodes.load(name, dict([parse_assignment(assignment)]) if assignment else None)
    except InputError as error:
        if "not installed" in str(error):
            pytest.skip(str(error))
        raise


@pytest.mark.parametrize("name", names())
def test_the_path_of_a_slider_sets_it(name: str) -> None:
    robot = loaded(name)
    knobs = knobs_of(robot)
    sliders = sliders_of(robot, knobs, most=1000)
    assert [(one["path"], one["design"]) for one in slider_records(robot, plain_sheet(robot))] == [
        (slider.path, slider.design) for slider in sliders_of(robot, knobs)
    ]
    for slider in sliders:
        value = slider.low + 0.37 * (slider.high - slider.low)
        changed = sheet_data(loaded(name, f"{slider.path}={value!r}"))
        assert changed == sheet_data(robot.with_(slider.changes(knobs[slider.knob], value))), slider.path
        assert changed != sheet_data(robot)


def test_design_variables_are_none_of_the_surroundings_and_of_the_task() -> None:
    robot = loaded("filipovic2010")
    sliders = [slider.info() for slider in sliders_of(robot, knobs_of(robot, others=True), most=1000)]
    given = {slider["group"] for slider in sliders if not slider["design"]}
    assert {slider["group"] for slider in sliders if slider["design"]} == {"gear", "links", "motor", "controller"}
    assert {"payload", "move", "environment", "gravity"} <= given
    assert not any(slider["path"].startswith("real:") or "friction" in slider["path"]
                   for slider in sliders if slider["design"])  # fmt: skip


def test_constants_of_a_material_and_damping_are_no_design_variables_but_sections_are() -> None:
    """The designer of an arm chooses tube, gear and gains; the sixteen settings that lead have them."""
    robot = tmodes.load("two_link_arm")
    design = {one.path: one.design for one in sliders_of(robot, knobs_of(robot)) if not one.real}
    wanted = ("shoulder.gear.stiffness.0", "section.outer_diameter", "section.thickness", "controller.position_gain")
    assert all(any(chosen and path.endswith(name) for path, chosen in design.items()) for name in wanted)
    assert not any(
        chosen and path.endswith(("young", "damping", "mass", "duration")) for path, chosen in design.items()
    )


ALL = "joints.*.gear.stiffness"


def test_groups_follow_what_was_changed_before_them() -> None:
    """Each change is of what those before it have left; a list may be meant by its own path or by that of its items."""
    robot = tmodes.load("manutec_r3")
    first = robot.joints[0].name
    base = {joint.name: joint.gear.stiffness for joint in robot.joints if joint.gear}
    changes = {f"joints.{first}.gear.stiffness": [10.0], ALL: 2.0, f"{ALL}.*": 1.5, f"joints.{first}.gear.damping": 7.0}
    after = {joint.name: joint.gear for joint in robot.with_(changes).joints if joint.gear}
    assert after[first].damping == 7.0
    for name, stiffness in (base | {first: (10.0,)}).items():
        assert after[name].stiffness == pytest.approx([3.0 * value for value in stiffness], rel=1e-15)
    assert sheet_data(tmodes.load("manutec_r3", changes)) == sheet_data(robot.with_(changes))


def test_one_of_several_numbers_for_which_the_sheet_has_one() -> None:
    (gear,) = (joint.gear for joint in tmodes.load("spong1987", {"joints.joint.gear.stiffness.0": 70.0}).joints)
    assert gear
    assert gear.stiffness == (70.0,)


@pytest.mark.parametrize(
    ("path", "value", "words"),
    [
        (ALL, 0.0, "a factor from 0.001 to 1000"),
        (ALL, True, "a factor"),
        ("real:gear.stiffness", float("nan"), "a factor"),
        ("joints.*.gear.stifness", 2.0, "no number there"),
        ("*.gear", 2.0, "no number there"),
        ("real:joints.nowhere.gear.stiffness", 2.0, "unknown"),
    ],
)
def test_what_is_no_factor_or_no_number_is_refused(path: str, value: object, words: str) -> None:
    with pytest.raises(InputError, match=words):
        tmodes.load("filipovic2010", {path: value})


def test_a_factor_that_acts_on_others_too_is_not_taken_for_one_of_its_own() -> None:
    robot = loaded("ur5_elastic").with_({"real.joints.shoulder_pan_joint.gear.stiffness": 0.9})
    with pytest.raises(InputError, match="several factors"):
        robot.with_({"real:joints.shoulder_pan_joint.gear.stiffness.0": 0.5})


@pytest.mark.parametrize(("value", "stiffness"), [("5 kNm/rad", 5e3), ("inf", math.inf), (math.inf, math.inf)])
def test_a_value_with_its_unit_sets_all(value: object, stiffness: float) -> None:
    changed = tmodes.load("manutec_r3").with_({"joints.*.gear.stiffness": value})
    found = [one for joint in changed.joints if joint.gear for one in joint.gear.stiffness]
    assert found
    assert set(found) == {stiffness}
