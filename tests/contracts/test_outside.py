"""One robot of kinds that are all defined outside of tmodes: native, in a batch, in derivatives and in a page.

A screw joint, a link with a tabulated stiffness, an LQR of the whole state, a soil and a cosine; a joint of two
coordinates carries the foot.
"""

from __future__ import annotations

import inspect
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest

import tmodes
from contracts import test_contacts, test_controllers, test_joints, test_links, test_signals
from lane_runs import simulate_lanes
from simulation.sheets import arm
from tmodes.gradients.gradient import forward_sensitivities
from tmodes.kinds.joints.registry import JOINTS
from tmodes.live.bundle import live_bundle, why_not_live
from tmodes.report.page import page
from tmodes.simulation.initial_state import run_setup, run_trajectory
from tmodes.simulation.simulate import simulate_motion
from wasm.node import page_states

KINDS = {
    "screw": (test_joints.ScrewNumbers, test_joints.Screw),
    "table": (test_links.TableStructure, test_links.TableLink, test_links.TableSheet),
    "own_lqr": (test_controllers.LQR,),
    "soil": (test_contacts.Soil,),
    "cosine": (test_signals.Cosine,),
}


@pytest.fixture(autouse=True, scope="module")
def screw() -> Iterator[None]:
    """The other kinds are registered where they are defined."""
    JOINTS.register(test_joints.Screw)
    yield
    JOINTS.unregister("screw")


def sheet(controller: dict[str, Any], **changed: Any) -> Any:
    """A screw lowers a flexure whose end stands on soil by a foot on a universal joint."""
    joints = [
        {"name": "lift", "type": "screw", "parent": "base", "child": "boom", "axis": [0, 0, 1],
         "parameters": {"pitch": 0.02}, "motor": {"inertia": 0.2, "side": "joint"},
         "gear": {"stiffness": 300.0, "damping": 0.5}},
        {"name": "ankle", "type": "universal", "parent": "boom", "child": "foot", "state": "free",
         "friction": {"viscous": 0.02}},
    ]  # fmt: skip
    inertia = {"xx": 2e-3, "yy": 3e-3, "zz": 2.5e-3}
    shoe = {"name": "shoe", "mass": 0.4, "center": [0, 0, -0.05], "inertia": inertia}
    links = [{"name": "boom", "beam": {"model": "table", **test_links.BEAMS["table"]}},
             {"name": "foot", "bodies": [shoe]}]  # fmt: skip
    move = {"type": "cosine", "amplitude": 0.2, "frequency": 1.0}
    drive = {"joint": "lift", "command": "position", "signal": move, "controller": controller}
    ground = test_contacts.FLOOR | {"position": [0.0, 0.0, -0.055]}
    soil = {"law": "soil", "shape": ground, **test_contacts.LAWS["soil"]}
    settings = {"duration": 0.3, "output_step": 0.01, "method": "dormand_prince", "relative_tolerance": 1e-9,
                "absolute_tolerance": 1e-10}  # fmt: skip
    return arm(joints=joints, links=links, drives=[drive], contact=soil, initial={"state": "zero"},
               tip={"link": "foot", "position": [0.0, 0.0, -0.06]}, integration=settings | changed)  # fmt: skip


@pytest.fixture(scope="module")
def robot() -> Any:
    row = test_controllers.gains(sheet({"type": "pd", "position_gain": 0.0, "velocity_gain": 0.0}))
    return sheet({"type": "own_lqr", "row": row})


@pytest.mark.parametrize("name", KINDS)
def test_each_is_defined_in_less_than_sixty_lines(name: str) -> None:
    assert sum(len(inspect.getsource(part).splitlines()) for part in KINDS[name]) < 60


def test_native_batch_and_implicit_agree(robot: Any) -> None:
    run, setup = simulate_motion(robot), run_setup(robot)
    assert run.status == "finished"
    assert run.contact_normal is not None
    assert run.contact_normal.max() > 1.0
    assert np.abs(run.q[-1]).max() > 0.05
    assert np.abs(run.energy_balance).max() < 1e-6 * run.energy_moved
    rows = np.array([setup.model.numbers] * 2)
    batch = simulate_lanes(setup.model, rows, setup.planned.schedule, setup.start, robot.integration)
    assert np.abs(batch.states[1] - run.states).max() < 1e-8
    other = simulate_motion(robot.with_({"integration.method": "extrapolation"}))
    assert np.abs(other.q - run.q).max() < 1e-5


@pytest.mark.parametrize(
    ("path", "value"),
    [("joints.lift.parameters.pitch", 0.02), ("links.boom.beam.damping", 0.05), ("contact.modulus", 2e4),
     ("drives.0.signal.amplitude", 0.2)],
)  # fmt: skip
def test_derivatives(robot: Any, path: str, value: float) -> None:
    """By a number of each kind: against differences of runs."""
    short = robot.with_({"integration.duration": 0.1, "integration.method": "dop853"})
    slope = forward_sensitivities(short, [path]).by[path][-1]
    ends = [simulate_motion(short.with_({path: value * (1 + s)})).q[-1] for s in (1e-4, -1e-4)]
    true = (ends[0] - ends[1]) / (2e-4 * value)
    assert slope[: len(true)] == pytest.approx(true, rel=1e-3, abs=1e-4 * np.abs(true).max())


def test_in_a_page(robot: Any, tmp_path: Any) -> None:
    """WebAssembly gives the motion of native code, feedback of the whole state included; the report names all kinds."""
    setup = run_setup(robot)
    native = run_trajectory(setup)
    assert np.abs(page_states(setup, tmp_path) - native.states).max() < 1e-8
    result = tmodes.run(robot)
    assert why_not_live(result) == ""
    assert live_bundle(result) is not None
    text = page(result, live=True)
    assert all(word in text for word in (*KINDS, "universal"))
