"""Properties of whole runs over random robots: what is written, turned or mirrored otherwise moves the same.

Joints of all kinds, gears, beams, dry friction, rough surfaces, motions that jump (:mod:`random_sheets`). The
variable ``TMODES_ROBOTS`` asks for so many robots of each property.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np
import pytest

from random_sheets import heavier, in_other_units, mirrored, random_sheet, reversed_order, rotation, turned
from tmodes.sheet import Robot
from tmodes.simulation.motion_run import RunData
from tmodes.simulation.simulate import simulate_motion

ROBOTS = int(os.environ.get("TMODES_ROBOTS", "6"))
RIGID = ("revolute", "revolute", "prismatic")
SAME, BOOKS = 1e-6, 1e-6
"""Difference of coordinates over the largest, and of energies over what was moved: the tolerance of a run."""


def run(sheet: dict[str, Any]) -> RunData:
    """With one method, so that steps can be compared."""
    settings = sheet["integration"] | {"method": "dormand_prince"}
    return simulate_motion(Robot.from_data(sheet | {"integration": settings}))


@cache
def drawn(structure: int, *, rigid: bool = False) -> tuple[dict[str, Any], RunData]:
    """A robot and its run."""
    sheet = random_sheet(structure, beams=not rigid, kinds=RIGID if rigid else ())
    return sheet, run(sheet)


def same(one: RunData, other: RunData) -> None:
    """The same motion, with as much work."""
    assert one.status == other.status == "finished"
    order = [other.coordinates.index(name) for name in one.coordinates]
    assert np.abs(other.q[:, order] - one.q).max() <= SAME * np.abs(one.q).max()
    as_many_steps(one, other)


def as_many_steps(one: RunData, other: RunData) -> None:
    """But for what rounding does: of steps at the limit of stability, and of the search for instants of a switch."""
    steps = [each.statistics["steps"] for each in (one, other)]
    assert abs(steps[1] - steps[0]) <= max(15, 0.06 * steps[0])


@pytest.mark.parametrize("structure", range(ROBOTS))
def test_energy_is_kept_and_the_world_may_be_turned(structure: int) -> None:
    sheet, first = drawn(structure)
    assert np.abs(first.energy_balance).max() <= BOOKS * first.energy_moved
    for attitude in range(3):
        same(first, run(turned(sheet, rotation(1000 * structure + attitude))))


@pytest.mark.parametrize("structure", range(ROBOTS // 2))
@pytest.mark.parametrize("change", [mirrored, in_other_units])
def test_in_a_mirror_and_in_other_units(change: Callable[[Any], Any], structure: int) -> None:
    sheet, first = drawn(structure, rigid=True)
    assert np.abs(first.energy_balance).max() <= BOOKS * first.energy_moved
    same(first, run(change(sheet)))


@pytest.mark.parametrize("structure", range(ROBOTS // 3))
def test_order_and_size_of_forces_do_not_matter(structure: int) -> None:
    """Steps may differ: works have an absolute tolerance, and rounding of sums its order."""
    sheet, first = drawn(structure, rigid=True)
    for other in (run(reversed_order(sheet)), run(heavier(sheet, 1e3)), run(heavier(sheet, 1e-3))):
        order = [other.coordinates.index(name) for name in first.coordinates]
        assert np.abs(other.q[:, order] - first.q).max() <= SAME * np.abs(first.q).max()


def on_a_slope() -> dict[str, Any]:
    """A block that moves in a plane and sticks on a slope of 0.3 rad: across that plane it has no mobility at all."""
    joints = [{"name": name, "type": "prismatic", "child": child, "axis": axis, "state": "free"}
              for name, child, axis in (("x", "l1", [1, 0, 0]), ("z", "f", [0, 0, 1]))]  # fmt: skip
    normal, weight = [np.sin(0.3), 0.0, np.cos(0.3)], 9.81 * np.cos(0.3)
    start = {name: -weight / 1e5 * x for name, x in zip("xz", (normal[0], normal[2]), strict=True)}
    return {
        "format": 1, "kind": "arm", "name": "slope", "gravity": [0.0, 0.0, -9.81], "joints": joints,
        "links": [{"name": "f", "bodies": [{"name": "b", "mass": 1.0, "center": [0, 0, 0], "inertia": 0.01}]}],
        "contact": {"law": "unilateral", "stiffness": 1e5, "damping": 200.0, "friction": 2 * np.tan(0.3),
                    "shape": {"type": "plane", "position": [0.0] * 3, "normal": normal}, "velocity": [0.0] * 3},
        "initial": {"state": "zero", "coordinates": start}, "loads": [], "drives": [],
        "integration": {"duration": 1.0, "output_step": 0.02, "line_points": 3, "error_estimate": False,
                        "model_error": False},
    }  # fmt: skip


def test_a_planar_block_sticks_in_any_attitude() -> None:
    first = run(on_a_slope())
    for attitude in range(100):
        other = run(turned(on_a_slope(), rotation(attitude)))
        assert other.status == "finished"
        assert np.abs(other.q - first.q[0]).max() < 1e-12
        as_many_steps(first, other)
