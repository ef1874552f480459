"""Numbers in a wrong unit are reported with the likely factor; right robots get no warning."""

from __future__ import annotations

import math
from typing import Any

import pytest

import tmodes
from tmodes.analysis.consequences import consequences
from tmodes.io.sheet_plausible import implausible_numbers
from tmodes.robots import names
from tmodes.sheet import Robot

ROBOT = tmodes.load("filipovic2010")
ROOT = "link.modes.0."
PLAIN = [name for name in names() if not name.endswith("_elastic")]  # those stand on models that may not be installed


def arm() -> Robot:
    """Two rods, the second on the first, with a motor at the root and a body at the tip."""
    rod = {"model": "strain", "functions": {"bend_y": 2, "bend_z": 2}, "length": 0.5, "damping_time": 1e-4,
           "section": {"shape": "round", "diameter": 0.01}, "material": "steel"}  # fmt: skip
    motor = {"side": "joint", "inertia": 0.1, "resistance": 1.0, "back_emf_constant": 2.0, "torque_constant": 2.0}
    return Robot.from_data({
        "format": 1, "kind": "arm", "name": "rods", "gravity": 9.81,
        "joints": [
            {"name": "shoulder", "type": "revolute", "parent": "base", "child": "upper", "axis": [0, 0, 1],
             "motor": motor},
            {"name": "elbow", "type": "fixed", "parent": "upper", "child": "lower"},
        ],
        "links": [{"name": "upper", "beam": rod},
                  {"name": "lower", "beam": rod, "bodies": [{"name": "hand", "mass": 0.2, "inertia": 1e-3}]}],
    })  # fmt: skip


@pytest.mark.parametrize("name", PLAIN)
def test_published_robots_look_right(name: str) -> None:
    robot = tmodes.load(name)
    assert implausible_numbers(robot) == []
    assert implausible_numbers(robot.pair().real) == []


@pytest.mark.parametrize(
    "changes",
    [
        {"gear.stiffness": math.inf},
        {f"{ROOT}bending_stiffness": math.inf},
        {"payload.mass": 0.0, "payload.inertia": 0.0},
        {"gravity": 0.0},
        {"reference.end": -6.2},
        {f"{ROOT}bending_stiffness": 70e9 * math.pi * 0.05**4 / 64, f"{ROOT}mass_per_length": 5.3},
        {f"{ROOT}bending_stiffness": 900.0, f"{ROOT}mass_per_length": 0.13},
    ],
)
def test_right_robots_get_no_warning(changes: dict[str, Any]) -> None:
    assert implausible_numbers(ROBOT.with_(changes)) == []


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({f"{ROOT}length": 600.0}, "modes.0.length = 600 m is outside .* was it meant in mm (factor 0.001)?"),
        ({"payload.mass": 500.0}, "masses in g (factor 0.001)"),
        ({"payload.mass": 5e5}, "payload.mass = 500000 kg is outside .* in g (factor 0.001)?"),
        ({f"{ROOT}mass_per_length": 1997.6}, "mass or density in g (factor 0.001)"),
        ({f"{ROOT}bending_stiffness": 1082.1e6}, "stiffness in N*mm^2 (factor 1e-06)"),
        ({f"{ROOT}bending_stiffness": 1082.1e-6}, "E in MPa or GPa (factor 1e+06 or 1e+09)"),
        ({f"{ROOT}damping_time": 0.2}, "modes.0.damping_time = 0.2 s is outside .* in ms (factor 0.001)?"),
        ({"gear.damping": -0.5}, "gear.damping = -0.5 N*m*s/rad is negative: it feeds energy"),
        ({"motor.friction": -0.5}, "motor.friction.viscous = -0.5 N*m*s/rad is negative"),
        ({"environment.damping": -0.5}, "contact.damping = -0.5 N*s/m is negative"),
        ({"reference.end": 45.0}, "goes to 45 rad .* in deg (factor 0.01745)?"),
        ({"motor.back_emf_constant": 0.316}, "V/rpm (factor 9.549)"),
        ({"motor.torque_constant": 3020.0}, "V per degree, or N*mm/A"),
        ({"payload.inertia": 250.0}, "an inertia of 250 kg*m^2 is more than 0.5 kg can have .* g*cm^2"),
        ({"gravity": 981.0}, "gravity = 981 m/s^2 is outside .* in cm/s^2 (factor 0.01)?"),
        ({"motor.resistance": 2990.0}, "motor.resistance = 2990 ohm is outside .* in mohm"),
    ],
)
def test_a_wrong_unit_is_reported_with_its_factor(changes: dict[str, Any], words: str) -> None:
    sentences = implausible_numbers(ROBOT.with_(changes))
    parts = words.replace(", ", " .* ").split(" .* ") if ".*" in words else [words]
    assert any(all(part in sentence for part in parts) for sentence in sentences), sentences
    assert len(sentences) <= 3


def test_any_robot_is_looked_at() -> None:
    """The same of rods on rods: what the first carries is all that is behind it."""
    right = arm()
    assert implausible_numbers(right) == []
    heavy = implausible_numbers(right.with_({"links.lower.bodies.hand.mass": 1000.0}))
    assert [sentence.split(" sags")[0] for sentence in heavy] == ["links.upper.beam", "links.lower.beam"]
    assert "under the weight of 1e+03 kg" in heavy[1]
    (motor,) = implausible_numbers(right.with_({"joints.shoulder.motor.torque_constant": 0.02}))
    assert motor.startswith("joints.shoulder.motor.back_emf_constant = 2 and torque_constant = 0.02")
    (inertia,) = implausible_numbers(right.with_({"links.lower.bodies.hand.inertia": 10.0}))
    assert inertia.startswith("links.lower.bodies.hand: an inertia of 10 kg*m^2 is more than 0.2 kg can have")
    (rest,) = implausible_numbers(right.with_({"joints.shoulder.spring": {"stiffness": 5.0, "rest": 90.0}}))
    assert rest.startswith("joints.shoulder.spring.rest = 90 rad")
    assert "deg (factor 0.01745)" in rest


FLOATING = {
    "format": 1,
    "kind": "arm",
    "name": "floating",
    "gravity": 9.81,
    "joints": [
        {"name": "x", "type": "prismatic", "child": "a", "axis": [1, 0, 0], "state": "free"},
        {"name": "z", "type": "prismatic", "child": "b", "axis": [0, 0, 1], "state": "free"},
        {"name": "turn", "type": "revolute", "child": "rod", "axis": [0, 1, 0], "state": "free"},
    ],
    "links": [
        {
            "name": "rod",
            "beam": {
                "model": "strain", "functions": {"bend_y": 3}, "length": 2.9, "damping_time": 1e-4,
                "section": {"shape": "round", "diameter": 0.003}, "material": "steel",
            },
            "bodies": [{"mass": 5.0, "at": 0.0}, {"mass": 5.0, "at": 1.0}],
        }
    ],
}  # fmt: skip


def test_no_weight_bends_a_beam_whose_root_nothing_holds() -> None:
    """Clamped, the masses would bend it by a kilometre."""
    floating = tmodes.Robot.from_data(FLOATING)
    assert implausible_numbers(floating) == []
    assert consequences(floating) == []
    held = floating.with_({"joints.turn.state": "active"}).with_(
        {"joints.x.state": "active", "joints.z.state": "active"}
    )
    assert "bodies: 5 kg at its end bend it" in consequences(held)[0]
