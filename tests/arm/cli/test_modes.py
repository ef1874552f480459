"""``tmodes modes`` of an arm."""

from __future__ import annotations

import json

import numpy as np
import pytest

from arm.cli.command import tmodes


def test_json():
    told = json.loads(tmodes("modes", "spong1987", "--json").stdout)
    assert 2 * np.pi * told["real"]["locked"][0]["frequency_Hz"] == pytest.approx(np.sqrt(109.8), rel=1e-9)
    assert set(told["real"]) == {"locked", "free", "controlled"}
    assert "nominal" not in told


def test_real_and_known_arm():
    told = tmodes("modes", "spong1987", "--set", "real.joints.joint.gear.stiffness=0.8").stdout
    assert "real arm, motor locked" in told
    assert "arm as known, motor locked" in told


@pytest.mark.parametrize("arguments", [["--angle", "0.5"], ["--contact"]])
def test_what_an_arm_has_not_is_refused(arguments):
    assert arguments[0] in tmodes("modes", "spong1987", *arguments, code=2).stderr
