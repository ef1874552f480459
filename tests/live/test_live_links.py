"""Robots with every kind of elastic link run in the page as natively: segments of a beam, modes of the 2010 robot."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from arm.see.runs import swinging
from tmodes import load, run
from tmodes.live.bundle import live_bundle, why_not_live
from tmodes.sheet import Robot

from .node import live_in_node, worst_difference

FINE = {"integration.relative_tolerance": 1e-11, "integration.absolute_tolerance": 1e-13, "integration.duration": 0.2,
        "integration.method": "dormand_prince"}  # fmt: skip


def segmented() -> Robot:
    """The swinging arm of two links with its beam in three segments."""
    info: dict[str, Any] = swinging() | {"real": {}, "contact": None, "points": [], "loads": []}
    beam = info["links"][0]["beam"]
    info["links"][0]["beam"] = {key: beam[key] for key in ("length", "section", "material", "damping_time")}
    info["links"][0]["beam"] |= {"model": "segments", "segments": 3}
    return Robot.from_data({key: value for key, value in info.items() if value not in (None, [])})


ROBOTS = {"segments": segmented, "modes": lambda: load("filipovic2010")}


@pytest.mark.parametrize("name", ROBOTS)
def test_it_runs_in_the_page_as_natively(name: str, tmp_path: Path) -> None:
    """Series to the tolerance of the integration, the picture to that of its lines."""
    result = run(ROBOTS[name]().with_(FINE))
    assert why_not_live(result) == ""
    bundle = live_bundle(result)
    assert bundle is not None
    (found,) = live_in_node(bundle, [[slider["value"] for slider in bundle["sliders"]]], tmp_path)
    assert found.get("error") is None
    assert found["status"] == "finished"
    series = {key: value for key, value in found["series"].items() if key in {"q", "tip", "tip_reference", "effort"}}
    assert worst_difference(series, result.data, {})[0] < 1e-7
    ends = np.asarray(found["scene"]["line"])[-1, :, -1]
    assert np.isfinite(ends).all()
    assert np.linalg.norm(ends - result.data["tip"].values[-1], axis=-1).min() < 0.25
