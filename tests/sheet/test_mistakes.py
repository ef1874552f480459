"""Natural mistakes in a sheet: the message names the place, and its hint is what the writer meant."""

from __future__ import annotations

from typing import Any

import pytest

from tmodes.errors import InputErrors
from tmodes.io.sheet_check import sheet_from_data
from tmodes.io.sheet_plausible import implausible_numbers
from tmodes.io.yaml_file import parse_yaml
from tmodes.sheet import Robot

SHEET = """
format: 1
kind: arm
name: arm
gravity: 9.81
joints:
  - name: shoulder
    type: revolute
    child: upper
    axis: [0, 1, 0]
    motor: {inertia: 0.05, side: joint}
    gear: {stiffness: 500.0, damping: 0.2}
    limits: {lower: -2, upper: 2}
links:
  - name: upper
    beam:
      model: strain
      functions: 3
      length: 0.8
      section: {shape: box, width: 40 mm, height: 20 mm, thickness: 2 mm}
      material: steel
      damping_time: 1.0e-4
    bodies:
      - {name: payload, mass: 0.5, inertia: 1.0e-4, at: 1.0}
tip: {link: upper}
drives:
  - joint: shoulder
    command: position
    signal: {type: quintic, start: 0.0, end: 0.8, duration: 0.6}
    controller: {type: pd, position_gain: 400.0, velocity_gain: 20.0}
integration: {duration: 1.0, output_step: 2.0e-3}
"""

MISTAKES = [
    ("axis: [0, 1, 0]", "axis: y", "axis", "[0, 1, 0]"),
    ("axis: [0, 1, 0]", "axis: -z", "axis", "[0, 0, -1]"),
    ("type: revolute", "type: hinge", "type", "`revolute`"),
    ("type: revolute", "type: linear", "type", "`prismatic`"),
    ("child: upper", "link: upper", "link", "`joints.shoulder.child`"),
    ("gravity: 9.81", "g: 9.81", "g", "`gravity`"),
    ("stiffness: 500.0", "stiffness: rigid", "stiffness", ".inf"),
    ("stiffness: 500.0", "k: 500.0", "k", "`joints.shoulder.gear.stiffness`"),
    ("inertia: 0.05", "mass: 0.05", "mass", "`links.upper.bodies.payload.mass`"),
    ("lower: -2", "min: -2", "min", "`joints.shoulder.limits.lower`"),
    ("model: strain", "model: flexible", "model", "`strain`"),
    ("length: 0.8", "L: 0.8", "L", "`links.upper.beam.length`"),
    ("shape: box", "shape: rectangle", "shape", "`box`"),
    ("at: 1.0", "at: 0.8 m", "at", "without a unit"),
    ("at: 1.0", "position: [0, 0, 0]", "position", "`links.upper.bodies.payload.center`"),
    ("type: quintic", "type: minimum_jerk", "type", "`quintic`"),
    ("duration: 0.6", "T: 0.6", "T", "`drives.0.signal.duration`"),
    ("position_gain: 400.0", "kp: 400.0", "kp", "`drives.0.controller.position_gain`"),
    ("joint: shoulder\n", "name: shoulder\n", "name", "`drives.shoulder.joint`"),
    ("output_step: 2.0e-3", "dt: 2.0e-3", "dt", "`integration.output_step`"),
    ("tip: {link: upper}", "tip: upper", "tip", "`tip: {link: upper}`"),
    ("tip: {link: upper}", "tcp: {link: upper}", "tcp", "`tip`"),
    ("format: 1", "version: 1", "version", "`format`"),
    ("links:\n", "bodies:\n", "bodies", "`links`"),
    ("tip: {link: upper}", "actual: {x: 0.8}", "actual", "`real`"),
    ("tip: {link: upper}", "loads: {force: [0, 0, -10]}", "loads", "- "),
    ("tip: {link: upper}", "initial: {shoulder: 0.3}", "shoulder", "`initial.coordinates.shoulder`"),
    ("tip: {link: upper}", "stop: tip.z < -5", "stop", "`integration.stop`"),
]


@pytest.mark.parametrize(("right", "wrong", "key", "hint"), MISTAKES)
def test_a_natural_mistake_is_answered_with_what_was_meant(right: str, wrong: str, key: str, hint: str) -> None:
    data, positions = parse_yaml(SHEET.replace(right, wrong, 1), "arm.yaml")
    with pytest.raises(InputErrors) as caught:
        sheet_from_data(data, positions, "arm.yaml")
    own = [error for error in caught.value.errors if error.which.rpartition(".")[2] == key]
    assert own, [error.which for error in caught.value.errors]
    assert hint in own[0].hint
    assert own[0].where.startswith("arm.yaml:")


@pytest.mark.parametrize(
    ("axis", "width", "height", "doubted"),
    [([0, 1, 0], 0.003, 0.04, True), ([0, -1, 0], 0.04, 0.003, False), ([0, 0, 1], 0.04, 0.003, True),
     ([0, 0, 1], 0.003, 0.04, False), ([0, 1, 0], 0.01, 0.04, False), ([1, 0, 0], 0.003, 0.04, False)],
)  # fmt: skip
def test_a_flat_section_that_is_turned_in_its_stiff_direction_is_doubted(
    axis: list[float], width: float, height: float, doubted: bool
) -> None:
    data: dict[str, Any] = parse_yaml(SHEET, "")[0]
    section = {"shape": "box", "width": width, "height": height}
    robot = Robot.from_data(data).with_({"joints.shoulder.axis": axis, "links.upper.beam.section": section})
    assert any("exchanged" in one for one in implausible_numbers(robot)) is doubted
