"""The modes of the 2010 robot follow the sliders: frequencies, damping, shapes are the native ones of the new robot."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tmodes.live.bundle import live_bundle
from tmodes.live.map import LiveMap, live_map
from tmodes.paper.sheet import PaperRobot
from tmodes.paper.simulate import simulate
from tmodes.report.facts import frequency_facts
from tmodes.report.mode_shapes import modes_of
from tmodes.report.spectra import robot_spectra
from tmodes.result.record import PaperResult
from tmodes.robots.load import load

from .node import live_in_node, worst_difference
from .same_modes import SHAPE, assert_same_modes

SETTINGS = 5
EQUAL = 1e-8
COARSE = {"integration.method": "dormand_prince", "integration.relative_tolerance": 1e-6,
          "integration.absolute_tolerance": 1e-8}  # fmt: skip
"""The modes do not hang on the run."""


def seed(**changes: Any) -> PaperRobot:
    sheet = load("filipovic2010", COARSE | changes)
    assert isinstance(sheet, PaperRobot)
    return sheet


def drawn(live: LiveMap) -> list[list[float]]:
    """The values as they are, then random ones of all sliders within their ranges."""
    generator = np.random.default_rng(11)
    random = [
        [s.low * (s.high / s.low) ** float(generator.uniform()) if s.log else float(generator.uniform(s.low, s.high))
         for s in live.sliders]
        for _ in range(SETTINGS)
    ]  # fmt: skip
    return [[slider.value for slider in live.sliders], *random]


def both(robot: PaperRobot, folder: Path) -> list[tuple[dict[str, Any], PaperResult]]:
    """Runs in the page and natively, by the same settings."""
    live, bundle = live_map(robot.pair()), live_bundle(simulate(robot))
    assert bundle is not None
    values = drawn(live)
    runs = live_in_node(bundle, values, folder)
    return [(run, simulate(robot.with_(live.changes(one)))) for run, one in zip(runs, values, strict=True)]


@pytest.fixture(scope="module")
def pairs(tmp_path_factory: pytest.TempPathFactory) -> list[tuple[dict[str, Any], PaperResult]]:
    return both(seed(), tmp_path_factory.mktemp("modes"))


def test_modes_of_each_case_are_the_native_ones(pairs: list[tuple[dict[str, Any], PaperResult]]) -> None:
    first = []
    for run, result in pairs:
        native = modes_of(result)
        assert {mode["case"] for mode in native} == {"controlled", "locked", "free"}
        assert_same_modes(run["vibration"]["modes"], native, EQUAL, SHAPE)
        first.append(native[0]["frequency"])
    assert np.ptp(first) > 0.1 * first[0]


def test_marks_and_first_frequency_are_those_of_the_changed_robot(
    pairs: list[tuple[dict[str, Any], PaperResult]],
) -> None:
    for run, result in pairs:
        (fact,) = frequency_facts(result.summary()["first_frequency_Hz"])
        assert run["facts"]["frequency.first"]["value"] == pytest.approx(fact.value, rel=EQUAL)
        assert run["facts"]["frequency.first"]["note"] == fact.note
        marks = next(robot_spectra(result.data)).marks
        own = run["vibration"]["marks"][: len(marks)]
        assert [mark["label"] for mark in own] == [label for _, label in marks]
        assert [mark["at"] for mark in own] == pytest.approx([at for at, _ in marks], rel=EQUAL)


def test_modes_of_a_robot_with_rigid_elements(tmp_path: Path) -> None:
    """Fewer directions are free, and a rigid spring stores nothing; it has no slider, and the others move the rest."""
    rigid = seed(**{"gear.stiffness": float("inf")})
    assert not [slider for slider in live_map(rigid.pair()).sliders if "gear.stiffness" in slider.path]
    for run, result in both(rigid, tmp_path)[:2]:
        tips = {name: run["series"][name] for name in ("tip", "tip_reference")}
        assert worst_difference(tips, result.data, {})[0] < 1e-6
        assert_same_modes(run["vibration"]["modes"], modes_of(result), EQUAL, SHAPE)


def test_modes_that_cannot_be_reported_say_why(tmp_path: Path) -> None:
    """The run is shown all the same."""
    robot = seed()
    bundle = live_bundle(simulate(robot))
    assert bundle is not None
    bundle["modes"]["cases"] = [{"name": "locked", "columns": np.zeros((6, 1))}]
    (run,) = live_in_node(bundle, [[s["value"] for s in bundle["sliders"]]], tmp_path)
    assert "mass matrix" in run["vibration"]
    assert "frequency.first" not in run["facts"]
    assert run["status"] == "finished"
