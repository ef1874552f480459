"""The headline numbers of the page's runs of the 2010 robot are those of the native report, in the same words."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tmodes import load, run
from tmodes.live.bundle import live_bundle
from tmodes.live.map import LiveMap, live_map
from tmodes.report.data import page_data
from tmodes.sheet import Robot

from .node import live_in_node

MASS, STIFFNESS = "links.link.bodies.payload.mass", "joints.joint.gear.stiffness.0"
DURATION = "drives.0.signal.duration"
CUT = 2.6
"""Duration of a move [s] that the end of the run cuts."""
SETTINGS = ({}, {DURATION: 1.5, MASS: 0.61}, {STIFFNESS: 3000.0, MASS: 0.2}, {DURATION: CUT})


@pytest.fixture(scope="module")
def live() -> LiveMap:
    return live_map(seed().pair())


def seed() -> Robot:
    return load("filipovic2010")


def info(fact: dict[str, Any]) -> str:
    return str(fact["note"]).replace("\xa0", " ")


@pytest.mark.nightly
def test_every_headline_number_and_its_note_are_those_of_the_native_report(live: LiveMap, tmp_path: Path) -> None:
    bundle = live_bundle(run(seed()))
    assert bundle is not None
    assert {MASS, STIFFNESS, DURATION} <= {one.path for one in live.sliders}
    jobs = [[given.get(one.path, one.value) for one in live.sliders] for given in SETTINGS]
    for given, live_run in zip(SETTINGS, live_in_node(bundle, jobs, tmp_path), strict=True):
        native = run(seed().with_({**given, "integration.method": "dormand_prince"}))
        for fact in page_data([native])["runs"][0]["facts"]:
            own = live_run["facts"][fact["id"]]
            if fact["id"] == "energy.residual":  # rounding, in the tenth digit of what was moved
                assert own["value"] < 1e-8
                continue
            assert (own["value"] is None) == (fact["value"] is None), fact["id"]
            if fact["value"] is not None:
                assert own["value"] == pytest.approx(fact["value"], rel=1e-6), fact["id"]
            assert info(own) == info(fact), fact["id"]
        assert np.isfinite(live_run["facts"]["frequency.first"]["value"])
