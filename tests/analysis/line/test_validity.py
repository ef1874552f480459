"""Warnings of a run: each limit passed is reported with its first time and how far; within the limits nothing is."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from analysis.line.beams import beam, clamped
from tmodes.analysis.line.line import elastic_line
from tmodes.analysis.quasistatic import held_shape
from tmodes.analysis.validity import missing_share, run_warnings
from tmodes.model.model import Model
from tmodes.sheet import Robot
from tmodes.simulation.simulate import simulate_motion
from tmodes.simulation.warnings import run_warnings as joint_warnings


def sheet(**beam_changes: Any) -> dict[str, Any]:
    """A steel rod of 10 mm on a hinge about z with limits, gravity along -z."""
    rod: dict[str, Any] = {
        "model": "strain", "functions": {"bend_y": 3, "bend_z": 3}, "length": 0.5, "damping_time": 0.0,
        "section": {"shape": "round", "diameter": 0.01}, "material": "steel", **beam_changes,
    }  # fmt: skip
    limits = {"lower": -1.0, "upper": 1.5, "speed": 2.0, "effort": 5.0}
    joint = {"name": "hub", "type": "revolute", "parent": "base", "child": "rod", "axis": [0, 0, 1], "limits": limits}
    return {"format": 1, "kind": "arm", "name": "rod", "joints": [joint], "links": [{"name": "rod", "beam": rod}]}


def info(q: Any, wrenches: Any = None, **changes: Any) -> list[str]:
    arm = Robot.from_data(sheet(**changes))
    model = Model(arm.chain())
    q = np.atleast_2d(q)
    return run_warnings(arm, model, 0.1 * np.arange(len(q)), q, elastic_line(model, q, wrenches=wrenches))


def info_of_joints(q: Any, v: Any = 0.0, effort: Any = 0.0) -> list[str]:
    """What the run itself reports, for the same samples put in the place of its own."""
    run = simulate_motion(Robot.from_data(sheet() | {"integration": {"duration": 0.02, "output_step": 0.01}}))
    nothing = np.zeros(len(q))
    return joint_warnings(replace(
        run, times=0.1 * np.arange(len(q)), q=q, v=np.broadcast_to(np.asarray(v, dtype=float), q.shape),
        effort=np.broadcast_to(np.asarray(effort, dtype=float), (len(q), 1)),
        energies=dict.fromkeys(run.energies, nothing), works=dict.fromkeys(run.works, nothing),
    ))  # fmt: skip


def rows(count: int, values: dict[int, float], at: int, size: int = 7) -> np.ndarray:
    """Samples at rest, one of them with some coordinates."""
    q = np.zeros((count, size))
    q[at, list(values)] = list(values.values())
    return q


def at_rest() -> np.ndarray:
    """The rod's sag: with it, what bends it is what it carries."""
    return held_shape(Model(Robot.from_data(sheet()).chain()), np.zeros(7))[0]


def test_nothing_is_reported_within_the_limits() -> None:
    still = np.repeat(at_rest(), 3, axis=0)
    assert info(still) == []
    assert info_of_joints(still) == []


def test_joint_limits_are_reported_with_first_time_and_extent() -> None:
    q = np.repeat(at_rest(), 5, axis=0)
    q[2:, 0] = [1.6, 1.8, 1.7]
    (sentence,) = info_of_joints(q)
    assert (
        sentence
        == "joint hub passes its limit of position, 1.5 rad, first at t = 0.2 s, and reaches 1.8 rad at t = 0.3 s"
    )
    q[2:, 0] = [-1.1, -1.2, 0.0]
    (sentence,) = info_of_joints(q)
    assert (
        sentence
        == "joint hub passes its limit of position, -1 rad, first at t = 0.2 s, and reaches -1.2 rad at t = 0.3 s"
    )


def test_speed_and_effort_are_reported() -> None:
    still = np.repeat(at_rest(), 3, axis=0)
    (sentence,) = info_of_joints(still, v=rows(3, {0: -2.5}, 1))
    assert (
        sentence
        == "joint hub passes its limit of speed, 2 rad/s, first at t = 0.1 s, and reaches 2.5 rad/s at t = 0.1 s"
    )
    (sentence,) = info_of_joints(still, effort=[[0.0], [-6.0], [5.5]])
    assert sentence == "joint hub passes its limit of effort, 5 N*m, first at t = 0.1 s, and reaches 6 N*m at t = 0.1 s"


def test_stress_beyond_yield_is_reported() -> None:
    """235 MPa in a rod of 10 mm: M = 235e6 pi d^3/32 = 23.07 N*m, a force of 46.14 N at 0.5 m."""
    for force, wanted in ((45.5, 0), (46.8, 1)):
        push = np.array([0.0, force, 0.0, 0.0, 0.0, 0.0])[None, None]
        found = [line for line in info(np.zeros(7), wrenches=push) if "yield" in line]
        assert len(found) == wanted
    assert "235 MPa, most at s = 0" in found[0]


def test_buckling_load_is_reported() -> None:
    """pi^2 EI/(4 L^2) of that rod: 210e9 pi 1e-8/64 pi^2/(4 0.25) = 1017 N."""
    for force, wanted in ((1010.0, 0), (1025.0, 1)):
        push = np.array([-force, 0.0, 0.0, 0.0, 0.0, 0.0])[None, None]
        found = [line for line in info(np.zeros(7), wrenches=push) if "buckling" in line]
        assert len(found) == wanted
    assert "1017 N" in found[0]
    assert "1025 N" in found[0]


def test_a_buckling_load_is_only_that_of_a_straight_cantilever() -> None:
    push = np.array([-2000.0, 0.0, 0.0, 0.0, 0.0, 0.0])[None, None]
    free = Robot.from_data(sheet()).with_({"joints.hub.state": "free", "joints.hub.limits": None})
    model, bent = Model(free.chain()), np.zeros((2, 1, 7))
    bent[1, 0, 1] = 1.5
    for q in bent:
        found = run_warnings(free, model, np.zeros(1), q, elastic_line(model, q, wrenches=push))
        assert not [line for line in found if "buckling" in line]
    assert not [line for line in info(bent[1], wrenches=push) if "buckling" in line]


def test_range_of_strain_and_of_segments_is_reported() -> None:
    bent = rows(3, {4: 12.0}, 1)
    assert any("rod turns by more than 1 rad between two of its points" in line for line in info(bent))
    low = rows(3, {2: 0.12}, 2, size=3)
    found = info(low, model="segments", segments=1, functions=None)
    assert any("link rod leaves the small angles" in line and "0.12 rad" in line for line in found)


@pytest.mark.parametrize(("functions", "share"), [(1, 1 / 4), (2, 0.0)])
def test_missing_share_of_a_tip_force(functions: int, share: float) -> None:
    """A linear moment seen by a constant one: of its energy L^3/3, L^3/12 is missing: a quarter; by two: nothing."""
    link = beam(bend_y=0, bend_z=functions)
    model = clamped(link, gravity=np.zeros(3))
    push = np.array([0.0, 1e-4, 0.0, 0.0, 0.0, 0.0])[None, None]
    q, _ = held_shape(model, np.zeros(functions), wrenches=push)
    line = elastic_line(model, q, wrenches=push, stations=401)["rod"]
    assert missing_share(line, link)["bend_z"] == pytest.approx(share, rel=1e-4, abs=1e-8)


def test_too_few_functions_are_reported() -> None:
    arm = Robot.from_data(sheet(functions={"bend_y": 1, "bend_z": 1}, basis="legendre"))
    model = Model(arm.chain())
    q, _ = held_shape(model, np.zeros(3))
    found = run_warnings(arm, model, [0.0], q, elastic_line(model, q))
    assert len(found) == 1
    assert "take more functions.bend_y" in found[0]
