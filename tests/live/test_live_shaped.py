"""A shaped S-curve in the page: its frequency is a slider, over knots that change places."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from simulation.sheets import arm
from tmodes.live.bundle import live_bundle
from tmodes.live.map import live_map
from tmodes.result import assemble_result
from tmodes.simulation.simulate import simulate_motion

from .node import live_in_node, worst_difference

FREQUENCY = "drives.0.signal.shaper.frequencies.0"


@pytest.mark.nightly("ei")
@pytest.mark.parametrize("kind", ["zv", "ei"])
def test_the_frequency_of_a_shaper_is_a_slider(kind: str, tmp_path: Path) -> None:
    """From half of it to twice as much, as native runs of the changed sheet; copies begin amid others' pieces."""
    curve = {"type": "s_curve", "start": 0.0, "end": 1.0, "speed": 2.0, "acceleration": 10.0, "jerk": 200.0}
    shaper = {"type": kind, "frequencies": [2.0], "damping": [0.02]}
    joint = {"name": "j", "type": "revolute", "child": "l", "axis": [0, 0, 1],
             "motor": {"inertia": 0.1, "side": "joint"}, "gear": {"stiffness": 80.0, "damping": 0.1}}  # fmt: skip
    body = {"name": "b", "mass": 1.0, "center": [0.7, 0, 0]}
    sheet = arm(
        gravity=0.0, joints=[joint], links=[{"name": "l", "bodies": [body]}],
        drives=[{"joint": "j", "command": "prescribed",
                 "signal": {"type": "shaped", "signal": curve, "shaper": shaper}}],
        integration={"method": "dormand_prince", "duration": 1.6, "output_step": 0.02, "relative_tolerance": 1e-12,
                     "absolute_tolerance": 1e-14},
    )  # fmt: skip
    result = assemble_result(simulate_motion(sheet), sheet)
    live, bundle = live_map(sheet.pair(), (0.0, 1.0)), live_bundle(result)
    (slider,) = (one for one in live.sliders if one.path == FREQUENCY)
    assert (slider.low, slider.high) == (1.0, 4.0)
    place = live.sliders.index(slider)
    settings = [[frequency if k == place else value for k, value in enumerate(live.start)]
                for frequency in (2.0, 1.0, 1.37, 2.5, 4.0)]  # fmt: skip
    assert bundle is not None
    for values, run in zip(settings, live_in_node(bundle, settings, tmp_path), strict=True):
        changed = sheet.with_(live.changes(values))
        native = assemble_result(simulate_motion(changed), changed)
        signal: Any = changed.drives[0].signal
        assert signal.shaper.frequencies == (values[place],)
        scales = {"energy_balance": float(np.abs(native.data["work"].values).max())}
        parts = dict.fromkeys(("deformation_stationary", "deformation_oscillatory"),
                              float(np.abs(native.data["deformation"].values).max()))  # fmt: skip
        assert worst_difference(run["series"], native.data, scales | parts)[0] < 1e-8
