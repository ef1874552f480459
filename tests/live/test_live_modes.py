"""The modes of an arm, and the parts of its deformations, follow the sliders: all equal those of the native run."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tmodes.live.bundle import live_bundle
from tmodes.live.map import live_map
from tmodes.plot.spectra import own_frequencies
from tmodes.report.data import modes_of
from tmodes.report.facts import frequency_facts
from tmodes.result import Result, assemble_result
from tmodes.sheet import Robot
from tmodes.simulation.simulate import simulate_motion

from .node import drawn, live_in_node
from .same_modes import SHAPE, assert_same_modes
from .test_live_run import two_links

SETTINGS = 2
EQUAL = 1e-8
PARTS = 1e-9
"""Bound of the parts over the largest deformation."""

_LOADS = [
    {"point": "tip", "force": [3.0, -2.0, -4.0], "moment": [0.0, 0.3, 0.1], "frame": "section",
     "signal": {"type": "sine", "amplitude": 0.5, "frequency": 3.0, "offset": 1.0}},
    {"point": "tip", "force": [0.0, 2.0, 0.0], "frame": "world"},
]  # fmt: skip
_BALL = {"shape": {"type": "ball", "center": [0.0, 0.02, 0.1], "radius": 0.88, "inside": True}, "law": "unilateral",
         "stiffness": 800.0, "damping": 4.0, "preload": 5.0}  # fmt: skip


def result_of(arm: Robot) -> Result:
    return assemble_result(simulate_motion(arm), arm)


def both(arm: Robot, folder: Path, most: int = 1 + SETTINGS) -> list[tuple[dict[str, Any], Result]]:
    live, bundle = live_map(arm.pair(), (0.0, 1.0)), live_bundle(result_of(arm))
    assert bundle is not None
    values = [live.start, *drawn(live, SETTINGS, seed=3)][:most]
    runs = live_in_node(bundle, values, folder)
    return [(run, result_of(arm.with_(live.changes(one)))) for run, one in zip(runs, values, strict=True)]


@pytest.fixture(scope="module")
def pairs(tmp_path_factory: pytest.TempPathFactory) -> list[tuple[dict[str, Any], Result]]:
    """Two flexible links in contact with a wall."""
    return both(two_links(), tmp_path_factory.mktemp("modes"))


def assert_parts_equal(run: dict[str, Any], result: Result) -> None:
    largest = float(np.abs(result.data["deformation"].values).max())
    for name in ("deformation_stationary", "deformation_oscillatory"):
        true = result.data[name].transpose("time", "deformation_kind").values
        assert np.abs(run["series"][name] - true).max() < PARTS * largest, name


def test_modes_of_each_case_are_the_native_ones(pairs: list[tuple[dict[str, Any], Result]]) -> None:
    first = []
    for run, result in pairs:
        native = modes_of(result)
        assert {mode["case"] for mode in native} == {"controlled", "locked", "free"}
        assert_same_modes(run["vibration"]["modes"], native, EQUAL, SHAPE)
        first.append(native[0]["frequency"])
    assert np.ptp(first) > 0.05 * first[0]


def test_marks_and_first_frequency_are_those_of_the_changed_arm(pairs: list[tuple[dict[str, Any], Result]]) -> None:
    for k, (run, result) in enumerate(pairs):
        (fact,) = frequency_facts(result.summary()["first_frequency_Hz"])
        assert run["facts"]["frequency.first"]["value"] == pytest.approx(fact.value, rel=EQUAL)
        assert run["facts"]["frequency.first"]["note"] == fact.note
        marks = own_frequencies(result)["actual"]
        if not k:  # elsewhere two pairings of damped motions with modes may be alike to rounding
            assert [mark["label"] for mark in run["vibration"]["marks"]] == [label for _, label in marks]
        assert [mark["at"] for mark in run["vibration"]["marks"]] == pytest.approx([at for at, _ in marks], rel=EQUAL)


def test_parts_of_the_deformations_are_the_native_ones(pairs: list[tuple[dict[str, Any], Result]]) -> None:
    for run, result in pairs:
        assert_parts_equal(run, result)


_SPRING = {"stiffness": 200.0, "rest": 0.3, "damping": 0.4}


@pytest.mark.nightly
def test_what_acts_on_the_points_is_in_modes_and_parts(tmp_path: Path) -> None:
    """Loads that follow their point (their stiffness is not symmetric) or not, a hollow ball, a spring by a gear."""
    changes = {"loads": _LOADS, "contact": _BALL, "joints.j1.spring": _SPRING}
    for run, result in both(two_links().with_(changes), tmp_path, 2):
        assert float(result.data["contact_force_normal"][0]) > 1.0
        assert_same_modes(run["vibration"]["modes"], modes_of(result), EQUAL, SHAPE)
        assert_parts_equal(run, result)


@pytest.mark.nightly
def test_an_arm_too_large_for_modes_in_the_page_says_so(tmp_path: Path) -> None:
    bundle = live_bundle(result_of(two_links()))
    assert bundle is not None
    bundle |= {"modes": None, "noModes": "of 130 coordinates modes are found natively alone"}
    (run,) = live_in_node(bundle, [[s["value"] for s in bundle["sliders"]]], tmp_path)
    assert "natively" in run["vibration"]
    assert run["facts"]["frequency.first"]["value"] is None
