"""Sensors of forces in a loop that starts at rest in contact; those on links that do not bend are refused there."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from contracts.test_blocks import Sheet
from contracts.test_contact_laws import BENDING, FORCE, IMPEDANCE, SPAN, pressing
from tmodes.errors import InputErrors

SENSORS: dict[str, tuple[Sheet, str, float]] = {  # what it is, its port, its value by a force of 1 N on the wall
    "wall": ({"type": "output", "output": "contact.force.y", "sample_time": 2e-3, "delay": 3e-3}, "", 1.0),
    "push": ({"type": "flange", "link": "link", "at": 0.25}, ".force.y", -1.0),
    "bend": ({"type": "flange", "link": "link", "at": 0.25}, ".moment.z", -0.75 * SPAN),
    "gauge": ({"type": "strain_gauge", "link": "link", "at": 0.0, "y": 0.002}, "", 0.002 * SPAN / BENDING),
    "wound": ({"type": "output", "output": "joint.gear_torque", "sample_time": 1e-3}, "", SPAN),
}


def robot(law: Sheet, goal: float, sensors: dict[str, Sheet], *, bends: bool = True) -> Any:
    """A tip at rest on a wall, with sensors, each behind a filter of its own."""
    read = [{"name": f"low_{name}", "block": {"type": "low_pass", "input": f"{name}{SENSORS[name][1]}",
             "frequency": 5.0, "sample_time": 1e-3}} for name in sensors]  # fmt: skip
    return pressing(law, goal, bends=bends).with_({
        "initial": {"state": "rest"}, "sensors": [one | {"name": name} for name, one in sensors.items()],
        "control": [{"name": "law", "drives": ["joint"], "block": law}, *read], "integration.duration": 0.1,
    })  # fmt: skip


def test_what_is_measured_at_the_start_is_what_stays() -> None:
    """By statics, but for the small angle between the link and the wall; no filter has anything to do."""
    result = robot(IMPEDANCE, 4e-2, {name: one for name, (one, _, _) in SENSORS.items()}).run()
    assert np.ptp(result.data["q"].values, axis=0).max() < 1e-11
    force = float(np.asarray(result.output("contact.force.y"))[0])
    assert force > 20
    for name, (_, _, share) in SENSORS.items():
        read = np.asarray(result.output(f"low_{name}"))
        assert read[0] == pytest.approx(share * force, rel=1e-4)
        assert read == pytest.approx(read[0], rel=1e-9)


@pytest.mark.parametrize("bends", [True, False])
def test_a_wanted_force_is_there_from_the_start(bends: bool) -> None:
    """By a late sensor, with the integral that it takes; rigid links, too."""
    result = robot(FORCE | {"input": "wall"}, 2e-3, {"wall": SENSORS["wall"][0]}, bends=bends).run()
    assert np.asarray(result.output("contact.force.y")) == pytest.approx(FORCE["force"], rel=1e-9)


@pytest.mark.parametrize("name", ["push", "gauge"])
@pytest.mark.parametrize("link", ["link", "nowhere"])
def test_a_sensor_of_what_bends_is_on_a_link_that_does(name: str, link: str) -> None:
    with pytest.raises(InputErrors) as error:
        robot(IMPEDANCE, 0.0, {name: SENSORS[name][0] | {"link": link}}, bends=False)
    (wrong,) = error.value.errors
    assert wrong.which.endswith(".link")
    assert link in wrong.got
