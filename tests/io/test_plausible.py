"""Numbers in a wrong unit are told with the likely factor; right robots are not nagged."""

from __future__ import annotations

import math
from typing import Any

import pytest

from tmodes.io.plausible import implausible
from tmodes.robots import load_robot, names

ROBOT = load_robot("filipovic2010")
ROOT = "link.modes.0."


@pytest.mark.parametrize("name", names())
def test_published_robots_look_right(name: str) -> None:
    robot = load_robot(name)
    assert implausible(robot) == []
    assert implausible(robot.pair().real) == []


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
def test_right_robots_are_not_nagged(changes: dict[str, Any]) -> None:
    assert implausible(ROBOT.with_(changes)) == []


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({f"{ROOT}length": 600.0}, "link.modes.0.length = 600 m is outside .* was it meant in mm (factor 0.001)?"),
        ({"payload.mass": 500.0}, "masses in g (factor 0.001)"),
        ({"payload.mass": 5e5}, "payload.mass = 500000 kg is outside .* in g (factor 0.001)?"),
        ({f"{ROOT}mass_per_length": 1997.6}, "mass_per_length in g/m (factor 0.001)"),
        ({f"{ROOT}bending_stiffness": 1082.1e6}, "bending_stiffness in N*mm^2 (factor 1e-06)"),
        ({f"{ROOT}bending_stiffness": 1082.1e-6}, "E in MPa or GPa (factor 1e+06 or 1e+09)"),
        ({f"{ROOT}bending_stiffness": 1082.1e-9}, "E in MPa or GPa (factor 1e+06 or 1e+09)"),
        ({f"{ROOT}damping_time": 0.2}, "link.modes.0.damping_time = 0.2 s is outside .* in ms (factor 0.001)?"),
        ({"gear.damping": -0.5}, "gear.damping = -0.5 N*m*s/rad is negative: it feeds energy"),
        ({"motor.friction": -0.5}, "motor.friction = -0.5 N*m*s/rad is negative"),
        ({"environment.damping": -0.5}, "environment.damping = -0.5 N*s/m is negative"),
        ({"reference.end": 45.0}, "reference.end = 45 rad is outside .* in deg (factor 0.01745)?"),
        ({"motor.back_emf_constant": 0.316}, "V/rpm (factor 9.549)"),
        ({"payload.inertia": 2500.0}, "payload.inertia = 2500 kg*m^2 is outside .* g*cm^2"),
        ({"payload.inertia": 250.0}, "payload.inertia = 250 kg*m^2 is more than 0.5 kg can have"),
        ({"gravity": 981.0}, "gravity = 981 m/s^2 is outside .* in cm/s^2 (factor 0.01)?"),
        ({"motor.resistance": 2990.0}, "motor.resistance = 2990 ohm is outside .* in mohm"),
        ({"link.modes.1.length": 1e-3, "payload.inertia": 0.0}, "link.modes.1 bends at .* outside the usual"),
    ],
)
def test_a_wrong_unit_is_reported_with_its_factor(changes: dict[str, Any], words: str) -> None:
    sentences = implausible(ROBOT.with_(changes))
    parts = words.split(" .* ")
    assert any(all(part in sentence for part in parts) for sentence in sentences), sentences
    assert len(sentences) <= 3
