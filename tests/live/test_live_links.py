"""Robots with every kind of elastic link run in the page as natively: segments of a beam, modes of the 2010 robot."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from see.runs import swinging
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


def universal() -> Robot:
    """Two coordinates in one joint, each with a controller that has a state of its own."""
    joint = {"name": "j", "type": "universal", "child": "l", "motor": {"inertia": 0.3, "side": "joint"},
             "gear": {"stiffness": 300.0, "damping": 0.2}}  # fmt: skip
    inertia = {"xx": 0.02, "yy": 0.03, "zz": 0.01}
    body = {"name": "bar", "mass": 1.0, "inertia": inertia, "center": [0.0, 0.0, 0.3]}
    drives = [
        {"joint": f"j.{axis}", "command": "position",
         "signal": {"type": "quintic", "start": 0.0, "end": end, "duration": 0.1},
         "controller": {"type": "pid", "position_gain": 200.0, "integral_gain": 900.0, "velocity_gain": 12.0}}
        for axis, end in (("x", 0.4), ("y", -0.2))
    ]  # fmt: skip
    settings = {"line_points": 3, "output_step": 0.005, "duration": 0.2}
    return Robot.from_data({
        "format": 1, "kind": "arm", "name": "universal", "gravity": 9.81, "joints": [joint],
        "links": [{"name": "l", "bodies": [body]}], "drives": drives, "integration": settings,
    })  # fmt: skip


ROBOTS = {"segments": segmented, "modes": lambda: load("filipovic2010"), "universal": universal}
SERIES = {"q", "tip", "tip_nominal", "effort", "controller_states"}


@pytest.mark.nightly("segments", "universal")
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
    series = {key: value for key, value in found["series"].items() if key in SERIES}
    assert series.keys() == SERIES & {str(name) for name in result.data}
    assert worst_difference(series, result.data, {})[0] < 1e-7
    if bundle["links"]:
        ends = np.asarray(found["scene"]["line"])[-1, :, -1]
        assert np.isfinite(ends).all()
        assert np.linalg.norm(ends - result.data["tip"].values[-1], axis=-1).min() < 0.25
