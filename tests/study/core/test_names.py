"""Names of series, static numbers and paths of the summary are checked when a study is read."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

import tmodes
from tmodes.errors import InputErrors
from tmodes.study.quantities.summary import KEYS, PATHS, names_in_summary, path_issues
from tmodes.study.read import study_of_robot

STUDY: dict[str, Any] = {
    "kind": "study", "format": 1, "name": "names",
    "parameters": {"k": {"path": "joints.joint.gear.stiffness",
                         "distribution": {"type": "uniform", "low": "80 Nm/rad", "high": "120 N-m/rad"}}},
    "plan": {"type": "grid", "levels": 2},
}  # fmt: skip


@pytest.fixture(scope="module")
def robot() -> tmodes.Robot:
    return tmodes.load("spong1987")


@pytest.mark.parametrize(
    ("quantity", "meant"),
    [
        ({"series": "deviaton", "reduce": "max"}, "deviation"),
        ({"series": "joint.efort", "reduce": "max"}, "joint.effort"),
        ({"static": "frequncy.locked.1"}, "frequency.locked.1"),
        ({"summary": "settling.tim_s"}, "settling.time_s"),
        ({"summary": "deviation"}, "deviation.max_m"),
        ({"summary": "setling.time_s"}, "settling"),
        ({"summary": "joints.jiont.largest"}, "joints.joint.largest"),
        ({"summary": "links.upper.stress.max_Pa"}, ""),
        ({"summary": "tip_error.commanded.parts_m.controler"}, "tip_error.commanded.parts_m.controller"),
    ],
)
def test_an_unknown_name_is_refused_before_anything_runs(
    robot: tmodes.Robot, quantity: dict[str, Any], meant: str
) -> None:
    with pytest.raises(InputErrors) as caught:
        study_of_robot(robot, STUDY | {"quantities": {"one": quantity, "good": {"static": "sag"}}})
    (error,) = caught.value.errors
    assert error.which.startswith("quantities.one.")
    assert f"`{meant}`" in error.hint if meant else "docs" in error.hint


def test_a_name_of_one_entry_of_a_choice_is_known() -> None:
    entries = [{"name": str(count), "set": {"links.forearm.beam.functions.bend_z": count}} for count in (4, 5)]
    plan = {"plan": {"type": "grid"}, "parameters": {"count": {"choices": entries}}}

    def asked(name: str) -> dict[str, Any]:
        return STUDY | plan | {"quantities": {"bend": {"series": f"forearm.{name}.position", "reduce": "max"}}}

    arm = tmodes.load("flexarm1990")
    assert study_of_robot(arm, asked("bend_z5")).cases == 2
    with pytest.raises(InputErrors, match="bend_z6"):
        study_of_robot(arm, asked("bend_z6"))


def _numbers(value: Any, path: str = "") -> Iterator[str]:
    items = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, inner in items:
        yield from _numbers(inner, f"{path}.{key}" if path else str(key))
    if isinstance(value, (int, float)) and not isinstance(value, bool):
        yield path


@pytest.mark.parametrize("name", ["spong1987", "flexarm1990"])
def test_every_number_of_a_summary_has_a_known_path(name: str) -> None:
    arm = tmodes.load(name, {"integration.duration": 0.05})
    names = names_in_summary(arm)
    for path in _numbers(tmodes.run(arm).summary()):
        assert not [*path_issues(path, names)], f"{path} is missing in PATHS"


def test_every_path_is_in_the_guide() -> None:
    guide = (Path(__file__).parents[3] / "docs/studies.md").read_text()
    for path, meaning in PATHS.items():
        row = "| `" + path.replace("|", "\\|") + f"` | {meaning} |"
        assert row in guide, f"docs/studies.md needs the row {row}"
    assert "settling" in KEYS
