"""Anchors, aliases and merge keys give the sheet that is written out, in bounded time, with the lines of their text."""

from __future__ import annotations

import pytest

from patience import bounded
from tmodes.errors import InputError, InputErrors
from tmodes.io.sheet_check import sheet_from_data
from tmodes.io.yaml_file import parse_yaml


def data(text: str) -> dict:
    return parse_yaml(f"kind: arm\n{text}", "s.yaml")[0]


SAME = {
    "a number": ("a: &g 9.81\nb: *g", "a: 9.81\nb: 9.81"),
    "a group": ("a: &g {x: 1, y: [1, 2]}\nb: *g", "a: {x: 1, y: [1, 2]}\nb: {x: 1, y: [1, 2]}"),
    "a list": ("a: &g [1, {x: 2}]\nb: [*g, *g]", "a: [1, {x: 2}]\nb: [[1, {x: 2}], [1, {x: 2}]]"),
    "text that is quoted": ("a: &g '1'\nb: *g", "a: '1'\nb: '1'"),
    "an anchor that is set again": ("a: &g 1\nb: *g\nc: &g 2\nd: *g", "a: 1\nb: 1\nc: 2\nd: 2"),
    "an anchor inside another": ("a: &g {x: &h 1, y: *h}\nb: *g\nc: *h", "a: {x: 1, y: 1}\nb: {x: 1, y: 1}\nc: 1"),
    "a merge": ("a: &g {x: 1, y: 2}\nb: {<<: *g, z: 3}", "a: {x: 1, y: 2}\nb: {x: 1, y: 2, z: 3}"),
    "a merge below": ("a: &g {x: 1, y: 2}\nb:\n  y: 5\n  <<: *g", "a: {x: 1, y: 2}\nb: {x: 1, y: 5}"),
    "merges of several": (
        "a: &g {x: 1}\nc: &h {x: 2, y: 2}\nb: {<<: [*g, *h]}", "a: {x: 1}\nc: {x: 2, y: 2}\nb: {x: 1, y: 2}"),
    "a merge of a merge": (
        "a: &g {x: 1}\nc: &h {<<: *g, y: 2}\nb: {<<: *h}", "a: {x: 1}\nc: {x: 1, y: 2}\nb: {x: 1, y: 2}"),
    "a quoted key": ("a: {'<<': 1}", "a: {'<<': 1}"),
}  # fmt: skip


@pytest.mark.parametrize(("short", "long"), SAME.values(), ids=SAME)
def test_they_mean_what_is_written_out(short: str, long: str) -> None:
    expected = {"kind": "arm", "a": {"<<": 1}} if "'<<'" in long else data(long)
    assert data(short) == expected


def test_what_is_repeated_is_apart() -> None:
    found = data("a: &g {x: [1]}\nb: *g")
    found["a"]["x"].append(2)
    assert found["b"] == {"x": [1]}


@pytest.mark.parametrize(
    "text",
    ["a: *g", "a: &g [*g]", "a: &g {<<: *g}", "<<: 3", "<<: [1]", "a: {<<: text}", "&g a: 3", "a: &g x\n*g : 3",
     "a: &g {x: 1}\nb: {x: 1, <<: *g, x: 2}"],
)  # fmt: skip
def test_what_has_no_meaning_is_refused_with_its_line(text: str) -> None:
    with pytest.raises(InputError, match=r"s\.yaml:[23]"):
        data(text)


TIMES = 10
BOMBS = {
    "lists": "\n".join(["a0: &a0 [x]", *(f"a{k}: &a{k} [{', '.join([f'*a{k - 1}'] * TIMES)}]" for k in range(1, 30))]),
    "groups": "\n".join(
        ["a0: &a0 {x: 1}"]
        + [f"a{k}: &a{k} {{{', '.join(f'k{i}: *a{k - 1}' for i in range(TIMES))}}}" for k in range(1, 30)]
    ),
    "merges": "\n".join(
        ["a0: &a0 {" + ", ".join(f"k{i}: 1" for i in range(100)) + "}"]
        + [f"a{k}: &a{k} {{<<: [{', '.join([f'*a{k - 1}'] * TIMES)}]}}" for k in range(1, 30)]
    ),
}


@pytest.mark.parametrize("text", BOMBS.values(), ids=BOMBS)
def test_what_they_stand_for_counts_as_if_written_out(text: str) -> None:
    with bounded(5.0), pytest.raises(InputError, match="40000 items"):
        data(text)


def test_wrong_values_in_them_are_reported_with_a_line_of_the_file() -> None:
    text = """format: 1
kind: arm
name: two
joints:
  - &joint {name: one, type: revolute, child: first, axis: [0, 0, 1], motor: &motor {inertia: -1.0, side: joint}}
  - {<<: *joint, name: two, child: second}
links:
  - &link {name: first, bodies: [{mass: 1.0, center: [0.1, 0, 0]}]}
  - <<: *link
    name: second
"""
    with pytest.raises(InputErrors) as error:
        sheet_from_data(*parse_yaml(text, "s.yaml"), "s.yaml")
    found = {(one.which, one.where) for one in error.value.errors}
    assert found == {("joints.one.motor.inertia", "s.yaml:5"), ("joints.two.motor.inertia", "s.yaml:5")}
    right = sheet_from_data(parse_yaml(text.replace("-1.0", "0.1"), "s.yaml")[0])
    assert [joint.motor == right.joints[0].motor for joint in right.joints] == [True, True]
    assert right.links[1].bodies == right.links[0].bodies
