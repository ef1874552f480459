"""Numbers at the end of a double's range, and parts of a loop in which nothing moves: an answer or a refusal."""

from __future__ import annotations

import math

import pytest

import tmodes
from tmodes.analysis.describe.describe import describe
from tmodes.analysis.modes.of_sheet import vibrations
from tmodes.errors import InputErrors

MASS = "links.link.bodies.bob.mass"


@pytest.mark.parametrize("mass", [5e-324, 1e-310, 1e-200, 9e-101])
def test_numbers_whose_quotients_overflow_are_refused(mass: float) -> None:
    with pytest.raises(InputErrors, match=r"zero, or a magnitude from 1e-100 to 1e\+12"):
        tmodes.load("spong1987", {MASS: mass})


@pytest.mark.parametrize("mass", [1e-100, 1e-30])
def test_the_smallest_mass_has_a_description_and_modes(mass: float) -> None:
    robot = tmodes.load("spong1987", {MASS: mass})
    assert describe(robot)
    modes = vibrations(robot).states
    assert all(math.isfinite(row["frequency_Hz"]) for rows in modes.values() for row in rows)


def test_a_controller_without_an_integral_gain_has_a_state_in_which_nothing_moves() -> None:
    """Its shape has no part in the motion, and is nobody's partner."""
    gains = {"position_gain": 80.0, "integral_gain": 0.0, "velocity_gain": 12.0}
    robot = tmodes.load("spong1987", {"drives.0.controller": {"type": "pid", **gains}})
    plain = tmodes.load(
        "spong1987", {"drives.0.controller": {"type": "pd", "position_gain": 80.0, "velocity_gain": 12.0}}
    )
    pairs = [
        [row["frequency_Hz"] for rows in vibrations(one).states.values() for row in rows] for one in (robot, plain)
    ]
    assert pairs[0][-2:] == pytest.approx(pairs[1][-2:], rel=1e-9)
