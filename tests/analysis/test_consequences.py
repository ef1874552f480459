"""Numbers that are allowed and lead to what no robot does are warnings of ``check``, by their consequences."""

from __future__ import annotations

from typing import Any

import pytest

from tmodes.analysis.consequences import consequences
from tmodes.cli.sheets import check
from tmodes.robots import names
from tmodes.robots.load import load
from tmodes.sheet import Robot

MOTOR = {"inertia": 0.05, "side": "joint"}
BEAM = {
    "model": "strain", "functions": 2, "length": 0.4, "damping_time": 1e-4, "material": "aluminium_6061",
    "section": {"shape": "tube", "outer_diameter": 0.03, "thickness": 0.002},
}  # fmt: skip


def desk_arm(**more: Any) -> Robot:
    """Three joints with gears, the last link flexible, with a payload."""
    joints = [
        {"name": name, "type": "revolute", "child": child, "axis": axis, "motor": MOTOR,
         "gear": {"stiffness": 16000.0, "damping": 1.0},
         **({"origin": {"position": [0.3, 0.0, 0.0]}} if name != "base_turn" else {})}
        for name, child, axis in (("base_turn", "foot", [0, 0, 1]), ("shoulder", "upper", [0, 1, 0]),
                                  ("elbow", "fore", [0, 1, 0]))
    ]  # fmt: skip
    body = {"mass": 3.0, "center": [0.15, 0.0, 0.0], "inertia": 0.02}
    links = [{"name": "foot", "bodies": [body]}, {"name": "upper", "bodies": [body]},
             {"name": "fore", "beam": BEAM, "bodies": [{"name": "payload", "mass": 2.0, "inertia": 1e-3}]}]  # fmt: skip
    drives = [{"joint": "elbow", "command": "prescribed", "signal": {"type": "constant", "value": 0.1}}]
    data = {"format": 1, "kind": "arm", "name": "desk", "joints": joints, "links": links, "drives": drives,
            "integration": {"duration": 1.0, "output_step": 0.01}}  # fmt: skip
    return Robot.from_data(data).with_(more)


def test_a_right_robot_has_none() -> None:
    assert consequences(desk_arm()) == []


@pytest.mark.parametrize("name", names())
def test_published_robots_have_none(name: str) -> None:
    try:
        robot = load(name)
    except Exception as error:
        pytest.skip(str(error))
    assert consequences(robot) == []


@pytest.mark.parametrize(
    ("path", "value", "words"),
    [
        ("links.fore.bodies.payload.mass", 3000.0, "is a mass in g"),
        ("links.fore.bodies.payload.mass", 500.0, "is a mass in g"),
        ("links.upper.bodies.0.mass", 5e4, "is a mass in g"),
        ("joints.elbow.friction.viscous", 3e5, "joints.elbow.friction.viscous"),
        ("joints.elbow.motor.friction.viscous", 3e5, "joints.elbow.motor.friction.viscous"),
        ("joints.elbow.gear.stiffness", 16.0, "joints.elbow.gear.stiffness"),
        ("joints.shoulder.gear.stiffness", 16.0, "joints.shoulder.gear.stiffness"),
        ("joints.base_turn.gear.stiffness", 16.0, "factor 1000"),
        ("joints.elbow.gear.damping", 5e4, "damping ratio"),
        ("links.fore.beam.damping_time", 0.1, "damping_time = 0.1 s"),
        ("links.fore.beam.damping_time", 5.0, "factor 0.001"),
        ("real", {"joints.elbow.gear.stiffness": 12800.0}, "factor on the nominal value"),
        ("real", {"joints.elbow.gear.stiffness": 1e-4}, "factor on the nominal value"),
        ("joints.shoulder.limits", {"effort": 5.0}, "limits.effort"),
    ],
)
def test_each_slip_is_named_with_its_likely_cause(path: str, value: Any, words: str) -> None:
    found = consequences(desk_arm(**{path: value}))
    assert found
    assert any(words in sentence for sentence in found)


@pytest.mark.parametrize(("limits", "words"), [
    ({"speed": 1.8}, "for 1.875, beyond joints.shoulder.limits.speed = 1.8"), ({"speed": 1.9}, ""),
    ({"upper": 0.3}, "for 0.4, beyond joints.shoulder.limits.upper"), ({"upper": 0.4, "lower": -0.4}, ""),
    ({"lower": -0.2}, "for -0.4, beyond joints.shoulder.limits.lower"),
])  # fmt: skip
def test_a_setpoint_beyond_a_limit_is_named(limits: dict[str, float], words: str) -> None:
    """A quintic over 0.8 rad in 0.8 s: its speed is 15/8 of its way over its time at most."""
    found = consequences(load("two_link_arm").with_({"joints.shoulder.limits": limits}))
    assert (words in " ".join(found)) if words else not found


@pytest.mark.parametrize("name", ["base_turn", "shoulder", "elbow"])
@pytest.mark.parametrize("factor", [1e-3, 1e3])
def test_the_cause_is_on_the_gear_that_is_wrong(name: str, factor: float) -> None:
    path = f"joints.{name}.gear.stiffness"
    accused = {
        word for one in consequences(desk_arm(**{path: 16000.0 * factor})) for word in one.split() if "gear" in word
    }
    assert {word.removesuffix(":") for word in accused} <= {path, f"joints.{name}.gear", "gears"}


@pytest.mark.parametrize("stiffness", [30.0, 60.0, 16000.0])
def test_leaf_springs_are_no_slip(stiffness: float) -> None:
    """A series elastic joint of a few Hz before stiff ones, in a plane without weight."""
    robot = desk_arm(gravity=0.0)
    assert (
        consequences(robot.with_({"joints.base_turn.gear.stiffness": stiffness, "joints.base_turn.gear.damping": 0.0}))
        == []
    )


@pytest.mark.parametrize("initial", [{"state": "zero"}, {"state": "rest"}, {}])
def test_a_robot_that_nothing_moves_is_reported_as_run_reports_it(initial: Any, capsys: Any, tmp_path: Any) -> None:
    path = tmp_path / "idle.yaml"
    path.write_text(
        "format: 1\nkind: arm\nname: idle\njoints: [{name: j, type: revolute, child: l, axis: [0, 1, 0]}]\n"
        "links: [{name: l, bodies: [{mass: 1.0, inertia: 0.1}]}]\nintegration: {duration: 1.0, output_step: 0.01}\n"
        f"initial: {initial}\n".replace("'", "")
    )
    check(str(path))
    assert "warning: `tmodes run` needs more: drives" in capsys.readouterr().out
