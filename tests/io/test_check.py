# pyright: reportOptionalMemberAccess=false
"""All that is wrong with a data sheet is reported together, with line, unit and hint."""

from __future__ import annotations

import json
import math
from typing import Any

import numpy as np
import pytest

from io_cases import SHEET, line_of, value_of
from tmodes.errors import InputError, InputErrors
from tmodes.io.sheet_check import sheet_from_data as robot_from_data
from tmodes.io.sheet_paths import changed_places
from tmodes.io.yaml_file import parse_yaml
from tmodes.sheet import Robot


def sheet(*changes: str) -> str:
    """The published sheet with words replaced pairwise."""
    text = SHEET
    for old, new in zip(changes[::2], changes[1::2], strict=True):
        assert old in text
        text = text.replace(old, new, 1)
    return text


def read(text: str) -> Robot:
    return robot_from_data(*parse_yaml(text, "my.yaml"), source="my.yaml")


def problems(*changes: str) -> list[InputError]:
    with pytest.raises(InputErrors) as caught:
        read(sheet(*changes))
    return list(caught.value.errors)


def problem(*changes: str) -> str:
    (error,) = problems(*changes)
    return str(error)


def changed(**values: Any) -> Robot:
    data, _ = parse_yaml(SHEET, "my.yaml")
    return robot_from_data(changed_places(data, {path.replace("__", "."): value for path, value in values.items()})[0])


def test_published_sheet_is_right() -> None:
    robot = read(SHEET)
    assert value_of(robot, "gear.stiffness") == 4700.0
    assert value_of(robot.pair().real, "gear.stiffness") == 940.0
    assert robot.pair().real.real == {}


def test_message_reports_place_value_rule_unit_and_hint() -> None:
    assert problem("stiffness: 4700.0", "stiffness: -3.0") == (
        f"my.yaml:{line_of('gear.stiffness')}: gear.stiffness must be "
        "a number greater than 0 [N*m/rad], or .inf for rigid, got -3.0; "
        "check sign, size and unit"
    )


def test_all_errors_are_reported_in_the_order_of_the_file() -> None:
    errors = problems(
        *("resistance: 0.299", "resistance: heavy", "gravity: 9.81", "gravity: .nan", "mass: 0.5 ", "mass: 1,5 "),
        *("damping: 2.0", "damping: true", "stiffness: 4700.0", "stifness: 4700.0", "gear.damping", "gear.dampin"),
        *("reading: consistent", "reading: consistant", "output_step: 1.0e-3", "output_step: 1.0e-9"),
        *("contact: true", "contact: yes", "length: 0.6", "length: 600 kg"),
    )
    assert [error.which for error in errors] == [
        *("reading", "contact", "gravity", "motor.resistance", "gear.stiffness", "gear.stifness", "gear.damping"),
        *("link.modes.0.length", "payload.mass", "real.gear.dampin", "integration.output_step"),
    ]
    lines = [int(error.where.removeprefix("my.yaml:")) for error in errors]
    assert lines == sorted(lines)
    for error, line in zip(errors, lines, strict=True):
        if error.which not in ("gear.stiffness", "gear.stifness", "real.gear.dampin"):
            assert line == line_of(error.which)


@pytest.mark.parametrize(
    ("old", "new", "hint"),
    [
        ("stiffness: 4700.0", "stifness: 4700.0", "Did you mean `gear.stiffness`?"),
        ("  resistance: 0.299", "  Resistance: 0.299", "Did you mean `motor.resistance`?"),
        ("back_emf_constant", "back-EMF-constant", "Did you mean `motor.back_emf_constant`?"),
        ("  velocity_gain: 20.0", "  velocity_gain: 20.0\n  Klp: 3.0", "Did you mean `controller.position_gain`?"),
        ("gravity: 9.81", "gravity: 9.81\nlength: 3.0", "Did you mean `link.modes.0.length`? Write it there"),
        ("gravity: 9.81", "gravity: 9.81\ngear.stiffness: 3.0", "put the key `stiffness` inside the group `gear`"),
        ("  damping: 2.0 ", "  damping: 2.0\n  zzz: 1.0", "remove it"),
        ("  gear.stiffness: 0.2", "  gear.stifness: 0.2", "Did you mean `real.gear.stiffness`?"),
        ("reading: consistent", "reading: consistant", "Did you mean `consistent`?"),
    ],
)
def test_the_name_that_was_meant_is_reported(old: str, new: str, hint: str) -> None:
    assert any(hint in str(error) for error in problems(old, new))


def test_a_missing_key_is_reported_with_meaning_unit_and_the_line_of_its_group() -> None:
    message = problem("  inertia: 0.175", "  # inertia: 0.175")
    assert message.startswith(f"my.yaml:{line_of('motor')}: motor.inertia is missing, ")
    assert "[kg*m^2]: rotor inertia, reflected after the reducer" in message
    assert message.endswith("add the line `inertia: ...` inside `motor`")


def test_the_link_has_exactly_two_modes() -> None:
    first = SHEET.index("    - length: 0.6")
    second, end = SHEET.index("    - length: 0.3"), SHEET.index("\npayload:")
    one, three = SHEET[:second] + SHEET[end:], SHEET[:end] + SHEET[first:second] + SHEET[end:]
    for text, got in ((one, "a list of 1"), (three, "a list of 3")):
        with pytest.raises(InputErrors, match=rf"link\.modes must be a list of exactly 2 groups, got {got}") as caught:
            read(text)
        assert caught.value.errors[0].where == f"my.yaml:{line_of('link.modes')}"


@pytest.mark.parametrize(
    ("version", "words"),
    [("2", "newer than this program"), ("0", "must be the number 1, got 0"), ("true", "got true"), ("1.0", "got 1.0")],
)
def test_another_format_is_reported_alone(version: str, words: str) -> None:
    message = problem("format: 1", f"format: {version}", "stiffness: 4700.0", "rigidity: 4700.0")
    assert message.startswith("my.yaml:5: format")
    assert words in message


@pytest.mark.parametrize("data", [None, [], 3, "robot", {1: 2}, {"gear": 5}, {"real": {3: 4}}, {None: None}])
def test_data_of_another_shape_is_reported(data: Any) -> None:
    with pytest.raises(InputErrors, match=r"must be|expected|unknown"):
        robot_from_data(data)


def test_no_more_than_a_hundred_errors_are_listed() -> None:
    with pytest.raises(InputErrors) as caught:
        robot_from_data({"kind": "arm"} | {f"key{index}": 1.0 for index in range(500)})
    assert len(caught.value.errors) == 101
    assert "wrong values" in caught.value.errors[-1].got


def test_data_is_not_changed() -> None:
    data, lines = parse_yaml(sheet("gravity: 9.81", 'gravity: "981 cm/s^2"'), "my.yaml")
    before = json.dumps(data)
    assert robot_from_data(data, lines).gravity == (0.0, 0.0, -9.81)
    assert json.dumps(data) == before


def test_numbers_of_numpy_are_numbers() -> None:
    robot = changed(gear__stiffness=np.float64(900), payload__mass=np.float32(0.5), integration__max_steps=np.int64(9))
    assert (value_of(robot, "gear.stiffness"), value_of(robot, "payload.mass"), robot.integration.max_steps) == (
        900.0,
        0.5,
        9,
    )
    with pytest.raises(InputErrors, match=r"gear\.stiffness must be"):
        changed(gear__stiffness=np.array([900.0, 901.0]))


def test_whole_numbers_may_be_written_with_an_exponent() -> None:
    assert changed(integration__max_steps=1e6).integration.max_steps == 1_000_000
    with pytest.raises(InputErrors, match=r"max_steps must be a whole number"):
        changed(integration__max_steps=10.5)


class TestRealRobot:
    def test_a_factor_of_zero_takes_a_damping_away_but_no_stiffness(self) -> None:
        assert read(sheet("gear.damping: 0.2", "gear.damping: 0.0")).pair().real.joints[0].gear.damping == 0.0
        message = problem("gear.stiffness: 0.2", "gear.stiffness: 0.0")
        assert message.startswith(f"my.yaml:{line_of('real.gear.stiffness')}: real.gear.stiffness must be")
        assert ", got 0.0 times 4700.0;" in message

    @pytest.mark.parametrize("factor", ["-1.0", ".nan", ".inf", "1.0e308", "some", "true"])
    def test_a_factor_is_a_number_from_zero(self, factor: str) -> None:
        message = problem("gear.stiffness: 0.2", f"gear.stiffness: {factor}")
        assert message.startswith(f"my.yaml:{line_of('real.gear.stiffness')}: real.gear.stiffness must be ")

    def test_an_unknown_path_is_reported_once(self) -> None:
        message = problem("gear.stiffness: 0.2", "gear.siffness: 0.2")
        assert "unknown key `real.gear.siffness`. Did you mean `real.gear.stiffness`?" in message

    @pytest.mark.parametrize("path", ["reference.end", "integration.duration", "environment.friction_law", "gear"])
    def test_only_numbers_of_the_plant_differ(self, path: str) -> None:
        assert f"real.{path}" in problem("gear.stiffness: 0.2", f"{path}: 0.2")

    def test_a_rigid_gear_has_no_factor_of_zero(self) -> None:
        message = problem("stiffness: 4700.0", "stiffness: .inf", "gear.stiffness: 0.2", "gear.stiffness: 0")
        assert "real.gear.stiffness must be" in message
        assert ", got 0.0 times .inf;" in message


class TestWhatMustFitTogether:
    def test_more_samples_than_memory_holds_are_refused_with_numbers(self) -> None:
        message = problem("output_step: 1.0e-3", "output_step: 1.0e-9")
        assert message.startswith(f"my.yaml:{line_of('integration.output_step')}: integration.output_step must be ")
        assert ", got 1e-09" in message
        assert "2e+09 samples, about 9.94e+03 GB" in message
        assert "write at least 5.55e-06 s" in message
        assert changed(integration__output_step=5.55e-6).integration.output_step == 5.55e-6

    def test_a_sample_after_the_end_is_refused(self) -> None:
        with pytest.raises(InputErrors, match=r"integration.output_step must be at most integration.dur"):
            changed(integration__duration=1e-4)

    def test_fixed_steps_are_bounded_where_they_are_taken(self) -> None:
        assert changed(integration__step=3.0).integration.step == 3.0
        with pytest.raises(InputErrors, match=r"integration.step must be at most integration.duration"):
            changed(integration__step=3.0, integration__method="rk4")
        with pytest.raises(
            InputErrors, match=r"integration.step must be .*, got 1e-09, that is 2e\+09 steps.*at least 1e-08 s"
        ):
            changed(integration__step=1e-9, integration__method="rk4")

    @pytest.mark.parametrize("duration", [0.0, -1.0, math.nan, math.inf, 1e9])
    def test_the_simulated_time_is_positive_and_bounded(self, duration: float) -> None:
        with pytest.raises(InputErrors, match=r"integration\.duration must be"):
            changed(integration__duration=duration)


@pytest.mark.parametrize("value", [1e13, 1e308, 1e-13, 5e-324])
def test_a_size_beyond_arithmetic_is_refused_with_its_bounds(value: float) -> None:
    with pytest.raises(InputErrors, match=r"must be a magnitude from 1e-12 to 1e\+12 \[N\*m/rad\].*\.inf makes it"):
        changed(gear__stiffness=value)


def test_gains_and_loads_may_be_zero() -> None:
    robot = changed(controller__position_gain=0, controller__velocity_gain=0.0, payload__mass=0, gravity=0)
    assert (value_of(robot, "controller.position_gain"), value_of(robot, "payload.mass"), robot.gravity) == (
        0.0,
        0.0,
        (0.0, 0.0, 0.0),
    )
