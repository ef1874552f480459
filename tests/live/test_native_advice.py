"""Where a native run of changed numbers gives others than the page, the page says so, with the command."""

from __future__ import annotations

import shlex
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from simulation.test_endings import bouncing
from tmodes import Result, load, run
from tmodes.live.bundle import live_bundle
from tmodes.sheet import Robot

from .all_numbers import different
from .node import live_in_node


def both(robot: Robot, changes: dict[str, float], folder: Path) -> tuple[dict[str, Any], Result]:
    """What the page gives for changed numbers, and the native run of the same."""
    bundle = live_bundle(run(robot))
    assert bundle is not None
    sliders: list[dict[str, Any]] = bundle["sliders"]
    job = [changes.get(slider["path"], float(slider["value"])) for slider in sliders]
    return live_in_node(bundle, [job], folder)[0], run(robot.with_(changes))


def asked_for(own: dict[str, Any]) -> list[str]:
    """The words of the command that the page advises."""
    return shlex.split("tmodes run" + own["native"].partition("tmodes run")[2])


@pytest.mark.nightly
def test_another_method_is_said(tmp_path: Path) -> None:
    """Beyond 20,000 explicit steps a native run is implicit; the page has the method of the original run alone."""
    stiff = {"joints.joint.gear.stiffness.0": 4e8}
    own, native = both(load("spong1987"), stiff, tmp_path)
    assert native.statistics["real"]["method"] == "extrapolation"
    assert "natively this run is by extrapolation, here by dormand_prince" in own["native"]
    assert asked_for(own) == ["tmodes", "run", "spong1987", "--set", "joints.joint.gear.stiffness.0=400000000"]


@pytest.mark.nightly
def test_a_contact_that_chatters_advises_the_native_run(tmp_path: Path) -> None:
    ball = bouncing(1e-9, 0.05, method="dormand_prince")
    damping = 2 * 5e-4 * float(np.sqrt(1e12 * 1e-3))
    own, native = both(ball, {"contact.damping": damping}, tmp_path)
    assert own["status"] == native.status == "chattering"
    assert own["native"].startswith("A native run, whose steps are others, may go on where this page ends: tmodes run")
    assert asked_for(own)[2:] == [f"{ball.name}.yaml", "--set", f"contact.damping={damping!r}"]


@pytest.mark.nightly
def test_what_rounding_decides_is_said(tmp_path: Path) -> None:
    """A drive at its limit: where steps meet it follows from rounding, and moves the tip within the tolerance."""
    weak = load("two_link_arm").with_({
        "payload.mass": 5.0, "drives.shoulder.saturation": {"torque": 50.0}, "integration.duration": 2.0,
    })  # fmt: skip
    own, native = both(weak, {"links.forearm.bodies.payload.mass": 2.5}, tmp_path)
    apart = np.linalg.norm(own["series"]["tip"] - native.data["tip"].values, axis=1).max()
    assert native.statistics["real"]["method"] == "extrapolation"
    assert different(own, native)
    assert apart < native.summary()["error"]["figures"]["tip_m"]
    assert "rounding moves the tip by" in own["native"]
