"""Frames: angles, quaternions and Denavit-Hartenberg rows against SciPy and textbook matrices."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from pydantic import ValidationError
from scipy.integrate import solve_ivp
from scipy.spatial.transform import Rotation

from sheet.cases import arm_of, at, body, joint, matrix, one_link, points, problem, sheet, turned
from tmodes.frame import rotation_vector
from tmodes.io.sheet_plausible import reading_notices
from tmodes.kinds.schema.axes import bent_line, rotation_about, unit
from tmodes.kinds.schema.frames import Convention, DenavitHartenberg, Origin

ANGLE = st.floats(-7, 7)


@given(st.tuples(ANGLE, ANGLE, ANGLE))
def test_rpy_is_that_of_scipy(angles) -> None:
    expected = Rotation.from_euler("xyz", angles).as_matrix()
    np.testing.assert_allclose(Origin(rpy=angles).rotation(), expected, atol=1e-14)


@given(st.tuples(*[st.floats(-1, 1)] * 4).filter(lambda q: np.linalg.norm(q) > 1e-3), st.floats(0.9991, 1.0009))
def test_quaternion_is_that_of_scipy(numbers, length) -> None:
    x, y, z, w = (float(number) for number in np.array(numbers) / np.linalg.norm(numbers) * length)
    numbers = (x, y, z, w)
    expected = Rotation.from_quat(numbers).as_matrix()
    np.testing.assert_allclose(Origin(quaternion=numbers).rotation(), expected, atol=1e-14)


@given(st.tuples(*[st.floats(-1, 1)] * 3).filter(lambda v: np.linalg.norm(v) > 1e-3), ANGLE)
def test_rotation_about_an_axis(vector, angle) -> None:
    axis = unit(vector)
    np.testing.assert_allclose(rotation_about(axis, angle), Rotation.from_rotvec(angle * axis).as_matrix(), atol=1e-14)


@given(st.tuples(*[st.floats(-1, 1)] * 3).filter(lambda v: np.linalg.norm(v) > 1e-3), st.floats(0, 3.1415))
def test_rotation_vector_is_that_of_scipy(vector, angle) -> None:
    matrix = Rotation.from_rotvec(angle * unit(vector)).as_matrix()
    np.testing.assert_allclose(
        rotation_vector(matrix), Rotation.from_matrix(matrix).as_rotvec(), atol=1e-15, rtol=1e-14
    )


@pytest.mark.parametrize("axis", np.eye(3).tolist())
def test_rotation_vector_of_nothing_and_of_half_a_turn(axis) -> None:
    assert rotation_vector(np.eye(3)).tolist() == [0, 0, 0]
    half = 2 * np.outer(axis, axis) - np.eye(3)
    np.testing.assert_allclose(np.abs(rotation_vector(half)), np.pi * np.array(axis), rtol=1e-15)


@pytest.mark.parametrize("scale", [1e-12, 1e-200, 1e12])
def test_unit_of_any_size(scale: float) -> None:
    np.testing.assert_allclose(unit([3 * scale, 0, 4 * scale]), [0.6, 0, 0.8], rtol=1e-15)


@pytest.mark.parametrize(
    ("numbers", "words"),
    [
        ([0, 0, 0, 0], "zeros"),
        ([0, 0, 0.6, 1.6], "length 1.7088"),
        ([0, 0, 0, 1.0011], "length 1.0011"),
        ([0, 0, 0, 0.9989], "length 0.9989"),
    ],
)
def test_quaternions_that_are_none(numbers, words: str) -> None:
    data = sheet(base={"quaternion": numbers})
    assert words in problem(data)
    assert "base.quaternion" in problem(data)


def test_a_rounded_quaternion_is_taken_with_a_notice() -> None:
    arm = arm_of(sheet(base={"quaternion": [0, 0, 0.70711, 0.70711]}))
    np.testing.assert_allclose(arm.chain().base.rotation, Rotation.from_euler("z", np.pi / 2).as_matrix(), atol=1e-15)
    assert [note.split(":")[0] for note in reading_notices(arm)] == ["base"]
    assert reading_notices(arm_of(sheet(base={"quaternion": [0.6, 0, 0, 0.8]}))) == []


def test_two_rotations_at_once() -> None:
    assert "one of the two" in problem(sheet(base={"quaternion": [0, 0, 0, 1], "rpy": [0, 0, 0]}))


def test_an_axis_is_made_of_length_one_with_a_notice() -> None:
    arm = arm_of(one_link({"bodies": [body()]}, axis=[0, 3, 4]))
    np.testing.assert_allclose(arm.chain().nodes[0].joint.axis, [0, 0.6, 0.8], rtol=1e-15)
    assert "joints.pivot.axis: axis of length 5" in reading_notices(arm)[0]


@pytest.mark.parametrize("curvature", [(0, 0, 0), (0, 0, 1e-9), (0.3, -1, 0.02), (0, 0, 0.19), (2, 8, -5)])
def test_bent_line_is_the_integral_of_its_curvature(curvature) -> None:
    def slope(_, state):
        rotation = state[3:].reshape(3, 3)
        x, y, z = curvature
        cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
        return [*rotation[:, 0], *(rotation @ cross).ravel()]

    start = [0, 0, 0, *np.eye(3).ravel()]
    exact = solve_ivp(slope, (0, 0.8), start, rtol=1e-12, atol=1e-13, method="DOP853").y[:, -1]
    rotation, position = bent_line(curvature, 0.8)
    np.testing.assert_allclose(position, exact[:3], atol=1e-11)
    np.testing.assert_allclose(rotation.ravel(), exact[3:], atol=1e-10)


def rx(angle):
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[1, 0, 0, 0], [0, c, -s, 0], [0, s, c, 0], [0, 0, 0, 1]])


def rz(angle):
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s, 0, 0], [s, c, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])


def along(x, z):
    out = np.eye(4)
    out[0, 3], out[2, 3] = x, z
    return out


ROWS = [(0.3, 1.2, 0.2, -0.4), (-0.1, -np.pi / 2, 0.05, 2.0), (0.4, 0.3, -0.2, 0.7)]
"""a, alpha, d, theta of three joints."""


def table(convention: str, rows=ROWS):
    joints = []
    for k, (a, alpha, d, theta) in enumerate(rows):
        row = {"convention": convention, "a": a, "alpha": alpha, "d": d, "theta": theta}
        joints.append({"name": f"j{k}", "type": "revolute", "child": f"l{k}", "dh": row})
    links = [{"name": f"l{k}", "bodies": [body()]} for k in range(len(rows))]
    return arm_of(sheet(joints=joints, links=links))


@given(st.tuples(ANGLE, ANGLE, ANGLE))
def test_standard_rows_are_the_textbook_product(q) -> None:
    expected = np.eye(4)
    for angle, (a, alpha, d, theta) in zip(q, ROWS, strict=True):
        expected = expected @ rz(theta + angle) @ along(0, d) @ along(a, 0) @ rx(alpha)
    found = points(table("standard").chain(), {f"j{k}": float(angle) for k, angle in enumerate(q)})["tip"]
    np.testing.assert_allclose(found, expected, atol=1e-13)


@given(st.tuples(ANGLE, ANGLE, ANGLE))
def test_modified_rows_are_the_textbook_product(q) -> None:
    expected = np.eye(4)
    for angle, (a, alpha, d, theta) in zip(q, ROWS, strict=True):
        expected = expected @ rx(alpha) @ along(a, 0) @ rz(theta + angle) @ along(0, d)
    found = points(table("modified").chain(), {f"j{k}": float(angle) for k, angle in enumerate(q)})["tip"]
    np.testing.assert_allclose(found, expected, atol=1e-13)


def test_the_bodies_of_a_standard_row_are_in_the_frame_at_its_far_end() -> None:
    chain = table("standard", ROWS[:1]).chain()
    a, alpha, _, _ = ROWS[0]
    (found,) = chain.nodes[0].link.bodies
    np.testing.assert_allclose(found.center, [a, 0, 0], atol=1e-15)
    turn = rx(alpha)[:3, :3]
    np.testing.assert_allclose(found.inertia, turn @ np.diag([0.02, 0.03, 0.025]) @ turn.T, atol=1e-16)


def test_rows_of_the_paper_are_chords() -> None:
    rows = [(0.3, 0, 0, 0.2), (0.4, 0, 0, -0.1)]
    found = points(table("paper", rows).chain(), {"j0": 0.5, "j1": 0.25})["tip"]
    np.testing.assert_allclose(found, rz(0.7) @ along(0.3, 0) @ rz(0.15) @ along(0.4, 0), atol=1e-15)


def test_a_row_of_the_paper_with_a_beam_is_as_long_as_the_beam() -> None:
    link = {"name": "rod", "beam": {"model": "segments", "segments": 1, "length": 0.5, "damping_time": 0.0}}
    link["beam"]["section"] = {"bending_stiffness": 1.0, "mass_per_length": 1.0}
    row = {"convention": "paper", "a": 0.5, "alpha": 0, "d": 0, "theta": 0.3}
    data = sheet(joints=[{"name": "j", "type": "revolute", "child": "rod", "dh": row}], links=[link])
    found = points(arm_of(data).chain(), {"j": 0.1})["tip"]
    np.testing.assert_allclose(found, rz(0.4) @ along(0.5, 0), atol=1e-15)
    data["joints"][0]["dh"]["a"] = 0.6
    assert "joints.j.dh.a must be the length of the beam `rod`, 0.5 [m], got 0.6" in problem(data)


def test_a_row_of_the_paper_lies_in_a_plane() -> None:
    with pytest.raises(ValidationError):
        DenavitHartenberg(convention=Convention.PAPER, a=1.0, alpha=0.1, d=0.0, theta=0.0)


def test_a_row_stands_in_place_of_origin_and_axis() -> None:
    row = {"convention": "modified", "a": 0, "alpha": 0, "d": 0, "theta": 0}
    said = problem(one_link({"bodies": [body()]}, dh=row, origin={"position": [0, 0, 1]}))
    assert "joints.pivot.axis" in said
    assert "joints.pivot.origin" in said


def test_the_frame_of_a_parent_is_its_undeformed_one() -> None:
    mounts = {"root_mount": {"position": [0.1, 0, 0.05], "rpy": [0.2, 0.3, 0.4]}}
    mounts["tip_mount"] = {"position": [0, 0.02, 0], "rpy": [0.5, 0, -0.3]}
    origin = {"position": [0.3, 0.2, 0.1], "rpy": [1, 2, 3]}
    beam = {"model": "strain", "functions": 2, "length": 0.5, "damping_time": 0.0}
    beam |= {"section": {"bending_stiffness": 9.0, "mass_per_length": 1.0}, **mounts}
    joints = [joint("a", "upper"), joint("b", "fore", origin=origin, axis=[1, 0, 0], **{"from": "frame"})]
    links = [{"name": "upper", "beam": beam}, {"name": "fore", "bodies": [body()]}]
    expected = turned([0, 0, 1], 0.7) @ at(origin["position"], origin["rpy"]) @ turned([1, 0, 0], -0.4)
    for model in ("strain", "rigid"):
        beam["model"] = model
        chain = arm_of(sheet(joints=joints, links=links)).chain()
        np.testing.assert_allclose(points(chain, {"a": 0.7, "b": -0.4})["tip"], expected, atol=1e-14)


def test_the_undeformed_frame_of_a_curved_beam() -> None:
    curvature = [0.4, -0.8, 1.1]
    beam = {"model": "strain", "functions": 2, "length": 0.5, "damping_time": 0.0, "rest_curvature": curvature}
    beam |= {"section": {"bending_stiffness": 9.0, "mass_per_length": 1.0}, "tip_mount": {"position": [0, 0, 0.1]}}
    origin = {"position": [0.3, 0.2, 0.1], "rpy": [1, 2, 3]}
    joints = [joint("a", "upper"), joint("b", "fore", origin=origin, **{"from": "frame"})]
    links = [{"name": "upper", "beam": beam}, {"name": "fore", "bodies": [body()]}]
    chain = arm_of(sheet(joints=joints, links=links)).chain()
    end = np.eye(4)
    end[:3, :3], end[:3, 3] = bent_line(curvature, 0.5)
    found = end @ matrix(chain.nodes[1].joint.placement)
    np.testing.assert_allclose(found, at(origin["position"], origin["rpy"]), atol=1e-14)
