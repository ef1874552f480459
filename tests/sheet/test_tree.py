"""The tree of joints and the masses that they move: what is no robot is refused with the names."""

from __future__ import annotations

import pytest

from sheet.cases import body, changed, joint, one_link, problem, sheet

LINKS = [{"name": name, "bodies": [body()]} for name in "abcd"]


def said(*joints, links=LINKS, **more) -> str:
    return problem(sheet(joints=list(joints), links=links, **more))


def test_an_empty_robot() -> None:
    assert "joints must be at least one joint, got an empty robot" in said(links=[])


def test_a_disconnected_link_is_named() -> None:
    assert "links.b.name must be" in said(joint("j", "a"), links=LINKS[:2])


def test_a_link_with_two_parents_names_the_joints() -> None:
    info = said(joint("j", "a"), joint("k", "b"), joint("l", "a", parent="b"), links=LINKS[:2])
    assert (
        "joints.l.child must be a link that no other joint carries, got `a`, which has 2 parents: the joints j, l"
        in info
    )


def test_a_cycle_names_its_links() -> None:
    info = said(joint("j", "a"), joint("k", "b", parent="c"), joint("l", "c", parent="b"), links=LINKS[:3])
    assert "a cycle of the links c -> b -> c" in info
    assert info.count("cycle") == 1


def test_a_cycle_with_a_tail() -> None:
    joints = [joint("j", "a", parent="b"), joint("k", "b", parent="a"), joint("l", "c", parent="b")]
    info = said(*joints, links=LINKS[:3])
    assert info.count("a cycle of the links") == 1
    assert "c" not in info.split("cycle of the links")[1].split(",")[0]


def test_a_self_loop() -> None:
    assert "joints.j.parent must be another link, got `a`, the link that it carries" in said(
        joint("j", "a", parent="a"), links=LINKS[:1]
    )


def test_an_unknown_parent() -> None:
    info = said(joint("j", "a"), joint("k", "b", parent="aa"), links=LINKS[:2])
    assert "joints.k.parent must be one of base, a, b" in info


def test_names_twice() -> None:
    info = said(joint("j", "a"), joint("j", "b"), links=[*LINKS[:2], LINKS[0]])
    assert "joints.j.name must be a name that none of the other joints has, got the name `j` a second time" in info
    assert "links.a.name must be a name that none of the other links has, got the name `a` a second time" in info


def test_the_base_is_the_ground() -> None:
    assert "`base`, the ground" in said(joint("j", "a"), joint("k", "base", parent="a"), links=LINKS[:1])
    assert "`base`, the ground" in said(joint("j", "a"), links=[LINKS[0], {"name": "base"}])


@pytest.mark.parametrize("axis", [[0, 0, 0], None])
def test_an_axis_without_direction(axis) -> None:
    assert "joints.j.axis" in said(joint("j", "a", axis=axis), links=LINKS[:1])


def test_a_fixed_joint_has_no_axis_and_no_motor() -> None:
    info = said(joint("j", "a", type="fixed", motor={"inertia": 1, "side": "joint"}), links=LINKS[:1])
    assert "joints.j.axis must be left out, got an axis of a fixed joint" in info
    assert "joints.j.motor must be left out: the joint does not move, got a motor on a fixed joint" in info


def test_limits_in_order() -> None:
    info = said(joint("j", "a", limits={"lower": 1, "upper": "-60 deg"}), links=LINKS[:1])
    assert "joints.j.limits.lower must be at most `upper`, -1.04" in info


def test_a_massless_end_that_moves_is_named() -> None:
    info = said(joint("j", "a"), joint("k", "b"), links=LINKS[:1])
    assert "joints.k must be a joint that moves mass, got `b`, a link that has no mass and is moved by `k`" in info
    assert "joints.j" not in info


def test_a_massless_link_between_others_is_right() -> None:
    assert said(joint("j", "a"), joint("k", "b", axis=[1, 0, 0]), links=[LINKS[1]]) == ""
    assert said(joint("j", "a"), {**joint("k", "b"), "type": "fixed", "axis": None}, links=LINKS[:1]) == ""


@pytest.mark.parametrize(
    ("center", "right"), [([0, 0, 1], False), ([0, 0, -3.7], False), ([1e-3, 0, 1], True), ([0, 1, 0], True)]
)
def test_a_point_mass_on_the_axis_has_no_inertia_about_it(center, right: bool) -> None:
    info = problem(one_link({"bodies": [{"mass": 1, "center": center}]}))
    assert (info == "") == right
    assert right or "has no inertia about the axis of `pivot`" in info


def test_a_point_mass_on_an_oblique_axis() -> None:
    """Only a general position shows it: the second axis passes through the mass in every position of the first."""
    origin = {"position": [0.3, 0.1, 0.2], "rpy": [0.5, 0.6, 0.7]}
    links = [LINKS[0], {"name": "b", "bodies": [{"mass": 1, "center": [2, 4, 6]}]}]
    info = said(joint("j", "a"), joint("k", "b", origin=origin, axis=[1, 2, 3]), links=links)
    assert "joints.k must be a joint that moves mass, got `b`, a link that has no inertia about the axis of `k`" in info
    assert "joints.j" not in info


def test_a_mass_that_is_on_an_axis_in_one_position_only() -> None:
    """An arm stretched up along its first axis: right, because its second joint takes the mass off that axis."""
    links = [{"name": "b", "bodies": [{"mass": 1, "center": [0, 0, 1]}]}]
    assert said(joint("j", "a"), joint("k", "b", axis=[1, 0, 0]), links=links) == ""


@pytest.mark.parametrize(("x", "right"), [(-0.7, False), (0.7, True)])
def test_a_mass_brought_back_to_an_axis_by_a_fixed_joint(x: float, right: bool) -> None:
    origin = {"position": [0, 0.7, 0.2], "rpy": [0, 0, 1.5707963267948966]}
    fixed = {"name": "k", "type": "fixed", "child": "b", "origin": origin}
    info = said(joint("j", "a"), fixed, links=[{"name": "b", "bodies": [{"mass": 1, "center": [x, 0, 0]}]}])
    assert (info == "") == right
    assert (
        right
        or "joints.j must be a joint that moves mass, got `a`, a link that has no inertia about the axis of `j`" in info
    )


def test_a_rotor_behind_a_rigid_gear_is_inertia_enough() -> None:
    motor = {"inertia": 0.1, "side": "joint"}
    link = {"bodies": [{"mass": 1, "center": [0, 0, 1]}]}
    assert problem(one_link(link, motor=motor)) == ""
    assert "no inertia" in problem(one_link(link, motor=motor, gear={"stiffness": 9, "damping": 0}))


def test_a_rotor_without_inertia_where_it_does_not_turn_by_itself() -> None:
    """Locked or behind a rigid gear; there the link has the inertia."""
    motor, gear = {"inertia": 0, "side": "joint"}, {"stiffness": 9, "damping": 0}
    link = {"bodies": [{"mass": 1, "center": [0, 1, 0]}]}
    assert problem(one_link(link, motor=motor)) == ""
    assert problem(one_link(link, motor=motor, gear=gear, state="locked")) == ""
    assert "motor.inertia must be an inertia > 0" in problem(one_link(link, motor=motor, gear=gear))
    assert "no inertia" in problem(one_link({"bodies": [{"mass": 1, "center": [0, 0, 1]}]}, motor=motor))


def test_inertia_without_mass_is_enough_to_turn_and_not_to_slide() -> None:
    link = {"bodies": [{"mass": 0, "center": [0, 1, 0], "inertia": {"xx": 0.1, "yy": 0.1, "zz": 0.1}}]}
    assert problem(one_link(link)) == ""
    assert "has no mass" in problem(one_link(link, type="prismatic"))


def test_a_sliding_mass_needs_no_inertia() -> None:
    assert problem(one_link({"bodies": [{"mass": 1}]}, type="prismatic")) == ""


def test_a_name_that_a_part_of_a_link_has_already() -> None:
    def named(data):
        data["links"][0]["beam"].update(model="segments", segments=2)
        data["links"][1]["name"] = data["joints"][1]["child"] = "upper.2"

    assert (
        "links must be links whose names no part of a link has, got `upper.2`, also the name of a part of a link"
        in problem(changed(named))
    )


@pytest.mark.parametrize(("place", "mass", "right"), [(0.0, 0, False), (0.0, 1, True), (0.5, 0, True)])
def test_joints_that_move_one_mass_alike_are_refused(place: float, mass: float, right: bool) -> None:
    """Two hinges about one axis, a link without mass between them: the mass matrix is singular in every position."""
    links = [
        {"name": name, "bodies": [{"mass": size, "center": [0.2, 0, 0]}]} for name, size in (("a", mass), ("b", 1))
    ]
    info = said(joint("j", "a"), joint("k", "b", origin={"position": [place, 0, 0]}), links=links)
    assert (info == "") == right
    assert right or "got `b`, a link that moves with `k` only as it does with the joints before; give `b`" in info
