"""Random changes of six robots: all numbers of the page are those of a native run of the changed sheet, or marked."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

from tmodes import load, run
from tmodes.live.bundle import live_bundle

from .all_numbers import different
from .node import live_in_node

if TYPE_CHECKING:
    from pathlib import Path

ROBOTS = ("spong1987", "filipovic2010", "two_link_arm", "manutec_r3", "flexarm1990", "quanser_2dsfl")
CHANGES = 10 if os.environ.get("TMODES_NIGHTLY") else 4


def changes(sliders: Any, random: np.random.Generator) -> dict[str, float]:
    """One to three sliders, anywhere within their ends."""
    chosen = random.choice(len(sliders), int(random.integers(1, 4)), replace=False)
    found = {}
    for slider in (sliders[k] for k in chosen):
        low, high, share = slider["min"], slider["max"], random.random()
        value = low * (high / low) ** share if slider["log"] and low > 0 else low + (high - low) * share
        found[slider["path"]] = float(f"{value:.4g}")
    return found


@pytest.mark.parametrize("name", [ROBOTS[0], *(pytest.param(one, marks=pytest.mark.nightly) for one in ROBOTS[1:])])
def test_all_numbers_are_those_of_the_native_run(name: str, tmp_path: Path) -> None:
    robot, random = load(name), np.random.default_rng(len(name))
    bundle = live_bundle(run(robot))
    assert bundle is not None
    sliders: list[dict[str, Any]] = bundle["sliders"]
    given = [changes(sliders, random) for _ in range(CHANGES)]
    jobs: list[list[float]] = [[one.get(slider["path"], float(slider["value"])) for slider in sliders] for one in given]
    wrong = []
    for one, live in zip(given, live_in_node(bundle, jobs, tmp_path), strict=True):
        found = different(live, run(robot.with_(one)))
        wrong += [f"{one} {what}" for what in found if "native" not in live]
    assert not wrong, "\n".join(wrong)
