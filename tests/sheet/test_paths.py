"""Changes by path, the real arm, and the sheet written out and read back."""

from __future__ import annotations

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sheet.cases import SECTION, arm_of, beam, body, joint, problem, sheet
from tmodes.errors import InputError, InputErrors
from tmodes.io.sheet_check import sheet_data, sheet_from_data
from tmodes.io.sheet_write import robot_to_yaml
from tmodes.io.yaml_file import parse_yaml
from tmodes.kinds.links.material import LIBRARY
from tmodes.sheet import Robot

ROUND = {"shape": "round", "diameter": 0.02}


@pytest.fixture
def arm() -> Robot:
    return arm_of(sheet())


@pytest.mark.parametrize("path", ["joints.shoulder.gear.stiffness", "joints.0.gear.stiffness"])
def test_a_change_by_name_or_number(arm: Robot, path: str) -> None:
    found = arm.with_({path: "1 kN*m/rad"})
    assert found.joints[0].gear is not None
    assert found.joints[0].gear.stiffness == (1000.0,)
    assert arm.joints[0].gear is not None
    assert arm.joints[0].gear.stiffness == (4700.0,)


def test_what_the_sheet_leaves_out_can_be_set(arm: Robot) -> None:
    changes = {
        "joints.elbow.motor.inertia": 0.1,
        "joints.elbow.motor.side": "joint",
        "joints.elbow.origin.position.0": 1,
    }
    with pytest.raises(InputError):
        arm.with_(changes)
    del changes["joints.elbow.origin.position.0"]
    found = arm.with_({**changes, "joints.elbow.origin.position": [1, 2, 3], "gravity.2": -1.62})
    assert found.joints[1].motor is not None
    assert found.joints[1].motor.inertia == 0.1
    assert found.gravity == (0.0, 0.0, -1.62)


def test_names_with_dots() -> None:
    data = sheet(joints=[joint("a.b", "l.k"), joint("a", "m")])
    data["links"] = [{"name": "l.k", "bodies": [body()]}, {"name": "m", "bodies": [body()]}]
    found = arm_of(data).with_({"joints.a.b.locked_at": 0.1, "joints.a.b.state": "locked"})
    assert (found.joints[0].locked_at, found.joints[1].locked_at) == (0.1, 0.0)


@pytest.mark.parametrize(
    ("path", "hint"),
    [
        ("joints.sholder.gear.stiffness", "Did you mean `joints.shoulder.gear.stiffness`?"),
        ("joints.shoulder.gear.stifness", "Did you mean `joints.shoulder.gear.stiffness`?"),
        ("joints.7.gear.stiffness", ""),
        ("joint.shoulder", "Did you mean `joints.shoulder`?"),
        ("", ""),
        ("joints.shoulder.gear.stiffness.0.0", ""),
        ("a" * 600, ""),
        ("joints..gear", ""),
        ("__class__", ""),
    ],
)
def test_paths_that_lead_nowhere(arm: Robot, path: str, hint: str) -> None:
    with pytest.raises(InputError) as caught:
        arm.with_({path: 1.0})
    assert hint in str(caught.value)


def test_a_wrong_change_is_reported_by_its_path(arm: Robot) -> None:
    with pytest.raises(InputErrors, match=r"links\.upper\.beam\.length must be"):
        arm.with_({"links.upper.beam.length": -1.0})


def test_the_real_arm_is_the_known_one_times_its_factors() -> None:
    real = {
        "joints.shoulder.gear.stiffness": 0.8,
        "links.upper.beam.section.bending_stiffness": 0.9,
        "links.fore.bodies.0.mass": 1.5,
        "gravity": 0.5,
    }
    pair = arm_of(sheet(real=real)).pair()
    assert pair.nominal.joints[0].gear.stiffness == (4700.0,)
    assert pair.real.joints[0].gear.stiffness == (0.8 * 4700.0,)
    assert pair.real.links[0].beam.section.bending_stiffness == (108.0, 72.0)
    assert pair.real.links[1].bodies[0].mass == 1.5
    assert pair.real.gravity == (0.0, 0.0, -9.81 / 2)
    assert pair.real.real == {}


def test_an_arm_known_exactly_is_its_own_real_one(arm: Robot) -> None:
    assert arm.pair().real is arm


def test_a_factor_on_a_material_of_the_library() -> None:
    data = sheet(real={"links.upper.beam.material.young": 0.5})
    data["links"][0]["beam"].update(section=ROUND, material="steel")
    found = arm_of(data).pair().real.links[0].beam.material
    assert found.young == LIBRARY["steel"].young / 2
    assert found.density == LIBRARY["steel"].density


def test_what_is_rigid_stays_rigid() -> None:
    """Any factor but zero, which would make a gear of no stiffness of it."""
    data = sheet(real={"joints.shoulder.gear.stiffness": 0.5})
    data["joints"][0]["gear"]["stiffness"] = math.inf
    assert arm_of(data).pair().real.joints[0].gear.stiffness == (math.inf,)
    assert "real.joints.shoulder.gear.stiffness must be" in problem(
        {**data, "real": {"joints.shoulder.gear.stiffness": 0.0}}
    )


@pytest.mark.parametrize(
    ("real", "words"),
    [
        ({"joints.sholder.gear.stiffness": 1}, "Did you mean `real.joints.shoulder.gear.stiffness`?"),
        ({"joints.shoulder.gear.stiffness": -1}, "real.joints.shoulder.gear.stiffness must be"),
        (
            {"links.upper.beam.section.bending_stiffness": 1e6, "joints.shoulder.gear.stiffness": 1e7},
            "not more than 1000000",
        ),
        ({"joints.shoulder.gear.stiffness": 0}, "got 0.0 times 4700.0;"),
        ({"joints.shoulder.name": 2}, "names no number"),
        ({"links.upper.beam.functions.bend_y": 2}, "names no number"),
        ({"integration.duration": 2}, "names no number"),
        ({"joints.elbow.motor.inertia": 2}, "a number that the sheet leaves out"),
    ],
)
def test_factors_that_are_none(real, words: str) -> None:
    assert words in problem(sheet(real=real))


def read_back(arm: Robot) -> Robot:
    text = robot_to_yaml(arm)
    data, positions = parse_yaml(text, "written.yaml")
    return sheet_from_data(data, positions, "written.yaml")


NAMES = st.sampled_from(["yes", "on", "null", "1", "a b", "x: y", "#", "'", '"', "é", "-", "1e5", "a.b", "~", "0x1f"])
NUMBER = st.floats(-1e3, 1e3)
VECTOR = st.lists(NUMBER, min_size=3, max_size=3)
SIGNAL = st.one_of(
    st.fixed_dictionaries({"type": st.just("constant"), "value": NUMBER}),
    st.fixed_dictionaries({"type": st.just("quintic"), "start": NUMBER, "end": NUMBER, "duration": st.just(2.0)}),
    st.fixed_dictionaries({"type": st.just("expression"), "formula": st.just("0.2*sin(2*pi*t)")}),
    st.just({"type": "table", "times": [0.5 * k for k in range(30)], "values": [1.0] * 30, "interpolation": "cubic"}),
)


@st.composite
def arms(draw):
    """Right sheets of any tree, with every kind of joint, drive and link."""
    count = draw(st.integers(1, 5))
    names = draw(st.lists(NAMES, min_size=count, max_size=count, unique=True))
    joints, links, drives = [], [], []
    for k, name in enumerate(names):
        kind = draw(st.sampled_from(["revolute", "prismatic", "fixed"]))
        one = {"name": name, "type": kind, "child": f"link {k}"}
        one["parent"] = "base" if k == 0 else f"link {draw(st.integers(0, k - 1))}"
        one["origin"] = {"position": draw(VECTOR), "rpy": draw(VECTOR)}
        one["from"] = draw(st.sampled_from(["tip", "frame"]))
        if kind != "fixed":
            one["axis"] = draw(VECTOR.filter(lambda v: any(abs(x) > 1e-3 for x in v)))
            one["limits"] = {"lower": -draw(st.floats(0, 3)), "upper": 1.0}
            if draw(st.booleans()):
                one["motor"] = {"inertia": 0.1, "side": "motor", "ratio": draw(st.floats(1, 200))}
                one["gear"] = {"stiffness": draw(st.sampled_from([900.0, [1.0, 2.0], math.inf])), "damping": 0.5}
                if one["gear"]["stiffness"] == [1.0, 2.0]:
                    one["gear"]["torque_limits"] = [3.0]
            if draw(st.booleans()):
                one |= {"state": "locked", "locked_at": draw(st.floats(-3, 3))}
            elif draw(st.booleans()):
                command = "prescribed" if "gear" not in one else "torque"
                drives.append({"joint": name, "command": command, "signal": draw(SIGNAL)})
        joints.append(one)
        links.append({"name": f"link {k}", **draw(st.sampled_from(LINKS))})
    return sheet(joints=joints, links=links, drives=drives, gravity=draw(VECTOR), base={"quaternion": [0.6, 0, 0, 0.8]})


MOUNT = {"position": [0, 0.1, 0]}
FLAT = {**SECTION, "bending_stiffness": [math.inf, 3.0]}

LINKS = [
    {"bodies": [body(center=[0.1, 0.2, 0.3], rpy=[0.1, 0.2, 0.3])]},
    {"beam": beam(), "bodies": [body(at=0.5)]},
    {"beam": beam(model="segments", segments=2), "bodies": [body()]},
    {"beam": beam(section=ROUND, material="steel", taper={"section": {"shape": "round", "diameter": 0.015}})},
    {
        "beam": beam(
            functions={"twist": 2, "bend_y": 3}, rest_curvature=[0.1, 0, 1], root_mount={"position": [0, 0.1, 0]}
        )
    },
    {
        "beam": beam(section={**SECTION, "bending_stiffness": [math.inf, 3.0]}, damping_time=0.1 + 0.2),
        "bodies": [body()],
    },
]


@settings(max_examples=30)
@given(arms())
def test_a_written_sheet_reads_back_as_the_same_arm(data) -> None:
    arm = arm_of(data)
    assert read_back(arm) == arm
    assert arm_of(sheet_data(arm)) == arm


@settings(max_examples=100)
@given(arms())
def test_the_chain_of_any_right_sheet_is_sound(data) -> None:
    """Parents first, rotations that are rotations, directions of length one, names once, points on nodes."""
    import numpy as np

    chain = arm_of(data).chain()
    names = [node.name for node in chain.nodes]
    assert len(set(names)) == len(names)
    for index, node in enumerate(chain.nodes):
        assert -1 <= node.parent < index
        rotation = node.joint.placement.rotation
        np.testing.assert_allclose(rotation @ rotation.T, np.eye(3), atol=1e-13)
        assert np.linalg.det(rotation) > 0
        assert np.linalg.norm(node.joint.axis) == pytest.approx(1, abs=1e-13)
    assert all(0 <= point.node < len(names) and 0 <= point.s <= 1 for point in chain.points)


@pytest.mark.parametrize(
    ("path", "same"),
    [
        ("drives.shoulder.signal.end", "drives.0.signal.end"),
        ("loads.hand.force.2", "loads.0.force.2"),
        ("points.hand.position.0", "points.0.position.0"),
        ("links.forearm.bodies.cup.mass", "links.1.bodies.0.mass"),
    ],
)
def test_items_of_every_list_are_known_by_what_they_belong_to(path: str, same: str) -> None:
    data = sheet()
    data["links"] = [{"name": data["joints"][0]["child"], "bodies": [body()]},
                     {"name": "forearm", "bodies": [{**body(), "name": "cup"}]}]  # fmt: skip
    data["joints"][1]["child"] = "forearm"
    data["points"] = [{"name": "hand", "link": "forearm", "position": [0.1, 0, 0]}]
    data["loads"] = [{"point": name, "force": [0, 0, -1.0], "frame": "world"} for name in ("hand", "tip")]
    data["drives"] = [{"joint": data["joints"][0]["name"], "command": "prescribed",
                       "signal": {"type": "quintic", "start": 0.0, "end": 0.5, "duration": 1.0}}]  # fmt: skip
    arm = arm_of(data)
    assert arm.with_({path: 0.25}) == arm.with_({same: 0.25})
    assert arm.with_({path: 0.25}) != arm
    with pytest.raises(InputError, match="Did you mean"):
        arm.with_({path.replace(path.split(".")[1], path.split(".")[1] + "x"): 0.25})
